"""A loading condition in water: the flow about her wetted hull, and her modes in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.checks import Check
from hullform.errors import HullError
from hullform.hull.equilibrium import FloatingPosition
from hullform.hull.loft import Hull
from hullform.loading.gravity import GRAVITY_M_S2
from hullform.loading.structure import Structure
from hullform.ship import Water
from hullform.wet_checks import check_clearance, check_panel_volume, check_strips
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
        strips: the same water, without a bottom, by sections in two dimensions.
        euler, shear: wet modes by panels, of the Euler-Bernoulli girder and of that with shear deflection.
        strips_euler, strips_shear: the same by strips; None where the water has a bottom, which strips cannot have.
        effective_factors: (modes,) J_n of the modes with shear: generalised added mass over that of the strips in two
            dimensions in deep water.
        checks: of the panels' volume, and of the strips against the panels.
    """

    panels: wet.Panels
    flow: wet.PanelFlow
    strips: wet.StripFlow
    euler: wet.WetModes
    shear: wet.WetModes
    strips_euler: wet.WetModes | None
    strips_shear: wet.WetModes | None
    effective_factors: Array
    checks: tuple[Check, ...]

    @property
    def depth_m(self) -> float | None:
        """Of the water; None where it is deep."""
        return self.flow.depth_m if np.isfinite(self.flow.depth_m) else None


def put_in_water(
    hull: Hull,
    structure: Structure,
    girder: Girder,
    position: FloatingPosition,
    water: Water,
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
        water: its density and, where it has a bottom, its depth.
        modes: how many.
        functions: dry modes that the wet ones are made of.

    Raises:
        HullError: nothing of her is under water, or she would touch the bottom.
    """
    sections = wetted_sections(hull, position.waterline)
    panels = wetted_panels(sections)
    _check_depth(water, float(sections.draught_m.max()))
    axis = structure.neutral_axis_m - position.waterline.heights(structure.x_m)
    flow = wet.PanelFlow(
        panels,
        neutral_axis_m=(structure.x_m, axis),
        density_kg_m3=water.density_kg_m3,
        depth_m=water.bottom_m,
        gravity_m_s2=GRAVITY_M_S2,
    )
    strips = wet.StripFlow(sections, density_kg_m3=water.density_kg_m3, gravity_m_s2=GRAVITY_M_S2)

    def solved(flow: wet.Flow, *, shear: bool) -> wet.WetModes:
        return wet.solve(girder, flow, StodolaRitz(functions, shear=shear), modes, functions=functions)

    euler, shear = (solved(flow, shear=with_shear) for with_shear in (False, True))
    checks = [check_panel_volume(panels.volume_m3, position.volume_m3)]
    if water.depth_m is not None:
        checks.append(check_clearance(water.depth_m, float(sections.draught_m.max())))
    strips_euler = strips_shear = None
    if water.depth_m is None:
        strips_euler, strips_shear = (solved(strips, shear=with_shear) for with_shear in (False, True))
        by_strips, by_panels = (
            {"Euler-Bernoulli": _first(plain), "with shear": _first(sheared)}
            for plain, sheared in ((strips_euler, strips_shear), (euler, shear))
        )
        checks.append(check_strips(by_strips, by_panels))
    return InWater(
        panels=panels,
        flow=flow,
        strips=strips,
        euler=euler,
        shear=shear,
        strips_euler=strips_euler,
        strips_shear=strips_shear,
        effective_factors=shear.effective_factors(strips),
        checks=tuple(checks),
    )


def _check_depth(water: Water, draught_m: float) -> None:
    if water.depth_m is not None and not water.depth_m > draught_m:
        raise HullError(
            f"[water] depth_m = {water.depth_m:g}: she reaches {draught_m:.2f} m down and would lie on the "
            "bottom; give the depth of water from the surface, or leave depth_m out for deep water"
        )


def _first(found: wet.WetModes) -> Array:
    return found.modes.angular_frequencies[:HELD_AGAINST_STRIPS]
