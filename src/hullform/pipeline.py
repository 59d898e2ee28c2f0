"""From a ship.toml to frequencies: each stage takes one frozen type and hands on the next."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hullform import checks
from hullform.afloat import ConditionAfloat, ShipAfloat, load_ship
from hullform.body_plan import BodyPlan
from hullform.empirical_figures import in_water_figures
from hullform.errors import HullError
from hullform.hull.loft import Hull
from hullform.in_service import in_service
from hullform.in_water import InWater, put_in_water
from hullform.loading.items import KG_PER_T
from hullform.outcome import ConditionRun, Distortion, Run
from hullform.ship import Ship
from hullform.ship_body_plan import MeshSource, OffsetsSource, PictureSource
from hullform.wet_checks import checks_of_ratios
from hullvib import distortion
from hullvib.bounds import Bracket, bracket
from hullvib.errors import NotProven
from hullvib.finite_elements import FiniteElements
from hullvib.girder import Girder
from hullvib.model_spread import ratio_uncertainty
from hullvib.modes import Modes
from hullvib.real_ships import ratios
from hullvib.ritz import Ritz
from hullvib.solving import solve
from hullvib.stodola import StodolaRitz
from hullvib.timoshenko_elements import TimoshenkoElements

if TYPE_CHECKING:
    from hullform.picture.reading import PictureReading

Array = NDArray[np.float64]
Progress = Callable[[str], None]

MODES = 5
FUNCTIONS = 12
ELEMENTS = 100
CONVERGENCE = range(4, 13)
CONVERGENCE_MODES = 3


def trace(ship: Ship) -> BodyPlan:
    """The body plan of a ship: read from her picture, her table of offsets or her mesh, or made of her particulars.

    Raises:
        PictureError: the picture cannot be read as a body plan.
        BodyPlanError: nor can the table or the mesh, or the particulars make no form.
    """
    return read_form(ship)[0]


def read_form(ship: Ship) -> tuple[BodyPlan, PictureReading | None]:
    """The body plan, and for a picture all that was read of it; raises as `trace`."""
    body_plan, reading = _read_stations(ship)
    if ship.profile_path is None:
        return body_plan, reading
    from hullform.doors.profile_reading import read_profile

    return replace(body_plan, profile=read_profile(ship, ship.profile_path)), reading


def _read_stations(ship: Ship) -> tuple[BodyPlan, PictureReading | None]:
    source = ship.body_plan
    if isinstance(source, PictureSource):
        from hullform.picture.reading import read_picture

        reading = read_picture(ship)
        return reading.body_plan, reading
    if isinstance(source, OffsetsSource):
        from hullform.doors.offsets_reading import read_offsets

        return read_offsets(ship, source), None
    if isinstance(source, MeshSource):
        from hullform.doors.mesh_reading import read_mesh

        return read_mesh(ship, source), None
    from hullform.doors.parametric import form_after_particulars

    return form_after_particulars(ship, source), None


def reading_step(ship: Ship) -> str:
    """What `read_form` does, for those who wait for it."""
    source = ship.body_plan
    if isinstance(source, PictureSource):
        return "reading the picture"
    return "making a form of the particulars" if source.file is None else f"reading {source.file.name}"


def hull_of(ship: Ship, body_plan: BodyPlan) -> Hull:
    """The hull through a body plan's stations.

    Raises:
        HullError: the stations make no hull; names the ship's file.
    """
    try:
        return Hull.from_body_plan(body_plan, ship.particulars, sections=ship.hull.sections)
    except HullError as error:
        raise HullError(f"{ship.path}: {error}") from None


def girder_of(ship: Ship, hull: Hull, condition: str) -> Girder:
    """The girder of one loading condition of a ship; `load_ship` has it with its checks.

    Raises:
        ShipFileError: the ship has no such condition, or no [structure] or [weights].
        LoadingError: weights or a structure that cannot be.
    """
    wanted = ship.require_condition(condition)
    (afloat,) = (found for found in load_ship(ship, hull).conditions if found.condition is wanted)
    return afloat.girder


def run_ship(ship: Ship, progress: Progress = lambda step: None) -> Run:
    """The whole road, from the picture, or what stands for it, to every condition's modes.

    Args:
        ship: from `read_ship`.
        progress: is told of each stage as it begins.

    Raises:
        HullformError: the input is wrong; the message says what to do.
    """
    ship.require_sections_of_a_run()
    seconds: dict[str, float] = {}
    clock = time.perf_counter()

    def finished(stage: str) -> None:
        nonlocal clock
        now = time.perf_counter()
        seconds[stage], clock = now - clock, now

    progress(reading_step(ship))
    body_plan, reading = read_form(ship)
    finished("picture" if reading else "form")
    progress("fitting sections and lofting the hull")
    hull = hull_of(ship, body_plan)
    mesh = checks.check_mesh(float(hull.mesh().volume), hull.volume_m3)
    finished("hull")
    progress("structure and weights")
    afloat = load_ship(ship, hull)
    finished("loading")
    water = {}
    for condition in afloat.conditions:
        progress(f"the water: {condition.condition.title}")
        water[condition.condition.name] = _in_water(ship, afloat, condition)
    finished("water")
    runs = {}
    for condition in afloat.conditions:
        name = condition.condition.name
        progress(f"frequencies: {condition.condition.title}")
        runs[name] = _vibrate(ship, afloat, condition, water[name])
    finished("frequencies")
    progress("propeller, engine and waves")
    service = {name: in_service(ship, condition.modes) for name, condition in runs.items()}
    finished("service")
    return Run(
        ship=ship,
        body_plan=body_plan,
        reading=reading,
        hull=hull,
        at_draught=afloat.at_draught,
        structure=afloat.structure,
        light=afloat.light,
        checks=(*afloat.checks, mesh),
        conditions=runs,
        in_service=service,
        seconds=seconds,
    )


def _in_water(ship: Ship, afloat: ShipAfloat, condition: ConditionAfloat) -> InWater:
    try:
        return put_in_water(
            afloat.hull,
            afloat.structure,
            condition.girder,
            condition.at_rest.position,
            ship.water,
            modes=MODES,
            functions=FUNCTIONS,
        )
    except HullError as error:
        raise HullError(f"{ship.path}: condition '{condition.condition.name}': {error}") from error


def _vibrate(ship: Ship, afloat: ShipAfloat, condition: ConditionAfloat, in_water: InWater) -> ConditionRun:
    girder, floating = condition.girder, condition.floating
    solutions = {
        "stodola_ritz": solve(girder, StodolaRitz(functions=FUNCTIONS), modes=MODES),
        "ritz": solve(girder, Ritz(functions=FUNCTIONS), modes=MODES),
        "ritz_elastic_only": solve(girder, Ritz(functions=FUNCTIONS, rigid_body=False), modes=MODES),
        "finite_element": solve(girder, FiniteElements(elements=ELEMENTS), modes=MODES),
        "shear": solve(girder, StodolaRitz(functions=FUNCTIONS, shear=True), modes=MODES),
        "timoshenko": solve(girder, TimoshenkoElements(elements=ELEMENTS), modes=MODES),
    }
    quoted = in_water.shear.modes
    frequency = checks.check_frequency(float(quoted.frequencies_hz[0]), girder.length)
    _, three_node, four_node, *_ = ratio_uncertainty(quoted)
    of_ships = checks_of_ratios(
        ratios(quoted.angular_frequencies), (float(three_node), float(four_node)), quoted.medium
    )
    return ConditionRun(
        condition=condition.condition,
        items=condition.items,
        girder=girder,
        floating=floating,
        at_rest=condition.at_rest,
        checks=(*condition.checks, *in_water.checks, frequency, *of_ships),
        solutions=solutions,
        in_water=in_water,
        bracket=_bracket(solutions["stodola_ritz"]),
        convergence_rad_s=_convergence(girder, rigid_body=True),
        elastic_only_convergence_rad_s=_convergence(girder, rigid_body=False),
        distortion=_distortion(solutions["ritz"]),
        empirical=in_water_figures(ship, afloat.structure, girder.total_mass / KG_PER_T, floating.draught_m),
    )


def _bracket(modes: Modes) -> Bracket | str:
    try:
        return bracket(modes)
    except NotProven as reason:
        return str(reason)


def _convergence(girder: Girder, *, rigid_body: bool) -> dict[int, Array]:
    found = distortion.ritz_convergence(girder, CONVERGENCE, CONVERGENCE_MODES, rigid_body=rigid_body)
    return dict(zip(CONVERGENCE, found, strict=True))


def _distortion(modes: Modes) -> Distortion:
    weights = distortion.weight_vectors(modes)
    return Distortion(
        weights=weights,
        diagonal_dominance=distortion.diagonal_dominance(weights),
        nondimensional=distortion.nondimensional_frequencies(modes),
        nodes=tuple(distortion.node_shifts(modes)),
        antinodes=tuple(distortion.antinode_shifts(modes)),
        energy=distortion.energy_split(modes),
        correlation=distortion.spatial_correlation(modes),
    )
