"""The form of what was traced, quickly: sectional areas and waterlines of the stations as they are, not faired.

A station with another's curve, or half a curve, stands out in them at once.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Station, TracedCurve

Array = NDArray[np.float64]


def half_breadth_at(curves: Sequence[TracedCurve], height_m: float) -> float | None:
    """The largest half-breadth of a section at a height, m; None where no curve of it passes there."""
    found: list[float] = []
    for curve in curves:
        y, z = curve.half_breadth_m, curve.height_m
        passing = np.flatnonzero((np.minimum(z[:-1], z[1:]) <= height_m) & (np.maximum(z[:-1], z[1:]) >= height_m))
        rise = z[passing + 1] - z[passing]
        share = np.divide(height_m - z[passing], rise, out=np.ones_like(rise), where=np.abs(rise) > 1e-12)
        found += (y[passing] + share * (y[passing + 1] - y[passing])).tolist()
    return max(found, default=None)


def waterlines(stations: Sequence[Station], heights_m: Sequence[float]) -> list[list[tuple[float, float]]]:
    """(x, y) in metres of each waterline at the stations that reach its height."""
    out = []
    for height in heights_m:
        at = [(station.x_m, half_breadth_at(station.curves, height)) for station in stations]
        out.append([(x, y) for x, y in at if y is not None])
    return out
