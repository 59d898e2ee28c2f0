"""Two super-ellipses, one upon the other: a section with a knuckle, or a full bottom below a flare."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hullform.errors import HullError
from hullform.hull.fitting import fit_super_ellipse
from hullform.hull.outlines import corners_of

Array = NDArray[np.float64]

# Of the depth: where they may meet; and of the breadth: an upper one that grows outwards by less is a straight line.
_LOWEST, _HIGHEST = 0.06, 0.94
_LEAST_GROWTH = 0.005
_MOST_TRIES = 2


def stacked_super_ellipses(points: Array, breadth_m: float, draught_m: float, count: int) -> Array | None:
    """Points (about count, 2) along two stacked super-ellipses fitted to a section (k, 2) whose height increases.

    The lower one ends at a joint (y, z) of the traced curve; the upper one is y plus a super-ellipse from there to the
    deck, or straight where it hardly grows. The joint is tried at the section's corners, or at the waterline where it
    has none. None where there is no room for two.
    """
    keel, top = float(points[0, 1]), float(points[-1, 1])
    share = (points[:, 1] - keel) / (top - keel)
    corners = [int(n) for n in corners_of(points, breadth_m) if _LOWEST < share[n] < _HIGHEST]
    waterline = int(np.argmin(np.abs(points[:, 1] - draught_m)))
    joints = corners[:_MOST_TRIES] or ([waterline] if _LOWEST < share[waterline] < _HIGHEST else [])
    tries = [found for joint in joints if (found := _stacked_at(points, joint, breadth_m, count)) is not None]
    return min(tries, key=lambda found: found[0])[1] if tries else None


def _stacked_at(points: Array, joint: int, breadth_m: float, count: int) -> tuple[float, Array] | None:
    lower, upper = points[: joint + 1], points[joint:] - [points[joint, 0], 0.0]
    if upper[:, 0].min() < -_LEAST_GROWTH * breadth_m:
        return None
    try:
        below = fit_super_ellipse(lower)
        curve, miss = below.points(count // 2), below.rms_m
        if upper[:, 0].max() < _LEAST_GROWTH * breadth_m:
            return miss, np.concatenate([curve, points[-1:]])
        above = fit_super_ellipse(upper)
    except HullError:
        return None
    higher = above.points(count // 2) + np.array([curve[-1, 0], 0.0])
    # the two ends at the joint are each its own fit's: nothing of the upper one hangs below it
    return miss + above.rms_m, np.concatenate([curve, higher[higher[:, 1] > curve[-1, 1]]])
