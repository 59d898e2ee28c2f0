"""The user's marks in the frame of their half, and what cannot be right about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.picture.image.reduction import Reduction
from hullform.picture.naming.alignment import NO_CURVE
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.ship_body_plan import Mark

Array = NDArray[np.float64]

FARTHEST = 0.03  # of B/2: a mark farther from every traced curve is on none of them
APART = 0.01  # of B/2: curves that lie nearer to each other at a mark are one place to the eye


@dataclass(frozen=True)
class PlacedMark:
    """A mark, the index of its station from the centre line outwards, and its place in px of the drawing."""

    mark: Mark
    station: int
    y_px: float
    z_px: float


def place_marks(
    marks: Sequence[Mark],
    inner_first: Sequence[float],
    frame: DiagonalFrame,
    size_px: tuple[int, int],
    reduction: Reduction,
) -> tuple[list[PlacedMark], list[str]]:
    """The marks of one half that may be right, and doubts about the others.

    Args:
        marks: of the half.
        inner_first: its stations from the centre line outwards, m.
        frame: of the half.
        size_px: (width, height) of the stored picture, which the marks refer to.
        reduction: of the picture that is read.
    """
    placed: list[PlacedMark] = []
    doubts: list[str] = []
    width, height = size_px
    for mark in marks:
        u, v = mark.px
        if not (-0.5 <= u <= width - 0.5 and -0.5 <= v <= height - 0.5):
            doubts.append(f"{_named(mark)} lies outside the picture of {width} x {height} px; it was not used")
            continue
        y, z = (float(value) for value in frame.from_picture(*reduction.read(mark.px)))
        if y < -APART * frame.half_breadth_px:
            doubts.append(
                f"{_named(mark)} lies in the other half; check its half, its px and aft_side; it was not used"
            )
            continue
        placed.append(PlacedMark(mark, int(np.argmin([abs(x - mark.station_m) for x in inner_first])), y, z))
    return placed, doubts


def distances_to_curves(marks: Sequence[PlacedMark], curves: Sequence[Array]) -> Array:
    """(marks, curves) distance of each mark from each curve, px of the drawing."""
    out = [[float(np.hypot(*(curve - (m.y_px, m.z_px)).T).min()) for curve in curves] for m in marks]
    return np.array(out, dtype=np.float64).reshape(len(marks), len(curves))


def near_curves(
    marks: Sequence[PlacedMark], curves: Sequence[Array], half_breadth_px: float
) -> tuple[list[PlacedMark], list[str]]:
    """The marks that lie on a traced curve, and doubts about the others.

    Args:
        marks: of a half, without those that lie on contours which close on the centre line.
        curves: (n, 2) [y, z] of each, px of the drawing.
        half_breadth_px: B/2.
    """
    nearest = distances_to_curves(marks, curves).min(axis=1, initial=np.inf)
    good = nearest <= FARTHEST * half_breadth_px
    doubts = [
        f"{_named(mark.mark)} lies {100 * distance / half_breadth_px:.0f} % of B/2 from the nearest traced curve; "
        "it was not used; check its px, or draw the curve on the review page where the line itself was not traced"
        for mark, distance, fits in zip(marks, nearest, good, strict=True)
        if not fits
    ]
    doubts += [
        f"{_named(mark.mark)} is for the second contour of its station, but none that closes on the centre line was "
        "found there, and it was taken for the station's curve; check it, or draw the contour on the review page"
        for mark, fits in zip(marks, good, strict=True)
        if fits and mark.mark.curve != 0
    ]
    return [mark for mark, fits in zip(marks, good, strict=True) if fits], doubts


def unheeded(
    marks: Sequence[PlacedMark], curves: Sequence[Array], assigned: Sequence[int], half_breadth_px: float
) -> list[str]:
    """Doubts about marks whose station got another curve than the one they lie on."""
    doubts = []
    for mark, row in zip(marks, distances_to_curves(marks, curves), strict=True):
        nearest, got = int(np.argmin(row)), assigned[mark.station]
        if got != NO_CURVE and row[got] > row[nearest] + APART * half_breadth_px:
            doubts.append(
                f"{_named(mark.mark)} lies on curve {nearest + 1} from the centre line, but the station got curve "
                f"{got + 1}: one of the two, or the list, is wrong; look at both curves in the overlay, and check "
                f"{mark.mark.half}_stations_m, this mark and those of its neighbours"
            )
    return doubts


def _named(mark: Mark) -> str:
    return f"the mark of station {mark.station_m:g} m ({mark.half} half) at px [{mark.px[0]:g}, {mark.px[1]:g}]"
