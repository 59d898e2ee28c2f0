"""Where in a list a station is missing: the places at which one more makes the waterlines of the half fair."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hullform.picture.checking.crosschecks import LEAST_GAIN, LEVELS, half_breadths
from hullform.picture.naming.fair_lines import MUCH_FAIRER, beside_fair_lines, unfairness
from hullform.picture.naming.named_half import NamedHalf

Array = NDArray[np.float64]

FEWEST_CURVES = 6
BETWEEN = 0.5  # of a spacing: where the missing station is supposed


def where_missing(half: NamedHalf, draught_m: float) -> str:
    """Between which stations one is missing from the list of a half, in words; empty where nothing tells.

    Args:
        half: which shows one curve more than stations are listed.
        draught_m: to which waterlines are looked at.
    """
    listed, curves = half.inner_first, half.reading.curves
    if half.reading.unlisted != 1 or len(curves) != len(listed) + 1 or len(curves) < FEWEST_CURVES:
        return ""
    frame = half.reading.frame
    levels = np.array(LEVELS) * draught_m / frame.metres_per_px
    y = np.array([half_breadths(curve[:, 0], curve[:, 1], levels) for curve in curves]) / frame.half_breadth_px
    unfair = []
    for k in range(len(listed) - 1):
        x = np.insert(np.array(listed), k + 1, listed[k] + BETWEEN * (listed[k + 1] - listed[k]))
        unfair.append(unfairness(beside_fair_lines(x, y)))
    fairest = min(unfair)
    places = [k for k, value in enumerate(unfair) if value < max(fairest / MUCH_FAIRER, fairest + LEAST_GAIN)]
    if len(places) == len(unfair):
        return ""
    low, high = sorted((listed[places[0]], listed[places[-1] + 1]))
    return (
        f", by the fairness of the waterlines between {half.names.several([low, high])}: check the list there, or mark "
        "a point of each of its stations"
    )
