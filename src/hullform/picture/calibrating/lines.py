"""Long straight lines: the centre line, the base line, waterlines, buttocks, box lines.

Candidates of the level and of the upright family come from projections, and each is refined by itself; what belongs to
curves or to the border round the sheet is told by its slope, length and place.
"""

from __future__ import annotations

import itertools

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.projections import LARGEST_CONVERGENCE, candidates, fan_of_lines, skew_slope
from hullform.picture.calibrating.straight_line import StraightLine, refine_line
from hullform.picture.image.ink import Ink

Array = NDArray[np.float64]

SEARCH_WIDTH_PX = 1000  # the search runs on a picture of about this width
LEAST_FAMILY_LENGTH = 0.72  # of the longest lines of the family: shorter ones are pieces of curves
LARGEST_SLOPE_SPREAD = 0.0022  # between the lines of a family (0.13 deg): curves that look straight differ more
LARGEST_PULL = 0.005  # of a line's slope by curves that lie on it
PULLED_PX = 2.5  # of its place
PLACED = 1e-7  # of slope: less is that of a line that was placed
SHARE_OF_TURNED = 0.5  # of a line's length, that speaks for a parallel family it does not lie in by itself
CONVERGENCE_GAIN = 0.8  # lines more, that a convergent family must hold to be believed
SAME_LINE, SAME_LINE_PX = 1.2, 1.5  # widths and px more between two axes, up to which they are those of one line
MUCH_LONGER = 1.5  # than a neighbour: a line across both halves beside one of a single half
BORDER_TOLERANCE = 0.015  # of the picture's width: how nearly the lines of a border meet
FEWEST_INSIDE = 3  # upright lines, beside which two longer ones may be a border
BORDER_LONGER = 1.03  # than any other line of its family


def find_lines(ink: Ink) -> tuple[list[StraightLine], list[StraightLine]]:
    """The horizontal lines from top to bottom, and the vertical lines from left to right."""
    horizontal, vertical, _ = find_lines_and_border(ink)
    return horizontal, vertical


def find_lines_and_border(ink: Ink) -> tuple[list[StraightLine], list[StraightLine], list[StraightLine]]:
    """The horizontal lines from top to bottom, the vertical lines from left to right, and those round the sheet."""
    height, width = ink.shape
    shrink = max(1.0, width / SEARCH_WIDTH_PX)
    small = cv2.resize(
        cv2.dilate((ink > 0.11).astype(np.float32), np.ones((2, 2), np.uint8)),
        (round(width / shrink), round(height / shrink)),
        interpolation=cv2.INTER_AREA,
    )
    v, u = np.nonzero(small > 0.3)
    skew = skew_slope(u.astype(np.float64), v.astype(np.float64))
    families = []
    for vertical in (False, True):
        along, across = (v, u) if vertical else (u, v)
        mean = -skew if vertical else skew
        side = small.shape[0 if vertical else 1]
        found = candidates(along.astype(np.float64), across.astype(np.float64), mean, side)
        parallel = _refined(ink, [(offset, mean) for offset in found], vertical, shrink)
        fan = fan_of_lines(along.astype(np.float64), across.astype(np.float64), mean, side)
        # a camera that leaned shows lines that converge; a scanner does not, and there curves that look straight do
        size = width if vertical else height
        fanned = _refined(ink, fan, vertical, shrink)
        trend = _convergent(fanned, mean, size)
        parallel = _one_each(_levelled(ink, parallel, (mean, 0.0), size, LARGEST_SLOPE_SPREAD), 4 * shrink)
        convergent = [] if trend is None else _levelled(ink, fanned, trend, size, LARGEST_SLOPE_SPREAD / 2)
        convergent = _one_each(convergent, 4 * shrink)
        # pieces of curves and letters speak for neither. An upright line that had to be turned speaks little for its
        # family; level ones may be flats of bottom of two halves at different heights, which only look askew
        share = SHARE_OF_TURNED if vertical else 1.0
        drawn = [
            sum(
                line.length * (1.0 if _turned_little(line, slopes, size) else share)
                for line in _family(lines, 4 * shrink)
            )
            for lines, slopes in ((parallel, (mean, 0.0)), (convergent, trend or (mean, 0.0)))
        ]
        typical = float(np.median([line.length for line in convergent])) if convergent else 0.0
        families.append(convergent if drawn[1] > drawn[0] + CONVERGENCE_GAIN * typical else parallel)
    horizontal, vertical_ = _without_border(families[0], families[1], width)
    inside = [*horizontal, *vertical_]
    border = [line for family in families for line in family if line not in inside]
    return _family(horizontal, 4 * shrink), _family(vertical_, 4 * shrink), border


def _refined(ink: Ink, found: list[tuple[float, float]], vertical: bool, shrink: float) -> list[StraightLine]:
    """The lines at offsets and slopes found on the smaller picture."""
    lines = [
        refine_line(ink, offset * shrink + (shrink - 1) / 2 * (1 - slope), slope, vertical, max(3.0, 2.0 * shrink))
        for offset, slope in found
    ]
    return [line for line in lines if line is not None]


def _levelled(
    ink: Ink, lines: list[StraightLine], trend: tuple[float, float], size: float, spread: float
) -> list[StraightLine]:
    """The lines of a family; what curves that lie on a line pulled askew is placed anew along the family's slope.

    Args:
        ink: (rows, columns) map of ink.
        lines: that were found.
        trend: slope of the family at place 0, and its change up to the far side of the picture.
        size: of the picture across the family, px.
        spread: of slopes that are the family's own.
    """
    out = []
    for line in lines:
        slope = _slope_there(line, trend, size)
        turned = abs(line.slope - slope)
        if turned < spread:
            out.append(line)
        elif turned < LARGEST_PULL:
            t = 0.5 * (line.start + line.end)
            again = refine_line(ink, float(line.at(t)) - slope * t, slope, line.vertical, PULLED_PX, turns=False)
            if again is not None:
                out.append(again)
    return out


def _slope_there(line: StraightLine, trend: tuple[float, float], size: float) -> float:
    return trend[0] + trend[1] * float(line.at((line.start + line.end) / 2)) / size


def _turned_little(line: StraightLine, trend: tuple[float, float], size: float) -> bool:
    """Whether a line was found at about the slope of its family, rather than placed along it."""
    turned = abs(line.slope - _slope_there(line, trend, size))
    return PLACED < turned < LARGEST_SLOPE_SPREAD / 2


def _convergent(lines: list[StraightLine], mean: float, size: float) -> tuple[float, float] | None:
    """Slope c0 and change c1 of the largest set of lines whose slope changes evenly: c0 + c1 n; None without one."""
    if len(lines) < 3:
        return None
    place = np.array([float(line.at((line.start + line.end) / 2)) / size for line in lines])
    slope = np.array([line.slope for line in lines])
    length = np.array([line.length for line in lines])
    best: tuple[float, tuple[float, float] | None] = (0.0, None)
    for i, j in itertools.combinations(range(len(lines)), 2):
        if abs(place[i] - place[j]) < 0.1:
            continue
        change = float((slope[j] - slope[i]) / (place[j] - place[i]))
        if abs(change) > LARGEST_CONVERGENCE:
            continue
        near = np.abs(slope - slope[i] - change * (place - place[i])) < LARGEST_SLOPE_SPREAD / 2
        if length[near].sum() > best[0]:
            best = (float(length[near].sum()), (float(slope[i] - change * place[i]), change))
    return best[1]


def _without_border(
    horizontal: list[StraightLine], vertical: list[StraightLine], width: int
) -> tuple[list[StraightLine], list[StraightLine]]:
    """The lines without the border round the sheet, which may be double.

    Its upright lines are the outermost and longer than all others, the centre line included; its level lines join
    their ends. A base line goes on beyond the sides, which figures above them may seem to make longer.
    """
    tolerance = BORDER_TOLERANCE * width
    while len(vertical) > FEWEST_INSIDE:
        left, right = _outermost(vertical)
        inner = [line for line in vertical if line is not left and line is not right]
        if min(left.length, right.length) <= BORDER_LONGER * max(line.length for line in inner):
            break
        tops, feet = (_joining(horizontal, left, right, lower, tolerance) for lower in (False, True))
        if not (tops and feet):
            break
        vertical = inner
        horizontal = [line for line in horizontal if line not in tops and line not in feet]
    return horizontal, vertical


def _joining(
    levels: list[StraightLine], left: StraightLine, right: StraightLine, lower: bool, tolerance: float
) -> list[StraightLine]:
    """Level lines from the end of one upright line to that of another, their lower or their upper ends."""
    corners = []
    for upright in (left, right):
        v = upright.end if lower else upright.start
        corners.append((float(upright.at(v)), v))
    return [
        level
        for level in levels
        if all(
            abs(end - u) < tolerance and abs(float(level.at(u)) - v) < tolerance
            for end, (u, v) in zip((level.start, level.end), corners, strict=True)
        )
    ]


def _outermost(lines: list[StraightLine]) -> tuple[StraightLine, StraightLine]:
    places = [float(line.at((line.start + line.end) / 2)) for line in lines]
    return lines[int(np.argmin(places))], lines[int(np.argmax(places))]


def _family(lines: list[StraightLine], nearest: float) -> list[StraightLine]:
    """Keep the long lines, one for each place, sorted across."""
    if not lines:
        return []
    lengths = np.sort([line.length for line in _inside_border(lines)])
    longest = float(np.median(lengths[-3:]))
    return _one_each([line for line in lines if line.length >= LEAST_FAMILY_LENGTH * longest], nearest)


def _inside_border(lines: list[StraightLine]) -> list[StraightLine]:
    """The lines without the two outermost, where these are longer than all others: a border, whole or not."""
    first, last = _outermost(lines)
    inner = [line for line in lines if line is not first and line is not last]
    border = len(inner) >= FEWEST_INSIDE and (
        min(first.length, last.length) > BORDER_LONGER * max(line.length for line in inner)
    )
    return inner if border else lines


def _one_each(lines: list[StraightLine], nearest: float) -> list[StraightLine]:
    """The boldest line of each place, sorted across; a much longer one goes first."""
    kept: list[StraightLine] = []
    for line in sorted(lines, key=lambda x: float(x.at((x.start + x.end) / 2))):
        t = (line.start + line.end) / 2
        # two lines with paper between them are two, however near
        apart = min(nearest, SAME_LINE * (line.width + kept[-1].width) / 2 + SAME_LINE_PX) if kept else 0.0
        if kept and abs(float(line.at(t)) - float(kept[-1].at(t))) < apart:
            # a flat of bottom is bolder than the waterline beside it, but ends at the centre line
            longer = line.length / kept[-1].length
            bolder = line.weight * line.length > kept[-1].weight * kept[-1].length
            if longer > MUCH_LONGER or (bolder and longer > 1 / MUCH_LONGER):
                kept[-1] = line
            continue
        kept.append(line)
    return kept
