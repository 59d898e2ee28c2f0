"""The shear area of a closed thin-walled section, from the shear flow that a vertical force causes in it.

With Q(s) = Int t z ds counted from the centre line at the deck, z from the neutral axis, the shear flow is q = V Q / I
and its strain energy that of a shear area A_s = I^2 / closed-Int (Q^2 / t) ds. Port and starboard being alike, q
vanishes on the centre line at deck and keel, so a section of one cell needs no compatibility condition.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# Q^2 is of the fourth degree along a straight plate: three points integrate it exactly.
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(3)
_PLACES, _SHARES = (1 + _NODES) / 2, _WEIGHTS / 2


def shear_area(half_breadth_m: Array, height_m: Array, thickness_m: float) -> Array:
    """Energy-equivalent vertical shear area k A of closed shells of one thickness, in m2.

    Args:
        half_breadth_m, height_m: (..., points) one side's contour, from the centre line at the deck round to the keel
            on the centre line; straight plates between the points.
        thickness_m: of all plates.

    Returns:
        (...) shear areas of the whole sections, both sides; 0 where a section has no depth.
    """
    length = np.hypot(np.diff(half_breadth_m), np.diff(height_m))
    start, end = height_m[..., :-1], height_m[..., 1:]
    girth = length.sum(-1, keepdims=True)
    safe_girth = np.where(girth > 0, girth, 1.0)
    axis = (length * (start + end) / 2).sum(-1, keepdims=True) / safe_girth
    start, rise = start - axis, end - start
    second_moment = (length * (start**2 + start * rise + rise**2 / 3)).sum(-1)
    moment = length * (start + rise / 2)
    before = np.concatenate([np.zeros_like(girth), np.cumsum(moment, -1)[..., :-1]], -1)
    at = (before + 0 * length)[..., None] + length[..., None] * (
        start[..., None] * _PLACES + rise[..., None] * _PLACES**2 / 2
    )
    energy = (length * (at**2 @ _SHARES)).sum(-1)
    # both sides: I and the energy integral double, and A_s = t (2 I1)^2 / (2 E1)
    return np.asarray(thickness_m * 2 * second_moment**2 / np.where(energy > 0, energy, np.inf))
