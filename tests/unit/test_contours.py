"""Polyline sections: what they enclose, what a level cuts off, their shell; against polygons and super-ellipses."""

import numpy as np
import pytest
from shapely import Polygon, box

from hullform.errors import HullError
from hullform.hull.contours import Contours, parted_at_the_centre_line
from hullform.hull.sections import Sections

# A tunnel on the centre line: up from 1 m, over to its roof, down to the side's foot, and up the side.
TUNNEL = [[0, 1.5], [1, 1.4], [2, 1.0], [3, 0.0], [5, 0.0], [6, 1.0], [6, 4], [6, 5]]
# A bulb of 1 to 4 m, the centre line, a flare from 6 m on.
BULB = [[0, 1], [1.5, 1.5], [2, 3], [0, 4], [0, 6], [1, 7], [4, 10], [5, 12]]
SECTIONS = np.array([TUNNEL, BULB], dtype=float)
LEVELS = [0.5, 1.2, 2.0, 3.5, 4.6, 5.0, 6.5, 11.0]


def polygons(section: np.ndarray) -> list[Polygon]:
    """Both sides of each contour of a section."""
    return [Polygon(np.concatenate([c, c[::-1] * [-1, 1]])) for c in parted_at_the_centre_line(section)]


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize("number", [0, 1])
def test_a_cut_against_polygons(number: int, level: float) -> None:
    section = SECTIONS[number]
    cut = Contours(SECTIONS).cut(level)
    under = [whole.intersection(box(-10, -10, 10, level)) for whole in polygons(section)]
    area = sum(part.area for part in under)
    assert cut.area[number] == pytest.approx(area, rel=1e-12, abs=1e-12)
    assert cut.moment_z[number] == pytest.approx(
        sum(p.area * p.centroid.y for p in under if p.area), rel=1e-12, abs=1e-12
    )
    held = min(level, section[-1, 1]) - 1e-9
    line = [whole.intersection(box(0, held - 1e-9, 10, held + 1e-9)) for whole in polygons(section)]
    assert cut.half_breadth[number] == pytest.approx(sum(part.area for part in line) / 2e-9, rel=1e-6, abs=1e-9)
    # the third power's moment: of every stretch from inner to outer, outer^3 - inner^3
    cubes = sum(part.bounds[2] ** 3 - part.bounds[0] ** 3 for part in line if part.area)
    assert cut.half_breadth_cubed[number] == pytest.approx(cubes, rel=1e-6, abs=1e-9)


def test_whole_sections_and_a_level_for_each() -> None:
    found = Contours(SECTIONS)
    whole = [sum(polygon.area for polygon in polygons(section)) for section in SECTIONS]
    np.testing.assert_allclose(found.areas_below(), whole, rtol=1e-12)
    np.testing.assert_allclose(found.areas_below(99.0), whole, rtol=1e-12)
    np.testing.assert_allclose(
        found.areas_below(np.array([1.2, 6.5])), [found.areas_below(1.2)[0], found.areas_below(6.5)[1]], rtol=1e-12
    )


def test_a_section_of_two_contours_is_parted() -> None:
    lower, upper = parted_at_the_centre_line(SECTIONS[1])
    np.testing.assert_array_equal(lower, SECTIONS[1, :4])
    np.testing.assert_array_equal(upper, SECTIONS[1, 4:])
    (single,) = parted_at_the_centre_line(SECTIONS[0])
    np.testing.assert_array_equal(single, SECTIONS[0])
    stem = np.array([[0.0, 1.0], [0.0, 4.0], [0.0, 9.0]])
    (line,) = parted_at_the_centre_line(stem)
    np.testing.assert_array_equal(line, stem)


def test_the_shell_between_two_contours_is_none() -> None:
    shell = Contours(SECTIONS).shell(0.01)
    segments = np.hypot(*np.diff(SECTIONS, axis=1).transpose(2, 0, 1))
    # the centre line from 4 to 6 m, the fourth segment of the second section, is no plate; the deck is one
    segments[1, 3] = 0.0
    np.testing.assert_allclose(shell.girth, 2 * segments.sum(axis=1) + 2 * SECTIONS[:, -1, 0], rtol=1e-12)
    np.testing.assert_allclose(shell.area, 0.01 * shell.girth, rtol=1e-12)


ELLIPSES = Sections(
    np.array([8.0, 8.0, 4.0]), np.array([9.0, 9.0, 8.0]), np.array([9.0, 9.0, 9.5]),
    np.array([8.0, 8.0, 0.9]), np.array([6.0, 6.0, 1.3]),
)  # fmt: skip


def test_many_points_of_super_ellipses_have_their_figures() -> None:
    polylines = Contours(ELLIPSES.points(1201))
    for level in (0.7, 3.0, 6.0, 9.2):
        exact, found = ELLIPSES.cut(level), polylines.cut(level)
        for name in ("area", "moment_z", "half_breadth", "half_breadth_cubed"):
            np.testing.assert_allclose(getattr(found, name), getattr(exact, name), rtol=2e-5, atol=1e-9)
    np.testing.assert_allclose(polylines.shell(0.016), ELLIPSES.shell(0.016), rtol=2e-5)


def test_a_wetted_surface_ends_at_the_waterline() -> None:
    x, one = np.array([0.0, 10.0, 20.0]), np.ones(3)
    narrowing = Sections(np.array([8.0, 7.5, 6.5]), 9 * one, 9 * one, 8 * one, 6 * one)
    # 41 points a section up to the waterline against 1201 up to the deck: shorter by less than a thousandth
    for draught in (2.0, 6.0, 8.9):
        found = Contours(narrowing.points(1201)).wetted_surface(x, draught)
        assert found == pytest.approx(narrowing.wetted_surface(x, draught), rel=1e-3)


def test_points_between_sections_do_not_overshoot() -> None:
    rng = np.random.default_rng(1)
    outline = np.sort(rng.uniform(0, 5, (6, 9, 2)), axis=1)
    x = np.array([0.0, 1.0, 4.0, 5.0, 9.0, 10.0])
    between = Contours(outline).interpolated(x, np.linspace(0, 10, 201)).outline
    low, high = (bound(outline[:-1], outline[1:]) for bound in (np.minimum, np.maximum))
    interval = np.clip(np.searchsorted(x, np.linspace(0, 10, 201)) - 1, 0, 4)
    assert (between >= low[interval] - 1e-12).all()
    assert (between <= high[interval] + 1e-12).all()


@pytest.mark.parametrize(
    ("outline", "what"),
    [
        (np.zeros((3, 1, 2)), "two or more points"),
        (np.zeros((3, 5, 3)), "two or more points"),
        (np.full((3, 5, 2), np.nan), "not finite"),
        (np.full((3, 5, 2), -1.0), "negative half-breadth"),
    ],
)
def test_what_is_no_section_is_refused(outline: np.ndarray, what: str) -> None:
    with pytest.raises(HullError, match=what):
        Contours(outline)
