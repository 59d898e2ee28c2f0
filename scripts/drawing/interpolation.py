"""Monotone cubic interpolation of a table, for the station tables of the drawn ships."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def tangents(x: Array, y: Array) -> Array:
    """Return slopes at the breakpoints that let a cubic pass through the table without overshoot.

    Inside: s_i = (sign d_l + sign d_r) min(|d_l|, |d_r|, |p_i| / 2), with d the chords' slopes and p the parabola's;
    at the ends the parabola's slope, held between nought and twice the chord's.
    Source: M. Steffen, A simple method for monotonic interpolation in one dimension, Astron. Astrophys. 239 (1990).
    """
    h = np.diff(x)
    chord = np.diff(y) / h
    left, right = chord[:-1], chord[1:]
    parabola = (left * h[1:] + right * h[:-1]) / (h[:-1] + h[1:])
    smallest = np.minimum(np.minimum(np.abs(left), np.abs(right)), 0.5 * np.abs(parabola))
    slopes = np.empty_like(y)
    slopes[1:-1] = (np.sign(left) + np.sign(right)) * smallest
    first = chord[0] + (chord[0] - chord[1]) * h[0] / (h[0] + h[1])
    last = chord[-1] + (chord[-1] - chord[-2]) * h[-1] / (h[-1] + h[-2])
    slopes[0] = _between_nought_and(first, 2.0 * chord[0])
    slopes[-1] = _between_nought_and(last, 2.0 * chord[-1])
    return slopes


def _between_nought_and(value: float, limit: float) -> float:
    return float(np.clip(value, min(0.0, limit), max(0.0, limit)))


def interpolate(x: Array, y: Array, at: Array) -> Array:
    """Return the monotone cubic through the table (x, y) at the given places, which must lie inside it."""
    slopes = tangents(x, y)
    piece = np.clip(np.searchsorted(x, at, side="right") - 1, 0, len(x) - 2)
    h = x[piece + 1] - x[piece]
    t = (at - x[piece]) / h
    return np.asarray(
        y[piece] * (1 + 2 * t) * (1 - t) ** 2
        + slopes[piece] * h * t * (1 - t) ** 2
        + y[piece + 1] * t**2 * (3 - 2 * t)
        + slopes[piece + 1] * h * t**2 * (t - 1)
    )
