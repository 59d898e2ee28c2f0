"""Empirical frequencies of vertical hull vibration, all of the ship **in water**.

The constants of these formulas were fitted to ships afloat and hold the added mass of water. Never set their figures
beside a dry calculation as if they were the same thing. Every function returns angular frequencies in rad/s, lowest
first. Each formula has a length and a virtual mass of its own, as its docstring says.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from hullvib.errors import ArgumentError

Array = NDArray[np.float64]

KUMAI_EXPONENTS: Mapping[str, float] = MappingProxyType({"cargo": 0.845, "bulk": 1.0, "tanker": 1.02})
"""Exponent of Kumai's higher modes by ship type; none is published for container ships, which take 'cargo'."""

_RAD_S_PER_CPM = np.pi / 30.0
_FEET_PER_METRE = 3.28084
_TONNES_PER_LONG_TON = 1.016047
_IN2_FT2_PER_M4 = _FEET_PER_METRE**4 * 144.0


def todd(*, breadth: float, depth: float, length: float, displacement_t: float, as_printed: bool = False) -> Array:
    """'Todd type' formula of SR94 for modes 1 to 3, in water, (3,) rad/s.

    N2 = 9.4e4 X + 19, N3 = 13.2e4 X + 65, N4 = 3 N2 (N_n = (n - 1) N2), X = sqrt(B D^3 / (Delta L^3)), in cycles/min.
    breadth B, depth D, length L in m (the paper uses the length overall), displacement Delta in t. as_printed=True
    takes 4 N2 for the third mode, as the paper's table 2 does against its own formula. Raises ArgumentError.
    Source: the paper, section 3.2.2; SR94 itself was not found.
    """
    _positive(breadth=breadth, depth=depth, length=length, displacement_t=displacement_t)
    root = np.sqrt(breadth * depth**3 / (displacement_t * length**3))
    return _sr94(9.4e4 * root + 19.0, 13.2e4 * root + 65.0, as_printed)


def schlick(*, second_moment: float, length: float, displacement_t: float, as_printed: bool = False) -> Array:
    """'Schlick type' formula of SR94 for modes 1 to 3, in water, (3,) rad/s.

    N2 = 27.1e5 X + 14.5, N3 = 38.8e5 X + 58.5, N4 = 3 N2, X = sqrt(I / (Delta L^3)), in cycles/min. second_moment I of
    the midship section in m^4 (the paper's table takes `hollow_box_second_moment` with 16 mm), length L in m (overall
    in the paper), displacement Delta in t. as_printed=True takes 4 N2 for the third mode, as the paper's table 2 does.
    Raises ArgumentError. Source: the paper, section 3.2.2; SR94 itself was not found.
    """
    _positive(second_moment=second_moment, length=length, displacement_t=displacement_t)
    root = np.sqrt(second_moment / (displacement_t * length**3))
    return _sr94(27.1e5 * root + 14.5, 38.8e5 * root + 58.5, as_printed)


def kumai(
    *,
    second_moment: float,
    breadth: float,
    draught: float,
    length: float,
    displacement_t: float,
    exponent: float = KUMAI_EXPONENTS["cargo"],
) -> Array:
    """Kumai's formula for modes 1 to 3, in water, (3,) rad/s.

    N2 = 3.07e6 sqrt(I / (Delta_v L^3)) cycles/min, Delta_v = (1.2 + B / (3 T)) Delta, and N_j = N2 j^mu for mode j
    (j + 1 nodes). second_moment I in m^4, breadth B and draught T in m, length L between perpendiculars in m,
    displacement Delta in t, exponent mu by ship type: `KUMAI_EXPONENTS`, 0.845 cargo ships (and, for want of a
    published one, container ships), 1.0 bulk carriers, 1.02 tankers. Raises ArgumentError.
    Provenance: 3.07e6 and Delta_v are found in public code; the exponents are from memory, with high confidence for
    bulk carriers and tankers, less for 0.845, which one source gives for tankers.
    """
    _positive(second_moment=second_moment, length=length, displacement_t=displacement_t, exponent=exponent)
    virtual_t = displacement_t * todd_virtual_mass_factor(breadth=breadth, draught=draught)
    two_node = 3.07e6 * np.sqrt(second_moment / (virtual_t * length**3))
    return np.asarray(two_node * np.arange(1.0, 4.0) ** exponent * _RAD_S_PER_CPM, dtype=np.float64)


def burrill(
    *,
    second_moment: float,
    breadth: float,
    depth: float,
    draught: float,
    length: float,
    displacement_t: float,
    length_kind: Literal["perpendiculars", "overall"] = "perpendiculars",
) -> Array:
    """Burrill's formula for the two-node mode, in water, (1,) rad/s; it has none for higher modes.

    N2 = phi sqrt(I / (Delta L^3)) / sqrt((1 + B / (2 T)) (1 + r_s)) cycles/min, with I in in^2 ft^2, L in ft, Delta in
    long tons, phi = 200000 for the length between perpendiculars and 220000 for the length overall, and the shear
    correction r_s = 3.5 D^2 (3 a^3 + 9 a^2 + 6 a + 1.2) / (L^2 (3 a + 1)), a = B / D. Arguments in m, m^4 and t; they
    are converted here. Raises ArgumentError.
    Provenance: phi from E. C. Tupper, Introduction to Naval Architecture, p. 293; r_s from memory, medium confidence.
    """
    _positive(second_moment=second_moment, depth=depth, length=length, displacement_t=displacement_t)
    factors = {"perpendiculars": 200000.0, "overall": 220000.0}
    if length_kind not in factors:
        raise ArgumentError(f"length_kind is {length_kind!r}; give 'perpendiculars' or 'overall'.")
    ratio = breadth / depth
    shear = 3.5 * (depth / length) ** 2 * (3.0 * ratio**3 + 9.0 * ratio**2 + 6.0 * ratio + 1.2) / (3.0 * ratio + 1.0)
    water = burrill_virtual_mass_factor(breadth=breadth, draught=draught)
    imperial = second_moment * _IN2_FT2_PER_M4
    stiffness = imperial * _TONNES_PER_LONG_TON / (displacement_t * (length * _FEET_PER_METRE) ** 3)
    two_node = factors[length_kind] * np.sqrt(stiffness / (water * (1.0 + shear)))
    return np.array([two_node * _RAD_S_PER_CPM])


def todd_virtual_mass_factor(*, breadth: float, draught: float) -> float:
    """Virtual over true displacement after Todd, 1.2 + B / (3 T); breadth and draught in m."""
    _positive(breadth=breadth, draught=draught)
    return 1.2 + breadth / (3.0 * draught)


def burrill_virtual_mass_factor(*, breadth: float, draught: float) -> float:
    """Virtual over true displacement after Burrill, 1 + B / (2 T); breadth and draught in m."""
    _positive(breadth=breadth, draught=draught)
    return 1.0 + breadth / (2.0 * draught)


def hollow_box_second_moment(breadth: float, depth: float, thickness: float) -> float:
    """Second moment of a hollow rectangle about its horizontal axis in m^4, exact.

    I = (B D^3 - (B - 2 t) (D - 2 t)^3) / 12, outer breadth B, outer depth D and wall thickness t in m.
    Raises ArgumentError.
    """
    _positive(breadth=breadth, depth=depth, thickness=thickness)
    if 2.0 * thickness >= min(breadth, depth):
        raise ArgumentError(f"thickness is {thickness:g} m; it must be below half the breadth and half the depth.")
    return (breadth * depth**3 - (breadth - 2.0 * thickness) * (depth - 2.0 * thickness) ** 3) / 12.0


def _sr94(two_node: float, three_node: float, as_printed: bool) -> Array:
    four_node = (4.0 if as_printed else 3.0) * two_node
    return np.array([two_node, three_node, four_node]) * _RAD_S_PER_CPM


def _positive(**values: float) -> None:
    for key, value in values.items():
        if not (np.isfinite(value) and value > 0.0):
            raise ArgumentError(f"{key} is {value}; give a finite number above 0.")
