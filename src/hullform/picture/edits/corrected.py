"""The ink of a half as a person corrects it: what is to be ignored taken out, the deck edge as drawn."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

from hullform.corrections import DeckEdge, Ignored
from hullform.picture.edits.placing import Placed
from hullform.picture.edits.turning_edits import without_ignored
from hullform.picture.pieces.half_ink import HalfInk, pieces_of_curve
from hullform.picture.pieces.sheer import SheerLine

Array = NDArray[np.float64]

DRAWN_FLANK_PX = 6.0  # a deck edge drawn by hand misses its line by as much between its points
DECK_STEP_PX = 2.0  # between the points of a deck edge


def correct_ink(prepared: HalfInk, placed: Sequence[Placed]) -> tuple[HalfInk, set[str]]:
    """A half without what is to be ignored and with the deck edge as drawn; ids of the corrections that did it."""
    heeded: set[str] = set()
    ink, peaks, sheer, flank = prepared.ink, prepared.peaks, prepared.sheer, None
    turning = prepared.turning
    for item in placed:
        correction = item.correction
        if isinstance(correction, Ignored):
            outline = np.zeros(ink.shape, np.uint8)
            cv2.fillPoly(outline, [np.round(item.at).astype(np.int32)], 1)
            row = np.clip(np.round(peaks.row).astype(np.int64), 0, ink.shape[0] - 1)
            inside = outline[row, peaks.column] > 0
            before, turning = len(turning.pieces), without_ignored(turning, outline)
            if inside.any() or len(turning.pieces) < before:
                heeded.add(correction.id)
                peaks, ink = peaks.chosen(~inside), np.asarray(np.where(outline > 0, 0, ink), dtype=np.float32)
        elif isinstance(correction, DeckEdge) and (drawn := _deck_edge(item.yz, prepared.frame.half_breadth_px)):
            heeded.add(correction.id)
            sheer, flank = drawn, DRAWN_FLANK_PX
    if not heeded:
        return prepared, heeded
    corrected = replace(prepared, ink=ink, peaks=peaks, sheer=sheer, turning=turning)
    return replace(corrected, tracklets=pieces_of_curve(corrected, flank)), heeded


def _deck_edge(yz: Array, half_breadth_px: float) -> SheerLine | None:
    """The deck edge through drawn points, rounded without overshoot; None where none of them lies in the half."""
    yz = yz[np.argsort(yz[:, 0], kind="stable")]
    yz = yz[np.concatenate([np.diff(yz[:, 0]) > 1e-6, [True]])]
    if yz[-1, 0] <= 0 or yz[0, 0] > 1.1 * half_breadth_px:
        return None
    if len(yz) < 2:
        return SheerLine(np.array([0.0, half_breadth_px]), np.repeat(yz[:, 1], 2))
    y = np.unique(np.append(np.arange(yz[0, 0], yz[-1, 0], DECK_STEP_PX), yz[:, 0]))
    return SheerLine(y, np.asarray(PchipInterpolator(yz[:, 0], yz[:, 1])(y)))
