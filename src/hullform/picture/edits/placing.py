"""A person's corrections in the frame of the half that they lie in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Half
from hullform.corrections import Correction, DeckEdge, Drawn, Ignored, MarkedStation
from hullform.picture.image.reduction import Reduction
from hullform.picture.pieces.frame import DiagonalFrame

Array = NDArray[np.float64]

REACH = 0.018  # of B/2: a hand's aim; what lies farther from a point is not under it


@dataclass(frozen=True, eq=False)
class Placed:
    """A correction with its points: `yz` in px of the drawing, `at` as [column, row] of the half's frame, (n, 2)."""

    correction: Correction
    yz: Array
    at: Array


def place_corrections(
    corrections: Sequence[Correction], frames: dict[Half, DiagonalFrame], reduction: Reduction
) -> dict[Half, tuple[Placed, ...]]:
    """The corrections of each half; an outline to be ignored counts for both, marks are placed elsewhere.

    Args:
        corrections: their points in px of the stored picture.
        frames: of both halves.
        reduction: of the picture that is read.
    """
    placed: dict[Half, list[Placed]] = {half: [] for half in frames}
    for correction in corrections:
        if isinstance(correction, MarkedStation):
            continue
        px = np.array(correction.px, dtype=np.float64).reshape(-1, 2)
        by_half = {half: drawing_of_stored(px, frame, reduction) for half, frame in frames.items()}
        if isinstance(correction, Drawn | DeckEdge):
            halves: list[Half] = [correction.half]
        elif isinstance(correction, Ignored):
            halves = list(frames)
        else:
            halves = [max(by_half, key=lambda half: float(by_half[half][:, 0].mean()))]
        for half in halves:
            yz = by_half[half]
            placed[half].append(Placed(correction, yz, np.column_stack(frames[half].from_drawing(yz[:, 0], yz[:, 1]))))
    return {half: tuple(here) for half, here in placed.items()}


def drawing_of_stored(px: Array, frame: DiagonalFrame, reduction: Reduction) -> Array:
    """(n, 2) [y, z] in px of the drawing of pixels of the stored picture."""
    return np.column_stack(frame.from_picture(*reduction.read((px[:, 0], px[:, 1]))))


def stored_of_drawing(yz: Array, frame: DiagonalFrame, reduction: Reduction) -> Array:
    """(n, 2) pixels of the stored picture of points [y, z] in px of the drawing."""
    u, v = frame.to_picture(yz[:, 0], yz[:, 1])
    return np.column_stack([(u + 0.5) * reduction.across - 0.5, (v + 0.5) * reduction.down - 0.5])
