"""Triangles over polygons: they fill them, and no two overlap."""

import numpy as np
import pytest

from hullform.hull.ears import clipped_ears


def areas(points: np.ndarray, faces: np.ndarray) -> np.ndarray:
    a, b, c = points[faces].transpose(1, 0, 2)
    return ((b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])) / 2


def enclosed(points: np.ndarray) -> float:
    x, y = points.T
    return float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) / 2)


COMB = [[0, 0], [7, 0], [7, 5], [6, 5], [6, 1], [5, 1], [5, 5], [4, 5], [4, 1], [1, 1], [1, 5], [0, 5]]
POLYGONS = {
    "a triangle": [[0, 0], [2, 0], [1, 3]],
    "a square with points along its sides": [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]],
    "a comb": COMB,
    "a bulb below a flare": [[0, 0], [2, 0.2], [2.5, 2], [0.3, 4], [0.2, 5], [4, 8], [0, 8]],
    "a point that stands twice": [[0, 0], [2, 0], [2, 0], [2, 2], [0, 2]],
}


@pytest.mark.parametrize("name", POLYGONS)
def test_triangles_fill_the_polygon_and_none_is_turned_over(name: str) -> None:
    points = np.array(POLYGONS[name], dtype=float)
    faces = clipped_ears(points)
    assert faces.shape == (len(points) - 2, 3)
    found = areas(points, faces)
    # turned over or overlapping triangles would make the sum of the sizes larger than the polygon
    assert found.min() >= -1e-12
    assert found.sum() == pytest.approx(enclosed(points), rel=1e-12)


def test_random_polygons_that_are_far_from_star_shaped() -> None:
    rng = np.random.default_rng(3)
    for _ in range(20):
        z = np.sort(rng.uniform(0, 10, 40))
        section = np.stack([rng.uniform(0.05, 5, 40), z], -1)
        points = np.concatenate([[[0.0, 0.0]], section, [[0.0, 10.0]]])
        found = areas(points, clipped_ears(points))
        assert found.min() >= -1e-12
        assert found.sum() == pytest.approx(enclosed(points), rel=1e-12)
