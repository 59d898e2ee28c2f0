"""Polynomials on the unit interval in Bernstein form.

p(t) = sum_i c_i B_i(t), B_i(t) = binom(n, i) t^i (1 - t)^(n - i), 0 <= t <= 1. The extreme coefficients bound the
polynomial, a straight line has its two end values as coefficients, and cutting the interval is exact up to
round-off (G. Farin, Curves and Surfaces for CAGD, 5th ed., chapters 4-6). The last axis holds the coefficients.
"""

from __future__ import annotations

import itertools
from math import comb

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def evaluate(coefficients: Array, t: Array) -> Array:
    """Value at t by de Casteljau's scheme, coefficients (..., n + 1) against t (...), broadcast."""
    degree = coefficients.shape[-1] - 1
    columns = [coefficients[..., i] for i in range(degree + 1)]
    if degree == 0:
        return np.asarray(columns[0] + 0.0 * t, dtype=np.float64)
    rest = 1.0 - t
    for _ in range(degree):
        columns = [left * rest + right * t for left, right in itertools.pairwise(columns)]
    return np.asarray(columns[0], dtype=np.float64)


def split(coefficients: Array, t: float) -> tuple[Array, Array]:
    """Coefficients of the parts over [0, t] and [t, 1], each on its own unit interval."""
    row = coefficients.astype(np.float64)
    left, right = [row[..., 0]], [row[..., -1]]
    while row.shape[-1] > 1:
        row = row[..., :-1] * (1.0 - t) + row[..., 1:] * t
        left.append(row[..., 0])
        right.append(row[..., -1])
    return np.stack(left, axis=-1), np.stack(right[::-1], axis=-1)


def integral(coefficients: Array) -> Array:
    """Integral over the unit interval: the mean of the coefficients."""
    return np.asarray(coefficients.mean(axis=-1), dtype=np.float64)


def first_moment(coefficients: Array) -> Array:
    """Integral of t p(t) over the unit interval: sum_i c_i (i + 1) / ((n + 1)(n + 2))."""
    size = coefficients.shape[-1]
    return np.asarray(coefficients @ (np.arange(1.0, size + 1.0) / (size * (size + 1))), dtype=np.float64)


def from_power(coefficients: Array, widths: Array) -> Array:
    """Bernstein form of sum_k a_k s^k on 0 <= s <= width; coefficients (pieces, n + 1), widths (pieces,)."""
    size = coefficients.shape[-1]
    # t^k = sum_i binom(i, k) / binom(n, k) B_i(t)
    change = np.array([[comb(i, k) / comb(size - 1, k) for i in range(size)] for k in range(size)])
    scaled = coefficients * widths[..., None] ** np.arange(size)
    return np.asarray(scaled @ change, dtype=np.float64)


def collocation(degree: int, t: Array) -> Array:
    """Matrix of the basis polynomials at t, (len(t), degree + 1)."""
    i = np.arange(degree + 1)
    binomials = np.array([float(comb(degree, k)) for k in range(degree + 1)])
    column = t[:, None]
    return np.asarray(binomials * column**i * (1.0 - column) ** (degree - i), dtype=np.float64)


def minimum(coefficients: Array) -> tuple[float, float]:
    """Smallest value of one polynomial over the closed unit interval, and its t; coefficients (n + 1,)."""
    size = len(coefficients)
    candidates = np.array([0.0, 1.0])
    if size > 2:
        # Chebyshev points, at least eight per degree, then Newton-free refinement by two zooms: the answer decides
        # between "negative" and "not negative" only, and it is quoted in a message
        candidates = 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, 8 * size + 1))
        for _ in range(2):
            values = evaluate(coefficients, candidates)
            best = int(values.argmin())
            low, high = candidates[max(best - 1, 0)], candidates[min(best + 1, len(candidates) - 1)]
            candidates = np.union1d(candidates[[0, best, -1]], np.linspace(low, high, 65))
    values = evaluate(coefficients, candidates)
    best = int(values.argmin())
    return float(values[best]), float(candidates[best])
