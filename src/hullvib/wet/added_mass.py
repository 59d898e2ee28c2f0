"""What the water does to a set of motions, and what a flow must be able to say."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError
from hullvib.wet.motions import Motions

Array = NDArray[np.float64]

NeutralAxis = float | tuple[ArrayLike, ArrayLike] | Callable[[Array], Array]
"""Height of the girder's neutral axis above the waterline in m, negative below: one number, (x, z) or a function."""


@dataclass(frozen=True, eq=False)
class AddedMass:
    """Added mass of n motions.

    matrix (n, n) in kg, symmetric: the force on motion k for unit acceleration of motion j; asymmetry is the largest
    difference between the two halves that were averaged, over the largest entry. edges_m (cells + 1,) and
    force_kg_per_m (n, cells): vertical force per length and per unit acceleration of each motion, in the mean of a
    cell; times the motion's deflection and integrated it gives the matrix, but for what the turning of the sections
    adds. record tells how it was found.
    """

    matrix: Array
    asymmetry: float
    edges_m: Array
    force_kg_per_m: Array
    record: Mapping[str, Any]


class Flow(Protocol):
    """The water about a hull at rest."""

    @property
    def density_kg_m3(self) -> float:
        """Of the water."""
        ...

    @property
    def gravity_m_s2(self) -> float:
        """Acceleration of free fall."""
        ...

    @property
    def breadth_m(self) -> float:
        """Largest breadth in the waterline."""
        ...

    def added_mass(self, motions: Motions) -> AddedMass:
        """Added mass in the limit of high frequency, in which the free surface is an equipotential."""
        ...

    def hydrostatic_stiffness(self, motions: Motions) -> Array:
        """rho g int B w_j w_k dx over the waterline, (n, n) in N/m."""
        ...


def heights_of(neutral_axis: NeutralAxis, x_m: Array) -> Array:
    """Heights above the waterline at x (points,). Raises ArgumentError."""
    if callable(neutral_axis):
        heights = np.asarray(neutral_axis(x_m), dtype=np.float64)
    elif isinstance(neutral_axis, tuple):
        places, given = (np.asarray(column, dtype=np.float64) for column in neutral_axis)
        heights = np.interp(x_m, places, given)
    else:
        heights = np.full(x_m.shape, float(neutral_axis))
    if heights.shape != x_m.shape or not np.isfinite(heights).all():
        raise ArgumentError("the neutral axis has a height that is not finite; give it in m above the waterline.")
    return np.asarray(heights, dtype=np.float64)


def check_density(density_kg_m3: float) -> None:
    """Raises ArgumentError for a density that is not positive."""
    if not (np.isfinite(density_kg_m3) and density_kg_m3 > 0.0):
        raise ArgumentError(f"density_kg_m3 is {density_kg_m3}; give a finite number above 0, 1025 for sea water.")
