"""Draw a section, blur it, thin it out, fit it: the curve comes back."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hullform.hull import SuperEllipse, fit_super_ellipse

exponents = st.floats(np.log(0.4), np.log(30.0)).map(lambda value: float(np.exp(value)))


def distance(points: np.ndarray, curve: np.ndarray) -> np.ndarray:
    """Distance of each point from a polyline."""
    start, step = curve[:-1], np.diff(curve, axis=0)
    from_start = points[:, None, :] - start
    along = np.clip((from_start * step).sum(-1) / np.maximum((step**2).sum(-1), 1e-300), 0.0, 1.0)
    return np.linalg.norm(from_start - along[..., None] * step, axis=-1).min(axis=1)


@settings(max_examples=40, deadline=None, derandomize=True)
@given(st.floats(2.0, 22.0), st.floats(4.0, 22.0), exponents, exponents, st.integers(0, 2**32 - 1))
def test_curve_is_recovered_from_an_uneven_noisy_trace(a: float, b: float, p: float, q: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    noise = 5e-4 * 2 * a  # 0.05 % of the breadth
    section = SuperEllipse(a, b, p, q)
    true = section.points(800) * [1.0, -1.0] + [0.0, b]
    kept = np.unique(np.concatenate([[0, 799], (799 * rng.uniform(size=150) ** 1.5).astype(int)]))
    traced = true[kept] + rng.normal(0.0, noise, (len(kept), 2))
    fit = fit_super_ellipse(traced)
    # The points miss by about one sigma. The curve, of five parameters (the top is one point's height) from a hundred
    # points, lies within it, but the last point's own error lifts or lowers the whole of it.
    limit = 1.5 * noise + float(np.abs(traced[-1] - true[kept[-1]]).max())
    assert fit.rms_m < noise + limit
    assert np.sqrt(np.mean(distance(fit.points(400), true) ** 2)) < limit
    assert np.sqrt(np.mean(distance(true, fit.points(800)) ** 2)) < limit


@pytest.mark.parametrize("p", [0.4, 0.7, 1.0, 2.0, 6.0, 30.0])
@pytest.mark.parametrize("q", [0.4, 0.7, 1.0, 2.0, 6.0, 30.0])
def test_parameters_are_recovered_from_a_clean_trace(p: float, q: float) -> None:
    section = SuperEllipse(16.1, 19.5, p, q)
    fit = fit_super_ellipse(section.points(800) * [1.0, -1.0] + [0.0, 19.5])
    # The fit sees a polyline through the points, whose sagitta moves the curve by some 1e-5 of its size; the exponents
    # of a sharp bilge feel it a hundredfold.
    assert fit.largest_deviation_m < 1e-3
    assert fit.ellipse.area == pytest.approx(section.area, rel=2e-4)
    assert fit.ellipse.half_breadth == pytest.approx(16.1, rel=2e-3)
    assert fit.ellipse.depth == pytest.approx(19.5, rel=2e-3)
    assert fit.ellipse.p == pytest.approx(p, rel=0.01)
    assert fit.ellipse.q == pytest.approx(q, rel=0.01)


@settings(max_examples=20, deadline=None, derandomize=True)
@given(exponents, exponents, st.floats(0.05, 20.0))
def test_fit_is_the_same_in_any_unit_of_length(p: float, q: float, scale: float) -> None:
    points = SuperEllipse(8.0, 11.0, p, q).points(120) * [1.0, -1.0] + [0.0, 11.0]
    points[:, 0] *= 1 + 0.03 * np.sin(points[:, 1])
    one, other = fit_super_ellipse(points), fit_super_ellipse(scale * points)
    # The same minimum of a cost without units, reached to the tolerance of the search.
    assert other.rms_m == pytest.approx(scale * one.rms_m, rel=1e-4)
    assert other.area_error == pytest.approx(one.area_error, abs=1e-5)
