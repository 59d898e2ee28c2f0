"""The result of a solution in water."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullvib.correlation import mac
from hullvib.modes import Modes
from hullvib.wet.added_mass import AddedMass
from hullvib.wet.motions import GirderMotions, MixedField
from hullvib.wet.strip_flow import StripFlow

Array = NDArray[np.float64]


@dataclass(frozen=True)
class RigidMotion:
    """Heave or pitch as it comes out beside the elastic modes: no valid figure of a ship, whose own lie where waves
    matter, only a sign that it was told apart.

    angular_frequency in rad/s; share, 0 to 1, of rigid-body motion in its kinetic energy.
    """

    angular_frequency: float
    share: float


@dataclass(frozen=True, eq=False)
class WetModes:
    """Elastic modes of a girder afloat, lowest first, with what the water does to each.

    modes are the wet ones, medium "wet", with the generalised mass of ship and water as modal mass; dry the girder's
    dry modes that they are made of, two rigid-body motions besides; heave and pitch those that were told apart by their
    shape; added_mass of the functions, heave and pitch first; coefficients (modes, 2 + functions) of the wet shapes in
    them; generalised_mass and generalised_added_mass (modes,) in kg, for a largest amplitude of 1 m;
    hydrostatic_stiffness_share (modes,) of the whole stiffness; tail (modes,), the factor of each mode's added mass by
    its frequency, 1 in the limit.
    """

    modes: Modes
    dry: Modes
    heave: RigidMotion
    pitch: RigidMotion
    added_mass: AddedMass
    coefficients: Array
    generalised_mass: Array
    generalised_added_mass: Array
    hydrostatic_stiffness_share: Array
    tail: Array

    @property
    def frequency_ratios(self) -> Array:
        """Wet over dry frequency, mode by mode, (modes,)."""
        wet = self.modes.angular_frequencies
        return np.asarray(wet / self.dry.angular_frequencies[: len(wet)], dtype=np.float64)

    @property
    def mac_dry(self) -> Array:
        """Modal assurance criterion of the wet modes against as many dry ones, (modes, modes)."""
        count = len(self.modes.angular_frequencies)
        return mac(self.modes, self.dry)[:, :count]

    @property
    def force_kg_per_m(self) -> Array:
        """Vertical force of the water per length and unit acceleration of each wet mode, (modes, cells), between
        `added_mass.edges_m`: positive against upward acceleration."""
        limit = self.coefficients @ self.added_mass.force_kg_per_m
        return np.asarray(self.tail[:, None] * limit, dtype=np.float64)

    def added_mass_per_length(self, least: float = 0.1) -> Array:
        """Added mass along the ship of each mode in kg/m, (modes, cells): the force over the deflection there.

        Where the deflection is below `least` of the largest, near the nodes, it means nothing and is NaN.
        """
        edges = self.added_mass.edges_m
        middle = 0.5 * (edges[1:] + edges[:-1])
        shapes = self.modes.shape(np.clip(middle, 0.0, self.modes.girder.length))
        small = np.abs(shapes) < least
        return np.where(small, np.nan, self.force_kg_per_m / np.where(small, 1.0, shapes))

    def effective_factors(self, strips: StripFlow) -> Array:
        """J_n of each wet mode, (modes,): its generalised added mass over that of the strips without correction."""
        field = MixedField(self.dry, self.coefficients)
        plain = strips.strip_mass(GirderMotions(self.dry))
        return np.asarray(
            self.generalised_added_mass / np.einsum("nj,jk,nk->n", field.coefficients, plain, field.coefficients)
        )
