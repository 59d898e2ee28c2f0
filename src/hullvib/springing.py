"""Waves that shake the hull girder at a natural frequency: encounter and springing.

A wave of the frequency w meets a ship of the speed U at the angle b between their ways (180 degrees head seas) with

    w_e = |w - w^2 U cos(b) / g|.

Waves excite a mode of the frequency w_n where w_e = w_n (linear springing) and, by their squares, where w_e = w_n / 2
(second order). With d = U cos(b) / g the roots w of w_e are (2 w_e) / (1 + sqrt(1 - 4 d w_e)), in head seas the only
one; in following seas, d > 0, also (1 + sqrt(1 - 4 d w_e)) / (2 d) while 4 d w_e <= 1, and (1 + sqrt(1 + 4 d w_e)) /
(2 d), waves that she overtakes. Length 2 pi g / w^2, period 2 pi / w. That is deep water; in water of the depth h
w^2 = g k tanh(k h), k the wave number, and w_e = |w - k U cos(b)| has as many roots at most, found by search. Source:
R. E. D. Bishop and W. G. Price, Hydroelasticity of Ships, Cambridge 1979, for the encounter; the roots in deep water
are those of the two quadratics.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError
from hullvib.sea import GRAVITY_M_S2

Array = NDArray[np.float64]

ORDERS = (1, 2)
SHORTEST_WAVE_M = 0.1
"""Shorter ones, such as a ship would overtake near beam seas, are ripples."""
_ROUND_OFF = 1e-12
_NEWTON_STEPS = 6
_CRITICAL = 1e-6


@dataclass(frozen=True)
class ExcitingWave:
    """A regular wave that meets the ship with a mode's frequency over its order.

    Attributes:
        order: 1 linear springing, 2 second-order.
        speed_m_s: of the ship.
        heading_rad: between her way and the waves', pi in head seas.
        angular_frequency: of the wave to one who stands still, rad/s.
        length_m: of the wave.
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

    In the last axis: the longest wave, which there always is but when 4 d w_e > 1; the shorter one that overtakes her
    too; the one that she overtakes. Where the first two coincide (4 d w_e = 1: her speed along the waves is half that
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


def wave_length(wave: ArrayLike, gravity: float = GRAVITY_M_S2, depth_m: float = math.inf) -> Array:
    """Length 2 pi / k in m of a wave of w^2 = g k tanh(k h), 2 pi g / w^2 in deep water."""
    deep = np.asarray(wave, dtype=np.float64) ** 2 / gravity
    if math.isinf(depth_m):
        return np.asarray(2.0 * np.pi / deep, dtype=np.float64)
    whole = deep * depth_m
    size = whole / np.sqrt(np.tanh(whole))  # k h, by C. Eckart within 5 per cent; Newton's steps do the rest
    for _ in range(_NEWTON_STEPS):
        over = np.tanh(size)
        size = size - (size * over - whole) / (over + size * (1.0 - over**2))
    return np.asarray(2.0 * np.pi * depth_m / size, dtype=np.float64)


def met_waves(
    encounter: float,
    speed_m_s: ArrayLike,
    heading_rad: ArrayLike,
    gravity: float = GRAVITY_M_S2,
    depth_m: float = math.inf,
) -> tuple[Array, Array]:
    """Frequencies in rad/s, as `wave_frequencies` has them, and lengths in m, in water of any depth, each (..., 3).

    Raises:
        ArgumentError: as `wave_frequencies`, or a depth that is not above 0.
    """
    if not depth_m > 0.0:
        raise ArgumentError(f"depth_m is {depth_m:g}; give the depth of the water, above 0, or leave it out.")
    waves = wave_frequencies(encounter, speed_m_s, heading_rad, gravity)
    if math.isfinite(depth_m):
        along = np.broadcast_to(_delay(speed_m_s, heading_rad, gravity) * gravity, waves.shape[:-1])
        for place in np.ndindex(along.shape):
            waves[place] = _waves_of_depth(float(encounter), float(along[place]), depth_m, gravity)
    return waves, wave_length(waves, gravity, depth_m)


def exciting_waves(
    natural_rad_s: float,
    speed_m_s: float,
    heading_rad: float,
    orders: tuple[int, ...] = ORDERS,
    gravity: float = GRAVITY_M_S2,
    depth_m: float = math.inf,
) -> tuple[ExcitingWave, ...]:
    """The waves that excite a mode at one speed and heading, by order, the longest of each first.

    Waves shorter than `SHORTEST_WAVE_M` are left out. Raises ArgumentError.

    Args:
        natural_rad_s: w_n.
        speed_m_s: of the ship.
        heading_rad: pi in head seas, 0 in following.
        orders: n of w_e = w_n / n.
        gravity: m/s^2.
        depth_m: of the water.
    """
    found = []
    for order in orders:
        waves, lengths = met_waves(natural_rad_s / order, speed_m_s, heading_rad, gravity, depth_m)
        found += [
            ExcitingWave(order, speed_m_s, heading_rad, float(wave), float(length), index == 2)
            for index, (wave, length) in enumerate(zip(waves, lengths, strict=True))
            if length >= SHORTEST_WAVE_M
        ]
    return tuple(found)


def _waves_of_depth(met: float, along: float, depth: float, gravity: float) -> tuple[float, float, float]:
    """The frequencies, as `wave_frequencies` has them, of the waves met with `met`; `along`, her speed along the waves.

    w(k) - k U rises to where the waves' energy travels with the ship, falls to 0 where their crests do, and on.
    """
    from scipy.optimize import brentq  # which takes long to import

    def wave(k: float) -> float:
        return math.sqrt(gravity * k * math.tanh(k * depth))

    def energy_speed(k: float) -> float:
        # 2 x / sinh(2 x), which is nothing long before sinh overflows
        share = 2 * k * depth / math.sinh(2 * k * depth) if k * depth < 300 else 0.0
        return wave(k) / (2 * k) * (1 + share)

    def root(of: Callable[[float], float], low: float, high: float = math.nan) -> float:
        if math.isnan(high):
            high = 2 * low
            while (of(high) > 0) == (of(low) > 0):
                high *= 2
        return float(brentq(of, low, high, xtol=_ROUND_OFF * low, rtol=8 * np.finfo(float).eps))

    tiny = 1e-9 / depth
    if along <= 0:
        return wave(root(lambda k: wave(k) - along * k - met, tiny)), math.nan, math.nan
    longest = shorter = math.nan
    still = tiny
    # not within round-off of the fastest of waves, sqrt(g h)
    if along < (1 - _CRITICAL) * math.sqrt(gravity * depth):
        still = root(lambda k: wave(k) - along * k, tiny)
        crest = root(lambda k: energy_speed(k) - along, tiny, still)
        if wave(crest) - along * crest > met:
            longest, shorter = (
                wave(root(lambda k: wave(k) - along * k - met, *ends)) for ends in ((tiny, crest), (crest, still))
            )
    return longest, shorter, wave(root(lambda k: wave(k) - along * k + met, still))


def _delay(speed_m_s: ArrayLike, heading_rad: ArrayLike, gravity: float) -> Array:
    """k = U cos(b) / g in s; 0 where it is round-off, as in beam seas, whose cosine is 6e-17."""
    speed, cosine = np.asarray(speed_m_s, dtype=np.float64), np.cos(np.asarray(heading_rad, dtype=np.float64))
    delay = speed * cosine / gravity
    return np.asarray(np.where(np.abs(delay) < _ROUND_OFF, 0.0, delay), dtype=np.float64)
