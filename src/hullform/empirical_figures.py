"""In-water frequencies of a condition by the empirical formulas, each with the length and virtual mass of its own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.loading.structure import Structure
from hullform.ship import Ship, ShipType
from hullvib import empirical

Array = NDArray[np.float64]

# Kumai's exponent is published for three kinds of ship; bulk carriers and tankers have their own.
KUMAI_KINDS: dict[ShipType, str] = {"tanker": "tanker", "chemical-tanker": "tanker", "bulk-carrier": "bulk"}


@dataclass(frozen=True, eq=False)
class EmpiricalFigures:
    """In-water frequencies of one condition, rad/s, mode 1 first, with the inputs of the formulas."""

    figures_rad_s: Mapping[str, Array]
    inputs: Mapping[str, float]


def in_water_figures(ship: Ship, structure: Structure, displacement_t: float, draught_m: float) -> EmpiricalFigures:
    """Todd and Schlick as the paper has them (length overall), Kumai and Burrill with LPP and the midship I.

    Args:
        ship: with its [structure].
        structure: for the midship second moment, the equivalent-thickness factor included.
        displacement_t: mass of the condition.
        draught_m: of the condition, on even keel.
    """
    given, _, _ = ship.require_sections_of_a_run()
    of_ship = ship.particulars
    length = ship.empirical.length_m or of_ship.length_overall_m
    perpendiculars = of_ship.length_between_perpendiculars_m
    breadth, depth = of_ship.breadth_m, of_ship.depth_m
    midship = structure.midship_second_moment_m4
    box = empirical.hollow_box_second_moment(breadth, depth, given.shell_thickness_m)
    exponent = empirical.KUMAI_EXPONENTS[KUMAI_KINDS.get(of_ship.type, "cargo")]

    def todd(as_printed: bool) -> Array:
        return empirical.todd(
            breadth=breadth, depth=depth, length=length, displacement_t=displacement_t, as_printed=as_printed
        )

    def schlick(second_moment: float) -> Array:
        return empirical.schlick(second_moment=second_moment, length=length, displacement_t=displacement_t)

    figures = {
        "todd": todd(as_printed=False),
        "todd_as_printed": todd(as_printed=True),
        "schlick": schlick(midship),
        "schlick_hollow_box": schlick(box),
        "kumai": empirical.kumai(
            second_moment=midship,
            breadth=breadth,
            draught=draught_m,
            length=perpendiculars,
            displacement_t=displacement_t,
            exponent=exponent,
        ),
        "burrill": empirical.burrill(
            second_moment=midship,
            breadth=breadth,
            depth=depth,
            draught=draught_m,
            length=perpendiculars,
            displacement_t=displacement_t,
        ),
    }
    inputs = {
        "length_m": length,
        "length_between_perpendiculars_m": perpendiculars,
        "breadth_m": breadth,
        "depth_m": depth,
        "draught_m": draught_m,
        "displacement_t": displacement_t,
        "midship_second_moment_m4": midship,
        "hollow_box_second_moment_m4": box,
        "kumai_exponent": exponent,
        "todd_virtual_mass_factor": empirical.todd_virtual_mass_factor(breadth=breadth, draught=draught_m),
        "burrill_virtual_mass_factor": empirical.burrill_virtual_mass_factor(breadth=breadth, draught=draught_m),
    }
    return EmpiricalFigures(figures, inputs)
