"""The items of a weight list as curves along the ship."""

from __future__ import annotations

import numpy as np

from hullform.hull.loft import Hull
from hullform.loading.distributions import Distribution, shaped, uniform
from hullform.loading.structure import Structure
from hullform.ship_weights import WeightItem

KG_PER_T = 1000.0


def item_along(item: WeightItem, hull: Hull, structure: Structure, draught_m: float) -> Distribution:
    """Spread an item as its shape says.

    Args:
        item: as ship.toml has it.
        hull, structure: of the same stations.
        draught_m: below which the sectional area counts.

    Raises:
        LoadingError: the ship has no girth or no sectional area where the item lies.
    """
    mass = item.mass_t * KG_PER_T
    first, last = item.span_m(hull.length_overall_m)
    if item.shape == "girth":
        return shaped(item.name, mass, structure.x_m, structure.girth_m, first, last)
    if item.shape == "sectional-area":
        return shaped(item.name, mass, hull.x_m, hull.sectional_areas(draught_m), first, last)
    if item.shape == "table":
        return shaped(item.name, mass, np.array(item.x_m), np.array(item.mass_per_m))
    if item.shape == "trapezoid" and item.centre_m is not None:
        # m = M / l (1 -+ 6 e / l) at the two ends, e the lever of the centre from the middle
        lean = 6 * (item.centre_m - (first + last) / 2) / (last - first)
        ends = mass / (last - first) * np.array([1 - lean, 1 + lean])
        return Distribution(item.name, np.array([first, last]), ends[:1], ends[1:])
    return uniform(item.name, mass, first, last)
