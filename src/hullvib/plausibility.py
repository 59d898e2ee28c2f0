"""Limits outside which a girder's figures are those of no hull: a wrong unit, most likely."""

from __future__ import annotations

from hullvib.modes import Modes

SHORTEST_SHIP_M = 30.0
"""Shorter girders may be models or test beams: they get wider limits for the frequency and none for the mass."""


def frequency_limits_hz(length_m: float) -> tuple[float, float]:
    """Lowest and highest first frequency of a hull of that length.

    Of ships, f1 L is some 100 to 600 m/s. A mass in tonnes raises it, and a rigidity in kN m2 lowers it, thirtyfold;
    the limits, 30 and 3000 m/s, lie between.
    """
    return (30.0 / length_m, 3000.0 / length_m) if length_m >= SHORTEST_SHIP_M else (0.05, 50.0)


def mean_mass_limits_kg_per_m(length_m: float) -> tuple[float, float]:
    """Lowest and highest mean mass per length of a hull of that length.

    A loaded ship has rho B T Cb, some 2 to 10 times L^2 in kg/m, and a light one a quarter of that; the limits,
    0.1 and 50 L^2, lie a factor of five outside.
    """
    return (0.1 * length_m**2, 50.0 * length_m**2) if length_m >= SHORTEST_SHIP_M else (0.0, float("inf"))


def implausible(modes: Modes) -> list[str]:
    """Sentences on a first frequency or a mean mass that no hull has: the number, the limits, the remedy."""
    length = modes.girder.length
    found = []
    first, (lowest, highest) = float(modes.frequencies_hz[0]), frequency_limits_hz(length)
    if not lowest <= first <= highest:
        found.append(
            f"the first frequency is {first:.3g} Hz, outside {lowest:.2g} .. {highest:.2g} Hz where hulls of "
            f"{length:.4g} m lie; check the units: mass in kg/m (not t/m), flexural rigidity in N m^2 (not kN m^2), "
            "x in m."
        )
    mean, (lightest, heaviest) = modes.girder.total_mass / length, mean_mass_limits_kg_per_m(length)
    if not lightest <= mean <= heaviest:
        found.append(
            f"the mean mass is {mean:.3g} kg/m, outside {lightest:.2g} .. {heaviest:.2g} kg/m where hulls of "
            f"{length:.4g} m lie; check the unit: kg/m (not t/m), x in m."
        )
    return found
