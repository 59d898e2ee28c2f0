"""Ships drawn from waterlines: a midship section narrowed by a run and an entrance, with a bulb and a transom."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from generator.hulls import Bulb, Midship, Rise, Run, Sheer, WaterlineHull
from generator.sections import Dimensions, evenly

from drawing.moulded import Array, Moulded
from drawing.tables import PARTICULARS, Particulars

_INTERVALS = 60


@dataclass(frozen=True)
class WaterlineForm(Moulded):
    """A ship by formula, with sections of one curve or two (bulb and flare)."""

    name: str
    particulars: Particulars
    hull: WaterlineHull

    def curves(self, x: float, n: int = 400) -> list[Array]:
        """Return the section's curves at x, each n points from its keel upwards at equal steps of arc."""
        if not 0.0 <= x <= self.particulars.length_overall_m:
            raise ValueError(f"x = {x} m is outside {self.name}: 0 to {self.particulars.length_overall_m} m")
        return [evenly(curve, n) for curve in self.hull.section(x)]

    def deck_edge(self, x: float) -> tuple[float, float]:
        """Return half-breadth and height of the deck edge at x."""
        top = self.hull.sheer(x)
        return self.half_breadth_at(x, top), top

    def half_breadth_at(self, x: float, height: float) -> float:
        """Return the half-breadth at a height."""
        return float(self.hull.half_breadths(x, np.array([height]))[0])

    def section_area(self, x: float, draught: float) -> float:
        """Return the immersed sectional area at x, both sides, m^2 (trapezoids over the curves)."""
        area = 0.0
        for curve in self.hull.section(x):
            y, z = curve[:, 0], np.minimum(curve[:, 1], draught)
            area += float(np.sum((y[1:] + y[:-1]) * np.diff(z)))
        return area

    def breaks(self) -> Array:
        """Return equal steps over the length."""
        return np.linspace(0.0, self.particulars.length_overall_m, _INTERVALS + 1)


def _stem(main: Particulars, foot_m: float, top_m: float) -> Rise:
    """The stem's profile: from x = foot_m low down to LOA at the stem head, through the waterline's end.

    The design waterline ends at the forward perpendicular, which settles the height where the stem leaves its foot:
    x = foot + (LOA - foot) s^2 (3 - 2 s) has s = 1/2 - sin(arcsin(1 - 2 r) / 3) at the share r of its way.
    """
    forward = main.aft_perpendicular_m + main.length_between_perpendiculars_m
    share = (forward - foot_m) / (main.length_overall_m - foot_m)
    s = 0.5 - np.sin(np.arcsin(1.0 - 2.0 * share) / 3.0)
    return Rise(foot_m, main.length_overall_m, float((main.draught_m - s * top_m) / (1.0 - s)), top_m)


def handymax_bulk_carrier() -> WaterlineForm:
    """Full, with a long parallel body, a bulb under a flared bow and a transom just in the water."""
    main = PARTICULARS["handymax-bulk-carrier"]
    length, depth, draught = main.length_overall_m, main.depth_m, main.draught_m
    sheer = Sheer(depth, length)
    hull = WaterlineHull(
        Dimensions(length, main.breadth_m, depth, draught),
        sheer,
        Midship(main.breadth_m / 2, 1.9),
        aft=Run(
            Rise(0.35 * length, 0.28 * length, 0.0, depth),
            Rise(0.056 * length, -0.055 * length, 0.50 * draught, 1.14 * draught),
            Rise(2.0, 2.5, 0.0, depth),
            Rise(1.75, 0.50, 0.0, 1.4 * draught),
        ),
        fore=Run(
            Rise(0.73 * length, 0.77 * length, 0.0, depth),
            _stem(main, 0.945 * length, depth),
            Rise(2.4, 2.6, 0.0, depth),
            Rise(1.10, 0.72, 0.0, draught),
        ),
        bulb=Bulb(2.5, 4.3, 4.7, 0.86 * length, 0.988 * length),
    )
    return WaterlineForm("handymax-bulk-carrier", main, hull)


def fast_ropax() -> WaterlineForm:
    """Fine and fast: rise of floor, a cut-up stern with its transom in the water, a bulb under a flared bow."""
    main = PARTICULARS["fast-ropax"]
    length, depth, draught = main.length_overall_m, main.depth_m, main.draught_m
    sheer = Sheer(depth, length)
    hull = WaterlineHull(
        Dimensions(length, main.breadth_m, depth, draught),
        sheer,
        Midship(main.breadth_m / 2, 2.2, np.radians(3.5)),
        aft=Run(
            Rise(0.50 * length, 0.40 * length, 0.0, depth),
            Rise(0.12 * length, -0.10 * length, 0.1 * draught, 1.30 * draught),
            Rise(1.8, 2.6, 0.0, depth),
            Rise(1.30, 0.42, 0.0, 1.3 * draught),
        ),
        fore=Run(
            Rise(0.44 * length, 0.60 * length, 0.0, depth),
            _stem(main, 0.922 * length, depth),
            Rise(1.7, 2.2, 0.2 * draught, depth),
            Rise(1.5, 0.75, 0.2 * draught, depth),
        ),
        bulb=Bulb(1.75, 2.75, 2.78, 0.80 * length, 0.982 * length),
    )
    return WaterlineForm("fast-ropax", main, hull)
