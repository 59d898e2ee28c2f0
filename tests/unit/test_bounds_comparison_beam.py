"""The count of eigenvalues on a comparison beam, and what a bracket refuses to prove."""

import numpy as np
import pytest

from hullvib import ArgumentError, FiniteElements, Girder, NotProven, PointMass, StodolaRitz, bracket, solve
from hullvib.comparison_beam import comparison_beam

UNIFORM = Girder([0, 1], [1, 1], [1, 1])
# (g_j)^4, cos g cosh g = 1: Blevins, table 8-1
EXACT = np.array([22.3732854480613, 61.6728228679202, 120.903391727123, 199.859448127200]) ** 2


def test_the_count_is_exact_for_a_uniform_beam():
    for pieces in (1, 3, 40):
        girder = UNIFORM.refined(np.linspace(0, 1, pieces + 1)[1:-1])
        beam = comparison_beam(girder, 5e4, 0.1, 1e-3)
        for number, eigenvalue in enumerate(EXACT, 1):
            # the beam is lighter and stiffer by 1e-12 at most, so the count changes at the eigenvalue itself
            # within some 1e-9 of it the sign of the last pivot is in doubt
            assert beam.count_below(eigenvalue * (1 - 1e-6)) == number + 1
            assert beam.count_below(eigenvalue * (1 + 1e-6)) == number + 2


def test_the_count_of_point_masses_at_the_ends():
    # tests/data/exact_beams.json, uniform_endmass_0.5_0.5; unit of eigenvalues: total mass 2
    girder = Girder([0, 1], [1, 1], [1, 1], point_masses=[PointMass(0, 0.5), PointMass(1, 0.5)])
    exact = 2.0 * np.array([12.7937136057281, 42.8576063710817, 92.4036042551996]) ** 2
    beam = comparison_beam(girder, 2e4, 0.1, 1e-3)
    counts = [beam.count_below(value * (1 + sign * 1e-6)) for value in exact for sign in (-1, 1)]
    assert counts == [2, 3, 3, 4, 4, 5]


def test_the_comparison_beam_lies_below_and_comes_closer():
    girder = Girder([0, 20, 20, 80, 100], [5e4, 9e4, 12e4, 8e4, 3e4], [1e12, 3e12, 6e12, 5e12, 1e12])
    largest = float(girder.flexural_rigidity_coefficients.max())
    omega = solve(girder, modes=3).angular_frequencies
    eigenvalues = omega**2 * girder.total_mass * girder.length**3 / largest
    for variation, within in ((0.3, 0.3), (0.03, 0.03)):
        beam = comparison_beam(girder, float(eigenvalues[-1]), variation, 1e-4)
        for number, value in enumerate(eigenvalues, 1):
            assert beam.count_below(value * 0.999999) >= number + 1
            assert beam.count_below(value * (1 - within)) == number + 1


def test_a_doubtful_count_is_no_count():
    # two parts of 1e-6 L beside parts of 0.4 L: what they carry is lost in round-off
    girder = Girder([0, 1], [1, 1], [1, 1], point_masses=[PointMass(0.5, 1), PointMass(0.5 + 1e-7, 1)])
    beam = comparison_beam(girder, 1e4, 0.1, 1e-3)
    assert beam.count_below(3e3) is None


def test_modes_may_stand_for_their_girder():
    modes = solve(UNIFORM, StodolaRitz(10), modes=4)
    again, fresh = bracket(modes), bracket(UNIFORM, modes=4, functions=10)
    assert again.upper == pytest.approx(fresh.upper, rel=1e-13)
    assert again.lower == pytest.approx(fresh.lower, rel=1e-13)
    assert len(bracket(modes, modes=2).upper) == 2
    # of another method only the girder is taken
    assert bracket(solve(UNIFORM, FiniteElements(20), modes=3)).upper[0] == pytest.approx(EXACT[0] ** 0.5, rel=1e-7)


def test_close_pairs_are_enclosed_together():
    # two heavy masses amidships leave two cantilevers, whose modes come in close pairs
    masses = [PointMass(40, 1e10), PointMass(60, 1e10)]
    x, rigidity = [0, 40, 40, 60, 60, 100], [1e13, 1e13, 1e16, 1e16, 1e13, 1e13]
    girder = Girder(x, [1e5] * 6, rigidity, point_masses=masses)
    omega = solve(girder, StodolaRitz(24, 3), modes=4).angular_frequencies
    assert omega[1] / omega[0] < 1.01
    found = bracket(girder, modes=1)
    assert "with 2 functions" in found.proof
    assert found.lower[0] <= omega[0] * (1 + 1e-12)
    assert found.upper[0] >= omega[0] * (1 - 1e-12)
    assert found.relative_width[0] < 1e-6


def test_refusals_give_the_reason():
    with pytest.raises(NotProven, match="vanishes at x = 2 m"):
        bracket(Girder([0, 1, 2], [1, 1, 0], [1, 1, 0]))
    with pytest.raises(NotProven, match="extremes are not known"):
        bracket(Girder.from_functions(1.0, lambda x: 1.0 + x**2, np.exp))
    sheared = Girder([0, 1], [1, 1], [1, 1], [100, 100])
    with pytest.raises(NotProven, match="shear-flexible"):
        bracket(solve(sheared, StodolaRitz(shear=True)))
    with pytest.raises(ArgumentError, match="12 modes are to be bounded with 12 functions"):
        bracket(UNIFORM, modes=12)


def test_the_proof_is_stated():
    found = bracket(UNIFORM, modes=3)
    assert "Lehmann-Goerisch with 3 functions" in found.proof
    assert EXACT[2] < found.rho < EXACT[3]
    assert found.relative_width == pytest.approx((found.upper - found.lower) / found.upper)


# bounds of 64-bit sums are a thousandfold narrower; elsewhere a long double may be a double
EXTENDED = np.finfo(np.longdouble).eps < 1e-18


@pytest.mark.skipif(not EXTENDED, reason="no extended precision on this machine")
def test_brackets_of_a_uniform_beam_are_of_thirteen_digits():
    found = bracket(UNIFORM, modes=5)
    # cos g cosh g = 1 to 20 digits: Blevins's table, continued by Newton's method
    assert found.lower[0] < 22.373285448061268 * (1 + 2e-15)
    assert found.upper[0] > 22.373285448061268 * (1 - 2e-15)
    # five functions: what a small eigenproblem loses, 160 eps, and of extended sums 1e-16 of a few hundred terms
    assert found.relative_width[0] < 1e-11
    assert (found.relative_width < 1e-9).all()


@pytest.mark.skipif(not EXTENDED, reason="no extended precision on this machine")
def test_a_mass_snapped_to_a_breakpoint_is_bounded_where_it_stands():
    # within 1e-12 L of a breakpoint the solver moves it there, which costs mode 1 some 2e-12: the bounds do not follow
    def bounded(place):
        masses = [PointMass(place, 1)]
        return bracket(Girder([0, 0.4, 0.4, 1], [1] * 4, [1, 1, 1e-3, 1e-3], point_masses=masses), 2)

    aft, on, fore = (bounded(0.4 + step) for step in (-9e-13, 0.0, 9e-13))
    assert on.upper == pytest.approx(fore.upper, rel=1e-9)
    assert (aft.upper - on.upper)[0] * (fore.upper - on.upper)[0] < 0.0
    assert abs(fore.upper[0] - aft.upper[0]) > 1e-12 * on.upper[0]


def test_modes_that_use_up_their_functions_are_bounded_with_more():
    modes = solve(UNIFORM, StodolaRitz(5), modes=5)
    found = bracket(modes)
    assert len(found.upper) == 5
    assert (found.lower[:4] <= EXACT**0.5 * (1 + 1e-13)).all()
    assert (found.upper[:4] >= EXACT**0.5 * (1 - 1e-13)).all()


def test_a_bay_too_short_for_the_count_is_named():
    girder = Girder.from_polynomials([0, 100, 100 + 4e-7, 200], [[1], [50], [1]], [[1], [1e-3], [1]])
    with pytest.raises(NotProven, match=r"bay of 4e-07 m at x = 100 m"):
        bracket(girder, modes=3)
