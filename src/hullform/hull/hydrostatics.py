"""What a hull displaces on even keel, from its sections: exact below the waterline, Gauss-Legendre along the ship."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from hullform.errors import HullError
from hullform.hull.sections import SectionSet, quadrature

Array = NDArray[np.float64]


class Buoyancy(NamedTuple):
    """Moments of the immersed volume and of the waterplane, each with the leading dimensions of the sections.

    volume (m3) and its moments about x = 0 and the base line (m4); waterplane area (m2), its moment about x = 0 (m3)
    and its second moments about the centreline and about x = 0 (m4).
    """

    volume: Array
    moment_x: Array
    moment_z: Array
    waterplane_area: Array
    waterplane_moment_x: Array
    waterplane_transverse: Array
    waterplane_longitudinal: Array


@dataclass(frozen=True, slots=True)
class Hydrostatics:
    """A hull below one waterline. SI; x from the aft end of the length overall, z from the base line.

    The draught is that halfway between the perpendiculars; the trim is positive by the stern. Of a waterline that is
    not level the waterplane is its projection on the base plane, and lengths are measured along the base line.
    Coefficients use the length between perpendiculars, the moulded breadth and the draught; midships is halfway
    between the perpendiculars. The wetted surface has no transom or other end faces.
    """

    draught_m: float
    water_density_kg_m3: float
    volume_m3: float
    displacement_kg: float
    lcb_x_m: float
    lcb_from_midships_m: float
    kb_m: float
    bm_transverse_m: float
    bm_longitudinal_m: float
    waterplane_area_m2: float
    lcf_x_m: float
    midship_area_m2: float
    wetted_surface_m2: float
    block_coefficient: float
    midship_coefficient: float
    prismatic_coefficient: float
    waterplane_coefficient: float
    trim_m: float = 0.0


class BonjeanCurves(NamedTuple):
    """Sections' areas up to a set of heights.

    x_m (stations,), height_m (heights,) above the base line, area_m2 (stations, heights) of both sides, and
    moment_m3 (stations, heights), their first moments about the base line.
    """

    x_m: Array
    height_m: Array
    area_m2: Array
    moment_m3: Array


def buoyancy(x: Array, sections: SectionSet, draught: ArrayLike, deck_tolerance: float = 0.0) -> Buoyancy:
    """Integrate volume and waterplane of sections (..., stations) at x (stations,) below a draught in m.

    draught: of all places alike, or at those of `quadrature(x)` for a waterline that is not level.
    deck_tolerance: depth in m by which a draught may exceed a section's top and still count as a draught at its top.
    """
    place, weight = quadrature(x)
    between = sections.interpolated(x, place)
    under = between.cut(draught)
    afloat = np.asarray(draught) <= between.top + deck_tolerance
    y, cubed = (np.where(afloat, values, 0.0) for values in (under.half_breadth, under.half_breadth_cubed))
    return Buoyancy(
        volume=under.area @ weight,
        moment_x=under.area @ (weight * place),
        moment_z=under.moment_z @ weight,
        waterplane_area=2 * y @ weight,
        waterplane_moment_x=2 * y @ (weight * place),
        waterplane_transverse=2 / 3 * cubed @ weight,
        waterplane_longitudinal=2 * y @ (weight * place**2),
    )


def draught_of_volume(volume_at: Callable[[float], float], volume: float, lowest: float, highest: float) -> float:
    """Find the draught in m, between two heights above the base line, at which volume_at(draught) m3 is `volume`.

    Raises HullError where the hull cannot displace so much, or the volume is not positive.
    """
    if not np.isfinite(volume) or volume <= 0:
        raise HullError(f"a displaced volume of {volume:g} m3 has no draught; give a positive one")
    most = volume_at(highest)
    if volume > most:
        raise HullError(
            f"the hull displaces {most:.6g} m3 at her depth amidships of {highest:.4g} m, less than the "
            f"{volume:.6g} m3 asked for; check the weights, the scale of the body plan and the breadth and depth given"
        )
    return float(brentq(lambda draught: volume_at(draught) - volume, lowest, highest, xtol=1e-10, rtol=1e-12))
