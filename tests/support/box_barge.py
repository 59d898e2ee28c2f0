"""A box barge of 80 by 12 by 8 m, whose still water has closed forms."""

from __future__ import annotations

import numpy as np

from hullform.hull import Hull

LENGTH_M, BREADTH_M, DEPTH_M = 80.0, 12.0, 8.0
# The super-ellipse nearest to a box: what its corner leaves out of a section is the same at every draught.
EXPONENT = 1e5


def box_barge(stations: int = 41) -> Hull:
    one = np.ones(stations)
    return Hull.of_super_ellipses(
        np.linspace(0.0, LENGTH_M, stations), BREADTH_M / 2 * one, DEPTH_M * one, DEPTH_M * one, EXPONENT * one,
        EXPONENT * one, LENGTH_M, LENGTH_M, 0.0, BREADTH_M, DEPTH_M, 4.0,
    )  # fmt: skip
