"""Plates that cross, touch or hang in the air."""

from __future__ import annotations

import numpy as np

from hullform.loading.arrangement import parted, tied


def line(*points: tuple[float, float]) -> np.ndarray:
    return np.array(points)


def pieces(lines: list[np.ndarray], number: int) -> list[list[list[float]]]:
    return [branch.points.tolist() for branch in parted(lines) if branch.of == number]


def test_two_straight_plates_that_cross_share_a_joint() -> None:
    branches = parted([line((0, 1), (4, 1)), line((3, 0), (3, 5))])
    assert len(branches) == 4
    (meeting,) = set.intersection(*(set(branch.joints) for branch in branches))
    for branch in branches:
        assert branch.points[branch.joints.index(meeting)].tolist() == [3.0, 1.0]


def test_a_plate_that_ends_on_a_bent_one_parts_it_and_leaves_its_corners() -> None:
    bent = line((0, 0), (2, 0), (4, 2), (4, 6))
    assert pieces([bent, line((0, 4), (4, 4))], 0) == [
        [[0, 0], [2, 0], [4, 2], [4, 4]],
        [[4, 4], [4, 6]],
    ]


def test_plates_that_meet_end_to_end_are_one_chain() -> None:
    first, second = parted([line((0, 0), (1, 0)), line((1, 0.0002), (1, 3))])
    assert first.joints[1] == second.joints[0]


def test_parallel_plates_and_those_that_stop_short_do_not_meet() -> None:
    branches = parted([line((0, 0), (5, 0)), line((0, 1), (5, 1)), line((2, 0.2), (2, 0.9))])
    assert len(branches) == 3
    assert len({joint for branch in branches for joint in branch.joints}) == 6


def test_what_hangs_on_nothing_is_left_out() -> None:
    lines = [line((0, 0), (5, 0)), line((5, 0), (5, 5)), line((1, 2), (2, 2)), line((2, 2), (2, 4))]
    assert {branch.of for branch in tied(parted(lines), {0})} == {0, 1}


def test_a_plate_without_length_is_no_branch() -> None:
    assert parted([line((1, 1), (1, 1))]) == []
