"""The hull: super-ellipse sections along the whole ship, lofted from the stations of a body plan."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullform.body_plan import BodyPlan
from hullform.errors import HullError
from hullform.hull import hydrostatics as floating
from hullform.hull.arcs import curve_points
from hullform.hull.drawn import (
    Extrapolation,
    FittedStation,
    fit_stations,
    lofted_sections,
    merge_halves,
    station_places,
)
from hullform.hull.equilibrium import FloatingPosition, Waterline, equilibrium, floating_position, immersed_areas
from hullform.hull.hydrostatics import Hydrostatics
from hullform.hull.sections import Sections, interpolated, quadrature
from hullform.hull.surface import closed_surface
from hullform.hull.turning_back import doubts_of_turning_back

if TYPE_CHECKING:
    import trimesh

Array = NDArray[np.float64]

# A draught may exceed the depth amidships by this share of it: a hull drawn to her waterline, as Wigley's, is read to
# no better.
_DEPTH_TOLERANCE = 0.005


class Particulars(Protocol):
    """What a hull takes from the ship's particulars; all in m."""

    @property
    def length_overall_m(self) -> float: ...
    @property
    def length_between_perpendiculars_m(self) -> float: ...
    @property
    def aft_perpendicular_m(self) -> float: ...
    @property
    def breadth_m(self) -> float: ...
    @property
    def depth_m(self) -> float: ...
    @property
    def draught_m(self) -> float: ...


@dataclass(frozen=True, eq=False)
class Hull:
    """A ship's moulded form: a super-ellipse section at each x, monotone cubics of their parameters between.

    Attributes:
        x_m: (n,) places of the sections from the aft end of the length overall, increasing, n >= 3.
        half_breadth_m, depth_m, top_height_m: (n,) half-breadth at each section's top, its own depth, and the height
            of its top above the base line. Half-breadth and depth may be 0 at an end.
        p, q: (n,) exponents.
        length_overall_m, length_between_perpendiculars_m, aft_perpendicular_m, breadth_m, depth_moulded_m, draught_m:
            the particulars; they scale nothing, coefficients refer to them.
        fits: the drawn stations with their fits, empty for a hull that was not drawn.
        extrapolated: spans of the ship outside the outermost drawn stations.
        doubts: what a person should look at.

    Raises HullError for arrays of unequal length, x that does not increase, numbers that are not finite, a negative
    length or an exponent that is not positive.
    """

    x_m: Array
    half_breadth_m: Array
    depth_m: Array
    top_height_m: Array
    p: Array
    q: Array
    length_overall_m: float
    length_between_perpendiculars_m: float
    aft_perpendicular_m: float
    breadth_m: float
    depth_moulded_m: float
    draught_m: float
    fits: tuple[FittedStation, ...] = ()
    extrapolated: tuple[Extrapolation, ...] = ()
    doubts: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        x = np.array(self.x_m, dtype=np.float64)
        for name in ("x_m", "half_breadth_m", "depth_m", "top_height_m", "p", "q"):
            values = np.array(getattr(self, name), dtype=np.float64)
            if values.shape != x.shape or x.ndim != 1 or len(x) < 3:
                raise HullError(
                    f"Hull: {name} has shape {values.shape} and x_m {x.shape}; give one value a section, three or more"
                )
            if not np.isfinite(values).all():
                raise HullError(f"Hull: {name} holds a number that is not finite")
            if name in ("half_breadth_m", "depth_m") and values.min() < 0:
                raise HullError(
                    f"Hull: {name} is {values.min():g} m at x = {x[values.argmin()]:g} m; it cannot be negative"
                )
            if name in "pq" and values.min() <= 0:
                raise HullError(
                    f"Hull: exponent {name} is {values.min():g} at x = {x[values.argmin()]:g} m; it must be positive"
                )
            values.setflags(write=False)
            object.__setattr__(self, name, values)
        if (np.diff(x) <= 0).any():
            where = int(np.argmax(np.diff(x) <= 0))
            raise HullError(f"Hull: x_m must increase, but {x[where + 1]:g} follows {x[where]:g}")
        if max(self.half_breadth_m) <= 0 or max(self.depth_m) <= 0:
            raise HullError("Hull: no section has breadth and depth; check the body plan")

    @classmethod
    def from_body_plan(cls, body_plan: BodyPlan, particulars: Particulars, stations: int = 100) -> Hull:
        """Fit the drawn stations and loft `stations` sections over the length overall.

        Sections stand closer together at the ends (`drawn.station_places`). A station drawn on both halves counts once,
        with the mean of its extents; the halves' disagreement beyond a pen's width becomes a doubt. Outside the
        outermost drawn stations the form is extrapolated (`drawn.lofted_sections`), and `extrapolated` says where.

        Raises HullError for fewer than three sections, a station outside the length overall or one without a shape.
        """
        length = float(particulars.length_overall_m)
        if stations < 3:
            raise HullError(f"a hull needs three or more lofted sections; {stations} asked for")
        for station in body_plan.stations:
            if not -1e-6 * length <= station.x_m <= (1 + 1e-6) * length:
                raise HullError(
                    f"station {station.name} ({station.half} half) is at x = {station.x_m:g} m, outside the length "
                    f"overall 0..{length:g} m; x counts from the aft end of the length overall, forward"
                )
        fits = fit_stations(body_plan, float(particulars.breadth_m))
        merged, disagreements = merge_halves(fits, float(particulars.breadth_m))
        unlike = doubts_of_turning_back(body_plan, fits, float(particulars.breadth_m) / 2)
        x = station_places(length, stations)
        sections, extrapolated, guesses = lofted_sections(merged, x, length)
        return cls(
            x_m=x,
            half_breadth_m=sections.half_breadth,
            depth_m=sections.depth,
            top_height_m=sections.top,
            p=sections.p,
            q=sections.q,
            length_overall_m=length,
            length_between_perpendiculars_m=float(particulars.length_between_perpendiculars_m),
            aft_perpendicular_m=float(particulars.aft_perpendicular_m),
            breadth_m=float(particulars.breadth_m),
            depth_moulded_m=float(particulars.depth_m),
            draught_m=float(particulars.draught_m),
            fits=fits,
            extrapolated=extrapolated,
            doubts=disagreements + guesses + unlike,
        )

    @property
    def sections(self) -> Sections:
        """The sections' parameters, as the section kernels take them."""
        return Sections(self.half_breadth_m, self.depth_m, self.top_height_m, self.p, self.q)

    @property
    def keel_height_m(self) -> Array:
        """(n,) heights of the sections' lowest points above the base line, in m."""
        return self.sections.keel

    @property
    def midships_m(self) -> float:
        """x halfway between the perpendiculars, in m."""
        return self.aft_perpendicular_m + self.length_between_perpendiculars_m / 2

    def sections_at(self, x_m: ArrayLike) -> Sections:
        """Parameters of the sections at any x in m within the hull; raises HullError for an x outside it."""
        outside = (np.asarray(x_m) < self.x_m[0]) | (np.asarray(x_m) > self.x_m[-1])
        if np.any(outside):
            raise HullError(
                f"x = {np.asarray(x_m)[outside].flat[0]:g} m is outside the hull, {self.x_m[0]:g}..{self.x_m[-1]:g} m"
            )
        return interpolated(self.x_m, self.sections, x_m)

    def sectional_areas(self, draught_m: ArrayLike | None = None, x_m: ArrayLike | None = None) -> Array:
        """Areas in m2 below a draught (m above the base line; default: to the deck) at the sections or at x_m.

        draught_m may be one value a section, for a trimmed waterline.
        """
        sections = self.sections if x_m is None else self.sections_at(x_m)
        return floating.sectional_areas(sections, draught_m)

    @cached_property
    def volume_m3(self) -> float:
        """Volume up to the deck, in m3."""
        place, weight = quadrature(self.x_m)
        return float(self.sectional_areas(x_m=place) @ weight)

    @cached_property
    def depth_amidships_m(self) -> float:
        """Height of the deck above the base line halfway between the perpendiculars, in m."""
        return float(self.sections_at(self.midships_m).top)

    def _immersed_volume(self, draught_m: float) -> float:
        return float(floating.buoyancy(self.x_m, self.sections, draught_m).volume)

    def hydrostatics(self, draught_m: float | None = None, density: float = 1025.0) -> Hydrostatics:
        """Return what the hull displaces on even keel at a draught in m (default: the design's), density in kg/m3.

        Raises HullError for a draught not positive or above the depth amidships, and where nothing is immersed.
        """
        draught = self.draught_m if draught_m is None else float(draught_m)
        depth = self.depth_amidships_m
        if not 0 < draught <= depth * (1 + _DEPTH_TOLERANCE):
            raise HullError(
                f"draught {draught:g} m is not between 0 and the hull's depth amidships, {depth:.2f} m; correct "
                "draught_m, or the scale of the body plan"
            )
        if not density > 0:
            raise HullError(f"water density {density:g} kg/m3 is not possible; sea water has 1025")
        under = floating.buoyancy(self.x_m, self.sections, draught, _DEPTH_TOLERANCE * depth)
        volume, waterplane = float(under.volume), float(under.waterplane_area)
        if volume <= 0 or waterplane <= 0:
            raise HullError(f"at a draught of {draught:g} m nothing of the hull is under water; check her keel heights")
        lcb, lcf = float(under.moment_x) / volume, float(under.waterplane_moment_x) / waterplane
        midship_area = float(self.sectional_areas(draught, self.midships_m))
        box = self.breadth_m * draught
        block = volume / (self.length_between_perpendiculars_m * box)
        return Hydrostatics(
            draught_m=draught,
            water_density_kg_m3=density,
            volume_m3=volume,
            displacement_kg=density * volume,
            lcb_x_m=lcb,
            lcb_from_midships_m=lcb - self.midships_m,
            kb_m=float(under.moment_z) / volume,
            bm_transverse_m=float(under.waterplane_transverse) / volume,
            bm_longitudinal_m=(float(under.waterplane_longitudinal) - waterplane * lcf**2) / volume,
            waterplane_area_m2=waterplane,
            lcf_x_m=lcf,
            midship_area_m2=midship_area,
            wetted_surface_m2=floating.wetted_surface(self.x_m, self.sections, draught),
            block_coefficient=block,
            midship_coefficient=midship_area / box,
            prismatic_coefficient=block * box / midship_area,
            waterplane_coefficient=waterplane / (self.length_between_perpendiculars_m * self.breadth_m),
        )

    def draught_for(self, mass_kg: float, density: float = 1025.0) -> float:
        """Return the even-keel draught in m at which the hull displaces a mass in kg of water of a density in kg/m3.

        Raises HullError for a mass not positive, or more than she displaces at her depth amidships.
        """
        lowest = float(self.keel_height_m.min())
        return floating.draught_of_volume(self._immersed_volume, mass_kg / density, lowest, self.depth_amidships_m)

    def waterline(self, aft_m: float, fore_m: float) -> Waterline:
        """The waterline of draughts in m at the aft and the fore perpendicular."""
        return Waterline.through(self.aft_perpendicular_m, self.length_between_perpendiculars_m, aft_m, fore_m)

    def floating_at(self, waterline: Waterline) -> FloatingPosition:
        """What she displaces below a waterline; raises HullError where nothing of her is under water."""
        return floating_position(self.x_m, self.sections, waterline)

    def equilibrium(self, mass_kg: float, lcg_x_m: float, density: float = 1025.0) -> FloatingPosition:
        """Float her under a mass in kg with its centre of gravity at an x in m, in water of a density in kg/m3.

        Raises HullError for a mass not positive or more than she displaces to her deck, and for a centre of gravity so
        far out that no trim carries it.
        """
        tolerance = _DEPTH_TOLERANCE * self.depth_amidships_m
        level = self.waterline(self.draught_m, self.draught_m)
        found = equilibrium(self.x_m, self.sections, level, mass_kg / density, lcg_x_m, tolerance)
        return self.floating_at(found)

    def immersed_areas(self, waterline: Waterline, x_m: ArrayLike) -> Array:
        """Areas in m2 below a waterline at x_m, the sides going on upright above the deck (`equilibrium`)."""
        return immersed_areas(self.sections_at(x_m), waterline.heights(x_m))

    def section_points(self, points: int = 49, x_m: ArrayLike | None = None) -> Array:
        """Return points (n, points, 2) [half-breadth, height] in m, keel to deck, of the sections or at x_m."""
        sections = self.sections if x_m is None else self.sections_at(np.atleast_1d(x_m))
        y, zeta = curve_points(*sections.shape, points)
        return np.stack([y, sections.top[:, None] - zeta], axis=-1)

    def mesh(self, points: int = 49) -> trimesh.Trimesh:
        """Return the closed hull, deck and ends included, as triangles with outward normals, in m (x, y to port, z up).

        points: vertices a side of each section, from keel to deck, spread by arc and by the turning of the curve.
        """
        import trimesh

        vertices, faces = closed_surface(self.x_m, self.sections, points)
        return trimesh.Trimesh(vertices, faces, process=False)
