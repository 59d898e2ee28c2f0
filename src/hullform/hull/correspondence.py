"""Which place of one section is which of the next: the common parameter of all sections of a hull.

Keel and deck answer to keel and deck, a neck (where the contour is narrowest between a bulb and the body above it, or
the stretch of centre line between two contours) to the neck of the next section or, where it has none, to the same
height on it; a corner answers to the corner near it that turns the same way. Between these, places answer to one
another that are near in place and in direction (`alignment`): the bottom to the bottom, the turn of the bilge to the
turn of the bilge, whatever their lengths, and a knuckle to the bend that it fades into. Every such map from a section
to its neighbour increases strictly: maps can be chained and turned round.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.hull.alignment import Stretch, aligned
from hullform.hull.outlines import arc_along, at_arc, corners_of

Array = NDArray[np.float64]

# Of the breadth: by how much a contour comes in to a neck, and goes out again; how far a corner may be from the
# next section's; what is on the centre line.
_NECK = 0.01
_CORNER_REACH = 0.25
_SIDE = 0.02  # of the breadth: how far on either side of a corner it is told which way the section turns
_ON_CENTRE = 1e-6
# Parameters nearer than this, of the whole, are pushed apart so far, that maps increase.
_APART = 1e-9
_SAME = 1e-6  # of the whole: landmarks of different sections that come so near are one
_DENSE = 240  # places a section at which the need for points is asked
_TURNING_SHARE = 0.6  # of the need for points that follows the turning of the curve, beside its length


@dataclass(frozen=True, eq=False)
class _Landmarks:
    """A section (k, 2), lengths along it, its neck (from, to) if it has one, its corners, as lengths, and which way the
    section turns there, 1 or -1."""

    points: Array
    arc: Array
    neck: tuple[float, float] | None
    corners: Array
    turns: Array

    def height(self, arc: float) -> float:
        return float(np.interp(arc, self.arc, self.points[:, 1]))

    def arc_at_height(self, height: float, start: float = 0.0) -> float:
        """Where the section first comes up to a height, from a place on."""
        after = self.arc > start
        z = np.append(self.height(start), self.points[after, 1])
        arc = np.append(start, self.arc[after])
        if height <= z[0]:
            return start
        (above,) = np.nonzero(z >= height)
        if not len(above):
            return float(self.arc[-1])
        n = int(above[0])
        share = (height - z[n - 1]) / (z[n] - z[n - 1])
        return float(arc[n - 1] + share * (arc[n] - arc[n - 1]))

    def widest_below_neck(self) -> float:
        """Where the part below the neck is widest."""
        assert self.neck is not None
        below = self.arc <= self.neck[0]
        return float(self.arc[below][np.argmax(self.points[below, 0])])


def matched_points(sections: Sequence[Array], count: int, breadth_m: float) -> Array:
    """Points (sections, m, 2) of outlines (k, 2), keel to deck: point j of each answers to point j of its neighbours.

    Corners of every section are among them; the others, up to `count`, stand close where any section is long or turns.
    """
    marked = [_landmarks(points, breadth_m) for points in sections]
    common = _Common([land.arc[-1] for land in marked], _maps(marked, breadth_m))
    wanted = _parameters(marked, common, count)
    return np.stack([at_arc(land.points, land.arc, common.to_section(n, wanted)) for n, land in enumerate(marked)])


@dataclass(frozen=True, eq=False)
class _Common:
    """The common parameter: the length along the middle section; lengths along all others through chained maps."""

    lengths: list[float]
    maps: list[tuple[Array, Array]]

    @property
    def middle(self) -> int:
        return int(np.argmax(self.lengths))

    def to_section(self, number: int, parameter: Array) -> Array:
        """Lengths along a section at common parameters."""
        arc = parameter
        for n in range(self.middle, number):
            arc = np.interp(arc, *self.maps[n])
        for n in range(self.middle - 1, number - 1, -1):
            arc = np.interp(arc, *self.maps[n][::-1])
        return arc

    def from_section(self, number: int, arc: Array) -> Array:
        """Common parameters at lengths along a section."""
        for n in range(number, self.middle):
            arc = np.interp(arc, *self.maps[n])
        for n in range(number - 1, self.middle - 1, -1):
            arc = np.interp(arc, *self.maps[n][::-1])
        return arc


def _landmarks(points: Array, breadth_m: float) -> _Landmarks:
    arc = arc_along(points)
    if arc[-1] <= 0:
        arc = np.linspace(0.0, _APART, len(points))
    corners = arc[corners_of(points, breadth_m)]
    before, here, after = (at_arc(points, arc, corners + side * _SIDE * breadth_m) for side in (-1, 0, 1))
    (y1, z1), (y2, z2) = (here - before).T, (after - here).T
    return _Landmarks(points, arc, _neck(points, arc, breadth_m), corners, np.sign(y1 * z2 - z1 * y2))


def _neck(points: Array, arc: Array, breadth_m: float) -> tuple[float, float] | None:
    """Where along the section it has its neck, from and to; the narrowest one, if more."""
    y = points[:, 0]
    out_before = np.maximum.accumulate(y)
    out_after = np.maximum.accumulate(y[::-1])[::-1]
    depth = np.minimum(out_before, out_after) - y
    if depth.max() < _NECK * breadth_m:
        return None
    # the lowest place of the deepest dent, and all of it that is as low
    lowest = y[depth >= 0.999 * depth.max()].min()
    (there,) = np.nonzero((y <= lowest + _ON_CENTRE * breadth_m) & (depth > 0))
    return float(arc[there[0]]), float(arc[there[-1]])


def _maps(marked: Sequence[_Landmarks], breadth_m: float) -> list[tuple[Array, Array]]:
    """Maps from lengths along each section to lengths along the next, as knots of polylines; both increase."""
    tied = [_tied(one, other, breadth_m) for one, other in itertools.pairwise(marked)]
    stretches = [
        (Stretch(one.points, one.arc, start[0], end[0]), Stretch(other.points, other.arc, start[1], end[1]))
        for (one, other), pairs in zip(itertools.pairwise(marked), tied, strict=True)
        for start, end in itertools.pairwise(pairs)
    ]
    parts = iter(aligned(stretches, breadth_m)) if stretches else iter(())
    maps = []
    for pairs in tied:
        knots = [next(parts) for _ in pairs[1:]]
        first, second = (np.concatenate([knots[0][n], *(part[n][1:] for part in knots[1:])]) for n in (0, 1))
        maps.append((first, second))
    return maps


def _tied(one: _Landmarks, other: _Landmarks, breadth_m: float) -> list[tuple[float, float]]:
    """Lengths along a section and along the next that answer to one another as landmarks, keel and deck among them."""
    pairs = [(0.0, 0.0), *_neck_pairs(one, other), (float(one.arc[-1]), float(other.arc[-1]))]
    pairs = _increasing(pairs, one, other)
    for pair in _corner_pairs(one, other, breadth_m):
        tried = sorted([*pairs, pair])
        # a corner that would cross what is tied already, or stands on it, is not tied
        if all(b[0] > a[0] and b[1] > a[1] for a, b in itertools.pairwise(tried)):
            pairs = tried
    return pairs


def _neck_pairs(one: _Landmarks, other: _Landmarks) -> list[tuple[float, float]]:
    if one.neck is None and other.neck is None:
        return []
    if one.neck is not None and other.neck is not None:
        wide_one, wide_other = one.neck[1] > one.neck[0], other.neck[1] > other.neck[0]
        if wide_one == wide_other:
            return list(dict.fromkeys(zip(one.neck, other.neck, strict=True)))
        if wide_one:
            start = other.widest_below_neck()
            return [(arc, other.arc_at_height(one.height(arc), start)) for arc in one.neck]
        return [(arc, along) for along, arc in _neck_pairs(other, one)]
    if other.neck is None:
        assert one.neck is not None
        return list(dict.fromkeys((arc, other.arc_at_height(one.height(arc))) for arc in one.neck))
    return [(arc, along) for along, arc in _neck_pairs(other, one)]


def _increasing(pairs: list[tuple[float, float]], one: _Landmarks, other: _Landmarks) -> list[tuple[float, float]]:
    """The same pairs, pushed apart where they stand on one place, so that every map can be turned round."""
    columns = []
    for values, whole in zip(zip(*pairs, strict=True), (one.arc[-1], other.arc[-1]), strict=True):
        least = _APART * whole
        steps = np.arange(len(values)) * least
        up = np.maximum.accumulate(np.array(values) - steps) + steps
        room = whole - steps[::-1]
        columns.append(np.minimum(up, room).tolist())
    return list(zip(*columns, strict=True))


def _corner_pairs(one: _Landmarks, other: _Landmarks, breadth_m: float) -> list[tuple[float, float]]:
    """Corners that turn the same way and are each other's nearest, and near, the nearest first."""
    if not len(one.corners) or not len(other.corners):
        return []
    here, there = at_arc(one.points, one.arc, one.corners), at_arc(other.points, other.arc, other.corners)
    apart = np.linalg.norm(here[:, None] - there, axis=-1)
    apart[one.turns[:, None] != other.turns] = np.inf
    mutual = [
        (float(apart[i, j]), float(one.corners[i]), float(other.corners[j]))
        for i in range(len(here))
        for j in [int(apart[i].argmin())]
        if apart[:, j].argmin() == i and apart[i, j] <= _CORNER_REACH * breadth_m
    ]
    return [(a, b) for _, a, b in sorted(mutual)]


def _parameters(marked: list[_Landmarks], common: _Common, count: int) -> Array:
    """Common parameters of the points that all sections get: landmarks, and others where any section needs them."""
    whole = common.lengths[common.middle]
    corners = [common.from_section(n, land.corners) for n, land in enumerate(marked)]
    necks = [common.from_section(n, np.array(land.neck)) for n, land in enumerate(marked) if land.neck is not None]
    kept = _once(np.concatenate([[0.0, whole], *corners, *necks]), _SAME * whole)
    own = [common.from_section(n, np.linspace(0.0, land.arc[-1], _DENSE)) for n, land in enumerate(marked)]
    dense = np.unique(np.concatenate([*own, kept]))
    needs = [np.diff(_need(land, common.to_section(n, dense))) for n, land in enumerate(marked)]
    along = np.append(0.0, np.cumsum(np.max(needs, axis=0)))
    steps = along[-1] / (count - 1)
    at_kept = np.interp(kept, dense, along)
    # each stretch between two landmarks is divided evenly
    parts = np.maximum(np.round(np.diff(at_kept) / steps).astype(int), 1)
    stretches = [np.linspace(a, b, n, endpoint=False) for a, b, n in zip(at_kept[:-1], at_kept[1:], parts, strict=True)]
    inner = np.interp(np.concatenate(stretches), along, dense)
    firsts = np.cumsum(np.append(0, parts[:-1]))
    inner[firsts] = kept[:-1]
    return np.append(inner, whole)


def _need(land: _Landmarks, arc: Array) -> Array:
    """How many points a section needs up to lengths along it, by its length and its turning, of one in all."""
    even = np.linspace(0.0, land.arc[-1], _DENSE)
    step = np.diff(at_arc(land.points, land.arc, even), axis=0)
    turn = np.abs(np.arctan2(step[:-1, 0] * step[1:, 1] - step[:-1, 1] * step[1:, 0], (step[:-1] * step[1:]).sum(-1)))
    turning = np.append(0.0, np.cumsum(np.append(turn / 2, 0.0) + np.append(0.0, turn / 2)))
    by_turning = turning / turning[-1] if turning[-1] > 0 else even / even[-1]
    need = (1 - _TURNING_SHARE) * even / even[-1] + _TURNING_SHARE * by_turning
    return np.asarray(np.interp(arc, even, need))


def _once(values: Array, apart: float) -> Array:
    """Sorted values, one of every group that lies together."""
    ordered = np.sort(values)
    return np.asarray(ordered[np.append(True, np.diff(ordered) > apart)])
