"""Curves that touch and part again: the lower parts go where the ship is fair, or where a mark says."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest
from numpy.typing import NDArray

from hullform.picture.naming.branches import below_fork, find_forks, rejoin
from hullform.picture.naming.marks import PlacedMark
from hullform.ship_body_plan import Mark

Array = NDArray[np.float64]
SIZE, LINE = 500.0, 3.0  # px: B/2, thickness of a line
NECK = (60.0, 50.0)  # [y, z] that all necks run through, upright
X = (100.0, 110.0, 120.0, 130.0, 140.0, 150.0)


def dome(number: int) -> Array:
    """Below the neck: a bulge that grows along the ship and ends lower and lower."""
    share = np.linspace(0.0, 1.0, 200)[:-1]
    bottom = -60.0 - 25.0 * number
    return np.column_stack(
        [NECK[0] + (30.0 + 40.0 * number) * np.sin(np.pi * share) ** 4, bottom + (NECK[1] - bottom) * share]
    )


def flare(number: int) -> Array:
    """Above the neck: upright there, outboard of one another at the deck."""
    share = np.linspace(0.0, 1.0, 200)
    return np.column_stack([NECK[0] + (150.0 + 40.0 * number) * share**2, NECK[1] + 400.0 * share])


def station(upper: int, lower: int) -> Array:
    # of the aft half, which shows its aftmost station innermost
    return np.concatenate([dome(lower), flare(upper)])


def positions() -> dict[int, float]:
    return dict(enumerate(X))


@pytest.mark.parametrize("order", [(0, 1, 3, 2, 4, 5), (1, 0, 2, 3, 4, 5), (0, 3, 2, 1, 4, 5)])
def test_exchanged_lower_parts_go_back_where_the_waterlines_are_fair(order: tuple[int, ...]) -> None:
    read = [station(upper, lower) for upper, lower in enumerate(order)]
    found = rejoin(read, positions(), LINE, SIZE)
    assert len(found.exchanged) > 0
    for number, curve in enumerate(found.curves):
        assert curve[:, 1].min() == pytest.approx(dome(number)[0, 1])
        assert curve[-1, 0] == pytest.approx(flare(number)[-1, 0])
    assert found.unsure == ()


def test_right_ones_stay_as_they_are() -> None:
    read = [station(number, number) for number in range(len(X))]
    found = rejoin(read, positions(), LINE, SIZE)
    assert found.exchanged == found.unsure == ()
    assert all(curve is before for curve, before in zip(found.curves, read, strict=True))


def test_two_stations_alone_cannot_be_told_apart_and_are_unsure() -> None:
    for order in permutations((0, 1)):
        read = [station(upper, lower) for upper, lower in enumerate(order)]
        found = rejoin(read, {0: X[0], 1: X[1]}, LINE, SIZE)
        assert found.exchanged == ()
        assert len(found.unsure) == 1


@pytest.mark.parametrize("marked", [0, 1])
def test_a_mark_below_the_touch_binds_the_lower_part(marked: int) -> None:
    read = [station(0, 1), station(1, 0)]
    place = dome(marked)[100]
    mark = PlacedMark(Mark(station_m=X[marked], half="aft", px=(0.0, 0.0)), marked, float(place[0]), float(place[1]))
    assert below_fork(read, find_forks(read, LINE, SIZE), mark)
    found = rejoin(read, {0: X[0], 1: X[1]}, LINE, SIZE, [(marked, mark)])
    assert [curve[:, 1].min() for curve in found.curves] == [dome(0)[0, 1], dome(1)[0, 1]]
    assert found.unsure == ()


def test_a_mark_above_the_touch_says_nothing_of_it() -> None:
    read = [station(0, 1), station(1, 0)]
    place = flare(0)[150]
    mark = PlacedMark(Mark(station_m=X[0], half="aft", px=(0.0, 0.0)), 0, float(place[0]), float(place[1]))
    assert not below_fork(read, find_forks(read, LINE, SIZE), mark)
    assert len(rejoin(read, {0: X[0], 1: X[1]}, LINE, SIZE, [(0, mark)]).unsure) == 1


def test_what_a_person_has_settled_stays() -> None:
    read = [station(upper, lower) for upper, lower in enumerate((0, 1, 3, 2, 4, 5))]
    found = rejoin(read, positions(), LINE, SIZE, settled=lambda fork: True)
    assert found.exchanged == found.unsure == ()


def test_lines_that_cross_at_an_angle_go_straight_on() -> None:
    share = np.linspace(0.0, 1.0, 200)
    one = np.column_stack([300.0 * share, 300.0 * share])
    other = np.column_stack([300.0 - 280.0 * share, 300.0 * share])
    assert find_forks([one, other], LINE, SIZE) == []
