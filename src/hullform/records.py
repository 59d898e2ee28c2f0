"""What stands in results.json, as types; results.schema.json is made from them."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Field

from hullform.record_table import Finite, Frequencies
from hullform.record_table import RecordTable as _Table
from hullform.rest_records import FloatingRecord, StillWaterRecord
from hullform.service_records import RatiosRecord, ResonanceRecord, SpringingRecord
from hullform.water_records import InWaterRecord


class Provenance(_Table):
    """What made the file, from what, and how long it took."""

    program: str
    versions: dict[str, str]
    created_utc: str
    ship_file: str
    ship_file_sha256: str
    body_plan_file: str | None
    body_plan_file_sha256: str | None
    profile: str | None
    profile_sha256: str | None
    review: str | None
    review_sha256: str | None
    seconds: dict[str, Finite]


class CheckRecord(_Table):
    """A plausibility check: a value held between its limits, null where there is none; `limit` is the nearer one."""

    id: str
    title: str
    value: Finite
    limit: Finite
    limits: tuple[Finite | None, Finite | None]
    unit: str
    ok: bool
    remedy: str


class StationRecord(_Table):
    """A drawn station and the model that stands for it.

    The model is null where the station is too thin to have a shape; p and q are those of a super-ellipse. Errors of the
    areas below the waterline and to the deck are shares of the drawn ones; the deviation is a Hausdorff distance.
    """

    x_m: Finite
    half: Literal["aft", "fore"]
    name: str
    confidence: Finite
    shared_with_m: list[Finite]
    half_breadth_m: Finite
    top_height_m: Finite
    keel_height_m: Finite
    model: str | None
    p: Finite | None
    q: Finite | None
    area_error: Finite | None
    area_error_to_deck: Finite | None
    largest_deviation_m: Finite | None


class HullRecord(_Table):
    """The hull as read and lofted. Of `source` 'particulars' nothing was drawn: the form is made of them."""

    source: Literal["picture", "offsets", "mesh", "particulars"]
    stations: list[StationRecord]
    hydrostatics: dict[str, Finite]
    notes: list[str]
    calibration: dict[str, Any] | None


class PlatesRecord(_Table):
    """Plates of one name in the half section at midships, as given: a polyline, gross thickness, stiffeners."""

    name: str
    y_m: list[Finite]
    z_m: list[Finite]
    thickness_m: Finite
    stiffener_share: Finite
    effective_share: Finite


class StructureRecord(_Table):
    """The section at midships, and the curves along the ship; where a member begins or ends an x stands twice."""

    plain_shell: bool
    midship_plates: list[PlatesRecord]
    steel_volume_m3: Finite
    transverse_steel_m3: list[tuple[Finite, Finite]]

    midship_shell_second_moment_m4: Finite
    thickness_factor: Finite
    midship_shell_shear_area_m2: Finite
    shear_factor: Finite
    equivalent_thickness_m: Finite
    youngs_modulus_pa: Finite
    shear_modulus_pa: Finite
    stations_at_the_floor: int
    x_m: list[Finite]
    girth_m: list[Finite]
    area_m2: list[Finite]
    neutral_axis_m: list[Finite]
    second_moment_m4: list[Finite]
    horizontal_second_moment_m4: list[Finite]
    shear_area_m2: list[Finite]
    torsion_constant_m4: list[Finite]
    steel_area_m2: list[Finite]


class LightShipRecord(_Table):
    """Steel as given or estimated, and what Watson would expect of steel, machinery and outfit, with ranges."""

    steel_weight_t: Finite
    steel_given: bool
    steel_estimate_t: Finite
    steel_estimate_range_t: tuple[Finite, Finite]
    machinery_and_outfit_t: Finite
    machinery_and_outfit_given: bool
    machinery_and_outfit_estimate_t: Finite | None
    machinery_and_outfit_range_t: tuple[Finite, Finite] | None


class Solution(_Table):
    """Frequencies by one method."""

    method: str
    theory: str
    medium: str
    functions: int | None = None
    steps: int | None = None
    rigid_body: bool | None = None
    basis: str | None = None
    elements: int | None = None
    solver: str | None = None
    rotary_inertia: bool | str | None = None
    dry_method: str | None = None
    hydrostatics: bool | None = None
    frequency_tail: bool | None = None
    flow: str | None = None
    panels: int | None = None
    depth_m: Finite | None = None
    sections: int | None = None
    lengthwise: str | None = None
    asymmetry: Finite | None = None
    frequencies_rad_s: Frequencies
    frequencies_hz: Frequencies
    node_counts: list[int]
    nodes_m: list[list[Finite]]
    modal_mass_kg: list[Finite]
    normalisation: str


class BracketRecord(_Table):
    """Two-sided bounds of the Euler-Bernoulli frequencies; null where nothing is proven, and `proof` says why."""

    lower: Frequencies | None
    upper: Frequencies | None
    proof: str


class Band(_Table):
    """What the model leaves open of each frequency: u over it, f (1 - u) and f (1 + u)."""

    uncertainty: list[Finite]
    lower_hz: Frequencies
    upper_hz: Frequencies


class Headline(_Table):
    """The figures to quote, and what they are figures of."""

    medium: str
    theory: str
    frequencies_hz: Frequencies
    band: Band


class DistortionRecord(_Table):
    """How the modes differ from the uniform beam's."""

    weights: list[list[Finite]]
    diagonal_dominance: list[Finite | None]
    nondimensional_frequencies: Frequencies
    node_shifts_m: list[list[Finite] | None]
    antinode_shifts_m: list[list[Finite] | None]
    energy_bounds_m: list[Finite]
    kinetic_energy_shares: list[list[Finite]]
    strain_energy_shares: list[list[Finite]]
    mass_correlation: list[Finite]
    rigidity_correlation: list[Finite]


class WeightRecord(_Table):
    """One weight: its mass and the x of its centre."""

    name: str
    mass_kg: Finite
    centre_m: Finite | None


class ConditionRecord(_Table):
    """One loading condition."""

    label: str
    mass_kg: Finite
    lcg_m: Finite
    displacement_kg: Finite
    draughts: dict[str, Finite]
    draughts_from: Literal["equilibrium", "given draughts", "even keel"]
    draughts_reason: str
    equilibrium: FloatingRecord | None
    still_water: StillWaterRecord
    weights: list[WeightRecord]
    hydrostatics: dict[str, Finite]
    checks: list[CheckRecord]
    doubts: list[str]
    dry_rad_s: dict[str, Frequencies]
    wet_rad_s: dict[str, Frequencies]
    in_water: InWaterRecord
    bracket_rad_s: BracketRecord
    empirical_rad_s: dict[str, Frequencies]
    empirical_inputs: dict[str, Finite]
    headline: Headline
    solutions: list[Solution]
    convergence: dict[str, dict[str, Frequencies]]
    distortion: DistortionRecord
    ships_as_they_are: RatiosRecord
    resonance: ResonanceRecord | None
    springing: SpringingRecord | None


class Results(_Table):
    """The whole file."""

    model_config = ConfigDict(extra="forbid", validate_by_name=True, validate_by_alias=True)

    schema_number: Annotated[Literal[1], Field(alias="schema")]
    provenance: Provenance
    ship: dict[str, Any]
    hull: HullRecord
    structure: StructureRecord
    light_ship: LightShipRecord
    checks: list[CheckRecord]
    doubts: list[str]
    conditions: dict[str, ConditionRecord]


def json_schema() -> dict[str, Any]:
    """The JSON schema of results.json, as shipped beside this module."""
    return Results.model_json_schema(mode="serialization")
