"""How a hull floats under a given mass and centre of gravity: the straight inclined waterline that carries them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from hullform.errors import HullError
from hullform.hull.sections import SectionSet, quadrature

Array = NDArray[np.float64]

# Rise of the waterline over the length, either way, that a floating position may have: 6 degrees, at which the ends of
# any ship are out of the water or under it.
STEEPEST = 0.1
# Of the displaced volume: Newton's steps end here, and a position that is further off is none.
_SHARP, _CLOSE = 1e-15, 1e-9
_MOST_STEPS = 60
_LEAST_SHARE_OF_A_STEP = 1e-4


@dataclass(frozen=True, slots=True)
class Waterline:
    """A straight waterline, z = draught + (x - midships) slope; heights in m above the base line.

    Attributes:
        aft_perpendicular_m, length_between_perpendiculars_m: where its draughts are read.
        draught_m: halfway between the perpendiculars.
        slope: rise per length, positive where she trims by the bow.
    """

    aft_perpendicular_m: float
    length_between_perpendiculars_m: float
    draught_m: float
    slope: float = 0.0

    @classmethod
    def through(
        cls, aft_perpendicular_m: float, length_between_perpendiculars_m: float, aft_m: float, fore_m: float
    ) -> Waterline:
        """The waterline of given draughts at the perpendiculars."""
        slope = (fore_m - aft_m) / length_between_perpendiculars_m
        return cls(aft_perpendicular_m, length_between_perpendiculars_m, (aft_m + fore_m) / 2, slope)

    def heights(self, x_m: ArrayLike) -> Array:
        """Heights in m above the base line at x in m."""
        midships = self.aft_perpendicular_m + self.length_between_perpendiculars_m / 2
        return np.asarray(self.draught_m + (np.asarray(x_m, dtype=np.float64) - midships) * self.slope)

    @property
    def draught_aft_m(self) -> float:
        """Draught at the aft perpendicular."""
        return self.draught_m - self.slope * self.length_between_perpendiculars_m / 2

    @property
    def draught_fore_m(self) -> float:
        """Draught at the fore perpendicular."""
        return self.draught_m + self.slope * self.length_between_perpendiculars_m / 2

    @property
    def trim_m(self) -> float:
        """Draught aft less draught fore: positive by the stern."""
        return -self.slope * self.length_between_perpendiculars_m


@dataclass(frozen=True, slots=True)
class FloatingPosition:
    """What a hull displaces below a straight waterline (`immersed_areas`), and how far her deck is above it.

    Attributes:
        waterline: its place.
        volume_m3, lcb_x_m: immersed volume, and the x of its centre.
        least_freeboard_m: least height of a section's top above the waterline; negative where the deck is under water.
    """

    waterline: Waterline
    volume_m3: float
    lcb_x_m: float
    least_freeboard_m: float


class _Misfit(NamedTuple):
    """What is missing of the volume and of its moment over half a length l, and how both rise with T and slope l."""

    missing: Array
    rise: Array

    @property
    def size(self) -> float:
        return float(np.abs(self.missing).sum())


def immersed_areas(sections: SectionSet, heights: ArrayLike) -> Array:
    """Areas in m2 of sections below heights in m (broadcast); above the deck the sides go on upright.

    So a hull that was drawn to her waterline floats, and a deck under water makes no hole in the buoyancy; what is
    above the deck is for the caller to tell, by `FloatingPosition.least_freeboard_m`.
    """
    return sections.areas_below(heights) + _above_deck(sections, heights)


def _above_deck(sections: SectionSet, heights: ArrayLike) -> Array:
    """Areas between upright sides above the deck, up to heights."""
    return 2 * sections.half_breadth * np.maximum(np.asarray(heights) - sections.top, 0.0)


def equilibrium(
    x: Array, sections: SectionSet, level: Waterline, volume: float, lcg_x_m: float, deck_tolerance_m: float
) -> Waterline:
    """The waterline that has a volume in m3 below it, with its centre at an x in m.

    The centre of buoyancy comes to the x of the centre of gravity: as its height is not known, BM_L stands for GM_L.
    A wall-sided hull's slope is (LCG - LCB) / BM_L, both on even keel. Newton's steps with step halving, from even
    keel; volume and moment are the gradient of a convex function of draught and slope, so that there is one answer.

    Args:
        x: (stations,) places of the sections in m.
        sections: of the hull.
        level: any waterline of no slope, for its perpendiculars.
        deck_tolerance_m: how far she may be under water to her deck on even keel and still float.

    Raises:
        HullError: the volume is not positive or more than the hull's, or no slope up to `STEEPEST` brings the centre
            of buoyancy there.
    """
    if not np.isfinite(volume) or volume <= 0:
        raise HullError(f"a displaced volume of {volume:g} m3 has no draught; give a positive one")
    place, weight = quadrature(x)
    between = sections.interpolated(x, place)
    midships = level.aft_perpendicular_m + level.length_between_perpendiculars_m / 2
    half_length = float(x[-1] - x[0]) / 2
    lever = (place - midships) / half_length
    moment = volume * (lcg_x_m - midships) / half_length

    def misfit(position: Array) -> _Misfit:
        heights = position[0] + position[1] * lever
        under = between.cut(heights)
        area = (under.area + _above_deck(between, heights)) * weight
        breadth = 2 * under.half_breadth * weight
        first = float(breadth @ lever)
        rise = np.array([[breadth.sum(), first], [first, breadth @ lever**2]])
        return _Misfit(np.array([volume - area.sum(), moment - area @ lever]), rise)

    whole = float(immersed_areas(between, between.top + deck_tolerance_m) @ weight)
    if volume > whole:
        raise HullError(
            f"the hull displaces {whole:.6g} m3 to her deck, less than the {volume:.6g} m3 asked for; check the "
            "weights, the scale of the body plan and the breadth and depth given"
        )
    lowest, highest = float(sections.keel.min()), float(sections.top.max()) + deck_tolerance_m
    even_keel = brentq(lambda draught: misfit(np.array([draught, 0.0])).missing[0], lowest, highest)
    position = np.array([even_keel, 0.0])
    found = misfit(position)
    for _ in range(_MOST_STEPS):
        if found.size <= _SHARP * volume:
            break
        step, *_ = np.linalg.lstsq(found.rise, found.missing, rcond=None)
        share, nearer = 1.0, misfit(position + step)
        while nearer.size >= found.size and share > _LEAST_SHARE_OF_A_STEP:
            share /= 2
            nearer = misfit(position + share * step)
        if nearer.size >= found.size:
            break
        position, found = position + share * step, nearer
    slope = float(position[1]) / half_length
    if found.size > _CLOSE * volume or abs(slope) > STEEPEST:
        raise HullError(
            f"no trim of up to {STEEPEST:g} of the length brings the centre of buoyancy to x = {lcg_x_m:.6g} m, where "
            "the centre of gravity lies; check where the weights lie"
        )
    return replace(level, draught_m=float(position[0]), slope=slope)


def floating_position(x: Array, sections: SectionSet, waterline: Waterline) -> FloatingPosition:
    """What lies below a waterline.

    Raises:
        HullError: nothing does.
    """
    place, weight = quadrature(x)
    area = immersed_areas(sections.interpolated(x, place), waterline.heights(place)) * weight
    volume = float(area.sum())
    if volume <= 0:
        raise HullError(
            f"at draughts of {waterline.draught_aft_m:g} m aft and {waterline.draught_fore_m:g} m fore nothing of the "
            "hull is under water; check them"
        )
    freeboard = float((sections.top - waterline.heights(x)).min())
    return FloatingPosition(waterline, volume, float(area @ place) / volume, freeboard)
