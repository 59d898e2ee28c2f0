"""The hull girder's section along the ship: what bends, shears and twists, and the steel that is spread over it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.errors import LoadingError
from hullform.hull.loft import Hull
from hullform.loading.framing import Plating
from hullform.loading.plated_sections import CONTOUR_POINTS, plated_sections, platings_at
from hullform.loading.thin_walled import SectionProperties, closed_shell, section_properties
from hullform.ship_structure import StructureInput

Array = NDArray[np.float64]

# Where a section shrinks to nothing its I and k A would be zero, and a beam there a hinge; a real end is never so
# soft.
FLOOR = 1e-4


@dataclass(frozen=True, eq=False)
class Structure:
    """Section properties along the ship, linear between the stations.

    Attributes:
        x_m: (n,) stations; one stands twice where a member begins or ends, abaft of it and forward of it.
        girth_m: (n,) whole contour, both sides and deck.
        area_m2: (n,) A(x) of what bends, with the equivalent-thickness factor.
        neutral_axis_m: (n,) height above the base line.
        second_moment_m4: (n,) I(x) about the neutral axis, with the factor, not below the floor.
        horizontal_second_moment_m4: (n,) about the centre plane, with the factor.
        shear_area_m2: (n,) energy-equivalent vertical shear area k A, with its factor, not below the floor.
        torsion_constant_m4: (n,) Saint-Venant's, with the factor.
        youngs_modulus_pa, shear_modulus_pa: E and G = E / (2 (1 + nu)).
        steel_area_m2: (n,) section of all longitudinal steel as given, without a factor: the steel weight follows it.
        transverse_steel_m3: (x in m, volume in m3) of the plates that close the ends and of the transverse bulkheads:
            mass only, no stiffness.
        midship_shell_second_moment_m4: I of the section at midships as modelled, before the factor.
        thickness_factor: given I over that at midships; it scales all that bears alike and never the steel mass.
        midship_shell_shear_area_m2: k A of the section at midships as modelled, before its factor.
        shear_factor: the thickness factor, or given over modelled shear area at midships.
        equivalent_thickness_m: the shell thickness times that factor.
        floored: how many stations have I lifted to the floor.
        midship_platings: the plates of the half section at midships, as given.
    """

    x_m: Array
    girth_m: Array
    area_m2: Array
    neutral_axis_m: Array
    second_moment_m4: Array
    horizontal_second_moment_m4: Array
    shear_area_m2: Array
    torsion_constant_m4: Array
    youngs_modulus_pa: float
    shear_modulus_pa: float
    steel_area_m2: Array
    transverse_steel_m3: tuple[tuple[float, float], ...]
    midship_shell_second_moment_m4: float
    thickness_factor: float
    midship_shell_shear_area_m2: float
    shear_factor: float
    equivalent_thickness_m: float
    floored: int
    midship_platings: tuple[Plating, ...]

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

    @property
    def steel_volume_m3(self) -> float:
        """Of all plates and stiffeners as given."""
        mean = 0.5 * (self.steel_area_m2[:-1] + self.steel_area_m2[1:])
        return float(mean @ np.diff(self.x_m)) + sum(volume for _, volume in self.transverse_steel_m3)


@dataclass(frozen=True, eq=False)
class _AsModelled:
    """Sections before any factor."""

    x_m: Array
    properties: SectionProperties
    steel_area_m2: Array


def structure_of(hull: Hull, given: StructureInput) -> Structure:
    """The structure of `[structure]` in a hull, scaled to the midship second moment where given.

    Raises:
        LoadingError: the section has no stiffness at midships, or a member lies nowhere within the hull.
    """
    modelled = _plain_shell(hull, given) if given.is_plain_shell else _plated(hull, given)
    x, bare = modelled.x_m, modelled.properties
    at_midships = float(np.interp(hull.midships_m, x, bare.second_moment_m4))
    if not at_midships > 0:
        raise LoadingError(
            f"the shell's second moment at midships (x = {hull.midships_m:g} m) is {at_midships:g} m4; "
            "the hull has no section there: check the stations and the lengths"
        )
    wanted = given.midship_second_moment_m4
    factor = 1.0 if wanted is None else wanted / at_midships
    second_moment = np.maximum(factor * bare.second_moment_m4, FLOOR * factor * at_midships)
    shear_at_midships = float(np.interp(hull.midships_m, x, bare.shear_area_m2))
    wanted_shear = given.midship_shear_area_m2
    shear_factor = factor if wanted_shear is None else wanted_shear / shear_at_midships
    return Structure(
        x_m=x,
        girth_m=hull.sections_at(x).shell(given.shell_thickness_m).girth,
        area_m2=factor * bare.area_m2,
        neutral_axis_m=bare.neutral_axis_m,
        second_moment_m4=second_moment,
        horizontal_second_moment_m4=factor * bare.horizontal_second_moment_m4,
        shear_area_m2=np.maximum(shear_factor * bare.shear_area_m2, FLOOR * shear_factor * shear_at_midships),
        torsion_constant_m4=factor * bare.torsion_constant_m4,
        shear_modulus_pa=given.youngs_modulus_pa / (2 * (1 + given.poissons_ratio)),
        youngs_modulus_pa=given.youngs_modulus_pa,
        steel_area_m2=modelled.steel_area_m2,
        transverse_steel_m3=_transverse_steel(hull, given),
        midship_shell_second_moment_m4=at_midships,
        thickness_factor=factor,
        midship_shell_shear_area_m2=shear_at_midships,
        shear_factor=shear_factor,
        equivalent_thickness_m=factor * given.shell_thickness_m,
        floored=int(np.count_nonzero(second_moment > factor * bare.second_moment_m4)),
        midship_platings=platings_at(hull, given, hull.midships_m),
    )


def _plain_shell(hull: Hull, given: StructureInput) -> _AsModelled:
    """A closed shell of one thickness: area and second moment by the contour's own integrals, not by chords."""
    shell = hull.sections.shell(given.shell_thickness_m)
    network = section_properties(closed_shell(*_contours(hull), given.shell_thickness_m))
    exact = network._replace(
        area_m2=shell.area,
        neutral_axis_m=hull.top_height_m - shell.neutral_axis_below_top,
        second_moment_m4=shell.second_moment,
    )
    return _AsModelled(hull.x_m, exact, shell.area)


def _plated(hull: Hull, given: StructureInput) -> _AsModelled:
    sections = plated_sections(hull, given)
    return _AsModelled(sections.x_m, section_properties(sections.network), sections.steel_area_m2)


def _contours(hull: Hull) -> tuple[Array, Array]:
    """One side of every section from the centre line at the deck round to the keel: y and z, (stations, points)."""
    deck_to_keel = hull.section_points(CONTOUR_POINTS)[:, ::-1]
    y, z = deck_to_keel[..., 0], deck_to_keel[..., 1]
    deck_centre = np.stack([np.zeros_like(y[:, 0]), z[:, 0]])[..., None]
    return np.concatenate([deck_centre[0], y], -1), np.concatenate([deck_centre[1], z], -1)


def _transverse_steel(hull: Hull, given: StructureInput) -> tuple[tuple[float, float], ...]:
    """The plates that close the ends, of the shell's thickness, and the bulkheads, each as large as its section."""
    ends = given.shell_thickness_m * hull.sectional_areas()[[0, -1]]
    plates = list(zip(hull.x_m[[0, -1]].tolist(), ends.tolist(), strict=True))
    for group in given.transverse_bulkheads:
        thickness = given.shell_thickness_m if group.thickness_m is None else group.thickness_m
        share = given.stiffener_share if group.stiffener_share is None else group.stiffener_share
        areas = hull.sectional_areas(x_m=np.array(group.x_m))
        plates += zip(group.x_m, (thickness * (1 + share) * areas).tolist(), strict=True)
    return tuple((float(x), float(volume)) for x, volume in sorted(plates) if volume > 0)
