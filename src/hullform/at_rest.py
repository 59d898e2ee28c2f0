"""A loaded ship at rest in still water: where her waterline lies, and what weight and buoyancy do to her girder.

The equilibrium carries her weights by trim. Beyond the limits of trim, or with a deck under water, it is a sign of
wrong weights rather than a position to sail in: she is then put on even keel, and a check says so. The shear force and
bending moment are those of the equilibrium all the same, as on even keel they would not close.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from hullform import rest_checks
from hullform.checks import Check
from hullform.errors import HullError
from hullform.hull.equilibrium import FloatingPosition, Waterline
from hullform.hull.loft import Hull
from hullform.loading.distributions import Distribution
from hullform.loading.still_water import StillWater, still_water

Adopted = Literal["equilibrium", "given draughts", "even keel"]


@dataclass(frozen=True, eq=False)
class AtRest:
    """How a condition lies in the water.

    Attributes:
        position: the waterline that the run takes for hers.
        adopted: where it comes from.
        reason: in words, why it is not the equilibrium; empty where it is.
        equilibrium: the position that carries her weights; None where there is none.
        still_water: shear force and bending moment, at the equilibrium where there is one.
        checks: of the trim, the freeboard, given draughts and the balance.
    """

    position: FloatingPosition
    adopted: Adopted
    reason: str
    equilibrium: FloatingPosition | None
    still_water: StillWater
    checks: tuple[Check, ...]


def at_rest(
    hull: Hull,
    items: Sequence[Distribution],
    density_kg_m3: float,
    even_keel_draught_m: float,
    given: Waterline | None,
) -> AtRest:
    """Lay a loaded hull at rest.

    Args:
        hull: afloat.
        items: all her weights.
        density_kg_m3: of the water.
        even_keel_draught_m: where she lies without trim.
        given: the waterline of given draughts, if any.

    Raises:
        HullError: nothing of her is under the given waterline.
    """
    mass = sum(item.mass_kg for item in items)
    centre = sum(item.moment_kg_m for item in items) / mass
    found: FloatingPosition | None = None
    reason = ""
    try:
        found = hull.equilibrium(mass, centre, density_kg_m3)
    except HullError as error:
        reason = str(error)
    length, depth = hull.length_between_perpendiculars_m, hull.depth_amidships_m
    level = hull.hydrostatics(even_keel_draught_m, density_kg_m3)
    lever = level.lcb_x_m - centre
    # BM_L stands for GM_L, some per cent more: an estimate, for want of a position that carries her
    trim_m = lever * length / level.bm_longitudinal_m if found is None else found.waterline.trim_m
    held = [rest_checks.check_trim(lever, trim_m, length)]
    if found is not None:
        held.append(rest_checks.check_freeboard(found.least_freeboard_m, depth))
        reason = "; ".join(f"{check.title}: {check.figures}" for check in held if not check.ok)
    adopted: Adopted = "even keel" if reason else "equilibrium"
    if given is not None:
        adopted, reason = "given draughts", "ship.toml gives the draughts"
        position = hull.floating_at(given)
        held.append(rest_checks.check_given_draughts(position.volume_m3 * density_kg_m3, mass))
        if found is not None:
            held.append(rest_checks.check_given_trim(given.trim_m, found.waterline.trim_m, length))
    elif found is None or reason:
        position = hull.floating_at(hull.waterline(even_keel_draught_m, even_keel_draught_m))
    else:
        position = found
    bent = still_water(hull, items, (position if found is None else found).waterline, density_kg_m3)
    held.append(rest_checks.check_closing(bent.moment_residual))
    return AtRest(position, adopted, reason, found, bent, tuple(held))
