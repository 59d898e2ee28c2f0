"""How a method's mode shapes are represented: series of uniform modes, or cubic Hermite elements."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from hullvib.quadrature import composite
from hullvib.uniform_beam import uniform_modes

Array = NDArray[np.float64]


class Field(Protocol):
    """Functions of xi = x/L on 0..1, one a mode."""

    def evaluate(self, xi: Array, derivative: int) -> Array:
        """Derivative by xi at xi (points,), (modes, points)."""
        ...

    def mean_square(self) -> Array:
        """Integral of the squares over 0..1, (modes,)."""
        ...


@dataclass(frozen=True, eq=False)
class UniformModeSeries:
    """rigid[:, 0] + rigid[:, 1] (2 xi - 1) + sum_k elastic[:, k] phi_k(xi); rigid (modes, 2), elastic (modes, N)."""

    rigid: Array
    elastic: Array

    def evaluate(self, xi: Array, derivative: int) -> Array:
        values = self.elastic @ uniform_modes(xi, self.elastic.shape[1], (derivative,))[0]
        if derivative == 0:
            values += self.rigid[:, :1] + self.rigid[:, 1:] * (2.0 * xi - 1.0)
        elif derivative == 1:
            values += 2.0 * self.rigid[:, 1:]
        return np.asarray(values, dtype=np.float64)

    def mean_square(self) -> Array:
        # the uniform modes are orthonormal and orthogonal to both rigid-body functions
        rigid = self.rigid[:, 0] ** 2 + self.rigid[:, 1] ** 2 / 3.0
        return np.asarray(rigid + (self.elastic**2).sum(axis=1), dtype=np.float64)


@dataclass(frozen=True, eq=False)
class HermiteElements:
    """Cubic Hermite interpolation between nodes (n,); values and slopes (by xi) at the nodes, each (modes, n)."""

    nodes: Array
    values: Array
    slopes: Array

    def evaluate(self, xi: Array, derivative: int) -> Array:
        element = np.clip(np.searchsorted(self.nodes, xi, side="right") - 1, 0, len(self.nodes) - 2)
        width = self.nodes[element + 1] - self.nodes[element]
        shape = hermite((xi - self.nodes[element]) / width, derivative) / width**derivative
        return np.asarray(
            self.values[:, element] * shape[0]
            + self.slopes[:, element] * (width * shape[1])
            + self.values[:, element + 1] * shape[2]
            + self.slopes[:, element + 1] * (width * shape[3]),
            dtype=np.float64,
        )

    def mean_square(self) -> Array:
        rule = composite(self.nodes, self.nodes, 4)  # a squared cubic has degree 6
        return np.asarray(self.evaluate(rule.xi.ravel(), 0) ** 2 @ rule.weights.ravel(), dtype=np.float64)


def hermite(t: Array, derivative: int) -> Array:
    """The four cubic Hermite shape functions (w0, w0', w1, w1') or a derivative by t at t (points,), (4, points)."""
    one = np.ones_like(t)
    rows = {
        0: (
            (1.0 + 2.0 * t) * (1.0 - t) ** 2,
            t * (1.0 - t) ** 2,
            t**2 * (3.0 - 2.0 * t),
            t**2 * (t - 1.0),
        ),
        1: (6.0 * t * (t - 1.0), (1.0 - t) * (1.0 - 3.0 * t), 6.0 * t * (1.0 - t), t * (3.0 * t - 2.0)),
        2: (12.0 * t - 6.0, 6.0 * t - 4.0, 6.0 - 12.0 * t, 6.0 * t - 2.0),
        3: (12.0 * one, 6.0 * one, -12.0 * one, 6.0 * one),
    }
    return np.stack(rows[derivative])
