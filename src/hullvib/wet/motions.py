"""How a girder moves the hull about her: heave, pitch and her dry elastic modes, and mixtures of them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError
from hullvib.fields import PiecewiseField
from hullvib.forces import section_rotation
from hullvib.modes import Modes
from hullvib.quadrature import composite

Array = NDArray[np.float64]

RIGID = 2
"""Heave and pitch stand first."""
_SLACK = 1e-6  # of the length: what the hull may reach beyond the girder


class Motions(Protocol):
    """Vertical motions of a hull whose sections keep their shape: what a flow asks of them."""

    @property
    def ranks(self) -> NDArray[np.intp]:
        """(n,) 1 for heave, 2 for pitch, 3 for the shape of two nodes, and so on."""
        ...

    def deflections(self, x_m: Array) -> Array:
        """Upward deflections (n, points) at x (points,) in m."""
        ...

    def angles(self, x_m: Array) -> Array:
        """Angles of the sections, bow up, in rad per metre of the deflection, (n, points)."""
        ...


@dataclass(frozen=True, eq=False)
class MixedField:
    """Mixtures of heave 1, pitch 2 x / L - 1 and a girder's dry elastic modes; a field as `hullvib.fields` has them.

    coefficients (n, 2 + modes) multiply them, the modes in the normalisation that they have. Moments and shear forces
    are the dry modes', mixed: EI psi' and -kGA (w' - psi) of the mixture.
    """

    dry: Modes
    coefficients: Array

    @property
    def nodes(self) -> Array:
        """Where pieces of the dry modes meet, 0 and 1 among them."""
        field = self.dry.field
        return field.nodes if isinstance(field, PiecewiseField) else np.array([0.0, 1.0])

    def evaluate(self, xi: Array, derivative: int) -> Array:
        """Derivative by xi at xi (points,), (n, points)."""
        elastic = self.dry.scale[:, None] * self.dry.field.evaluate(xi, derivative)
        return self._rigid(xi, derivative) + self._elastic @ elastic

    def rotation(self, xi: Array, derivative: int) -> Array:
        """L times the angle of the sections, or its derivative by xi, (n, points)."""
        elastic = self.dry.scale[:, None] * section_rotation(self.dry.field, xi, derivative)
        return self._rigid(xi, derivative + 1) + self._elastic @ elastic

    def moment(self, xi: Array) -> Array:
        """Bending moment in N m for the functions as deflections in metres, (n, points)."""
        return np.asarray(self._elastic @ self.dry.moment(xi * self.dry.girder.length), dtype=np.float64)

    def shear(self, xi: Array) -> Array:
        """Shear force in N, (n, points)."""
        return np.asarray(self._elastic @ self.dry.shear(xi * self.dry.girder.length), dtype=np.float64)

    def mean_square(self) -> Array:
        """Integral of the squares over 0..1, (n,)."""
        bays = 4 * (len(self.dry.scale) + RIGID)
        edges = np.unique(np.concatenate([self.nodes, np.linspace(0.0, 1.0, bays + 1)]))
        rule = composite(np.array([0.0, 1.0]), edges, 8)
        return np.asarray(self.evaluate(rule.xi.ravel(), 0) ** 2 @ rule.weights.ravel(), dtype=np.float64)

    @property
    def _elastic(self) -> Array:
        return self.coefficients[:, RIGID:]

    def _rigid(self, xi: Array, derivative: int) -> Array:
        heave, pitch = self.coefficients[:, :1], self.coefficients[:, 1:RIGID]
        if derivative == 0:
            return np.asarray(heave + pitch * (2.0 * xi - 1.0), dtype=np.float64)
        return np.asarray(2.0 * pitch if derivative == 1 else np.zeros_like(pitch), dtype=np.float64)


@dataclass(frozen=True, eq=False)
class GirderMotions:
    """Heave 1, pitch 2 x / L - 1 and the dry elastic modes of a girder: the functions that wet modes are made of."""

    dry: Modes

    @property
    def ranks(self) -> NDArray[np.intp]:
        return np.arange(1, len(self.dry.scale) + RIGID + 1)

    @cached_property
    def field(self) -> MixedField:
        """The functions themselves."""
        return MixedField(self.dry, np.eye(len(self.dry.scale) + RIGID))

    def deflections(self, x_m: ArrayLike) -> Array:
        return self.field.evaluate(self._places(x_m), 0)

    def angles(self, x_m: ArrayLike) -> Array:
        xi = self._places(x_m)
        turn = np.broadcast_to(self.field.rotation(xi, 0), (len(self.ranks), len(xi)))
        return np.asarray(turn / self.dry.girder.length, dtype=np.float64)

    def _places(self, x_m: ArrayLike) -> Array:
        length = self.dry.girder.length
        xi = np.asarray(x_m, dtype=np.float64) / length
        if xi.size and not bool(((xi >= -_SLACK) & (xi <= 1.0 + _SLACK)).all()):
            raise ArgumentError(
                f"the hull reaches from x = {xi.min() * length:g} m to {xi.max() * length:g} m, the girder from 0 to "
                f"{length:g} m; both count x from the girder's aft end."
            )
        return np.clip(xi, 0.0, 1.0)
