"""Curves that touch and part again: which lower part belongs to which upper one.

Where the necks of domes and bulbs run through one place, every pairing of upper and lower parts is a smooth curve, and
the ink alone does not tell which is drawn. The ship does: along her the half-breadths below the touch are as fair as
those above it. So the lower parts of two curves are exchanged where that makes her much fairer, or where a person's
mark says so, and are in doubt where neither way is much fairer.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from hullform.picture.naming.fair_lines import LARGEST_UNFAIRNESS, MUCH_FAIRER, beside_fair_lines, unfairness
from hullform.picture.naming.marks import APART, PlacedMark

Array = NDArray[np.float64]

TOUCHING = 1.5  # of a line's thickness between the axes: ink without paper between
APART_BESIDE = 0.04  # of B/2: parts that lie nearer to each other all along may change places at little loss
LEVELS = 12  # between the lowest point of the parts and the touch
LEAST_GAIN_BELOW = 0.002  # of B/2, mean below the touch: less is the noise of tracing, on few stations and levels
FEWEST_STATIONS = 5
NEIGHBOURS = 2  # to either side of which the fairness depends on a station
STRETCH = 0.03  # of B/2: that shows where a curve heads
LARGEST_BEND = np.radians(20.0)  # where a lower part goes on from an upper one: lines that bend more cross


@dataclass(frozen=True)
class Fork:
    """A place where two curves touch: the curves, the index of the point of each, and [y, z] in px."""

    first: int
    second: int
    at_first: int
    at_second: int
    place: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Branches:
    """Curves with each lower part where it belongs.

    Attributes:
        curves: (n, 2) [y, z] of each, px, keel to deck.
        exchanged: forks whose lower parts were exchanged.
        unsure: forks of which neither way is much fairer.
    """

    curves: tuple[Array, ...]
    exchanged: tuple[Fork, ...]
    unsure: tuple[Fork, ...]


def find_forks(curves: Sequence[Array], line_px: float, half_breadth_px: float) -> list[Fork]:
    """Places where two curves touch that part above and below.

    Args:
        curves: (n, 2) [y, z] of each, px, keel to deck.
        line_px: thickness of a line.
        half_breadth_px: B/2.
    """
    trees = [cKDTree(curve) for curve in curves]
    apart = APART_BESIDE * half_breadth_px
    forks = []
    for first, second in combinations(range(len(curves)), 2):
        beside, nearest = (np.asarray(found) for found in trees[second].query(curves[first]))
        back = np.asarray(trees[first].query(curves[second])[0])
        touching = np.concatenate([[False], beside < TOUCHING * line_px, [False]]).astype(np.int8)
        starts, stops = np.flatnonzero(np.diff(touching) == 1), np.flatnonzero(np.diff(touching) == -1)
        for start, stop in zip(starts, stops, strict=True):
            middle = int(start + np.argmin(beside[start:stop]))
            other = int(nearest[middle])
            parts = (beside[:middle], beside[middle:], back[:other], back[other:])
            if not all(part.size and part.max() > apart for part in parts):
                continue
            (y, z), stretch = (float(value) for value in curves[first][middle]), STRETCH * half_breadth_px
            below, above = zip(
                *(_headings(curve, at, stretch) for curve, at in ((curves[first], middle), (curves[second], other))),
                strict=True,
            )
            kept = max(_bend(below[0], above[0]), _bend(below[1], above[1]))
            if max(_bend(below[1], above[0]), _bend(below[0], above[1])) < max(LARGEST_BEND, kept):
                forks.append(Fork(first, second, middle, other, (y, z)))
    return forks


def rejoin(
    curves: Sequence[Array],
    positions_m: Mapping[int, float],
    line_px: float,
    half_breadth_px: float,
    marks: Sequence[tuple[int, PlacedMark]] = (),
    settled: Callable[[Fork], bool] = lambda _: False,
) -> Branches:
    """Exchange lower parts of curves that touch, where the ship is much fairer so or a mark says so.

    Args:
        curves: (n, 2) [y, z] of each, px, keel to deck, from the centre line outwards.
        positions_m: x of the station of each curve that has one.
        line_px: thickness of a line.
        half_breadth_px: B/2.
        marks: of a half, and the curve that the station of each got.
        settled: forks that stay as they are.
    """
    out = list(curves)
    exchanged: list[Fork] = []
    while True:
        forks = [
            fork
            for fork in find_forks(out, line_px, half_breadth_px)
            if {fork.first, fork.second} <= set(positions_m) and not settled(fork)
        ]
        worth = [_worth(out, fork, positions_m, half_breadth_px, marks) for fork in forks]
        fairer = [k for k in range(len(forks)) if _much_fairer(*worth[k])]
        best = min(fairer, key=lambda k: worth[k][0] / max(worth[k][1], LEAST_GAIN_BELOW), default=None)
        if best is None or len(exchanged) == len(curves):
            unsure = [fork for fork, (other, kept) in zip(forks, worth, strict=True) if not _much_fairer(kept, other)]
            return Branches(tuple(out), tuple(exchanged), tuple(unsure))
        fork = forks[best]
        out[fork.first], out[fork.second] = _exchange(out, fork)
        exchanged.append(fork)


def _much_fairer(one: float, other: float) -> bool:
    return one < MUCH_FAIRER * other and other - one > LEAST_GAIN_BELOW


def _headings(curve: Array, at: int, stretch_px: float) -> tuple[float, float]:
    """Angles at which a curve comes to a point from below and leaves it upwards."""
    away = np.hypot(*(curve - curve[at]).T)
    before, after = np.flatnonzero(away[:at] >= stretch_px), np.flatnonzero(away[at:] >= stretch_px)
    first, last = (int(before[-1]) if before.size else 0), (at + int(after[0]) if after.size else len(curve) - 1)
    (y0, z0), (y1, z1) = curve[at] - curve[first], curve[last] - curve[at]
    return float(np.arctan2(z0, y0)), float(np.arctan2(z1, y1))


def _bend(below: float, above: float) -> float:
    return abs((above - below + np.pi) % (2 * np.pi) - np.pi)


def below_fork(curves: Sequence[Array], forks: Sequence[Fork], mark: PlacedMark) -> bool:
    """Whether a mark lies on the lower part of a curve that touches another higher up."""
    nearest = min(range(len(curves)), key=lambda number: _distance(curves[number], mark), default=-1)
    if nearest < 0:
        return False
    at = int(np.argmin(np.hypot(*(curves[nearest] - (mark.y_px, mark.z_px)).T)))
    tops = [f.at_first for f in forks if f.first == nearest] + [f.at_second for f in forks if f.second == nearest]
    return any(at < top for top in tops)


def _exchange(curves: Sequence[Array], fork: Fork) -> tuple[Array, Array]:
    a, b, i, j = curves[fork.first], curves[fork.second], fork.at_first, fork.at_second
    return np.concatenate([b[:j], a[i:]]), np.concatenate([a[:i], b[j:]])


def _worth(
    curves: Sequence[Array],
    fork: Fork,
    positions_m: Mapping[int, float],
    size: float,
    marks: Sequence[tuple[int, PlacedMark]],
) -> tuple[float, float]:
    """Unfairness below a touch with the lower parts exchanged, and as they are; a mark counts as a knuckle.

    Without enough stations nothing is known of it, and both are 0.
    """
    order = sorted(positions_m, key=lambda number: positions_m[number])
    x = np.array([positions_m[number] for number in order])
    low = min(
        float(curves[fork.first][: fork.at_first, 1].min()), float(curves[fork.second][: fork.at_second, 1].min())
    )
    levels = low + (fork.place[1] - low) * (np.arange(LEVELS) + 0.5) / LEVELS
    places = [order.index(fork.first), order.index(fork.second)]
    around = slice(max(0, min(places) - NEIGHBOURS - 1), max(places) + NEIGHBOURS)
    own: dict[int, Array] = {}
    both = dict(zip((fork.first, fork.second), _exchange(curves, fork), strict=True))
    total = []
    for changed in (both, own):
        y = np.array([_widest(changed.get(number, curves[number]), levels) for number in order]) / size
        beside = beside_fair_lines(x, y)[around] if len(x) >= FEWEST_STATIONS else np.zeros(0)
        total.append(unfairness(beside))
        for number, mark in marks:
            if number in both:
                there, elsewhere = (_distance(changed.get(n, curves[n]), mark) for n in (number, *({*both} - {number})))
                total[-1] += LARGEST_UNFAIRNESS * bool(there > elsewhere + APART * size)
    return total[0], total[1]


def _distance(curve: Array, mark: PlacedMark) -> float:
    return float(np.hypot(*(curve - (mark.y_px, mark.z_px)).T).min())


def _widest(curve: Array, levels: Array) -> Array:
    """Largest half-breadth of a curve at each level, NaN below and above it: where a waterline ends it has a kink."""
    (y0, z0), (y1, z1) = curve[:-1].T, curve[1:].T
    share = (levels[:, None] - z0) / np.where(z1 == z0, 1.0, z1 - z0)
    crossed = (share >= 0) & (share <= 1) & (z1 != z0)
    widest = np.where(crossed, y0 + share * (y1 - y0), -1.0).max(axis=1)
    return np.asarray(np.where(widest < 0, np.nan, widest))
