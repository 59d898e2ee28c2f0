"""Points at even steps along a curve."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

POINT_SPACING_PX = 2.0  # along a traced curve
NO_CORNERS: Array = np.zeros((0, 2))


def evenly(points: Array, corners: Array = NO_CORNERS) -> Array:
    """The curve at even steps of arc length, its ends and corners kept."""
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    keep = np.concatenate([[True], np.diff(arc) > 1e-9])
    at = np.linspace(0.0, arc[-1], max(3, round(arc[-1] / POINT_SPACING_PX) + 1))
    for corner in corners:
        away = np.hypot(*(points - corner).T)
        if away.min() < POINT_SPACING_PX:
            at = np.unique(np.append(at, arc[np.argmin(away)]))
    return np.column_stack([np.interp(at, arc[keep], points[keep, k]) for k in (0, 1)])
