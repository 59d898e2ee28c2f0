"""Single values of the super-ellipse that need no quadrature to check."""

import numpy as np
import pytest

from hullform.errors import HullError
from hullform.hull import SuperEllipse, shell_section
from hullform.hull.arcs import arc_integrals, curve_points
from hullform.hull.super_ellipse import moment_below


def test_half_ellipse_has_the_area_and_moments_of_the_textbook() -> None:
    section = SuperEllipse(16.1, 13.2, 2.0, 2.0)
    a, b = 16.1, 13.2
    assert section.area == pytest.approx(np.pi * a * b / 2, rel=1e-13)
    assert section.centroid_below_top == pytest.approx(4 * b / (3 * np.pi), rel=1e-13)
    assert section.centroid_from_centreline == pytest.approx(4 * a / (3 * np.pi), rel=1e-13)
    assert section.second_moment_about_top == pytest.approx(np.pi * a * b**3 / 8, rel=1e-13)
    assert section.second_moment_vertical == pytest.approx(np.pi * a**3 * b / 8, rel=1e-13)
    assert section.second_moment_horizontal == pytest.approx(a * b**3 * (np.pi / 8 - 8 / (9 * np.pi)), rel=1e-12)


def test_triangle_has_straight_sides() -> None:
    section = SuperEllipse(3.0, 4.0, 1.0, 1.0)
    assert section.area == pytest.approx(12.0, rel=1e-13)
    assert section.girth() == pytest.approx(10.0, rel=1e-12)
    assert section.girth(deck=True) == pytest.approx(16.0, rel=1e-12)
    assert section.half_breadth_at(1.0) == pytest.approx(2.25, rel=1e-14)
    # Below 1 m of 4 the triangle is 3/4 as large either way.
    assert section.area_below(1.0) == pytest.approx(12.0 * 0.75**2, rel=1e-12)
    assert section.first_moment_below(1.0) == pytest.approx(12.0 * 0.75**2 * 2.0, rel=1e-12)


def test_a_level_above_the_top_or_below_the_keel_is_held_there() -> None:
    section = SuperEllipse(3.0, 4.0, 2.5, 0.7)
    assert section.area_below(-1.0) == pytest.approx(section.area, rel=1e-12)
    assert section.area_below(5.0) == 0.0
    np.testing.assert_allclose(section.half_breadth_at([-1.0, 0.0, 4.0, 5.0]), [3.0, 3.0, 0.0, 0.0])


def test_sections_without_breadth_or_depth_are_plates() -> None:
    plate = arc_integrals([0.0, 3.0, 0.0], [4.0, 0.0, 0.0], 1.7, 0.6)
    np.testing.assert_allclose(plate.girth, [4.0, 3.0, 0.0], rtol=1e-12)
    np.testing.assert_allclose(plate.first_moment, [8.0, 0.0, 0.0], rtol=1e-12)
    np.testing.assert_allclose(plate.second_moment, [64.0 / 3.0, 0.0, 0.0], rtol=1e-12)
    nothing = shell_section(0.0, 0.0, 2.0, 2.0, 0.016)
    assert (nothing.area, nothing.second_moment) == (0.0, 0.0)
    assert moment_below(0.0, 4.0, 2.0, 2.0, 1.0) == 0.0
    assert moment_below(3.0, 0.0, 2.0, 2.0, 0.0) == 0.0


@pytest.mark.parametrize(
    ("p", "q"), [(2.0, 2.0), (30.0, 30.0), (0.3, 0.3), (0.3, 30.0), (40.0, 0.5), (1.0, 2.0), (0.999, 1.001)]
)
@pytest.mark.parametrize("level", [0.0, 7.3])
def test_points_lie_on_the_curve_in_order_and_evenly(p: float, q: float, level: float) -> None:
    a, b, count = 16.1, 19.5, 65
    (y,), (zeta,) = curve_points(a, b, p, q, count, level)
    top = float(SuperEllipse(a, b, p, q).half_breadth_at(level))
    assert (y[0], zeta[0]) == (0.0, b)
    assert (y[-1], zeta[-1]) == (pytest.approx(top, rel=1e-12), level)
    assert (np.diff(y) >= 0).all()
    assert (np.diff(zeta) <= 0).all()
    np.testing.assert_allclose((y / a) ** p + (zeta / b) ** q, 1.0, atol=1e-12)
    # Spacing follows arc with a share for the turning: no step longer than twice the mean one of girth a + b at most,
    # and none vanishes.
    step = np.hypot(np.diff(y), np.diff(zeta))
    assert step.max() < 2 * (a + b) / (count - 1)
    assert step.min() > 0


def test_kernels_take_leading_dimensions() -> None:
    rng = np.random.default_rng(3)
    a, b, p, q = rng.uniform(0.5, 5.0, (4, 2, 3, 4))
    shell = shell_section(a, b, p, q, 0.01)
    for index in np.ndindex(2, 3, 4):
        one = SuperEllipse(*(float(v[index]) for v in (a, b, p, q))).shell(0.01)
        np.testing.assert_allclose([field[index] for field in shell], one, rtol=1e-12)


@pytest.mark.parametrize("values", [(-1.0, 1, 1, 1), (1, -1.0, 1, 1), (1, 1, 0.0, 1), (1, 1, 1, float("nan"))])
def test_impossible_sections_are_refused_by_name(values: tuple[float, float, float, float]) -> None:
    name = ("half_breadth", "depth", "p", "q")[next(i for i, v in enumerate(values) if not v > 0)]
    with pytest.raises(HullError, match=f"{name} = "):
        SuperEllipse(*values)
