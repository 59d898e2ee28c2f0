"""Ritz with Legendre polynomials: sharp ends, steps, point masses, against exact answers; the basis itself."""

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from hullvib import ArgumentError, FiniteElements, Girder, PointMass, Ritz, solve
from hullvib.legendre import legendre_trials, smooth_stretches

XI = Polynomial([0.0, 1.0])


def piece(*factors):
    product = Polynomial([1.0])
    for base, power in factors:
        product *= base**power
    return product.coef


def tip(mass, rigidity):
    return Girder.from_polynomials([0, 1], [piece(*mass)], [piece(*rigidity)])


def double(n, k):
    aft, fore = 2 * XI, 1 - 2 * XI
    return Girder.from_polynomials(
        [0, 0.5, 1], [piece((aft, n)), piece((fore, n))], [piece((aft, k)), piece((fore, k))]
    )


FORE, AFT = 2 - 2 * XI, 2 * XI
# tests/data/exact_beams.json: Bessel functions and Jacobi polynomials in 45-digit arithmetic
SHARP = {
    "wedge": (tip([(1 - XI, 1)], [(1 - XI, 3)]), [12.7575088709440, 27.7553529693745, 47.5759448930284]),
    "cone": (tip([(1 - XI, 2)], [(1 - XI, 4)]), [17.4164576741972, 35.0269759566952, 57.3796409776707]),
    "double wedge": (double(1, 3), [26.3746164271633, 43.6094489507007, 70.8499989190958]),
    "double cone": (double(2, 4), [40.7064658182003, 61.6273420895527, 95.2775725440371]),
    "jacobi 0 0": (tip([], [(FORE, 2), (AFT, 2)]), [19.5959179422654, 43.8178046004132, 75.8946638440411]),
    "jacobi 1 1": (
        tip([(FORE, 1), (AFT, 1)], [(FORE, 3), (AFT, 3)]), [30.9838667696593, 63.4980314655501, 103.691851174525]),
    "jacobi 2 1": (
        tip([(FORE, 2), (AFT, 1)], [(FORE, 4), (AFT, 3)]), [36.6606055596467, 73.3212111192934, 117.575507653592]),
}  # fmt: skip


@pytest.mark.parametrize("name", SHARP)
def test_sharp_ends(name):
    girder, exact = SHARP[name]
    frequencies = solve(girder, Ritz(16, basis="legendre"), modes=3).angular_frequencies
    # the shapes are polynomials (jacobi) or entire functions on each stretch: round-off and 15 printed digits are left
    assert frequencies == pytest.approx(exact, rel=1e-10)
    # uniform modes crawl there
    assert solve(girder, Ritz(16), modes=3).angular_frequencies[2] > exact[2] * 1.001


def test_polynomials_in_the_trial_space_are_exact():
    # the Jacobi beam's modes are Legendre polynomials of degree 2, 3, ...: Omega^2 = 16 (n - 1) n (n + 1) (n + 2)
    girder = SHARP["jacobi 0 0"][0]
    n = np.arange(2, 6)
    exact = np.sqrt(16.0 * (n - 1) * n * (n + 1) * (n + 2))
    # 4 functions hold degrees 2 to 5; round-off with a condition of 1e4
    assert solve(girder, Ritz(4, basis="legendre"), modes=4).angular_frequencies == pytest.approx(exact, rel=1e-11)


def test_high_degrees_stay_stable():
    uniform = Girder([0, 1], [1, 1], [1, 1])
    exact = solve(uniform, Ritz(40), modes=30).angular_frequencies
    assert solve(uniform, Ritz(80, basis="legendre"), modes=30).angular_frequencies == pytest.approx(exact, rel=1e-10)


# segments [0, a], [a, 1 - a], [1 - a, 1] with m = mu, 1, mu and EI = e, 1, e; transfer matrices
@pytest.mark.parametrize(
    ("a", "mu", "e", "exact"),
    [
        (0.25, 0.5, 0.25, [24.870305803505, 52.075042570106, 97.118969195744]),
        (0.2, 2.0, 0.4, [18.024868993184, 46.485694759540, 80.074837492509]),
    ],
)
def test_steps_part_the_stretches(a, mu, e, exact):
    girder = Girder([0, a, a, 1 - a, 1 - a, 1], [mu, mu, 1, 1, mu, mu], [e, e, 1, 1, e, e])
    modes = solve(girder, Ritz(40, basis="legendre"), modes=3)
    assert modes.method == {
        "method": "ritz", "functions": 40, "rigid_body": True, "basis": "legendre", "stretches": 3
    }  # fmt: skip
    # eight polynomials on the shortest stretch; 14 digits are given
    assert modes.angular_frequencies == pytest.approx(exact, rel=1e-10)
    moment = modes.moment([a - 1e-9, a + 1e-9])
    # EI w'' on both sides of the step is the one bending moment
    curvature = modes.curvature([a - 1e-9, a + 1e-9]) * [e, 1.0]
    assert curvature == pytest.approx(moment, rel=1e-5, abs=1e-5 * np.abs(moment).max())


def test_end_masses():
    girder = Girder([0, 1], [1, 1], [1, 1], point_masses=[PointMass(0, 0.5), PointMass(1, 0.5)])
    exact = [12.7937136057281, 42.8576063710817, 92.4036042551996]
    assert solve(girder, Ritz(16, basis="legendre"), modes=3).angular_frequencies == pytest.approx(exact, rel=1e-12)


def test_point_masses_inside_part_the_stretches():
    girder = Girder([0, 1], [1, 1], [1, 1], point_masses=[PointMass(0.37, 0.5), PointMass(0.37, 0.1)])
    modes = solve(girder, Ritz(24, basis="legendre"), modes=3)
    assert modes.method["stretches"] == 2
    # 100 elements leave (11 / 100)^4 / 1440 = 1e-7
    fine = solve(girder, FiniteElements(100), modes=3)
    assert modes.angular_frequencies == pytest.approx(fine.angular_frequencies, rel=1e-6)
    assert (modes.angular_frequencies <= fine.angular_frequencies * (1 + 1e-9)).all()


def test_stretches_are_told_by_jumps_and_kinks_alone():
    kinked = Girder([0, 0.2, 0.5, 0.5, 0.7, 1], [1, 2, 3.5, 3.5, 3.5, 3.5], [3, 3, 3, 2, 2, 2])
    # at 0.2 the mass goes on straight, at 0.5 EI jumps and m bends, at 0.7 nothing happens
    assert smooth_stretches(kinked) == pytest.approx([0.0, 0.5, 1.0])
    smooth = Girder.from_functions(10.0, lambda x: np.exp(0.3 * x), lambda x: 2 + np.cos(x))
    assert len(smooth.breaks) > 2
    assert smooth_stretches(smooth) == pytest.approx([0.0, 1.0])
    # a saw-tooth has more stretches than three functions can serve
    saw = Girder(np.repeat(np.arange(11.0), 2)[1:-1], [1, 2] * 10, [1, 1] * 10)
    assert len(smooth_stretches(saw)) == 11
    assert len(legendre_trials(saw, 19).counts) == 1
    assert legendre_trials(saw, 23).counts.count(3) == 3


def test_the_functions_are_the_integrals_of_orthonormal_polynomials():
    girder = Girder([0, 0.3, 0.3, 1], [1, 1, 2, 2], [1, 1, 1, 1])
    trials = legendre_trials(girder, 9)
    rule = trials.rule(girder.breaks, 0)
    xi, weights = rule.xi.ravel(), rule.weights.ravel()
    curvature = trials.bending(xi, (2,))[0]
    assert (curvature * weights) @ curvature.T == pytest.approx(np.eye(9), abs=1e-13)
    # each order is the derivative of the one before it; central differences of quadratics are exact, h^2 else
    x, h = np.linspace(0.011, 0.989, 57), 1e-5
    x = x[np.abs(x - 0.3) > 2 * h]
    aft, here, fore = (trials.bending(x + step, (0, 1, 2, 3)) for step in (-h, 0.0, h))
    for order in range(3):
        size = np.abs(here[order + 1]).max()
        assert np.abs((fore[order] - aft[order]) / (2 * h) - here[order + 1]).max() < 1e-6 * size
    assert np.array_equal(trials.shearing(x, (0, 1, 2)), trials.bending(x, (1, 2, 3)))


def test_senseless_combinations_are_refused():
    with pytest.raises(ArgumentError, match="basis is 'chebyshev'"):
        Ritz(12, basis="chebyshev")
    with pytest.raises(ArgumentError, match="needs rigid_body=True"):
        Ritz(12, rigid_body=False, basis="legendre")
