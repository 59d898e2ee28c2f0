"""A condition in service as it stands in results.json."""

from __future__ import annotations

import math
from dataclasses import asdict

from hullform.in_service import InService, Resonances, Response, Springing
from hullform.service_records import (
    HitRecord,
    PublishedRecord,
    RatiosRecord,
    ResonanceRecord,
    ResponseRecord,
    SourceRecord,
    SpringingRecord,
    UnbalanceRecord,
    WaveRecord,
)
from hullform.ship import Particulars
from hullform.ship_kinds import published_like
from hullvib.model_spread import ratio_uncertainty
from hullvib.modes import Modes
from hullvib.real_ships import RATIO_LIMITS, ratios


def ratios_record(modes: Modes, particulars: Particulars) -> RatiosRecord:
    """The headline's ratios beside those of ships as they are."""
    three_node, four_node = ratios(modes.angular_frequencies)
    _, uncertainty_of_three, uncertainty_of_four, *_ = ratio_uncertainty(modes).tolist()
    return RatiosRecord(
        medium=modes.medium,
        theory=modes.theory,
        three_to_two_node=three_node,
        three_to_two_node_uncertainty=uncertainty_of_three,
        three_to_two_node_limits=RATIO_LIMITS[0],
        four_to_two_node=four_node,
        four_to_two_node_uncertainty=uncertainty_of_four,
        four_to_two_node_limits=RATIO_LIMITS[1],
        published_ships=[
            PublishedRecord(
                kind=ship.kind,
                length_m=ship.length_m,
                condition=ship.condition,
                cycles_per_minute=list(ship.cycles_per_minute),
            )
            for ship in published_like(particulars)
        ],
    )


def resonance_record(service: InService) -> ResonanceRecord | None:
    """Propeller and engine against the headline; None without [excitation]."""
    found, modes = service.resonances, service.modes
    if found is None:
        return None
    lower, upper = found.bands_hz
    responses = {response.hit: response for response in found.responses}
    return ResonanceRecord(
        medium=modes.medium,
        theory=modes.theory,
        frequencies_hz=modes.frequencies_hz.tolist(),
        uncertainty=found.uncertainty.tolist(),
        band_lower_hz=lower.tolist(),
        band_upper_hz=upper.tolist(),
        beam_limit_hz=found.beam_limit_hz,
        shaft_speed_rpm=found.given.shaft_speed_rpm,
        service_rpm=found.given.service_rpm,
        sources=_sources(found),
        hits=[
            HitRecord(
                mode=hit.mode,
                source=hit.source.name,
                critical_rpm=hit.critical_rpm,
                avoid_rpm=hit.avoid_rpm,
                at_service_speed=None if found.given.service_rpm is None else hit.holds(found.given.service_rpm),
                participation=found.participation_of(hit),
                flagged=hit.flagged,
                response=_response(responses.get(hit)),
            )
            for hit in found.hits
        ],
        speeds_to_avoid_rpm=list(found.avoid_rpm),
        speeds_to_avoid_flagged_rpm=list(found.flagged_rpm),
        unbalances=[
            UnbalanceRecord(order=one.order, pru_nm_per_kw=one.pru_nm_per_kw, need_for_compensator=one.need)
            for one in found.unbalances
        ],
    )


def springing_record(service: InService) -> SpringingRecord | None:
    """The waves that excite the first mode; None without [operation]."""
    found = service.springing
    if found is None:
        return None
    return SpringingRecord(
        medium=service.modes.medium,
        theory=service.modes.theory,
        natural_frequency_hz=found.natural_rad_s / (2.0 * math.pi),
        waves=_waves(found),
    )


def _sources(found: Resonances) -> list[SourceRecord]:
    margins = None if found.margins is None else found.margins.tolist()
    return [
        SourceRecord(
            **asdict(source),
            participation=found.participation[index].tolist(),
            margin_at_service_speed=None if margins is None else margins[index],
        )
        for index, source in enumerate(found.sources)
    ]


def _response(found: Response | None) -> ResponseRecord | None:
    if found is None:
        return None
    motion = found.motion
    return ResponseRecord(
        speed_rpm=found.speed_rpm,
        frequency_hz=motion.angular_frequency / (2.0 * math.pi),
        load_is_given=found.load_is_given,
        load_x_m=found.load.x_m,
        force_n=found.load.force_n,
        moment_n_m=found.load.moment_n_m,
        x_m=motion.x_m.tolist(),
        amplitude_m=motion.amplitude_m.tolist(),
        peak_velocity_m_s=motion.peak_velocity_m_s.tolist(),
    )


def _waves(found: Springing) -> list[WaveRecord]:
    return [
        WaveRecord(
            order=met.wave.order,
            speed_knots=met.speed_knots,
            heading_deg=met.heading_deg,
            frequency_rad_s=met.wave.angular_frequency,
            period_s=met.wave.period_s,
            length_m=met.wave.length_m,
            overtaken=met.wave.overtaken,
        )
        for met in found.waves
    ]
