"""Ridges of ink: sub-pixel peaks on every column of the diagonal frame, chained into tracklets.

A tracklet is a piece of curve that no junction, gap or straight line interrupts.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import median_filter

from hullform.picture.calibrating.line_mask import BOLD, HORIZONTAL, VERTICAL, Mask
from hullform.picture.image.ink import Ink
from hullform.picture.pieces.frame import DiagonalFrame

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

FAINTEST_RIDGE = 0.16  # ink of a peak after smoothing
FAINTEST_THROUGH_LINE = 0.35  # of a curve's peak where a faint line was taken off: what that left is fainter
STEEPEST = 2.2  # db/da of a ridge that is followed: tumblehome of 20 degrees
LARGEST_STEP_PX = 3.0  # across, between neighbouring columns: that slope and the noise of two peaks
LARGEST_MISS_PX = 1.3  # between a peak and where its neighbour's slope points
ALONG, ACROSS = -0.55, -0.3  # db/da beside an upright line: up to one it runs along it, from the other it crosses it
SHORTEST_PX = 5  # of a tracklet
JUNCTION_PX = 3.5  # a tracklet that ends so near another one cuts it there
BESIDE_RIBBON_PX = 1.0  # or so near the edge of the ink of that one, along which it runs
ALONG_RIBBON = 0.3  # db/da between it and that one: at a larger angle it crosses
STRETCHES = (slice(None, 12), slice(-12, None))  # points that show where a tracklet's ends head
USUAL_BOLDNESS = 35.0  # percentile of the ink across the lines that is a station's: merged ones are bolder
HOOK_PX = 1.2  # beside the continuation of its tracklet, an end that lies so far off is a hook
HAIR_LINE = 0.5  # of that: a line so thin is no station
CREST = 0.4  # of full ink, for each line width of depth
CREST_FROM = 1.9  # line widths inside a ribbon: two lines side by side are 0.9 to 1.4 deep, three 1.2 to 2.1
OFF_CENTRE, OFF_CENTRE_PX = 0.002, 1.5  # of B/2, at least: how uncertain the place of the centre line is
BELOW = 0.008  # of B/2: how far below the base line or a dome a curve may lie
WIDEST_PX = 60  # of a ribbon of merged curves, to either side of a peak


@dataclass(frozen=True, eq=False)
class Peaks:
    """Ridge peaks, sorted by column and row. `low` and `high` are the edges of the ink around them on the column."""

    column: Indices
    row: Array
    strength: Array
    slope: Array
    low: Array
    high: Array

    @property
    def width(self) -> Array:
        """Thickness of the ink across the ridge, px."""
        return np.asarray((self.high - self.low) / np.hypot(1.0, np.clip(self.slope, -STEEPEST, STEEPEST)))

    def chosen(self, which: NDArray[np.generic]) -> Peaks:
        """A part of them, by indices or by a mask."""
        return Peaks(
            *(values[which] for values in (self.column, self.row, self.strength, self.slope, self.low, self.high))
        )


Tracklet = Peaks  # one peak a column, without gaps


def line_width(ink: Ink) -> float:
    """Usual thickness of the lines of a picture, px: twice the distance from their axes to the paper."""
    drawn = (ink > 0.4).astype(np.uint8)
    depth = cv2.distanceTransform(drawn, cv2.DIST_L2, 3)
    axes = depth[(depth == cv2.dilate(depth, np.ones((3, 3), np.uint8))) & (depth > 0)]
    return float(2 * np.median(axes) - 0.5) if axes.size > 50 else 2.0


def find_peaks(ink: Ink, width_px: float) -> Peaks:
    """Local maxima of each column of the smoothed ink, placed by a parabola; slopes from the Hessian.

    Args:
        ink: (rows, columns) of the frame.
        width_px: usual thickness of a line.
    """
    sigma = float(np.clip(0.35 * width_px, 0.8, 1.4))
    crested = _crested(ink, width_px)
    smooth = cv2.GaussianBlur(crested, (0, 0), sigma)
    wide = cv2.GaussianBlur(crested, (0, 0), max(1.3, 1.4 * sigma))
    middle = smooth[1:-1]
    row, column = np.nonzero((middle > smooth[:-2]) & (middle >= smooth[2:]) & (middle > FAINTEST_RIDGE))
    order = np.lexsort((row, column))
    row, column = row[order] + 1, column[order]
    below, here, above = (smooth[row + k, column].astype(np.float64) for k in (-1, 0, 1))
    offset = 0.5 * (below - above) / (below - 2 * here + above - 1e-9)
    along2, across2, mixed = (
        cv2.Sobel(wide, cv2.CV_32F, dx, dy, ksize=3)[row, column].astype(np.float64)
        for dx, dy in ((2, 0), (0, 2), (1, 1))
    )
    # the ridge runs along the eigenvector of the weaker curvature; its normal is that of the most negative one
    strongest = 0.5 * (along2 + across2) - np.sqrt(0.25 * (along2 - across2) ** 2 + mixed**2)
    normal_row = strongest - along2
    slope = np.clip(mixed / np.where(np.abs(normal_row) < 1e-6, 1e-6, -normal_row), -2.5, 2.5)
    low, high = _ribbon(ink, column, row, here)
    return Peaks(column.astype(np.int64), row + offset, here, slope, low, high)


def _crested(ink: Ink, width_px: float) -> Ink:
    """The ink, raised along the axis of ribbons much wider than two lines, whose flat top has no ridge by itself."""
    depth = cv2.distanceTransform((ink > 0.5).astype(np.uint8), cv2.DIST_L2, 5)
    return np.asarray(ink + CREST * np.maximum(depth / width_px - CREST_FROM, 0.0), dtype=np.float32)


def _ribbon(ink: Ink, column: Indices, row: Indices, strength: Array) -> tuple[Array, Array]:
    """Where the ink around each peak falls to half, along its column, below and above."""
    half = 0.5 * np.clip(strength, 0.3, 1.0)
    edges = []
    for step in (-1, 1):
        at = np.clip(row, 1, ink.shape[0] - 2).copy()
        going = np.ones(len(at), dtype=np.bool_)
        for _ in range(WIDEST_PX):
            going &= (at > 0) & (at < ink.shape[0] - 1)
            going[going] = ink[at[going], column[going]] > half[going]
            if not going.any():
                break
            at[going] += step
        here = ink[at, column].astype(np.float64)
        before = ink[np.clip(at - step, 0, ink.shape[0] - 1), column].astype(np.float64)
        rise = before - here
        share = np.where(rise > 1e-6, (half - here) / np.maximum(rise, 1e-6), 0.5)
        edges.append(at - step * np.clip(share, 0.0, 1.0))
    return edges[0], edges[1]


def usable(peaks: Peaks, lines: Mask, beside: Mask, frame: DiagonalFrame) -> NDArray[np.bool_]:
    """Peaks inside the half and not on a straight line of the drawing.

    Those whose ridge runs along a line are kept, and those of a curve that can be seen through a faint line.

    Args:
        peaks: of the frame.
        lines: (rows, columns) where straight lines were taken off; `beside`: where they disturb a curve that runs
            at a small angle to them.
        frame: of the half.
    """
    row = np.clip(np.round(peaks.row).astype(np.int64), 0, lines.shape[0] - 1)
    lost = np.zeros(len(row), dtype=np.bool_)
    # an upright line has the slope -1 in the frame, a level one 1
    for bit, angle in ((VERTICAL, peaks.slope), (HORIZONTAL, -peaks.slope)):
        shallow = ((beside[row, peaks.column] & bit) > 0) & (angle < ACROSS)
        lost |= (((lines[row, peaks.column] & bit) > 0) | shallow) & (angle > ALONG)
    seen = ((lines[row, peaks.column] & BOLD) == 0) & (peaks.strength >= FAINTEST_THROUGH_LINE)
    y, z = frame.to_drawing(peaks.column.astype(np.float64), peaks.row)
    return np.asarray(~(lost & ~seen) & in_half(y, z, frame))


def in_half(y: Array, z: Array, frame: DiagonalFrame) -> NDArray[np.bool_]:
    """Whether places belong to a half: what lies beyond the centre line is the other half's.

    There curves run close to the centre line too, and would go on where one of this half ends on it.

    Args:
        y, z: px of the drawing.
        frame: of the half.
    """
    size = frame.half_breadth_px
    across = max(OFF_CENTRE_PX, OFF_CENTRE * size)
    return np.asarray((y >= -across) & (z - frame.bottom_px >= -BELOW * size))


def find_tracklets(peaks: Peaks) -> list[Tracklet]:
    """Chain peaks of neighbouring columns that point at each other; split chains where another one ends on them."""
    following = _following(peaks)
    preceded = np.zeros(len(following), dtype=np.bool_)
    preceded[following[following >= 0]] = True
    chains = []
    successor = following.tolist()
    for first in np.flatnonzero(~preceded).tolist():
        chain = [first]
        while successor[chain[-1]] >= 0:
            chain.append(successor[chain[-1]])
        if len(chain) >= SHORTEST_PX:
            chains.append(peaks.chosen(np.array(chain)))
    return _split_at_junctions(chains)


def without_hair_lines(tracklets: list[Tracklet], width_px: float) -> list[Tracklet]:
    """What is drawn as boldly as stations, without hooks at its ends.

    Sheer lines, diagonals, leaders and letters are often thinner by half; where a stroke ends bluntly its ridge turns
    off to a corner.

    Args:
        tracklets: of a half.
        width_px: usual thickness of a line.
    """
    if not tracklets:
        return []
    boldness = np.concatenate([t.width * np.minimum(t.strength, 1.0) for t in tracklets])
    usual = min(float(np.percentile(boldness, USUAL_BOLDNESS)), width_px)  # where many merge, most ink is bolder
    kept = []
    for t in tracklets:
        ink = t.width * np.minimum(t.strength, 1.0)
        if float(np.median(ink)) <= HAIR_LINE * usual:
            continue
        bold = np.flatnonzero(median_filter(ink, min(len(ink), 9), mode="nearest") > HAIR_LINE * usual)
        part = _without_hooks(t.chosen(np.arange(bold[0], bold[-1] + 1)), width_px)
        if len(part.column) >= SHORTEST_PX:
            kept.append(part)
    return kept


def _without_hooks(tracklet: Tracklet, width_px: float) -> Tracklet:
    """The tracklet without the last pixels at either end, where they turn off from what lies before."""
    hook = max(3, round(width_px))
    cut = [0, 0]
    for end, row in enumerate((tracklet.row, tracklet.row[::-1])):
        if len(row) < 4 * hook:
            continue
        stretch = np.arange(hook, min(len(row), 4 * hook))
        offset = float(np.polyfit(stretch, row[stretch], 1)[1])
        if abs(row[0] - offset) > HOOK_PX:
            cut[end] = hook
    return tracklet.chosen(np.arange(cut[0], len(tracklet.column) - cut[1])) if any(cut) else tracklet


def _following(peaks: Peaks) -> Indices:
    """Index of the peak on the next column that continues each peak, mutually the best; -1 where there is none."""
    span = float(peaks.row.max(initial=0.0)) + 10.0
    key = peaks.column * span + peaks.row
    lean = np.clip(peaks.slope, -STEEPEST, STEEPEST)

    def nearest(step: int) -> Indices:
        aim = (peaks.column + step) * span + np.clip(peaks.row + step * lean, 0.0, span - 1.0)
        right = np.searchsorted(key, aim)
        best = np.full(len(key), -1, dtype=np.int64)
        miss = np.full(len(key), LARGEST_MISS_PX)
        for candidate in (right - 1, right):
            index = np.clip(candidate, 0, len(key) - 1)
            gap = np.abs(key[index] - aim)
            fits = (
                (peaks.column[index] == peaks.column + step)
                & (gap < miss)
                & (np.abs(peaks.row[index] - peaks.row) <= LARGEST_STEP_PX)
            )
            best, miss = np.where(fits, index, best), np.where(fits, gap, miss)
        return best

    if len(key) == 0:
        return np.zeros(0, dtype=np.int64)
    forward, backward = nearest(1), nearest(-1)
    mutual = (forward >= 0) & (backward[np.maximum(forward, 0)] == np.arange(len(key)))
    return np.where(mutual, forward, -1)


def _split_at_junctions(chains: list[Tracklet]) -> list[Tracklet]:
    if not chains:
        return []
    first = np.array([(c.column[0], c.row[0]) for c in chains])
    last = np.array([(c.column[-1], c.row[-1]) for c in chains])
    ends = np.vstack([first, last])
    owner = np.tile(np.arange(len(chains)), 2)
    lean = np.array([np.polyfit(c.column[part], c.row[part], 1)[0] for part in STRETCHES for c in chains])
    pieces = []
    for number, chain in enumerate(chains):
        start, stop = int(chain.column[0]), int(chain.column[-1])
        near = (owner != number) & (ends[:, 0] > start + 3) & (ends[:, 0] < stop - 3)
        at = (ends[near, 0] - start).astype(np.int64)
        cuts = [0]
        beside = ends[near, 1] - chain.row[at]
        # a curve leaves a ribbon of several at its edge, wide of its axis, and at a small angle
        outer = np.where(beside > 0, chain.high[at], chain.low[at]) - chain.row[at]
        along = np.abs(lean[near] - np.gradient(chain.row)[at]) < ALONG_RIBBON
        met = np.abs(beside) < np.where(along, np.maximum(JUNCTION_PX, np.abs(outer) + BESIDE_RIBBON_PX), JUNCTION_PX)
        for cut in sorted(set(at[met].tolist())):
            if cut - cuts[-1] >= 3 and len(chain.column) - cut >= 3:
                cuts.append(cut)
        cuts.append(len(chain.column))
        pieces += [chain.chosen(np.arange(a, b)) for a, b in pairwise(cuts)]
    return pieces
