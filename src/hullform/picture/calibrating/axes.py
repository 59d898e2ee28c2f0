"""The axes of a body plan among its long lines: centre line, base line, ship's side, and how the lines lean."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.expected_lines import is_flat_of_bottom
from hullform.picture.calibrating.scale import outermost_half_breadth
from hullform.picture.calibrating.straight_line import StraightLine, crossing
from hullform.picture.image.ink import Ink

Array = NDArray[np.float64]

OFF_CENTRE = 0.06  # of the horizontal lines' length: how far the centre line may lie from their middle
WHOLE_LINE = 0.75  # of the longest horizontal line: shorter ones may belong to one half
BOTH_SIDES = 0.35  # of a horizontal line's length that must lie on either side of the centre line
PAST_CENTRE = 0.05  # of the centre line's length: how far below its end the base line may lie, where a gap ends it
FEWEST_LINES = 4  # of each family, to tell how it leans
LEAST_CONVERGENCE = 0.0008  # change of slope over a family: less is how lines are pulled by curves on them


def convergence(places: Array, lines: Sequence[StraightLine]) -> float:
    """Change of a family's slopes per px, the median over pairs of lines; 0 where it is too small to matter.

    With u = k y / (1 + p y + r z) and v likewise, horizontal lines have the slopes p z and vertical ones r y, while
    k y = d / (1 - d p / k) at a distance d along the base line: p / k is the change of the horizontal lines' slopes.
    """
    if len(lines) < FEWEST_LINES:
        return 0.0
    slopes = np.array([line.slope for line in lines])
    first, second = np.triu_indices(len(lines), 1)
    apart = places[second] - places[first]
    far = np.abs(apart) > 0.2 * np.ptp(places)
    change = float(np.median((slopes[second] - slopes[first])[far] / apart[far]))
    return change if abs(change) * np.ptp(places) > LEAST_CONVERGENCE else 0.0


def mean_slope(horizontal: Sequence[StraightLine], vertical: Sequence[StraightLine]) -> float:
    """dv/du of the horizontal family, from both families: median, so that a straight ship's side does no harm."""
    slopes = [line.slope for line in horizontal] + [-line.slope for line in vertical]
    return float(np.median(slopes)) if slopes else 0.0


def centre_line(horizontal: Sequence[StraightLine], vertical: Sequence[StraightLine]) -> StraightLine | None:
    """The upright line nearest to the middle of the long level lines, bold rather than faint; None if none is near."""
    if not vertical:
        return None
    if horizontal:
        # flat bottoms are level lines too, but end at the centre line
        longest = max(line.length for line in horizontal)
        whole = [line for line in horizontal if line.length > WHOLE_LINE * longest]
        middle = float(np.median([(line.start + line.end) / 2 for line in whole]))
        breadth = float(np.median([line.length for line in whole]))
        v = float(np.median([line.at(middle) for line in horizontal]))
    else:
        v = float(np.mean([(line.start + line.end) / 2 for line in vertical]))
        ends = [float(line.at(v)) for line in vertical]
        middle, breadth = (min(ends) + max(ends)) / 2, max(ends) - min(ends)
    near = [line for line in vertical if abs(float(line.at(v)) - middle) < OFF_CENTRE * breadth]
    return min(near, key=lambda line: abs(float(line.at(v)) - middle) / (1 + line.weight), default=None)


def base_line(
    ink: Ink,
    horizontal: Sequence[StraightLine],
    centre: StraightLine | None,
    u0: float | None,
    depth_m: float,
    breadth_m: float,
    skew: float,
) -> StraightLine | None:
    """The lowest bold line of those with a whole depth of drawing above them; the lowest line where none is bold.

    The centre line reaches it: the border of a sheet or of its title block lies lower.
    """
    wide = []
    for line in horizontal:
        u = float(crossing(centre, line)[0]) if centre is not None else float(u0 or 0.0)
        if min(u - line.start, line.end - u) >= BOTH_SIDES * line.length:
            wide.append((line, u))
    if centre is not None:
        foot = centre.end + PAST_CENTRE * centre.length
        wide = [(line, u) for line, u in wide if float(line.at(u)) < foot] or wide
    if not wide:
        return None
    lowest, u = max(wide, key=lambda pair: float(pair[0].at(pair[1])))
    half_breadth = outermost_half_breadth(ink, (u, float(lowest.at(u))), skew)
    if half_breadth is not None:
        wide = [(line, u) for line, u in wide if line is lowest or not is_flat_of_bottom(line, ink, u, half_breadth)]
    drawn = np.flatnonzero((ink > 0.25).any(axis=1))
    if half_breadth is None or drawn.size == 0:
        return lowest
    depth_px = depth_m * half_breadth / (breadth_m / 2)
    deep = [line for line, u in wide if float(line.at(u)) - drawn[0] >= 0.97 * depth_px]
    boldest = max((line.weight for line in deep), default=0.0)
    bold = [line for line in deep if line.weight > 0.6 * boldest]
    return max(bold, key=lambda line: float(line.at(u)), default=lowest)


def side_px(
    ink: Ink,
    vertical: Sequence[StraightLine],
    base: StraightLine | None,
    origin: tuple[float, float],
    skew: float,
    rough_px: float,
    depth: float,
) -> float:
    """B/2 in px without a grid: from upright lines on both sides near the rough one, else the side's own axis."""
    near = []
    for sign in (-1, 1):
        distances = [
            sign * ((crossing(line, base)[0] if base else float(line.at(origin[1]))) - origin[0]) for line in vertical
        ]
        # of two that lie side by side the inner one is a station
        near += sorted(d for d in distances if abs(d - rough_px) < 6)[-1:]
    if near:
        return float(np.mean(near))
    # axis of the outermost upright ink: the centroid of the outermost run of each row, its outer twentieth
    # up to the depth, in parts of B/2: above it stand numbers
    z = np.arange(0.02, depth, 0.002) * rough_px
    reach = np.arange(-12, 6.01, 0.25)
    axes = []
    for sign in (-1, 1):
        across = sign * (rough_px + reach)
        u = (origin[0] + across[None] + z[:, None] * skew).astype(np.float32)
        v = (origin[1] + across[None] * skew - z[:, None]).astype(np.float32)
        section = np.asarray(cv2.remap(ink, u, v, cv2.INTER_LINEAR), dtype=np.float64)
        outer = np.cumsum(section[:, ::-1] > 0.25, axis=1)[:, ::-1]
        section *= (outer > 0) & (outer <= 20)
        seen = section.max(axis=1) > 0.5
        if seen.sum() >= 5:
            centroid = (section[seen] @ reach) / section[seen].sum(axis=1)
            axes.append(rough_px + float(np.percentile(centroid, 95)))
    return max(axes, default=rough_px)
