"""How much a frequency moves when mass or rigidity is added at x: curves along the ship, first order and exact there.

Rayleigh's quotient is stationary in the mode, so that with the modal mass M_n

    d omega_n / dm(x)   = - omega_n Phi_n^2 / (2 M_n)         d omega_n / dJ(x)   = - omega_n psi_n^2 / (2 M_n)
    d omega_n / dEI(x)  = kappa_n^2 / (2 omega_n M_n)         d omega_n / dkGA(x) = gamma_n^2 / (2 omega_n M_n)

and the change for small distributions is the integral of the curve times the added property over x. Source: R. L. Fox
and M. P. Kapoor, Rates of change of eigenvalues and eigenvectors, AIAA Journal 6 (1968) 2426-2429, eq. (6).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError
from hullvib.modes import Modes

Array = NDArray[np.float64]


def mass_sensitivity(modes: Modes, x: ArrayLike) -> Array:
    """d omega / dm(x) in rad/s per kg/m over a metre, i.e. per kg put at x (points,) in m; (modes, points), <= 0."""
    return _lowered(modes, modes.shape(x))


def rotary_inertia_sensitivity(modes: Modes, x: ArrayLike) -> Array:
    """d omega / dJ(x) in rad/s per kg m^2 put at x (points,) in m; (modes, points), <= 0."""
    return _lowered(modes, modes.rotation(x))


def rigidity_sensitivity(modes: Modes, x: ArrayLike) -> Array:
    """d omega / dEI(x) in rad/s per N m^2 over a metre, at x (points,) in m; (modes, points), >= 0.

    kappa = M / EI with the bending moment from equilibrium, so that the curve has the jumps of 1 / EI and no others.
    """
    return _raised(modes, _strain(modes.moment(x), modes.girder.flexural_rigidity(_row(x)), modes.bending_curvature(x)))


def shear_rigidity_sensitivity(modes: Modes, x: ArrayLike) -> Array:
    """d omega / dkGA(x) in rad/s per N over a metre, at x (points,) in m; (modes, points), >= 0.

    gamma = -V / kGA with the shear force from equilibrium; the curve has its square. Raises ArgumentError for modes of
    a theory without shear.
    """
    rigidity = modes.girder.shear_rigidity(_row(x))
    if rigidity is None or not modes.shear_flexible:
        raise ArgumentError(
            f"the theory is {modes.theory!r}, in which shear rigidity plays no part; solve by a method for "
            "Timoshenko's beam."
        )
    return _raised(modes, _strain(-modes.shear(x), rigidity, modes.shear_strain(x)))


def _row(x: ArrayLike) -> Array:
    return np.atleast_1d(np.asarray(x, dtype=np.float64))


def _strain(force: Array, rigidity: Array, own: Array) -> Array:
    """Force over rigidity; at a sharp end, where both vanish, the strain of the shape itself."""
    return np.divide(force, rigidity, out=own.copy(), where=np.broadcast_to(rigidity > 0.0, own.shape))


def _lowered(modes: Modes, values: Array) -> Array:
    factor = -0.5 * modes.angular_frequencies / modes.modal_mass
    return np.asarray(factor[:, None] * values**2, dtype=np.float64)


def _raised(modes: Modes, values: Array) -> Array:
    factor = 0.5 / (modes.angular_frequencies * modes.modal_mass)
    return np.asarray(factor[:, None] * values**2, dtype=np.float64)
