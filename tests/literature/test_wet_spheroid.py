"""Added mass and wet frequencies of half-submerged prolate spheroids against the exact series and the printed tables.

Tables: F. M. Lewis (1929) and J. L. Taylor (1930) as E. C. Tupper, Introduction to Naval Architecture, table 11.2, has
them, for 2 and 3 nodes; k_2 of H. Lamb, Hydrodynamics, art. 114. Ellipsoids of three axes: Lamb, art. 114 too.
"""

import numpy as np
import pytest
from floating_bodies import (
    SpheroidFlow,
    UniformMotions,
    spheroid_panels,
    spheroid_sections,
    uniform_girder,
)
from scipy.integrate import quad
from scipy.special import ellipe

from hullvib import wet
from hullvib.errors import ArgumentError
from hullvib.wet import bending_factors, sliding_factors, spheroid_added_mass

LEWIS = {
    5: (0.700, 0.621),
    6: (0.752, 0.675),
    7: (0.787, 0.720),
    8: (0.818, 0.758),
    9: (0.840, 0.787),
    10: (0.858, 0.811),
    12: (0.887, 0.845),
    15: (0.919, 0.883),
}
TAYLOR = {6: (0.674, 0.564), 7: (0.724, 0.633), 8: (0.764, 0.682), 9: (0.797, 0.723), 10: (0.825, 0.760)}
MODES = 5


@pytest.mark.parametrize("slenderness", LEWIS)
def test_sliding_spheroid_has_lewis_factors(slenderness):
    two, three = sliding_factors(slenderness, 4)[2:]
    printed_two, printed_three = LEWIS[slenderness]
    # printed to three digits, from graphs
    assert two == pytest.approx(printed_two, abs=0.005)
    assert three == pytest.approx(printed_three, abs=0.005)


@pytest.mark.parametrize("slenderness", TAYLOR)
def test_turning_spheroid_has_taylors_factors(slenderness):
    two, three = bending_factors(slenderness, 4)[2:]
    printed_two, printed_three = TAYLOR[slenderness]
    assert two == pytest.approx(printed_two, abs=0.005)
    # his three-node figures lie up to 0.015 below the series
    assert three == pytest.approx(printed_three, abs=0.015)


def test_heave_is_lambs():
    assert sliding_factors(10, 1)[0] == pytest.approx(0.960, abs=5e-4)


def test_factors_rise_to_one_for_slender_bodies_and_fall_with_the_nodes():
    factors = np.array([sliding_factors(slenderness, 6) for slenderness in (3, 6, 12, 100)])
    assert (np.diff(factors, axis=0) > 0).all()
    assert (np.diff(factors, axis=1) < 0).all()
    assert factors[-1, 0] == pytest.approx(1.0, abs=2e-3)


def test_a_body_as_broad_as_long_is_refused():
    with pytest.raises(ArgumentError, match="longer than broad"):
        sliding_factors(1.0, 3)


def test_a_motion_that_is_a_term_of_the_series_has_its_factor():
    legendre = np.polynomial.legendre

    def two_node(mu):
        shape = legendre.legval(mu, legendre.legder([0, 0, 0, 1]))
        return shape[None], np.zeros((1, len(mu)))

    mu, weights = legendre.leggauss(20)
    strips = 0.5 * np.pi * 1025.0 * 10.0**2 * 100.0 * float(weights @ ((1 - mu**2) * two_node(mu)[0][0] ** 2))
    exact = spheroid_added_mass(two_node, 200.0, 20.0)[0, 0]
    assert exact / strips == pytest.approx(sliding_factors(10, 3)[2], rel=1e-12)


@pytest.mark.parametrize("slenderness", [6, 8, 10, 12])
def test_panels_about_a_spheroid(slenderness):
    length, breadth = 20.0 * slenderness, 20.0
    motions = UniformMotions(length, MODES)
    flow = wet.PanelFlow(spheroid_panels(length, breadth, 32, 8), neutral_axis_m=0.0)
    exact = SpheroidFlow(length, breadth).added_mass(motions).matrix
    found = flow.added_mass(motions)
    error = np.abs(found.matrix.diagonal() / exact.diagonal() - 1.0)
    # 512 panels of the whole body. They lie within it: its volume is 0.9 per cent short, most of the error
    assert error[: 2 + 4].max() < 0.01
    assert error[6] < 0.015
    assert found.asymmetry < 3e-3


@pytest.mark.parametrize("slenderness", [6, 12])
def test_panels_converge(slenderness):
    length, breadth = 20.0 * slenderness, 20.0
    motions = UniformMotions(length, MODES)
    exact = SpheroidFlow(length, breadth).added_mass(motions).matrix.diagonal()
    errors = []
    for lengthwise, girthwise in ((32, 8), (45, 11), (64, 16)):
        flow = wet.PanelFlow(spheroid_panels(length, breadth, lengthwise, girthwise), neutral_axis_m=0.0)
        errors.append(np.abs(flow.added_mass(motions).matrix.diagonal() / exact - 1.0))
    # of the order of a panel's length, at the worst: twice the panels, the error falls by the root of two and more
    # until what counting far panels as points costs is left
    assert (errors[1] < np.maximum(errors[0] / np.sqrt(2.0), 1e-3)).all()
    assert (errors[2] < np.maximum(errors[1] / np.sqrt(2.0), 1e-3)).all()


@pytest.mark.parametrize("slenderness", [6, 8, 10, 12])
def test_wet_frequencies_of_a_flexible_spheroid(slenderness):
    length, breadth = 20.0 * slenderness, 20.0
    girder = uniform_girder(length, 100e3, 3e13)
    exact = wet.solve(girder, SpheroidFlow(length, breadth))
    found = wet.solve(girder, wet.PanelFlow(spheroid_panels(length, breadth, 32, 8), neutral_axis_m=0.0))
    np.testing.assert_allclose(found.modes.angular_frequencies[:4], exact.modes.angular_frequencies[:4], rtol=0.004)
    finer = wet.solve(girder, wet.PanelFlow(spheroid_panels(length, breadth, 64, 16), neutral_axis_m=0.0))
    np.testing.assert_allclose(finer.modes.angular_frequencies[:4], exact.modes.angular_frequencies[:4], rtol=0.0013)


def test_strips_with_the_spheroids_own_series_are_exact_but_for_the_turning():
    """Sections that slide: the operator has the body's own factors; only sections between stations are interpolated."""
    length, breadth = 200.0, 20.0

    class Sliding(UniformMotions):
        def angles(self, x):
            return np.zeros_like(self.deflections(x))

    motions = Sliding(length, MODES)
    exact = SpheroidFlow(length, breadth).added_mass(motions).matrix
    found = wet.StripFlow(spheroid_sections(length, breadth, 121)).added_mass(motions).matrix
    np.testing.assert_allclose(found.diagonal(), exact.diagonal(), rtol=2e-3)
    np.testing.assert_allclose(found, exact, atol=2e-3 * np.abs(exact).max())


def ellipsoid_heave(length, breadth, draught):
    """Exact added mass in heave of a half-submerged ellipsoid, kg: rho V gamma / (2 - gamma), V immersed."""
    a, b, c = length / 2, breadth / 2, draught

    def integrand(t):
        # lambda = t / (1 - t) brings infinity to 1
        lam = t / (1 - t)
        return 1.0 / ((c**2 + lam) * np.sqrt((a**2 + lam) * (b**2 + lam) * (c**2 + lam))) / (1 - t) ** 2

    gamma = a * b * c * quad(integrand, 0.0, 1.0, limit=400, points=[0.5, 0.99, 0.999, 0.9999])[0]
    return 1025.0 * 2.0 / 3.0 * np.pi * a * b * c * gamma / (2.0 - gamma)


def ellipsoid_sections(length, breadth, draught, count):
    circle = spheroid_sections(length, 2.0, count)
    return wet.Sections(circle.x_m, circle.points_m * [breadth / 2, draught])


def test_the_ellipsoids_formula_has_the_spheroid_and_the_disc_as_limits():
    strips = 0.5 * np.pi * 1025.0 * 10.0**2 * 200.0 * 2.0 / 3.0
    assert ellipsoid_heave(200.0, 20.0, 10.0) / strips == pytest.approx(sliding_factors(10, 1)[0], rel=1e-6)
    assert ellipsoid_heave(200.0, 20.0, 0.01) / strips == pytest.approx(1.0 / ellipe(1.0 - 0.01), rel=2e-3)


@pytest.mark.parametrize("draught", [1.5, 4.0, 10.0, 15.0])
def test_flat_and_deep_ellipsoids_heave(draught):
    length, breadth = 160.0, 20.0
    exact = ellipsoid_heave(length, breadth, draught)
    sections = ellipsoid_sections(length, breadth, draught, 49)
    panels = wet.PanelFlow(wet.Panels.from_sections(sections, girthwise=12), neutral_axis_m=0.0)
    motions = UniformMotions(length, 1)
    assert panels.added_mass(motions).matrix[0, 0] == pytest.approx(exact, rel=0.01)
    # a semicircle of the same dipole stands for the section: 1 per cent, where one of the same breadth leaves 3
    assert wet.StripFlow(sections).added_mass(motions).matrix[0, 0] == pytest.approx(exact, rel=0.015)
    same_breadth = wet.StripFlow(sections, lengthwise="lewis").added_mass(motions).matrix[0, 0]
    if draught == 1.5:
        assert same_breadth < 0.975 * exact
