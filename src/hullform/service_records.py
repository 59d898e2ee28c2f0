"""What results.json says of a condition in service, as types: resonance, springing, ships as they are."""

from __future__ import annotations

from typing import Literal

from hullform.record_table import Finite, Frequencies, RecordTable


class SourceRecord(RecordTable):
    """What excites: `order` cycles a revolution of the shaft, by a force at the propeller or a moment at the engine.

    `participation` says how well its place excites each mode, -1 to 1; `margin_at_service_speed` how far it lies above
    each natural frequency at the service speed, over it, null without one.
    """

    name: str
    order: Finite
    acts: Literal["force", "moment"]
    participation: list[Finite]
    margin_at_service_speed: list[Finite] | None


class ResponseRecord(RecordTable):
    """The steady motion of the mode at a hit: hull girder alone, zero to peak; no verdict on habitability.

    A load that is not given is one of 1 kN or 1 MN m.
    """

    speed_rpm: Finite
    frequency_hz: Finite
    load_is_given: bool
    load_x_m: Finite
    force_n: Finite
    moment_n_m: Finite
    x_m: list[Finite]
    amplitude_m: list[Finite]
    peak_velocity_m_s: list[Finite]


class HitRecord(RecordTable):
    """A source within a mode's band in the shaft's speed range; `flagged` above mode 3, beam modes by courtesy."""

    mode: int
    source: str
    critical_rpm: Finite
    avoid_rpm: tuple[Finite, Finite]
    at_service_speed: bool | None
    participation: Finite
    flagged: bool
    response: ResponseRecord | None


class UnbalanceRecord(RecordTable):
    """An external moment of the engine over her power, and whether a compensator is likely to be needed."""

    order: int
    pru_nm_per_kw: Finite
    need_for_compensator: Literal["not relevant", "unlikely", "likely", "most likely"]


class ResonanceRecord(RecordTable):
    """Propeller and engine against the natural frequencies of the headline; nothing is said above `beam_limit_hz`.

    `speeds_to_avoid_rpm` joins the hits of modes 1 to 3, `speeds_to_avoid_flagged_rpm` those of modes 4 and 5.
    """

    medium: str
    theory: str
    frequencies_hz: Frequencies
    uncertainty: list[Finite]
    band_lower_hz: Frequencies
    band_upper_hz: Frequencies
    beam_limit_hz: Finite
    shaft_speed_rpm: tuple[Finite, Finite]
    service_rpm: Finite | None
    sources: list[SourceRecord]
    hits: list[HitRecord]
    speeds_to_avoid_rpm: list[tuple[Finite, Finite]]
    speeds_to_avoid_flagged_rpm: list[tuple[Finite, Finite]]
    unbalances: list[UnbalanceRecord]


class WaveRecord(RecordTable):
    """A wave that meets the ship with the first mode's frequency over `order`."""

    order: int
    speed_knots: Finite
    heading_deg: Finite
    frequency_rad_s: Finite
    period_s: Finite
    length_m: Finite
    overtaken: bool


class SpringingRecord(RecordTable):
    """Waves that excite the first mode, at each speed and heading of [operation]; 180 degrees are head seas."""

    medium: str
    theory: str
    natural_frequency_hz: Finite
    waves: list[WaveRecord]


class PublishedRecord(RecordTable):
    """A published ship of the type and length, in water."""

    kind: str
    length_m: Finite
    condition: str
    cycles_per_minute: list[Finite]


class RatiosRecord(RecordTable):
    """The headline's 3- and 4-node over the 2-node frequency, the model's own relative uncertainty of each, the limits
    of ships in water, which the checks widen by it, and such ships like her."""

    medium: str
    theory: str
    three_to_two_node: Finite
    three_to_two_node_uncertainty: Finite
    three_to_two_node_limits: tuple[Finite, Finite]
    four_to_two_node: Finite
    four_to_two_node_uncertainty: Finite
    four_to_two_node_limits: tuple[Finite, Finite]
    published_ships: list[PublishedRecord]
