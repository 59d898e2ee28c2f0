"""A fair curve through a traced contour that keeps its corners: smoothing cubic B-splines between them."""

from __future__ import annotations

import itertools
import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline, splprep

from hullform.hull.outlines import arc_along, corners_of, resampled

Array = NDArray[np.float64]

# Root mean square by which the spline may leave the trace, as a share of the breadth: a pen's width in a drawing.
_PEN = 2e-4
_END_WEIGHT = 1e3  # of a piece's ends over its other points: corners stay where they are
_MOST_POINTS = 220  # of a piece that the spline sees
_DRAWN_STEP = 0.004  # of the breadth, between points of the drawn curve
_FEWEST, _MOST_DRAWN = 5, 160


def fair_curve(points: Array, breadth_m: float) -> Array:
    """Points (n, 2) along a corner-aware B-spline through a traced contour (k, 2), m; its ends and corners are kept.

    Between corners a parametric cubic spline smooths by a pen's width, 0.02 % of the breadth (Dierckx 1993, ch. 2);
    pieces of too few points stay as they are.
    """
    bounds = [0, *corners_of(points, breadth_m).tolist(), len(points) - 1]
    pieces = [_fair_piece(points[start : end + 1], breadth_m) for start, end in itertools.pairwise(bounds)]
    whole = np.concatenate([pieces[0], *(piece[1:] for piece in pieces[1:])])
    return np.asarray(np.maximum(whole, [0.0, -np.inf]))


def _fair_piece(piece: Array, breadth_m: float) -> Array:
    if len(piece) < 5:
        return piece
    seen = piece if len(piece) <= _MOST_POINTS else resampled(piece, _MOST_POINTS)
    arc = arc_along(seen)
    weight = np.ones(len(seen))
    weight[[0, -1]] = _END_WEIGHT
    smoothing = len(seen) * (_PEN * breadth_m) ** 2
    with warnings.catch_warnings():
        # stopped short of the sum of squares that is asked for, the spline is good all the same: how far it lies from
        # the trace is measured, as of every model
        warnings.filterwarnings("ignore", "The maximal number of iterations", RuntimeWarning)
        spline: Any = splprep(seen.T, w=weight, u=arc / arc[-1], s=smoothing, k=3, quiet=1)[0]
    knots, coefficients, degree = spline
    count = int(np.clip(arc[-1] / (_DRAWN_STEP * breadth_m), _FEWEST, _MOST_DRAWN))
    drawn = BSpline(knots, np.stack(coefficients, axis=-1), degree)(np.linspace(0.0, 1.0, count))
    drawn[[0, -1]] = piece[[0, -1]]
    return np.asarray(drawn, dtype=np.float64)
