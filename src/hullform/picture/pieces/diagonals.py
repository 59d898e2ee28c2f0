"""Diagonals: straight lines from the centre line outboard and down, along which a draughtsman fairs the bilges.

They cross the stations, and a path that could use them would leave its own curve. No station is straight for so long
where it leans back, so what lies on such a line is left out.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LARGEST_LEAN = 0.6  # da/db: from 14 to 76 degrees below level
LEAN_STEP = 0.01
BIN_PX = 3.0
SHORTEST = 0.35  # of B/2
LEAST_DRAWN = 0.5  # of the length between its ends: where stations cross, nothing is seen of it
NEAR_CENTRE = 0.05  # of B/2: the upper end
NEAR_PX = 2.5  # to the axis: a part of the line
ALONG = 0.3  # da/db beside the lean
MOST = 8  # of a half


def on_diagonals(along: Array, across: Array, lean: Array, y_px: Array, half_breadth_px: float) -> NDArray[np.bool_]:
    """Which ridge peaks of one half lie on a diagonal.

    Args:
        along: (n,) coordinate across the frame, px, on which the walk inboard and up goes forward.
        across: (n,) coordinate along the frame, px.
        lean: (n,) slope of the ridge there, d across / d along.
        y_px: (n,) half-breadths.
        half_breadth_px: B/2.
    """
    found = np.zeros(len(along), dtype=np.bool_)
    shortest = SHORTEST * half_breadth_px
    leans = np.arange(-LARGEST_LEAN, LARGEST_LEAN + LEAN_STEP / 2, LEAN_STEP)
    for _ in range(MOST):
        left = np.flatnonzero(~found & (np.abs(lean) < LARGEST_LEAN + ALONG))
        if len(left) < LEAST_DRAWN * shortest:
            return found
        line = _boldest(along[left], across[left], lean[left], leans)
        at = left[_on_line(along[left], across[left], lean[left], line)]
        if len(at) < LEAST_DRAWN * shortest:
            return found
        line = np.polyfit(along[at], across[at], 1)
        at = left[_on_line(along[left], across[left], lean[left], line)]
        length = float(np.ptp(along[at])) if at.size else 0.0
        if length < shortest or len(np.unique(along[at])) < LEAST_DRAWN * length:
            return found
        if y_px[at].min() < NEAR_CENTRE * half_breadth_px:
            found[at] = True
        else:
            lean = lean.copy()
            lean[at] = np.inf  # not to be found again
    return found


def _boldest(along: Array, across: Array, lean: Array, leans: Array) -> Array:
    """Slope and offset of the line on which most peaks lie that lean as it does."""
    best, most = np.zeros(2), 0
    for slope in leans:
        offset = (across - slope * along)[np.abs(lean - slope) < ALONG]
        if len(offset) <= most:
            continue
        counts = np.bincount(np.floor((offset - offset.min()) / BIN_PX).astype(np.int64))
        if counts.max() > most:
            most = int(counts.max())
            best = np.array([slope, offset.min() + (int(counts.argmax()) + 0.5) * BIN_PX])
    return best


def _on_line(along: Array, across: Array, lean: Array, line: Array) -> NDArray[np.bool_]:
    return np.asarray((np.abs(across - np.polyval(line, along)) < NEAR_PX) & (np.abs(lean - line[0]) < ALONG))
