"""A half of a body plan drawn by formula in its diagonal frame, so that a test knows where every line runs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray
from reading_accuracy import to_polyline

from hullform.corrections import Correction
from hullform.picture.edits.placing import Placed
from hullform.picture.image.ink import ink_of
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.half_ink import HalfInk, pieces_of_curve
from hullform.picture.pieces.ridges import find_peaks
from hullform.picture.tracing.half import HalfReading, trace_half

Array = NDArray[np.float64]

SIZE_PX = 600.0  # B/2, and depth
LINE_PX = 2
# one pixel of the drawing is one metre, and the picture is the drawing: u = y, v = -z
FRAME = DiagonalFrame(np.diag([1.0, -1.0, 1.0]), 1, 1.0, SIZE_PX, SIZE_PX)


def half_of(lines: Sequence[Array]) -> HalfInk:
    """The half that shows these lines, each (n, 2) [y, z] in px."""
    image = np.full(FRAME.shape, 250, np.uint8)
    for line in lines:
        points = np.column_stack(FRAME.from_drawing(line[:, 0], line[:, 1]))
        cv2.polylines(image, [np.round(points * 16).astype(np.int32)], False, 10, LINE_PX, cv2.LINE_AA, 4)
    ink = ink_of(image)
    peaks = find_peaks(ink, LINE_PX)
    hidden = np.zeros(ink.shape, np.uint8)
    bare = HalfInk(
        half="aft",
        frame=FRAME,
        ink=ink,
        hidden=hidden,
        line_width_px=LINE_PX,
        single_px=LINE_PX,
        depth_px=SIZE_PX,
        deck_level_px=None,
        side_top_px=None,
        side_steps_px=(),
        sheer=None,
        peaks=peaks,
        tracklets=[],
    )
    tracklets = pieces_of_curve(bare)
    single = float(np.median(np.concatenate([line.width for line in tracklets])))
    return replace(bare, single_px=single, tracklets=tracklets)


def placed(correction: Correction) -> Placed:
    """A correction in the frame of the half; its px are the picture's, (y, -z)."""
    yz = np.array(correction.px, dtype=np.float64).reshape(-1, 2) * (1.0, -1.0)
    return Placed(correction, yz, np.column_stack(FRAME.from_drawing(yz[:, 0], yz[:, 1])))


def traced(half: HalfInk, most: int, *corrections: Correction) -> HalfReading:
    """The curves of the half, corrected."""
    return trace_half(half, most, (), [placed(correction) for correction in corrections])


def misses(curve: Array, line: Array) -> Array:
    """(n,) distance of points of a line from a curve, px."""
    return to_polyline(line, curve)
