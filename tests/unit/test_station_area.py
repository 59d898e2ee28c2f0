"""The area of a traced section: closed forms, with curves that turn back and with two contours."""

from __future__ import annotations

import numpy as np
import pytest

from hullform.body_plan import Station, TracedCurve

TURN = np.linspace(-np.pi / 2, np.pi / 2, 2001)
# a bulb: a half circle on the centre line
BULB = TracedCurve(np.cos(TURN), 2.0 + np.sin(TURN))


def station(*curves: TracedCurve) -> Station:
    return Station(10.0, "fore", curves)


def test_of_a_triangle_and_of_its_lower_part() -> None:
    # y = z to 4 m: both sides together z^2
    triangle = station(TracedCurve(np.array([0.0, 4.0]), np.array([0.0, 4.0])))
    assert triangle.area_below(10.0) == pytest.approx(16.0)
    assert triangle.area_below(3.0) == pytest.approx(9.0)
    assert triangle.area_below(-1.0) == 0.0


def test_of_a_curve_that_turns_back_is_what_it_encloses() -> None:
    # a polygon of 2000 sides is too small by 1e-6 of the circle; below the bulb's centre lies half of it
    assert station(BULB).area_below(5.0) == pytest.approx(np.pi, rel=1e-5)
    assert station(BULB).area_below(2.0) == pytest.approx(np.pi / 2, rel=1e-5)


def test_a_second_contour_counts() -> None:
    # above the bulb a flare y = z - 4 from 4 to 7 m: both sides together 9 m2
    flare = TracedCurve(np.array([0.0, 3.0]), np.array([4.0, 7.0]))
    assert station(flare, BULB).area_below(7.0) == pytest.approx(np.pi + 9.0, rel=1e-5)
