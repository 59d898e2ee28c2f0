"""From a ship.toml to frequencies: each stage takes one frozen type and hands on the next."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from hullform import checks
from hullform.body_plan import BodyPlan
from hullform.empirical_figures import empirical_figures
from hullform.hull.hydrostatics import Hydrostatics
from hullform.hull.loft import Hull
from hullform.loading.distributions import Distribution, girder_from
from hullform.loading.structure import Structure, shell_structure
from hullform.loading.weights import KG_PER_T, LightShip, condition_items, light_ship
from hullform.outcome import ConditionRun, Distortion, Run
from hullform.ship import ConditionInput, Ship
from hullvib import distortion
from hullvib.finite_elements import FiniteElements
from hullvib.girder import Girder
from hullvib.modes import Modes
from hullvib.ritz import Ritz
from hullvib.solving import solve

Array = NDArray[np.float64]
Progress = Callable[[str], None]

MODES = 5
RITZ_FUNCTIONS = 12
ELEMENTS = 100
CONVERGENCE = range(4, 13)
CONVERGENCE_MODES = 3
# The condition that sails at the design draught.
LOADED = "loaded"


def trace(ship: Ship) -> BodyPlan:
    """Read the body plan of a ship's picture.

    Raises:
        PictureError: the picture cannot be read as a body plan.
    """
    from hullform.picture.reading import read_picture

    return read_picture(ship).body_plan


def loft(ship: Ship, body_plan: BodyPlan) -> Hull:
    """The hull through a body plan's stations.

    Raises:
        HullError: the stations make no hull.
    """
    return Hull.from_body_plan(body_plan, ship.particulars)


def girder_of(ship: Ship, hull: Hull, condition: str) -> Girder:
    """The girder of one loading condition of a ship.

    Raises:
        ShipFileError: the ship has no such condition, or no [structure] or [weights].
        LoadingError: weights or structure that cannot be.
    """
    given, _, _ = ship.require_sections_of_a_run()
    structure = shell_structure(hull, given)
    light = _light_ship(ship, hull, structure, _at_draught(ship, hull))
    return _girder(ship, hull, structure, ship.require_condition(condition), light)[1]


def run_ship(ship: Ship, progress: Progress = lambda step: None) -> Run:
    """The whole road, from the picture to every condition's modes.

    Args:
        ship: from `read_ship`.
        progress: is told of each stage as it begins.

    Raises:
        HullformError: the input is wrong; the message says what to do.
    """
    from hullform.picture.reading import read_picture

    given, weights, conditions = ship.require_sections_of_a_run()
    seconds: dict[str, float] = {}
    clock = time.perf_counter()

    def finished(stage: str) -> None:
        nonlocal clock
        now = time.perf_counter()
        seconds[stage], clock = now - clock, now

    progress("reading the picture")
    reading = read_picture(ship)
    finished("picture")
    progress("fitting sections and lofting the hull")
    hull = loft(ship, reading.body_plan)
    at_draught = _at_draught(ship, hull)
    finished("hull")
    progress("structure and weights")
    structure = shell_structure(hull, given)
    light = _light_ship(ship, hull, structure, at_draught)
    finished("loading")
    runs = {}
    for condition in conditions:
        progress(f"frequencies: {condition.title}")
        runs[condition.name] = _run_condition(ship, hull, structure, at_draught, light, condition)
    finished("frequencies")
    return Run(
        ship=ship,
        reading=reading,
        hull=hull,
        at_draught=at_draught,
        structure=structure,
        light=light,
        checks=(
            *checks.checks_of_the_hull(ship.particulars, at_draught),
            checks.check_light_ship(weights.semi_concentrated_weight_t, light.machinery_and_outfit_estimate),
        ),
        conditions=runs,
        seconds=seconds,
    )


def _at_draught(ship: Ship, hull: Hull) -> Hydrostatics:
    return hull.hydrostatics(ship.particulars.draught_m, ship.water.density_kg_m3)


def _light_ship(ship: Ship, hull: Hull, structure: Structure, at_draught: Hydrostatics) -> LightShip:
    _, weights, _ = ship.require_sections_of_a_run()
    return light_ship(
        weights,
        hull,
        structure,
        ship.particulars,
        at_draught.block_coefficient,
        at_draught.displacement_kg / KG_PER_T,
    )


def _girder(
    ship: Ship, hull: Hull, structure: Structure, condition: ConditionInput, light: LightShip
) -> tuple[tuple[Distribution, ...], Girder]:
    items = condition_items(condition, light, hull, ship.particulars.draught_m)
    name = f"{ship.particulars.name}, {condition.title}"
    return items, girder_from(name, items, structure.x_m, structure.flexural_rigidity)


def _run_condition(
    ship: Ship, hull: Hull, structure: Structure, at_draught: Hydrostatics, light: LightShip, condition: ConditionInput
) -> ConditionRun:
    items, girder = _girder(ship, hull, structure, condition, light)
    mass = girder.total_mass
    density = ship.water.density_kg_m3
    capacity = hull.hydrostatics(hull.depth_amidships_m, density).displacement_kg
    floats = checks.check_floating(mass, capacity, hull.depth_amidships_m)
    draught = hull.depth_amidships_m if mass > capacity else hull.draught_for(mass, density)
    floating = hull.hydrostatics(draught, density)
    found = [floats, checks.check_trim(girder.centre_of_gravity, floating)]
    if condition.name == LOADED:
        found.insert(0, checks.check_displacement(mass, at_draught))
    modes = solve(girder, Ritz(functions=RITZ_FUNCTIONS), modes=MODES)
    return ConditionRun(
        condition=condition,
        items=items,
        girder=girder,
        floating=floating,
        checks=tuple(found),
        solutions={
            "ritz": modes,
            "ritz_elastic_only": solve(girder, Ritz(functions=RITZ_FUNCTIONS, rigid_body=False), modes=MODES),
            "finite_element": solve(girder, FiniteElements(elements=ELEMENTS), modes=MODES),
        },
        convergence_rad_s=_convergence(girder, rigid_body=True),
        elastic_only_convergence_rad_s=_convergence(girder, rigid_body=False),
        distortion=_distortion(modes),
        empirical=empirical_figures(ship, structure, mass / KG_PER_T, draught),
    )


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
