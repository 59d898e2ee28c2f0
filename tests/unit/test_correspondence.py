"""Which place of one section is which of the next: keel, deck, corners and necks keep their number."""

import itertools

import numpy as np
import pytest

from hullform.hull.correspondence import matched_points
from hullform.hull.outlines import corners_of

BREADTH = 10.0


def polyline(*corners: tuple[float, float], points: int = 40) -> np.ndarray:
    nodes = np.array(corners, dtype=float)
    parts = [np.linspace(a, b, points, endpoint=False) for a, b in itertools.pairwise(nodes)]
    return np.concatenate([*parts, nodes[-1:]])


def bulb(neck_z: float, neck_y: float, keel: float = 0.0, deck: float = 4.0) -> np.ndarray:
    turn = np.linspace(0.0, np.pi, 60)
    low = np.stack([1.5 * np.sin(turn), keel + (neck_z - keel) * (1 - np.cos(turn)) / 2], -1)
    low[30:, 0] += neck_y * (turn[30:] - turn[30]) / (turn[-1] - turn[30])
    return np.concatenate([low, polyline((neck_y, neck_z), (deck, 9.0))[1:]])


def number_of(points: np.ndarray, at: np.ndarray) -> int:
    apart = np.linalg.norm(points - at, axis=1)
    assert apart.min() < 1e-5
    return int(apart.argmin())


def test_a_chine_is_one_line_along_the_ship() -> None:
    chines = [(4.0, 1.0), (3.6, 1.3), (3.2, 1.6), (2.9, 1.9)]
    found = matched_points([polyline((0, 0), chine, (4.5, 6)) for chine in chines], 61, BREADTH)
    assert len({number_of(points, np.array(chine)) for points, chine in zip(found, chines, strict=True)}) == 1


def test_a_chine_that_ends_stays_a_corner_where_it_is() -> None:
    round_one = np.stack(
        [4.5 * np.sin(np.linspace(0, np.pi / 2, 99)), 6 - 6 * np.cos(np.linspace(0, np.pi / 2, 99))], -1
    )
    found = matched_points([polyline((0, 0), (4.0, 1.0), (4.5, 6)), round_one], 61, BREADTH)
    number_of(found[0], np.array([4.0, 1.0]))


def test_keel_and_deck_come_first_and_last_and_nothing_goes_back() -> None:
    sections = [polyline((0, 0), (4, 0.2), (5, 6)), bulb(4.0, 0.4), bulb(4.2, 0.2), polyline((0, 5), (3, 9))]
    found = matched_points(sections, 81, BREADTH)
    for points, section in zip(found, sections, strict=True):
        np.testing.assert_allclose(points[[0, -1]], section[[0, -1]], atol=1e-12)
        # along each section the points go forward: the length through them is the section's, but for chords
        length, whole = (float(np.linalg.norm(np.diff(p, axis=0), axis=1).sum()) for p in (points, section))
        assert whole * 0.995 < length <= whole * (1 + 1e-9)


def test_a_neck_answers_to_the_next_neck_and_a_bulb_that_ends_shrinks_to_the_keel() -> None:
    sections = [bulb(4.0, 0.5), bulb(4.3, 0.2), polyline((0, 6.0), (3, 9))]
    found = matched_points(sections, 81, BREADTH)
    neck = number_of(found[0], np.array([0.5, 4.0]))
    assert number_of(found[1], np.array([0.2, 4.3])) == neck
    # the keel of the last lies above both necks: all of the bulb comes together there
    np.testing.assert_allclose(found[2][: neck + 1], np.broadcast_to([0, 6.0], (neck + 1, 2)), atol=1e-6)


def test_the_centre_line_between_two_contours_answers_to_the_same_heights() -> None:
    two = np.concatenate([bulb(4.0, 0.0)[:60], polyline((0, 4.0), (0, 5.5), (3, 9))[1:]])
    one = bulb(4.2, 0.3)
    found = matched_points([one, two], 81, BREADTH)
    foot, head = number_of(found[1], np.array([0.0, 4.0])), number_of(found[1], np.array([0.0, 5.5]))
    assert head > foot
    np.testing.assert_allclose(found[0][head, 1], 5.5, atol=1e-6)
    assert found[0][foot, 1] == pytest.approx(4.0, abs=1e-6)


def test_bottom_answers_to_bottom_and_bilge_to_bilge() -> None:
    wide, narrow = polyline((0, 0), (5, 0), (5, 6)), polyline((0, 0), (3, 0), (3, 6))
    rounded = np.concatenate(
        [[[0, 0]], [[4 + 0.9 * np.sin(t), 0.9 - 0.9 * np.cos(t)] for t in np.linspace(0, np.pi / 2, 30)], [[4.9, 6]]]
    )
    found = matched_points([wide, narrow, rounded], 61, BREADTH)
    corner = number_of(found[0], np.array([5.0, 0.0]))
    assert number_of(found[1], np.array([3.0, 0.0])) == corner
    # amid the turn: half of it lies either side, but for what the flat and the upright parts are longer
    assert np.linalg.norm(found[2][corner] - [4 + 0.9 * 0.7071, 0.9 * 0.2929]) < 0.15
    assert len(corners_of(rounded, BREADTH)) == 0


def test_the_two_knuckles_of_a_chine_strip_are_not_taken_for_one_another() -> None:
    # outwards, level, upwards: the inner knuckle of the second lies where the outer one of the first was
    strips = [((3.0, 2.0), (3.6, 2.0)), ((3.55, 2.2), (4.15, 2.2))]
    sections = [polyline((0, 0), inner, outer, (5, 6)) for inner, outer in strips]
    found = matched_points(sections, 121, BREADTH)
    for which in (0, 1):
        numbers = [number_of(points, np.array(strip[which])) for points, strip in zip(found, strips, strict=True)]
        assert numbers[0] == numbers[1]
