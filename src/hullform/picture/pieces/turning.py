"""Pieces of curve that the columns of the diagonal frame cannot follow: the upper side of a bulb, the roof of a tunnel.

A curve that comes back to the centre line as it rises, or falls as it goes outboard, runs across the diagonal. Its
pieces are found like the others, on the rows of the frame instead of its columns, where no other piece lies already.
Each may be walked both ways: inboard and up, as a bulb, or outboard and down, as a tunnel.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.line_mask import BOLD, HORIZONTAL, VERTICAL, Mask
from hullform.picture.image.ink import Ink
from hullform.picture.pieces.diagonals import on_diagonals
from hullform.picture.pieces.ends import Ends
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.ridges import FAINTEST_THROUGH_LINE, Tracklet, find_peaks, find_tracklets, in_half

Array = NDArray[np.float64]
Ceiling = Callable[[Array], Array]

STEEPEST = 0.8  # da/db: the columns follow what is steeper than 0.45, and a curve's end is uncertain
COVERED_PX = 2.5  # so near a piece of the columns it is that piece
SHORTEST = 0.008  # of B/2: shorter ones are specks of junctions
LEVEL = -0.6  # da/db of a walk inboard that rises less than 14 degrees
LEANING = -0.2  # of one that rises less than 34 degrees: no column follows a steeper one that falls outboard
LOWEST_LEVEL = 0.1  # of B/2: level lines below are flats of bottom
UNDER_WATER = 0.7  # of the depth: there bulbs and tunnels lie
WIDEST_BULB = 0.4  # of B/2
FLAT_BEYOND = (0.4, 0.6)  # of B/2: where a level line that is no top of a bulb goes on
MOSTLY = 0.6  # of that stretch is drawn, figures and lines that were taken off left aside
LEVEL_WITHIN_PX = 3
SHORTEST_OF_TUNNEL = 0.03  # of B/2
LARGEST_DESCENT = -1.25  # da/db of a walk inboard: so far below level may the top of a bulb fall


@dataclass(frozen=True, eq=False)
class Turning:
    """Pieces walked across the frame, one direction each; as tracklets their column counts rows of the frame downwards.

    Attributes:
        pieces: of the transposed frame: column = rows - 1 - row, row = column.
        rows: of the frame.
        inboard_only: (pieces,) whether a piece is not walked outboard and down: it lies on one of the columns, which
            is the same line walked outboard, or is too high up or too short for a tunnel's side.
    """

    pieces: list[Tracklet]
    rows: int
    inboard_only: NDArray[np.bool_]

    def chosen(self, which: NDArray[np.bool_]) -> Turning:
        """A part of them."""
        kept = [piece for piece, keep in zip(self.pieces, which, strict=True) if keep]
        return Turning(kept, self.rows, self.inboard_only[which])

    def points(self, number: int) -> tuple[Array, Array]:
        """(column, row) in the frame of the points of a piece, in the order of its walk."""
        piece = self.pieces[number]
        return piece.row, (self.rows - 1 - piece.column).astype(np.float64)

    def ends(self, last: bool) -> Ends:
        """Column and row in the frame, and da/db, of one end of each piece."""
        ends = Ends.of(self.pieces, last)
        return Ends(ends.row, self.rows - 1.0 - ends.column, ends.slope)


NOTHING_TURNS = Turning([], 0, np.zeros(0, dtype=np.bool_))


def find_turning(
    ink: Ink,
    hidden: Mask,
    tracklets: list[Tracklet],
    frame: DiagonalFrame,
    width_px: float,
    depth_px: float,
    ceiling: Ceiling,
) -> Turning:
    """The pieces of one half that lean back.

    Args:
        ink: (rows, columns) of the frame, without long lines; hidden: where those lay.
        tracklets: pieces found on the columns.
        frame: of the half.
        width_px: usual thickness of a line.
        depth_px: depth at side.
        ceiling: height of the deck over half-breadths, px; what lies above is no station.
    """
    rows = ink.shape[0]
    across = np.ascontiguousarray(ink[::-1].T)
    peaks = find_peaks(across, width_px)
    covered = np.zeros(ink.shape, np.uint8)
    for tracklet in tracklets:
        points = np.column_stack([tracklet.column, np.round(tracklet.row)]).astype(np.int32)
        cv2.polylines(covered, [points], False, 1, max(1, round(2 * COVERED_PX)))
    row, column = rows - 1 - peaks.column, np.clip(np.round(peaks.row).astype(np.int64), 0, ink.shape[1] - 1)
    here = hidden[row, column]
    # da/db of a vertical line walked upwards is 1, of a level one walked inboard -1
    lost = ((here & BOLD) > 0) | (peaks.strength < FAINTEST_THROUGH_LINE)
    on_vertical = lost & ((here & VERTICAL) > 0) & (peaks.slope > 0.55)
    on_horizontal = lost & ((here & HORIZONTAL) > 0) & (peaks.slope < -0.55)
    y, z = frame.to_drawing(peaks.row, rows - 1.0 - peaks.column)
    leaning = (peaks.slope < STEEPEST) & (peaks.slope > LARGEST_DESCENT)
    inside = in_half(y, z, frame) & (z < ceiling(y))
    # a level line is walked outboard on the columns; the top of a bulb is one that is walked inboard
    level = (peaks.slope < np.where(z < UNDER_WATER * depth_px, LEANING, LEVEL)) & (
        z > LOWEST_LEVEL * frame.half_breadth_px
    )
    # that of a bulb lies near the centre line; a flat of bottom, at whatever height, goes on to the bilge
    level &= y < WIDEST_BULB * frame.half_breadth_px
    level[level] &= ~_goes_on(ink, frame, z[level])
    good = leaning & inside & ~on_vertical & ~on_horizontal & (level | (covered[row, column] == 0))
    candidates = np.flatnonzero(good)
    good &= z < ceiling(y)
    good[candidates] &= ~on_diagonals(
        peaks.column[candidates].astype(np.float64),
        peaks.row[candidates],
        peaks.slope[candidates],
        y[candidates],
        frame.half_breadth_px,
    )
    least_of_tunnel = SHORTEST_OF_TUNNEL * frame.half_breadth_px
    least = SHORTEST * frame.half_breadth_px
    pieces = [piece for piece in find_tracklets(peaks.chosen(good)) if len(piece.column) >= least]
    inboard_only = []
    for piece in pieces:
        _, height = frame.to_drawing(piece.row, rows - 1.0 - piece.column)
        on_column = covered[rows - 1 - piece.column, np.round(piece.row).astype(np.int64)].mean() > 0.5
        no_tunnel = height.max() > UNDER_WATER * depth_px or len(piece.column) < least_of_tunnel
        inboard_only.append(bool(on_column or no_tunnel))
    return Turning(pieces, rows, np.array(inboard_only, dtype=np.bool_))


def _goes_on(ink: Ink, frame: DiagonalFrame, z: Array) -> NDArray[np.bool_]:
    """Whether level lines at heights z go on far outboard."""
    y = np.arange(FLAT_BEYOND[0] * frame.half_breadth_px, FLAT_BEYOND[1] * frame.half_breadth_px)
    heights = np.arange(0.0, max(frame.top_px, 1.0))
    column, row = frame.from_drawing(*np.meshgrid(y, heights))
    drawn = cv2.remap(ink, column.astype(np.float32), row.astype(np.float32), cv2.INTER_LINEAR, borderValue=0)
    near = cv2.dilate((drawn > FAINTEST_THROUGH_LINE).astype(np.uint8), np.ones((2 * LEVEL_WITHIN_PX + 1, 1), np.uint8))
    share = near.mean(axis=1)
    return np.asarray(share[np.clip(np.round(z).astype(np.int64), 0, len(share) - 1)] > MOSTLY)
