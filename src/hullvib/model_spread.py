"""The model's own uncertainty of a frequency: what scantlings, shear area and weights leave open, to first order.

With s_n the share of the mode's strain energy that is shear,

    d ln w_n = (1 - s_n) / 2 d ln EI + s_n / 2 d ln kGA - 1/2 d ln m,

and the three, taken as independent, add by their squares. In the ratio of two modes' frequencies the same EI, kGA and m
stand twice, so that only the difference of their shares counts:

    d ln (w_n / w_1) = (s_n - s_1) / 2 (d ln kGA - d ln EI).

It has nothing to do with the numerical error of the beam solution, which is smaller by many powers of ten; nor does it
know that EI, kGA or m may be wrong in one part of the ship and right in another.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hullvib.energies import energy_rule, strain_terms
from hullvib.modes import Modes

Array = NDArray[np.float64]

MASS_SPREAD = 0.05
"""Of the vibrating mass, added mass included: weights of a design, 3 %, and what methods of added mass differ by."""
FLEXURAL_SPREAD = 0.10
"""Of EI: corrosion margins, effective breadth, superstructures."""
SHEAR_SPREAD = 0.30
"""Of kGA, the least known: side plating, longitudinal bulkheads and openings weigh more here than in EI."""


def shear_energy_shares(modes: Modes) -> Array:
    """Strain energy of shear over the whole strain energy of each mode, (modes,); 0 for theories without shear."""
    field, count = modes.field, len(modes.angular_frequencies)
    rule = energy_rule(modes.girder, [field], count, np.array([]))
    energies = [
        (values**2) @ (rule.of(coefficients) * rule.weights.ravel())
        for coefficients, values in strain_terms(modes.girder, field, rule.xi.ravel(), shear=modes.shear_flexible)
    ]
    whole = np.sum(energies, axis=0)
    return np.asarray((whole - energies[0]) / whole, dtype=np.float64)


def model_uncertainty(
    modes: Modes, mass: float = MASS_SPREAD, flexural: float = FLEXURAL_SPREAD, shear: float = SHEAR_SPREAD
) -> Array:
    """u_n: relative uncertainty of each natural frequency, (modes,), from those of m, EI and kGA as a whole."""
    share = shear_energy_shares(modes)
    return np.asarray(0.5 * np.sqrt(((1 - share) * flexural) ** 2 + (share * shear) ** 2 + mass**2), dtype=np.float64)


def ratio_uncertainty(modes: Modes, flexural: float = FLEXURAL_SPREAD, shear: float = SHEAR_SPREAD) -> Array:
    """Relative uncertainty of each natural frequency over the first, (modes,), from those of EI and kGA as a whole.

    0 for the first mode, and for theories without shear; the mass as a whole drops out.
    """
    share = shear_energy_shares(modes)
    return np.asarray(0.5 * np.abs(share - share[0]) * np.hypot(flexural, shear), dtype=np.float64)
