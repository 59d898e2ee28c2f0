"""The free-free modes of the uniform beam, of any order, without loss of digits.

phi_j = cos(g x) + cosh(g x) - sigma_j (sin(g x) + sinh(g x)), cos(g) cosh(g) = 1, on 0 <= x <= 1, with
phi_j(0) = 2 and integral phi_j^2 dx = 1. That textbook form cancels from mode 10 on and overflows later. About the
middle, u = x - 1/2, the same functions are, with a = e^(-g x) and b = e^(-g (1 - x)),

    j odd:    cos(g u) / cos(g/2) + (b + a) / (1 + e^(-g))
    j even: - sin(g u) / sin(g/2) - (b - a) / (1 - e^(-g))

in which no term exceeds sqrt(2). Frequency equation: R. D. Blevins, Formulas for Natural Frequency and Mode Shape,
table 8-1, case 1.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError

Array = NDArray[np.float64]

_FEW = 30  # points, fewer than any rule or grid has
_REMEMBERED = 20_000  # values of one derivative at one set of points


@lru_cache(maxsize=64)
def frequency_parameters(count: int) -> Array:
    """The first `count` positive roots g of cos(g) cosh(g) = 1, (count,), by Newton on cos(g) - 1/cosh(g)."""
    if count < 1:
        raise ArgumentError(f"count is {count}; ask for at least 1 mode.")
    g: Array = (2.0 * np.arange(1, count + 1, dtype=np.float64) + 1.0) * (np.pi / 2.0)
    # from mode 12 on the start is the root to the last bit; Newton acts on the lower ones, where cosh stays finite
    low = g[:12]
    for _ in range(6):
        cosh = np.cosh(low)
        low -= (np.cos(low) - 1.0 / cosh) / (-np.sin(low) + np.sinh(low) / cosh**2)
    g.flags.writeable = False
    return g


def uniform_modes(x_over_length: ArrayLike, count: int, derivatives: Sequence[int] = (0,)) -> Array:
    """Modes 1..count and their derivatives by x/L, (len(derivatives), count, points).

    Arguments: x_over_length (points,), 0..1; derivatives of order 0 to 3. Raises ArgumentError.
    """
    x = np.asarray(x_over_length, dtype=np.float64)
    if x.ndim != 1:
        raise ArgumentError(f"x_over_length has {x.ndim} dimensions; give one.")
    if any(order not in (0, 1, 2, 3) for order in derivatives):
        raise ArgumentError(f"derivatives of order {list(derivatives)} were asked; 0, 1, 2 and 3 exist.")
    # a grid or a rule is asked for again by the next variant of a girder, a few points in search of a zero are not
    if len(x) > _FEW and count * len(x) <= _REMEMBERED:
        return _remembered_modes(x.tobytes(), count, tuple(derivatives)).copy()
    return _evaluated_modes(x, count, derivatives)


@lru_cache(maxsize=32)
def _remembered_modes(x: bytes, count: int, derivatives: tuple[int, ...]) -> Array:
    return _evaluated_modes(np.frombuffer(x), count, derivatives)


def _evaluated_modes(x: Array, count: int, derivatives: Sequence[int]) -> Array:
    g = frequency_parameters(count)
    out = np.empty((len(derivatives), count, len(x)))
    for first, symmetric in ((0, True), (1, False)):
        rows = g[first::2]
        if len(rows) == 0:
            continue
        half, decay = 0.5 * rows, np.exp(-rows)
        angle = rows[:, None] * (x - 0.5)
        # the scale of each trigonometric and of each hyperbolic row
        trig_scale = 1.0 / np.cos(half) if symmetric else -1.0 / np.sin(half)
        hyper_scale = 1.0 / (1.0 + decay) if symmetric else -1.0 / (1.0 - decay)
        aft = np.exp(-rows[:, None] * x) * hyper_scale[:, None]
        fore = np.exp(rows[:, None] * (x - 1.0)) * hyper_scale[:, None]
        circular: dict[bool, Array] = {}
        for place, order in enumerate(derivatives):
            cosine = symmetric == (order % 2 == 0)
            if cosine not in circular:
                circular[cosine] = (np.cos(angle) if cosine else np.sin(angle)) * trig_scale[:, None]
            sign = -1.0 if order in _TRIG_NEGATIVE[symmetric] else 1.0
            hyper = fore + aft if cosine else fore - aft
            value = sign * circular[cosine] + hyper
            out[place, first::2] = value if order == 0 else value * (rows**order)[:, None]
    return out


# orders whose trigonometric part carries a minus: cos, -sin, -cos, sin and sin, cos, -sin, -cos
_TRIG_NEGATIVE = {True: (1, 2), False: (2, 3)}
