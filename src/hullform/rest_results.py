"""A ship at rest as results.json has her."""

from __future__ import annotations

from hullform.hull.equilibrium import FloatingPosition
from hullform.loading.still_water import Extremes, sampled
from hullform.outcome import ConditionRun
from hullform.rest_records import ExtremesRecord, FloatingRecord, StillWaterRecord


def floating_record(position: FloatingPosition, density_kg_m3: float) -> FloatingRecord:
    """A floating position in water of a density."""
    waterline = position.waterline
    return FloatingRecord(
        draught_aft_m=waterline.draught_aft_m,
        draught_fore_m=waterline.draught_fore_m,
        draught_midships_m=waterline.draught_m,
        trim_m=waterline.trim_m,
        trim_percent_lpp=100 * waterline.trim_m / waterline.length_between_perpendiculars_m,
        displacement_kg=density_kg_m3 * position.volume_m3,
        lcb_m=position.lcb_x_m,
        least_freeboard_m=position.least_freeboard_m,
    )


def _extremes(found: Extremes) -> ExtremesRecord:
    return ExtremesRecord(
        maximum=found.greatest, maximum_x_m=found.greatest_x_m, minimum=found.least, minimum_x_m=found.least_x_m
    )


def still_water_record(run: ConditionRun) -> StillWaterRecord:
    """Weight, buoyancy, shear force and bending moment of a condition, both ends of every piece among the places."""
    found = run.at_rest.still_water
    curves = (found.weight, found.buoyancy, found.shear_force, found.bending_moment)
    x = sampled(found.weight, points=2)[0]
    weight, buoyancy, shear, moment = (sampled(curve, points=2)[1].tolist() for curve in curves)
    return StillWaterRecord(
        equilibrium=run.at_rest.equilibrium is not None,
        draught_aft_m=found.waterline.draught_aft_m,
        draught_fore_m=found.waterline.draught_fore_m,
        shear_force_n=_extremes(found.shear_extremes),
        bending_moment_n_m=_extremes(found.moment_extremes),
        unclosed_shear_force_n=found.unclosed_shear_n,
        unclosed_bending_moment_n_m=found.unclosed_moment_n_m,
        closing_shear=found.shear_residual,
        closing_moment=found.moment_residual,
        x_m=x.tolist(),
        weight_n_per_m=weight,
        buoyancy_n_per_m=buoyancy,
        shear_force_curve_n=shear,
        bending_moment_curve_n_m=moment,
    )
