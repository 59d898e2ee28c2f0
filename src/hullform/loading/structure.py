"""The hull girder's section: a closed steel shell of one thickness round every station, deck included."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.errors import LoadingError
from hullform.hull.loft import Hull
from hullform.hull.super_ellipse import shell_section
from hullform.ship import StructureInput

Array = NDArray[np.float64]

# Where a section shrinks to nothing its I would be zero and a beam there a hinge; a real end is never that soft.
SECOND_MOMENT_FLOOR = 1e-4


@dataclass(frozen=True, eq=False)
class Structure:
    """Section properties along the ship, linear between the stations.

    Attributes:
        x_m: (n,) stations.
        girth_m: (n,) whole contour, both sides and deck.
        area_m2: (n,) A(x) of the shell, with the equivalent-thickness factor.
        neutral_axis_m: (n,) height above the base line.
        second_moment_m4: (n,) I(x) about the neutral axis, with the factor, not below the floor.
        youngs_modulus_pa: E.
        end_plate_area_m2: of the plates that close the aft and the fore end: mass only, no stiffness.
        midship_shell_second_moment_m4: I of the bare shell at midships, before the factor.
        thickness_factor: given I over bare I at midships; it scales A and I alike and never the steel mass.
        equivalent_thickness_m: the shell thickness times that factor.
        floored: how many stations have I lifted to the floor.
    """

    x_m: Array
    girth_m: Array
    area_m2: Array
    neutral_axis_m: Array
    second_moment_m4: Array
    youngs_modulus_pa: float
    end_plate_area_m2: tuple[float, float]
    midship_shell_second_moment_m4: float
    thickness_factor: float
    equivalent_thickness_m: float
    floored: int

    @property
    def midship_second_moment_m4(self) -> float:
        """I at midships, with the factor."""
        return self.thickness_factor * self.midship_shell_second_moment_m4

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
    floor = SECOND_MOMENT_FLOOR * factor * at_midships
    second_moment = np.maximum(factor * bare, floor)
    ends = hull.sectional_areas()[[0, -1]]
    return Structure(
        x_m=hull.x_m,
        girth_m=shell.girth,
        area_m2=factor * shell.area,
        neutral_axis_m=hull.top_height_m - shell.neutral_axis_below_top,
        second_moment_m4=second_moment,
        youngs_modulus_pa=given.youngs_modulus_pa,
        end_plate_area_m2=(float(ends[0]), float(ends[1])),
        midship_shell_second_moment_m4=at_midships,
        thickness_factor=factor,
        equivalent_thickness_m=factor * given.shell_thickness_m,
        floored=int(np.count_nonzero(second_moment > factor * bare)),
    )
