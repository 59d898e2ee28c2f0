"""Long straight lines: the centre line, the base line, waterlines, buttocks, box lines.

A drawing turned in its picture turns both families alike, so one skew angle is found from the projections of all
ink, and each line is then refined by itself to a few hundredths of a pixel.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.image.ink import Ink

Array = NDArray[np.float64]
Mask = NDArray[np.uint8]

LARGEST_SKEW_DEG = 3.0
SEARCH_WIDTH_PX = 1000  # the search runs on a picture of about this width
LEAST_LENGTH = 0.3  # of the picture's side: a shorter run is no candidate
MOST_CANDIDATES = 80  # of a family
FAN_NEAREST_PX = 3  # between candidates of different slopes, where the search runs
LEAST_FAMILY_LENGTH = 0.72  # of the longest lines of the family: shorter ones are pieces of curves
LARGEST_SLOPE_SPREAD = 0.0022  # between the lines of a family (0.13 deg): curves that look straight differ more
LARGEST_PULL = 0.005  # of a line's slope by curves that lie on it
PULLED_PX = 2.5  # of its place
LARGEST_CONVERGENCE = 0.06  # change of slope of a family across the picture, where a camera leaned
CONVERGENCE_STEP = 0.002  # between the slopes at which such a family is looked for
PLACED = 1e-7  # of slope: less is that of a line that was placed
SHARE_OF_TURNED = 0.5  # of a line's length, that speaks for a parallel family it does not lie in by itself
CONVERGENCE_GAIN = 0.8  # lines more, that a convergent family must hold to be believed
SAME_LINE, SAME_LINE_PX = 1.2, 1.5  # widths and px more between two axes, up to which they are those of one line
MUCH_LONGER = 1.5  # than a neighbour: a line across both halves beside one of a single half
BORDER_TOLERANCE = 0.015  # of the picture's width: how nearly the lines of a border meet
FEWEST_INSIDE = 3  # upright lines, beside which two longer ones may be a border
BORDER_LONGER = 1.03  # than any other line of its family
LEAST_DRAWN = 30.0  # percentile
VERTICAL, HORIZONTAL, BOLD = 1, 2, 4  # bits of the mask
FAINT_LINE = 0.6  # ink of a line's axis: through a fainter one the curves that cross it can be seen


@dataclass(frozen=True, eq=False)
class StraightLine:
    """A line n = offset + slope * t; t runs along the family (u for horizontal lines, v for vertical ones).

    Attributes:
        start, end: range of t, px.
        width: px between the points where the ink falls to 40 %.
        profile: median ink across the line at `profile_at` px from its axis.
    """

    vertical: bool
    offset: float
    slope: float
    start: float
    end: float
    width: float
    profile_at: Array
    profile: Array

    def at(self, t: float | Array) -> Array:
        """The position across, px."""
        return np.asarray(self.offset + self.slope * np.asarray(t, dtype=np.float64))

    @property
    def length(self) -> float:
        """px."""
        return self.end - self.start

    @property
    def weight(self) -> float:
        """Ink across the line, px: how boldly it was drawn."""
        return float(np.trapezoid(self.profile, self.profile_at))


def crossing(vertical: StraightLine, horizontal: StraightLine) -> tuple[float, float]:
    """The pixel (u, v) where a vertical and a horizontal line meet."""
    u = (vertical.offset + vertical.slope * horizontal.offset) / (1 - vertical.slope * horizontal.slope)
    return u, horizontal.offset + horizontal.slope * u


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
    skew = _skew(u.astype(np.float64), v.astype(np.float64))
    families = []
    for vertical in (False, True):
        along, across = (v, u) if vertical else (u, v)
        mean = -skew if vertical else skew
        side = small.shape[0 if vertical else 1]
        found = _candidates(along.astype(np.float64), across.astype(np.float64), mean, side)
        parallel = _refined(ink, [(offset, mean) for offset in found], vertical, shrink)
        fan = _fan(along.astype(np.float64), across.astype(np.float64), mean, side)
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


def _fan(along: Array, across: Array, mean: float, side: int) -> list[tuple[float, float]]:
    """Offsets and slopes of long lines whose slopes lie about a mean one, the one with most ink at each place."""
    reach = LARGEST_CONVERGENCE / 2
    best: list[tuple[float, float, float, float]] = []
    for slope in mean + np.arange(-reach, reach + 1e-9, CONVERGENCE_STEP):
        for offset, count in _peaks(along, across, float(slope), side):
            best.append((count, offset + slope * side / 2, offset, float(slope)))
    kept: list[tuple[float, float, float, float]] = []
    for line in sorted(best, reverse=True):
        if all(abs(line[1] - other[1]) > FAN_NEAREST_PX for other in kept):
            kept.append(line)
    return [(offset, slope) for _, _, offset, slope in kept[:MOST_CANDIDATES]]


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


def _projection(along: Array, across: Array, slope: float) -> NDArray[np.int64]:
    n = np.round(across - slope * along).astype(np.int64)
    return np.bincount(n - n.min())


def _skew(u: Array, v: Array) -> float:
    """The slope dv/du of the horizontal family at which the projections of all ink are sharpest."""
    if u.size == 0:
        return 0.0
    thin = max(1, u.size // 150_000)
    u, v = u[::thin], v[::thin]

    def sharpness(slope: float) -> float:
        # cubes favour few full bins: long lines, not the body of the curves
        return sum(
            float(np.sum(np.sort(_projection(a, n, s))[-60:].astype(np.float64) ** 3))
            for a, n, s in ((u, v, slope), (v, u, -slope))
        )

    slopes = np.tan(np.deg2rad(np.arange(-LARGEST_SKEW_DEG, LARGEST_SKEW_DEG + 0.05, 0.1)))
    best = slopes[int(np.argmax([sharpness(s) for s in slopes]))]
    near = best + np.tan(np.deg2rad(np.arange(-0.1, 0.101, 0.02)))
    return float(near[int(np.argmax([sharpness(s) for s in near]))])


def _candidates(along: Array, across: Array, slope: float, side: int) -> list[float]:
    """Offsets whose projection holds a long line's worth of ink, from the first to the last."""
    return sorted(offset for offset, _ in _peaks(along, across, slope, side)[:MOST_CANDIDATES])


def _peaks(along: Array, across: Array, slope: float, side: int) -> list[tuple[float, float]]:
    """Offsets and ink of the projection where it holds a long line's worth, each the peak of its neighbourhood."""
    n = np.round(across - slope * along).astype(np.int64)
    shift = int(n.min()) - 2 if n.size else 0
    counts = np.bincount(n - shift, minlength=3).astype(np.float64)
    counts = np.r_[counts, 0.0, 0.0]
    near = np.max([np.roll(counts, k) for k in (-2, -1, 1, 2)], axis=0)
    peaks = np.flatnonzero((counts >= near) & (counts >= 0.8 * LEAST_LENGTH * side))
    return [(float(k + shift), float(counts[k])) for k in peaks[np.argsort(-counts[peaks])]]


def _across(ink: Ink, centre: Array, t: Array, reach: Array, vertical: bool) -> Array:
    """Ink on cross-sections (len(t), len(reach)) of a line."""
    n = (centre[:, None] + reach).astype(np.float32)
    tt = np.repeat(t[:, None], len(reach), 1).astype(np.float32)
    u, v = (n, tt) if vertical else (tt, n)
    return np.asarray(cv2.remap(ink, u, v, cv2.INTER_LINEAR), dtype=np.float64)


def refine_line(
    ink: Ink, offset: float, slope: float, vertical: bool, window: float, turns: bool = True
) -> StraightLine | None:
    """Fit a line through the ink centroids of its cross-sections (robust, Tukey weights) and find its run.

    Args:
        ink: (rows, columns) map of ink.
        offset, slope: about where it lies.
        vertical: its family.
        window: how far to either side, px.
        turns: whether the slope is fitted too.

    Returns:
        the line; None where no long one is drawn there.
    """
    side = ink.shape[0 if vertical else 1]
    t = np.linspace(0, side - 1, 600)
    for reach_px in (window, max(2.5, window / 2)):
        reach = np.arange(-np.ceil(reach_px), np.ceil(reach_px) + 0.01, 0.5)
        section = _across(ink, offset + slope * t, t, reach, vertical)
        seen = section.max(axis=1) > 0.12
        if seen.sum() < LEAST_LENGTH * 0.8 * t.size:
            return None
        power = section**2
        centre = offset + slope * t + (power @ reach) / np.maximum(power.sum(axis=1), 1e-9)
        weights = seen.astype(np.float64)
        design = np.column_stack([np.ones_like(t), t])[:, : 2 if turns else 1]
        fixed = 0.0 if turns else slope * t
        for _ in range(12):
            root = np.sqrt(weights)
            fit = np.linalg.lstsq(design * root[:, None], (centre - fixed) * root, rcond=None)[0]
            residual = centre - fixed - design @ fit
            scale = 1.4826 * float(np.median(np.abs(residual[seen]))) + 0.05
            weights = seen * np.clip(1 - (residual / (4 * scale)) ** 2, 0, 1) ** 2
        offset, slope = float(fit[0]), float(fit[1]) if turns else slope
    reach = np.arange(-9, 9.01, 0.5)
    section = _across(ink, offset + slope * t, t, reach, vertical)
    middle = len(reach) // 2
    present = section[:, middle - 1 : middle + 2].max(axis=1) > 0.10
    run = _longest_run(present, largest_gap=round(0.03 * t.size))
    if run is None or present[run[0] : run[1]].mean() < 0.5:
        return None
    on_line = np.zeros_like(present)
    on_line[run[0] : run[1]] = True
    # stations run along a ship's side for a part of its height: its own ink is where least is drawn
    usual = LEAST_DRAWN if vertical else 50.0
    profile = _unimodal(np.percentile(section[present & on_line], usual, axis=0), middle)
    width = 0.5 * float(np.sum(profile > 0.4 * profile.max()))
    return StraightLine(vertical, offset, slope, float(t[run[0]]), float(t[run[1] - 1]), width, reach, profile)


def _longest_run(present: NDArray[np.bool_], largest_gap: int) -> tuple[int, int] | None:
    """[first, last + 1) of the longest run, its ends trimmed where less than half is drawn (labels)."""
    where = np.flatnonzero(present)
    if where.size < LEAST_LENGTH * 0.8 * present.size:
        return None
    runs = np.split(where, np.flatnonzero(np.diff(where) > largest_gap) + 1)
    run = max(runs, key=lambda r: int(r[-1] - r[0]))
    first, last = int(run[0]), int(run[-1]) + 1
    probe, step = 16, 4
    while last - first > 60 and present[first : first + probe].mean() < 0.6:
        first += step
    while last - first > 60 and present[last - probe : last].mean() < 0.6:
        last -= step
    return first, last


def _unimodal(profile: Array, middle: int) -> Array:
    """Cut what lies beyond the first blank on either side of the line: it belongs to a neighbour."""
    out = np.where(profile < 0.06, 0.0, profile)
    blank = np.flatnonzero(out == 0)
    left, right = blank[blank < middle], blank[blank > middle]
    if left.size:
        out[: left[-1]] = 0
    if right.size:
        out[right[0] :] = 0
    return out


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


def subtract_lines(ink: Ink, lines: list[StraightLine]) -> tuple[Ink, Mask]:
    """The ink without the lines, and a mask of where they lie (bit 1 vertical, bit 2 horizontal, bit 4 a bold one).

    Each line's own profile, a little enlarged, is taken off, so that a curve that crosses a grey line stays.
    """
    out = ink.copy()
    mask = np.zeros(ink.shape, np.uint8)
    for line in lines:
        t = np.arange(max(0, int(line.start) - 4), min(ink.shape[0 if line.vertical else 1], int(line.end) + 5))
        centre = line.at(t)
        reach = np.arange(-9, 10)
        n = np.round(centre)[:, None].astype(np.int64) + reach
        offset = n - centre[:, None]
        inside = (n >= 0) & (n < ink.shape[1 if line.vertical else 0])
        tt = np.broadcast_to(t[:, None], n.shape)
        rows, columns = (tt[inside], n[inside]) if line.vertical else (n[inside], tt[inside])
        out[rows, columns] -= (1.12 * np.interp(offset[inside], line.profile_at, line.profile)).astype(np.float32)
        covered = np.abs(offset[inside]) <= line.width / 2 + 1.2
        bold = BOLD if float(line.profile.max()) > FAINT_LINE else 0
        mask[rows[covered], columns[covered]] |= (VERTICAL if line.vertical else HORIZONTAL) | bold
    return np.clip(out, 0, 1), mask
