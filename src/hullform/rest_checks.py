"""Checks of a ship at rest: trim and freeboard in equilibrium, given draughts, balance of weight and buoyancy."""

from __future__ import annotations

import math

from hullform.checks import (
    DISPLACEMENT_LIMIT_PERCENT,
    LCB_LIMIT_PERCENT_LPP,
    Check,
    deviation,
)
from hullform.rounding import significant

# Trim beyond which her weights are more likely wrong than meant (by the stern, by the bow).
TRIM_BY_STERN_LIMIT_PERCENT_LPP = 1.5
TRIM_BY_BOW_LIMIT_PERCENT_LPP = 0.5
# A deck may be under water by this share of the depth: a hull drawn to her waterline is read to no better.
DECK_UNDER_WATER_LIMIT_PERCENT_DEPTH = 0.5
# BM_L is near LPP: a lever of LCB_LIMIT_PERCENT_LPP trims a ship by about as much.
GIVEN_TRIM_LIMIT_PERCENT_LPP = LCB_LIMIT_PERCENT_LPP
# Balanced weights and buoyancy close to round-off; what is left is a position that does not carry her.
CLOSING_LIMIT_PERCENT = 0.01


def check_trim(lever_m: float, trim_m: float, length_m: float) -> Check:
    """The trim of her weights, by the stern positive.

    Args:
        lever_m: from the centre of gravity forward to that of buoyancy on even keel.
        trim_m: over the length between perpendiculars.
        length_m: between perpendiculars.
    """
    side = "abaft" if lever_m > 0 else "forward of"
    return Check(
        "trim",
        f"trim, by the stern positive, with LCG {significant(abs(lever_m))} m {side} LCB on even keel",
        100 * trim_m / length_m,
        (-TRIM_BY_BOW_LIMIT_PERCENT_LPP, TRIM_BY_STERN_LIMIT_PERCENT_LPP),
        "% of LPP",
        "spread the weights so that LCG meets LCB, or add ballast; check aft_side, where the picture of a body plan "
        "may have been taken the wrong way round",
    )


def check_freeboard(least_freeboard_m: float, depth_m: float) -> Check:
    """The least height of the deck above the waterline that carries the weights."""
    return Check(
        "freeboard",
        "least height of the deck above the waterline that carries the weights",
        least_freeboard_m,
        (-DECK_UNDER_WATER_LIMIT_PERCENT_DEPTH / 100 * depth_m, math.inf),
        "m",
        "her deck would be under water: check where the weights lie, the depth and the body plan to the deck",
    )


def check_given_draughts(displacement_kg: float, mass_kg: float) -> Check:
    """What the hull displaces at given draughts against the mass of the condition."""
    return deviation(
        "given-draughts",
        "displacement at the given draughts against the mass of this condition",
        100 * (displacement_kg / mass_kg - 1),
        DISPLACEMENT_LIMIT_PERCENT,
        "%",
        "check draught_aft_m, draught_fore_m and the weights",
    )


def check_given_trim(given_m: float, trim_m: float, length_m: float) -> Check:
    """The trim of given draughts against that which carries the weights."""
    return deviation(
        "given-trim",
        "trim of the given draughts less that which carries the weights, by the stern positive",
        100 * (given_m - trim_m) / length_m,
        GIVEN_TRIM_LIMIT_PERCENT_LPP,
        "% of LPP",
        "check draught_aft_m, draught_fore_m and where the weights lie",
    )


def check_closing(residual: float) -> Check:
    """What is left of the still-water bending moment at the fore end, over the largest along her."""
    return Check(
        "closing",
        "bending moment in still water left at the fore end, over the largest",
        100 * residual,
        (-math.inf, CLOSING_LIMIT_PERCENT),
        "%",
        "weight and buoyancy do not balance: no waterline of a moderate trim carries these weights",
    )
