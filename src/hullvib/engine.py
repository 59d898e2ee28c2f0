"""External moments of a two-stroke engine: how they grow with speed, and whether they are large for her power.

Source: MAN B&W S80MC-C7/ME-C7 project guide, 17.04 (198 46 79-8.2): M(n) = M(n1) (n / n1)^2, power-related unbalance
PRU = M / P in N m per kW, and the need of a compensator by service experience: 0 to 60 not relevant, 60 to 120
unlikely, 120 to 220 likely, above 220 most likely.
"""

from __future__ import annotations

import math
from typing import Literal

from hullvib.errors import ArgumentError

Need = Literal["not relevant", "unlikely", "likely", "most likely"]

PRU_LIMITS: tuple[tuple[float, Need], ...] = ((60.0, "not relevant"), (120.0, "unlikely"), (220.0, "likely"))
"""Upper limit in N m/kW of each class but the last."""


def moment_at(moment: float, rated_rpm: float, speed_rpm: float) -> float:
    """An external moment given at one speed, at another, in its own unit: inertia forces go with the speed squared.

    Raises ArgumentError.
    """
    if not (rated_rpm > 0.0 and speed_rpm >= 0.0):
        raise ArgumentError(f"engine speeds are {rated_rpm} and {speed_rpm} rpm; give numbers above 0.")
    return moment * (speed_rpm / rated_rpm) ** 2


def power_related_unbalance(moment_n_m: float, power_kw: float) -> float:
    """PRU = M / P in N m/kW, both at the same rating. Raises ArgumentError."""
    if not (math.isfinite(power_kw) and power_kw > 0.0):
        raise ArgumentError(f"engine power is {power_kw} kW; give a finite number above 0.")
    return moment_n_m / power_kw


def need_for_compensator(unbalance: float) -> Need:
    """The class of a power-related unbalance in N m/kW; a limit belongs to the class above it."""
    return next((need for limit, need in PRU_LIMITS if unbalance < limit), "most likely")
