"""The ink of one half, ready to be traced: its deck edge, its side and its pieces of curve.

What depends on the picture alone is done here, once; `half.trace_half` is quick and may be called again and again.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Half
from hullform.picture.calibrating.line_mask import BOLD, HORIZONTAL, VERTICAL, Mask
from hullform.picture.image.ink import Ink
from hullform.picture.pieces.dome import find_dome, only_contours
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.ridges import (
    Peaks,
    Tracklet,
    find_peaks,
    find_tracklets,
    line_width,
    usable,
    without_hair_lines,
)
from hullform.picture.pieces.sheer import SheerLine, find_sheer
from hullform.picture.pieces.side import find_side
from hullform.picture.pieces.turning import NOTHING_TURNS, Turning, find_turning

Array = NDArray[np.float64]

SHEER_FLANK_PX = 3.5  # flat ridges so near the sheer line are the sheer line
FLAT_SLOPE = 0.6  # db/da of a ridge within 14 degrees of level
DECK_ZONE = 0.84  # of the depth: without a sheer line found, level ridges above it are taken for the deck
LEVEL_SLOPE = 0.8
CLEAR_OF_DECK = 0.03  # of B/2: a piece that ends so far above a line has passed it
TALLER_THAN_FIGURES = 0.07  # of B/2: twice the height of a station's number
FEWEST_PASSING = 2  # pieces that tell that a line is no deck
NEAR_DEPTH = 0.12  # of the depth: a side drawn so high goes to the depth, by its meaning; lower, the deck is stepped
OUTBOARD = 0.012  # of B/2: beyond the line of B/2, where stations run along it, are figures and lines of the sheet


@dataclass(frozen=True, eq=False)
class HalfInk:
    """The ink of one half, ready to be traced.

    Attributes:
        half: which.
        frame: its diagonal frame.
        ink: (rows, columns) of the frame, the long lines of the sheet taken off.
        hidden: where they lay.
        line_width_px: usual thickness of a line; `single_px`: of a ribbon that is one line.
        depth_px: depth at side.
        deck_level_px: height of a level deck line at the depth, or None where none is drawn.
        side_top_px: height to which stations run along the line of B/2, or None where none does.
        side_steps_px: heights at which stations end on it inside the outermost one.
        sheer: the deck edge, or None where none was found.
        peaks: of the ridges that may be curves; `tracklets`: pieces of curve, of the peaks below the deck edge;
            `turning`: pieces that lean back.
    """

    half: Half
    frame: DiagonalFrame
    ink: Ink
    hidden: Mask
    line_width_px: float
    single_px: float
    depth_px: float
    deck_level_px: float | None
    side_top_px: float | None
    side_steps_px: tuple[float, ...]
    sheer: SheerLine | None
    peaks: Peaks
    tracklets: list[Tracklet]
    turning: Turning = NOTHING_TURNS


def prepare_half(
    half: Half, frame: DiagonalFrame, ink: Ink, bare: Ink, mask: Mask, depth_px: float, deck_line: bool
) -> HalfInk:
    """Find the deck edge and the pieces of curve of one half.

    Args:
        half: which.
        frame: its diagonal frame; it is made to reach down to contours below the base line.
        ink: of the picture; bare: the same, its long lines taken off; mask: where they lay.
        depth_px: depth at side.
        deck_line: whether a level line is drawn at the depth.
    """
    here = frame.sample(bare)
    width = line_width(here)
    dome = find_dome(bare, frame)
    if dome.depth_px > 0:
        frame = replace(frame, bottom_px=-dome.depth_px)
        here = only_contours(frame.sample(bare), frame, dome)
    lines = frame.sample_mask(mask)
    hidden = _widened(lines, width)
    side = find_side(ink, frame, width, depth_px)
    side_top = side.top_px
    if side_top is not None and abs(side_top / depth_px - 1) < NEAR_DEPTH:
        side_top = depth_px
    sheer = find_sheer(bare, frame, depth_px, side_top)
    peaks = find_peaks(here, width)
    peaks = peaks.chosen(usable(peaks, lines, hidden, frame))
    if side_top is not None:
        y, _ = frame.to_drawing(peaks.column.astype(np.float64), peaks.row)
        peaks = peaks.chosen(y < frame.half_breadth_px + max(OUTBOARD * frame.half_breadth_px, 2 * width))
    level = depth_px if deck_line else None
    prepared = HalfInk(
        half, frame, here, hidden, width, width, depth_px, level, side_top, side.steps_px, sheer, peaks, []
    )
    if level is not None and _passed(prepared):
        prepared = replace(prepared, deck_level_px=None)
    tracklets = pieces_of_curve(prepared)
    single = float(np.percentile(np.concatenate([t.width for t in tracklets]), 35)) if tracklets else width
    prepared = replace(prepared, single_px=single, tracklets=tracklets)
    return replace(prepared, turning=_pieces_that_turn(prepared))


def _passed(prepared: HalfInk) -> bool:
    """Whether stations go on above the level line at the depth, which is then a waterline."""
    size, passing = prepared.frame.half_breadth_px, 0
    for piece in pieces_of_curve(replace(prepared, deck_level_px=None)):
        _, z = prepared.frame.to_drawing(piece.column.astype(np.float64), piece.row)
        passing += bool(z[-1] > prepared.depth_px + CLEAR_OF_DECK * size and np.ptp(z) > TALLER_THAN_FIGURES * size)
    return passing >= FEWEST_PASSING


def pieces_of_curve(prepared: HalfInk, flank_px: float | None = None) -> list[Tracklet]:
    """The tracklets of a half below its deck edge.

    Args:
        prepared: the half; its tracklets are not looked at.
        flank_px: how near the deck edge flat ridges are the deck edge.
    """
    peaks, sheer, depth_px = prepared.peaks, prepared.sheer, prepared.depth_px
    y, z = prepared.frame.to_drawing(peaks.column.astype(np.float64), peaks.row)
    if sheer is not None:
        flank = SHEER_FLANK_PX if flank_px is None else flank_px
        deck = sheer.at(y)
        on_deck = (np.abs(z - deck) < flank) & (peaks.slope > FLAT_SLOPE)
        above = z > deck + flank
    else:
        on_deck = (z > DECK_ZONE * depth_px) & (peaks.slope > LEVEL_SLOPE)
        above = z > (1.01 if prepared.deck_level_px is not None else 1.6) * depth_px
    return without_hair_lines(find_tracklets(peaks.chosen(~(on_deck | above))), prepared.line_width_px)


def _pieces_that_turn(prepared: HalfInk) -> Turning:
    sheer, depth_px = prepared.sheer, prepared.depth_px

    def ceiling(half_breadth: Array) -> Array:
        if sheer is not None:
            return sheer.at(half_breadth) - SHEER_FLANK_PX
        return np.full(np.shape(half_breadth), DECK_ZONE * depth_px)

    return find_turning(
        prepared.ink, prepared.hidden, prepared.tracklets, prepared.frame, prepared.line_width_px, depth_px, ceiling
    )


def _widened(mask: Mask, width_px: float) -> Mask:
    """The mask, each kind of line wider by half a line: a curve that touches a line is lost in it."""
    kernel = np.ones((2 * round(width_px / 2) + 3,) * 2, np.uint8)
    vertical, horizontal, bold = (
        np.asarray(cv2.dilate(mask & bit, kernel), dtype=np.uint8) for bit in (VERTICAL, HORIZONTAL, BOLD)
    )
    return vertical | horizontal | bold
