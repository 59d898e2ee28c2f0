"""[body_plan] of ship.toml: the picture, which stations it shows, and what the user knows of its scale."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import Field, PrivateAttr, field_validator, model_validator

from hullform.quantities import Number, Positive, Table
from hullform.station_names import StationNames, fault_of_names

Half = Literal["aft", "fore"]
Side = Literal["left", "right"]
StationName = Annotated[str, Field(strict=True, pattern=r"^\S(.*\S)?$", max_length=16)]
SAME_STATION_M = 1e-3  # nearer to each other, two places along the ship mean one station


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


class BodyPlanSource(Table):
    """[body_plan]: the picture, and which stations it shows."""

    image: Annotated[str, Field(min_length=1)]
    page: Annotated[int, Field(strict=True, ge=1)] = 1
    aft_side: Side
    aft_stations_m: Annotated[tuple[Number, ...], Field(min_length=1)]
    fore_stations_m: Annotated[tuple[Number, ...], Field(min_length=1)]
    aft_station_names: tuple[StationName, ...] = ()
    fore_station_names: tuple[StationName, ...] = ()
    calibration: CalibrationGiven | None = None
    marks: tuple[Mark, ...] = ()
    _folder: Path = PrivateAttr(default=Path())

    @field_validator("aft_stations_m", "fore_stations_m")
    @classmethod
    def _from_aft_forward(cls, stations: tuple[float, ...]) -> tuple[float, ...]:
        for before, after in itertools.pairwise(stations):
            if after <= before:
                raise ValueError(f"{after:g} follows {before:g}; list each half's stations from aft forward, each once")
        return stations

    @field_validator("aft_station_names", "fore_station_names", mode="before")
    @classmethod
    def _names_are_text(cls, names: Any) -> Any:
        for name in names if isinstance(names, list) else ():
            if isinstance(name, int | float):
                raise ValueError(f'{name} is a number; put the names in quotation marks: "{name}"')
        return names

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
