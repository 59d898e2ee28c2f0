"""Fitting one traced section: what is reported, what is refused, what a trace may look like."""

import numpy as np
import pytest

from hullform.errors import HullError
from hullform.hull import SuperEllipse, fit_super_ellipse
from hullform.hull.fitting import LARGEST_EXPONENT, SMALLEST_EXPONENT, traced_area


def trace(section: SuperEllipse, top: float, count: int = 200) -> np.ndarray:
    """Points [half-breadth, height] of a section whose top lies at a height."""
    y, zeta = section.points(count).T
    return np.stack([y, top - zeta], axis=-1)


def test_a_counter_above_the_base_line_keeps_its_heights() -> None:
    section = SuperEllipse(12.7, 6.7, 2.8, 2.4)
    fit = fit_super_ellipse(trace(section, 20.4))
    assert fit.top_height_m == pytest.approx(20.4, abs=1e-12)
    assert fit.keel_height_m == pytest.approx(13.7, abs=1e-3)
    assert fit.ellipse.p == pytest.approx(2.8, rel=1e-3)
    assert abs(fit.area_error) < 1e-3
    assert fit.largest_deviation_m < 1e-3
    np.testing.assert_allclose(fit.points(5)[[0, -1]], [[0.0, fit.keel_height_m], [fit.ellipse.half_breadth, 20.4]])


def test_a_box_of_flat_bottom_and_flat_side_is_found_from_its_corners() -> None:
    corners = np.array([[0.0, 0.0], [7.0, 0.0], [10.0, 0.0], [10.0, 3.0], [10.0, 8.0]])
    fit = fit_super_ellipse(corners)
    assert min(fit.ellipse.p, fit.ellipse.q) > 20
    # The sharpest curve allowed rounds the corner by 1 - 2^(-1/40) = 1.7 % of either side.
    assert fit.largest_deviation_m < 0.02 * np.hypot(10.0, 8.0)
    assert abs(fit.area_error) < 0.005


def test_a_trace_that_begins_off_the_centreline_is_closed_flat() -> None:
    section = SuperEllipse(16.1, 19.5, 10.0, 8.0)
    points = trace(section, 19.5)
    fit = fit_super_ellipse(points[points[:, 0] > 5.0])
    assert fit.ellipse.depth == pytest.approx(19.5, rel=2e-3)
    assert fit.ellipse.area == pytest.approx(section.area, rel=2e-3)


def test_a_stray_label_does_not_bend_the_curve() -> None:
    section = SuperEllipse(16.1, 19.5, 3.0, 2.5)
    points = trace(section, 19.5)
    # A reader that slips onto a label or a waterline for two per cent of the curve, one metre off it.
    points[120:124, 0] += 1.0
    fit = fit_super_ellipse(points)
    at = fit.ellipse.half_breadth_at(np.linspace(0.0, 19.0, 50))
    # Plain least squares is drawn off by 0.17 m (measured with the loss set to linear).
    assert np.abs(at - section.half_breadth_at(np.linspace(0.0, 19.0, 50))).max() < 0.05
    # The label lies a metre aside of a side that slopes by 20 to 30 degrees.
    assert 0.8 < fit.largest_deviation_m < 1.0


def test_the_area_error_is_that_of_the_reported_section() -> None:
    # A hard chine, which no super-ellipse follows.
    chine = np.array([[0.0, 0.0], [2.0, 0.4], [4.0, 0.8], [4.4, 2.0], [4.6, 3.0]])
    fit = fit_super_ellipse(chine)
    assert traced_area(chine) == pytest.approx(2 * (0.4 + 1.2 + 4.2 * 1.2 + 4.5), rel=1e-12)
    assert fit.area_error == pytest.approx(fit.ellipse.area / traced_area(chine) - 1, abs=1e-12)
    assert fit.largest_deviation_m > 0.05


def test_exponents_stay_within_their_box() -> None:
    cross = np.concatenate([np.stack([np.full(20, 0.01), np.linspace(0, 4.9, 20)], -1), [[0.5, 5.0], [4.0, 5.0]]])
    for points in (cross, np.array([[0.0, 0.0], [5.0, 0.0], [5.0, 1.0], [5.0, 5.0]])):
        ellipse = fit_super_ellipse(points).ellipse
        assert min(ellipse.p, ellipse.q) >= SMALLEST_EXPONENT * 0.999
        assert max(ellipse.p, ellipse.q) <= LARGEST_EXPONENT * 1.001


@pytest.mark.parametrize(
    ("points", "what"),
    [
        ([[0, 0], [1, 1], [2, 2]], "four or more"),
        ([[0, 0], [1, 1], [2, np.nan], [3, 3]], "finite"),
        ([[0, 0], [0, 1], [0, 2], [0, 3]], "breadth 0"),
        ([[5, 9], [5, 4], [3, 1], [0, 0]], "from keel to deck"),
    ],
)
def test_what_is_no_section_is_refused(points: list[list[float]], what: str) -> None:
    with pytest.raises(HullError, match=what):
        fit_super_ellipse(points)
