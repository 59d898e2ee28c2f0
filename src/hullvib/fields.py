"""How a method's mode shapes are represented: series of trial functions, or cubic Hermite elements."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from hullvib.quadrature import composite
from hullvib.trials import Trials
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


@runtime_checkable
class TurningField(Protocol):
    """A field whose sections turn by an angle of their own, as in Timoshenko's beam; else the angle is the slope."""

    def rotation(self, xi: Array, derivative: int) -> Array:
        """L times the angle of the section, or its first derivative by xi, at xi (points,), (modes, points)."""
        ...


@runtime_checkable
class LoadedField(Protocol):
    """A field that knows its bending moment and shear force; else they follow from the inertia loads."""

    def moment(self, xi: Array) -> Array:
        """Bending moment in N m at xi (points,) for the function as a deflection in metres, (modes, points)."""
        ...

    def shear(self, xi: Array) -> Array:
        """dM/dx of it in N, (modes, points); forward of a point mass where one stands, aft of it at the fore end."""
        ...


@runtime_checkable
class PiecewiseField(Protocol):
    """A field that is smooth only between nodes, (n,) on 0..1; integrals over it are broken there."""

    @property
    def nodes(self) -> Array: ...


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
class TrialSeries:
    """rigid[:, 0] + rigid[:, 1] (2 xi - 1) + sum_k elastic[:, k] w_k(xi) with any trial functions w_k."""

    trials: Trials
    rigid: Array
    elastic: Array

    @property
    def nodes(self) -> Array:
        """Where pieces of the trial functions meet, 0 and 1 among them."""
        return self.trials.nodes

    def evaluate(self, xi: Array, derivative: int) -> Array:
        values = _rigid(self.rigid, xi, derivative) + self.elastic @ self.trials.bending(xi, (derivative,))[0]
        return np.asarray(values, dtype=np.float64)

    def mean_square(self) -> Array:
        return _mean_square(self, self.trials)


@dataclass(frozen=True, eq=False)
class TimoshenkoSeries:
    """Deflection and rotation of Timoshenko's beam as series of trial functions.

    Coefficients of rigid-body motion (modes, 2), of the bending functions, whose sections stay normal to the axis
    (modes, N), and of the shear functions, whose sections do not turn (modes, N_shear).
    """

    trials: Trials
    rigid: Array
    bending: Array
    shearing: Array

    @property
    def nodes(self) -> Array:
        """Where pieces of the trial functions meet, 0 and 1 among them."""
        return self.trials.nodes

    def evaluate(self, xi: Array, derivative: int) -> Array:
        values = _rigid(self.rigid, xi, derivative) + self.bending @ self.trials.bending(xi, (derivative,))[0]
        return np.asarray(values + self.shearing @ self.trials.shearing(xi, (derivative,))[0], dtype=np.float64)

    def rotation(self, xi: Array, derivative: int) -> Array:
        order = derivative + 1
        values = _rigid(self.rigid, xi, order) + self.bending @ self.trials.bending(xi, (order,))[0]
        return np.asarray(values, dtype=np.float64)

    def mean_square(self) -> Array:
        return _mean_square(self, self.trials)


def _rigid(rigid: Array, xi: Array, derivative: int) -> Array:
    if derivative == 0:
        return np.asarray(rigid[:, :1] + rigid[:, 1:] * (2.0 * xi - 1.0), dtype=np.float64)
    return np.asarray(2.0 * rigid[:, 1:] if derivative == 1 else np.zeros((len(rigid), 1)), dtype=np.float64)


def _mean_square(field: Field, trials: Trials) -> Array:
    rule = trials.rule(np.array([0.0, 1.0]), 0)
    return np.asarray(field.evaluate(rule.xi.ravel(), 0) ** 2 @ rule.weights.ravel(), dtype=np.float64)


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


@dataclass(frozen=True, eq=False)
class ShearFlexibleElements:
    """Cubic Hermite elements with two shear functions each, w = h a (t - 3 t^2 + 2 t^3) and w = h b t (1 - t).

    values and rotations (times L) at the nodes, each (modes, n); constant and linear, a and b, (modes, n - 1): the
    shear strain (times L) is a + b (1 - 2 t). The first turns the sections by -6 a t (1 - t), the second does not.
    """

    nodes: Array
    values: Array
    rotations: Array
    constant: Array
    linear: Array

    def evaluate(self, xi: Array, derivative: int) -> Array:
        element, width, t = self._place(xi)
        shape = shear_functions(t, derivative) * width / width**derivative
        bent = HermiteElements(self.nodes, self.values, self.rotations).evaluate(xi, derivative)
        return np.asarray(bent + self.constant[:, element] * shape[0] + self.linear[:, element] * shape[1])

    def rotation(self, xi: Array, derivative: int) -> Array:
        element, width, t = self._place(xi)
        turn = -6.0 * t * (1.0 - t) if derivative == 0 else (12.0 * t - 6.0) / width
        bent = HermiteElements(self.nodes, self.values, self.rotations).evaluate(xi, derivative + 1)
        return np.asarray(bent + self.constant[:, element] * turn, dtype=np.float64)

    def mean_square(self) -> Array:
        rule = composite(self.nodes, self.nodes, 4)  # a squared cubic has degree 6
        return np.asarray(self.evaluate(rule.xi.ravel(), 0) ** 2 @ rule.weights.ravel(), dtype=np.float64)

    def _place(self, xi: Array) -> tuple[NDArray[np.intp], Array, Array]:
        element = np.clip(np.searchsorted(self.nodes, xi, side="right") - 1, 0, len(self.nodes) - 2)
        width = self.nodes[element + 1] - self.nodes[element]
        return element, width, (xi - self.nodes[element]) / width


def shear_functions(t: Array, derivative: int) -> Array:
    """t - 3 t^2 + 2 t^3 and t (1 - t), or a derivative by t, at t (points,), (2, points)."""
    rows = {
        0: (t * (1.0 - t) * (1.0 - 2.0 * t), t * (1.0 - t)),
        1: (1.0 - 6.0 * t * (1.0 - t), 1.0 - 2.0 * t),
        2: (12.0 * t - 6.0, np.full_like(t, -2.0)),
    }
    return np.stack(rows[derivative])
