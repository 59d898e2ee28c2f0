"""The plates of every section along the ship as one stack of networks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.errors import LoadingError
from hullform.hull.loft import Hull
from hullform.loading.arrangement import Branch, parted, tied
from hullform.loading.framing import Frame, Plating, member_names, platings_of
from hullform.loading.places import moved_to
from hullform.loading.thin_walled import Network
from hullform.ship_structure import StructureInput

Array = NDArray[np.float64]

# Points round one side of a section; its shear area is then good to some 1e-5.
CONTOUR_POINTS = 101

# Just abaft and just forward of where a member begins or ends.
_BESIDE_M = 1e-6


@dataclass(frozen=True, eq=False)
class PlatedSections:
    """Sections with their members along the ship.

    Attributes:
        x_m: (n,) their places; where a member begins or ends, twice: as it is abaft and as it is forward.
        network: of n sections, half of each.
        steel_area_m2: (n,) of all plates and stiffeners as given, both sides, those included that bend with the hull by
            a share only.
    """

    x_m: Array
    network: Network
    steel_area_m2: Array


def plated_sections(hull: Hull, given: StructureInput) -> PlatedSections:
    """Plate every section of a hull.

    Raises:
        LoadingError: a member lies nowhere within the hull, or hangs in the air somewhere.
    """
    x, probes = _places(hull, given.bounds_m)
    contours = hull.section_points(CONTOUR_POINTS, x)
    frames = [Frame(float(probe), contour, hull.breadth_m / 2) for probe, contour in zip(probes, contours, strict=True)]
    platings = [platings_of(given, frame) for frame in frames]
    branches = [_branches(section, x_m) for section, x_m in zip(platings, x, strict=True)]
    seen = {plating.name for section in platings for plating in section}
    for name in sorted(member_names(given) - seen):
        raise LoadingError(
            f"structure: '{name}' lies nowhere within the hull; check its heights and its place across, in metres from "
            "the base line and the centre line, and its from_m and to_m"
        )
    return PlatedSections(
        x_m=x,
        network=_stacked(given, platings, branches),
        steel_area_m2=np.array([sum(_steel(plating) for plating in section) for section in platings]),
    )


def platings_at(hull: Hull, given: StructureInput, x_m: float) -> tuple[Plating, ...]:
    """The plates of the half section at one place."""
    (contour,) = hull.section_points(CONTOUR_POINTS, x_m)
    return tuple(platings_of(given, Frame(x_m, contour, hull.breadth_m / 2)))


def _places(hull: Hull, bounds: tuple[float, ...]) -> tuple[Array, Array]:
    """Where the sections are, and where to ask which members they have."""
    given = list(bounds)
    at = moved_to(hull.x_m, np.array(given), hull.length_overall_m)
    inside = (at > hull.x_m[0]) & (at < hull.x_m[-1])
    # of several that came to one place the outermost are asked beside
    twice = np.unique(at[inside])
    abaft = np.array([min(x, *np.array(given)[at == x]) for x in twice]) - _BESIDE_M
    forward = np.array([max(x, *np.array(given)[at == x]) for x in twice]) + _BESIDE_M
    own = np.setdiff1d(hull.x_m, twice)
    places, probes = np.concatenate([own, twice, twice]), np.concatenate([own, abaft, forward])
    order = np.argsort(probes)
    return places[order], probes[order]


def _branches(platings: list[Plating], x_m: float) -> list[Branch]:
    branches = parted([plating.points for plating in platings])
    held = tied(branches, {number for number, plating in enumerate(platings) if plating.shell})
    if len(held) < len(branches):
        loose = {branch.of for branch in branches} - {branch.of for branch in held}
        names = ", ".join(sorted(f"'{platings[number].name}'" for number in loose))
        raise LoadingError(
            f"structure: at x = {x_m:g} m nothing ties {names} to the shell; let it reach the shell, the deck or "
            "another member (foot_m, head_m, breadth_m, from_m, to_m)"
        )
    return branches


def _steel(plating: Plating) -> float:
    sides = 1 if plating.on_centre_line else 2
    scantling = plating.scantling
    return sides * plating.length_m * scantling.thickness_m * (1 + scantling.stiffener_share)


def _stacked(given: StructureInput, platings: list[list[Plating]], branches: list[list[Branch]]) -> Network:
    """All sections side by side, filled up to the longest with branches of no length at a joint of their own."""
    most = max(1, max(len(found) for found in branches))
    longest = max(2, max((len(branch.points) for found in branches for branch in found), default=2))
    sections = len(branches)
    y, z = np.zeros((2, sections, most, longest))
    shear, bending = np.zeros((2, sections, most, longest - 1))
    spare = 1 + max((max(branch.joints) for found in branches for branch in found), default=0)
    joints = np.full((sections, most, 2), spare, dtype=np.int64)
    margin = given.corrosion_margin_m if given.scantlings == "net" else 0.0
    for row, (section, found) in enumerate(zip(platings, branches, strict=True)):
        for number, branch in enumerate(found):
            plating = section[branch.of]
            last = len(branch.points) - 1
            y[row, number], z[row, number] = branch.points[np.minimum(np.arange(longest), last)].T
            sides = 0.5 if plating.on_centre_line else 1.0
            net = sides * plating.scantling.effective_share * (plating.scantling.thickness_m - margin)
            shear[row, number] = net
            bending[row, number] = net * (1 + plating.scantling.stiffener_share)
            joints[row, number] = branch.joints
    return Network(y, z, shear, bending, joints)
