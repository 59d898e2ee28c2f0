"""When two places along the ship are one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# Of the length: some millimetres, far below any part of a ship. Finite elements need bays of 9e-6.
SAME_PLACE = 1e-5


def moved_to(stations: Array, places: Array, length_m: float) -> Array:
    """Places (k,), those put on a station (n,) that all but stand on it; all in m."""
    if not stations.size:
        return places
    nearest = stations[np.abs(places[:, None] - stations).argmin(axis=1)]
    return np.where(np.abs(places - nearest) <= SAME_PLACE * length_m, nearest, places)
