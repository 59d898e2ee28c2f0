"""Pieces that lean back, as a person edits them: deleted, ignored, or taken by a curve that was drawn."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from hullform.corrections import Deleted
from hullform.picture.edits.hand_drawn import ON_LINE, ON_LINE_PX, SHARE_OF_TRACKLET
from hullform.picture.edits.line_edits import under
from hullform.picture.edits.placing import REACH, Placed
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.ridges import Tracklet
from hullform.picture.pieces.turning import Turning

Array = NDArray[np.float64]


def without_deleted(
    turning: Turning, tracklets: Sequence[Tracklet], placed: Sequence[Placed], half_breadth_px: float
) -> tuple[Turning, list[Placed]]:
    """The pieces that nobody deleted, and the corrections that mean other lines."""
    others = []
    for item in placed:
        if isinstance(item.correction, Deleted) and turning.pieces:
            column, row = (float(value) for value in item.at[0])
            away = [
                float(np.hypot(c - column, r - row).min())
                for c, r in (turning.points(number) for number in range(len(turning.pieces)))
            ]
            if min(away) < min(under(tracklets, (column, row)).distance_px, REACH * half_breadth_px):
                turning = turning.chosen(np.arange(len(away)) != int(np.argmin(away)))
                continue
        others.append(item)
    return turning, others


def without_ink_of_drawn(turning: Turning, curve: Array, frame: DiagonalFrame) -> Turning:
    """The pieces that do not lie on a drawn curve, (n, 2) [y, z] in px of the drawing."""
    line = KDTree(np.column_stack(frame.from_drawing(curve[:, 0], curve[:, 1])))
    reach = max(ON_LINE_PX, ON_LINE * frame.half_breadth_px)

    def lies_on_it(column: Array, row: Array) -> bool:
        distance, _ = line.query(np.column_stack([column, row]))
        return float(np.mean(distance < reach)) >= SHARE_OF_TRACKLET

    return _without(turning, lies_on_it)


def without_ignored(turning: Turning, outline: NDArray[np.uint8]) -> Turning:
    """The pieces that have no point in an outline, (rows, columns) of the frame, 1 inside."""

    def touches(column: Array, row: Array) -> bool:
        rows, columns = outline.shape
        at = np.clip(np.round(row), 0, rows - 1).astype(np.int64), np.clip(np.round(column), 0, columns - 1)
        return bool(outline[at[0], at[1].astype(np.int64)].any())

    return _without(turning, touches)


def _without(turning: Turning, gone: Callable[[Array, Array], bool]) -> Turning:
    keep = [not gone(*turning.points(number)) for number in range(len(turning.pieces))]
    return turning.chosen(np.array(keep, dtype=np.bool_))
