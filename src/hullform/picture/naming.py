"""Which curve is which station: counted from the centre line outwards, held to the user's marks where there are any.

The aft half shows its aftmost station innermost, the fore half its foremost. Stations of a parallel body are drawn
once: where there are fewer curves than names, the outermost curve has several.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

COST_OF_SHARING_INSIDE = 30.0  # px of mark distance that sharing any but the outermost curve is worth
COST_OF_SHARING_OUTSIDE = 0.5
COST_OF_UNNAMED_CURVE = 60.0
FARTHEST_MARK_PX = 200.0  # a mark farther from every curve says no more than this


def assign_stations(stations: int, curves: int, mark_distance_px: Array | None = None) -> list[int]:
    """The curve of each station, both counted from the centre line outwards; never decreasing.

    Args:
        stations: number of names.
        curves: number of curves, at least one.
        mark_distance_px: (stations, curves) distance of each station's mark from each curve, NaN where it has none.
    """
    marks = np.zeros((stations, curves)) if mark_distance_px is None else np.nan_to_num(mark_distance_px)
    cost = np.minimum(marks, FARTHEST_MARK_PX)
    total = np.full((stations, curves), np.inf)
    came_from = np.zeros((stations, curves), dtype=np.int64)
    total[0] = cost[0] + COST_OF_UNNAMED_CURVE * np.arange(curves)
    for station in range(1, stations):
        for curve in range(curves):
            step = np.full(curves, np.inf)
            step[:curve] = total[station - 1, :curve] + COST_OF_UNNAMED_CURVE * np.arange(curve - 1, -1, -1)
            outermost = curve == curves - 1
            step[curve] = total[station - 1, curve] + (COST_OF_SHARING_OUTSIDE if outermost else COST_OF_SHARING_INSIDE)
            came_from[station, curve] = int(np.argmin(step))
            total[station, curve] = step[came_from[station, curve]] + cost[station, curve]
    last = int(np.argmin(total[-1] + COST_OF_UNNAMED_CURVE * np.arange(curves - 1, -1, -1)))
    assigned = [last]
    for station in range(stations - 1, 0, -1):
        assigned.append(int(came_from[station, assigned[-1]]))
    return assigned[::-1]


def mark_distances(
    curves: Sequence[NDArray[np.float64]], marks: Sequence[tuple[int, float, float]], stations: int
) -> Array | None:
    """(stations, curves) distance in px of each station's mark from each curve; NaN without a mark, None without any.

    Args:
        curves: (n, 2) points of each, px.
        marks: station index, and the point in the same px.
        stations: number of names.
    """
    if not marks:
        return None
    out = np.full((stations, len(curves)), np.nan)
    for station, first, second in marks:
        out[station] = [float(np.hypot(*(points - (first, second)).T).min()) for points in curves]
    return out
