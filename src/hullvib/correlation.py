"""Modes held against each other: how orthogonal a set is, and the modal assurance criterion between two sets."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.energies import energy_matrices, energy_rule
from hullvib.errors import ArgumentError
from hullvib.modes import Modes

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Orthogonality:
    """What is left of the orthogonality relations, both (modes, modes), 0 for exact modes.

    mass is <Phi_j, Phi_k>_m / sqrt(M_j M_k) - delta_jk with the modal masses M, point masses and rotary inertia
    included where they took part; stiffness the same of the strain energy with omega^2 M.
    """

    mass: Array
    stiffness: Array

    @property
    def largest(self) -> float:
        """The largest of all residuals by size."""
        return float(max(np.abs(self.mass).max(), np.abs(self.stiffness).max()))


def orthogonality(modes: Modes) -> Orthogonality:
    """Residuals of the orthogonality of a set of modes, with the integrals taken anew.

    Off the diagonal they tell whether the modes are apart, on it whether modal mass and frequency fit the shapes: the
    diagonal of the stiffness is Rayleigh's quotient against omega^2. Of dry modes: what the water adds to mass and
    stiffness a girder does not know. Raises ArgumentError for others.
    """
    if modes.medium != "dry":
        raise ArgumentError(
            f"the modes are {modes.medium}; these are orthogonal with the water's mass, which is not the girder's."
        )
    rule = energy_rule(modes.girder, [modes.field], len(modes.scale), np.array([0.0, 1.0]))
    mass, stiffness = energy_matrices(modes.girder, modes.field, rule, rotary=modes.rotary, shear=modes.shear_flexible)
    scaled = np.outer(modes.scale, modes.scale)
    unit = np.eye(len(modes.scale))
    kinetic, strain = np.sqrt(modes.modal_mass), np.sqrt(modes.modal_stiffness)
    return Orthogonality(
        mass * scaled / np.outer(kinetic, kinetic) - unit, stiffness * scaled / np.outer(strain, strain) - unit
    )


def mac(modes: Modes, other: Modes | ArrayLike, x: ArrayLike | None = None) -> Array:
    """Modal assurance criterion, (modes, other modes), 1 for equal shapes and 0 for orthogonal ones.

    MAC_jk = (Phi_j, Psi_k)^2 / ((Phi_j, Phi_j) (Psi_k, Psi_k)); against other Modes, of a girder of the same length,
    (., .) is the integral over x; against amplitudes (other modes, points) measured at x (points,) in m, the sum over
    the points. Source: R. J. Allemang, The modal assurance criterion, Sound and Vibration 37 (2003) 14-21, eq. (2).
    Raises ArgumentError.
    """
    if isinstance(other, Modes):
        if x is not None:
            raise ArgumentError("x belongs to measured amplitudes; between two sets of Modes leave it out.")
        length = modes.girder.length
        if abs(other.girder.length - length) > 1e-9 * length:
            raise ArgumentError(
                f"the girders are {length:g} m and {other.girder.length:g} m long; shapes of equal length only are "
                "held against each other."
            )
        count = max(len(modes.scale), len(other.scale))
        rule = energy_rule(modes.girder, [modes.field, other.field], count, np.array([0.0, 1.0]))
        xi, weights = rule.xi.ravel(), rule.weights.ravel()
        own, theirs = modes.field.evaluate(xi, 0), other.field.evaluate(xi, 0)
    else:
        if x is None:
            raise ArgumentError("measured amplitudes need x, the positions in m at which they were taken.")
        own, theirs = modes.shape(x), np.atleast_2d(np.asarray(other, dtype=np.float64))
        if theirs.ndim != 2 or theirs.shape[1] != own.shape[1]:
            raise ArgumentError(f"the amplitudes have shape {theirs.shape}, but x has {own.shape[1]} positions.")
        weights = np.ones(own.shape[1])
    products = (own * weights) @ theirs.T
    sizes = np.outer((own**2) @ weights, (theirs**2) @ weights)
    if not bool((sizes > 0.0).all()):
        raise ArgumentError("a shape is zero at every position; it has no direction to compare.")
    return np.asarray(products**2 / sizes, dtype=np.float64)
