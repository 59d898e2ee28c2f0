"""The flared rectellipse: a super-ellipse with a flare, y = a (1 - v^q)^(1/p) + f (1 - v)^r, v the share of the depth.

The second term is a flare that grows towards the deck, straight for r = 1; f below 0 is a tumblehome.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from hullform.hull.fitting import LARGEST_EXPONENT, SMALLEST_EXPONENT
from hullform.hull.outlines import resampled

Array = NDArray[np.float64]

_SAMPLES = 96
_STEEPEST_FLARE = 8.0  # exponent r: a flare within the uppermost eighth of the depth
_MOST_STEPS = 40
_CLOSE = 0.005  # of the half-breadth: so near, no other start is tried
# Starting values of a, f as shares of the half-breadth at the top, and of p, q, r.
_STARTS = ((0.6, 0.4, 1.5, 2.0, 1.5), (0.3, 0.7, 1.0, 4.0, 2.5))


def flared_rectellipse(points: Array, count: int) -> Array:
    """Points (count, 2) along the flared rectellipse that fits a traced section (k, 2) [half-breadth, height] best.

    Least squares of the horizontal miss times the cosine of the traced curve's slope; the top and the keel are the
    traced ones.
    """
    sample = resampled(points, _SAMPLES)
    keel, top = float(points[0, 1]), float(points[-1, 1])
    depth, breadth = top - keel, float(points[:, 0].max())
    share = np.clip((top - sample[:, 1]) / depth, 0.0, 1.0)
    tangent = np.gradient(sample, axis=0)
    upright = np.abs(tangent[:, 1]) / np.maximum(np.hypot(*tangent.T), 1e-300)
    low, high = np.log(SMALLEST_EXPONENT), np.log(LARGEST_EXPONENT)

    def miss(unknown: Array) -> Array:
        return np.asarray((_half_breadths(share, unknown) - sample[:, 0] / breadth) * upright)

    tries = []
    for a, f, p, q, r in _STARTS:
        found = least_squares(
            miss, [a, f, *np.log([p, q, r])],
            bounds=([0.0, -1.0, low, low, 0.0], [2.0, 1.5, high, high, np.log(_STEEPEST_FLARE)]),
            max_nfev=_MOST_STEPS, xtol=1e-6, ftol=1e-6,
        )  # fmt: skip
        tries.append(found)
        if np.abs(found.fun).max() < _CLOSE:
            break
    best = min(tries, key=lambda found: float(found.cost)).x
    # even in the angle: dense at the keel and the deck, where the curve may run along an axis
    v = (1 + np.cos(np.linspace(0.0, np.pi, count))) / 2
    y = np.maximum(breadth * _half_breadths(v, best), 0.0)
    y[0] = 0.0
    return np.stack([y, top - depth * v], axis=-1)


def _half_breadths(v: Array, unknown: Array) -> Array:
    a, f = unknown[:2]
    p, q, r = np.exp(unknown[2:])
    return np.asarray(a * (1 - v**q) ** (1 / p) + f * (1 - v) ** r)
