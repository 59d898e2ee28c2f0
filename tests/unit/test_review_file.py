"""The review file: it goes before ship.toml, and says what is wrong with it."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from hullform.cli import main
from hullform.corrections import Cut, MarkedStation
from hullform.errors import ReviewError
from hullform.review_file import Review, ReviewedStations, new_review, read_review, write_review
from hullform.ship import Ship, read_ship
from hullform.ship_body_plan import CalibrationGiven

WIGLEY = Path(__file__).parents[2] / "bodyplans" / "wigley"


@pytest.fixture
def ship(tmp_path: Path) -> Ship:
    for name in ("ship.toml", "bodyplan.png"):
        shutil.copy(WIGLEY / name, tmp_path / name)
    return read_ship(tmp_path / "ship.toml")


def test_a_ship_without_a_review_has_none(ship: Ship) -> None:
    assert read_review(ship) is None


def test_a_review_comes_back_as_it_was_written(ship: Ship) -> None:
    station = ship.body_plan.aft_stations_m[1]
    review = new_review(ship).model_copy(
        update={
            "calibration": CalibrationGiven(centreline_px=700.25),
            "corrections": (
                MarkedStation(id="c1", station_m=station, half="aft", px=(10.5, 20.0)),
                Cut(id="c2", px=(1.0, 2.0)),
            ),
        }
    )
    path = write_review(review, ship)
    assert path == ship.review_path == ship.path.parent / "ship.review.json"
    assert read_review(ship) == review


def test_a_review_goes_before_the_file(ship: Ship) -> None:
    first, *others = ship.body_plan.aft_stations_m
    review = new_review(ship).model_copy(
        update={
            "calibration": CalibrationGiven(baseline_px=900.0),
            "stations": ReviewedStations(
                aft_side="right", aft_stations_m=tuple(others), fore_stations_m=ship.body_plan.fore_stations_m
            ),
            "corrections": (MarkedStation(id="c1", station_m=others[0], half="aft", px=(10.5, 20.0)),),
        }
    )
    applied = review.applied_to(ship).body_plan
    assert applied.calibration == CalibrationGiven(baseline_px=900.0)
    assert (applied.aft_side, applied.aft_stations_m) == ("right", tuple(others))
    assert [(mark.station_m, mark.px) for mark in applied.marks] == [(others[0], (10.5, 20.0))]
    assert applied.image_path == ship.body_plan.image_path
    assert first in ship.body_plan.aft_stations_m  # the ship that was given is as it was


def test_a_mark_of_a_station_that_is_not_listed_is_refused(ship: Ship) -> None:
    review = new_review(ship).model_copy(
        update={"corrections": (MarkedStation(id="c1", station_m=-7.0, half="aft", px=(1.0, 2.0)),)}
    )
    with pytest.raises(ReviewError, match=r"ship\.review\.json.*-7 m of the aft half"):
        review.applied_to(ship)


def test_a_changed_picture_is_an_error_that_says_what_to_do(ship: Ship) -> None:
    write_review(new_review(ship), ship)
    ship.body_plan.image_path.write_bytes(b"another")
    with pytest.raises(ReviewError, match=r"another picture.*Put the former picture back"):
        read_review(ship)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{", "is no JSON"),
        ("{}", "picture: Field required"),
        ('{"picture": {"file": "a.png", "sha256": "zz"}}', "picture.sha256"),
    ],
)
def test_a_damaged_review_is_named(ship: Ship, text: str, said: str) -> None:
    ship.review_path.write_text(text, encoding="utf-8")
    with pytest.raises(ReviewError, match=said):
        read_review(ship)


def test_a_correction_of_an_unknown_kind_is_named(ship: Ship) -> None:
    path = write_review(new_review(ship), ship)
    document = json.loads(path.read_text(encoding="utf-8"))
    document["corrections"] = [{"kind": "melt", "id": "c1", "px": [1, 2]}]
    path.write_text(json.dumps(document), encoding="utf-8")
    with pytest.raises(ReviewError, match=r"corrections\.0.*melt"):
        read_review(ship)


def test_nothing_is_written_over_a_review(ship: Ship, capsys: pytest.CaptureFixture[str]) -> None:
    path = write_review(new_review(ship), ship)
    before = path.read_bytes()
    assert main(["trace", str(ship.path), "-o", str(path)]) == 1
    assert "is what this command reads" in capsys.readouterr().err
    assert path.read_bytes() == before


def test_a_review_says_what_it_gives(ship: Ship) -> None:
    review = new_review(ship)
    assert review.account == "nothing"
    cut = Cut(id="c1", px=(1.0, 2.0))
    review = review.model_copy(update={"calibration": CalibrationGiven(baseline_px=900.0), "corrections": (cut,)})
    assert review.account == "the calibration, 1 correction"


def test_an_id_that_stands_twice_is_named(ship: Ship) -> None:
    path = write_review(new_review(ship), ship)
    document = json.loads(path.read_text(encoding="utf-8"))
    document["corrections"] = [{"kind": "cut", "id": "c1", "px": [1, 2]}, {"kind": "cut", "id": "c1", "px": [3, 4]}]
    path.write_text(json.dumps(document), encoding="utf-8")
    with pytest.raises(ReviewError, match="the id 'c1' stands twice"):
        read_review(ship)


def test_the_schema_is_written_by_its_name(ship: Ship) -> None:
    document = json.loads(write_review(new_review(ship), ship).read_text(encoding="utf-8"))
    assert document["schema"] == 1
    assert Review.model_validate(document).schema_number == 1
