"""Where sections meet the centre plane, and sections that are made to meet it there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.errors import BodyPlanError, HullError
from hullform.hull import Hull
from hullform.hull.crossings import crossing_triangles
from hullform.profile import Profile

LENGTH, DEPTH, HALF = 100.0, 10.0, 8.0


@dataclass(frozen=True)
class Particulars:
    length_overall_m: float = LENGTH
    length_between_perpendiculars_m: float = LENGTH
    aft_perpendicular_m: float = 0.0
    breadth_m: float = 2 * HALF
    depth_m: float = DEPTH
    draught_m: float = 6.0


def box(x: float, foot: float = 0.0) -> Station:
    """A flat bottom at a height, an upright side."""
    y = np.concatenate([np.linspace(0.0, HALF, 20), np.full(20, HALF)])
    z = np.concatenate([np.full(20, foot), np.linspace(foot, DEPTH, 20)])
    return Station(x, "aft" if x < 50 else "fore", (TracedCurve(y, z),))


def wedge(x: float, foot: float = 0.0) -> Station:
    """Straight from the keel to the deck."""
    return Station(x, "fore", (TracedCurve(np.linspace(0.0, HALF, 30), np.linspace(foot, DEPTH, 30)),))


def lofted(stations: list[Station], *points: tuple[float, float]) -> Hull:
    profile = Profile(*np.array(points).T) if points else None
    return Hull.from_body_plan(BodyPlan(tuple(stations), "offsets", profile=profile), Particulars(), sections="traced")


def test_the_centre_plane_of_a_bulb_a_transom_and_beyond() -> None:
    profile = Profile(
        np.array([0.0, 0.0, 20.0, 90.0, 95.0, 88.0, 100.0]), np.array([10.0, 6.0, 0.0, 0.0, 3.0, 5.0, 10.0])
    )
    found = np.array(profile.at(np.array([0.0, 10.0, 50.0, 92.5, 97.6, 100.0, 101.0])))
    nan = np.nan
    expected = [[6, 3, 0, 1.5, 9, 10, nan], [nan, nan, nan, 3 + 5 / 7, nan, nan, nan], [nan] * 3 + [6.875] + [nan] * 3]
    np.testing.assert_allclose(found, expected, atol=1e-6)


def test_either_side_of_an_upright_piece() -> None:
    profile = Profile(np.array([0.0, 50.0, 50.0, 100.0]), np.array([5.0, 5.0, 0.0, 0.0]))
    x = np.array([50.0])
    assert [float(profile.at(x, side).foot[0]) for side in (-1.0, 1.0)] == [5.0, 0.0]


@pytest.mark.parametrize(
    ("x", "z", "told"),
    [([0.0], [1.0], "two or more points"), ([0.0, 1.0], [0.0, np.nan], "not a finite"), ([1.0, 1.0], [0, 5], "length")],
)
def test_a_profile_that_cannot_be_is_refused(x: list[float], z: list[float], told: str) -> None:
    with pytest.raises(BodyPlanError, match=told):
        Profile(np.array(x), np.array(z))


def test_a_keel_between_two_stations_is_met_and_the_side_stays() -> None:
    stations = [wedge(x) for x in (0.0, 40.0, 60.0, 100.0)]
    # a keel that goes 1 m down and 1 m up between two stations
    points = (0.0, 10.0), (0.0, 0.0), (40.0, 0.0), (45.0, -1.0), (55.0, 1.0), (60.0, 0.0), (100.0, 0.0), (100.0, 10.0)
    hull = lofted(stations, *points)
    keel = hull.sections_at(np.array([20.0, 40.0, 45.0, 50.0, 55.0, 60.0, 80.0])).keel
    # cubics between lofted sections leave the straight line by a per mille of the breadth
    np.testing.assert_allclose(keel, [0, 0, -1, 0, 1, 0, 0], atol=0.02)
    for x in (45.0, 55.0):
        y, z = hull.section_curves(x)[0].T
        assert (np.diff(z) > -1e-9).all()
        # at half the depth, twice the shift above, nothing has moved
        assert np.interp(5.0, z, y) == pytest.approx(HALF / 2, abs=1e-6)
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert len(crossing_triangles(np.asarray(mesh.vertices), np.asarray(mesh.faces))) == 0


def test_a_station_that_is_a_little_off_is_passed_without_a_step() -> None:
    stations = [wedge(x, 0.1 if x == 40.0 else 0.0) for x in (0.0, 40.0, 60.0, 100.0)]
    hull = lofted(stations, (0.0, 10.0), (0.0, 0.0), (100.0, 0.0), (100.0, 10.0))
    keel = hull.sections_at(np.array([39.9, 40.0, 40.1, 50.0, 60.0])).keel
    np.testing.assert_allclose(keel, [0.1, 0.1, 0.1, 0.05, 0.0], atol=3e-3)
    assert hull.doubts == ()


def test_waterlines_close_on_the_stem_and_end_where_it_ends() -> None:
    stations = [wedge(x) for x in (0.0, 30.0, 60.0)] + [
        Station(80.0, "fore", (TracedCurve(np.linspace(0.0, 5.0, 30), np.linspace(0.0, DEPTH, 30)),))
    ]
    # a stem that rakes from 90 m at the keel to 99.6 m at the deck
    hull = lofted(stations, (0.0, 10.0), (0.0, 0.0), (90.0, 0.0), (99.6, 10.0))
    x = np.array([85.0, 90.0, 94.8, 98.4])
    np.testing.assert_allclose(hull.sections_at(x).keel, [0.0, 0.0, 5.0, 8.75], atol=0.02)
    breadths = hull.sections_at(np.array([80.0, 85.0, 90.0, 99.5, 100.0])).half_breadth
    assert (np.diff(breadths) <= 1e-9).all()
    assert breadths[-2] < 0.6
    assert breadths[-1] == 0.0
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert mesh.bounds[1, 0] == pytest.approx(99.6, abs=0.2)
    assert mesh.volume == pytest.approx(hull.volume_m3, rel=1e-3)


def test_a_stem_that_leans_aft_ends_the_sections_below_the_deck() -> None:
    stations = [wedge(x) for x in (0.0, 30.0, 60.0, 80.0)]
    hull = lofted(stations, (0.0, 10.0), (0.0, 0.0), (100.0, 0.0), (90.0, 10.0))
    assert hull.sections_at(np.array([95.0])).top.item() == pytest.approx(5.0, abs=0.1)
    assert hull.mesh().is_watertight


def test_a_raked_transom_keeps_its_breadth() -> None:
    stations = [box(x) for x in (20.0, 40.0, 60.0, 100.0)]
    hull = lofted(stations, (0.0, 10.0), (10.0, 0.0), (100.0, 0.0), (100.0, 10.0))
    aft = hull.sections_at(np.array([2.0, 5.0, 15.0]))
    np.testing.assert_allclose(aft.keel, [8.0, 5.0, 0.0], atol=0.05)
    np.testing.assert_allclose(aft.half_breadth, HALF, rtol=1e-6)
    # of the box, half of its last ten metres is cut off
    assert hull.volume_m3 == pytest.approx(2 * HALF * DEPTH * (LENGTH - 5.0), rel=2e-3)
    assert hull.mesh().is_watertight


def bulbous(x: float) -> Station:
    """A bulb from 1 to 3 m, and the bow from 5 m."""
    turn = np.linspace(-np.pi / 2, np.pi / 2, 20)
    low, high = np.cos(turn), 2 + np.sin(turn)
    return Station(x, "fore", (TracedCurve(low, high), TracedCurve(np.linspace(0, 3, 20), np.linspace(5, DEPTH, 20))))


@pytest.mark.parametrize(
    ("points", "told"),
    [
        ([(0.0, 10.0), (0.0, 0.0), (96.0, 0.0), (96.0, 10.0)], "from x = 0 to 96 m, the ship from 0 to 100 m"),
        (
            [(0.0, 0.0), (100.0, 0.0), (100.0, 10.0)],
            "ends at z = 0 m at the stern, and the deck of station 0 lies at 10",
        ),
        ([(0.0, 10.0), (0.0, 0.0), (90.0, 0.0), (100.0, 5.0)], "ends at z = 5 m at the stem"),
        ([(0.0, 10.0), (0.0, 0.0), (90.0, 0.0), (100.0, 14.0)], "ends at z = 14 m at the stem"),
    ],
)
def test_a_profile_that_is_not_whole_is_refused(points: list[tuple[float, float]], told: str) -> None:
    with pytest.raises(HullError, match=told):
        lofted([wedge(x) for x in (0.0, 30.0, 60.0, 90.0)], *points)


@pytest.mark.parametrize(
    ("bow", "told"),
    [
        ([(90.0, 0.0), (100.0, 10.0)], "has a contour below the hull, a bulb or a gondola"),
        ([(90.0, 0.0), (100.0, 2.0), (90.0, 4.5), (92.0, 5.0), (98.0, 10.0)], "bulb beyond the stem, to x = 100 m"),
    ],
)
def test_a_bulb_that_the_profile_does_not_have_or_ends_with_is_refused(
    bow: list[tuple[float, float]], told: str
) -> None:
    with pytest.raises(HullError, match=told):
        lofted([*(wedge(x) for x in (0.0, 30.0, 60.0)), bulbous(93.0)], (0.0, 10.0), (0.0, 0.0), *bow)


def test_a_hull_ends_with_a_profile_that_ends_at_her_outermost_stations() -> None:
    stations = [box(x) for x in (0.4, 40.0, 60.0, 99.6)]
    hull = lofted(stations, (0.4, 10.0), (0.4, 0.0), (99.6, 0.0), (99.6, 10.0))
    # but for the wedge to the next of the lofted places, which is the end of the ship or nearer
    box_m3 = 2 * HALF * DEPTH * 99.2
    assert box_m3 - 1e-6 <= hull.volume_m3 <= box_m3 * 100.0 / 99.6
    assert hull.sections_at(np.array([0.0, 100.0])).half_breadth.tolist() == [0.0, 0.0]


def test_a_profile_of_upright_ends_and_a_keel_is_enough() -> None:
    stations = [wedge(x) for x in (0.0, 30.0, 60.0, 100.0)]
    hull = lofted(stations, (0.0, 10.0), (0.0, 0.0), (100.0, 0.0), (100.0, 10.0))
    assert hull.volume_m3 == pytest.approx(HALF * DEPTH * LENGTH, rel=1e-6)
