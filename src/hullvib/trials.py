"""Trial functions of the Ritz methods, under one interface, and the uniform beam's modes as such.

Two kinds serve Timoshenko's beam. Bending functions w_k turn each section by w_k', shear functions turn none, so their
slope is the shear strain. Both in xi = x/L; rigid-body motion comes on top of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from hullvib.quadrature import Quadrature, for_waves
from hullvib.uniform_beam import frequency_parameters, uniform_modes

Array = NDArray[np.float64]


class Trials(Protocol):
    """A set of elastic trial functions, scaled so that their stiffness matrix is near the unit matrix."""

    @property
    def nodes(self) -> Array:
        """Positions between which the functions are smooth, 0 and 1 among them."""
        ...

    @property
    def sizes(self) -> tuple[int, int]:
        """Numbers of bending and of shear functions."""
        ...

    def bending(self, xi: Array, orders: Sequence[int]) -> Array:
        """Derivatives, of orders 0 to 3, of the bending functions, (len(orders), N, points)."""
        ...

    def shearing(self, xi: Array, orders: Sequence[int]) -> Array:
        """Derivatives, of orders 0 to 2, of the shear functions, (len(orders), N_shear, points)."""
        ...

    def rule(self, breaks: Array, degree: int) -> Quadrature:
        """Integrates products of two of the functions and a property of `degree` between breaks, to round-off."""
        ...


@dataclass(frozen=True)
class UniformTrials:
    """Modes phi_k of the uniform free-free beam, over g_k^2; shear functions phi_k'' / g_k^3, and 3 xi^2 - 2 xi^3.

    The strains phi_k''' have no mean; the last shear function adds it, with the strain 6 xi (1 - xi), which vanishes at
    the free ends as the others do.
    """

    functions: int

    @property
    def nodes(self) -> Array:
        return np.array([0.0, 1.0])

    @property
    def sizes(self) -> tuple[int, int]:
        return self.functions, self.functions + 1

    def bending(self, xi: Array, orders: Sequence[int]) -> Array:
        g = frequency_parameters(self.functions)
        return uniform_modes(xi, self.functions, orders) / (g**2)[:, None]

    def shearing(self, xi: Array, orders: Sequence[int]) -> Array:
        g = frequency_parameters(self.functions)
        # phi'''' = g^4 phi
        waves = uniform_modes(xi, self.functions, [(order + 2) % 4 for order in orders]) / (g**3)[:, None]
        cubic = {0: xi**2 * (3.0 - 2.0 * xi) - 0.5, 1: 6.0 * xi * (1.0 - xi), 2: 6.0 - 12.0 * xi}
        rows = [
            np.vstack([wave * (g**4)[:, None] if order == 2 else wave, cubic[order]])
            for wave, order in zip(waves, orders, strict=True)
        ]
        return np.stack(rows)

    def rule(self, breaks: Array, degree: int) -> Quadrature:
        return for_waves(breaks, float(frequency_parameters(self.functions)[-1]), degree)
