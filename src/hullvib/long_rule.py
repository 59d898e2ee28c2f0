"""Gauss's rule and double integration on the unit cell in extended precision, where the machine has it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from hullvib.quadrature import gauss


@dataclass(frozen=True, eq=False)
class LongOperators:
    """Gauss's rule on the unit cell and double integration, as `Operators` but in extended precision.

    nodes and weights (q,); legendre (q, q) from values at the nodes to Legendre coefficients; twice (q, q) from values
    to the double integral from 0 at the nodes.
    """

    nodes: NDArray[np.longdouble]
    weights: NDArray[np.longdouble]
    legendre: NDArray[np.longdouble]
    twice: NDArray[np.longdouble]


@lru_cache(maxsize=64)
def long_operators(points: int) -> LongOperators:
    """Nodes by Newton's method from those of double precision; weights 2 (1 - x^2) / (q P_(q-1))^2 (Abramowitz &
    Stegun 25.4.29)."""
    x: NDArray[np.longdouble] = 2.0 * gauss(points)[0].astype(np.longdouble) - 1.0
    for _ in range(2):
        basis = _long_legendre(x, points)
        x -= basis[:, points] * (1.0 - x**2) / (points * (basis[:, points - 1] - x * basis[:, points]))
    x = 0.5 * (x - x[::-1])
    basis = _long_legendre(x, points + 1)
    weights = (1.0 - x**2) / (points * basis[:, points - 1]) ** 2
    orders = np.arange(points, dtype=np.longdouble)
    legendre = basis[:, :points] * (weights[:, None] * (2.0 * orders + 1.0))
    # integration's matrix again, whose entries are not exact in double precision
    k = np.arange(1, points + 1)
    once = np.zeros((points + 1, points + 2), dtype=np.longdouble)
    once[0, :2] = 0.5
    once[k, k + 1] = 0.5 / (2.0 * k.astype(np.longdouble) + 1.0)
    once[k, k - 1] = -once[k, k + 1]
    twice = legendre @ once[:points, : points + 1] @ once @ basis.T
    return LongOperators(
        *(np.asarray(array, dtype=np.longdouble) for array in (0.5 + 0.5 * x, weights, legendre, twice))
    )


def _long_legendre(x: NDArray[np.longdouble], degree: int) -> NDArray[np.longdouble]:
    return np.asarray(np.polynomial.legendre.legvander(x, degree), dtype=np.longdouble)
