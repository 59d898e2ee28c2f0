"""Gauss-Legendre integration, piece by piece, so that no rule ever straddles a jump."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from hullvib import bernstein

Array = NDArray[np.float64]


@lru_cache(maxsize=64)
def gauss(points: int) -> tuple[Array, Array]:
    """Nodes and weights of the Gauss-Legendre rule on 0..1, each (points,)."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    nodes, weights = 0.5 + 0.5 * nodes, 0.5 * weights
    nodes.flags.writeable = weights.flags.writeable = False
    return nodes, weights


@dataclass(frozen=True, eq=False)
class Quadrature:
    """Points of a composite rule on 0..1 and what is needed to evaluate a girder's pieces there.

    xi and weights (cells, points); piece (cells,) is the piece of the girder that holds a cell, t (cells, points)
    the position within that piece, 0..1; edges (cells + 1,).
    """

    edges: Array
    xi: Array
    weights: Array
    piece: NDArray[np.intp]
    t: Array

    def of(self, coefficients: Array) -> Array:
        """Values of a property, Bernstein coefficients (pieces, n + 1), at the points, (cells * points,)."""
        return bernstein.evaluate(coefficients[self.piece][:, None, :], self.t).ravel()


def composite(breaks: Array, edges: Array, points: int) -> Quadrature:
    """Rule of `points` points on every cell of edges (cells + 1,); each cell lies in one piece of breaks, both 0..1."""
    nodes, weights = gauss(points)
    widths = np.diff(edges)
    xi = edges[:-1, None] + widths[:, None] * nodes
    middle = 0.5 * (edges[:-1] + edges[1:])
    piece = np.clip(np.searchsorted(breaks, middle, side="right") - 1, 0, len(breaks) - 2)
    left = breaks[piece][:, None]
    t = np.clip((xi - left) / (breaks[piece + 1][:, None] - left), 0.0, 1.0)
    return Quadrature(edges, xi, widths[:, None] * weights, piece, t)


def for_waves(breaks: Array, wave_number: float, degree: int) -> Quadrature:
    """Rule that integrates polynomial pieces of `degree` times products of two waves of `wave_number`, to round-off.

    Long pieces are cut into cells of at most 1.5 rad. Over a cell the product has the phase p = 2 k h; q Gauss points
    leave the relative error p^(2q) (q!)^4 / ((2q + 1) (2q)!^3) (Abramowitz & Stegun 25.4.30).
    """
    widths = np.diff(breaks)
    parts = np.maximum(np.ceil(widths * wave_number / 1.5), 1.0).astype(np.intp)
    edges = np.append(_subdivided(breaks, parts), 1.0)
    phase = 2.0 * wave_number * float((widths / parts).max())
    points, error = 1, phase**2 / 24.0
    while error > 1e-16:
        points += 1
        q = float(points)
        # the ratio of the error's neighbours: (q!)^4 / (2q)!^3 grows by q^4 / (2q (2q - 1))^3
        error *= phase**2 * q**4 / (2.0 * q * (2.0 * q - 1.0)) ** 3 * (2.0 * q - 1.0) / (2.0 * q + 1.0)
    return composite(breaks, edges, points + (degree + 1) // 2)


def _subdivided(breaks: Array, parts: NDArray[np.intp]) -> Array:
    """Left edges of the cells when piece i is cut into parts[i] equal cells."""
    piece = np.repeat(np.arange(len(parts)), parts)
    within = np.arange(len(piece)) - np.repeat(np.cumsum(parts) - parts, parts)
    return np.asarray(breaks[piece] + (np.diff(breaks) / parts)[piece] * within, dtype=np.float64)
