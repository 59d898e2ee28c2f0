"""The outline of a drawn station: its contours closed to the centre line, corners, and how far two curves lie apart."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Station

Array = NDArray[np.float64]

# Arc over which a corner's two sides are looked at, and between two corners at least, as a share of the breadth.
_SIDE = 0.02
# A curve that turns by more within it has a corner; a bilge of a radius above a twentieth of the breadth has none.
_SHARPEST_TURN = np.radians(28.0)
_DISTANCE_SAMPLES = 240
# Of a contour's extent: a point that lies nearer to the one before repeats it.
_REPEATED = 1e-7
# Of a contour's own breadth: what is nearer to the centre line is on it.
_PEN = 2e-3


def contours_of(station: Station) -> tuple[Array, ...]:
    """The contours (k, 2) [half-breadth, height] of a station, the lowest first, each closed to the centre line.

    A contour that does not begin at the centre line is closed level to it, and so is every one but the uppermost where
    it ends. Points that repeat are left out.
    """
    drawn = sorted((curve.points for curve in station.curves), key=lambda points: float(points[:, 1].min()))
    closed = []
    for number, points in enumerate(drawn):
        held = _from_its_lowest(np.maximum(points, [0.0, -np.inf]))
        parts = [held]
        if held[0, 0] > 0:
            parts.insert(0, np.array([[0.0, held[0, 1]]]))
        if number < len(drawn) - 1 and held[-1, 0] > 0:
            parts.append(np.array([[0.0, held[-1, 1]]]))
        whole = np.concatenate(parts)
        moves = np.append(True, np.hypot(*np.diff(whole, axis=0).T) > _REPEATED * np.ptp(whole, axis=0).max())
        closed.append(whole[moves])
    return tuple(closed)


def _from_its_lowest(points: Array) -> Array:
    """A contour without what it does at the centre line before it has gone down to where it begins."""
    near = points[:, 0] <= _PEN * points[:, 0].max()
    away = len(points) if near.all() else int(np.argmin(near))
    return points[int(np.argmin(points[:away, 1])) if away else 0 :]


def arc_along(points: Array) -> Array:
    """(k,) length along a polyline (k, 2) up to each of its points."""
    return np.append(0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T)))


def at_arc(points: Array, arc: Array, wanted: Array) -> Array:
    """Points of a polyline at given lengths along it."""
    return np.stack([np.interp(wanted, arc, points[:, 0]), np.interp(wanted, arc, points[:, 1])], axis=-1)


def resampled(points: Array, count: int) -> Array:
    """Points (count, 2) even along the polyline."""
    arc = arc_along(points)
    return at_arc(points, arc, np.linspace(0.0, arc[-1], count))


def area_below(points: Array, height_m: float) -> float:
    """Area in m2, both sides, below a height: 2 Int y dz along the curve."""
    y, z = points.T
    below = np.minimum(z, height_m)
    rise = np.diff(z)
    slope = np.divide(np.diff(y), rise, out=np.zeros_like(rise), where=rise != 0)
    start, end = y[:-1] + slope * (below[:-1] - z[:-1]), y[:-1] + slope * (below[1:] - z[:-1])
    return float((start + end) @ np.diff(below))


def largest_distance(one: Array, other: Array) -> float:
    """Hausdorff distance in m of two polylines: the farthest that any place of either lies from the other."""
    return max(_farthest(one, other), _farthest(other, one))


def _farthest(of: Array, line: Array) -> float:
    """Largest distance of the points and of even places of a polyline from another."""
    y, z = resampled(of, _DISTANCE_SAMPLES).T[..., None]
    (y_start, z_start), (y_run, z_run) = line[:-1].T, np.diff(line, axis=0).T
    square = np.maximum(y_run**2 + z_run**2, 1e-300)
    along = np.clip(((y - y_start) * y_run + (z - z_start) * z_run) / square, 0.0, 1.0)
    apart = (y - y_start - along * y_run) ** 2 + (z - z_start - along * z_run) ** 2
    return float(np.sqrt(apart.min(axis=1).max()))


def corners_of(points: Array, breadth_m: float) -> NDArray[np.int64]:
    """Numbers of the points of a polyline (k, 2) at which it has a corner: a knuckle, a chine, a sharp bilge.

    A corner is where the chords over 2 % of the breadth before and after a point enclose more than 28 degrees, more
    than anywhere else so near.
    """
    arc = arc_along(points)
    side = _SIDE * breadth_m
    if len(points) < 3 or arc[-1] < 2 * side:
        return np.empty(0, dtype=np.int64)
    before = points - at_arc(points, arc, arc - side)
    after = at_arc(points, arc, arc + side) - points
    turn = np.abs(np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(-1)))
    turn[(arc < 0.5 * side) | (arc > arc[-1] - 0.5 * side)] = 0.0
    found: list[int] = []
    for number in np.argsort(-turn):
        if turn[number] < _SHARPEST_TURN:
            break
        if all(abs(arc[number] - arc[other]) >= side for other in found):
            found.append(int(number))
    return np.array(sorted(found), dtype=np.int64)
