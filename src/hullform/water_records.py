"""The water about a condition as results.json has it, as types."""

from __future__ import annotations

from hullform.record_table import Finite, Frequencies, RecordTable


class RigidMotionRecord(RecordTable):
    """Heave or pitch in the limit of high frequency, which is not theirs: told apart by shape, and no figure to quote.

    `rigid_share` is the share of rigid-body motion in the kinetic energy, water included.
    """

    angular_frequency_rad_s: Finite
    rigid_share: Finite


class InWaterRecord(RecordTable):
    """The water about a condition. But for `strips_rad_s` and `frequency_ratios` all is of the girder with shear and
    of the panels; masses are for a largest amplitude of 1 m, forces per length and unit acceleration of the mode.
    depth_m is null in deep water; strips_rad_s is null where the water has a bottom, which strips cannot have."""

    density_kg_m3: Finite
    depth_m: Finite | None
    panels: int
    panel_volume_m3: Finite
    wet_from_m: Finite
    wet_to_m: Finite
    asymmetry: Finite
    strips_rad_s: dict[str, Frequencies] | None
    frequency_ratios: dict[str, list[Finite]]
    heave: RigidMotionRecord
    pitch: RigidMotionRecord
    generalised_mass_kg: list[Finite]
    generalised_added_mass_kg: list[Finite]
    hydrostatic_stiffness_shares: list[Finite]
    effective_factors: list[Finite]
    mac_dry: list[list[Finite]]
    edges_m: list[Finite]
    force_kg_per_m: list[list[Finite]]
