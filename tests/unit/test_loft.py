"""From drawn stations to a hull: what is interpolated, averaged, extrapolated, refused."""

from dataclasses import dataclass

import numpy as np
import pytest

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.errors import HullError
from hullform.hull import Hull, SuperEllipse
from hullform.hull.drawn import station_places


@dataclass(frozen=True)
class Particulars:
    length_overall_m: float = 100.0
    length_between_perpendiculars_m: float = 96.0
    aft_perpendicular_m: float = 2.0
    breadth_m: float = 16.0
    depth_m: float = 9.0
    draught_m: float = 6.0


def station(x: float, section: SuperEllipse, top: float = 9.0, half: str = "aft", name: str = "") -> Station:
    y, zeta = section.points(120).T
    return Station(x, half, (TracedCurve(y, top - zeta),), name)  # type: ignore[arg-type]


def stem(x: float, low: float = 0.0, top: float = 9.0, half: str = "fore") -> Station:
    return Station(x, half, (TracedCurve(np.array([0.0, 0.0]), np.array([low, top])),))  # type: ignore[arg-type]


MIDSHIP = SuperEllipse(8.0, 9.0, 8.0, 6.0)
FINE = SuperEllipse(4.0, 9.0, 0.8, 1.2)


def plan(*stations: Station) -> BodyPlan:
    return BodyPlan(stations, "offsets")


def ship() -> BodyPlan:
    return plan(
        station(0.0, SuperEllipse(6.0, 4.0, 3.0, 2.0), top=10.0),
        station(10.0, FINE),
        station(30.0, MIDSHIP),
        station(70.0, MIDSHIP, half="fore"),
        station(90.0, FINE, half="fore"),
        stem(100.0),
    )


def test_a_hundred_sections_span_the_length_overall_and_crowd_at_the_ends() -> None:
    x = station_places(262.0, 100)
    assert (x[0], x[-1], len(x)) == (0.0, 262.0, 100)
    np.testing.assert_allclose(x + x[::-1], 262.0, rtol=1e-13)
    step = np.diff(x)
    assert step.min() == pytest.approx(step[0], rel=1e-9)
    assert 3.5 < step.max() / step[0] < 5.0


def test_drawn_sections_come_back_and_nothing_overshoots() -> None:
    hull = Hull.from_body_plan(ship(), Particulars())
    assert len(hull.x_m) == 100
    assert hull.extrapolated == ()
    assert hull.doubts == ()
    assert [fit.x_m for fit in hull.fits] == [0.0, 10.0, 30.0, 70.0, 90.0, 100.0]
    body = (hull.x_m > 31.0) & (hull.x_m < 69.0)
    np.testing.assert_allclose(hull.half_breadth_m[body], 8.0, rtol=1e-3)
    np.testing.assert_allclose(hull.sections.p[body], 8.0, rtol=0.02)
    np.testing.assert_allclose(hull.depth_m[body], 9.0, rtol=1e-3)
    fine = hull.sections_at(10.0)
    # The hundred sections do not include x = 10 m: the cubic between them is off by the square of their 0.9 m spacing.
    np.testing.assert_allclose([fine.half_breadth, fine.p, fine.q], [4.0, 0.8, 1.2], rtol=0.01)
    assert hull.half_breadth_m.max() < 8.0 * 1.001
    assert hull.keel_height_m.min() > -0.01
    assert hull.sections.p.min() > 0.79
    assert hull.sections.p.max() < 8.2


def test_a_station_without_breadth_keeps_its_heights_and_its_neighbours_exponents() -> None:
    hull = Hull.from_body_plan(ship(), Particulars())
    assert hull.fits[-1].fit is None
    assert hull.half_breadth_m[-1] == pytest.approx(0.0, abs=1e-12)
    assert hull.depth_m[-1] == pytest.approx(9.0)
    ahead = hull.x_m > 90.0
    np.testing.assert_allclose(hull.sections.p[ahead], hull.sections.p[ahead][-1], rtol=1e-6)


def test_stations_that_share_a_curve_are_fitted_alike() -> None:
    hull = Hull.from_body_plan(ship(), Particulars())
    assert hull.fits[2].fit is hull.fits[3].fit


def test_two_halves_are_averaged_and_their_difference_is_a_doubt() -> None:
    wide, narrow = SuperEllipse(8.1, 9.0, 8.0, 6.0), SuperEllipse(7.7, 9.0, 8.0, 6.0)
    ends = (stem(0.0, half="aft"), stem(100.0))
    hull = Hull.from_body_plan(
        plan(*ends, station(50.0, wide, name="5"), station(50.0, narrow, half="fore", name="5")), Particulars()
    )
    assert hull.sections_at(50.0).half_breadth == pytest.approx(7.9, rel=2e-3)
    assert "station 5 (x = 50 m)" in hull.doubts[0]
    assert "half-breadth differs by 0.40 m" in hull.doubts[0]
    # and half the length lies between the ends and it
    assert ["between x = 0 and 50 m, 50% of the length" in doubt for doubt in hull.doubts] == [False, True, False]
    agreeing = Hull.from_body_plan(plan(*ends, station(50.0, wide), station(50.0, wide, half="fore")), Particulars())
    assert agreeing.doubts == ()


def test_ends_are_extrapolated_by_the_parabola_of_the_last_three() -> None:
    x = np.arange(10.0, 91.0, 10.0)
    breadth = 8.0 * (1 - (x / 50.0 - 1.0) ** 2)
    drawn = plan(*(station(float(s), SuperEllipse(float(a), 9.0, 1.0, 2.0)) for s, a in zip(x, breadth, strict=True)))
    hull = Hull.from_body_plan(drawn, Particulars())
    assert [(span.from_m, span.to_m) for span in hull.extrapolated] == [(0.0, 10.0), (90.0, 100.0)]
    assert len(hull.doubts) == 2
    assert "between x = 0.00 and 10.00 m" in hull.doubts[0]
    outside = (hull.x_m < 10.0) | (hull.x_m > 90.0)
    expected = 8.0 * (1 - (hull.x_m / 50.0 - 1.0) ** 2)
    # Half-breadths are fitted to about 1e-4 of themselves; the parabola through three magnifies that a few times.
    np.testing.assert_allclose(hull.half_breadth_m[outside], expected[outside], atol=0.02)
    assert hull.half_breadth_m[0] == pytest.approx(0.0, abs=0.02)


def test_extrapolated_breadths_never_grow_and_heights_stay_near() -> None:
    grows = (SuperEllipse(3.0, 9.0, 2, 2), SuperEllipse(5.0, 9.0, 2, 2), SuperEllipse(8.0, 9.0, 2, 2))
    drawn = plan(*(station(x, s) for x, s in zip((20.0, 40.0, 80.0), grows, strict=True)))
    hull = Hull.from_body_plan(drawn, Particulars())
    assert hull.half_breadth_m[-1] <= 8.0 * 1.001
    assert hull.half_breadth_m[0] >= 0.0
    np.testing.assert_allclose(hull.top_height_m, 9.0, atol=1e-6)


def test_arrays_are_read_only() -> None:
    hull = Hull.from_body_plan(ship(), Particulars())
    with pytest.raises(ValueError, match="read-only"):
        hull.sections.p[0] = 1.0


def test_a_station_outside_the_ship_is_named() -> None:
    with pytest.raises(
        HullError, match=r"station 21 \(aft half\) is at x = 101 m, outside the length overall 0..100 m"
    ):
        Hull.from_body_plan(
            plan(station(0.0, FINE), station(50.0, MIDSHIP), station(101.0, FINE, name="21")), Particulars()
        )


def test_a_station_that_cannot_be_fitted_is_named() -> None:
    upside_down = Station(10.0, "aft", (TracedCurve(np.array([4.0, 4.0, 2, 0]), np.array([9.0, 5, 2, 0])),), "1")
    with pytest.raises(HullError, match=r"station 1 \(aft half, x = 10 m\).*from keel to deck"):
        Hull.from_body_plan(plan(stem(0.0), upside_down, station(50.0, MIDSHIP)), Particulars())


def test_a_plan_of_lines_only_has_no_shape() -> None:
    with pytest.raises(HullError, match="one of them with a shape"):
        Hull.from_body_plan(plan(stem(0.0), stem(50.0), stem(100.0)), Particulars())


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"x_m": [0.0, 2.0, 1.0]}, "1 follows 2"),
        ({"p": [1.0, 0.0, 1.0]}, "exponent p is 0 at x = 50 m"),
        ({"q": [1.0, np.nan, 1.0]}, "q holds a number that is not finite"),
        ({"half_breadth_m": [1.0, -2.0, 1.0]}, "half_breadth_m is -2 m at x = 50 m"),
        ({"depth_m": [1.0, 2.0]}, "depth_m has shape"),
        ({"half_breadth_m": [0.0, 0.0, 0.0]}, "no section has breadth"),
    ],
)
def test_impossible_hulls_are_refused(change: dict[str, list[float]], what: str) -> None:
    values = {
        "x_m": [0.0, 50.0, 100.0],
        "half_breadth_m": [1.0, 2.0, 1.0],
        "depth_m": [3.0, 3.0, 3.0],
        "top_height_m": [3.0, 3.0, 3.0],
        "p": [1.0, 1.0, 1.0],
        "q": [1.0, 1.0, 1.0],
    } | change
    with pytest.raises(HullError, match=what):
        Hull.of_super_ellipses(**{k: np.array(v) for k, v in values.items()}, **PARTICULARS)


PARTICULARS = {
    "length_overall_m": 100.0,
    "length_between_perpendiculars_m": 100.0,
    "aft_perpendicular_m": 0.0,
    "breadth_m": 4.0,
    "depth_moulded_m": 3.0,
    "draught_m": 2.0,
}


def test_places_outside_the_hull_are_refused() -> None:
    with pytest.raises(HullError, match=r"x = 101 m is outside the hull, 0..100 m"):
        Hull.from_body_plan(ship(), Particulars()).sections_at([3.0, 101.0])
