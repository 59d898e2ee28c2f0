"""How far half-breadths lie beside fair lines along the ship."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LARGEST_UNFAIRNESS = 0.08  # of B/2: a knuckle counts as no more
MUCH_FAIRER = 0.75  # right readings get no fairer than 0.82 by another naming, wrong ones fall to 0.3 to 0.7


def unfairness(beside: Array) -> float:
    """Mean distance beside fair lines, in parts of B/2; 0 where none is known."""
    known = np.isfinite(beside)
    return float(np.minimum(beside[known], LARGEST_UNFAIRNESS).mean()) if known.any() else 0.0


def beside_fair_lines(x: Array, y: Array) -> Array:
    """(stations - 2, ...) distance of each station but the first and last from lines through its neighbours.

    The lines are straight through one neighbour to either side or cubic through two, whichever passes nearer: at a
    knuckle the first is fair, in a round bilge the second.

    Args:
        x: (stations,) strictly monotone, five or more.
        y: (stations, levels), NaN where there is none.
    """
    beside = np.abs(y[1:-1] - _through(x, y, (-1, 1), 1))
    beside[1:-1] = np.fmin(beside[1:-1], np.abs(y[2:-2] - _through(x, y, (-2, -1, 1, 2), 2)))
    return np.asarray(beside)


def _through(x: Array, y: Array, neighbours: tuple[int, ...], margin: int) -> Array:
    """Lagrange's polynomial through some neighbours of each station, at that station."""
    at = np.arange(margin, len(x) - margin)
    total = np.zeros((len(at), y.shape[1]))
    for k in neighbours:
        weight = np.ones(len(at))
        for m in neighbours:
            if m != k:
                weight *= (x[at] - x[at + m]) / (x[at + k] - x[at + m])
        total += weight[:, None] * y[at + k]
    return total
