"""Which places of two curves answer to one another: those near in place and in direction."""

import numpy as np
import pytest

from hullform.hull.alignment import Stretch, aligned
from hullform.hull.outlines import arc_along, at_arc

BREADTH = 10.0
# directions are taken along chords of 2 % of the breadth, and places lie 2 % of it apart
NEAR = 0.04 * BREADTH


def whole(points: np.ndarray) -> Stretch:
    arc = arc_along(points)
    return Stretch(points, arc, 0.0, float(arc[-1]))


def bilge(flat: float, radius: float, side: float) -> np.ndarray:
    turn = np.linspace(0.0, np.pi / 2, 60)
    arc = np.stack([flat + radius * np.sin(turn), radius * (1 - np.cos(turn))], -1)
    return np.concatenate([[[0.0, 0.0]], arc, [[flat + radius, side]]])


def answer(one: np.ndarray, other: np.ndarray, at: float) -> np.ndarray:
    """Where the place at a length along one lies on the other."""
    ((first, second),) = aligned([(whole(one), whole(other))], BREADTH)
    there = np.interp(at, first, second)
    return at_arc(other, arc_along(other), np.array([there]))[0]


def test_the_edge_of_a_flat_answers_to_the_edge_of_a_much_shorter_one() -> None:
    one, other = bilge(7.0, 1.0, 8.0), bilge(2.0, 1.0, 8.0)
    for at in (7.0, 7.0 + np.pi / 2):  # where the bilge begins and ends
        turned = (at - 7.0) / (np.pi / 2)
        expected = [2.0 + turned, turned]
        assert np.linalg.norm(answer(one, other, at) - expected) < NEAR


def test_a_knuckle_answers_to_the_middle_of_the_bilge_that_it_fades_into() -> None:
    sharp = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 8.0]])
    middle = np.array([6.0 + np.sqrt(0.5), 1 - np.sqrt(0.5)])
    assert np.linalg.norm(answer(sharp, bilge(6.0, 1.0, 8.0), 4.0) - middle) < NEAR
    # and the bilge to places about the knuckle; where it begins and ends its direction no longer tells
    for at in 6.0 + np.pi / 2 * np.linspace(0.1, 0.9, 9):
        assert np.linalg.norm(answer(bilge(6.0, 1.0, 8.0), sharp, at) - [4.0, 0.0]) < NEAR


def test_a_curve_answers_to_itself_and_to_itself_grown() -> None:
    one = bilge(5.0, 2.0, 8.0)
    ((first, second),) = aligned([(whole(one), whole(one))], BREADTH)
    np.testing.assert_allclose(second, first, atol=1e-12)
    ((first, second),) = aligned([(whole(one), whole(1.3 * one))], BREADTH)
    np.testing.assert_allclose(second, 1.3 * first, atol=NEAR / 2)


@pytest.mark.parametrize("other", [bilge(1.0, 0.2, 3.0), np.array([[0.0, 5.0], [0.0, 5.0 + 1e-8]])])
def test_maps_increase_strictly_from_start_to_end(other: np.ndarray) -> None:
    one = bilge(7.0, 1.0, 8.0)
    ((first, second),) = aligned([(whole(one), whole(other))], BREADTH)
    assert (np.diff(first) > 0).all()
    assert (np.diff(second) > 0).all()
    assert (first[0], first[-1]) == (0.0, arc_along(one)[-1])
    assert (second[0], second[-1]) == (0.0, arc_along(other)[-1])


def test_only_the_stretch_is_matched() -> None:
    one, other = bilge(7.0, 1.0, 8.0), bilge(2.0, 1.0, 8.0)
    ((first, second),) = aligned(
        [(whole(one)._replace(start=3.0, end=9.0), whole(other)._replace(start=1.0, end=6.0))], BREADTH
    )
    assert (first[0], first[-1], second[0], second[-1]) == (3.0, 9.0, 1.0, 6.0)
