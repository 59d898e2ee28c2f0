"""The weights of a loading condition along the ship: the paper's three classes, and the items of a weight list.

Steel follows the section of the longitudinal steel, which is the girth of a shell of one thickness (end plates and
transverse bulkheads at their place), machinery lies over 0 .. 0.2 LOA, deck machinery
over 0.9 .. 1.0 LOA, deadweight over 0.2 .. 0.9 LOA in step with the sectional area below the design draught.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.hull.loft import Hull
from hullform.loading import watson
from hullform.loading.distributions import Distribution, shaped, uniform
from hullform.loading.items import KG_PER_T, item_along
from hullform.loading.structure import Structure
from hullform.ship import Particulars
from hullform.ship_weights import ConditionInput, WeightsInput

Array = NDArray[np.float64]

MACHINERY = (0.0, 0.2)  # fractions of LOA, the paper's section 2.2
DECK_MACHINERY = (0.9, 1.0)
DEADWEIGHT = (0.2, 0.9)


@dataclass(frozen=True, eq=False)
class LightShip:
    """Steel and semi-concentrated weights, the same in every condition.

    Attributes:
        items: steel, machinery, deck machinery, and those of the light ship's list.
        steel_weight_t: as given, or estimated.
        steel_estimate: Watson & Gilfillan's figure and range for this ship.
        steel_given: whether ship.toml gave the steel weight.
        machinery_and_outfit_estimate: what Watson would expect of the rest of the light ship; None where no source
            has the type.
    """

    items: tuple[Distribution, ...]
    steel_weight_t: float
    steel_estimate: watson.Estimate
    steel_given: bool
    machinery_and_outfit_estimate: watson.Estimate | None


def light_ship(
    given: WeightsInput,
    hull: Hull,
    structure: Structure,
    particulars: Particulars,
    block_coefficient: float,
    displacement_t: float,
) -> LightShip:
    """Spread the light ship over her length.

    Args:
        given: [weights] of ship.toml.
        hull, structure: of the same stations.
        particulars: of the ship.
        block_coefficient, displacement_t: at the design draught, as read.

    Raises:
        LoadingError: there is nothing to spread a weight over.
    """
    estimate = watson.steel_weight(particulars, block_coefficient)
    steel_t = estimate.weight_t if given.steel_weight_t is None else given.steel_weight_t
    length = hull.length_overall_m
    semi_kg = given.semi_concentrated_weight_t * KG_PER_T
    steel = shaped(
        "steel", steel_t * KG_PER_T, structure.x_m, structure.steel_area_m2, lumps=structure.transverse_steel_m3
    )
    machinery = uniform("machinery", given.machinery_share * semi_kg, MACHINERY[0] * length, MACHINERY[1] * length)
    deck_machinery = uniform(
        "deck machinery",
        (1 - given.machinery_share) * semi_kg,
        DECK_MACHINERY[0] * length,
        DECK_MACHINERY[1] * length,
    )
    return LightShip(
        items=(
            steel,
            machinery,
            deck_machinery,
            *(item_along(item, hull, structure, particulars.draught_m) for item in given.items),
        ),
        steel_weight_t=steel_t,
        steel_estimate=estimate,
        steel_given=given.steel_weight_t is not None,
        machinery_and_outfit_estimate=watson.machinery_and_outfit_weight(particulars, displacement_t),
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
