"""A hull after the main particulars alone: rectellipse sections under a sectional-area curve, marked as no drawing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.doors.area_curve import AreaCurve, area_curve, lcb_share, midship_coefficient
from hullform.errors import BodyPlanError
from hullform.hull.arcs import curve_points
from hullform.hull.super_ellipse import moment_below
from hullform.rounding import significant
from hullform.ship import Particulars, Ship
from hullform.ship_body_plan import ParticularsSource

Array = NDArray[np.float64]

# Of LPP, from the aft perpendicular.
_PLACES = np.array(
    [0, 0.0125, 0.025, 0.05, 0.075, *np.arange(0.1, 0.9001, 0.05), 0.925, 0.95, 0.975, 0.9875, 1.0], dtype=np.float64
)
# Of the overhangs, from the perpendicular to the end.
_OVERHANG = np.array([0.5, 1.0])
_POINTS = 49
# A freeboard of this share of the depth, or more, has a counter, a transom and a raking stem above the water; without
# any the ends are upright, as Wigley's.
_FULL_ENDS_FREEBOARD = 0.15
# Of LPP: the lengths over which the keel rises to the waterline, aft and fore.
_COUNTER, _FOREFOOT = 0.12, 0.03
# Of the freeboard: by which the counter rises further to the aft end.
_COUNTER_RISE = 0.4
# The deck: breadth of the transom over her own, lengths over LOA in which it comes to the full breadth, and the power
# of its ends.
_TRANSOM, _DECK_AFT, _DECK_FORE, _DECK_POWER = 0.7, 0.3, 0.25, 3.0
# Waterline ends over those of the areas: (A / Am)^0.75, between sections that keep their breadth and those that keep
# their depth.
_WATERLINE_POWER = 0.75
# Exponents p = q of the sections.
_LEAST_EXPONENT, _GREATEST_EXPONENT = 0.4, 30.0
_HALVINGS = 50
# Those of sections that are all above the water: a round counter, a straight flare.
_COUNTER_EXPONENT, _FLARE_EXPONENT = 2.0, 1.0
# Of its box: a section at the ends is no fuller.
_FULLEST = 0.95
_NOTHING = 1e-6


@dataclass(frozen=True)
class Form:
    """What the form of a ship without a drawing is made of.

    Attributes:
        block_coefficient, midship_coefficient: with LPP, breadth and draught.
        lcb_share: LCB over LPP, forward of midships positive.
        curve: of the sectional areas.
    """

    block_coefficient: float
    midship_coefficient: float
    lcb_share: float
    curve: AreaCurve


def form_of(ship: Ship, source: ParticularsSource) -> Form:
    """The given coefficients, and estimates of those that are not.

    Raises:
        BodyPlanError: neither block coefficient nor displacement, or coefficients that make no ship.
    """
    main = ship.particulars
    box = main.length_between_perpendiculars_m * main.breadth_m * main.draught_m
    block = main.block_coefficient
    if block is None:
        if main.displacement_t is None:
            raise BodyPlanError(
                f"{ship.path}: [body_plan] gives neither picture (image), table (offsets) nor mesh; for a form made "
                "of the main particulars give block_coefficient or displacement_t in [ship]"
            )
        block = 1e3 * main.displacement_t / (ship.water.density_kg_m3 * box)
        if not block < 1:
            raise BodyPlanError(
                f"{ship.path}: displacement_t = {main.displacement_t:g} is {block:.3g} times the box of length "
                "between perpendiculars, breadth and draught; correct one of the four"
            )
    midship = source.midship_coefficient
    if midship is None:
        midship = midship_coefficient(block)
    length = main.length_between_perpendiculars_m
    given = main.lcb_from_midships_m
    lcb = lcb_share(block / midship) if given is None else given / length
    try:
        return Form(block, midship, lcb, area_curve(block, midship, lcb, source.parallel_body_share))
    except BodyPlanError as error:
        raise BodyPlanError(f"{ship.path}: {error}") from None


def form_after_particulars(ship: Ship, source: ParticularsSource) -> BodyPlan:
    """Stations of a ship of which the main particulars are all that is known.

    Each is one rectellipse from the keel to a level deck, with p = q such that the area below the design draught is
    that of the sectional-area curve.

    Raises:
        BodyPlanError: as `form_of`.
    """
    form, main = form_of(ship, source), ship.particulars
    x = _places(main, form.curve)
    keel, half_breadth = _keel(main, x), _deck_half_breadth(main, form.curve, x)
    area = form.midship_coefficient * main.breadth_m * main.draught_m * form.curve(_share(main, x))
    depth, immersed = main.depth_m - keel, np.maximum(main.draught_m - keel, 0.0)
    # so broad that the area has room
    room = np.divide(area, 2 * _FULLEST * immersed, out=np.zeros_like(area), where=immersed > 0)
    half_breadth = np.minimum(np.maximum(half_breadth, room), main.breadth_m / 2)
    exponent = _exponents(half_breadth, depth, depth - immersed, area)
    dry = immersed <= _NOTHING * main.draught_m
    exponent[dry] = np.where(_share(main, x[dry]) < 0.5, _COUNTER_EXPONENT, _FLARE_EXPONENT)
    y, zeta = curve_points(half_breadth, depth, exponent, exponent, _POINTS)
    midships = main.aft_perpendicular_m + main.length_between_perpendiculars_m / 2
    stations = tuple(
        Station(float(at), "aft" if at < midships else "fore", (TracedCurve(b, main.depth_m - down),), f"{at:.2f}")
        for at, b, down in zip(x, y, zeta, strict=True)
    )
    return BodyPlan(stations, "particulars", notes=_notes(ship, source, form), doubts=(_NO_DRAWING,))


_NO_DRAWING = (
    "there is no drawing: the hull is a form made of the main particulars, good for a first look and no more; give a "
    "picture (image), a table (offsets) or a mesh in [body_plan]"
)


def _notes(ship: Ship, source: ParticularsSource, form: Form) -> tuple[str, ...]:
    main, curve = ship.particulars, form.curve
    block = "given" if main.block_coefficient is not None else "of the given displacement"
    midship = "given" if source.midship_coefficient is not None else "estimated (Kerlen)"
    lcb = "given" if main.lcb_from_midships_m is not None else "estimated of the prismatic coefficient"
    body = "given" if source.parallel_body_share is not None else "as of Series 60"
    return (
        f"made of the main particulars, not drawn: block coefficient {significant(form.block_coefficient)}, {block}; "
        f"midship coefficient {significant(form.midship_coefficient)}, {midship}; LCB "
        f"{significant(100 * form.lcb_share)} % of LPP forward of midships, {lcb}",
        f"sectional areas 1 − (1 − s)^{significant(curve.exponent)} along entrance and run, "
        f"{significant(100 * curve.entrance)} and {significant(100 * curve.run)} % of LPP, with "
        f"{significant(100 * curve.parallel_body)} % of parallel body ({body}), swung to the LCB",
    )


def _share(main: Particulars, x: Array) -> Array:
    """Places over LPP, 0 at the aft perpendicular."""
    return (x - main.aft_perpendicular_m) / main.length_between_perpendiculars_m


def _places(main: Particulars, curve: AreaCurve) -> Array:
    """x of the stations: between the perpendiculars, at the shoulders of the areas, and in the overhangs."""
    aft, length = main.aft_perpendicular_m, main.length_between_perpendiculars_m
    overhang = main.length_overall_m - aft - length
    parts = [aft + length * np.append(_PLACES, curve.shoulders)]
    parts += [aft * (1 - _OVERHANG)] * (aft > 0) + [aft + length + overhang * _OVERHANG] * (overhang > 0)
    return np.unique(np.concatenate(parts).round(3))


def _fullness_of_ends(main: Particulars) -> float:
    """0 for upright ends without a deck beyond the waterline, 1 for those of a ship with freeboard."""
    return float(np.clip((main.depth_m - main.draught_m) / (_FULL_ENDS_FREEBOARD * main.depth_m), 0.0, 1.0))


def _keel(main: Particulars, x: Array) -> Array:
    """Heights of the keel: it rises to the waterline at both perpendiculars, and beyond them to the deck."""
    u, ends, freeboard = _share(main, x), _fullness_of_ends(main), main.depth_m - main.draught_m
    rise = np.clip(1 - u / _COUNTER, 0.0, 1.0) ** 2 + np.clip((u - 1 + _FOREFOOT) / _FOREFOOT, 0.0, 1.0) ** 2
    beyond_aft = np.clip(-u * main.length_between_perpendiculars_m / max(main.aft_perpendicular_m, 1e-9), 0.0, 1.0)
    overhang = main.length_overall_m - main.aft_perpendicular_m - main.length_between_perpendiculars_m
    beyond_fore = np.clip((u - 1) * main.length_between_perpendiculars_m / max(overhang, 1e-9), 0.0, 1.0)
    return np.asarray(ends * (rise * main.draught_m + freeboard * (_COUNTER_RISE * beyond_aft + 0.98 * beyond_fore)))


def _deck_half_breadth(main: Particulars, curve: AreaCurve, x: Array) -> Array:
    """Half-breadths of the deck: that of a ship with freeboard, or the waterline where there is none."""
    length, ends = main.length_overall_m, _fullness_of_ends(main)
    aft, fore = np.clip(x / (_DECK_AFT * length), 0.0, 1.0), np.clip((length - x) / (_DECK_FORE * length), 0.0, 1.0)
    deck = (1 - (1 - _TRANSOM) * (1 - aft) ** _DECK_POWER) * (1 - (1 - fore) ** _DECK_POWER)
    waterline = curve(_share(main, x)) ** _WATERLINE_POWER
    return np.asarray(main.breadth_m / 2 * (ends * deck + (1 - ends) * waterline))


def _exponents(half_breadth: Array, depth: Array, level: Array, area: Array) -> Array:
    """p = q of rectellipses with an area below a level (m below their tops), by halving its logarithm."""
    low, high = (np.full(half_breadth.shape, np.log(value)) for value in (_LEAST_EXPONENT, _GREATEST_EXPONENT))
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        exponent = np.exp(middle)
        less = moment_below(half_breadth, depth, exponent, exponent, level) < area
        low, high = np.where(less, middle, low), np.where(less, high, middle)
    return np.asarray(np.exp((low + high) / 2))
