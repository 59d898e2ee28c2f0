"""Steady response of the modes to a harmonic force or moment, with modal damping.

Under F cos(w t) at x_F, or M cos(w t) on the section at x_M, mode n answers with the complex amplitude

    q_n = Q_n / (m_n (w_n^2 - w^2 + 2 i zeta_n w_n w)),      Q_n = F Phi_n(x_F)  or  M psi_n(x_M),

m_n its modal mass (in water with the added mass) and psi_n the angle of the sections, which is the slope without shear;
at resonance |q_n| = Q_n / (2 zeta_n w_n^2 m_n). The deflection is the sum of q_n Phi_n(x), its peak velocity w times
its amplitude. Rigid-body motion is not in it: far below the first mode it matters, at a resonance not. Source: any
text, e.g. R. E. D. Bishop and D. C. Johnson, The Mechanics of Vibration, Cambridge 1960, chapter 7.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError
from hullvib.modes import Modes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class HarmonicLoad:
    """A vertical force in N, positive up, and a moment in N m, positive as slopes are, at x_m; amplitudes, in phase."""

    x_m: float
    force_n: float = 0.0
    moment_n_m: float = 0.0


@dataclass(frozen=True, eq=False)
class ForcedResponse:
    """The girder's steady motion at one exciting frequency.

    Attributes:
        angular_frequency: of the load, rad/s.
        x_m: (points,).
        deflection: complex amplitudes in m, (points,), the load real.
    """

    angular_frequency: float
    x_m: Array
    deflection: Complex

    @property
    def amplitude_m(self) -> Array:
        """Of the deflection, (points,), zero to peak."""
        return np.asarray(np.abs(self.deflection), dtype=np.float64)

    @property
    def peak_velocity_m_s(self) -> Array:
        """Largest velocity within a cycle, (points,)."""
        return self.angular_frequency * self.amplitude_m


def generalised_load(modes: Modes, load: HarmonicLoad) -> Array:
    """Q_n in N, per metre of the shape's scale, (modes,). Raises ArgumentError for a load off the girder."""
    at = [load.x_m]
    return np.asarray(load.force_n * modes.shape(at)[:, 0] + load.moment_n_m * modes.rotation(at)[:, 0])


def modal_amplitudes(
    natural: ArrayLike, modal_mass: ArrayLike, load: ArrayLike, angular_frequency: ArrayLike, damping: ArrayLike
) -> Complex:
    """q_n in m; the arguments broadcast.

    Args:
        natural: w_n, rad/s.
        modal_mass: m_n, kg.
        load: Q_n, N.
        angular_frequency: w, rad/s.
        damping: zeta_n over critical.

    Raises:
        ArgumentError: damping outside 0 .. 1, or an exciting frequency below 0.
    """
    zeta, w = np.asarray(damping, dtype=np.float64), np.asarray(angular_frequency, dtype=np.float64)
    if not ((zeta > 0.0) & (zeta < 1.0)).all():
        raise ArgumentError(f"damping is {zeta.tolist()} of critical; give a number above 0 and below 1.")
    if not (np.isfinite(w).all() and (w >= 0.0).all()):
        raise ArgumentError(f"the exciting frequency is {w.tolist()} rad/s; give a finite one, 0 or more.")
    own = np.asarray(natural, dtype=np.float64)
    stiffness = own**2 - w**2 + 2j * zeta * own * w
    return np.asarray(np.asarray(load) / (np.asarray(modal_mass) * stiffness), dtype=np.complex128)


def forced_response(
    modes: Modes,
    load: HarmonicLoad,
    angular_frequency: float,
    damping: ArrayLike,
    x_m: ArrayLike,
    only_mode: int | None = None,
) -> ForcedResponse:
    """The girder under one harmonic load.

    Args:
        modes: the elastic modes, whose sum the response is.
        load: where it acts and how much.
        angular_frequency: of the load, rad/s.
        damping: of critical, (modes,) or one for all.
        x_m: where the response is wanted, (points,).
        only_mode: the response of this mode alone, from 1.

    Raises:
        ArgumentError: the load or x off the girder, damping outside 0 .. 1, or no such mode.
    """
    count = len(modes.angular_frequencies)
    if only_mode is not None and not 1 <= only_mode <= count:
        raise ArgumentError(f"there is no mode {only_mode} among {count}.")
    amplitudes = modal_amplitudes(
        modes.angular_frequencies, modes.modal_mass, generalised_load(modes, load), angular_frequency, damping
    )
    if only_mode is not None:
        amplitudes = np.where(np.arange(1, count + 1) == only_mode, amplitudes, 0.0)
    x = np.asarray(x_m, dtype=np.float64)
    return ForcedResponse(float(angular_frequency), x, amplitudes @ modes.shape(x))


def participation(modes: Modes, x_m: float, acts: str) -> Array:
    """How well a place excites each mode, (modes,), 0 .. 1 in size: 0 where nothing of the mode is.

    Of a force Phi_n(x) over the largest |Phi_n|, of a moment psi_n(x) over the largest |psi_n|; with their signs.
    Raises ArgumentError for a place off the girder.
    """
    value = modes.shape if acts == "force" else modes.rotation
    along = np.abs(value(np.linspace(0.0, modes.girder.length, 2001))).max(axis=1)
    return np.asarray(value([x_m])[:, 0] / along, dtype=np.float64)
