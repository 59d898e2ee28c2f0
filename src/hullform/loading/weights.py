"""The weights of a loading condition along the ship: the paper's three classes, and the items of a weight list.

Steel follows the section of the longitudinal steel, which is the girth of a shell of one thickness (end plates and
transverse bulkheads at their place), machinery lies over 0 .. 0.2 LOA, deck machinery
over 0.9 .. 1.0 LOA, deadweight over 0.2 .. 0.9 LOA in step with the sectional area below the design draught. Where
nothing is said of machinery and outfit Watson's estimates stand for them: machinery in its place, outfit evenly.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.hull.loft import Hull
from hullform.loading import watson
from hullform.loading.distributions import Distribution, shaped, uniform
from hullform.loading.items import KG_PER_T, item_along
from hullform.loading.structure import Structure
from hullform.ship import Particulars
from hullform.ship_structure import Superstructure
from hullform.ship_weights import ConditionInput, WeightsInput

Array = NDArray[np.float64]

MACHINERY = (0.0, 0.2)  # fractions of LOA, the paper's section 2.2
DECK_MACHINERY = (0.9, 1.0)
DEADWEIGHT = (0.2, 0.9)


@dataclass(frozen=True, eq=False)
class LightShip:
    """Steel and semi-concentrated weights, the same in every condition.

    Attributes:
        items: steel, machinery, deck machinery or outfit, and those of the light ship's list.
        steel_weight_t: as given, or estimated.
        steel_estimate: Watson & Gilfillan's figure and range for this ship.
        steel_given: whether ship.toml gave the steel weight.
        beyond_steel_t: machinery and outfit, as given, or estimated.
        beyond_steel_given: whether ship.toml said anything of them.
        machinery_and_outfit_estimate: what Watson would expect of the rest of the light ship; None where no source
            has the type.
    """

    items: tuple[Distribution, ...]
    steel_weight_t: float
    steel_estimate: watson.Estimate
    steel_given: bool
    beyond_steel_t: float
    beyond_steel_given: bool
    machinery_and_outfit_estimate: watson.Estimate | None


def light_ship(
    given: WeightsInput,
    hull: Hull,
    structure: Structure,
    particulars: Particulars,
    block_coefficient: float,
    displacement_t: float,
    houses: Sequence[Superstructure] = (),
) -> LightShip:
    """Spread the light ship over her length.

    Args:
        given: [weights] of ship.toml.
        hull, structure: of the same stations.
        particulars: of the ship.
        block_coefficient, displacement_t: at the design draught, as read.
        houses: of [structure], for the steel estimate.

    Raises:
        LoadingError: there is nothing to spread a weight over.
    """
    estimate = watson.steel_weight(particulars, block_coefficient, houses)
    steel_t = estimate.weight_t if given.steel_weight_t is None else given.steel_weight_t
    length = hull.length_overall_m
    steel = shaped(
        "steel", steel_t * KG_PER_T, structure.x_m, structure.steel_area_m2, lumps=structure.transverse_steel_m3
    )
    expected = watson.machinery_and_outfit(particulars, displacement_t)
    beyond_t = given.beyond_steel_t
    classes = (
        _given_classes(given, length) if beyond_t is not None or expected is None else _estimated(expected, length)
    )
    if beyond_t is None:
        beyond_t = 0.0 if expected is None else expected.together.weight_t
    return LightShip(
        items=(
            steel,
            *classes,
            *(item_along(item, hull, structure, particulars.draught_m) for item in given.items),
        ),
        steel_weight_t=steel_t,
        steel_estimate=estimate,
        steel_given=given.steel_weight_t is not None,
        beyond_steel_t=beyond_t,
        beyond_steel_given=given.beyond_steel_t is not None,
        machinery_and_outfit_estimate=None if expected is None else expected.together,
    )


def _given_classes(given: WeightsInput, length_m: float) -> tuple[Distribution, ...]:
    semi_kg = (given.semi_concentrated_weight_t or 0.0) * KG_PER_T
    aft, fore = given.machinery_share * semi_kg, (1 - given.machinery_share) * semi_kg
    return (
        uniform("machinery", aft, MACHINERY[0] * length_m, MACHINERY[1] * length_m),
        uniform("deck machinery", fore, DECK_MACHINERY[0] * length_m, DECK_MACHINERY[1] * length_m),
    )


def _estimated(expected: watson.MachineryAndOutfit, length_m: float) -> tuple[Distribution, ...]:
    machinery, outfit = expected.machinery_t * KG_PER_T, expected.outfit_t * KG_PER_T
    return (
        uniform("machinery", machinery, MACHINERY[0] * length_m, MACHINERY[1] * length_m),
        uniform("outfit", outfit, 0.0, length_m),
    )


def condition_items(
    condition: ConditionInput, light: LightShip, hull: Hull, structure: Structure, draught_m: float
) -> tuple[Distribution, ...]:
    """Every weight of a condition: the light ship's items, the deadweight and the condition's own items.

    Raises:
        LoadingError: there is no sectional area to spread the deadweight over, or an item lies off the hull.
    """
    listed = (item_along(item, hull, structure, draught_m) for item in condition.items)
    if condition.deadweight_t == 0:
        return (*light.items, *listed)
    length = hull.length_overall_m
    deadweight = shaped(
        "deadweight",
        condition.deadweight_t * KG_PER_T,
        hull.x_m,
        hull.sectional_areas(draught_m),
        DEADWEIGHT[0] * length,
        DEADWEIGHT[1] * length,
    )
    return (*light.items, deadweight, *listed)
