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
LARGEST_TURN = 0.006
REACHES_SIDE = 0.985  # of B/2: a flat of bottom ends inside, where the bilge begins
SEARCHED_FROM = 0.6  # of B/2
BILGE = 0.05  # of B/2: how far beyond its end the bilge is followed
LEAST_RISE_PX = 3.0  # of the bilge over that length
LARGEST_GAP_PX = 6  # in a line that goes on
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
    step_m = 0.2 * ink.shape[0 if vertical else 1] * calibration.metres_per_px
    found: list[StraightLine] = []
    for place in places_m:
        offset, slope, middle = _predicted(calibration, place, step_m, vertical)
        aim = offset + slope * middle
        if _nearest_px((*known, *found), middle, aim) < SAME_LINE_PX:
            continue
        line = refine_line(ink, offset, slope, vertical, SEARCH_PX)
        if line is None or abs(line.slope - slope) > LARGEST_TURN:
            continue
        at = float(line.at(middle))
        if abs(at - aim) < LARGEST_SHIFT_PX and _nearest_px((*known, *found), middle, at) > SAME_LINE_PX:
            found.append(line)
    return found


def _predicted(calibration: Calibration, place_m: float, step_m: float, vertical: bool) -> tuple[float, float, float]:
    """Offset and slope of a line in px, and the middle of the stretch over which it was predicted."""
    ends = [(place_m, 0.0), (place_m, step_m)] if vertical else [(-step_m, place_m), (step_m, place_m)]
    places = np.column_stack([np.array(ends), np.ones(2)]) @ np.array(calibration.pixel_from_metres).T
    across, along = (0, 1) if vertical else (1, 0)
    n, t = places[:, across] / places[:, 2], places[:, along] / places[:, 2]
    slope = float((n[1] - n[0]) / (t[1] - t[0]))
    return float(n[0] - slope * t[0]), slope, float(t.mean())


def _nearest_px(lines: Sequence[StraightLine], t: float, at: float) -> float:
    return min((abs(float(line.at(t)) - at) for line in lines), default=np.inf)


def is_flat_of_bottom(line: StraightLine, ink: Ink, u0: float, half_breadth_px: float) -> bool:
    """Whether a level line is the flat bottoms of both halves: it ends short of the side and turns up into a bilge.

    Args:
        line: a horizontal line.
        ink: (rows, columns) map of ink.
        u0: of the centre line.
        half_breadth_px: B/2.
    """
    return all(_turns_up(line, ink, u0, sign, half_breadth_px) for sign in (-1, 1))


def _turns_up(line: StraightLine, ink: Ink, u0: float, sign: int, half_breadth_px: float) -> bool:
    """Whether the stroke leaves the line short of the side and rises above it, little by little."""
    columns = np.round(u0 + sign * np.arange(SEARCHED_FROM * half_breadth_px, half_breadth_px)).astype(np.int64)
    columns = columns[(columns >= 0) & (columns < ink.shape[1])]
    if not columns.size:
        return False
    level = line.at(columns.astype(np.float64))
    rows = np.clip(np.round(level)[:, None].astype(np.int64) + np.arange(-1, 2), 0, ink.shape[0] - 1)
    drawn = np.flatnonzero(ink[rows, columns[:, None]].max(axis=1) > DRAWN)
    breaks = np.flatnonzero(np.diff(drawn, append=len(columns) + LARGEST_GAP_PX + 1) > LARGEST_GAP_PX)
    if not drawn.size or drawn[0] > LARGEST_GAP_PX:
        return False
    end = int(drawn[breaks[0]])
    if end > (REACHES_SIDE - SEARCHED_FROM) * half_breadth_px:
        return False
    row, rise = round(float(level[max(end - LARGEST_GAP_PX, 0)])), 0.0
    for at in range(max(end - LARGEST_GAP_PX, 0), min(end + round(BILGE * half_breadth_px), len(columns))):
        near = np.arange(max(row - 3, 0), min(row + 2, ink.shape[0]))
        seen = near[ink[near, columns[at]] > DRAWN]
        if not seen.size:
            break
        row = round(float(np.average(seen, weights=ink[seen, columns[at]])))
        rise = float(level[at]) - row
    return rise > LEAST_RISE_PX
