"""The hull girder's section: a closed steel shell of one thickness round every station, deck included."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.errors import LoadingError
from hullform.hull.loft import Hull
from hullform.hull.super_ellipse import shell_section
from hullform.loading.shear_flow import shear_area
from hullform.ship import StructureInput

Array = NDArray[np.float64]

# Where a section shrinks to nothing its I and k A would be zero, and a beam there a hinge; a real end is never so
# soft.
FLOOR = 1e-4

# Points round one side of a section; its shear area is then good to some 1e-5.
_CONTOUR_POINTS = 101


@dataclass(frozen=True, eq=False)
class Structure:
    """Section properties along the ship, linear between the stations.

    Attributes:
        x_m: (n,) stations.
        girth_m: (n,) whole contour, both sides and deck.
        area_m2: (n,) A(x) of the shell, with the equivalent-thickness factor.
        neutral_axis_m: (n,) height above the base line.
        second_moment_m4: (n,) I(x) about the neutral axis, with the factor, not below the floor.
        shear_area_m2: (n,) energy-equivalent vertical shear area k A, with its factor, not below the floor.
        youngs_modulus_pa, shear_modulus_pa: E and G = E / (2 (1 + nu)).
        end_plate_area_m2: of the plates that close the aft and the fore end: mass only, no stiffness.
        midship_shell_second_moment_m4: I of the bare shell at midships, before the factor.
        thickness_factor: given I over bare I at midships; it scales A and I alike and never the steel mass.
        midship_shell_shear_area_m2: k A of the bare shell at midships, before its factor.
        shear_factor: the thickness factor, or given over bare shear area at midships.
        equivalent_thickness_m: the shell thickness times that factor.
        floored: how many stations have I lifted to the floor.
    """

    x_m: Array
    girth_m: Array
    area_m2: Array
    neutral_axis_m: Array
    second_moment_m4: Array
    shear_area_m2: Array
    youngs_modulus_pa: float
    shear_modulus_pa: float
    end_plate_area_m2: tuple[float, float]
    midship_shell_second_moment_m4: float
    thickness_factor: float
    midship_shell_shear_area_m2: float
    shear_factor: float
    equivalent_thickness_m: float
    floored: int

    @property
    def midship_second_moment_m4(self) -> float:
        """I at midships, with the factor."""
        return self.thickness_factor * self.midship_shell_second_moment_m4

    @property
    def midship_shear_area_m2(self) -> float:
        """k A at midships, with its factor."""
        return self.shear_factor * self.midship_shell_shear_area_m2

    @property
    def shear_rigidity(self) -> Array:
        """(n,) k G A(x) in N."""
        return self.shear_modulus_pa * self.shear_area_m2

    @property
    def flexural_rigidity(self) -> Array:
        """(n,) EI(x) in N m2."""
        return self.youngs_modulus_pa * self.second_moment_m4


def shell_structure(hull: Hull, given: StructureInput) -> Structure:
    """The shell of `[structure]` round the hull's stations, scaled to the midship second moment where given.

    Raises:
        LoadingError: the bare shell has no stiffness at midships.
    """
    shell = shell_section(hull.half_breadth_m, hull.depth_m, hull.p, hull.q, given.shell_thickness_m)
    bare = shell.second_moment
    at_midships = float(np.interp(hull.midships_m, hull.x_m, bare))
    if not at_midships > 0:
        raise LoadingError(
            f"the shell's second moment at midships (x = {hull.midships_m:g} m) is {at_midships:g} m4; "
            "the hull has no section there: check the stations and the lengths"
        )
    wanted = given.midship_second_moment_m4
    factor = 1.0 if wanted is None else wanted / at_midships
    second_moment = np.maximum(factor * bare, FLOOR * factor * at_midships)
    bare_shear = shear_area(*_contours(hull), given.shell_thickness_m)
    shear_at_midships = float(np.interp(hull.midships_m, hull.x_m, bare_shear))
    wanted_shear = given.midship_shear_area_m2
    shear_factor = factor if wanted_shear is None else wanted_shear / shear_at_midships
    ends = hull.sectional_areas()[[0, -1]]
    return Structure(
        x_m=hull.x_m,
        girth_m=shell.girth,
        area_m2=factor * shell.area,
        neutral_axis_m=hull.top_height_m - shell.neutral_axis_below_top,
        second_moment_m4=second_moment,
        shear_area_m2=np.maximum(shear_factor * bare_shear, FLOOR * shear_factor * shear_at_midships),
        shear_modulus_pa=given.youngs_modulus_pa / (2 * (1 + given.poissons_ratio)),
        youngs_modulus_pa=given.youngs_modulus_pa,
        end_plate_area_m2=(float(ends[0]), float(ends[1])),
        midship_shell_second_moment_m4=at_midships,
        thickness_factor=factor,
        midship_shell_shear_area_m2=shear_at_midships,
        shear_factor=shear_factor,
        equivalent_thickness_m=factor * given.shell_thickness_m,
        floored=int(np.count_nonzero(second_moment > factor * bare)),
    )


def _contours(hull: Hull) -> tuple[Array, Array]:
    """One side of every section from the centre line at the deck round to the keel: y and z, (stations, points)."""
    deck_to_keel = hull.section_points(_CONTOUR_POINTS)[:, ::-1]
    y, z = deck_to_keel[..., 0], deck_to_keel[..., 1]
    deck_centre = np.stack([np.zeros_like(y[:, 0]), z[:, 0]])[..., None]
    return np.concatenate([deck_centre[0], y], -1), np.concatenate([deck_centre[1], z], -1)
