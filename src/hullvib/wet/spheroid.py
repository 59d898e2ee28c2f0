"""The half-submerged prolate spheroid: the one body whose three-dimensional added mass is known in closed form.

The potential of the vertical motion w(mu), mu = 2 x / L from -1 to 1, is a series in P_n^1(mu) Q_n^1(zeta) on
zeta = L / sqrt(L^2 - B^2) (H. Lamb, Hydrodynamics, art. 105-107); a motion w = P_n'(mu) is a term of its own. With
u = Q_n'(zeta) / Q_n(zeta) its factor on the strips' added mass is J_n = -zeta u / (n (n + 1) - zeta u): n = 1 heave,
2 pitch, 3 the two-node shape, 4 the three-node one. F. M. Lewis tabled it (Trans. SNAME 37 (1929) 1-20). J. L. Taylor's
lower figures (Trans. INA 72 (1930) 162-196) hold the turning of the sections too, which moves them lengthwise.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from hullvib.errors import ArgumentError
from hullvib.sea import SEA_WATER_KG_M3

Array = NDArray[np.float64]

_MARGIN = 40.0  # natural logarithm by which the recursion's start is forgotten


def sliding_factors(length_over_breadth: float, count: int) -> Array:
    """J_1 .. J_count of a prolate spheroid whose sections slide up and down without turning, (count,).

    Raises ArgumentError for a length not above the breadth.
    """
    zeta = _zeta(length_over_breadth)
    n = np.arange(1, count + 1)
    size = zeta * (zeta - 1.0 / _ratios(zeta, count)) / (zeta**2 - 1.0) * n
    return np.asarray(-size / (n * (n + 1) - size), dtype=np.float64)


def bending_factors(length_over_breadth: float, count: int) -> Array:
    """The same with sections that turn by the slope: added mass of w = P_n'(mu) over the strips', (count,)."""
    mu, weights = legendre.leggauss(count + 4)
    out = np.empty(count)
    for n in range(1, count + 1):
        shape = legendre.legder([0.0] * n + [1.0])
        w, slope = legendre.legval(mu, shape), legendre.legval(mu, legendre.legder(shape))
        moving = w - mu * slope / length_over_breadth**2
        strips = float(weights @ ((1.0 - mu**2) * w**2))
        out[n - 1] = _series(moving[None], mu, weights, sliding_factors(length_over_breadth, n))[0, 0] / strips
    return out


def spheroid_added_mass(
    motions: Callable[[Array], tuple[Array, Array]],
    length_m: float,
    breadth_m: float,
    density_kg_m3: float = SEA_WATER_KG_M3,
    terms: int = 40,
    points: int = 200,
) -> Array:
    """Exact added mass (n, n) in kg of a half-submerged prolate spheroid for n motions.

    motions(mu) gives the deflections and the sections' angles times half the length, each (n, points), at mu = -1 aft
    to 1 forward, turning about the axis in the waterline. Raises ArgumentError.
    """
    mu, weights = legendre.leggauss(points)
    deflections, angles = motions(mu)
    moving = deflections - mu * angles * (breadth_m / length_m) ** 2
    factors = sliding_factors(length_m / breadth_m, terms)
    strip = 0.5 * np.pi * density_kg_m3 * (0.5 * breadth_m) ** 2 * (0.5 * length_m)
    return strip * _series(moving, mu, weights, factors)


def _series(moving: Array, mu: Array, weights: Array, factors: Array) -> Array:
    """sum_n J_n f_jn f_kn |P_n^1|^2, with the coefficients of the motions in P_n'(mu)."""
    out = np.zeros((len(moving), len(moving)))
    across = weights * (1.0 - mu**2)
    for n, factor in enumerate(factors, 1):
        shape = legendre.legval(mu, legendre.legder([0.0] * n + [1.0]))
        # int (1 - mu^2) P_n'^2 dmu = 2 n (n + 1) / (2 n + 1)
        part = moving @ (across * shape)
        out += factor * np.outer(part, part) * (2 * n + 1) / (2.0 * n * (n + 1))
    return out


def _zeta(length_over_breadth: float) -> float:
    if not length_over_breadth > 1.0:
        raise ArgumentError(
            f"length over breadth is {length_over_breadth:g}; the spheroid's factors are for hulls longer than broad."
        )
    return float(1.0 / np.sqrt(1.0 - length_over_breadth**-2.0))


def _ratios(zeta: float, count: int) -> Array:
    """Q_n / Q_(n-1) for n = 1 .. count, downwards, in which direction the recursion is stable."""
    step = np.log(zeta + np.sqrt(zeta**2 - 1.0))
    start = count + int(np.ceil(_MARGIN / (2.0 * step)))
    ratio = float(np.exp(-step))
    out = np.empty(count)
    for n in range(start, 0, -1):
        ratio = n / ((2 * n + 1) * zeta - (n + 1) * ratio)
        if n <= count:
            out[n - 1] = ratio
    return out
