"""Fit of smooth callables by polynomial pieces of modest degree, halving pieces until the fit holds."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from hullvib import bernstein
from hullvib.errors import GirderError

Array = NDArray[np.float64]

_DEGREE = 8  # Bernstein collocation of this degree is conditioned below 1e3
_TOLERANCE = 2e-13  # of the largest value; below it, halving only collects round-off
_HALVINGS = 24
_PIECES = 1000  # callables with noise of their own would otherwise be halved for ever


def fitted_pieces(edges: Array, functions: Sequence[Callable[[float], float]]) -> tuple[Array, list[Array], float]:
    """Breaks, Bernstein coefficients per function (pieces, 9), and the largest relative residual.

    Interpolation in Chebyshev points of the first kind, which lie strictly inside; the residual is taken at points
    between them.
    """
    nodes = 0.5 - 0.5 * np.cos((np.arange(_DEGREE + 1) + 0.5) * np.pi / (_DEGREE + 1))
    # between the nodes and next to the ends
    probes = 0.5 - 0.5 * np.cos(np.clip(np.arange(_DEGREE + 2), 0.15, _DEGREE + 0.85) * np.pi / (_DEGREE + 1))
    to_bernstein = np.linalg.inv(bernstein.collocation(_DEGREE, nodes))
    check = bernstein.collocation(_DEGREE, probes)
    centres = (edges[:-1, None] + nodes * np.diff(edges)[:, None]).ravel()
    scales = [float(np.abs(_values(function, centres)).max()) or 1.0 for function in functions]

    def fit(left: float, right: float) -> tuple[list[Array], float]:
        rows, worst = [], 0.0
        for function, scale in zip(functions, scales, strict=True):
            row = to_bernstein @ _values(function, left + nodes * (right - left))
            misfit = np.abs(check @ row - _values(function, left + probes * (right - left))).max() / scale
            rows.append(row)
            worst = max(worst, float(misfit))
        return rows, worst

    breaks = [float(edges[0])]
    coefficients: list[list[Array]] = [[] for _ in functions]
    residual = 0.0
    waiting = [(float(a), float(b), 0) for a, b in itertools.pairwise(edges)][::-1]
    while waiting:
        left, right, depth = waiting.pop()
        rows, misfit = fit(left, right)
        if misfit > _TOLERANCE and depth < _HALVINGS and len(breaks) + len(waiting) < _PIECES:
            middle = 0.5 * (left + right)
            waiting += [(middle, right, depth + 1), (left, middle, depth + 1)]
            continue
        breaks.append(right)
        residual = max(residual, misfit)
        for stack, row in zip(coefficients, rows, strict=True):
            stack.append(row)
    return np.array(breaks), [np.array(stack) for stack in coefficients], residual


def _values(function: Callable[[float], float], x: Array) -> Array:
    values = np.array([float(function(float(position))) for position in x])
    wrong = np.flatnonzero(~np.isfinite(values))
    if len(wrong):
        raise GirderError(f"the function gives {values[wrong[0]]} at x = {x[wrong[0]]:g} m; it must be finite inside.")
    return values
