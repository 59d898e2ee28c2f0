"""The ship afloat: structure and weights on the lofted hull, and every condition in still water, with checks."""

from __future__ import annotations

from dataclasses import dataclass

from hullform import checks
from hullform.at_rest import AtRest, at_rest
from hullform.checks import Check
from hullform.errors import HullError
from hullform.hull.hydrostatics import Hydrostatics
from hullform.hull.loft import Hull
from hullform.loading.distributions import Distribution, girder_from
from hullform.loading.items import KG_PER_T
from hullform.loading.structure import Structure, structure_of
from hullform.loading.weights import LightShip, condition_items, light_ship
from hullform.ship import Ship
from hullform.ship_structure import StructureInput
from hullform.ship_weights import ConditionInput
from hullvib.girder import Girder

# Of everything on board about the neutral axis, over the depth: a hull full of weights spread evenly has 0.29 of its
# depth, one with most of it in bottom and deck up to 0.5.
RADIUS_OF_GYRATION = 0.35


@dataclass(frozen=True, eq=False)
class ConditionAfloat:
    """One loading condition: its weights along the ship, the girder that carries them, and how she floats.

    Attributes:
        condition: what ship.toml says of it.
        items: its weights.
        girder: m(x), EI(x), k G A(x) and rotary inertia.
        floating: hydrostatics on even keel, at the mean of given draughts or else at the draught of its mass (at the
            depth, where she would sink).
        at_rest: her waterline, shear force and bending moment.
        checks: of both.
    """

    condition: ConditionInput
    items: tuple[Distribution, ...]
    girder: Girder
    floating: Hydrostatics
    at_rest: AtRest
    checks: tuple[Check, ...]


@dataclass(frozen=True, eq=False)
class ShipAfloat:
    """A ship loaded in all her conditions.

    Attributes:
        hull: lofted.
        at_draught: hydrostatics at the design draught.
        structure: section properties along the ship.
        light: steel, machinery and their estimates.
        checks: of the hull, the structure and the light ship.
        conditions: in the order of ship.toml.
    """

    hull: Hull
    at_draught: Hydrostatics
    structure: Structure
    light: LightShip
    checks: tuple[Check, ...]
    conditions: tuple[ConditionAfloat, ...]


def load_ship(ship: Ship, hull: Hull) -> ShipAfloat:
    """Give a hull her structure and her weights, and float her in every condition.

    The heaviest condition is held against the buoyancy at the design draught.

    Raises:
        ShipFileError: [structure], [weights] or [[conditions]] is missing.
        LoadingError: weights or a structure that cannot be.
        HullError: nothing of her is under water.
    """
    given, weights, conditions = ship.require_sections_of_a_run()
    at_draught = hull.hydrostatics(ship.particulars.draught_m, ship.water.density_kg_m3)
    structure = structure_of(hull, given)
    displacement_t = at_draught.displacement_kg / KG_PER_T
    light = light_ship(
        weights,
        hull,
        structure,
        ship.particulars,
        at_draught.block_coefficient,
        displacement_t,
        given.superstructures,
    )
    heaviest = max(conditions, key=lambda condition: condition.load_t)
    return ShipAfloat(
        hull=hull,
        at_draught=at_draught,
        structure=structure,
        light=light,
        checks=_checks_of_the_ship(ship, given, at_draught, structure, light, hull.midships_m),
        conditions=tuple(
            _afloat(ship, hull, structure, light, condition, at_draught if condition is heaviest else None)
            for condition in conditions
        ),
    )


def _checks_of_the_ship(
    ship: Ship,
    given: StructureInput,
    at_draught: Hydrostatics,
    structure: Structure,
    light: LightShip,
    midships_m: float,
) -> tuple[Check, ...]:
    found = list(checks.checks_of_the_hull(ship.particulars, at_draught))
    if given.midship_second_moment_m4 is not None:
        found.append(checks.check_thickness(structure.thickness_factor, given))
    if light.machinery_and_outfit_estimate is None:
        found.append(checks.check_bare_light_ship(light.beyond_steel_t, light.steel_weight_t))
    elif light.beyond_steel_given:
        found.append(checks.check_light_ship(light.beyond_steel_t, light.machinery_and_outfit_estimate))
    numeral = None if light.steel_given else checks.check_steel_numeral(ship.particulars, given.superstructures)
    hatches = checks.check_hatches(ship.particulars, given, midships_m)
    return (*found, *(check for check in (numeral, hatches) if check))


def _afloat(
    ship: Ship,
    hull: Hull,
    structure: Structure,
    light: LightShip,
    condition: ConditionInput,
    held_against: Hydrostatics | None,
) -> ConditionAfloat:
    items = condition_items(condition, light, hull, structure, ship.particulars.draught_m)
    name = f"{ship.particulars.name}, {condition.title}"
    girder = girder_from(
        name,
        items,
        structure.x_m,
        structure.flexural_rigidity,
        structure.shear_rigidity,
        RADIUS_OF_GYRATION * ship.particulars.depth_m,
    )
    mass, density, depth = girder.total_mass, ship.water.density_kg_m3, hull.depth_amidships_m
    capacity = hull.hydrostatics(depth, density).displacement_kg
    aft, fore = condition.draught_aft_m, condition.draught_fore_m
    given = None if aft is None or fore is None else hull.waterline(aft, fore)
    even_keel = depth if mass > capacity else hull.draught_for(mass, density)
    try:
        floating = hull.hydrostatics(even_keel if given is None else given.draught_m, density)
    except HullError as error:
        keys = "" if given is None else ", mean of draught_aft_m and draught_fore_m"
        raise HullError(f"{ship.path}: condition '{condition.name}'{keys}: {error}") from error
    found = [checks.check_floating(mass, capacity, depth)]
    if held_against is not None:
        found.insert(0, checks.check_displacement(mass, held_against))
    rest = at_rest(hull, items, density, even_keel, given)
    return ConditionAfloat(condition, items, girder, floating, rest, (*found, *rest.checks))
