"""The hull: her sections along the whole ship, and what follows of them: areas, waterlines, curves, a mesh."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullform.body_plan import BodyPlan
from hullform.errors import HullError
from hullform.hull import hydrostatics as floating
from hullform.hull.contours import parted_at_the_centre_line
from hullform.hull.drawn import Extrapolation, FittedStation
from hullform.hull.equilibrium import FloatingPosition, Waterline, equilibrium, floating_position, immersed_areas
from hullform.hull.hydrostatics import BonjeanCurves, Hydrostatics
from hullform.hull.ladder import Choice
from hullform.hull.lofted_stations import Particulars, loft_stations
from hullform.hull.sections import Sections, SectionSet, checked_parameter, quadrature
from hullform.hull.surface import closed_surface
from hullform.quantities import SEA_WATER_KG_M3

if TYPE_CHECKING:
    import trimesh

Array = NDArray[np.float64]

# A draught may exceed the depth amidships by this share of it: a hull drawn to her waterline, as Wigley's, is read to
# no better.
_DEPTH_TOLERANCE = 0.005


@dataclass(frozen=True, eq=False)
class Hull:
    """A ship's moulded form: a section at each x, monotone cubics of what makes them between.

    Attributes:
        x_m: (n,) places of the sections from the aft end of the length overall, increasing, n >= 3.
        sections: the n sections: super-ellipses (`Sections`), or polylines with matched points (`Contours`).
        length_overall_m, length_between_perpendiculars_m, aft_perpendicular_m, breadth_m, depth_moulded_m, draught_m:
            the particulars; they scale nothing, coefficients refer to them.
        fits: the drawn stations with their models, empty for a hull that was not drawn.
        extrapolated: spans of the ship outside the outermost drawn stations.
        doubts: what a person should look at.

    Raises HullError for x that does not increase or is not of one length with the sections, and for sections of which
    none has breadth and depth.
    """

    x_m: Array
    sections: SectionSet
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
        if x.ndim != 1 or len(x) < 3 or self.sections.top.shape != x.shape:
            raise HullError(
                f"Hull: x_m has shape {x.shape} for {self.sections.top.size} sections; give one place a section, three "
                "or more"
            )
        if not np.isfinite(x).all():
            raise HullError("Hull: x_m holds a number that is not finite")
        if (np.diff(x) <= 0).any():
            where = int(np.argmax(np.diff(x) <= 0))
            raise HullError(f"Hull: x_m must increase, but {x[where + 1]:g} follows {x[where]:g}")
        if max(self.half_breadth_m) <= 0 or max(self.depth_m) <= 0:
            raise HullError("Hull: no section has breadth and depth; check the body plan")
        x.setflags(write=False)
        object.__setattr__(self, "x_m", x)

    @classmethod
    def of_super_ellipses(
        cls,
        x_m: ArrayLike,
        half_breadth_m: ArrayLike,
        depth_m: ArrayLike,
        top_height_m: ArrayLike,
        p: ArrayLike,
        q: ArrayLike,
        length_overall_m: float,
        length_between_perpendiculars_m: float,
        aft_perpendicular_m: float,
        breadth_m: float,
        depth_moulded_m: float,
        draught_m: float,
    ) -> Hull:
        """A hull of super-ellipse sections.

        Args:
            x_m: (n,) places of the sections.
            half_breadth_m, depth_m, top_height_m: (n,) half-breadth at each section's top, its own depth, and the
                height of its top above the base line. Half-breadth and depth may be 0 at an end.
            p, q: (n,) exponents.
            length_overall_m, length_between_perpendiculars_m, aft_perpendicular_m, breadth_m, depth_moulded_m,
            draught_m: the particulars.

        Raises HullError for arrays of unequal length, x that does not increase, numbers that are not finite, a negative
        length or an exponent that is not positive.
        """
        x = np.array(x_m, dtype=np.float64)
        given = {"half_breadth_m": half_breadth_m, "depth_m": depth_m, "top_height_m": top_height_m, "p": p, "q": q}
        sections = Sections(*(checked_parameter(name, values, x) for name, values in given.items()))
        return cls(
            x, sections, length_overall_m, length_between_perpendiculars_m, aft_perpendicular_m, breadth_m,
            depth_moulded_m, draught_m,
        )  # fmt: skip

    @classmethod
    def from_body_plan(
        cls, body_plan: BodyPlan, particulars: Particulars, stations: int = 100, sections: Choice = "auto"
    ) -> Hull:
        """Model the drawn stations and loft `stations` sections over the length overall.

        `lofted_stations.loft_stations` says how.

        Raises HullError for fewer than three sections, a station outside the length overall or one without a shape.
        """
        lofted = loft_stations(body_plan, particulars, stations, sections)
        return cls(
            x_m=lofted.x_m,
            sections=lofted.sections,
            length_overall_m=float(particulars.length_overall_m),
            length_between_perpendiculars_m=float(particulars.length_between_perpendiculars_m),
            aft_perpendicular_m=float(particulars.aft_perpendicular_m),
            breadth_m=float(particulars.breadth_m),
            depth_moulded_m=float(particulars.depth_m),
            draught_m=float(particulars.draught_m),
            fits=lofted.fits,
            extrapolated=lofted.extrapolated,
            doubts=lofted.doubts,
        )

    @property
    def half_breadth_m(self) -> Array:
        """(n,) half-breadths of the deck, in m."""
        return self.sections.half_breadth

    @property
    def top_height_m(self) -> Array:
        """(n,) heights of the deck at side above the base line, in m."""
        return self.sections.top

    @property
    def keel_height_m(self) -> Array:
        """(n,) heights of the sections' lowest points above the base line, in m."""
        return self.sections.keel

    @property
    def depth_m(self) -> Array:
        """(n,) depths of the sections from deck to lowest point, in m."""
        return self.top_height_m - self.keel_height_m

    @property
    def midships_m(self) -> float:
        """x halfway between the perpendiculars, in m."""
        return self.aft_perpendicular_m + self.length_between_perpendiculars_m / 2

    def sections_at(self, x_m: ArrayLike) -> SectionSet:
        """The sections at any x in m within the hull; raises HullError for an x outside it."""
        outside = (np.asarray(x_m) < self.x_m[0]) | (np.asarray(x_m) > self.x_m[-1])
        if np.any(outside):
            raise HullError(
                f"x = {np.asarray(x_m)[outside].flat[0]:g} m is outside the hull, {self.x_m[0]:g}..{self.x_m[-1]:g} m"
            )
        return self.sections.interpolated(self.x_m, x_m)

    def sectional_areas(self, draught_m: ArrayLike | None = None, x_m: ArrayLike | None = None) -> Array:
        """Areas in m2 below a draught (m above the base line; default: to the deck) at the sections or at x_m.

        draught_m may be one value a section, for a trimmed waterline.
        """
        sections = self.sections if x_m is None else self.sections_at(x_m)
        return sections.areas_below(draught_m)

    @cached_property
    def volume_m3(self) -> float:
        """Volume up to the deck, in m3."""
        place, weight = quadrature(self.x_m)
        return float(self.sectional_areas(x_m=place) @ weight)

    @cached_property
    def depth_amidships_m(self) -> float:
        """Height of the deck above the base line halfway between the perpendiculars, in m."""
        return self.sections_at(self.midships_m).top.item()

    def _immersed_volume(self, draught_m: float) -> float:
        return float(floating.buoyancy(self.x_m, self.sections, draught_m).volume)

    def hydrostatics(
        self, draught_m: float | None = None, density: float = SEA_WATER_KG_M3, trim_m: float = 0.0
    ) -> Hydrostatics:
        """Return what the hull displaces at a draught halfway between the perpendiculars, in m (default: the design's).

        density: of the water, kg/m3. trim_m: draught aft less that fore, at the perpendiculars.

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
            raise HullError(f"water density {density:g} kg/m3 is not possible; sea water has {SEA_WATER_KG_M3:g}")
        waterline = self.waterline(draught + trim_m / 2, draught - trim_m / 2)
        heights = waterline.heights(quadrature(self.x_m)[0])
        under = floating.buoyancy(self.x_m, self.sections, heights, _DEPTH_TOLERANCE * depth)
        volume, waterplane = float(under.volume), float(under.waterplane_area)
        if volume <= 0 or waterplane <= 0:
            raise HullError(f"at a draught of {draught:g} m nothing of the hull is under water; check her keel heights")
        lcb, lcf = float(under.moment_x) / volume, float(under.waterplane_moment_x) / waterplane
        midship_area = self.sectional_areas(draught, self.midships_m).item()
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
            wetted_surface_m2=self.sections.wetted_surface(self.x_m, waterline.heights(self.x_m)),
            block_coefficient=block,
            midship_coefficient=midship_area / box,
            prismatic_coefficient=block * box / midship_area,
            waterplane_coefficient=waterplane / (self.length_between_perpendiculars_m * self.breadth_m),
            trim_m=float(trim_m),
        )

    def bonjean_curves(self, heights_m: ArrayLike, x_m: ArrayLike | None = None) -> BonjeanCurves:
        """Areas of the sections, or of those at x_m (stations,), below heights (heights,) in m above the base line."""
        x = self.x_m if x_m is None else np.atleast_1d(np.asarray(x_m, dtype=np.float64))
        heights = np.atleast_1d(np.asarray(heights_m, dtype=np.float64))
        under = self.sections_at(x).cut(heights[:, None])
        return BonjeanCurves(x, heights, under.area.T, under.moment_z.T)

    def draught_for(self, mass_kg: float, density: float = SEA_WATER_KG_M3) -> float:
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

    def equilibrium(self, mass_kg: float, lcg_x_m: float, density: float = SEA_WATER_KG_M3) -> FloatingPosition:
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
        return sections.points(points)

    def section_curves(self, x_m: float, points: int = 121) -> tuple[Array, ...]:
        """The contours (k, 2) [half-breadth, height] in m of the section at an x in m, keel to deck, the lowest first.

        One, or two where the section has a bulb or a gondola apart from the body above it. points: of a super-ellipse;
        polyline sections give all that they have, knuckles among them.
        """
        (section,) = self.sections_at(np.atleast_1d(x_m)).mesh_points(points)
        return parted_at_the_centre_line(section)

    def mesh(self, points: int = 49) -> trimesh.Trimesh:
        """Return the closed hull, deck and ends included, as triangles with outward normals, in m (x, y to port, z up).

        points: vertices a side of each section, from keel to deck, spread by arc and by the turning of the curve.
        """
        import trimesh

        vertices, faces = closed_surface(self.x_m, self.sections.mesh_points(points))
        return trimesh.Trimesh(vertices, faces, process=False)
