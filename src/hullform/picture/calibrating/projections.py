"""Where long straight lines may lie: places at which all ink, projected along a slope, heaps up.

A drawing turned in its picture turns both families alike, so one skew angle is found from the projections of all ink.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.straight_line import LEAST_LENGTH

Array = NDArray[np.float64]

LARGEST_SKEW_DEG = 3.0
MOST_CANDIDATES = 80  # of a family
FAN_NEAREST_PX = 3  # between candidates of different slopes, where the search runs
LARGEST_CONVERGENCE = 0.06  # change of slope of a family across the picture, where a camera leaned
CONVERGENCE_STEP = 0.002  # between the slopes at which such a family is looked for


def _projection(along: Array, across: Array, slope: float) -> NDArray[np.int64]:
    n = np.round(across - slope * along).astype(np.int64)
    return np.bincount(n - n.min())


def skew_slope(u: Array, v: Array) -> float:
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


def candidates(along: Array, across: Array, slope: float, side: int) -> list[float]:
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


def fan_of_lines(along: Array, across: Array, mean: float, side: int) -> list[tuple[float, float]]:
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
