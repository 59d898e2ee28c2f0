"""results.json: everything that a run found out, for other programs.

All digits, SI, no NaN; times stand in provenance alone.
"""

from __future__ import annotations

import datetime
import hashlib
import importlib.metadata
import json
import math
import platform
from collections.abc import Iterable, Mapping
from dataclasses import asdict
from pathlib import Path

from hullform.checks import Check
from hullform.files import PROGRAM
from hullform.in_service import InService
from hullform.outcome import Array, ConditionRun, Run
from hullform.record_table import Frequencies
from hullform.records import (
    Band,
    BracketRecord,
    CheckRecord,
    ConditionRecord,
    DistortionRecord,
    Headline,
    HullRecord,
    LightShipRecord,
    PlatesRecord,
    Provenance,
    Results,
    Solution,
    StationRecord,
    StructureRecord,
    WeightRecord,
)
from hullform.rest_results import floating_record, still_water_record
from hullform.service_results import ratios_record, resonance_record, springing_record
from hullform.water_results import in_water_record
from hullvib.bounds import Bracket
from hullvib.mode_files import solution_record
from hullvib.modes import Modes
from hullvib.resonance import frequency_bands


def results_of(run: Run) -> Results:
    """Collect a run's figures."""
    return Results(
        schema_number=1,
        provenance=_provenance(run),
        ship=run.ship.particulars.model_dump(mode="json", exclude_none=True),
        hull=_hull(run),
        structure=_structure(run),
        light_ship=_light_ship(run),
        checks=_checks(run.checks),
        doubts=list(run.doubts),
        conditions={name: _condition(run, name) for name in run.conditions},
    )


def write_results(run: Run, path: Path) -> None:
    """Write a run's results.json."""
    document = results_of(run).model_dump(mode="json", by_alias=True)
    path.write_text(json.dumps(document, indent=1, allow_nan=False) + "\n", encoding="utf-8")


def _provenance(run: Run) -> Provenance:
    packages = ("hullform", "numpy", "scipy", "opencv-python-headless", "trimesh")
    file, review, profile = run.ship.body_plan.file, run.ship.review_path, run.ship.profile_path
    reviewed = run.reading is not None and review.exists()
    return Provenance(
        program=PROGRAM,
        versions={"python": platform.python_version(), **{name: importlib.metadata.version(name) for name in packages}},
        created_utc=datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        ship_file=run.ship.path.name,
        ship_file_sha256=_digest(run.ship.path),
        body_plan_file=None if file is None else file.name,
        body_plan_file_sha256=None if file is None else _digest(file),
        profile=None if profile is None else profile.name,
        profile_sha256=None if profile is None else _digest(profile),
        review=review.name if reviewed else None,
        review_sha256=_digest(review) if reviewed else None,
        seconds=dict(run.seconds),
    )


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _checks(checks: Iterable[Check]) -> list[CheckRecord]:
    records = []
    for check in checks:
        low, high = (limit if math.isfinite(limit) else None for limit in check.limits)
        records.append(
            CheckRecord(
                id=check.id,
                title=check.title,
                value=check.value,
                limit=check.limit,
                limits=(low, high),
                unit=check.unit,
                ok=check.ok,
                remedy=check.remedy,
            )
        )
    return records


def _hull(run: Run) -> HullRecord:
    records = []
    for station, fitted in zip(run.body_plan.stations, run.hull.fits, strict=True):
        fit, model = fitted.fit, fitted.model
        records.append(
            StationRecord(
                x_m=station.x_m,
                half=station.half,
                name=station.name,
                confidence=station.confidence,
                shared_with_m=list(station.shared_with_m),
                half_breadth_m=fitted.half_breadth_m,
                top_height_m=fitted.top_height_m,
                keel_height_m=fitted.keel_height_m,
                model=None if model is None else model.kind,
                p=None if fit is None else fit.ellipse.p,
                q=None if fit is None else fit.ellipse.q,
                area_error=None if model is None else model.area_error,
                area_error_to_deck=None if model is None else model.area_error_to_deck,
                largest_deviation_m=None if model is None else model.largest_deviation_m,
            )
        )
    calibration = run.body_plan.calibration
    return HullRecord(
        source=run.body_plan.source,
        stations=records,
        hydrostatics=asdict(run.at_draught),
        notes=list(run.body_plan.notes),
        calibration=None if calibration is None else asdict(calibration),
    )


def _structure(run: Run) -> StructureRecord:
    structure = run.structure
    given, _, _ = run.ship.require_sections_of_a_run()
    return StructureRecord(
        plain_shell=given.is_plain_shell,
        midship_plates=[
            PlatesRecord(
                name=plating.name,
                y_m=plating.points[:, 0].tolist(),
                z_m=plating.points[:, 1].tolist(),
                **asdict(plating.scantling),
            )
            for plating in structure.midship_platings
        ],
        steel_volume_m3=structure.steel_volume_m3,
        transverse_steel_m3=list(structure.transverse_steel_m3),
        midship_shell_second_moment_m4=structure.midship_shell_second_moment_m4,
        thickness_factor=structure.thickness_factor,
        midship_shell_shear_area_m2=structure.midship_shell_shear_area_m2,
        shear_factor=structure.shear_factor,
        equivalent_thickness_m=structure.equivalent_thickness_m,
        youngs_modulus_pa=structure.youngs_modulus_pa,
        shear_modulus_pa=structure.shear_modulus_pa,
        stations_at_the_floor=structure.floored,
        x_m=structure.x_m.tolist(),
        girth_m=structure.girth_m.tolist(),
        area_m2=structure.area_m2.tolist(),
        neutral_axis_m=structure.neutral_axis_m.tolist(),
        second_moment_m4=structure.second_moment_m4.tolist(),
        horizontal_second_moment_m4=structure.horizontal_second_moment_m4.tolist(),
        shear_area_m2=structure.shear_area_m2.tolist(),
        torsion_constant_m4=structure.torsion_constant_m4.tolist(),
        steel_area_m2=structure.steel_area_m2.tolist(),
    )


def _light_ship(run: Run) -> LightShipRecord:
    light = run.light
    steel, rest = light.steel_estimate, light.machinery_and_outfit_estimate
    return LightShipRecord(
        steel_weight_t=light.steel_weight_t,
        steel_given=light.steel_given,
        steel_estimate_t=steel.weight_t,
        steel_estimate_range_t=(steel.lower_t, steel.upper_t),
        machinery_and_outfit_t=light.beyond_steel_t,
        machinery_and_outfit_given=light.beyond_steel_given,
        machinery_and_outfit_estimate_t=None if rest is None else rest.weight_t,
        machinery_and_outfit_range_t=None if rest is None else (rest.lower_t, rest.upper_t),
    )


def _bracket(bracket: Bracket | str) -> BracketRecord:
    if isinstance(bracket, str):
        return BracketRecord(lower=None, upper=None, proof=bracket)
    return BracketRecord(lower=bracket.lower.tolist(), upper=bracket.upper.tolist(), proof=bracket.proof)


def _condition(whole: Run, name: str) -> ConditionRecord:
    run, service = whole.conditions[name], whole.in_service[name]
    floating, modes = run.floating, run.modes
    waterline, equilibrium = run.at_rest.position.waterline, run.at_rest.equilibrium
    return ConditionRecord(
        label=run.condition.title,
        mass_kg=run.mass_kg,
        lcg_m=run.girder.centre_of_gravity,
        displacement_kg=floating.displacement_kg,
        draughts={"aft_m": waterline.draught_aft_m, "fore_m": waterline.draught_fore_m},
        draughts_from=run.at_rest.adopted,
        draughts_reason=run.at_rest.reason,
        equilibrium=None if equilibrium is None else floating_record(equilibrium, floating.water_density_kg_m3),
        still_water=still_water_record(run),
        weights=[
            WeightRecord(name=item.name, mass_kg=item.mass_kg, centre_m=item.centre_m if item.mass_kg else None)
            for item in run.items
        ],
        hydrostatics=asdict(floating),
        checks=_checks(run.checks),
        doubts=[check.doubt for check in run.checks if not check.ok],
        dry_rad_s={name: found.angular_frequencies.tolist() for name, found in run.solutions.items()},
        wet_rad_s={
            name: found.modes.angular_frequencies.tolist()
            for name, found in (("euler", run.in_water.euler), ("shear", run.in_water.shear))
        },
        in_water=in_water_record(run.in_water),
        bracket_rad_s=_bracket(run.bracket),
        empirical_rad_s={name: found.tolist() for name, found in run.empirical.figures_rad_s.items()},
        empirical_inputs=dict(run.empirical.inputs),
        headline=_headline(service),
        solutions=[Solution.model_validate(solution_record(found)) for found in (*run.solutions.values(), *_wet(run))],
        convergence={
            "ritz": _by_functions(run.convergence_rad_s),
            "ritz_elastic_only": _by_functions(run.elastic_only_convergence_rad_s),
        },
        distortion=_distortion(run),
        ships_as_they_are=ratios_record(modes, whole.ship.particulars),
        resonance=resonance_record(service),
        springing=springing_record(service),
    )


def _headline(service: InService) -> Headline:
    modes = service.modes
    lower, upper = frequency_bands(modes.frequencies_hz, service.uncertainty, keep_clear=0.0)
    return Headline(
        medium=modes.medium,
        theory=modes.theory,
        frequencies_hz=modes.frequencies_hz.tolist(),
        band=Band(uncertainty=service.uncertainty.tolist(), lower_hz=lower.tolist(), upper_hz=upper.tolist()),
    )


def _wet(run: ConditionRun) -> tuple[Modes, ...]:
    water = run.in_water
    solved = (water.euler, water.shear, water.strips_euler, water.strips_shear)
    return tuple(found.modes for found in solved if found is not None)


def _by_functions(convergence: Mapping[int, Array]) -> dict[str, Frequencies]:
    return {str(functions): found.tolist() for functions, found in convergence.items()}


def _distortion(run: ConditionRun) -> DistortionRecord:
    found = run.distortion
    shifts = [[shift.shift for shift in kind] for kind in (found.nodes, found.antinodes)]
    node_shifts, antinode_shifts = ([None if s is None else s.tolist() for s in kind] for kind in shifts)
    return DistortionRecord(
        weights=found.weights.tolist(),
        # a uniform girder's weights are the unit matrix, and dominance is without bound
        diagonal_dominance=[float(value) if value < float("inf") else None for value in found.diagonal_dominance],
        nondimensional_frequencies=found.nondimensional.tolist(),
        node_shifts_m=node_shifts,
        antinode_shifts_m=antinode_shifts,
        energy_bounds_m=found.energy.bounds_m.tolist(),
        kinetic_energy_shares=found.energy.kinetic.tolist(),
        strain_energy_shares=found.energy.strain.tolist(),
        mass_correlation=found.correlation.mass.tolist(),
        rigidity_correlation=found.correlation.rigidity.tolist(),
    )
