"""[body_plan] of ship.toml: where her form comes from, a picture, a table, a mesh, or her particulars alone."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import Discriminator, Field, PrivateAttr, Tag, field_validator, model_validator

from hullform.quantities import Number, Positive, Table
from hullform.station_names import StationNames, fault_of_names

Half = Literal["aft", "fore"]
Side = Literal["left", "right"]
Unit = Literal["m", "cm", "mm", "ft", "in"]
Axis = Literal["+x", "-x", "+y", "-y", "+z", "-z"]
METRES_PER: dict[Unit, float] = {"m": 1.0, "cm": 0.01, "mm": 0.001, "ft": 0.3048, "in": 0.0254}
StationName = Annotated[str, Field(strict=True, pattern=r"^\S(.*\S)?$", max_length=16)]
SAME_STATION_M = 1e-3  # nearer to each other, two places along the ship mean one station


def from_aft_forward(stations: tuple[float, ...], remedy: str) -> tuple[float, ...]:
    """The same stations; ValueError where one does not lie forward of the one before."""
    for before, after in itertools.pairwise(stations):
        if after <= before:
            raise ValueError(f"{after:g} follows {before:g}; {remedy}")
    return stations


class CalibrationPoint(Table):
    """A point known in the picture and on the ship: px = [u, v], m = [y, z] (y negative in the left half)."""

    px: tuple[Number, Number]
    m: tuple[Number, Number]


class CalibrationGiven(Table):
    """[body_plan.calibration]: what the user knows of the picture; the rest is found in it."""

    centreline_px: Number | None = None
    baseline_px: Number | None = None
    metres_per_px: Positive | None = None
    rotation_deg: Annotated[float, Field(gt=-45, lt=45)] | None = None
    points: tuple[CalibrationPoint, ...] = ()


class Mark(Table):
    """[[body_plan.marks]]: a point on a station's curve, as a person would click it."""

    station_m: Number
    half: Half
    px: tuple[Number, Number]
    curve: Annotated[int, Field(ge=0, le=1)] = 0


class _Source(Table):
    """What every kind of [body_plan] has: the folder of ship.toml, beside which its file lies."""

    _folder: Path = PrivateAttr(default=Path())

    @property
    def file(self) -> Path | None:
        """The file that the form is read from; None where there is none."""
        return None


class PictureSource(_Source):
    """[body_plan] with `image`: the picture, and which stations it shows."""

    image: Annotated[str, Field(min_length=1)]
    page: Annotated[int, Field(strict=True, ge=1)] = 1
    aft_side: Side
    aft_stations_m: Annotated[tuple[Number, ...], Field(min_length=1)]
    fore_stations_m: Annotated[tuple[Number, ...], Field(min_length=1)]
    aft_station_names: tuple[StationName, ...] = ()
    fore_station_names: tuple[StationName, ...] = ()
    calibration: CalibrationGiven | None = None
    marks: tuple[Mark, ...] = ()

    @field_validator("aft_stations_m", "fore_stations_m")
    @classmethod
    def _from_aft_forward(cls, stations: tuple[float, ...]) -> tuple[float, ...]:
        return from_aft_forward(stations, "list each half's stations from aft forward, each once")

    @field_validator("aft_station_names", "fore_station_names", mode="before")
    @classmethod
    def _names_are_text(cls, names: Any) -> Any:
        for name in names if isinstance(names, list) else ():
            if isinstance(name, int | float):
                raise ValueError(f'{name} is a number; put the names in quotation marks: "{name}"')
        return names

    @model_validator(mode="after")
    def _aft_half_lies_aft(self) -> Self:
        aft, fore = (sum(x) / len(x) for x in (self.aft_stations_m, self.fore_stations_m))
        if aft >= fore:
            raise ValueError(
                f"aft_stations_m lie at {aft:g} m on average, fore_stations_m at {fore:g} m; x runs from the aft end "
                "forward, in metres: exchange the lists, or the stations are numbers from another end"
            )
        return self

    @model_validator(mode="after")
    def _each_station_has_its_name(self) -> Self:
        for half in ("aft", "fore"):
            names, stations = getattr(self, f"{half}_station_names"), getattr(self, f"{half}_stations_m")
            fault = fault_of_names(half, names, len(stations))
            if fault is not None:
                raise ValueError(fault)
        return self

    @model_validator(mode="after")
    def _marks_name_stations(self) -> Self:
        for mark in self.marks:
            stations = self.aft_stations_m if mark.half == "aft" else self.fore_stations_m
            if all(abs(mark.station_m - x) > SAME_STATION_M for x in stations):
                raise ValueError(
                    f"a mark names station {mark.station_m:g} m of the {mark.half} half, "
                    f"which {mark.half}_stations_m does not list"
                )
        return self

    def names_of(self, half: Half) -> StationNames:
        """What the drawing calls the stations of a half."""
        if half == "aft":
            return StationNames(half, self.aft_stations_m, self.aft_station_names)
        return StationNames(half, self.fore_stations_m, self.fore_station_names)

    @property
    def image_path(self) -> Path:
        """Where the picture lies: beside ship.toml unless the path is absolute."""
        return self._folder / self.image

    @property
    def file(self) -> Path:
        """The picture."""
        return self.image_path


class OffsetsSource(_Source):
    """[body_plan] with `offsets`: a table of points or of half-breadths, as csv."""

    offsets: Annotated[str, Field(min_length=1)]
    unit: Unit = "m"
    origin_x_m: Number = 0.0
    origin_z_m: Number = 0.0

    @property
    def file(self) -> Path:
        """The table: beside ship.toml unless the path is absolute."""
        return self._folder / self.offsets


class MeshSource(_Source):
    """[body_plan] with `mesh`: a surface of triangles, and how its axes lie in the ship."""

    mesh: Annotated[str, Field(min_length=1)]
    unit: Unit = "m"
    forward: Axis = "+x"
    up: Axis = "+z"
    origin_x_m: Number = 0.0
    origin_y_m: Number = 0.0
    origin_z_m: Number = 0.0
    up_to_m: Positive | None = None
    stations_m: tuple[Number, ...] = ()

    @field_validator("stations_m")
    @classmethod
    def _from_aft_forward(cls, stations: tuple[float, ...]) -> tuple[float, ...]:
        return from_aft_forward(stations, "list the stations from aft forward, each once")

    @model_validator(mode="after")
    def _three_stations_or_none(self) -> Self:
        if 0 < len(self.stations_m) < 3:
            raise ValueError(
                f"stations_m lists {len(self.stations_m)}; a hull needs three or more, or leave the list out"
            )
        return self

    @model_validator(mode="after")
    def _two_axes(self) -> Self:
        if self.forward[1] == self.up[1]:
            raise ValueError(f'forward = "{self.forward}" and up = "{self.up}" are one axis of the mesh; give two')
        return self

    @property
    def file(self) -> Path:
        """The mesh: beside ship.toml unless the path is absolute."""
        return self._folder / self.mesh


class ParticularsSource(_Source):
    """[body_plan] left out, or with neither picture, table nor mesh: a form made of the main particulars."""

    midship_coefficient: Annotated[float, Field(strict=True, gt=0.5, lt=1)] | None = None
    parallel_body_share: Annotated[float, Field(strict=True, ge=0, le=0.8)] | None = None


# The key that names each kind of source, and the kind. Without any it is the particulars'.
SOURCES: dict[str, type[_Source]] = {"image": PictureSource, "offsets": OffsetsSource, "mesh": MeshSource}
PARTICULARS = "particulars"


def kind_of_source(given: Any) -> str:
    """The kind of [body_plan]: by the key that names its file, else by the kind that alone knows a key of it."""
    if isinstance(given, _Source):
        return next((key for key, source in SOURCES.items() if isinstance(given, source)), PARTICULARS)
    if not isinstance(given, dict):
        return PARTICULARS
    for key in SOURCES:
        if key in given:
            return key
    own = [key for key, source in SOURCES.items() if _own_keys(source).intersection(given)]
    return own[0] if len(own) == 1 else PARTICULARS


def _own_keys(source: type[_Source]) -> set[str]:
    """The keys that no other kind of source has."""
    others: list[type[_Source]] = [ParticularsSource]
    others += [other for other in SOURCES.values() if other is not source]
    return set(source.model_fields) - {key for other in others for key in other.model_fields}


BodyPlanSource = Annotated[
    Annotated[PictureSource, Tag("image")]
    | Annotated[OffsetsSource, Tag("offsets")]
    | Annotated[MeshSource, Tag("mesh")]
    | Annotated[ParticularsSource, Tag(PARTICULARS)],
    Discriminator(kind_of_source),
]
