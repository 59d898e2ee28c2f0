"""The ship's side: how high it is drawn where many stations run up the line of B/2 together.

There the sheet often has a box line or a grid line too, which goes on above the deck. A station covers that line with
a thicker one, so the side ends where the ink across the line falls back to what the line has by itself.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.frame import DiagonalFrame
from hullform.picture.ink import Ink

Array = NDArray[np.float64]

FOOT = 0.04  # of B/2: so near the base line no station has reached the line of B/2
REACH_PX = 3.5  # to either side of the line
STEP_PX = 0.5
SHARE_OF_STATION = 0.5  # of the way from the line's own thickness to a station's: more ink is a station
CLEARLY_THICKER = 1.8  # a station than the line by itself; else the whole line is taken for the side
SHORTEST = 0.04  # of B/2: shorter strokes are labels, waterlines or curves that pass


def top_of_side(ink: Ink, frame: DiagonalFrame, width_px: float) -> float | None:
    """Height in px to which stations are drawn along the line of B/2; None where none runs along it.

    Args:
        ink: (rows, columns) of the picture, its long lines not taken off.
        frame: of the half.
        width_px: thickness of a station's line.
    """
    size = frame.half_breadth_px
    z = np.arange(-FOOT * size, frame.top_px)
    y = size + np.arange(-REACH_PX, REACH_PX + 0.01, STEP_PX)
    u, v = frame.to_picture(*np.meshgrid(y, z))
    across = cv2.remap(ink, u.astype(np.float32), v.astype(np.float32), cv2.INTER_LINEAR).sum(axis=1) * STEP_PX
    own = float(np.median(across[np.abs(z) < FOOT * size]))
    # a station lies on the line, so that the thicker of the two is seen
    least = own + SHARE_OF_STATION * (width_px - own) if width_px > CLEARLY_THICKER * own else 0.5 * own
    drawn = (across > least) & (z > FOOT * size)
    kernel = np.ones((max(3, round(SHORTEST * size)), 1), np.uint8)
    runs = np.flatnonzero(cv2.morphologyEx(drawn.astype(np.uint8)[:, None], cv2.MORPH_OPEN, kernel)[:, 0])
    return float(z[runs[-1]]) if runs.size else None
