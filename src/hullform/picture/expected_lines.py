"""Straight lines that a drawing must have where its grid and its main particulars say, and level lines that are hull.

The search for long lines keeps one line of each place. A waterline beside a flat of bottom, or a design waterline
beside a waterline of the grid, is looked for again once the scale is known.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Calibration
from hullform.picture.ink import Ink
from hullform.picture.lines import StraightLine, refine_line

Array = NDArray[np.float64]

SEARCH_PX = 2.0  # to either side of the place: a neighbour farther off does not pull the line
SAME_LINE_PX = 1.6  # between a line that is known and where one is looked for
LARGEST_SHIFT_PX = 2.5
LARGEST_TURN = 0.004
REACHES_SIDE = 0.985  # of B/2: a flat of bottom ends inside, where the bilge begins
BILGE = 0.05  # of B/2: how far beyond its end the bilge is followed
LEAST_RISE_PX = 2.0  # of the bilge over that length
DRAWN = 0.3


def expected_lines(
    ink: Ink, calibration: Calibration, places_m: Sequence[float], known: Sequence[StraightLine], vertical: bool
) -> list[StraightLine]:
    """Lines at given half-breadths (signed, vertical lines) or heights (horizontal ones) that are not known yet.

    Args:
        ink: (rows, columns) map of ink.
        calibration: of the picture.
        places_m: where they should lie.
        known: lines of the family.
        vertical: which family.
    """
    matrix = np.array(calibration.pixel_from_metres)
    size_px = ink.shape[0 if vertical else 1]
    step_m = 0.2 * size_px * calibration.metres_per_px
    found: list[StraightLine] = []
    for place in places_m:
        ends = np.array(
            [[place, 0.0, 1.0], [place, step_m, 1.0]] if vertical else [[-step_m, place, 1], [step_m, place, 1]]
        )
        (u0, v0), (u1, v1) = ((p[:2] / p[2]) for p in ends @ matrix.T)
        t0, n0, t1, n1 = (v0, u0, v1, u1) if vertical else (u0, v0, u1, v1)
        slope = float((n1 - n0) / (t1 - t0))
        middle = float(t0 + t1) / 2
        aim = float(n0 + slope * (middle - t0))
        if any(abs(float(line.at(middle)) - aim) < SAME_LINE_PX for line in (*known, *found)):
            continue
        line = refine_line(ink, float(n0 - slope * t0), slope, vertical, SEARCH_PX)
        if (
            line is None
            or abs(float(line.at(middle)) - aim) > LARGEST_SHIFT_PX
            or abs(line.slope - slope) > LARGEST_TURN
        ):
            continue
        if all(abs(float(line.at(middle)) - float(other.at(middle))) > SAME_LINE_PX for other in (*known, *found)):
            found.append(line)
    return found


def is_flat_of_bottom(line: StraightLine, ink: Ink, u0: float, half_breadth_px: float) -> bool:
    """Whether a level line is the flat bottoms of both halves: it ends short of the side and turns up into a bilge.

    Args:
        line: a horizontal line.
        ink: (rows, columns) map of ink.
        u0: of the centre line.
        half_breadth_px: B/2.
    """
    if max(u0 - line.start, line.end - u0) > REACHES_SIDE * half_breadth_px:
        return False
    return all(
        _turns_up(line, ink, end, sign, BILGE * half_breadth_px) for end, sign in ((line.start, -1), (line.end, 1))
    )


def _turns_up(line: StraightLine, ink: Ink, end: float, sign: int, reach_px: float) -> bool:
    """Whether the stroke goes on beyond an end and rises above the line, little by little."""
    columns = np.round(end + sign * np.arange(-reach_px / 2, reach_px)).astype(np.int64)
    columns = columns[(columns >= 0) & (columns < ink.shape[1])]
    rise = 0.0
    row = round(float(line.at(float(columns[0]))))
    for column in columns:
        near = np.arange(max(row - 3, 0), min(row + 2, ink.shape[0]))
        drawn = near[ink[near, column] > DRAWN]
        if not drawn.size:
            break
        # the upper part of a stroke at most: a steep one leaves the window
        row = round(float(np.average(drawn, weights=ink[drawn, column])))
        rise = float(line.at(float(column))) - row
    return rise > LEAST_RISE_PX
