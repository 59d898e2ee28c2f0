"""How far what was read lies from what was drawn.

A station is found where some traced station lies on its curve: RMS distance at most 1.2 % of B/2, at least 90 % of the
true curve within 3 % of the traced one, at least 95 % of the traced one within 3 % of a true one. It is right where the
station of the same x and half does. What lies in the centre line's own ink, less than half a line from its axis, nobody
can see: that part of a true curve need not be traced.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from generator.pictures import DrawnPicture, DrawnStation
from generator.sections import Array, evenly
from hullform.body_plan import Station

_NEAR = 0.03  # of B/2
_COVERED, _KEPT_TO = 0.90, 0.95  # shares of the true curve and of the traced one
_RMS_PERCENT = 1.2
_POINTS = 200  # of a curve
_SAME_X_M = 2e-3


@dataclass(frozen=True)
class StationScore:
    """How one drawn station was read; RMS in % of B/2, area to the draught in % of the largest; None if not right."""

    name: str
    half: str
    found: bool
    right: bool
    rms_percent: float | None
    area_percent: float | None


def score_stations(picture: DrawnPicture, traced: Sequence[Station]) -> list[StationScore]:
    """Compare every drawn station with what was traced (nothing, where the reader refused the picture)."""
    main = picture.plan.dimensions
    half_breadth, draught = main.breadth_m / 2, main.draught_m
    largest = max(area_below(list(s.curves_m), draught) for s in picture.stations)
    scores = []
    for drawn in picture.stations:
        mine = [s for s in traced if s.half == drawn.half and abs(s.x_m - drawn.x_m) < _SAME_X_M]
        hidden = picture.line_px / 2 / picture.scale.px_per_m
        fits = {id(s): _fit(drawn, s, half_breadth, hidden) for s in traced if s.half == drawn.half}
        rms, right = fits[id(mine[0])] if mine else (None, False)
        area = None
        if right:
            read = area_below([c.points for c in mine[0].curves], draught)
            area = 100 * abs(read - area_below(list(drawn.curves_m), draught)) / largest
        found = any(good for _, good in fits.values())
        scores.append(StationScore(drawn.name, drawn.half, found, right, rms if right else None, area))
    return scores


def _fit(drawn: DrawnStation, traced: Station, half_breadth_m: float, hidden_m: float) -> tuple[float, bool]:
    """RMS distance in % of B/2 over the points that are near, and whether the curves are the same."""
    truth = [evenly(curve, _POINTS) for curve in drawn.curves_m]
    read = [evenly(curve.points, _POINTS) for curve in traced.curves]
    points = np.vstack(truth)
    there = distances(points[points[:, 0] > hidden_m], read) / half_breadth_m
    back = distances(np.vstack(read), truth) / half_breadth_m
    near = there < _NEAR
    rms = 100 * float(np.sqrt(np.mean(there[near] ** 2))) if near.any() else 99.0
    return rms, bool(near.mean() >= _COVERED and (back < _NEAR).mean() >= _KEPT_TO and rms <= _RMS_PERCENT)


def distances(points: Array, lines: Iterable[Array]) -> Array:
    """Return the distance of points (n, 2) to the nearest of several polylines."""
    return np.asarray(np.min([_to_polyline(points, line) for line in lines], axis=0))


def _to_polyline(points: Array, line: Array) -> Array:
    start, step = line[:-1], np.diff(line, axis=0)
    length = np.maximum((step**2).sum(axis=1), 1e-18)
    share = np.clip(((points[:, None] - start) * step).sum(axis=2) / length, 0.0, 1.0)
    return np.sqrt(((start + share[..., None] * step - points[:, None]) ** 2).sum(axis=2).min(axis=1))


def area_below(curves: Sequence[Array], height_m: float) -> float:
    """Return the area between the centre line and the outermost of the curves, up to a height."""
    points = np.vstack(curves)
    z = np.linspace(points[:, 1].min(), height_m, 800)
    if z[-1] <= z[0]:
        return 0.0
    y = np.zeros_like(z)
    for curve in curves:
        order = np.maximum.accumulate(curve[:, 1])
        inside = (z >= curve[0, 1]) & (z <= order[-1])
        y[inside] = np.maximum(y[inside], np.interp(z[inside], order, curve[:, 0]))
    return float(np.trapezoid(y, z))
