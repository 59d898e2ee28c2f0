"""Where plates meet: polylines that cross or touch, parted at their joints."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# Plates that come this near to each other are welded. Members are placed to the centimetre; round-off is far below.
TOUCHING_M = 1e-3


@dataclass(frozen=True, eq=False)
class Branch:
    """A piece of a polyline between two joints.

    Attributes:
        of: number of the polyline.
        points: (k, 2) y and z in m.
        joints: numbers of the joints at its ends.
    """

    of: int
    points: Array
    joints: tuple[int, int]


def parted(polylines: list[Array]) -> list[Branch]:
    """Part polylines (k, 2) where they cross or touch one another.

    Straight ones of two points may cross each other; any may end on any other. Bent ones are not looked at for
    crossings in their course: let what meets them end on them.
    """
    straight = np.array([line for line in polylines if len(line) == 2]).reshape(-1, 2, 2)
    ends = np.array([line[[0, -1]] for line in polylines]).reshape(-1, 2)
    places = _distinct(np.concatenate([ends, _crossings(straight)]))
    branches = []
    for number, line in enumerate(polylines):
        along = _along(line)
        found = sorted((at, joint) for joint, at in _touching(line, along, places))
        for (start, first), (end, last) in itertools.pairwise(found):
            inner = line[(along > start + TOUCHING_M) & (along < end - TOUCHING_M)]
            branches.append(Branch(number, np.concatenate([places[[first]], inner, places[[last]]]), (first, last)))
    return branches


def tied(branches: list[Branch], to: set[int]) -> list[Branch]:
    """Those branches that hang together with any branch of the polylines numbered in `to`."""
    held = {joint for branch in branches if branch.of in to for joint in branch.joints}
    before = -1
    while len(held) > before:
        before = len(held)
        held |= {joint for branch in branches if held.intersection(branch.joints) for joint in branch.joints}
    return [branch for branch in branches if held.intersection(branch.joints)]


def _along(line: Array) -> Array:
    steps = np.hypot(*np.diff(line, axis=0).T)
    return np.concatenate([[0.0], np.cumsum(steps)])


def _distinct(places: Array) -> Array:
    """One of every group of places that touch."""
    near = np.hypot(*(places[:, None] - places[None]).transpose(2, 0, 1)) <= TOUCHING_M
    return np.asarray(places[near.argmax(axis=1) == np.arange(len(places))])


def _crossings(lines: Array) -> Array:
    """(k, 2) points where straight lines (n, 2, 2) cross within both."""
    start, run = lines[:, 0], lines[:, 1] - lines[:, 0]
    one, other = np.triu_indices(len(lines), 1)
    turn = run[one, 0] * run[other, 1] - run[one, 1] * run[other, 0]
    apart = start[other] - start[one]
    crossing = np.abs(turn) > 1e-9 * np.hypot(*run[one].T) * np.hypot(*run[other].T)
    one, other, turn, apart = one[crossing], other[crossing], turn[crossing], apart[crossing]
    at_one = (apart[:, 0] * run[other, 1] - apart[:, 1] * run[other, 0]) / turn
    at_other = (apart[:, 0] * run[one, 1] - apart[:, 1] * run[one, 0]) / turn
    within = (at_one >= 0) & (at_one <= 1) & (at_other >= 0) & (at_other <= 1)
    return np.asarray((start[one] + at_one[:, None] * run[one])[within])


def _touching(line: Array, along: Array, places: Array) -> list[tuple[int, float]]:
    """Numbers of the places that lie on a line, each with where along it in m; both ends of the line among them."""
    start, run = line[:-1], np.diff(line, axis=0)
    square = np.maximum((run**2).sum(-1), TOUCHING_M**2 * 1e-6)
    share = np.clip(((places[:, None] - start) * run).sum(-1) / square, 0.0, 1.0)
    foot = start + share[..., None] * run
    distance = np.hypot(*(places[:, None] - foot).transpose(2, 0, 1))
    nearest = distance.argmin(axis=1)
    rows = np.arange(len(places))
    at = along[nearest] + share[rows, nearest] * np.hypot(*run[nearest].T)
    return [(int(j), float(at[j])) for j in rows[distance[rows, nearest] <= TOUCHING_M]]
