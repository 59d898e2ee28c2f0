"""The sheer line: the deck edge at side, where every station ends.

It is the topmost drawn curve that runs outward without rising much: a path over all half-breadths that gathers ink
and keeps blank paper above it, found by dynamic programming with a cost of the height climbed.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.image.ink import Ink
from hullform.picture.pieces.frame import DiagonalFrame

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

LOWEST = 0.9  # of the depth: a deck edge lies above it at every station, but where it is stepped or has much sheer
LOWEST_STEPPED = 0.42  # then nothing may be drawn above it
LONGEST_BREAK = 0.1  # of B/2: what lies inside of a longer one is another line
SHARE_DRAWN = 0.65  # of its length that must be drawn: a row of labels is not
SHARE_BLANK = 0.88  # of its length over which nothing is
FALLS = (0.0, -0.6, -1.3)  # dz/dy of a sheer line; near the side of a slender ship it falls steeply
COST_OF_PAPER = 0.35  # per px of path: what ink must exceed to be gathered
COST_OF_RISING = 0.6  # per px of height: stations rise outwards, a sheer line does so but for a short way
COST_OF_FALLING = 0.3  # a sheer of 45 degrees still pays
COST_OF_INK_ABOVE = 0.25  # per px of path, where a line lies above
RIDGE = 0.12  # smoothed ink of a hair line in grey
BOLD = 0.3  # of a station's line, above a scan's noise
BLANK_ABOVE = 0.15  # of B/2: the height over which the paper above should be blank
DEPTH_TOLERANCE = 0.015  # of the depth: the deck edge at B/2 lies at D, by the meaning of D
SHORTEST = 0.05  # of B/2: gain below which nothing was found

BELOW_SIDE = 0.1  # of the depth
SHARE_AT_DEPTH = 0.6  # of the best path's gain that one to the depth must have to be taken instead
JUMP_PX = 2.0  # between neighbouring points of the line, beyond a slope of 56 degrees
SHORTEST_RUN = 0.035  # of B/2
LAST_STRETCH = 0.04  # of B/2: where it is last seen
FALLING = -0.6  # dz/dy there of a line that goes on falling, more and more: of the slopes that are looked for


@dataclass(frozen=True, eq=False)
class SheerLine:
    """Heights z over half-breadths y, px of the drawing; constant inside of its first point.

    Attributes:
        y_px, z_px: of its points; the last lies on the line of B/2.
        seen_to_px: half-breadth to which it was seen, infinite where its last point is known by its meaning.
        falls: whether it falls steeply where it was last seen. Beyond that it falls too steeply to be seen, and the
            stations show where they end; else it is taken to go on level.
    """

    y_px: Array
    z_px: Array
    seen_to_px: float = np.inf
    falls: bool = False

    def at(self, y_px: Array | float) -> Array:
        """Height of the deck edge at a half-breadth."""
        return np.asarray(np.interp(y_px, self.y_px, self.z_px))

    def lost_at(self, y_px: float) -> bool:
        """Whether the line falls unseen at a half-breadth."""
        return self.falls and y_px > self.seen_to_px

    def range_at(self, y_px: float) -> tuple[float, float]:
        """Lowest and highest height that the line can have there: those of the known points on either side."""
        right = int(np.clip(np.searchsorted(self.y_px, y_px), 1, len(self.y_px) - 1))
        heights = self.z_px[right - 1 : right + 1]
        return float(heights.min()), float(heights.max())


def find_sheer(ink: Ink, frame: DiagonalFrame, depth_px: float, side_top_px: float | None = None) -> SheerLine | None:
    """The sheer line of one half, or None where none is drawn.

    Args:
        ink: (rows, columns) of the picture, its long straight lines taken off.
        frame: of the half.
        depth_px: depth at side.
        side_top_px: height to which the line of B/2 is drawn, or None where no station runs along it.
    """
    stepped = _sheer_above(LOWEST_STEPPED, ink, frame, depth_px, side_top_px)
    return stepped or _sheer_above(LOWEST, ink, frame, depth_px, side_top_px)


def _sheer_above(
    lowest: float, ink: Ink, frame: DiagonalFrame, depth_px: float, side_top_px: float | None
) -> SheerLine | None:
    """The sheer line at `lowest` of the depth and higher; one that lies low must have nothing above it."""
    y = np.arange(2.0, frame.half_breadth_px - 1.0)
    z = np.arange(lowest * depth_px, frame.top_px)
    if z.size < 12:
        return None
    grid_z, grid_y = np.meshgrid(z, y, indexing="ij")
    u, v = frame.to_picture(grid_y, grid_z)
    upright = cv2.remap(ink, u.astype(np.float32), v.astype(np.float32), cv2.INTER_LINEAR, borderValue=0)
    smooth = np.asarray(cv2.GaussianBlur(upright, (0, 0), 1.0), dtype=np.float32)
    # thin grey lines are weaker than the stations: what counts is that there is a ridge, not how black it is
    along = np.max([cv2.filter2D(smooth, -1, _stroke(slope)) for slope in FALLS], axis=0)
    flat = np.minimum(along / RIDGE, 1.0)
    band = round(BLANK_ABOVE * frame.half_breadth_px)
    clear = 5  # px: the line's own flank
    padded = np.vstack([smooth[clear:], np.zeros((clear, len(y)), np.float32)])
    highest = cv2.dilate(padded, np.ones((band, 1), np.uint8), anchor=(0, 0), borderType=cv2.BORDER_CONSTANT)
    above = np.minimum(highest / RIDGE, 1.0)
    gain = flat - COST_OF_PAPER - COST_OF_INK_ABOVE * above
    target = np.abs(z - depth_px) < DEPTH_TOLERANCE * depth_px
    path, total = _best_path(gain.astype(np.float64), target, SHARE_AT_DEPTH if lowest < LOWEST else 0.0)
    if path is None or total < SHORTEST * frame.half_breadth_px:
        return None
    columns, rows = path
    if lowest < LOWEST:
        columns, rows = _outermost_part(smooth, columns, rows, round(LONGEST_BREAK * frame.half_breadth_px))
    # a low one must stand out from a scan's noise
    if _drawn(smooth, columns, rows, RIDGE if lowest < LOWEST else RIDGE / 2).mean() < SHARE_DRAWN:
        return None
    if lowest < LOWEST and not _nothing_above(smooth, columns, rows, clear):
        return None
    # sub-pixel: centroid of the ink within two pixels of the path
    near = np.clip(rows[:, None] + np.arange(-2, 3), 0, len(z) - 1)
    weights = smooth[near, columns[:, None]].astype(np.float64) ** 2
    seen = smooth[rows, columns] > 0.08
    # where a station meets the line, or a label touches it, the centroid is pulled off: rather interpolate there
    flank = np.arange(3) + _half_thickness(smooth, columns, rows)
    for offset in (*-flank, *flank):
        seen &= smooth[np.clip(rows + offset, 0, len(z) - 1), columns] < 0.08
    if seen.sum() < SHORTEST * frame.half_breadth_px:
        return None
    exact = (weights * z[near]).sum(axis=1) / np.maximum(weights.sum(axis=1), 1e-9)
    at, height_px = y[columns[seen]], exact[seen]
    steady = _long_runs(at, height_px, SHORTEST_RUN * frame.half_breadth_px)
    # a deck edge falls outwards to where the side ends; what lies far below that is a flat of bottom or a waterline
    least = side_top_px - BELOW_SIDE * depth_px if lowest < LOWEST and side_top_px is not None else -np.inf
    if steady.any() and float(height_px[steady][-1]) < least:
        return None
    # amidships the deck edge lies at half the breadth and at the depth, by the meaning of both, if the side is drawn so
    # high; else the widest stations end lower than the ship's ends
    to_depth = side_top_px is not None and side_top_px > (1 - 2 * DEPTH_TOLERANCE) * depth_px
    last = depth_px if to_depth or not steady.any() else float(height_px[steady][-1])
    falls = not to_depth and _slope_at_end(at[steady], height_px[steady], frame.half_breadth_px) < FALLING
    seen_to = np.inf if to_depth or not steady.any() else float(at[steady][-1])
    points = np.append(at[steady], frame.half_breadth_px), np.append(height_px[steady], last)
    return SheerLine(*points, seen_to, falls)


def _slope_at_end(y: Array, z: Array, size: float) -> float:
    """dz/dy over the outermost stretch of a line; 0 of none."""
    stretch = LAST_STRETCH * size
    if not y.size or y[-1] - y[0] < stretch:
        return 0.0
    return float(z[-1] - np.interp(y[-1] - stretch, y, z)) / stretch


def _stroke(slope: float) -> Array:
    """A kernel that averages along a short stroke of the slope dz/dy."""
    reach = np.arange(-4, 5)
    rows = np.round(slope * reach).astype(np.int64)
    kernel = np.zeros((2 * int(np.abs(rows).max()) + 1, reach.size))
    kernel[rows + len(kernel) // 2, reach + 4] = 1 / reach.size
    return kernel


def _half_thickness(smooth: Ink, columns: Indices, rows: Indices) -> int:
    """Distance in px from the axis of a line to the paper beside it, 4 or more: at most places nothing touches it."""
    offsets = np.arange(4, 12)
    around = [smooth[np.clip(rows + sign * offsets[:, None], 0, len(smooth) - 1), columns] for sign in (-1, 1)]
    paper = np.median(np.maximum(*around), axis=1) < 0.08
    return int(offsets[int(np.argmax(paper))]) if paper.any() else 4


def _drawn(smooth: Ink, columns: Indices, rows: Indices, faintest: float) -> NDArray[np.bool_]:
    """Where along a path there is ink, within two pixels."""
    near = np.clip(rows[:, None] + np.arange(-2, 3), 0, len(smooth) - 1)
    return np.asarray(smooth[near, columns[:, None]].max(axis=1) > faintest)


def _outermost_part(smooth: Ink, columns: Indices, rows: Indices, longest_break: int) -> tuple[Indices, Indices]:
    """The part of a path outside of its last long break."""
    seen = np.flatnonzero(_drawn(smooth, columns, rows, RIDGE))
    breaks = np.flatnonzero(np.diff(seen) > longest_break)
    first = int(seen[breaks[-1] + 1]) if breaks.size else 0
    return columns[first:], rows[first:]


def _nothing_above(smooth: Ink, columns: Indices, rows: Indices, clear: int) -> bool:
    """Whether the paper above most of a path is blank, up to the top."""
    drawn = np.cumsum(smooth[::-1] > BOLD, axis=0)[::-1]  # ridges at each height and higher
    at = np.minimum(rows + clear, len(smooth) - 1)
    return float((drawn[at, columns] == 0).mean()) > SHARE_BLANK


def _long_runs(y: Array, z: Array, shortest: float) -> NDArray[np.bool_]:
    """Points of runs without a jump that are long enough: strokes of labels and leaders make short ones."""
    jumps = np.abs(np.diff(z)) > JUMP_PX + 1.5 * np.diff(y)
    run = np.concatenate([[0], np.cumsum(jumps)])
    return np.asarray(np.bincount(run)[run] >= min(shortest, len(y)))


def _best_path(
    gain: Array, target: NDArray[np.bool_], least_share: float
) -> tuple[tuple[NDArray[np.int64], NDArray[np.int64]] | None, float]:
    """The path (columns, rows) of largest gain, one row a column, that ends on the last column in a target row.

    Where it gains less than `least_share` of one that ends elsewhere, that one is taken.
    """
    rows, columns = gain.shape
    rise, fall = COST_OF_RISING * np.arange(rows), COST_OF_FALLING * np.arange(rows)
    value = np.zeros(rows)
    origins = np.full((columns, rows), -1, dtype=np.int64)
    index = np.arange(rows)
    for column in range(columns):
        up, down = value + rise, (value - fall)[::-1]
        rising = np.maximum.accumulate(up)
        falling = np.maximum.accumulate(down)[::-1]
        from_below = np.maximum.accumulate(np.where(up >= rising, index, 0))
        from_above = rows - 1 - np.maximum.accumulate(np.where(down >= falling[::-1], index, 0))[::-1]
        reached = np.maximum(rising - rise, falling + fall)
        origin = np.where(rising - rise >= falling + fall, from_below, from_above)
        origins[column] = np.where(reached > 0, origin, -1)  # a path that does not pay starts anew here
        value = np.maximum(reached, 0.0) + gain[:, column]
    row = int(np.argmax(np.where(target, value, -np.inf))) if target.any() else 0
    if least_share > 0 and (not target.any() or value[row] < least_share * value.max()):
        row = int(np.argmax(value))
    total, column = float(value[row]), columns - 1
    if total <= 0 or not (target.any() or least_share > 0):
        return None, 0.0
    path = []
    while column >= 0 and row >= 0:
        path.append((column, row))
        row = int(origins[column, row])
        column -= 1
    found = np.array(path[::-1], dtype=np.int64)
    return (found[:, 0], found[:, 1]), total
