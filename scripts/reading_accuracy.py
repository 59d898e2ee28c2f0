"""How far traced stations lie from the outlines that were drawn: by distance along the curves, and by area."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from drawing.moulded import Moulded

    from hullform.picture.reading import PictureReading

Array = NDArray[np.float64]


class StationErrors(NamedTuple):
    """Per station: RMS distance, the worse of both directions, in % of B/2; area errors in % of the largest area.

    rms_percent (stations,); area_percent (stations, 2), below the draught and to the deck.
    """

    rms_percent: Array
    area_percent: Array


def to_polyline(points: Array, line: Array) -> Array:
    """Distance of each point to a polyline."""
    start, step = line[:-1], np.diff(line, axis=0)
    length = np.maximum((step**2).sum(axis=1), 1e-18)
    share = np.clip(((points[:, None] - start) * step).sum(axis=2) / length, 0, 1)
    return np.hypot(*np.moveaxis(start + share[..., None] * step - points[:, None], 2, 0)).min(axis=1)


def evenly(line: Array, count: int = 300) -> Array:
    """Points at equal steps of arc length."""
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
    at = np.linspace(0, arc[-1], count)
    return np.column_stack([np.interp(at, arc, line[:, k]) for k in (0, 1)])


def area_below(line: Array, height: float) -> float:
    """Half the sectional area up to a height: the integral of y dz, for a curve whose z does not fall."""
    z = np.linspace(line[0, 1], min(height, line[-1, 1]), 2000)
    return float(np.trapezoid(np.interp(z, np.maximum.accumulate(line[:, 1]), line[:, 0]), z)) if z[-1] > z[0] else 0.0


def station_errors(hull: Moulded, reading: PictureReading) -> StationErrors:
    """Every traced station of a reading, all its curves, against the form that its picture was drawn from."""
    stations = reading.body_plan.stations
    truths = [hull.curves(station.x_m, 600) for station in stations]
    largest = max(sum(area_below(curve, np.inf) for curve in truth) for truth in truths)
    rms, areas = [], []
    for station, truth in zip(stations, truths, strict=True):
        traced = [evenly(curve.points) for curve in station.curves]
        there = _to_nearest(np.vstack([evenly(curve) for curve in truth]), traced)
        back = _to_nearest(np.vstack(traced), truth)
        rms.append(100 * max(np.sqrt(np.mean(there**2)), np.sqrt(np.mean(back**2))) / (reading.breadth_m / 2))
        read, drawn = (
            np.array([sum(area_below(curve, height) for curve in curves) for height in (reading.draught_m, np.inf)])
            for curves in (traced, truth)
        )
        areas.append(100 * (read - drawn) / largest)
    return StationErrors(np.array(rms), np.array(areas))


def _to_nearest(points: Array, lines: list[Array]) -> Array:
    """Distance of each point to the nearest of several polylines."""
    return np.min([to_polyline(points, line) for line in lines], axis=0)
