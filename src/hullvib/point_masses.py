"""Masses without extent, which stand at one position of a girder."""

from __future__ import annotations

import math
from dataclasses import dataclass

from hullvib.errors import GirderError


@dataclass(frozen=True, slots=True)
class PointMass:
    """A mass at one position: x_m (m), mass_kg (kg), rotary inertia about its own centre (kg m^2)."""

    x_m: float
    mass_kg: float
    rotary_inertia_kg_m2: float = 0.0

    def __post_init__(self) -> None:
        for key in ("x_m", "mass_kg", "rotary_inertia_kg_m2"):
            value = getattr(self, key)
            try:
                number = float(value) + 0.0
            except (TypeError, ValueError, OverflowError):
                number = float("nan")
            if not math.isfinite(number) or (key != "x_m" and number < 0.0):
                raise GirderError(f"point mass: {key} is {value!s:.40}; give a finite number, not negative.")
            object.__setattr__(self, key, number)
