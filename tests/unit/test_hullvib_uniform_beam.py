"""Uniform free-free modes: roots against the tables, shapes of any order against closed forms."""

import numpy as np
import pytest

from hullvib import ArgumentError
from hullvib.uniform_beam import frequency_parameters, uniform_modes

# Blevins, Formulas for Natural Frequency and Mode Shape (1979), table 8-1, case 1, free-free, lambda_i, as printed
BLEVINS = [4.73004074, 7.85320462, 10.9956078, 14.1371655, 17.2787597]
# square roots of the 20-digit Omega of the uniform beam (45-digit evaluation of cos b cosh b = 1)
OMEGA = [22.373285448061323923, 61.672822867920245259, 120.90339172712377951, 199.85944812720089844]


def test_roots_are_those_of_the_tables():
    g = frequency_parameters(200)
    assert g[:5] == pytest.approx(BLEVINS, rel=1e-8)  # nine printed digits
    assert g[:4] ** 2 == pytest.approx(OMEGA, rel=4e-16)  # two last bits, after squaring
    # from mode 12 on 1/cosh(g) is below the last bit of g
    assert np.array_equal(g[12:], (2 * np.arange(13, 201) + 1) * np.pi / 2)


def test_mode_200_follows_its_closed_form():
    # At g x = k pi / 2, x < 1/2, the term of the far end is below e^-300, so phi = cos - sin + e^(-g x).
    k = np.arange(0, 200)
    phi = uniform_modes(k / 401.0, 200)[0, -1]
    expected = np.array([1.0, -1.0, -1.0, 1.0])[k % 4] + np.exp(-k * np.pi / 2)
    # the argument reaches 630, its last bit is 1e-13
    assert phi == pytest.approx(expected, abs=1e-12)
    # mode 200 is antisymmetric
    assert uniform_modes(1.0 - k / 401.0, 200)[0, -1] == pytest.approx(-expected, abs=1e-12)


def test_modes_are_orthonormal_and_orthogonal_to_the_rigid_body_functions():
    nodes, weights = np.polynomial.legendre.leggauss(800)  # exact for products of phase 2 * 630
    x = 0.5 + 0.5 * nodes
    functions = np.vstack([np.ones_like(x), np.sqrt(3) * (2 * x - 1), uniform_modes(x, 200)[0]])
    gram = (functions * (0.5 * weights)) @ functions.T
    assert np.abs(gram - np.eye(202)).max() < 1e-11  # 202 by 800 sums of terms good to 1e-13


def test_ends_are_free_and_the_aft_end_is_two():
    ends = uniform_modes(np.array([0.0, 1.0]), 40, (0, 1, 2, 3))
    g = frequency_parameters(40)
    assert ends[0, :, 0] == pytest.approx(np.full(40, 2.0), rel=1e-13)
    assert np.abs(ends[2] / g[:, None] ** 2).max() < 1e-12
    assert np.abs(ends[3] / g[:, None] ** 3).max() < 1e-12


def test_derivatives_match_differences():
    x, h = np.linspace(0.05, 0.95, 19), 1e-4
    for order in (0, 1, 2):
        up, down = (uniform_modes(x + s * h, 6, (order,))[0] for s in (1, -1))
        exact = uniform_modes(x, 6, (order + 1,))[0]
        # second-order difference: error g^2 h^2 / 6 = 7e-7 of the derivative's size, g <= 20.5
        assert np.abs((up - down) / (2 * h) - exact).max() < 2e-6 * np.abs(exact).max()


def test_senseless_requests_are_refused():
    with pytest.raises(ArgumentError, match="count is 0"):
        frequency_parameters(0)
    with pytest.raises(ArgumentError, match="order"):
        uniform_modes(np.zeros(1), 2, (4,))
    with pytest.raises(ArgumentError, match="dimensions"):
        uniform_modes(np.zeros((1, 1)), 2)
