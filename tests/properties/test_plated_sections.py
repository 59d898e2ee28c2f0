"""What holds for any members in any hull: added steel takes no stiffness away, and all scales as it should."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from hullform.errors import LoadingError
from hullform.hull import Hull
from hullform.loading.structure import FLOOR, Structure, structure_of
from hullform.ship_structure import StructureInput

BREADTH, DEPTH, LENGTH = 20.0, 12.0, 120.0


def hull(p: float, q: float, scale: float = 1.0) -> Hull:
    """Sharp ends with V sections below exponents of one, fuller amidships, sheer forward."""
    x = np.linspace(0.0, LENGTH, 13)
    shape = 1 - 0.9995 * np.abs(2 * x / LENGTH - 1) ** 3
    top = DEPTH + 2 * (x / LENGTH) ** 2
    lengths = (x, BREADTH / 2 * shape, top * shape, top)
    return Hull.of_super_ellipses(
        *(scale * values for values in lengths), 0.4 + (p - 0.4) * shape, 0.5 + (q - 0.5) * shape,
        scale * LENGTH, scale * LENGTH, 0.0, scale * BREADTH, scale * DEPTH, scale * 8.0,
    )  # fmt: skip


exponents = st.tuples(st.floats(0.7, 12.0), st.floats(0.8, 12.0))
places = st.floats(0.0, LENGTH)
MEMBERS: dict[str, st.SearchStrategy[Any]] = {
    "inner_bottom": st.fixed_dictionaries({"height_m": st.floats(0.3, 4.0)}),
    "double_side": st.fixed_dictionaries({"breadth_m": st.floats(0.1, 6.0)}),
    "decks": st.lists(
        st.fixed_dictionaries({"height_m": st.floats(2.0, 11.5), "outboard_of_m": st.floats(0.0, 5.0)}), max_size=2
    ),
    "longitudinal_bulkheads": st.lists(
        st.fixed_dictionaries(
            {"y_m": st.floats(0.0, 6.0)}, optional={"head_m": st.floats(6.0, 11.0), "from_m": places}
        ),
        max_size=3,
    ),
    "superstructures": st.lists(
        st.fixed_dictionaries({"height_m": st.floats(1.0, 9.0), "breadth_m": st.floats(2.0, 30.0)}), max_size=1
    ),
}
A_ZONE = [{"part": "deck", "thickness_m": 0.016}]


def structure(ship: Hull, **keys: Any) -> Structure:
    return structure_of(ship, StructureInput.model_validate({"zones": A_ZONE, **keys}))


@settings(max_examples=20, deadline=None)
@given(exponents, st.fixed_dictionaries({}, optional=MEMBERS))
def test_members_add_stiffness_and_nothing_is_not_a_number(pq: tuple[float, float], members: dict[str, Any]) -> None:
    ship = hull(*pq)
    shell = structure(ship)
    try:
        with_members = structure(ship, **members)
    except LoadingError:
        # nowhere within the hull
        reject()
    for name in ("area_m2", "second_moment_m4", "horizontal_second_moment_m4", "torsion_constant_m4", "steel_area_m2"):
        found = getattr(with_members, name)
        assert np.isfinite(found).all()
        # where a member begins between two stations of the shell the section is a new one
        own = np.isin(with_members.x_m, shell.x_m)
        least = np.interp(with_members.x_m[own], shell.x_m, getattr(shell, name))
        # round-off of flows that are tied to the ground by 1e-13, through slivers some 1e4 times as stiff as a plate
        assert (found[own] >= least * (1 - 1e-6)).all()
    assert (with_members.shear_area_m2 > 0).all()
    # shear flows through no more than all the steel that stands upright
    assert (with_members.shear_area_m2 <= with_members.area_m2 + FLOOR * with_members.area_m2.max()).all()


@settings(max_examples=10, deadline=None)
@given(exponents, st.floats(1.1, 4.0))
def test_a_ship_twice_as_large_has_sixteen_times_the_second_moment(pq: tuple[float, float], scale: float) -> None:
    def keys(size: float) -> dict[str, Any]:
        t = 0.016 * size
        return {
            "shell_thickness_m": t,
            "zones": [{"part": "deck", "thickness_m": 1.2 * t}],
            "inner_bottom": {"height_m": 1.5 * size},
            "longitudinal_bulkheads": [{"y_m": 0.0}],
        }

    small, large = structure(hull(*pq), **keys(1.0)), structure(hull(*pq, scale), **keys(scale))
    for name, power in (("area_m2", 2), ("second_moment_m4", 4), ("shear_area_m2", 2), ("torsion_constant_m4", 4)):
        # the least breadth of a member is a length, so a sliver may be there in one ship and not in the other
        np.testing.assert_allclose(
            getattr(large, name), scale**power * getattr(small, name), rtol=2e-3, atol=1e-4 * getattr(large, name).max()
        )
