"""Does she float right, and is she a ship at all? Plausibility checks with limits and remedies.

Nothing here bends a result: a check that fails is shown in red, and the run ends with exit code 3.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from hullform.hull.hydrostatics import Hydrostatics
from hullform.loading import watson
from hullform.rounding import short, significant
from hullform.ship import Particulars
from hullform.ship_structure import StructureInput, Superstructure
from hullvib.plausibility import frequency_limits_hz

# Reading, fitting and lofting together are good to some tenths of a per cent; ten times that is a fault somewhere.
DISPLACEMENT_LIMIT_PERCENT = 1.0
BLOCK_COEFFICIENT_LIMIT_PERCENT = 1.0
LCB_LIMIT_PERCENT_LPP = 0.5
# The mesh's facets lie inside curved sections: that costs some 1e-4 of the volume.
MESH_LIMIT_PERCENT = 0.1
# A shell of the given thickness stands for stiffeners, decks and bottom too: two to four times is usual.
THICKNESS_FACTOR_LIMITS = (0.5, 6.0)
# Where the members are given too, the model should come near: what is left is stiffeners, strakes and rounding.
MODELLED_FACTOR_LIMITS = (0.7, 1.5)
# Machinery and outfit of any ship are more than this share of her steel.
LEAST_BEYOND_STEEL = 0.1
# Container ships have openings of four fifths of their breadth and more.
HATCH_LIMITS_PERCENT_B = (50.0, 100.0)


@dataclass(frozen=True)
class Check:
    """One check: a value held between its limits.

    Attributes:
        id: a short name that programs may rely on.
        title: what is compared, in words.
        value: the figure found.
        limits: the least and the greatest that it may be, one of them infinite where there is only the other.
        unit: of all three.
        remedy: what to look at where it does not hold.
    """

    id: str
    title: str
    value: float
    limits: tuple[float, float]
    unit: str
    remedy: str

    @property
    def ok(self) -> bool:
        """Whether it holds."""
        low, high = self.limits
        return low <= self.value <= high

    @property
    def limit(self) -> float:
        """The nearer limit: the one that is passed, if any is."""
        return min(self.limits, key=lambda limit: abs(self.value - limit))

    @property
    def doubt(self) -> str:
        """One sentence for the list of doubts."""
        return f"{self.title}: {self.figures}; {self.remedy}"

    @property
    def figures(self) -> str:
        """The value with the limit that it passes, or with the limits that it keeps."""
        return f"{significant(self.value)}{self._unit}, {self.bounds}"

    @property
    def bounds(self) -> str:
        """The limit that the value passes, or the limits that it keeps."""
        low, high = self.limits
        if not (self.ok and math.isfinite(low) and math.isfinite(high)):
            return f"limit {short(self.limit)}{self._unit}"
        between = f"limit ±{short(high)}" if low == -high else f"limits {short(low)} and {short(high)}"
        return between + self._unit

    @property
    def _unit(self) -> str:
        return f" {self.unit}" if self.unit else ""


def deviation(id: str, title: str, value: float, limit: float, unit: str, remedy: str) -> Check:
    """A value that must not be further from nought than its limit."""
    return Check(id, title, value, (-limit, limit), unit, remedy)


def checks_of_the_hull(particulars: Particulars, at_draught: Hydrostatics) -> tuple[Check, ...]:
    """What ship.toml says of the hull against what was read: displacement, block coefficient, LCB."""
    found: list[Check] = []
    if particulars.displacement_t is not None:
        found.append(
            deviation(
                "given-displacement",
                "displacement read at the design draught against [ship] displacement_t",
                100 * (at_draught.displacement_kg / 1e3 / particulars.displacement_t - 1),
                DISPLACEMENT_LIMIT_PERCENT,
                "%",
                "look at the overlay: check aft_side, the station list, the calibration and the draught",
            )
        )
    if particulars.block_coefficient is not None:
        found.append(
            deviation(
                "given-block-coefficient",
                "block coefficient read against [ship] block_coefficient",
                100 * (at_draught.block_coefficient / particulars.block_coefficient - 1),
                BLOCK_COEFFICIENT_LIMIT_PERCENT,
                "%",
                "look at the overlay: check aft_side, the station list, the calibration and the length between "
                "perpendiculars",
            )
        )
    if particulars.lcb_from_midships_m is not None:
        length = particulars.length_between_perpendiculars_m
        found.append(
            deviation(
                "given-lcb",
                "centre of buoyancy read against [ship] lcb_from_midships_m",
                100 * (at_draught.lcb_from_midships_m - particulars.lcb_from_midships_m) / length,
                LCB_LIMIT_PERCENT_LPP,
                "% of LPP",
                "check that aft_side names the half that shows the aft body, and the station positions",
            )
        )
    return tuple(found)


def check_mesh(mesh_volume_m3: float, section_volume_m3: float) -> Check:
    """The mesh's volume against that of the sections."""
    return deviation(
        "mesh-volume",
        "volume of the mesh against that of the sections, to the deck",
        100 * (mesh_volume_m3 / section_volume_m3 - 1),
        MESH_LIMIT_PERCENT,
        "%",
        "the hull has sections that a mesh cannot follow: check the stations in the report",
    )


def check_thickness(factor: float, given: StructureInput) -> Check:
    """The equivalent-thickness factor: what the given midship second moment makes of the section as modelled."""
    plain = given.is_plain_shell
    section = f"the bare {1000 * given.shell_thickness_m:g} mm shell" if plain else "the section as modelled"
    return Check(
        "equivalent-thickness",
        f"given midship second moment over that of {section}",
        factor,
        THICKNESS_FACTOR_LIMITS if plain else MODELLED_FACTOR_LIMITS,
        "",
        "check midship_second_moment_m4 (in m4) and shell_thickness_m (in m)"
        if plain
        else "check midship_second_moment_m4 (in m4), the plates' thicknesses (in m) and stiffener_share",
    )


def check_hatches(particulars: Particulars, given: StructureInput, midships_m: float) -> Check | None:
    """Whether a container ship is open amidships; None for ships of other types."""
    if particulars.type != "container":
        return None
    return Check(
        "hatch-openings",
        "breadth of a container ship's hatch openings amidships over her own",
        100 * given.opening_breadth_m(midships_m) / particulars.breadth_m,
        HATCH_LIMITS_PERCENT_B,
        "%",
        "a closed box stands badly for an open ship: give [[structure.hatches]], with the double side and the thick "
        "strakes at the deck that go with them",
    )


def check_light_ship(beyond_steel_t: float, expected: watson.Estimate) -> Check:
    """Light ship less steel against Watson's estimate of machinery and outfit: within a factor of two."""
    return Check(
        "light-ship",
        f"light ship less steel, expected near {significant(expected.weight_t)} t of machinery and outfit (Watson)",
        beyond_steel_t,
        (expected.lower_t, expected.upper_t),
        "t",
        "the given steel weight may hold the outfit, spread by girth instead of where it lies: "
        "check steel_weight_t, semi_concentrated_weight_t and [[weights.items]]",
    )


def check_bare_light_ship(beyond_steel_t: float, steel_t: float) -> Check:
    """Whether a light ship, of a type for which there is no estimate, has anything but steel in it."""
    return Check(
        "bare-light-ship",
        "light ship less steel, of a type for which no estimate of machinery and outfit is at hand",
        beyond_steel_t,
        (LEAST_BEYOND_STEEL * steel_t, math.inf),
        "t",
        "machinery and outfit are missing in the light ship: give semi_concentrated_weight_t or [[weights.items]]",
    )


def check_steel_numeral(particulars: Particulars, houses: Iterable[Superstructure] = ()) -> Check | None:
    """Whether Watson & Gilfillan had ships of this size behind their K; None where the table gives no range."""
    limits = watson.TYPE_FIGURES[particulars.type].numeral_range_m2
    if limits is None:
        return None
    return Check(
        "steel-estimate",
        f"Watson & Gilfillan's numeral, for the estimated steel weight, against the ships of type {particulars.type} "
        "behind it",
        watson.hull_numeral(particulars, houses),
        limits,
        "m2",
        "the estimate is extrapolated: give steel_weight_t",
    )


def check_displacement(mass_kg: float, at_draught: Hydrostatics) -> Check:
    """The loaded ship's mass against her buoyancy at the design draught."""
    return deviation(
        "displacement",
        f"buoyancy at the design draught {at_draught.draught_m:g} m against the mass of this condition",
        100 * (at_draught.displacement_kg / mass_kg - 1),
        DISPLACEMENT_LIMIT_PERCENT,
        "%",
        "check the draught, the deadweight and the light ship, then the scale of the body plan",
    )


def check_floating(mass_kg: float, capacity_kg: float, depth_m: float) -> Check:
    """The mass against what the hull displaces when immersed to her depth amidships."""
    return Check(
        "floats",
        f"mass of this condition over the displacement at the depth {significant(depth_m)} m",
        100 * mass_kg / capacity_kg,
        (-math.inf, 100 + DISPLACEMENT_LIMIT_PERCENT),
        "%",
        "she would sink: check the weights, the depth and the scale of the body plan",
    )


def check_frequency(first_hz: float, length_m: float) -> Check:
    """The first frequency against what hulls of that length have: a wrong unit shows here."""
    return Check(
        "first-frequency",
        f"first frequency against hulls of {length_m:g} m",
        first_hz,
        frequency_limits_hz(length_m),
        "Hz",
        "check the units of youngs_modulus_pa, midship_second_moment_m4 and the weights",
    )
