"""The ends of tracklets: where they point, and what it costs a curve to begin or to end there."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.line_mask import HORIZONTAL, Mask
from hullform.picture.image.ink import Ink
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.ridges import Tracklet

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

REACH_OF_KEEL_PX = 12.0  # an end so near the centre line or base line is one on it
END_STRETCHES_PX = (22, 14, 9, 6)  # that show where an end points: the longest that is smooth
SMOOTH_PX = 0.5  # beside a parabola, root of mean square: the noise of a ridge; a corner leaves more
DEAREST_ENTRY = 1500.0
DEAREST_EXIT = 500.0
COST_OF_END_ON_PAPER = 110.0  # ends below the deck where no ink goes on
COST_OF_END_ON_INK = 1200.0  # more, for ink ahead
COST_AT_SIDE = 12.0  # ends in the line of B/2, which goes on to the deck
GAIN_OF_SIDE = 25.0  # ends where it joins the line of B/2, of which it is a part from there on
GAIN_OF_FLAT = 25.0  # begins where it leaves the base line, of which it is a part up to there
COST_ON_LEVEL = 10.0  # begins level where a waterline hides what comes before
LEVEL = 0.6  # db/da of a curve within 14 degrees of level
BEFORE_PX = 6.0
LEAST_TURN = 0.5  # of db/da, of a bilge from its flat to its side: 27 degrees
LEAST_FLAT = 0.5  # of B/2
STEEPEST = 2.2  # db/da of a curve: tumblehome of 20 degrees
CLOSE_TO_SIDE = 0.975  # of B/2: the mask of the line of B/2 hides the rest of a bilge of small radius
BENDING_UP = 0.5  # db/da of a curve that has begun to rise, by 18 degrees
RISING = -0.15  # db/da of a curve that rises more than it widens: it may join the line of B/2


@dataclass(frozen=True, eq=False)
class Ends:
    """Position, slope at one end of each tracklet."""

    column: Array
    row: Array
    slope: Array

    @classmethod
    def of(cls, tracklets: list[Tracklet], last: bool) -> Ends:
        """The last or the first ends, fitted by a parabola over up to 22 px, or less where a corner is nearer."""
        fits = [end_fit(t.column, t.row, last) for t in tracklets]
        column = np.array([float(t.column[-1 if last else 0]) for t in tracklets])
        return cls(column, np.array([f[0] for f in fits]), np.array([f[1] for f in fits]))

    def with_others(self, others: Ends) -> Ends:
        """These ends, then the others."""
        return Ends(
            np.concatenate([self.column, others.column]),
            np.concatenate([self.row, others.row]),
            np.concatenate([self.slope, others.slope]),
        )


def end_fit(column: Indices | Array, row: Array, last: bool) -> tuple[float, float]:
    """Row and slope at the last or the first end of a run of columns, over the longest stretch that is smooth."""
    for stretch in END_STRETCHES_PX:
        size = min(len(column), stretch)
        part = slice(-size, None) if last else slice(None, size)
        x = (column[part] - column[-1 if last else 0]).astype(np.float64)
        fit = np.polyfit(x, row[part], 1 if size < 14 else 2)
        if float(np.sqrt(np.mean((np.polyval(fit, x) - row[part]) ** 2))) < SMOOTH_PX:
            break
    return float(fit[-1]), float(np.clip(fit[-2], -STEEPEST, STEEPEST))


def entry_cost(first: Ends, last: Ends, mask: Mask, frame: DiagonalFrame, scale: float) -> Array:
    """Little at the centre line and the base line, then by the distance from them.

    A bilge that begins on the base line gains for the flat of bottom that lies on that line unseen.
    """
    y, z = frame.to_drawing(first.column, first.row)
    away = np.minimum(np.abs(y), np.abs(z))
    reach = np.maximum(REACH_OF_KEEL_PX * scale, _half_of_base(mask, frame) + 0.6 * REACH_OF_KEEL_PX * scale)
    cost = np.where(away < reach, 0.3 * away, np.minimum(3 + 4 * (away - reach), DEAREST_ENTRY * scale))
    on_flat = (y > LEAST_FLAT * frame.half_breadth_px) & (z < reach)
    cost = np.where(on_flat, cost - GAIN_OF_FLAT * scale, cost)
    # likewise one that begins level on a waterline, of a raked end; what goes on as it began only crosses that line
    bilge = (y > LEAST_FLAT * frame.half_breadth_px) & (first.slope - last.slope > LEAST_TURN)
    on_level = bilge & begins_on_level_line(first, mask)
    return np.where(on_level, np.minimum(cost, COST_ON_LEVEL * scale), cost)


def begins_on_level_line(ends: Ends, mask: Mask) -> NDArray[np.bool_]:
    """Whether curves begin level where a level line of the drawing lies before them, which may hide what they were."""
    before = np.arange(0.0, BEFORE_PX)[:, None]
    column = np.clip(np.round(ends.column - before), 0, mask.shape[1] - 1).astype(np.int64)
    row = np.clip(np.round(ends.row - ends.slope * before), 0, mask.shape[0] - 1).astype(np.int64)
    return np.asarray((ends.slope > LEVEL) & ((mask[row, column] & HORIZONTAL > 0).mean(axis=0) > 0.5))


def _half_of_base(mask: Mask, frame: DiagonalFrame) -> float:
    """Height above the base line up to which the mask hides what is drawn, px: many flats of bottom make it thick."""
    z, y = np.meshgrid(np.arange(0.0, 0.04 * frame.half_breadth_px), np.linspace(0.1, 0.8, 15) * frame.half_breadth_px)
    column, row = frame.from_drawing(y, z)
    hidden = mask[np.round(row).astype(np.int64), np.round(column).astype(np.int64)] & HORIZONTAL > 0
    return float(np.median(np.cumprod(hidden, axis=1).sum(axis=1)))


def exit_cost(
    last: Ends, ink: Ink, frame: DiagonalFrame, top_px: Array, side_top_px: float | None, scale: float
) -> Array:
    """Nothing at the deck, little in the line of B/2, else by the distance to the deck and the ink ahead."""
    size = frame.half_breadth_px
    y, z = frame.to_drawing(last.column, last.row)
    below = np.maximum(0.0, top_px - z - 0.03 * size)
    cost = np.minimum(1.5 * below, DEAREST_EXIT * scale)
    near = cv2.dilate(ink, np.ones((3, 3), np.uint8))
    ahead = np.linspace(5, 0.055 * size, 26)
    columns = np.clip(np.round(last.column[:, None] + ahead), 0, ink.shape[1] - 1).astype(np.int64)
    rows = np.clip(np.round(last.row[:, None] + last.slope[:, None] * ahead), 0, ink.shape[0] - 1).astype(np.int64)
    going_on = (near[rows, columns] > 0.3).mean(axis=1)
    on_ink = COST_OF_END_ON_PAPER + COST_OF_END_ON_INK * np.clip(going_on - 0.2, 0.0, 1.0)
    cost = np.minimum(cost, on_ink * scale)
    at_side = (y > 0.965 * size) & (last.slope < RISING)
    if side_top_px is not None:  # nothing is outboard of a drawn side, so what nears it turns into it
        at_side |= (y > CLOSE_TO_SIDE * size) & (last.slope < BENDING_UP) & (z < side_top_px)
    cost = np.where(at_side, np.minimum(cost, COST_AT_SIDE * scale), cost)
    joins = at_side & (z < (side_top_px or 0.0) - 0.05 * size)
    return np.asarray(np.where(joins, -GAIN_OF_SIDE * scale, cost), dtype=np.float64)
