"""Closed forms and arc integrals against adaptive quadrature, and the laws that they must keep."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from hullform.hull import SuperEllipse
from hullform.hull.arcs import arc_integrals
from hullform.hull.super_ellipse import quadrant_moment

exponents = st.floats(np.log(0.4), np.log(100.0)).map(lambda value: float(np.exp(value)))
lengths = st.floats(0.2, 30.0)
sections = st.builds(SuperEllipse, lengths, lengths, exponents, exponents)
bounded = settings(max_examples=40, deadline=None, derandomize=True)


def below(section: SuperEllipse, level: float, n: int) -> float:
    """2 Int zeta^n y dzeta by quadrature, split and substituted so that the integrand is smooth.

    With w = (zeta / b)^q the integrand is w^((n+1)/q - 1) (1 - w)^(1/p); u = w^((n+1)/q) removes the pole at w = 0, and
    1 - w = s^p does so at w = 1.
    """
    a, b, p, q = section.half_breadth, section.depth, section.p, section.q
    k = (n + 1) / q
    low, middle = (level / b) ** q, max(0.5, (level / b) ** q)
    scale = 2 * a * b ** (n + 1) / q
    options = {"epsabs": 0.0, "epsrel": 1e-12, "limit": 300}
    upper, _ = quad(lambda s: (1 - s**p) ** (k - 1) * p * s**p, 0.0, (1 - middle) ** (1 / p), **options)
    lower = 0.0
    if low < middle:
        lower, _ = quad(lambda u: (1 - u ** (1 / k)) ** (1 / p) / k, low**k, middle**k, **options)
    return float(scale * (upper + lower))


@bounded
@given(sections, st.integers(0, 2))
def test_area_moments_agree_with_quadrature(section: SuperEllipse, n: int) -> None:
    closed = {0: section.area, 1: section.area * section.centroid_below_top, 2: section.second_moment_about_top}[n]
    assert closed == pytest.approx(below(section, 0.0, n), rel=1e-10)


@bounded
@given(sections, st.floats(0.0, 0.999), st.integers(0, 1))
def test_partial_moments_agree_with_quadrature(section: SuperEllipse, share: float, n: int) -> None:
    level = share * section.depth
    closed = section.area_below(level) if n == 0 else section.first_moment_below(level)
    # Near the keel of a hollow section next to nothing is left below the level; what is lost to round-off there is
    # round-off of (zeta / b)^q, measured against the whole.
    whole = section.area * section.depth**n
    assert closed == pytest.approx(below(section, level, n), rel=1e-9, abs=1e-13 * whole)


@bounded
@given(sections)
def test_arc_integrals_agree_with_quadrature(section: SuperEllipse) -> None:
    a, b, p, q = section.half_breadth, section.depth, section.p, section.q

    def half(a: float, b: float, p: float, q: float, power: int, side: bool) -> float:
        """Int zeta^power ds over w <= 1/2 with s = -ln w; zeta is the long axis' coordinate or, on the side, y."""

        def integrand(s: float) -> float:
            w = np.exp(-s)
            u, v = np.exp(-s / p), np.exp(np.log1p(-w) / q)
            ds = np.hypot(a / p * u, b / q * v * w / (1 - w))
            return float(((a * u if side else b * v) ** power) * ds)

        end = 40.0 * max(1.0, p)
        cuts = np.unique(np.concatenate([[np.log(2.0)], np.geomspace(1.0, end, 24)]))
        parts = [quad(integrand, lo, hi, epsabs=0.0, epsrel=1e-12, limit=200)[0] for lo, hi in pairwise(cuts)]
        return float(sum(parts))

    found = arc_integrals(a, b, p, q)
    for power, value in enumerate(found):
        expected = half(a, b, p, q, power, False) + half(b, a, q, p, power, True)
        assert value == pytest.approx(expected, rel=1e-10)


@bounded
@given(sections, st.floats(0.1, 10.0))
def test_moments_scale_with_length(section: SuperEllipse, scale: float) -> None:
    larger = SuperEllipse(scale * section.half_breadth, scale * section.depth, section.p, section.q)
    assert larger.area == pytest.approx(scale**2 * section.area, rel=1e-12)
    assert larger.second_moment_horizontal == pytest.approx(scale**4 * section.second_moment_horizontal, rel=1e-9)
    assert larger.girth() == pytest.approx(scale * section.girth(), rel=1e-12)
    # A shell's second moment goes with the cube of the size at a given thickness.
    assert larger.shell_second_moment(0.01) == pytest.approx(scale**3 * section.shell_second_moment(0.01), rel=1e-10)


@bounded
@given(sections)
def test_turning_a_section_on_its_side_swaps_its_axes(section: SuperEllipse) -> None:
    turned = SuperEllipse(section.depth, section.half_breadth, section.q, section.p)
    assert turned.girth() == pytest.approx(section.girth(), rel=1e-13)
    assert turned.second_moment_vertical == pytest.approx(section.second_moment_about_top, rel=1e-12)
    for m, n in ((1, 0), (1, 1), (2, 1)):
        one = quadrant_moment(section.half_breadth, section.depth, section.p, section.q, m, n)
        other = quadrant_moment(turned.half_breadth, turned.depth, turned.p, turned.q, n, m)
        assert other == pytest.approx(float(one), rel=1e-12)


@bounded
@given(sections)
def test_a_shell_lies_between_a_cross_and_a_box(section: SuperEllipse) -> None:
    a, b = section.half_breadth, section.depth
    # Any monotone curve between the two ends is at least as long as the chord and no longer than the two sides.
    assert np.hypot(a, b) * (1 - 1e-12) <= section.girth() / 2 <= (a + b) * (1 + 1e-12)
