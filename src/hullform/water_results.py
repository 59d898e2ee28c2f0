"""The water about a condition as it stands in results.json."""

from __future__ import annotations

from hullform.in_water import InWater
from hullform.water_records import InWaterRecord, RigidMotionRecord
from hullvib.wet import RigidMotion


def in_water_record(water: InWater) -> InWaterRecord:
    """Panels, wet modes and what the water adds to each."""
    shear = water.shear
    wet_from, wet_to = water.panels.extent_m
    return InWaterRecord(
        density_kg_m3=water.flow.density_kg_m3,
        depth_m=water.depth_m,
        panels=2 * len(water.panels),
        panel_volume_m3=water.panels.volume_m3,
        wet_from_m=wet_from,
        wet_to_m=wet_to,
        asymmetry=shear.added_mass.asymmetry,
        strips_rad_s=None
        if water.strips_euler is None or water.strips_shear is None
        else {
            "euler": water.strips_euler.modes.angular_frequencies.tolist(),
            "shear": water.strips_shear.modes.angular_frequencies.tolist(),
        },
        frequency_ratios={"euler": water.euler.frequency_ratios.tolist(), "shear": shear.frequency_ratios.tolist()},
        heave=_rigid_motion(shear.heave),
        pitch=_rigid_motion(shear.pitch),
        generalised_mass_kg=shear.generalised_mass.tolist(),
        generalised_added_mass_kg=shear.generalised_added_mass.tolist(),
        hydrostatic_stiffness_shares=shear.hydrostatic_stiffness_share.tolist(),
        effective_factors=water.effective_factors.tolist(),
        mac_dry=shear.mac_dry.tolist(),
        edges_m=shear.added_mass.edges_m.tolist(),
        force_kg_per_m=shear.force_kg_per_m.tolist(),
    )


def _rigid_motion(found: RigidMotion) -> RigidMotionRecord:
    return RigidMotionRecord(angular_frequency_rad_s=found.angular_frequency, rigid_share=found.share)
