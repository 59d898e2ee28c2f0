"""ship.toml: what a user knows of a ship besides her picture.

Every fault of a file is listed at once with its path; unknown keys are refused with the nearest known one.
"""

from __future__ import annotations

import itertools
import math
import tomllib
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import Field, PrivateAttr, ValidationError, field_validator, model_validator

from hullform.errors import ShipFileError
from hullform.quantities import SEA_WATER_KG_M3, NotNegative, Number, Positive, Table, WaterDensity
from hullform.ship_body_plan import (
    SOURCES,
    BodyPlanSource,
    MeshSource,
    ParticularsSource,
    PictureSource,
)
from hullform.ship_excitation import ExcitationInput
from hullform.ship_faults import fault_lines
from hullform.ship_operation import OperationInput
from hullform.ship_structure import StructureInput
from hullform.ship_weights import ConditionInput, WeightsInput

REVIEW_SUFFIX = ".review.json"
# Least and greatest ratios: from barges and pontoons to rowing shells; beyond them one of the two is in another unit.
UNLIKE_ANY_SHIP = {
    ("length_overall_m", "breadth_m"): (0.5, 50.0),
    ("breadth_m", "depth_m"): (0.2, 30.0),
    ("length_overall_m", "length_between_perpendiculars_m"): (1.0, 2.0),
    ("depth_m", "draught_m"): (1.0, 50.0),
}
# Of the water in a block of LOA B D: a mass beyond it is no overload but in another unit.
NO_SUCH_MASS = 2.0

ShipType = Literal[
    "tanker",
    "chemical-tanker",
    "bulk-carrier",
    "container",
    "refrigerated-cargo",
    "coaster",
    "offshore-supply",
    "tug",
    "research",
    "ro-ro-ferry",
    "passenger",
    "frigate",
]


class Particulars(Table):
    """[ship]: main particulars, moulded, in metres."""

    name: Annotated[str, Field(min_length=1)]
    type: ShipType
    length_overall_m: Positive
    length_between_perpendiculars_m: Positive
    aft_perpendicular_m: NotNegative
    breadth_m: Positive
    depth_m: Positive
    draught_m: Positive
    displacement_t: Positive | None = None
    block_coefficient: Annotated[float, Field(gt=0, le=1)] | None = None
    lcb_from_midships_m: Number | None = None

    @model_validator(mode="before")
    @classmethod
    def _aft_perpendicular_where_lengths_agree(cls, values: Any) -> Any:
        if not isinstance(values, dict):
            return values
        lengths_agree = values.get("length_between_perpendiculars_m") == values.get("length_overall_m")
        return {"aft_perpendicular_m": 0.0, **values} if lengths_agree else values

    @model_validator(mode="after")
    def _lengths_and_draught_fit(self) -> Self:
        overall, perpendiculars = self.length_overall_m, self.length_between_perpendiculars_m
        if perpendiculars > overall:
            raise ValueError(
                f"length_between_perpendiculars_m = {perpendiculars:g} is longer than length_overall_m = "
                f"{overall:g}; give the length overall in metres"
            )
        fore_perpendicular = self.aft_perpendicular_m + perpendiculars
        if fore_perpendicular > overall + 1e-6:
            raise ValueError(
                f"aft_perpendicular_m = {self.aft_perpendicular_m:g} puts the fore perpendicular at x = "
                f"{fore_perpendicular:g} m, forward of the ship's end at {overall:g} m"
            )
        if self.draught_m > self.depth_m:
            raise ValueError(
                f"draught_m = {self.draught_m:g} is above depth_m = {self.depth_m:g}; "
                "the depth is measured from the base line to the deck at side"
            )
        for (longer, shorter), (least, greatest) in UNLIKE_ANY_SHIP.items():
            one, other = getattr(self, longer), getattr(self, shorter)
            if not least <= one / other <= greatest:
                raise ValueError(
                    f"{longer} = {one:g} is {one / other:.3g} times {shorter} = {other:g}, as in no ship; "
                    "check that all of [ship] is in metres"
                )
        return self


class HullOptions(Table):
    """[hull]: which curves stand for the stations, as `hull.ladder` has them; the contour in the centre plane."""

    sections: Literal["auto", "super-ellipse", "traced"] = "auto"
    profile: Annotated[str, Field(min_length=1)] | None = None


class Water(Table):
    """[water]: what she floats in."""

    density_kg_m3: WaterDensity = SEA_WATER_KG_M3
    depth_m: Positive | None = None

    @property
    def bottom_m(self) -> float:
        """Its depth, infinite in deep water."""
        return math.inf if self.depth_m is None else self.depth_m


class EmpiricalInput(Table):
    """[empirical]: the length that Todd and Schlick take, by default the length overall."""

    length_m: Positive | None = None


class Ship(Table):
    """A whole ship.toml. `structure`, `weights` and `conditions` may be missing until a run needs them."""

    schema_number: Annotated[Literal[1], Field(alias="schema")]
    particulars: Annotated[Particulars, Field(alias="ship")]
    body_plan: BodyPlanSource = Field(default_factory=ParticularsSource)
    hull: HullOptions = HullOptions()
    structure: StructureInput | None = None
    weights: WeightsInput | None = None
    conditions: tuple[ConditionInput, ...] = ()
    water: Water = Water()
    empirical: EmpiricalInput = EmpiricalInput()
    excitation: ExcitationInput | None = None
    operation: OperationInput | None = None
    _path: Path = PrivateAttr(default=Path())

    @field_validator("body_plan", mode="before")
    @classmethod
    def _one_source(cls, given: Any) -> Any:
        named = [key for key in SOURCES if isinstance(given, dict) and key in given]
        if len(named) > 1:
            raise ValueError(f"has {' and '.join(named)}; the form comes from one of them: remove the others")
        return given

    @model_validator(mode="after")
    def _names_and_stations_fit(self) -> Self:
        names = [condition.name for condition in self.conditions]
        for name in names:
            if names.count(name) > 1:
                raise ValueError(
                    f"two conditions are called '{name}'; condition names are file names, so make them unique"
                )
        overall = self.particulars.length_overall_m
        for key, stations in self._listed_stations().items():
            for x in stations:
                if not -1e-6 <= x <= overall + 1e-6:
                    raise ValueError(
                        f"body_plan.{key} has {x:g}, outside the ship (0 .. {overall:g} m); "
                        "x runs from the aft end of the length overall"
                    )
        return self

    @model_validator(mode="after")
    def _structure_lies_in_the_ship(self) -> Self:
        if self.structure is not None:
            self.structure.require_within(self.particulars.length_overall_m, self.particulars.breadth_m)
        return self

    @model_validator(mode="after")
    def _weights_lie_in_the_ship(self) -> Self:
        light = () if self.weights is None else self.weights.items
        for item in itertools.chain(light, *(condition.items for condition in self.conditions)):
            item.require_within(self.particulars.length_overall_m)
        return self

    @model_validator(mode="after")
    def _weights_are_in_tonnes(self) -> Self:
        main = self.particulars
        block_t = self.water.density_kg_m3 * main.length_overall_m * main.breadth_m * main.depth_m / 1e3
        masses = {f"conditions, {condition.name}": condition.load_t for condition in self.conditions}
        if self.weights is not None:
            masses["weights.steel_weight_t"] = self.weights.steel_weight_t or 0.0
            masses["weights, machinery and outfit"] = self.weights.beyond_steel_t or 0.0
        for place, mass_t in masses.items():
            if mass_t > NO_SUCH_MASS * block_t:
                raise ValueError(
                    f"{place}: {mass_t:.10g} t is {mass_t / block_t:.3g} times the water in a block of her length, "
                    "breadth and depth; check that masses are in tonnes and [ship] in metres"
                )
        return self

    @model_validator(mode="after")
    def _propeller_and_engine_lie_in_the_ship(self) -> Self:
        if self.excitation is not None:
            self.excitation.require_within(self.particulars.length_overall_m)
        return self

    @property
    def path(self) -> Path:
        """The file that was read."""
        return self._path

    def _listed_stations(self) -> dict[str, tuple[float, ...]]:
        """The lists of stations in [body_plan], by their keys."""
        source = self.body_plan
        if isinstance(source, PictureSource):
            return {"aft_stations_m": source.aft_stations_m, "fore_stations_m": source.fore_stations_m}
        return {"stations_m": source.stations_m} if isinstance(source, MeshSource) else {}

    @property
    def files(self) -> tuple[Path, ...]:
        """What is read: ship.toml, the file of her form, and the review of her picture where there is one."""
        read = self._path, self.body_plan.file, self.review_path, self.profile_path
        return tuple(file for file in read if file is not None)

    @property
    def profile_path(self) -> Path | None:
        """Her profile, if there is one: beside ship.toml unless the path is absolute."""
        return None if self.hull.profile is None else self._path.parent / self.hull.profile

    @property
    def picture(self) -> PictureSource:
        """Her picture.

        Raises:
            ShipFileError: her form comes from something else.
        """
        if isinstance(self.body_plan, PictureSource):
            return self.body_plan
        source = "her particulars" if self.body_plan.file is None else self.body_plan.file.name
        raise ShipFileError(
            f"{self.path}: her form comes from {source}, and this needs a picture: give body_plan.image"
        )

    @property
    def review_path(self) -> Path:
        """Where the review of her picture lies: beside her ship.toml, by its name."""
        return self._path.with_name(self._path.stem + REVIEW_SUFFIX)

    def reading(self, body_plan: PictureSource) -> Ship:
        """The same ship with another account of the same picture."""
        body_plan._folder = self.body_plan._folder
        return self.model_copy(update={"body_plan": body_plan})

    def require_condition(self, name: str) -> ConditionInput:
        """The loading condition of that name.

        Raises:
            ShipFileError: there is none; lists those that there are.
        """
        for condition in self.conditions:
            if condition.name == name:
                return condition
        names = ", ".join(condition.name for condition in self.conditions) or "none"
        raise ShipFileError(f"{self.path}: has no condition '{name}'; its conditions: {names}")

    def require_sections_of_a_run(self) -> tuple[StructureInput, WeightsInput, tuple[ConditionInput, ...]]:
        """The tables that `run` needs beyond [ship] and [body_plan].

        Raises:
            ShipFileError: names those that are missing.
        """
        missing = [name for name in ("structure", "weights") if getattr(self, name) is None]
        if not self.conditions:
            missing.append("[conditions]")
        if self.structure is None or self.weights is None or missing:
            raise ShipFileError(
                f"{self.path}: a run needs {', '.join(f'[{name}]' for name in missing)} too; "
                "add it (an empty [structure] or [weights] takes the defaults)"
            )
        return self.structure, self.weights, self.conditions


def read_ship(path: str | Path) -> Ship:
    """Read and check a ship.toml.

    Raises:
        ShipFileError: the file is missing, is no TOML, or breaks the format; lists every fault with its path.
    """
    path = Path(path)
    try:
        document = tomllib.loads(path.read_text(encoding="utf-8-sig"))
    except FileNotFoundError:
        raise ShipFileError(f"{path}: no such file; give the path of a ship.toml") from None
    except IsADirectoryError:
        raise ShipFileError(f"{path}: is a folder; give the ship.toml in it") from None
    except UnicodeDecodeError:
        raise ShipFileError(f"{path}: is no text file in UTF-8; give the ship.toml, not the picture") from None
    except OSError as error:
        raise ShipFileError(f"{path}: cannot be read ({error.strerror}); check its permissions") from None
    except tomllib.TOMLDecodeError as error:
        raise ShipFileError(f"{path}: is no TOML: {error}") from None
    try:
        ship = Ship.model_validate(document)
    except ValidationError as error:
        faults = fault_lines(error.errors(), Ship)
        raise ShipFileError("\n".join(f"{path}: {fault}" for fault in faults)) from None
    ship._path = path
    ship.body_plan._folder = path.parent
    return ship
