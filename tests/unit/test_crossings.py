"""Triangles that go through one another are found; those that only touch are not."""

import numpy as np
import pytest

from hullform.hull.crossings import crossing_triangles, doubts_of_crossing

FLAT = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]


def soup(*triangles: list[list[float]]) -> tuple[np.ndarray, np.ndarray]:
    return np.array(triangles, dtype=float).reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)


def test_an_edge_through_the_other_is_a_crossing() -> None:
    piercing = [[0.4, 0.4, -1.0], [0.5, 0.5, 1.0], [3.0, 3.0, 1.0]]
    np.testing.assert_array_equal(crossing_triangles(*soup(FLAT, piercing)), [[0, 1]])
    # the smaller one may be pierced by the larger one as well
    np.testing.assert_array_equal(crossing_triangles(*soup(piercing, FLAT)), [[0, 1]])


@pytest.mark.parametrize(
    "other",
    [
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, -2.0, 1.0]],  # an edge in common, as other vertices
        [[0.4, 0.4, 0.0], [0.5, 0.5, 1.0], [1.0, 1.0, 1.0]],  # stands on it
        [[0.2, 0.2, 0.0], [0.6, 0.2, 0.0], [0.2, 0.6, 0.0]],  # lies on it
        [[0.2, 0.2, 1e-6], [0.6, 0.2, 1e-6], [0.2, 0.6, 1e-6]],  # just above it
        [[1.5, 1.5, -1.0], [1.6, 1.6, 1.0], [3.0, 3.0, 1.0]],  # passes it by, within its box
    ],
)
def test_what_touches_or_passes_is_none(other: list[list[float]]) -> None:
    assert len(crossing_triangles(*soup(FLAT, other))) == 0


def test_neighbours_are_not_asked() -> None:
    # they share vertex 0, and the second one's opposite edge goes through the first
    vertices = np.array([*FLAT, [1.0, 0.5, -1.0], [0.5, 1.0, 1.0]])
    assert len(crossing_triangles(vertices, np.array([[0, 1, 2], [0, 3, 4]]))) == 0
    moved = np.array([*FLAT, [1.0, 0.5, -1.0], [0.5, 1.0, 1.0], [0.01, 0.01, 0.5]])
    assert len(crossing_triangles(moved, np.array([[0, 1, 2], [5, 3, 4]]))) == 1


def meet(one: np.ndarray, other: np.ndarray) -> bool:
    """By solving for the place of every edge in the other's plane: another method than signed distances."""
    for edges, through in ((one, other), (other, one)):
        a, b, c = through
        for p, q in zip(edges, np.roll(edges, -1, axis=0), strict=True):
            matrix = np.stack([q - p, a - b, a - c], axis=-1)
            if abs(np.linalg.det(matrix)) < 1e-12:
                continue
            share, u, v = np.linalg.solve(matrix, a - p)
            if 0 < share < 1 and u > 0 and v > 0 and u + v < 1:
                return True
    return False


def test_random_triangles_of_all_sizes_against_every_pair() -> None:
    rng = np.random.default_rng(11)
    centre, size = rng.uniform(0, 10, (150, 1, 3)), rng.lognormal(0.0, 0.8, (150, 1, 1))
    triangles = centre + size * rng.normal(size=(150, 3, 3))
    found = {tuple(pair) for pair in crossing_triangles(triangles.reshape(-1, 3), np.arange(450).reshape(-1, 3))}
    expected = {(i, j) for i in range(150) for j in range(i + 1, 150) if meet(triangles[i], triangles[j])}
    assert len(expected) > 50
    assert found == expected


def test_the_doubt_says_where() -> None:
    piercing = [[0.4, 0.4, -1.0], [0.5, 0.5, 1.0], [3.0, 3.0, 1.0]]
    (doubt,) = doubts_of_crossing(*soup(FLAT, piercing))
    assert "between x = 0.00 and 3.00 m (1 pairs of triangles)" in doubt
    assert doubts_of_crossing(*soup(FLAT)) == ()
