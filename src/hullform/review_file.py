"""<ship>.review.json: what a person confirmed and corrected of one picture.

It goes before the calibration, stations and marks of ship.toml, which go before what is found in the picture.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from hullform.corrections import Correction, Drawn, MarkedStation
from hullform.errors import ReviewError
from hullform.files import whole_file
from hullform.quantities import Number
from hullform.ship import Ship
from hullform.ship_body_plan import SAME_STATION_M, CalibrationGiven, Half, PictureSource, Side, StationName

BLOCK_BYTES = 1 << 20
NEVER_SAVED = "none"
HALVES: tuple[Half, Half] = ("aft", "fore")


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class ReviewedPicture(_Part):
    """The picture that was looked at."""

    file: str
    sha256: Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]


class ReviewedStations(_Part):
    """Which half is drawn left, the stations of each half from aft forward, and what the drawing calls them.

    Without names a station keeps the one that ship.toml gives to its x.
    """

    aft_side: Side
    aft_stations_m: Annotated[tuple[Number, ...], Field(min_length=1)]
    fore_stations_m: Annotated[tuple[Number, ...], Field(min_length=1)]
    aft_station_names: tuple[StationName, ...] = ()
    fore_station_names: tuple[StationName, ...] = ()

    def over(self, source: PictureSource) -> dict[str, Any]:
        """The keys of [body_plan] that change."""
        changed = self.model_dump()
        for half in HALVES:
            if not changed[f"{half}_station_names"]:
                changed[f"{half}_station_names"] = source.names_of(half).kept_by(changed[f"{half}_stations_m"])
        return changed


class Review(_Part):
    """A whole review file. What is None was left as ship.toml has it, or as it is found."""

    schema_number: Annotated[Literal[1], Field(alias="schema")] = 1
    picture: ReviewedPicture
    calibration: CalibrationGiven | None = None
    stations: ReviewedStations | None = None
    corrections: tuple[Correction, ...] = ()

    @model_validator(mode="after")
    def _each_correction_has_its_id(self) -> Self:
        ids = [correction.id for correction in self.corrections]
        for id in ids:
            if ids.count(id) > 1:
                raise ValueError(f"corrections: the id '{id}' stands twice; give each correction its own")
        return self

    @property
    def account(self) -> str:
        """What it has to say, in words."""
        said = ["the calibration"] * (self.calibration is not None) + ["the stations"] * (self.stations is not None)
        count = len(self.corrections)
        said += [f"{count} correction{'s' if count > 1 else ''}"] * (count > 0)
        return ", ".join(said) or "nothing"

    def applied_to(self, ship: Ship) -> Ship:
        """The ship with the review's calibration, stations and marks in place of those of her file.

        A station that the review marks loses the marks of the file.

        Raises:
            ReviewError: the stations do not fit the marks or the drawn curves.
        """
        source = ship.picture
        marks = [correction.mark for correction in self.corrections if isinstance(correction, MarkedStation)]
        marked = {(mark.half, mark.station_m, mark.curve) for mark in marks}
        marks += [mark for mark in source.marks if (mark.half, mark.station_m, mark.curve) not in marked]
        stations = {} if self.stations is None else self.stations.over(source)
        calibration = self.calibration if self.calibration is not None else source.calibration
        changed = source.model_dump() | stations
        changed |= {
            "calibration": None if calibration is None else calibration.model_dump(),
            "marks": tuple(mark.model_dump() for mark in marks),
        }
        try:
            reviewed = PictureSource.model_validate(changed)
        except ValidationError as error:
            raise _refused(ship.review_path, error) from None
        listed = {"aft": reviewed.aft_stations_m, "fore": reviewed.fore_stations_m}
        for curve in (correction for correction in self.corrections if isinstance(correction, Drawn)):
            if all(abs(curve.station_m - x) > SAME_STATION_M for x in listed[curve.half]):
                raise ReviewError(
                    f"{ship.review_path}: the curve {curve.id} is drawn for station {curve.station_m:g} m of the "
                    f"{curve.half} half, which {curve.half}_stations_m does not list; delete it, or list the station"
                )
        return ship.reading(reviewed)


def new_review(ship: Ship) -> Review:
    """An empty review of the ship's picture."""
    image = ship.picture.image_path
    return Review(picture=ReviewedPicture(file=ship.picture.image, sha256=_hash_of(image)))


def read_review(ship: Ship) -> Review | None:
    """The review that lies beside a ship.toml, or None where there is none.

    Raises:
        ReviewError: the file is damaged, or was made of another picture.
    """
    path = ship.review_path
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None
    except (OSError, UnicodeDecodeError) as error:
        raise ReviewError(f"{path}: cannot be read ({error}); check it, or move it away") from None
    except json.JSONDecodeError as error:
        raise ReviewError(f"{path}: is no JSON: {error}; mend it, or move it away and review again") from None
    return checked_review(document, ship)


def checked_review(document: object, ship: Ship) -> Review:
    """A review out of its JSON document, which must be of the ship's picture as it lies there.

    Raises:
        ReviewError: it is no review, or was made of another picture.
    """
    path = ship.review_path
    try:
        review = Review.model_validate(document)
    except ValidationError as error:
        raise _refused(path, error) from None
    image = ship.picture.image_path
    if review.picture.sha256 != _hash_of(image):
        raise ReviewError(
            f"{path}: was made of another picture than {image} is now; its places mean nothing here. "
            "Put the former picture back, or move the review away and run 'hullform review' again"
        )
    return review


def write_review(review: Review, ship: Ship) -> Path:
    """Write the review beside its ship.toml, whole or not at all; returns the path.

    Raises:
        OutputError: the file cannot be written.
    """
    path = ship.review_path
    document: dict[str, Any] = review.model_dump(mode="json", by_alias=True, exclude_none=True)
    with whole_file(path) as aside:
        aside.write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    return path


def revision_of(ship: Ship) -> str:
    """What the review file beside a ship.toml is called as it lies there now: another name after every change.

    It is a hash of what the file holds, so that another page, another run and an editor are told alike.

    Raises:
        ReviewError: it cannot be read.
    """
    path = ship.review_path
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()[:16]
    except FileNotFoundError:
        return NEVER_SAVED
    except OSError as error:
        raise ReviewError(f"{path}: cannot be read ({error.strerror}); check it, or move it away") from None


def _hash_of(path: Path) -> str:
    found = hashlib.sha256()
    try:
        with path.open("rb") as file:
            while block := file.read(BLOCK_BYTES):
                found.update(block)
    except OSError as error:
        raise ReviewError(f"{path}: cannot be read ({error.strerror}); check [body_plan] image in ship.toml") from None
    return found.hexdigest()


def _refused(path: Path, error: ValidationError) -> ReviewError:
    faults = [(".".join(str(place) for place in fault["loc"]) or "the file", fault["msg"]) for fault in error.errors()]
    return ReviewError(
        "\n".join(f"{path}: {where}: {message.removeprefix('Value error, ')}" for where, message in faults)
    )
