"""The parameters of many sections side by side, and their interpolation along the ship."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import PchipInterpolator

Array = NDArray[np.float64]

_POINTS_PER_INTERVAL = 3


class Sections(NamedTuple):
    """Super-ellipse sections, arrays (..., stations): lengths in m, top and keel above the base line."""

    half_breadth: Array
    depth: Array
    top: Array
    p: Array
    q: Array

    @property
    def keel(self) -> Array:
        """Height of the sections' lowest points above the base line, in m."""
        return self.top - self.depth

    @property
    def shape(self) -> tuple[Array, Array, Array, Array]:
        """half_breadth, depth, p, q: the arguments of the section kernels."""
        return self.half_breadth, self.depth, self.p, self.q

    def below_top(self, height: ArrayLike) -> Array:
        """Depth in m, below each section's top, of a height above the base line, held to 0..depth."""
        return np.clip(self.top - np.asarray(height, dtype=np.float64), 0.0, self.depth)


def interpolated(x: Array, sections: Sections, at: ArrayLike) -> Sections:
    """Interpolate sections given at x (stations,) to the places `at`, without overshoot.

    Half-breadth, top and keel height and the logarithms of the exponents follow monotone cubics (PCHIP; Fritsch &
    Butland 1984), so that a straight keel stays straight under any sheer.
    """
    logs = np.log(sections.p), np.log(sections.q)
    stack = np.stack(np.broadcast_arrays(sections.half_breadth, sections.top, sections.keel, *logs))
    a, top, keel, log_p, log_q = PchipInterpolator(x, stack, axis=-1)(np.asarray(at, dtype=np.float64))
    return Sections(np.maximum(a, 0.0), np.maximum(top - keel, 0.0), top, np.exp(log_p), np.exp(log_q))


def quadrature(x: Array) -> tuple[Array, Array]:
    """Return Gauss-Legendre places and weights along the ship, three in each interval between stations x."""
    node, weight = np.polynomial.legendre.leggauss(_POINTS_PER_INTERVAL)
    half_length = np.diff(x)[:, None] / 2
    middle = (x[1:] + x[:-1])[:, None] / 2
    return (middle + half_length * node).ravel(), (half_length * weight).ravel()
