"""StodolaRitz: what it refuses, what it returns, and girders that are hard on it."""

import numpy as np
import pytest

from hullvib import (
    ArgumentError,
    FiniteElements,
    Girder,
    PointMass,
    Ritz,
    SolutionError,
    StodolaRitz,
    solve,
)
from hullvib.timoshenko_elements import TimoshenkoElements

HULL = Girder([0, 20, 20, 80, 100], [5e4, 9e4, 12e4, 8e4, 3e4], [1e12, 3e12, 6e12, 5e12, 1e12])


def test_it_is_the_default_and_says_what_it_did():
    modes = solve(HULL)
    assert modes.method == {"method": "stodola_ritz", "functions": 12, "steps": 2}
    assert (modes.theory, modes.medium) == ("Euler-Bernoulli", "dry")
    assert modes.node_counts.tolist() == [2, 3, 4, 5, 6]


@pytest.mark.parametrize(
    ("settings", "message"),
    [({"functions": 0}, "functions is 0"), ({"functions": 401}, "functions is 401"), ({"steps": 0}, "steps is 0")],
)
def test_settings_out_of_range(settings, message):
    with pytest.raises(ArgumentError, match=message):
        StodolaRitz(**settings)


def test_requests_that_cannot_be_met():
    with pytest.raises(ArgumentError, match="7 modes were asked of 6"):
        solve(HULL, StodolaRitz(6), modes=7)
    with pytest.raises(ArgumentError, match="shear rigidity kGA"):
        solve(HULL, StodolaRitz(shear=True))
    with pytest.raises(ArgumentError, match="a method and a tolerance"):
        solve(HULL, Ritz(), tolerance=1e-6)
    with pytest.raises(ArgumentError, match="tolerance is 0"):
        solve(HULL, tolerance=0.0)


def test_a_tolerance_chooses_the_functions_and_says_so():
    wide, narrow = solve(HULL, tolerance=1e-2), solve(HULL, tolerance=1e-7)
    assert wide.method["proven"] is True
    assert narrow.method["relative_width"] <= 1e-7
    assert narrow.method["functions"] >= wide.method["functions"]
    with pytest.raises(SolutionError, match="is not reached"):
        solve(HULL, tolerance=1e-15)


def test_a_tolerance_without_proof_rests_on_the_last_change():
    sharp = Girder([0, 1, 2], [0, 1, 0], [0, 1, 0])
    modes = solve(sharp, tolerance=1e-6, modes=2)
    assert modes.method["proven"] is False
    better = solve(sharp, StodolaRitz(48, 3), modes=2)
    assert modes.angular_frequencies == pytest.approx(better.angular_frequencies, rel=1e-6)


def test_the_scale_is_the_largest_amplitude():
    modes = solve(HULL, modes=5)
    x = np.linspace(0, 100, 20001)
    # 5 mm apart, a mode of 25 m waves misses its top by (pi 0.005 / 25)^2 / 2 at most
    assert np.abs(modes.shape(x)).max(axis=1) == pytest.approx(1.0, abs=1e-6)
    assert (modes.shape([0.0]) > 0).all()
    amid = solve(Girder([0, 1], [1, 1], [1, 1], point_masses=[PointMass(0, 3.0), PointMass(1, 3.0)]), modes=3)
    assert np.abs(amid.shape(np.linspace(0, 1, 20001))).max(axis=1) == pytest.approx(1.0, abs=1e-6)


def test_moments_and_shears_are_those_of_the_inertia_loads():
    modes = solve(HULL, modes=3).normalised("unit-modal-mass")
    x = np.linspace(0, 100, 4001)
    moment, shear = modes.moment(x), modes.shear(x)
    size = np.abs(moment).max(axis=1)
    # both ends are free
    assert np.abs(moment[:, [0, -1]]).max() < 1e-10 * size.max()
    assert np.abs(shear[:, [0, -1]]).max() < 1e-10 * np.abs(shear).max()
    # M' = V: the trapezoidal rule with steps of h errs by (h g / L)^2 / 12, 6e-7 at g = 11, more where V' jumps
    sums = np.concatenate([np.zeros((3, 1)), np.cumsum(0.5 * (shear[:, 1:] + shear[:, :-1]), axis=1) * 0.025], axis=1)
    assert np.abs(sums - moment).max() < 1e-5 * size.max()
    # curvature jumps where EI does, the moment does not
    aft, fore = modes.curvature([20 - 1e-9, 20.0]).T
    assert fore / aft == pytest.approx(np.full(3, 0.5), rel=1e-6)


def test_point_masses_at_the_ends_and_several_at_one_place():
    masses = [PointMass(0, 2e5), PointMass(50, 1e5), PointMass(50, 1.5e5), PointMass(33.3, 4e5), PointMass(100, 1e5)]
    girder = Girder([0, 50, 100], [1e4, 2e4, 1e4], [1e12, 2e12, 1e12], point_masses=masses)
    ours, fine = solve(girder, modes=4), solve(girder, FiniteElements(200), modes=4)
    # 200 elements: (g h)^4 / 1440 of 3e-8 in mode 4
    assert ours.angular_frequencies == pytest.approx(fine.angular_frequencies, rel=2e-7)
    x = np.linspace(0, 100, 101)
    assert ours.shape(x) == pytest.approx(fine.shape(x), abs=1e-5)


def test_masses_on_a_massless_girder():
    masses = [PointMass(x, 1e5) for x in (0.0, 40.0, 60.0, 100.0)]
    girder = Girder([0, 100], [0, 0], [1e12, 1e12], point_masses=masses)
    # four masses, two rigid motions, two elastic modes: the exact ones of a 2 x 2 problem, as elements have them
    expected = solve(girder, FiniteElements(20), modes=2).angular_frequencies
    assert solve(girder, modes=2).angular_frequencies == pytest.approx(expected, rel=1e-9)
    with pytest.raises(SolutionError, match="only 2 elastic modes"):
        solve(girder, modes=3)
    one_place = Girder([0, 100], [0, 0], [1e12, 1e12], point_masses=[PointMass(30, 1e5)])
    with pytest.raises(SolutionError, match="all mass lies at one point"):
        solve(one_place)


def test_a_massless_bay():
    girder = Girder([0, 30, 30, 40, 40, 100], [1e5, 1e5, 0, 0, 1e5, 1e5], [1e12] * 6)
    fine = solve(girder, FiniteElements(200), modes=3)
    assert solve(girder, modes=3).angular_frequencies == pytest.approx(fine.angular_frequencies, rel=1e-7)


@pytest.mark.parametrize("ratio", [1e2, 1e4])
def test_rigidity_that_falls_towards_the_ends(ratio):
    girder = Girder([0, 30, 70, 100], [1e5] * 4, [6e12 / ratio, 6e12, 6e12, 6e12 / ratio])
    better = solve(girder, StodolaRitz(40, 3), modes=3).angular_frequencies
    errors = solve(girder, modes=3).angular_frequencies / better - 1
    # soft tips bend sharply, which twelve smooth functions resolve to 1e-7 after two steps
    assert (errors > -1e-12).all()
    assert (errors < 1e-6).all()
    fine = solve(girder, FiniteElements(2000), modes=3).angular_frequencies
    # 2000 elements: round-off of 1e-5
    assert better == pytest.approx(fine, rel=1e-4)


def test_very_short_segments():
    plain = Girder([0, 100], [1e5, 1e5], [1e12, 1e12])
    positions = np.array([0, 3e-7, 50, 50 + 2e-7, 50 + 3e-7, 100 - 2e-7, 100])
    cut = Girder(positions, np.full(7, 1e5), np.full(7, 1e12))
    assert solve(cut).angular_frequencies == pytest.approx(solve(plain).angular_frequencies, rel=1e-12)


def test_thousands_of_breakpoints():
    x = np.linspace(0, 100, 2001)
    mass, rigidity = 1e5 * (1.2 + np.sin(x / 9)), 1e12 * (1.1 + np.cos(x / 30))
    ours = solve(Girder(x, mass, rigidity), modes=3)
    every = solve(Girder(x[::10], mass[::10], rigidity[::10]), modes=3)
    # lines through every tenth point differ by (h / 9)^2 / 12 of the sines
    assert ours.angular_frequencies == pytest.approx(every.angular_frequencies, rel=1e-3)
    assert ours.angular_frequencies == pytest.approx(
        solve(Girder(x, mass, rigidity), FiniteElements(2000), modes=3).angular_frequencies, rel=1e-4
    )


def test_upper_bounds_fall_with_functions_and_steps():
    reference = solve(HULL, StodolaRitz(30, 4), modes=5).angular_frequencies
    previous = np.full(5, np.inf)
    for method in (StodolaRitz(6, 1), StodolaRitz(9, 1), StodolaRitz(9, 2), StodolaRitz(12, 2), StodolaRitz(12, 4)):
        omega = solve(HULL, method, modes=5).angular_frequencies
        assert (omega <= previous * (1 + 1e-13)).all()
        assert (omega >= reference * (1 - 1e-13)).all()
        previous = omega


def test_shear_flexibility():
    girder = Girder(
        [0, 30, 30, 100], [1e5, 2e5, 1e5, 1e5], [1e12, 2e12, 3e12, 1e12], [4e9, 4e9, 6e9, 3e9],
        point_masses=[PointMass(60, 1e6), PointMass(100, 1e5)],
    )  # fmt: skip
    ours = solve(girder, StodolaRitz(16, 3, shear=True), modes=3)
    assert ours.theory == "shear-flexible"
    stiff = solve(girder, modes=3).angular_frequencies
    assert (ours.angular_frequencies < 0.95 * stiff).all()
    fine = solve(girder, TimoshenkoElements(200), modes=3)
    # elements of fourth order in omega^2, without rotary inertia as the girder has none
    assert ours.angular_frequencies == pytest.approx(fine.angular_frequencies, rel=1e-6)
    x = np.linspace(0.5, 99.5, 200)
    assert ours.shape(x) == pytest.approx(fine.shape(x), abs=1e-4)
    for quantity in ("rotation", "moment", "shear"):
        a, b = getattr(ours, quantity)(x), getattr(fine, quantity)(x)
        assert np.abs(a - b).max() < 1e-3 * np.abs(b).max(), quantity
    # shear strain -M' / kGA, M of the shape itself and the strain of the shape before the last step: of mode 3 they
    # differ by the root of the relative error of its eigenvalue, 1e-12
    strain = -ours.shear(x) / girder.shear_rigidity(x)
    assert ours.slope(x) - ours.rotation(x) == pytest.approx(strain, abs=1e-5 * np.abs(ours.slope(x)).max())


def test_no_mode_is_made_of_round_off():
    # three masses on a massless girder: two rigid motions, one elastic mode
    masses = [PointMass(0, 1), PointMass(0.5, 1), PointMass(1, 1)]
    girder = Girder([0, 1], [0, 0], [1, 1], point_masses=masses)
    # 2 m of the masses against one in the middle: k = 48, mass 1 x 2 / 3, hence omega^2 = 48 x 3 / 2
    assert solve(girder, modes=1).angular_frequencies == pytest.approx(72.0**0.5, rel=1e-12)
    with pytest.raises(SolutionError, match="only 1 elastic modes"):
        solve(girder, modes=2)


@pytest.mark.parametrize("lowest", [1e-6, 1e-8, 1e-9, 1e-10])
def test_a_rigidity_that_dips_inside(lowest):
    girder = Girder([0, 0.5, 0.5, 1], [1, 1, 1, 1], [1, lowest, 1, 1])
    # the same line, cut by halves towards the dip, so that every piece is gentle
    cuts = 0.5 - 0.5 * 2.0 ** -np.arange(1, 28)
    x = np.concatenate([[0], cuts, [0.5, 0.5, 1]])
    rigidity = np.concatenate([[1], 1 - (1 - lowest) * cuts / 0.5, [lowest, 1, 1]])
    cut = solve(Girder(x, np.ones(len(x)), rigidity), modes=3).angular_frequencies
    # the table's own values near the dip are rounded to 1e-16 of 1, that is 1e-6 of 1e-10
    assert solve(girder, modes=3).angular_frequencies == pytest.approx(cut, rel=max(1e-18 / lowest, 1e-9))


@pytest.mark.parametrize("least", [1e-2, 1e-3, 1e-4, 1e-6])
def test_negative_coefficients_of_a_positive_rigidity(least):
    # EI = least + (2 x - 1)^2, whose middle Bernstein coefficient is negative
    girder = Girder.from_polynomials([0, 1], [[1]], [[1 + least, -4, 4]])
    halves = 2.0 ** -np.arange(2, 14)
    cut = girder.refined(np.concatenate([[0.5], 0.5 - halves, 0.5 + halves]))
    assert solve(girder, modes=3).angular_frequencies == pytest.approx(
        solve(cut, modes=3).angular_frequencies, rel=1e-9
    )


def test_waves_shorter_than_those_of_the_trial_functions():
    girder = Girder.from_polynomials([0, 0.97, 1], [[1], [1e4]], [[1], [1e-5]])
    cut = girder.refined(np.linspace(0.97, 1, 9)[1:-1])
    best = solve(cut, StodolaRitz(48), modes=3).angular_frequencies
    for functions in (12, 24, 36):
        errors = solve(girder, StodolaRitz(functions), modes=3).angular_frequencies / best - 1
        # upper bounds, good to what a fourfold larger set leaves in the reference
        assert (errors > -1e-9).all()
    assert (errors < 1e-6).all()


def test_a_tolerance_may_take_more_steps():
    # a pair of soft ends: three steps on a few functions are cheaper than many functions
    girder = Girder([0, 10, 90, 100], [1e5] * 4, [6e9, 6e12, 6e12, 6e9])
    found = solve(girder, modes=3, tolerance=1e-6)
    assert found.method["steps"] in (2, 3)
    assert found.method["relative_width"] <= 1e-6
    with pytest.raises(ArgumentError, match="ask for 1 to 93"):
        solve(girder, modes=94, tolerance=1e-6)
