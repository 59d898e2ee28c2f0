"""Fair cubics along the ship through points of sections: nothing overshoots, no section doubles back."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline

Array = NDArray[np.float64]

# A cubic from 0 to 1 over 1 that starts and ends with a slope of 0 to 3 keeps between; one from 1 to 1 that starts with
# -3 and ends with 3, or more gently, stays positive.
_STEEPEST = 3.0


def fair_sections(x: Array, points: Array) -> CubicHermiteSpline:
    """Cubics along the ship through points (sections, m, 2) at x (sections,), two sections or more.

    No point leaves the range of its coordinates on the two sections beside it (`_without_overshoot`), and no section
    doubles back between two that go the same way (`_kept_in_order`).
    """
    return CubicHermiteSpline(x, points, _kept_in_order(x, points, _without_overshoot(x, points)), axis=0)


def _without_overshoot(x: Array, values: Array) -> Array:
    """Slopes of cubics through values (n, ...) at x (n,), n >= 2, that stay between those of the places beside.

    The slope at a place is that of the parabola through it and its neighbours, at either end through the last three,
    as far as it does not overshoot, which is none at a largest or least value and elsewhere three times the lesser
    slope beside it at the most (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980; Hyman, SIAM J. Sci. Stat. Comput.
    4, 1983). Parabolas that need no bound come back as they are; harmonic means of the slopes (PCHIP) flatten them.
    """
    step = np.diff(x).reshape(-1, *(1,) * (values.ndim - 1))
    slope = np.diff(values, axis=0) / step
    if len(x) < 3:
        return np.repeat(slope, 2, axis=0)
    inner = (step[1:] * slope[:-1] + step[:-1] * slope[1:]) / (step[1:] + step[:-1])
    wanted = np.concatenate([2 * slope[:1] - inner[:1], inner, 2 * slope[-1:] - inner[-1:]])
    before, after = np.concatenate([slope[:1], slope]), np.concatenate([slope, slope[-1:]])
    bound = np.where(before * after > 0, _STEEPEST * np.minimum(np.abs(before), np.abs(after)), 0.0)
    sign = np.sign(before)
    return np.asarray(sign * np.clip(sign * wanted, 0.0, bound))


def _kept_in_order(x: Array, points: Array, slope: Array) -> Array:
    """Slopes no larger than those given under which points keep their order along the section.

    Where two points follow one another in the same sense on two sections, their distance d there is a cubic that stays
    positive if its slope is -3 d / h at the least where it begins and 3 d / h at the most where it ends, h being the
    distance of the sections (Schmidt and Hess, BIT 28, 1988). Points that lie close together move alike by this. Of
    slopes upwards and downwards, each with half of the bound, the largest that keep it are taken.
    """
    run = np.diff(points, axis=1)
    alike = run[:-1] * run[1:] > 0
    most = np.abs(slope).max() + np.finfo(float).tiny
    free, step = np.full_like(run[:1], np.inf), np.diff(x)[:, None, None]
    near = _STEEPEST * np.abs(run) / 2
    begins = np.minimum(np.concatenate([np.where(alike, near[:-1] / step, np.inf), free]), most)
    ends = np.minimum(np.concatenate([free, np.where(alike, near[1:] / step, np.inf)]), most)
    up, down = np.where(run > 0, ends, begins), np.where(run > 0, begins, ends)
    return _held(np.maximum(slope, 0.0), up, down) - _held(np.maximum(-slope, 0.0), down, up)


def _held(values: Array, up: Array, down: Array) -> Array:
    """The largest values (n, m, ...) up to those given that rise by no more than up, and fall by no more than down."""
    for most, way in ((up, 1), (down, -1)):
        ramp = np.cumsum(np.concatenate([np.zeros_like(values[:, :1]), most[:, ::way]], axis=1), axis=1)
        values = (ramp + np.minimum.accumulate(values[:, ::way] - ramp, axis=1))[:, ::way]
    return values
