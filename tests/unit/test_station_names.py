"""Names of stations: how they are compared, what ship.toml accepts, how messages and a review take them."""

from __future__ import annotations

from pathlib import Path

import pytest

from hullform.errors import ShipFileError
from hullform.review_file import ReviewedStations, new_review
from hullform.ship import Ship, read_ship
from hullform.station_names import StationNames, number_of, same_name

BODYPLANS = Path(__file__).parents[2] / "bodyplans"
AFT = '"½", "1", "2", "3", "4", "5", "6", "7", "8", "9"'


def ship_with(folder: Path, line: str) -> Ship:
    text = (BODYPLANS / "wigley" / "ship.toml").read_text(encoding="utf-8")
    path = folder / "ship.toml"
    path.write_text(text.replace("aft_stations_m", f"{line}\naft_stations_m", 1), encoding="utf-8")
    (folder / "bodyplan.png").write_bytes((BODYPLANS / "wigley" / "bodyplan.png").read_bytes())
    return read_ship(path)


@pytest.mark.parametrize(
    ("one", "other"),
    [("1/2", "½"), ("0.5", ",50"), ("9 3/4", "9¾"), ("9-3/4", "9.75"), ("A.P.", "ap"), ("X", "x"), ("-1", "-1.0")],
)
def test_spellings_of_one_name(one: str, other: str) -> None:
    assert same_name(one) == same_name(other)


@pytest.mark.parametrize(
    ("one", "other"), [("1", "11"), ("1 1/2", "11/2"), ("FP", "F"), ("19/18", "19 18"), ("0", "O")]
)
def test_different_names(one: str, other: str) -> None:
    assert same_name(one) != same_name(other)


@pytest.mark.parametrize("word", ["AP", "13 14 15", "nan", "1/0", "1e5", "19/18", ""])
def test_words_that_are_no_station_number(word: str) -> None:
    assert number_of(word) is None


def test_names_reach_the_ship(tmp_path: Path) -> None:
    names = ship_with(tmp_path, f"aft_station_names = [{AFT}]").body_plan.names_of("aft")
    assert names.of(2.5) == "½"
    assert names.one(20.0) == "station 4 (20 m, aft half)"
    assert names.several((40.0, 45.0)) == "8, 9 (40, 45 m)"


def test_without_names_stations_are_called_by_their_x() -> None:
    names = StationNames("fore", (50.0, 60.0))
    assert names.of(50.0) == ""
    assert names.one(50.0) == "station 50 m (fore half)"
    assert names.several((50.0, 60.0)) == "50, 60 m"


@pytest.mark.parametrize(
    ("line", "told"),
    [
        (f"aft_station_names = [{AFT}, '9½']", "aft_station_names has 11 names, but aft_stations_m has 10 stations"),
        (f"aft_station_names = [{AFT.replace('9', '0.50')}]", "has '½' and '0.50', which are one name"),
        (f"aft_station_names = [{AFT.replace('7', ' 7')}]", "body_plan.aft_station_names.7 = ' 7'"),
        ("aft_station_names = [0, 1]", '0 is a number; put the names in quotation marks: "0"'),
        ("station_names = ['1']", "body_plan.station_names: each half has names of its own: give aft_station_names"),
    ],
)
def test_names_that_are_refused(line: str, told: str, tmp_path: Path) -> None:
    with pytest.raises(ShipFileError) as caught:
        ship_with(tmp_path, line)
    assert told in str(caught.value)


def test_a_review_that_changes_the_stations_keeps_the_names_of_those_that_stay(tmp_path: Path) -> None:
    ship = ship_with(tmp_path, f"aft_station_names = [{AFT}]")
    stations = ReviewedStations(aft_side="left", aft_stations_m=(2.5, 7.5, 10.0), fore_stations_m=(50.0, 60.0))
    review = new_review(ship).model_copy(update={"stations": stations})
    assert review.applied_to(ship).body_plan.aft_station_names == ("½", "7.5 m", "2")
    assert review.applied_to(ship).body_plan.fore_station_names == ()
    own = stations.model_copy(update={"aft_station_names": ("a", "b", "c")})
    assert review.model_copy(update={"stations": own}).applied_to(ship).body_plan.aft_station_names == ("a", "b", "c")
