"""Weight estimates for early design after Watson & Gilfillan (1976) and Watson, Practical Ship Design (1998).

Weights are in tonnes, lengths in metres, power in kilowatts, as the formulas have them.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from hullform.loading.gravity import GRAVITY_M_S2
from hullform.ship import Particulars, ShipType
from hullform.ship_operation import METRES_PER_NAUTICAL_MILE
from hullform.ship_structure import Superstructure

KNOTS_PER_M_S = 3600.0 / METRES_PER_NAUTICAL_MILE
# Slow-running diesel engine, dry, with its gearing and shafting left out (Practical Ship Design, p. 110).
SLOW_DIESEL_T_PER_KW = 0.037
# A house so broad, of the ship's breadth, is an erection from side to side.
FROM_SIDE_TO_SIDE = 0.95
# The ratio within which an estimate with a guessed speed is worth believing: a factor of two either way.
LIGHT_SHIP_FACTOR = 2.0


@dataclass(frozen=True)
class TypeFigures:
    """What the estimates need to know of a ship type.

    Attributes:
        steel_k: K of the steel weight (Practical Ship Design, table 4.1, p. 85).
        steel_k_spread: the scatter of K in the same table; 10 % of K, ours, where the table gives none.
        numeral_range_m2: of the ships behind K in the same table; None where it gives none.
        outfit_t_m2: outfit weight over L B at the usual size of the type, read off figure 4.13; None where the
            figure has no such type.
        remainder: factor of the machinery remainder, K P^0.70.
        froude_number: of the usual service speed, a guess of ours; None where no outfit is known either.
    """

    steel_k: float
    steel_k_spread: float
    numeral_range_m2: tuple[float, float] | None
    outfit_t_m2: float | None = None
    remainder: float = 0.69
    froude_number: float | None = None


TYPE_FIGURES: dict[ShipType, TypeFigures] = {
    "tanker": TypeFigures(0.032, 0.003, (1500.0, 40000.0), 0.21, 0.72, 0.16),
    "chemical-tanker": TypeFigures(0.036, 0.001, (1900.0, 2500.0), 0.28, 0.72, 0.20),
    "bulk-carrier": TypeFigures(0.031, 0.002, (3000.0, 15000.0), 0.22, 0.69, 0.16),
    "container": TypeFigures(0.036, 0.003, (6000.0, 13000.0), 0.34, 0.69, 0.25),
    "refrigerated-cargo": TypeFigures(0.034, 0.002, (4000.0, 6000.0), 0.40, 0.69, 0.25),
    "coaster": TypeFigures(0.030, 0.002, (1000.0, 2000.0), 0.40, 0.69, 0.22),
    "offshore-supply": TypeFigures(0.045, 0.005, (800.0, 1300.0)),
    "tug": TypeFigures(0.044, 0.002, (350.0, 450.0)),
    "research": TypeFigures(0.045, 0.002, (1350.0, 1500.0)),
    "ro-ro-ferry": TypeFigures(0.031, 0.006, (2000.0, 5000.0)),
    "passenger": TypeFigures(0.038, 0.001, (5000.0, 15000.0), 0.80, 0.83, 0.25),
    "frigate": TypeFigures(0.023, 0.0023, None),
}


@dataclass(frozen=True)
class Estimate:
    """An estimated weight in tonnes with the range that its source supports."""

    weight_t: float
    lower_t: float
    upper_t: float


@dataclass(frozen=True)
class MachineryAndOutfit:
    """Estimates in tonnes: main engine with the remainder of the machinery, and outfit."""

    machinery_t: float
    outfit_t: float

    @property
    def together(self) -> Estimate:
        """Their sum; its range is a factor of two either way, as wide as a guessed speed and outfit make it."""
        weight_t = self.machinery_t + self.outfit_t
        return Estimate(weight_t, weight_t / LIGHT_SHIP_FACTOR, weight_t * LIGHT_SHIP_FACTOR)


def hull_numeral(particulars: Particulars, houses: Iterable[Superstructure] = ()) -> float:
    """Watson & Gilfillan's steel numeral E = L (B + T) + 0.85 L (D - T) + 0.85 l1 h1 + 0.75 l2 h2, in m2.

    L is between perpendiculars; l1, h1 are length and height of erections from side to side, l2, h2 those of houses.
    (Practical Ship Design, p. 82.)
    """
    length = particulars.length_between_perpendiculars_m
    freeboard = particulars.depth_m - particulars.draught_m
    erected = 0.0
    for house in houses:
        first = 0.0 if house.from_m is None else house.from_m
        last = particulars.length_overall_m if house.to_m is None else house.to_m
        share = 0.85 if house.breadth_m >= FROM_SIDE_TO_SIDE * particulars.breadth_m else 0.75
        erected += share * (last - first) * house.height_m
    return length * (particulars.breadth_m + particulars.draught_m) + 0.85 * length * freeboard + erected


def steel_weight(particulars: Particulars, block_coefficient: float, houses: Iterable[Superstructure] = ()) -> Estimate:
    """Steel weight W = K E^1.36 [1 + 0.5 (Cb' - 0.70)], Cb' = Cb + (1 - Cb) (0.8 D - T) / (3 T).

    Args:
        particulars: of the ship; lengths in metres.
        block_coefficient: at the draught, with LPP.
        houses: on her upper deck, as far as [structure] has them.

    Returns:
        The weight at the mean K of the ship's type and the range of the K in the source's table.

    Source: Watson, Practical Ship Design, eqs. 4.2 and 4.3 and table 4.1, pp. 82-85.
    """
    draught, depth = particulars.draught_m, particulars.depth_m
    cb_at_80_percent = block_coefficient + (1 - block_coefficient) * (0.8 * depth - draught) / (3 * draught)
    figures = TYPE_FIGURES[particulars.type]
    per_k = hull_numeral(particulars, houses) ** 1.36 * (1 + 0.5 * (cb_at_80_percent - 0.70))
    return Estimate(
        weight_t=figures.steel_k * per_k,
        lower_t=(figures.steel_k - figures.steel_k_spread) * per_k,
        upper_t=(figures.steel_k + figures.steel_k_spread) * per_k,
    )


def installed_power_kw(particulars: Particulars, displacement_t: float, froude_number: float) -> float:
    """A guess of the installed power: P = Delta^(2/3) V^3 / C, C = 26 (sqrt(L) + 150 / V), V in knots.

    V = Fn sqrt(g L). Source: the Admiralty coefficient with the approximation of C in Barrass, Ship Design and
    Performance for Masters and Mates (2004), from memory.
    """
    length = particulars.length_between_perpendiculars_m
    speed_knots = froude_number * math.sqrt(GRAVITY_M_S2 * length) * KNOTS_PER_M_S
    coefficient = 26.0 * (math.sqrt(length) + 150.0 / speed_knots)
    return float(displacement_t ** (2 / 3) * speed_knots**3 / coefficient)


def machinery_and_outfit(particulars: Particulars, displacement_t: float) -> MachineryAndOutfit | None:
    """Machinery 0.037 P + K_r P^0.70, with P of `installed_power_kw` and a slow diesel engine, and outfit C_o L B.

    None for types of which no outfit figure is at hand. Source: Watson, Practical Ship Design, pp. 109-110 (machinery),
    figure 4.13 (outfit).
    """
    figures = TYPE_FIGURES[particulars.type]
    if figures.outfit_t_m2 is None or figures.froude_number is None:
        return None
    power_kw = installed_power_kw(particulars, displacement_t, figures.froude_number)
    return MachineryAndOutfit(
        machinery_t=SLOW_DIESEL_T_PER_KW * power_kw + figures.remainder * float(power_kw**0.70),
        outfit_t=figures.outfit_t_m2 * particulars.length_between_perpendiculars_m * particulars.breadth_m,
    )
