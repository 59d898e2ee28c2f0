"""What is drawn below the base line: a sonar dome, a drop keel. Its curves reach the centre line there; letters do not.

The picture below the base line is mostly labels. A contour is told from them by its size: it is connected, touches
the centre line or the base line, and is several times higher than a letter.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.image.ink import Ink
from hullform.picture.pieces.frame import DiagonalFrame

Array = NDArray[np.float64]

DEEPEST = 0.8  # of B/2: how far below the base line contours are looked for
FAINTEST = 0.25  # ink
GAP = 0.014  # of B/2: a long line that was taken off leaves no wider gap in a contour
AT_CENTRE = 0.03  # of B/2
HIGHEST_LETTER = 0.07  # of B/2
AT_BASE = 0.008  # of B/2: what lies so little below the base line is on it
FLANK_PX = 4  # of a contour


@dataclass(frozen=True, eq=False)
class Dome:
    """Where contours are drawn below the base line: a mask over half-breadth and depth, a px each.

    Attributes:
        mask: (depths, half-breadths); empty where none is drawn.
    """

    mask: NDArray[np.bool_]

    @property
    def depth_px(self) -> float:
        """How far the deepest contour reaches below the base line, px; 0 where none is drawn."""
        deep = np.flatnonzero(self.mask.any(axis=1))
        return float(deep[-1] + 1) if deep.size else 0.0

    def shows(self, y: Array, z: Array) -> NDArray[np.bool_]:
        """Whether a contour is drawn at places (y, z), px of the drawing, z below the base line."""
        if not self.mask.size:
            return np.zeros(np.shape(y), dtype=np.bool_)
        rows, columns = self.mask.shape
        depth, across = np.round(-z).astype(np.int64), np.round(y).astype(np.int64)
        known = (depth >= 0) & (depth < rows) & (across >= 0) & (across < columns)
        return np.asarray(known & self.mask[np.clip(depth, 0, rows - 1), np.clip(across, 0, columns - 1)])


def find_dome(bare: Ink, frame: DiagonalFrame) -> Dome:
    """The contours that one half shows below the base line.

    Args:
        bare: (rows, columns) of the picture, its long lines taken off.
        frame: of the half.
    """
    size = frame.half_breadth_px
    y, z = np.meshgrid(np.arange(0.0, size), -np.arange(0.0, DEEPEST * size))
    u, v = frame.to_picture(y, z)
    below = cv2.remap(bare, u.astype(np.float32), v.astype(np.float32), cv2.INTER_LINEAR, borderValue=0)
    kernel = np.ones((2 * round(GAP * size / 2) + 1,) * 2, np.uint8)
    drawn = cv2.morphologyEx((below > FAINTEST).astype(np.uint8), cv2.MORPH_CLOSE, kernel)
    _, labels, boxes, _ = cv2.connectedComponentsWithStats(drawn)
    left, top, width, height = (
        boxes[:, k] for k in (cv2.CC_STAT_LEFT, cv2.CC_STAT_TOP, cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT)
    )
    contour = (height > HIGHEST_LETTER * size) & (left < AT_CENTRE * size) & (width > HIGHEST_LETTER / 2 * size)
    contour &= top + height < DEEPEST * size - 2
    # a border, or a title block that hangs together with it, goes on outboard of the ship
    contour[np.unique(labels[round(HIGHEST_LETTER / 2 * size) :, -1])] = False
    contour[0] = False
    mask = contour[labels]
    if not mask.any():
        return Dome(np.zeros((0, 0), dtype=np.bool_))
    wide = cv2.dilate(mask.astype(np.uint8), np.ones((2 * FLANK_PX + 1,) * 2, np.uint8))
    return Dome(wide > 0)


def only_contours(ink: Ink, frame: DiagonalFrame, dome: Dome) -> Ink:
    """The ink of a half without the labels below the base line.

    Args:
        ink: (rows, columns) of the frame.
        frame: of the half, which reaches as far down as the dome.
        dome: what is drawn below the base line.
    """
    rows, columns = ink.shape
    column, row = np.meshgrid(np.arange(columns, dtype=np.float64), np.arange(rows, dtype=np.float64))
    y, z = frame.to_drawing(column, row)
    below = z < -AT_BASE * frame.half_breadth_px
    out = ink.copy()
    out[below] = np.where(dome.shows(y[below], z[below]), ink[below], 0.0)
    return out
