"""Cubics along the ship through matched points: exact on parabolas, without overshoot, in order."""

import numpy as np
import pytest

from hullform.hull.fair_sections import fair_sections

X = np.array([0.0, 3.0, 7.0, 8.0, 12.0])
FINE = np.linspace(0.0, 12.0, 241)


def test_parabolas_that_rise_all_the_way_come_back() -> None:
    def section(x: np.ndarray) -> np.ndarray:
        return np.stack([np.stack([(x + 20 + j) ** 2 / 40 + j, 3 * x + x**2 / 10 + 2 * j], -1) for j in range(5)], 1)

    np.testing.assert_allclose(fair_sections(X, section(X))(FINE), section(FINE), rtol=1e-12)


def test_nothing_leaves_the_range_of_the_two_sections_beside_it() -> None:
    points = np.random.default_rng(5).uniform(-1, 1, (5, 40, 2)).cumsum(axis=0)
    found = fair_sections(X, points)
    for n in range(4):
        between = found(np.linspace(X[n], X[n + 1], 50))
        assert (between >= np.minimum(points[n], points[n + 1]) - 1e-12).all()
        assert (between <= np.maximum(points[n], points[n + 1]) + 1e-12).all()


@pytest.mark.parametrize("seed", range(20))
def test_what_goes_outwards_and_upwards_on_all_sections_does_so_between(seed: int) -> None:
    # distances of points from a thousandth to a thousand: crowds of points on one section, wide apart on the next
    random = np.random.default_rng(seed)
    points = np.cumsum(10 ** random.uniform(-3, 3, (5, 30, 2)), axis=1)
    points[:, 0] += random.uniform(-50, 50, (5, 2)).cumsum(axis=0)
    points[:, 1:] += points[:, :1]
    assert (np.diff(points, axis=1) > 0).all()
    between = fair_sections(X, points)(FINE)
    assert np.diff(between, axis=1).min() > -1e-9


def test_two_sections_are_joined_by_straight_lines() -> None:
    points = np.array([[[0.0, 0.0], [1.0, 2.0]], [[2.0, 1.0], [3.0, 6.0]]])
    np.testing.assert_allclose(fair_sections(np.array([1.0, 3.0]), points)(2.0), points.mean(axis=0), rtol=1e-14)
