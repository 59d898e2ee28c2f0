"""A loading condition in water: the flow about her wetted hull, and her modes in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.checks import Check
from hullform.hull.equilibrium import FloatingPosition
from hullform.hull.loft import Hull
from hullform.loading.gravity import GRAVITY_M_S2
from hullform.loading.structure import Structure
from hullform.wet_checks import check_panel_volume, check_strips
from hullform.wetted import wetted_panels, wetted_sections
from hullvib import wet
from hullvib.girder import Girder
from hullvib.stodola import StodolaRitz

Array = NDArray[np.float64]

# Of wet modes, so many are held against the strips: those that a run shows.
HELD_AGAINST_STRIPS = 3


@dataclass(frozen=True, eq=False)
class InWater:
    """A condition's modes in water, with two added masses and for two girders.

    Attributes:
        panels: of the wetted half hull.
        flow: about them.
        strips: the same water by sections in two dimensions.
        euler, shear: wet modes by panels, of the Euler-Bernoulli girder and of that with shear deflection.
        strips_euler, strips_shear: the same by strips.
        effective_factors: (modes,) J_n of the modes with shear: generalised added mass over that of the strips in two
            dimensions.
        checks: of the panels' volume, and of the strips against the panels.
    """

    panels: wet.Panels
    flow: wet.PanelFlow
    strips: wet.StripFlow
    euler: wet.WetModes
    shear: wet.WetModes
    strips_euler: wet.WetModes
    strips_shear: wet.WetModes
    effective_factors: Array
    checks: tuple[Check, ...]


def put_in_water(
    hull: Hull,
    structure: Structure,
    girder: Girder,
    position: FloatingPosition,
    density_kg_m3: float,
    *,
    modes: int,
    functions: int,
) -> InWater:
    """Find the wet modes of a girder whose hull lies at a floating position.

    Args:
        hull: lofted.
        structure: for the height of the neutral axis, about which the sections turn.
        girder: of the condition, with shear rigidity.
        position: of her waterline.
        density_kg_m3: of the water.
        modes: how many.
        functions: dry modes that the wet ones are made of.

    Raises:
        HullError: nothing of her is under water.
    """
    sections = wetted_sections(hull, position.waterline)
    panels = wetted_panels(sections)
    axis = structure.neutral_axis_m - position.waterline.heights(structure.x_m)
    flow = wet.PanelFlow(
        panels, neutral_axis_m=(structure.x_m, axis), density_kg_m3=density_kg_m3, gravity_m_s2=GRAVITY_M_S2
    )
    strips = wet.StripFlow(sections, density_kg_m3=density_kg_m3, gravity_m_s2=GRAVITY_M_S2)
    plain, sheared = StodolaRitz(functions), StodolaRitz(functions, shear=True)
    euler, shear, strips_euler, strips_shear = (
        wet.solve(girder, water, method, modes, functions=functions)
        for water in (flow, strips)
        for method in (plain, sheared)
    )
    by_strips, by_panels = (
        {"Euler-Bernoulli": _first(plain_modes), "with shear": _first(sheared_modes)}
        for plain_modes, sheared_modes in ((strips_euler, strips_shear), (euler, shear))
    )
    return InWater(
        panels=panels,
        flow=flow,
        strips=strips,
        euler=euler,
        shear=shear,
        strips_euler=strips_euler,
        strips_shear=strips_shear,
        effective_factors=shear.effective_factors(strips),
        checks=(check_panel_volume(panels.volume_m3, position.volume_m3), check_strips(by_strips, by_panels)),
    )


def _first(found: wet.WetModes) -> Array:
    return found.modes.angular_frequencies[:HELD_AGAINST_STRIPS]
