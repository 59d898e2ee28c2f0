"""Stations with two contours: which loop at the centre line belongs to which station.

A bulb that reaches forward of the stem is a closed loop below a flare that starts on the centre line higher up; a
gondola below a counter is the same aft. The loops are nested as the stations are, and the outermost loop belongs to
the station next to the ones that are still one curve.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.picture.naming.marks import FARTHEST, PlacedMark, distances_to_curves

Array = NDArray[np.float64]

NO_LOOP = -1
AT_CENTRE = 0.03  # of B/2: a curve that starts so near the centre line starts on it
OVERLAP = 0.05  # of B/2: by how much a loop may rise above the start of the contour over it


def pair_loops(
    loops: Sequence[Array],
    curves: Sequence[Array | None],
    half_breadth_px: float,
    chosen: Sequence[tuple[int, int]] = (),
    drawn: Collection[int] = (),
) -> list[int]:
    """The loop of each station, or -1.

    Args:
        loops: (n, 2) [y, z] of each, px of the drawing, innermost first.
        curves: of each station from the centre line outwards, the curve that it got, or None.
        half_breadth_px: B/2.
        chosen: (station, loop) that the user's marks say; these go before the order.
        drawn: stations whose second contour a person drew: no loop is theirs.
    """
    out = [NO_LOOP] * len(curves)
    free = list(range(len(loops)))
    for station, loop in chosen:
        if loop in free and out[station] == NO_LOOP:
            out[station] = loop
            free.remove(loop)
    waiting = [station for station in range(len(curves)) if out[station] == NO_LOOP and station not in drawn]
    for loop in free[::-1]:
        top = float(loops[loop][:, 1].max()) - OVERLAP * half_breadth_px
        two = [curve is None or _starts_above(curve, top, half_breadth_px) for curve in curves]
        # a station that was not found may be its loop alone only where none inside of it is drawn as one curve
        fits = [s for s in waiting if two[s] and (curves[s] is not None or all(two[:s]))]
        if fits:
            out[fits[-1]] = loop
            waiting = [station for station in waiting if station < fits[-1]]
    return out


def _starts_above(curve: Array, height_px: float, half_breadth_px: float) -> bool:
    """Whether a curve starts on the centre line above a height."""
    return bool(curve[0, 0] < AT_CENTRE * half_breadth_px and curve[0, 1] > height_px)


def marks_on_loops(
    marks: Sequence[PlacedMark], curves: Sequence[Array], loops: Sequence[Array], half_breadth_px: float
) -> tuple[list[PlacedMark], list[tuple[PlacedMark, int]]]:
    """The marks that lie on curves, and those that lie nearer to a loop, with that loop.

    Args:
        marks: of a half.
        curves, loops: (n, 2) [y, z] of each, px of the drawing.
        half_breadth_px: B/2.
    """
    to_curves = distances_to_curves(marks, curves).min(axis=1, initial=np.inf)
    to_loops = distances_to_curves(marks, loops)
    others, chosen = [], []
    for mark, beside, row in zip(marks, to_curves, to_loops, strict=True):
        if row.size and row.min() < min(float(beside), FARTHEST * half_breadth_px):
            chosen.append((mark, int(np.argmin(row))))
        else:
            others.append(mark)
    return others, chosen
