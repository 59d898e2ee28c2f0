"""Which places of a stretch of one section answer to which of the next: those near in place and in direction.

A map from one curve to another is sought under which points and their tangents differ the least, in all (Sederberg and
Greenwood, "A physically based approach to 2-D shape blending", SIGGRAPH 1992), by dynamic programming with a bound on
how unevenly it may run (Sakoe and Chiba, IEEE Trans. ASSP 26, 1978). The edge of a flat bottom answers to the edge of
the next, and the turn of a bilge to the knuckle that it becomes, however long the bottoms and the sides are.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hullform.hull.outlines import at_arc

Array = NDArray[np.float64]

_PLACES = 81  # of a stretch
# Of the breadth: half the chord along which the direction of the curve is taken; a corner turns within it.
_CHORD = 0.01
_FINE = 400  # places at which length and turning are summed
# Of the breadth: the length that counts as much as a turn of one radian where places are spread over a stretch.
_LENGTH_OF_A_TURN = 0.25
# A difference of direction d costs this much times 1 - cos d, a distance its square in breadths: 90 degrees 0.7 B. The
# stretches lie one on the other, grown or shrunk to their mean extent across and upward.
_COST_OF_DIRECTION = 0.5
# Of each step in which the curves go on by unequal a and b places, times (a - b)^2 / (a + b): enough that a map between
# curves much alike has no need of it.
_COST_OF_UNEVENNESS = 0.003
# While one curve goes on by a place the other goes on by so many at the most.
_MOST_UNEVEN = 4
_SMOOTHED = 4  # places on either side over which the map is averaged, twice
_NO_EXTENT = 1e-3  # of the breadth: a stretch that is as thin is not grown to the width of the other
_NO_LENGTH = 1e-6  # of the breadth: a stretch so short has no directions

# (one, other): places by which both curves go on in a step; going on evenly comes first, and wins a tie
_STEPS = [(1, 1), *((1, k) for k in range(2, _MOST_UNEVEN + 1)), *((k, 1) for k in range(2, _MOST_UNEVEN + 1))]


class Stretch(NamedTuple):
    """A part of a section's polyline (k, 2) with lengths (k,) along it, from one length to another."""

    points: Array
    arc: Array
    start: float
    end: float


class _Places(NamedTuple):
    """Even places along a stretch by length and turning: lengths, points and directions in rad."""

    arc: Array
    points: Array
    direction: Array
    has_length: bool


def aligned(pairs: Sequence[tuple[Stretch, Stretch]], breadth_m: float) -> list[tuple[Array, Array]]:
    """Of each pair of stretches the knots of the map from lengths along one to lengths along the other.

    Both increase strictly, from the starts to the ends. Where a stretch has no length the other is divided evenly.
    """
    places = [(_places(one, breadth_m), _places(other, breadth_m)) for one, other in pairs]
    costs = np.stack([_cost(one, other, breadth_m) for one, other in places])
    maps = []
    for (one, other), path in zip(places, _cheapest_paths(costs), strict=True):
        first, second = _smooth_map(path)
        number = np.arange(_PLACES)
        maps.append((np.interp(first, number, one.arc), np.interp(second, number, other.arc)))
    return maps


def _places(stretch: Stretch, breadth_m: float) -> _Places:
    """Places spread by length and by turning, so that a corner has as many of them as the bilge it answers to."""
    points, arc, start, end = stretch
    fine = np.union1d(np.linspace(start, end, _FINE), arc[(arc > start) & (arc < end)])
    has_length = end - start > _NO_LENGTH * breadth_m
    chord = at_arc(points, arc, np.minimum(fine + _CHORD * breadth_m, end)) - at_arc(
        points, arc, np.maximum(fine - _CHORD * breadth_m, start)
    )
    direction = np.unwrap(np.arctan2(chord[:, 1], chord[:, 0])) if has_length else np.zeros(len(fine))
    steps = np.diff(fine) / breadth_m + _LENGTH_OF_A_TURN * np.abs(np.diff(direction))
    along = np.append(0.0, np.cumsum(steps))
    even = np.linspace(0.0, along[-1], _PLACES)
    at = np.interp(even, along, fine)
    at[[0, -1]] = start, end
    return _Places(at, at_arc(points, arc, at), np.interp(even, along, direction), has_length)


def _cost(one: _Places, other: _Places, breadth_m: float) -> Array:
    """What it costs that a place of one stretch answers to a place of the other: (places, places)."""
    if not (one.has_length and other.has_length):
        return np.zeros((_PLACES, _PLACES))
    low = [places.points.min(axis=0) for places in (one, other)]
    extent = [np.maximum(np.ptp(places.points, axis=0), _NO_EXTENT * breadth_m) for places in (one, other)]
    first, second = ((p.points - low[n]) / extent[n] for n, p in enumerate((one, other)))
    mean = (extent[0] + extent[1]) / (2 * breadth_m)
    apart = (((first[:, None] - second) * mean) ** 2).sum(axis=-1)
    return np.asarray(apart + _COST_OF_DIRECTION * (1 - np.cos(one.direction[:, None] - other.direction)))


def _cheapest_paths(costs: Array) -> list[NDArray[np.int64]]:
    """Of each table of costs (tables, places, places) the cheapest way (steps, 2) from its first corner to its last."""
    tables, count, _ = costs.shape
    spent = np.full(costs.shape, np.inf)
    spent[:, 0, 0] = 0.0
    step_to = np.zeros(costs.shape, dtype=np.int64)
    for row in range(1, count):
        tried = np.full((len(_STEPS), tables, count), np.inf)
        for number, (one, other) in enumerate(_STEPS):
            if one <= row:
                uneven = _COST_OF_UNEVENNESS * (one - other) ** 2 / (one + other)
                mean = (costs[:, row - one, :-other] + costs[:, row, other:]) / 2
                tried[number, :, other:] = spent[:, row - one, :-other] + mean * (one + other) / 2 + uneven
        step_to[:, row] = tried.argmin(axis=0)
        spent[:, row] = tried.min(axis=0)
    return [_way_back(steps) for steps in step_to]


def _way_back(step_to: NDArray[np.int64]) -> NDArray[np.int64]:
    here = len(step_to) - 1, len(step_to) - 1
    way = [here]
    while here != (0, 0):
        one, other = _STEPS[step_to[here]]
        here = here[0] - one, here[1] - other
        way.append(here)
    return np.array(way[::-1])


def _smooth_map(path: NDArray[np.int64]) -> tuple[Array, Array]:
    """The numbers of places that answer to one another, fractions among them, without the steps of the table.

    Averaged is by how much one curve is ahead of the other, against the mean of both. It never changes as fast as that
    mean does, and averages of it do not either: both curves go on all the time.
    """
    last = _PLACES - 1
    mean = np.linspace(0.0, last, 2 * last + 1)
    ahead = np.interp(mean, path.sum(axis=1) / 2, (path[:, 0] - path[:, 1]) / 2)
    for _ in range(2):
        before, after = -ahead[_SMOOTHED:0:-1], -ahead[-2 : -_SMOOTHED - 2 : -1]
        window = np.full(2 * _SMOOTHED + 1, 1 / (2 * _SMOOTHED + 1))
        ahead = np.convolve(np.concatenate([before, ahead, after]), window, "valid")
    ahead[[0, -1]] = 0.0
    return mean + ahead, mean - ahead
