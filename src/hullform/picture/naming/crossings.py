"""Neighbouring curves that cross: sections of most hulls lie inside one another, so one of the two may be misread."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from hullform.picture.pieces.frame import DiagonalFrame

Array = NDArray[np.float64]

CLEAR = 0.01  # of B/2 between two curves: more than what two readings of nearly one line differ by
LONG = 0.02  # of B/2: so long must a curve lie on the wrong side
NEAR_AXIS = 0.03  # of B/2 from centre line and base line: there many curves merge, and their order is not known


def crossing_of(inner: Array, outer: Array, frame: DiagonalFrame) -> tuple[float, float] | None:
    """[y, z] in px where the inner of two curves crosses to the outside of the outer one; None where it does not.

    Args:
        inner, outer: (n, 2) [y, z] of each, px, keel to deck; pieces that lean back are not looked at.
        frame: of their half.
    """
    size = frame.half_breadth_px
    (column_a, row_a), (column_b, row_b) = along_frame(inner, frame), along_frame(outer, frame)
    if len(column_a) < 2 or len(column_b) < 2:
        return None
    start, stop = max(column_a[0], column_b[0]), min(column_a[-1], column_b[-1])
    column = np.arange(start, stop)
    if len(column) < 2:
        return None
    apart = np.interp(column, column_b, row_b) - np.interp(column, column_a, row_a)
    y, z = frame.to_drawing(column, np.interp(column, column_a, row_a))
    inside = np.minimum(y, z) > NEAR_AXIS * size
    wrong = inside & (apart < -CLEAR * size)
    if wrong.sum() < LONG * size or (inside & (apart > CLEAR * size)).sum() < LONG * size:
        return None
    turns = np.flatnonzero(np.diff(np.sign(apart)) != 0)
    place = int(turns[np.argmin(np.abs(turns - np.flatnonzero(wrong)[0]))])
    return float(y[place]), float(z[place])


def crossings(curves: Sequence[Array], frame: DiagonalFrame) -> list[tuple[int, int, float, float]]:
    """Every pair of neighbours that cross: their numbers from the centre line outwards, and [y, z] in px."""
    found = []
    for number, (inner, outer) in enumerate(pairwise(curves)):
        place = crossing_of(inner, outer, frame)
        if place is not None:
            found.append((number, number + 1, *place))
    return found


def along_frame(curve: Array, frame: DiagonalFrame) -> tuple[Array, Array]:
    """(column, row) of the points of a curve, (n, 2) [y, z] in px, that go forward in the frame."""
    column, row = frame.from_drawing(curve[:, 0], curve[:, 1])
    forward = column >= np.maximum.accumulate(column)
    return column[forward], row[forward]
