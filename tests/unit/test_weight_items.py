"""Items of a weight list along the ship: mass and centre are kept, whatever the shape."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from box_barge import LENGTH_M, box_barge

from hullform.errors import LoadingError
from hullform.hull import Hull
from hullform.loading.items import item_along
from hullform.loading.structure import structure_of
from hullform.ship_structure import StructureInput
from hullform.ship_weights import WeightItem


def along(hull: Hull, **keys: Any) -> Any:
    item = WeightItem(name="item", mass_t=250.0, **keys)
    item.require_within(hull.length_overall_m)
    return item_along(item, hull, structure_of(hull, StructureInput()), 4.0)


def wedge() -> Hull:
    """A box whose breadth grows evenly from nothing at the aft end."""
    x = np.linspace(0.0, LENGTH_M, 41)
    one = np.ones(41)
    return Hull.of_super_ellipses(
        x, 6 * x / LENGTH_M, 8 * one, 8 * one, 1e5 * one, 1e5 * one, LENGTH_M, LENGTH_M, 0.0, 12.0, 8.0, 4.0
    )


@pytest.mark.parametrize(
    ("keys", "centre"),
    [
        ({"shape": "uniform"}, 40.0),
        ({"shape": "uniform", "from_m": 10.0, "to_m": 22.0}, 16.0),
        ({"shape": "trapezoid", "from_m": 10.0, "to_m": 22.0, "centre_m": 17.3}, 17.3),
        ({"shape": "trapezoid", "from_m": 10.0, "to_m": 22.0, "centre_m": 14.0}, 14.0),
        # all sections of the barge are one
        ({"shape": "girth", "from_m": 21.0, "to_m": 63.0}, 42.0),
        ({"shape": "sectional-area", "from_m": 21.0, "to_m": 63.0}, 42.0),
        # 20 x 3 at 10 and 10 x 1 at 25, over a sum of 70
        ({"shape": "table", "x_m": (0.0, 20.0, 20.0, 30.0), "mass_per_m": (3.0, 3.0, 1.0, 1.0)}, 850 / 70),
    ],
)
def test_mass_and_centre_are_kept(keys: dict[str, Any], centre: float) -> None:
    found = along(box_barge(), **keys)
    assert found.mass_kg == pytest.approx(250e3, rel=1e-12)
    # the girth of an all but square corner is summed from points, alike at every station
    assert found.centre_m == pytest.approx(centre, rel=1e-9)


def test_a_trapezoid_at_its_limit_is_a_triangle() -> None:
    found = along(box_barge(), shape="trapezoid", from_m=10.0, to_m=22.0, centre_m=18.0)
    assert found.left_kg_per_m[0] == pytest.approx(0.0, abs=1e-9)
    assert found.right_kg_per_m[0] == pytest.approx(2 * 250e3 / 12.0)


def test_sectional_area_leads_a_weight_to_where_the_hull_is_broad() -> None:
    found = along(wedge(), shape="sectional-area", from_m=20.0, to_m=80.0)
    assert found.centre_m == pytest.approx(2 / 3 * (80**3 - 20**3) / (80**2 - 20**2), rel=1e-6)


def test_girth_spreads_more_evenly_than_area() -> None:
    by_girth, by_area = (along(wedge(), shape=shape, from_m=0.0, to_m=80.0) for shape in ("girth", "sectional-area"))
    assert 40.0 < by_girth.centre_m < by_area.centre_m


def test_an_item_where_the_hull_has_no_section_is_refused() -> None:
    x = np.linspace(0.0, LENGTH_M, 41)
    keel = np.where(x < 20.0, 6.0, 0.0)
    one = np.ones(41)
    counter = Hull.of_super_ellipses(x, 6 * one, 8 - keel, 8 * one, 1e4 * one, 1e4 * one, 80, 80, 0, 12.0, 8.0, 4.0)
    with pytest.raises(LoadingError, match=r"item: nothing to spread 250 t over between x = 2 and 17 m"):
        along(counter, shape="sectional-area", from_m=2.0, to_m=17.0)
