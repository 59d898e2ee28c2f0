"""No ripple along the edge of a flat bottom that is a bilge on some stations and a knuckle on others."""

import numpy as np
import pytest
from fairness import waves_of

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.hull import Hull
from hullform.hull.outlines import corners_of, largest_distance

DEPTH, BREADTH, LENGTH = 9.0, 16.0, 100.0
X = np.array([0.0, 20.0, 40.0, 55.0, 70.0, 85.0, 100.0])


class Particulars:
    length_overall_m = LENGTH
    length_between_perpendiculars_m = LENGTH
    aft_perpendicular_m = 0.0
    breadth_m = BREADTH
    depth_m = DEPTH
    draught_m = 6.0


def form(x: float) -> np.ndarray:
    """A flat bottom, a bilge that is a parabola's arc and sharpens forward, a straight side that leans outwards."""
    t = max(x - 40.0, 0.0) / 60.0
    edge, radius = np.array([6.9 - 6.0 * t**2, 0.0]), 2.2 * (1.0 - t) ** 2 + 0.02
    head = np.array([8.0 - 1.5 * t**2, DEPTH])
    up = (head - edge) / np.linalg.norm(head - edge)
    s = np.linspace(0.0, 1.0, 60)[:, None]
    bilge = (1 - s) ** 2 * (edge - [radius, 0.0]) + 2 * s * (1 - s) * edge + s**2 * (edge + radius * up)
    return np.concatenate([[[0.0, 0.0]], bilge, [head]])


@pytest.fixture(scope="module")
def hull() -> Hull:
    stations = (Station(x, "aft" if x < 50 else "fore", (TracedCurve(*form(x).T),)) for x in X.tolist())  # type: ignore[arg-type]
    return Hull.from_body_plan(BodyPlan(tuple(stations), "offsets"), Particulars(), sections="traced")


def test_the_edge_is_a_knuckle_on_some_stations_only() -> None:
    assert [len(corners_of(form(x), BREADTH)) for x in X.tolist()] == [0, 0, 0, 0, 1, 1, 1]


def test_between_stations_the_hull_is_near_the_form(hull: Hull) -> None:
    # shares of what a contour does across and upward, as the match of the sections, are 0.6 % of the breadth off
    places = np.linspace(55.0, 85.0, 31)
    apart = [largest_distance(hull.section_curves(x)[0], form(x)) for x in places.tolist()]
    assert max(apart) < 0.0025 * BREADTH


def test_waterlines_have_no_waves_of_their_own(hull: Hull) -> None:
    # 13 of up to 1.0 % of the breadth with such shares
    found = waves_of(hull, X)
    assert found.count <= 2
    assert found.largest_percent < 0.5


def test_the_knuckle_is_one_line_of_points(hull: Hull) -> None:
    numbers = set()
    for x in X[4:].tolist():
        (knuckle,) = form(x)[corners_of(form(x), BREADTH)]
        (outline,) = hull.sections_at(np.array([x])).mesh_points(141)
        apart = np.linalg.norm(outline - knuckle, axis=-1)
        assert apart.min() < 1e-3 * BREADTH
        numbers.add(int(apart.argmin()))
    assert len(numbers) == 1
