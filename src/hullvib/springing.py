"""Waves that shake the hull girder at a natural frequency: encounter, springing, in deep water.

A wave of the frequency w meets a ship of the speed U at the angle b between their ways (180 degrees head seas) with

    w_e = |w - w^2 U cos(b) / g|.

Waves excite a mode of the frequency w_n where w_e = w_n (linear springing) and, by their squares, where w_e = w_n / 2
(second order). With k = U cos(b) / g the roots w of w_e are (2 w_e) / (1 + sqrt(1 - 4 k w_e)), in head seas the only
one; in following seas, k > 0, also (1 + sqrt(1 - 4 k w_e)) / (2 k) while 4 k w_e <= 1, and (1 + sqrt(1 + 4 k w_e)) /
(2 k), waves that she overtakes. Length 2 pi g / w^2, period 2 pi / w. Source: R. E. D. Bishop and W. G. Price,
Hydroelasticity of Ships, Cambridge 1979, for the encounter; the roots are those of the two quadratics.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError
from hullvib.sea import GRAVITY_M_S2

Array = NDArray[np.float64]

ORDERS = (1, 2)
_ROUND_OFF = 1e-12


@dataclass(frozen=True)
class ExcitingWave:
    """A regular wave that meets the ship with a mode's frequency over its order.

    Attributes:
        order: 1 linear springing, 2 second-order.
        speed_m_s: of the ship.
        heading_rad: between her way and the waves', pi in head seas.
        angular_frequency: of the wave to one who stands still, rad/s.
        length_m: of the wave, in deep water.
        overtaken: whether she overtakes it.
    """

    order: int
    speed_m_s: float
    heading_rad: float
    angular_frequency: float
    length_m: float
    overtaken: bool

    @property
    def period_s(self) -> float:
        """Of the wave."""
        return 2.0 * math.pi / self.angular_frequency


def encounter_frequency(
    wave: ArrayLike, speed_m_s: ArrayLike, heading_rad: ArrayLike, gravity: float = GRAVITY_M_S2
) -> Array:
    """w_e in rad/s of waves w in rad/s; the arguments broadcast."""
    w = np.asarray(wave, dtype=np.float64)
    return np.asarray(np.abs(w - w**2 * _delay(speed_m_s, heading_rad, gravity)), dtype=np.float64)


def wave_frequencies(
    encounter: ArrayLike, speed_m_s: ArrayLike, heading_rad: ArrayLike, gravity: float = GRAVITY_M_S2
) -> Array:
    """The waves that are met with the frequency w_e, (..., 3) in rad/s, NaN where there is none; arguments broadcast.

    In the last axis: the longest wave, which there always is but when 4 k w_e > 1; the shorter one that overtakes her
    too; the one that she overtakes. Where the first two coincide (4 k w_e = 1: her speed along the waves is half that
    of their crests, with which their energy travels) the second is NaN.

    Raises:
        ArgumentError: an encounter frequency that is not above 0, or a speed below 0.
    """
    met, speed = np.asarray(encounter, dtype=np.float64), np.asarray(speed_m_s, dtype=np.float64)
    if not (np.isfinite(met).all() and (met > 0.0).all()):
        raise ArgumentError("an encounter frequency is not above 0; give finite numbers in rad/s.")
    if not (np.isfinite(speed).all() and (speed >= 0.0).all()):
        raise ArgumentError("a ship's speed is below 0; give it ahead, in m/s, and turn the heading.")
    met, k = np.broadcast_arrays(met, _delay(speed, heading_rad, gravity))
    tangent = np.abs(1.0 - 4.0 * k * met) < _ROUND_OFF
    inner = np.where(tangent, 0.0, 1.0 - 4.0 * k * met)
    real, following = inner >= 0.0, k > 0.0
    root, outer = np.sqrt(np.where(real, inner, 0.0)), np.sqrt(1.0 + 4.0 * np.abs(k) * met)
    twice = np.where(following, 2.0 * k, np.inf)
    longest = np.where(real, 2.0 * met / (1.0 + root), np.nan)
    shorter = np.where(real & following & ~tangent, (1.0 + root) / twice, np.nan)
    overtaken = np.where(following, (1.0 + outer) / twice, np.nan)
    return np.stack([longest, shorter, overtaken], axis=-1)


def wave_length(wave: ArrayLike, gravity: float = GRAVITY_M_S2) -> Array:
    """2 pi g / w^2 in m, deep water."""
    return np.asarray(2.0 * np.pi * gravity / np.asarray(wave, dtype=np.float64) ** 2, dtype=np.float64)


def exciting_waves(
    natural_rad_s: float,
    speed_m_s: float,
    heading_rad: float,
    orders: tuple[int, ...] = ORDERS,
    gravity: float = GRAVITY_M_S2,
) -> tuple[ExcitingWave, ...]:
    """The waves that excite a mode at one speed and heading, by order, the longest of each first. Raises ArgumentError.

    Args:
        natural_rad_s: w_n.
        speed_m_s: of the ship.
        heading_rad: pi in head seas, 0 in following.
        orders: n of w_e = w_n / n.
        gravity: m/s^2.
    """
    found = []
    for order in orders:
        roots = wave_frequencies(natural_rad_s / order, speed_m_s, heading_rad, gravity)
        found += [
            ExcitingWave(order, speed_m_s, heading_rad, float(root), float(wave_length(root, gravity)), index == 2)
            for index, root in enumerate(roots)
            if np.isfinite(root)
        ]
    return tuple(found)


def _delay(speed_m_s: ArrayLike, heading_rad: ArrayLike, gravity: float) -> Array:
    """k = U cos(b) / g in s; 0 where it is round-off, as in beam seas, whose cosine is 6e-17."""
    speed, cosine = np.asarray(speed_m_s, dtype=np.float64), np.cos(np.asarray(heading_rad, dtype=np.float64))
    delay = speed * cosine / gravity
    return np.asarray(np.where(np.abs(delay) < _ROUND_OFF, 0.0, delay), dtype=np.float64)
