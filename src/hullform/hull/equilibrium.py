"""How a hull floats under a given mass and centre of gravity: the straight inclined waterline that carries them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from hullform.errors import HullError
from hullform.hull.hydrostatics import sectional_areas, waterline_half_breadths
from hullform.hull.sections import Sections, interpolated, quadrature

Array = NDArray[np.float64]

# Rise of the waterline over the length, either way, within which a floating position is looked for: 6 degrees, at
# which the ends of any ship are out of the water or under it.
STEEPEST = 0.1
# Root finding stops here, and Newton's steps go on from there to round-off.
_DRAUGHT_TOLERANCE_M = 1e-6
_SLOPE_TOLERANCE = 1e-9
_NEWTON_STEPS = 4


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
    """What a hull displaces below a straight waterline, and how far her deck is above it.

    Attributes:
        waterline: its place.
        volume_m3, lcb_x_m: immersed volume, and the x of its centre.
        least_freeboard_m: least height of a section's top above the waterline; negative where the deck is under water.
    """

    waterline: Waterline
    volume_m3: float
    lcb_x_m: float
    least_freeboard_m: float


class _Below(NamedTuple):
    """Volume and waterplane below a waterline, moments about midships."""

    volume: float
    moment: float
    plane_area: float
    plane_moment: float
    plane_second_moment: float


class _Floats:
    """Sections at the places of the quadrature, found once for many waterlines."""

    def __init__(self, x: Array, sections: Sections, midships_m: float) -> None:
        place, self.weight = quadrature(x)
        self.between = interpolated(x, sections, place)
        self.lever = place - midships_m
        reach = STEEPEST * float(np.abs(x - midships_m).max())
        self.lowest = float(sections.keel.min()) - reach
        self.highest = float(sections.top.max()) + reach

    def below(self, draught: float, slope: float) -> _Below:
        height = draught + self.lever * slope
        area = sectional_areas(self.between, height) * self.weight
        breadth = 2 * waterline_half_breadths(self.between, height, 0.0) * self.weight
        first = breadth * self.lever
        return _Below(
            float(area.sum()),
            float(area @ self.lever),
            float(breadth.sum()),
            float(first.sum()),
            float(first @ self.lever),
        )

    def draught(self, volume: float, slope: float) -> float:
        """The draught amidships at which a waterline of a slope has a volume below it."""
        return float(
            brentq(
                lambda draught: self.below(draught, slope).volume - volume,
                self.lowest,
                self.highest,
                xtol=_DRAUGHT_TOLERANCE_M,
            )
        )

    def lever_at(self, volume: float, slope: float) -> float:
        """How far forward of midships the centre of buoyancy lies with a volume and a slope, with which it rises."""
        found = self.below(self.draught(volume, slope), slope)
        return found.moment / found.volume

    def sharpened(self, draught: float, slope: float, volume: float, moment: float) -> tuple[float, float]:
        """Newton's steps, whose derivatives are the moments of the waterplane."""
        best, least = (draught, slope), np.inf
        for _ in range(_NEWTON_STEPS):
            found = self.below(draught, slope)
            missing = np.array([volume - found.volume, moment - found.moment])
            misfit = abs(missing[0]) + abs(missing[1]) / float(np.abs(self.lever).max())
            if misfit >= least:
                break
            best, least = (draught, slope), misfit
            rise = np.array([[found.plane_area, found.plane_moment], [found.plane_moment, found.plane_second_moment]])
            if not np.linalg.det(rise) > 0:
                break
            step = np.linalg.solve(rise, missing)
            draught, slope = draught + float(step[0]), slope + float(step[1])
        return best


def equilibrium_slope(
    x: Array, sections: Sections, midships_m: float, volume: float, lcg_x_m: float
) -> tuple[float, float]:
    """Draught amidships in m and slope of the waterline that has a volume in m3 below it and its centre at an x in m.

    The centre of buoyancy comes to the x of the centre of gravity: as its height is not known, BM_L stands for GM_L.
    A wall-sided hull's slope is (LCG - LCB) / BM_L, both on even keel.

    Args:
        x: (stations,) places of the sections in m.
        sections: of the hull.

    Raises:
        HullError: the volume is not positive or more than the hull's, or no slope up to `STEEPEST` brings the centre
            of buoyancy there.
    """
    if not np.isfinite(volume) or volume <= 0:
        raise HullError(f"a displaced volume of {volume:g} m3 has no draught; give a positive one")
    floats = _Floats(x, sections, midships_m)
    whole = floats.below(floats.highest, 0.0).volume
    if volume > whole:
        raise HullError(
            f"the hull displaces {whole:.6g} m3 to her deck, less than the {volume:.6g} m3 asked for; check the "
            "weights, the scale of the body plan and the breadth and depth given"
        )
    lever = lcg_x_m - midships_m
    ends = [floats.lever_at(volume, slope) for slope in (-STEEPEST, STEEPEST)]
    if not ends[0] < lever < ends[1]:
        raise HullError(
            f"no floating position has its centre of buoyancy at x = {lcg_x_m:.6g} m, where the centre of gravity "
            f"lies: trims of up to {STEEPEST:g} of the length reach {midships_m + ends[0]:.6g} to "
            f"{midships_m + ends[1]:.6g} m; check where the weights lie"
        )
    slope = float(
        brentq(lambda slope: floats.lever_at(volume, slope) - lever, -STEEPEST, STEEPEST, xtol=_SLOPE_TOLERANCE)
    )
    return floats.sharpened(floats.draught(volume, slope), slope, volume, volume * lever)


def floating_position(x: Array, sections: Sections, waterline: Waterline) -> FloatingPosition:
    """What lies below a waterline.

    Raises:
        HullError: nothing does.
    """
    place, weight = quadrature(x)
    area = sectional_areas(interpolated(x, sections, place), waterline.heights(place)) * weight
    volume = float(area.sum())
    if volume <= 0:
        raise HullError(
            f"at draughts of {waterline.draught_aft_m:g} m aft and {waterline.draught_fore_m:g} m fore nothing of the "
            "hull is under water; check them"
        )
    freeboard = float((sections.top - waterline.heights(x)).min())
    return FloatingPosition(waterline, volume, float(area @ place) / volume, freeboard)
