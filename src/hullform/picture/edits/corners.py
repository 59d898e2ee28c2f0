"""Where along a curve a corner lies that a person pointed at."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

SEARCH = 0.02  # of B/2: how far along the curve from the point the corner is sought
ARM = 0.05  # of B/2: the stretch to either side that shows it
FEWEST = 10  # points of each stretch
BLURRED_PX = 2.5  # to either side of a corner, where the ridge is rounded by the line's own width


def corner_near(column: Array, row: Array, weight: Array, at: float, half_breadth_px: float) -> int | None:
    """Index of the point where two parabolas that meet there fit the curve best; None where it is too short.

    Args:
        column, row: of the curve, one point a column.
        weight: of each point.
        at: column near which the corner is sought.
        half_breadth_px: B/2.
    """
    arm = max(ARM * half_breadth_px, 2.0 * FEWEST)
    candidates = np.flatnonzero(np.abs(column - at) <= SEARCH * half_breadth_px)
    best: tuple[float, int] | None = None
    for index in candidates.tolist():
        away = column - column[index]
        part = (np.abs(away) <= arm) & (np.abs(away) > BLURRED_PX)
        before, after = np.minimum(away[part], 0.0), np.maximum(away[part], 0.0)
        if min((before < 0).sum(), (after > 0).sum()) < FEWEST:
            continue
        basis = np.column_stack([np.ones(part.sum()), before, after, before**2, after**2])
        root = np.sqrt(weight[part])
        _, left, rank, _ = np.linalg.lstsq(basis * root[:, None], row[part] * root, rcond=None)
        if rank == basis.shape[1] and left.size:
            misfit = float(left[0]) / float(weight[part].sum())
            if best is None or misfit < best[0]:
                best = (misfit, index)
    return None if best is None else best[1]


def without_blur(weight: Array, corners: Sequence[int], of_blurred: float) -> Array:
    """Weights that trust the stretches to either side of each corner more than its own rounded tip."""
    if not corners:
        return weight
    away = np.abs(np.arange(len(weight))[:, None] - np.array(corners)[None, :]).min(axis=1)
    return np.asarray(np.where(away <= BLURRED_PX, np.minimum(weight, of_blurred), weight))


def bends_freely(size: int, corners: Sequence[int]) -> NDArray[np.bool_]:
    """(size - 3,) whether each third difference of four neighbours spans a corner inside."""
    first = np.arange(size - 3)[:, None]
    at = np.array(corners, dtype=np.int64)[None, :]
    return np.asarray(((first < at) & (at < first + 3)).any(axis=1))
