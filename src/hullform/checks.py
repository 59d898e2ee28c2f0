"""Does she float right? Plausibility checks of a ship and of each loading condition, with limits and remedies.

Nothing here bends a result: a check that fails is shown in red, and the run ends with exit code 3.
"""

from __future__ import annotations

from dataclasses import dataclass

from hullform.hull.hydrostatics import Hydrostatics
from hullform.loading.watson import Estimate
from hullform.rounding import short, significant
from hullform.ship import Particulars

# Reading, fitting and lofting together are good to some tenths of a per cent; ten times that is a fault somewhere.
DISPLACEMENT_LIMIT_PERCENT = 1.0
BLOCK_COEFFICIENT_LIMIT_PERCENT = 1.0
LCB_LIMIT_PERCENT_LPP = 0.5
# Trim beyond which 'on even keel' is no description of the ship (by the stern, by the bow).
TRIM_BY_STERN_LIMIT_PERCENT_LPP = 1.5
TRIM_BY_BOW_LIMIT_PERCENT_LPP = 0.5


@dataclass(frozen=True)
class Check:
    """One check: a value held against its limit.

    Attributes:
        id: a short name that programs may rely on.
        title: what is compared, in words.
        value: the figure found.
        limit: the figure that it must not exceed in size (or reach, see the title).
        unit: of both.
        ok: whether it holds.
        remedy: what to look at where it does not.
    """

    id: str
    title: str
    value: float
    limit: float
    unit: str
    ok: bool
    remedy: str

    @property
    def doubt(self) -> str:
        """One sentence for the list of doubts."""
        return (
            f"{self.title}: {significant(self.value)} {self.unit}, limit {short(self.limit)} {self.unit}; {self.remedy}"
        )


def _deviation(id: str, title: str, value: float, limit: float, unit: str, remedy: str) -> Check:
    return Check(id, title, value, limit, unit, abs(value) <= limit, remedy)


def checks_of_the_hull(particulars: Particulars, at_draught: Hydrostatics) -> tuple[Check, ...]:
    """What ship.toml says of the hull against what was read: displacement, block coefficient, LCB."""
    found: list[Check] = []
    if particulars.displacement_t is not None:
        found.append(
            _deviation(
                "given-displacement",
                "displacement read at the design draught against [ship] displacement_t",
                100 * (at_draught.displacement_kg / 1e3 / particulars.displacement_t - 1),
                DISPLACEMENT_LIMIT_PERCENT,
                "%",
                "check the picture's calibration, the station list and the draught",
            )
        )
    if particulars.block_coefficient is not None:
        found.append(
            _deviation(
                "given-block-coefficient",
                "block coefficient read against [ship] block_coefficient",
                100 * (at_draught.block_coefficient / particulars.block_coefficient - 1),
                BLOCK_COEFFICIENT_LIMIT_PERCENT,
                "%",
                "check the picture's calibration, the station list and the length between perpendiculars",
            )
        )
    if particulars.lcb_from_midships_m is not None:
        lcb_from_midships = at_draught.lcb_from_midships_m
        length = particulars.length_between_perpendiculars_m
        found.append(
            _deviation(
                "given-lcb",
                "centre of buoyancy read against [ship] lcb_from_midships_m",
                100 * (lcb_from_midships - particulars.lcb_from_midships_m) / length,
                LCB_LIMIT_PERCENT_LPP,
                "% of LPP",
                "check that aft_side names the half that shows the aft body, and the station positions",
            )
        )
    return tuple(found)


def check_displacement(mass_kg: float, at_draught: Hydrostatics) -> Check:
    """The loaded ship's mass against her buoyancy at the design draught."""
    return _deviation(
        "displacement",
        f"buoyancy at the design draught {at_draught.draught_m:g} m against the mass of this condition",
        100 * (at_draught.displacement_kg / mass_kg - 1),
        DISPLACEMENT_LIMIT_PERCENT,
        "%",
        "check the draught, the deadweight and the light ship, then the picture's calibration",
    )


def check_floating(mass_kg: float, capacity_kg: float, depth_m: float) -> Check:
    """The mass against what the hull displaces when immersed to her depth amidships."""
    return Check(
        "floats",
        f"mass of this condition over the displacement at the depth {depth_m:g} m",
        100 * mass_kg / capacity_kg,
        100 + DISPLACEMENT_LIMIT_PERCENT,
        "%",
        mass_kg <= capacity_kg * (1 + DISPLACEMENT_LIMIT_PERCENT / 100),
        "she would sink: check the weights, the depth and the picture's calibration",
    )


def check_trim(lcg_m: float, floating: Hydrostatics) -> Check:
    """The trim that the weights' lever to the buoyancy would cause: t = lever LPP / BM_L, by the stern positive.

    The girder is analysed on even keel; a lever that trims her far is a fault of the weights.
    BM_L stands for GM_L, some per cent more: the trim is an estimate.
    """
    lever = floating.lcb_x_m - lcg_m
    trim_percent = 100 * lever / floating.bm_longitudinal_m
    limit = TRIM_BY_STERN_LIMIT_PERCENT_LPP if trim_percent >= 0 else TRIM_BY_BOW_LIMIT_PERCENT_LPP
    way = "stern" if trim_percent >= 0 else "bow"
    return _deviation(
        "trim",
        f"trim by the {way} that the lever of {significant(abs(lever))} m between LCG and LCB would cause",
        trim_percent,
        limit,
        "% of LPP",
        "the frequencies are for even keel: spread the weights so that LCG meets LCB, or add ballast",
    )


def check_light_ship(semi_concentrated_t: float, expected: Estimate) -> Check:
    """Light ship less steel against Watson's estimate of machinery and outfit: within a factor of two."""
    if semi_concentrated_t < expected.weight_t:
        limit, ok = expected.lower_t, semi_concentrated_t >= expected.lower_t
    else:
        limit, ok = expected.upper_t, semi_concentrated_t <= expected.upper_t
    return Check(
        "light-ship",
        f"light ship less steel, expected near {significant(expected.weight_t)} t of machinery and outfit (Watson)",
        semi_concentrated_t,
        limit,
        "t",
        ok,
        "the given steel weight may hold the outfit, spread by girth instead of where it lies: "
        "check steel_weight_t and semi_concentrated_weight_t",
    )
