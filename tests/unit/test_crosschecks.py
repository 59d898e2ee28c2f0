"""What the stations together say of their names: nothing of right ones, the place and the number of wrong ones.

The sections are those of the drawn ships, exact, so that the names alone decide.
"""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest
from draw_bodyplans import outline

from hullform.body_plan import Half, Station, TracedCurve
from hullform.picture.checking.crosschecks import crosscheck
from hullform.ship import Ship, Water, read_ship

BODYPLANS = Path(__file__).parents[2] / "bodyplans"
CONTAINER, TANKER, WIGLEY = "scim-containership", "ds-tanker", "wigley"
SAME_CURVE = 1e-3  # of B: the parallel body is drawn once


def ship(name: str) -> Ship:
    return read_ship(BODYPLANS / name / "ship.toml")


def drawn(name: str, half: Half) -> tuple[list[float], list[TracedCurve]]:
    """The names and the distinct curves of a half, from the centre line outwards."""
    source = ship(name).body_plan
    names = list(source.aft_stations_m) if half == "aft" else list(source.fore_stations_m)[::-1]
    curves: list[TracedCurve] = []
    for x in names:
        y, z = outline(name).section(x).T
        if not curves or abs(curves[-1].half_breadth_m - y).max() > SAME_CURVE * outline(name).particulars.breadth_m:
            curves.append(TracedCurve(y, z))
    return names, curves


def named(names: list[float], curves: list[TracedCurve], half: Half) -> list[Station]:
    """Stations by counting, the rest of the names on the outermost curve."""
    return [Station(x, half, (curves[min(k, len(curves) - 1)],)) for k, x in enumerate(names)]


def doubts(name: str, aft: list[Station], fore: list[Station]) -> str:
    return "\n".join(crosscheck([*aft, *fore], ship(name).particulars, Water()))


@pytest.mark.parametrize("name", [CONTAINER, TANKER, WIGLEY])
def test_right_names_are_not_doubted(name: str) -> None:
    assert doubts(name, named(*drawn(name, "aft"), "aft"), named(*drawn(name, "fore"), "fore")) == ""


@pytest.mark.parametrize(
    ("name", "half", "left_out"),
    [(CONTAINER, "fore", 193.0), (CONTAINER, "fore", 230.2), (TANKER, "aft", 15.0), (TANKER, "fore", 233.05)],
)
def test_a_station_left_out_that_the_parallel_body_absorbs(name: str, half: Half, left_out: float) -> None:
    names, curves = drawn(name, half)
    other: Half = "fore" if half == "aft" else "aft"
    found = doubts(name, named([x for x in names if x != left_out], curves, half), named(*drawn(name, other), other))
    where = re.search(r"if one more station lay between (\S+) and (\S+) m \((\w+) half\)", found)
    assert where
    assert float(where[1]) < left_out < float(where[2])
    assert where[3] == half


def test_a_station_too_many() -> None:
    names, curves = drawn(CONTAINER, "aft")
    at = names.index(56.6) + 1
    found = doubts(
        CONTAINER, named([*names[:at], 62.8, *names[at:]], curves, "aft"), named(*drawn(CONTAINER, "fore"), "fore")
    )
    assert "if station 62.8 m (aft half) had no curve of its own: check aft_stations_m" in found


@pytest.mark.parametrize("name", [TANKER, WIGLEY])
def test_halves_swapped_where_the_stations_lie_unlike(name: str) -> None:
    (aft, aft_curves), (fore, fore_curves) = drawn(name, "aft"), drawn(name, "fore")
    found = doubts(name, named(aft, fore_curves, "aft"), named(fore, aft_curves, "fore"))
    assert "with the halves swapped: check aft_side" in found


@pytest.mark.parametrize(
    ("key", "other"), [("displacement_t", "block_coefficient"), ("block_coefficient", "displacement_t")]
)
@pytest.mark.parametrize("stretch", [1.0, 1.2])
def test_displacement_and_block_coefficient(key: str, other: str, stretch: float) -> None:
    # heights a fifth too large: a grid of 2 m taken for one of 2.4 m
    halves: tuple[Half, Half] = ("aft", "fore")
    stations = [
        replace(s, curves=(TracedCurve(s.curves[0].half_breadth_m, stretch * s.curves[0].height_m),))
        for half in halves
        for s in named(*drawn(CONTAINER, half), half)
    ]
    given = ship(CONTAINER).particulars.model_copy(update={other: None})
    found = "\n".join(crosscheck(stations, given, Water()))
    assert (f"{key} = " in found) == (stretch != 1.0)
    assert other not in found


def test_a_deck_that_is_wider_forward_asks_for_aft_side() -> None:
    name = CONTAINER
    right = [*named(*drawn(name, "aft"), "aft"), *named(*drawn(name, "fore"), "fore")]
    main = ship(name).particulars
    there = {"aft": "fore", "fore": "aft"}
    mirrored = [
        replace(station, x_m=main.length_overall_m - station.x_m, half=there[station.half]) for station in right
    ]
    assert "aft_side: over her fore quarter the deck has" in "\n".join(crosscheck(mirrored, main, Water()))
    assert "aft_side" not in "\n".join(crosscheck(right, main, Water()))
