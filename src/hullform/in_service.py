"""The ship in service: what propeller, engine and waves do to the modes of a condition."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.loading.gravity import GRAVITY_M_S2
from hullform.ship import Ship
from hullform.ship_excitation import ExcitationInput
from hullform.ship_operation import OperationInput, metres_per_second
from hullvib import engine, resonance, springing
from hullvib.forced import ForcedResponse, HarmonicLoad, forced_response, participation
from hullvib.model_spread import model_uncertainty
from hullvib.modes import Modes
from hullvib.resonance import Hit, Source

Array = NDArray[np.float64]

# Where nothing says how large a load is, the response is that to one of these.
UNIT_FORCE_N, UNIT_MOMENT_N_M = 1e3, 1e6
POINTS_ALONG = 101
# A place where a mode has less than this of its largest deflection or slope hardly excites it.
HARDLY_EXCITED = 0.1


@dataclass(frozen=True, eq=False)
class Response:
    """What one hit does to its mode at the critical speed, or at the nearest speed in the range.

    Attributes:
        hit: the source and the mode.
        speed_rpm: of the shaft.
        load: its amplitude and place.
        load_is_given: whether ship.toml says how large it is; a unit load otherwise.
        motion: of this mode alone, along the ship.
    """

    hit: Hit
    speed_rpm: float
    load: HarmonicLoad
    load_is_given: bool
    motion: ForcedResponse


@dataclass(frozen=True, eq=False)
class Unbalance:
    """An external moment of the engine held against her power."""

    order: int
    pru_nm_per_kw: float
    need: engine.Need


@dataclass(frozen=True, eq=False)
class Resonances:
    """Propeller and engine against the natural frequencies of a condition.

    Attributes:
        given: [excitation].
        sources: what excites.
        uncertainty: (modes,) the model's own, over the frequency.
        bands_hz: lower and upper edges, each (modes,).
        hits: within the shaft's speed range.
        avoid_rpm: shaft speeds of all hits of the modes that a beam describes well, together.
        flagged_rpm: those of the flagged hits, together.
        participation: (sources, modes), how well its place excites each mode, -1 .. 1.
        margins: (sources, modes) at the service speed, over the natural frequency; None without a service speed.
        beam_limit_hz: above it no beam speaks for the ship.
        unbalances: of the engine, where its power is given.
        responses: one a hit, where the damping is given.
    """

    given: ExcitationInput
    sources: tuple[Source, ...]
    uncertainty: Array
    bands_hz: tuple[Array, Array]
    hits: tuple[Hit, ...]
    avoid_rpm: tuple[tuple[float, float], ...]
    flagged_rpm: tuple[tuple[float, float], ...]
    participation: Array
    margins: Array | None
    beam_limit_hz: float
    unbalances: tuple[Unbalance, ...]
    responses: tuple[Response, ...]

    def participation_of(self, hit: Hit) -> float:
        """How well a hit's source excites its mode from where it stands, 0 .. 1."""
        return abs(float(self.participation[self.sources.index(hit.source), hit.mode - 1]))

    def hits_at(self, source: Source, mode: int, speed_rpm: float) -> bool:
        """Whether a source hits a mode, from 1, at a shaft speed."""
        return any(hit.source == source and hit.mode == mode and hit.holds(speed_rpm) for hit in self.hits)

    def margin_of(self, hit: Hit) -> float | None:
        """How far a hit's source lies above its mode's frequency at the service speed, over it."""
        return None if self.margins is None else float(self.margins[self.sources.index(hit.source), hit.mode - 1])


@dataclass(frozen=True)
class MetWave:
    """A wave that excites the first mode, with the speed and the heading as given."""

    speed_knots: float
    heading_deg: float
    wave: springing.ExcitingWave


@dataclass(frozen=True, eq=False)
class Springing:
    """The waves that meet the ship with her first mode's frequency, or half of it.

    Attributes:
        given: [operation].
        natural_rad_s: of mode 1.
        waves: by heading, speed and order.
    """

    given: OperationInput
    natural_rad_s: float
    waves: tuple[MetWave, ...]


@dataclass(frozen=True, eq=False)
class InService:
    """One condition in service; None where ship.toml has no [excitation], or no [operation].

    Attributes:
        modes: the headline of the condition, of which all this is said.
        uncertainty: (modes,) the model's own of each frequency, over it: as given in [excitation], else estimated.
        resonances: propeller and engine.
        springing: waves.
    """

    modes: Modes
    uncertainty: Array
    resonances: Resonances | None
    springing: Springing | None


def in_service(ship: Ship, modes: Modes) -> InService:
    """Hold a condition's headline modes against what shakes the ship."""
    given = None if ship.excitation is None else ship.excitation.frequency_uncertainty
    uncertainty = model_uncertainty(modes) if given is None else np.full(modes.angular_frequencies.shape, given)
    return InService(
        modes=modes,
        uncertainty=uncertainty,
        resonances=None if ship.excitation is None else _resonances(ship, ship.excitation, modes, uncertainty),
        springing=None if ship.operation is None else _springing(ship.operation, float(modes.angular_frequencies[0])),
    )


def _resonances(ship: Ship, given: ExcitationInput, modes: Modes, uncertainty: Array) -> Resonances:
    excited_by = resonance.sources(given.propeller_blades, given.orders)
    frequencies = modes.frequencies_hz
    bands = resonance.frequency_bands(frequencies, uncertainty)
    hits = resonance.find_hits(frequencies, bands, excited_by, given.shaft_speed_rpm)
    speed = given.service_rpm
    return Resonances(
        given=given,
        sources=excited_by,
        uncertainty=uncertainty,
        bands_hz=bands,
        hits=hits,
        avoid_rpm=resonance.speeds_to_avoid(hit for hit in hits if not hit.flagged),
        flagged_rpm=resonance.speeds_to_avoid(hit for hit in hits if hit.flagged),
        participation=np.array([participation(modes, _place(ship, given, s), s.acts) for s in excited_by]),
        margins=None if speed is None else resonance.margins(frequencies, excited_by, speed),
        beam_limit_hz=resonance.beam_limit_hz(bands),
        unbalances=_unbalances(given),
        responses=() if given.damping is None else tuple(_response(ship, given, given.damping, modes, h) for h in hits),
    )


def _place(ship: Ship, given: ExcitationInput, source: Source) -> float:
    """Where a source acts: a propeller whose place is not given is near the aft perpendicular."""
    if source.acts == "moment":
        assert given.engine_x_m is not None  # [excitation] with engine orders has it
        return given.engine_x_m
    return ship.particulars.aft_perpendicular_m if given.propeller_x_m is None else given.propeller_x_m


def _unbalances(given: ExcitationInput) -> tuple[Unbalance, ...]:
    if given.rated_power_kw is None:
        return ()
    found = []
    for order, moment in ((1, given.m1v_nm), (2, given.m2v_nm)):
        if moment is not None:
            unbalance = engine.power_related_unbalance(moment, given.rated_power_kw)
            found.append(Unbalance(order, unbalance, engine.need_for_compensator(unbalance)))
    return tuple(found)


def _response(ship: Ship, given: ExcitationInput, damping: float, modes: Modes, hit: Hit) -> Response:
    slowest, fastest = given.shaft_speed_rpm
    speed = min(max(hit.critical_rpm, slowest), fastest)
    size = _given_load(given, hit.source)
    # forces of propellers and engines go with the square of the speed
    scaled = None if size is None else engine.moment_at(size, given.reference_rpm, speed)
    place = _place(ship, given, hit.source)
    load = (
        HarmonicLoad(place, force_n=UNIT_FORCE_N if scaled is None else scaled)
        if hit.source.acts == "force"
        else HarmonicLoad(place, moment_n_m=UNIT_MOMENT_N_M if scaled is None else scaled)
    )
    x = np.linspace(0.0, modes.girder.length, POINTS_ALONG)
    exciting = 2.0 * math.pi * hit.source.frequency_hz(speed)
    motion = forced_response(modes, load, exciting, damping, x, only_mode=hit.mode)
    return Response(hit, speed, load, size is not None, motion)


def _given_load(given: ExcitationInput, source: Source) -> float | None:
    """The amplitude of a source's force or moment at the reference speed; None where it is not given."""
    if source.acts == "force":
        return given.propeller_force_n if source.order == given.propeller_blades else None
    return {1.0: given.m1v_nm, 2.0: given.m2v_nm}.get(source.order) or None


def _springing(given: OperationInput, natural_rad_s: float) -> Springing:
    waves = [
        MetWave(speed, heading, wave)
        for heading in given.headings_deg
        for speed in given.speeds_knots
        for wave in springing.exciting_waves(
            natural_rad_s, metres_per_second(speed), math.radians(heading), gravity=GRAVITY_M_S2
        )
    ]
    return Springing(given, natural_rad_s, tuple(waves))
