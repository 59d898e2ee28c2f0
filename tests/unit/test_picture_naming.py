"""Curves and names of a hull whose half-breadths are known: nothing that is missing or too many may shift a name."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from hullform.picture.naming.alignment import NO_CURVE, assign_stations, half_breadths_at, mark_distances

Array = NDArray[np.float64]
# spacings as on a body plan: close at the end, wide towards amidships; the last three lie in the parallel body
X = np.array([0.0, 5.0, 10.0, 15.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0])
DISTINCT = 8
TOP = 300.0


def hull(x: Array) -> list[Array]:
    """V-shaped sections that fill towards x = 50 and stay so; B/2 = 200 px."""
    z = np.linspace(0.0, TOP, 60)
    fullness = np.sin(np.minimum(x, 50.0) / 50.0 * np.pi / 2)
    return [np.column_stack([200.0 * (0.05 + 0.95 * f) * (z / TOP) ** (1.1 - 0.9 * f), z]) for f in fullness]


def names_of(curves: list[Array], certainty: list[float] | None = None, marks: Array | None = None) -> list[int]:
    return assign_stations(X, half_breadths_at(curves, 200.0), certainty or [1.0] * len(curves), marks)


def test_one_curve_for_each_name_and_the_outermost_for_the_parallel_body() -> None:
    assert names_of(hull(X[:DISTINCT])) == [0, 1, 2, 3, 4, 5, 6, 7, 7, 7]


# next to the parallel body a lost curve looks like one station more in it
@pytest.mark.parametrize("lost", [1, 2, 3, 4])
def test_a_curve_that_was_not_found_leaves_the_other_names_right(lost: int) -> None:
    curves = hull(X[:DISTINCT])
    del curves[lost]
    whole = [0, 1, 2, 3, 4, 5, 6, 7, 7, 7]
    expected = [NO_CURVE if n == lost else n - (n > lost) for n in whole]
    assert names_of(curves) == expected


@pytest.mark.parametrize("place", [0, 2, 4, 6])
def test_a_piece_that_is_no_station_gets_no_name(place: int) -> None:
    curves = hull(X[:DISTINCT])
    inner = curves[place][:14]
    piece = np.column_stack([inner[:, 0] + 6.0, inner[:, 1]])
    curves.insert(place + 1, piece)
    certainty = [0.3 if n == place + 1 else 1.0 for n in range(len(curves))]
    expected = [n + (n > place) for n in [0, 1, 2, 3, 4, 5, 6, 7, 7, 7]]
    assert names_of(curves, certainty) == expected


def test_a_mark_decides_where_fairness_cannot() -> None:
    # three curves for four names of one spacing: any name may be the one that shares
    curves = [np.array([[y, 0.0], [y, TOP]]) for y in (100.0, 150.0, 200.0)]
    x = np.array([0.0, 10.0, 20.0, 30.0])
    rows = half_breadths_at(curves, 200.0)
    marks = mark_distances(curves, [(1, 101.0, 0.0), (2, 152.0, 0.0)], 4)
    assert marks is not None
    assert assign_stations(x, rows, [1.0] * 3, marks)[1:] == [0, 1, 2]
    assert mark_distances(curves, [], 4) is None


def test_a_mark_within_a_hand_s_error_of_two_curves_overrides_nothing() -> None:
    curves = hull(X[:DISTINCT])
    marks = np.full((len(X), DISTINCT), np.nan)
    marks[3] = [60.0, 40.0, 3.0, 1.5, 30.0, 50.0, 70.0, 90.0]
    assert names_of(curves, None, marks) == [0, 1, 2, 3, 4, 5, 6, 7, 7, 7]


def test_one_name_gets_the_curve_of_its_mark() -> None:
    curves = hull(X[:3])
    marks = mark_distances(curves, [(0, float(curves[1][30, 0]), float(curves[1][30, 1]))], 1)
    assert assign_stations([X[1]], half_breadths_at(curves, 200.0), [0.1] * 3, marks) == [1]


def test_half_breadths_of_a_curve_that_starts_high_and_of_one_that_hangs_in_the_air() -> None:
    high = np.array([[0.0, 150.0], [100.0, TOP]])
    piece = np.array([[80.0, 120.0], [90.0, 180.0]])
    rows = half_breadths_at([high, piece], 200.0)
    assert rows[0][0] == 0.0
    assert rows[0][-1] == pytest.approx(100.0 / 200.0 * (0.95 * TOP - 150.0) / 150.0)
    assert np.isnan(rows[1][0])
    assert np.isnan(rows[1][-1])
    assert rows[1][3] == pytest.approx(85.0 / 200.0)
