"""Straight lines that a drawing must have where its grid and its main particulars say, and level lines that are hull.

The search for long lines keeps one line of each place. A waterline beside a flat of bottom, or a design waterline
beside a waterline of the grid, is looked for again once the scale is known.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Calibration
from hullform.picture.calibrating.straight_line import StraightLine, refine_line
from hullform.picture.image.ink import Ink

Array = NDArray[np.float64]

SEARCH_PX = 2.0  # to either side of the place: a neighbour farther off does not pull the line
SAME_LINE_PX = 1.6  # between a line that is known and where one is looked for
LARGEST_SHIFT_PX = 2.5
LARGEST_TURN = 0.006
AT_SIDE = 0.01  # of B/2: what goes on farther outboard of the side is a waterline
SEARCHED_FROM = 0.6  # of B/2
BILGE = 0.05  # of B/2: how far before and beyond its end the bilge is followed
LEAST_RISE_PX = 2.0  # of the bilge over that length
OUTBOARD = 1.05  # of B/2: up to where waterlines go on outboard
END_WINDOW = 0.04  # of B/2: the stretch before a line's end
MOSTLY = 0.7  # of it is drawn
FEWEST_ALIKE = 3  # waterlines that tell how bold those of a grid are
BOLDER = 1.5
FEWEST_PX_OUTBOARD = 8
WIDEST_STROKE_PX = 4.0
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
    ends = [_end_beside(line, ink, u0, sign, half_breadth_px) for sign in (-1, 1)]
    if max(ends) > (1 + AT_SIDE) * half_breadth_px:
        return False
    # a figure or a gap may hide one of the bilges
    return any(
        _turns_up(line, ink, u0, sign, min(end, half_breadth_px), half_breadth_px)
        for sign, end in zip((-1, 1), ends, strict=True)
    )


def _end_beside(line: StraightLine, ink: Ink, u0: float, sign: int, half_breadth_px: float) -> float:
    """Distance from the centre line to where a line ends on one side, its gaps and what crosses it left aside."""
    reach = np.arange(SEARCHED_FROM * half_breadth_px, OUTBOARD * half_breadth_px)
    columns = np.round(u0 + sign * reach).astype(np.int64)
    inside = (columns >= 0) & (columns < ink.shape[1])
    reach, columns = reach[inside], columns[inside]
    if not columns.size:
        return 0.0
    rows = np.round(line.at(columns.astype(np.float64)))[:, None].astype(np.int64) + np.arange(-1, 2)
    drawn = ink[np.clip(rows, 0, ink.shape[0] - 1), columns[:, None]].max(axis=1) > _visible(line)
    window = max(1, round(END_WINDOW * half_breadth_px))
    share = np.convolve(drawn, np.ones(window) / window)[: drawn.size]  # of the stretch that ends here
    last = np.flatnonzero(drawn & (share > MOSTLY))
    return float(reach[last[-1]]) if last.size else 0.0


def _visible(line: StraightLine) -> float:
    """Ink that counts as drawn: a part of the line's own, so that faint waterlines are followed to their ends."""
    return min(DRAWN, 0.4 * float(line.profile.max()))


def _turns_up(line: StraightLine, ink: Ink, u0: float, sign: int, end_px: float, half_breadth_px: float) -> bool:
    """Whether the stroke leaves the line near its end and rises above it, before it meets the side."""
    width = min(line.width, WIDEST_STROKE_PX)  # flats of both halves that nearly meet make a wide line
    last = min(end_px + BILGE * half_breadth_px, half_breadth_px - 1.5 * width)
    columns = np.round(u0 + sign * np.arange(end_px - BILGE * half_breadth_px, last)).astype(np.int64)
    columns = columns[(columns >= 0) & (columns < ink.shape[1])]
    if not columns.size:
        return False
    level = line.at(columns.astype(np.float64))
    window = int(np.ceil(width)) + 2
    row, rise = round(float(level[0])), 0.0
    for at, column in enumerate(columns.tolist()):
        near = np.arange(max(row - window, 0), min(row + window + 1, ink.shape[0]))
        seen = near[ink[near, column] > _visible(line)]
        if not seen.size:
            break
        if seen.size < near.size:  # else a line crosses
            row = round(float(np.average(seen, weights=ink[seen, column])))
        rise = float(level[at]) - row
    return rise > LEAST_RISE_PX


def drawn_alike(lines: Sequence[StraightLine], ink: Ink, u0: float, half_breadth_px: float) -> tuple[StraightLine, ...]:
    """Waterlines of a grid, all as bold as most: a flat of bottom upon one of them must not go with it.

    A line that is drawn more boldly outboard of the ship too is left as it is.

    Args:
        lines: horizontal ones of one grid.
        ink: (rows, columns) map of ink.
        u0: of the centre line.
        half_breadth_px: B/2.
    """
    if len(lines) < FEWEST_ALIKE:
        return tuple(lines)
    weights = np.array([line.weight for line in lines])
    usual = lines[int(np.argsort(weights)[(len(lines) - 1) // 2])]
    out = []
    for line in lines:
        if line.weight > BOLDER * usual.weight and _outboard(line, ink, u0, half_breadth_px) < BOLDER * usual.weight:
            line = replace(line, width=usual.width, profile=usual.profile, profile_at=usual.profile_at)
        out.append(line)
    return tuple(out)


def _outboard(line: StraightLine, ink: Ink, u0: float, half_breadth_px: float) -> float:
    """Ink across a line outboard of the ship, px; infinite where it does not reach there."""
    u = np.concatenate([u0 + sign * np.arange(1.01 * half_breadth_px, OUTBOARD * half_breadth_px) for sign in (-1, 1)])
    u = u[(u > line.start) & (u < line.end)]
    if u.size < FEWEST_PX_OUTBOARD:
        return np.inf
    v = line.at(u)[:, None] + np.arange(-4.0, 4.01, 0.5)
    across = cv2.remap(
        ink, np.repeat(u[:, None], v.shape[1], 1).astype(np.float32), v.astype(np.float32), cv2.INTER_LINEAR
    )
    return float(np.median(across.sum(axis=1))) * 0.5
