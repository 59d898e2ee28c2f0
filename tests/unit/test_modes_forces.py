"""Rotations, bending moments and shear forces of modes, from the equilibrium of the inertia loads."""

import numpy as np
import pytest

from hullvib import ArgumentError, FiniteElements, Girder, PointMass, Ritz, StodolaRitz, TimoshenkoElements, solve

STEPPED = Girder(
    [0, 20, 20, 70, 100],
    [3e4, 5e4, 9e4, 7e4, 1e4],
    [2e12, 8e12, 3e12, 9e12, 1e12],
    point_masses=[PointMass(12.0, 4e5), PointMass(12.0, 1e5), PointMass(100.0, 1e5), PointMass(0.0, 2e5)],
)


def test_the_uniform_beam_has_the_moments_and_shears_of_its_closed_form():
    # phi'' and phi''' of the free-free beam with L = m = EI = 1; Blevins, table 8-1, case 1
    modes = solve(Girder([0, 1], [1, 1], [1, 1]), Ritz(12), modes=3)
    x = np.linspace(0, 1, 41)
    g = np.array([4.730040744862704, 7.853204624095838, 10.995607838001671])[:, None]
    sigma = (np.cosh(g) - np.cos(g)) / (np.sinh(g) - np.sin(g))
    moment = 0.5 * g**2 * (-np.cos(g * x) + np.cosh(g * x) - sigma * (-np.sin(g * x) + np.sinh(g * x)))
    shear = 0.5 * g**3 * (np.sin(g * x) + np.sinh(g * x) - sigma * (-np.cos(g * x) + np.cosh(g * x)))
    # the textbook form cancels to 1e-12 at g = 11
    assert np.abs(modes.moment(x) - moment).max() < 1e-10 * np.abs(moment).max()
    assert np.abs(modes.shear(x) - shear).max() < 1e-10 * np.abs(shear).max()


@pytest.mark.parametrize(
    "method", [Ritz(20), Ritz(40, basis="legendre"), FiniteElements(200), FiniteElements(9)], ids=str
)
def test_forces_balance_vanish_at_the_ends_and_jump_at_point_masses(method):
    modes = solve(STEPPED, method, modes=4)
    x = np.linspace(0, 100, 301)
    moment, shear = modes.moment(x), modes.shear(x)
    top, sheared = np.abs(moment).max(axis=1), np.abs(shear).max(axis=1)
    # orthogonal to the rigid-body motions but for the round-off of the eigenvalue solver
    assert (np.abs(moment[:, -1]) < 1e-8 * top).all()
    assert np.abs(modes.moment([0.0])).max() == 0.0
    # the last section carries the inertia load of the end mass
    held = -(modes.angular_frequencies**2) * 1e5 * modes.shape([100.0])[:, 0]
    assert (np.abs(shear[:, -1] - held) < 1e-8 * sheared).all()
    for place, mass in ((12.0, 5e5), (0.0, 2e5)):
        inertia = modes.angular_frequencies**2 * mass * modes.shape([place])[:, 0]
        before = modes.shear([place - 1e-7])[:, 0] if place else 0.0
        after = modes.shear([place])[:, 0]
        # the load on 1e-7 m is the rest
        assert np.abs(after - before - inertia).max() < 1e-6 * sheared.max()
    # dM/dx = V by Simpson's rule between points off the jumps of V
    x = np.linspace(12.5, 19.5, 5)
    step = modes.moment(x[-1:])[:, 0] - modes.moment(x[:1])[:, 0]
    v = modes.shear(x)
    simpson = (x[1] - x[0]) / 3 * (v[:, 0] + 4 * v[:, 1] + 2 * v[:, 2] + 4 * v[:, 3] + v[:, 4])
    assert np.abs(step - simpson).max() < 1e-5 * top.max()


def test_the_moment_is_good_where_the_curvature_of_smooth_functions_is_poor():
    exact = solve(STEPPED, Ritz(60, basis="legendre"), modes=2)
    rough = solve(STEPPED, Ritz(20), modes=2)
    x = np.linspace(1, 99, 99)
    moment = exact.moment(x)
    # piecewise polynomials hold the jump of curvature: EI w'' and equilibrium agree to what seven functions leave on
    # the first 12 m, where EI rises threefold
    own = STEPPED.flexural_rigidity(x) * exact.curvature(x)
    assert np.abs(own - moment).max() < 1e-5 * np.abs(moment).max()
    size = np.abs(moment).max()
    wrong = np.abs(STEPPED.flexural_rigidity(x) * rough.curvature(x) - moment).max()
    assert wrong > 0.2 * size
    assert np.abs(rough.moment(x) - moment).max() < 0.03 * size


def test_fields_that_know_their_forces_agree_with_the_equilibrium_of_the_others():
    own, exact = solve(STEPPED, StodolaRitz(16, 2), modes=3), solve(STEPPED, Ritz(60, basis="legendre"), modes=3)
    # at point masses and jumps too, where the value forward of them counts
    x = np.concatenate([[0.0, 12.0, 20.0, 70.0, 100.0], np.linspace(0.7, 99.3, 60)])
    for mine, theirs in ((own.moment(x), exact.moment(x)), (own.shear(x), exact.shear(x))):
        size = np.abs(theirs).max(axis=1, keepdims=True)
        # two steps on 16 functions leave 1e-6 in the shape of mode 3
        assert (np.abs(mine - theirs) < 1e-5 * size).all()


def test_moments_scale_with_the_shape():
    modes = solve(STEPPED, Ritz(16), modes=2)
    unit = modes.normalised("unit-modal-mass")
    x = np.linspace(0, 100, 7)
    factor = unit.scale / modes.scale
    assert unit.moment(x) == pytest.approx(factor[:, None] * modes.moment(x), rel=1e-12)
    assert unit.shear(x) == pytest.approx(factor[:, None] * modes.shear(x), rel=1e-12)


def test_rotary_inertia_enters_the_moment_but_not_the_shear_force():
    girder = Girder([0, 4], [1, 1], [3, 3], None, [0.2, 0.2], [PointMass(1.0, 0.5, 0.3)])
    modes = solve(girder, FiniteElements(100, rotary_inertia=True), modes=2)
    assert np.abs(modes.moment([4.0])).max() < 1e-7 * np.abs(modes.moment(np.linspace(0, 4, 99))).max()
    # M' = V - omega^2 J psi between the point mass and the fore end
    x = np.linspace(1.5, 3.5, 201)
    slope = np.gradient(modes.moment(x), x, axis=1)[:, 1:-1]
    turned = modes.angular_frequencies[:, None] ** 2 * 0.2 * modes.rotation(x)[:, 1:-1]
    # central differences: h^2 / 6 of the third derivative, g h = 0.02
    assert np.abs(slope - modes.shear(x)[:, 1:-1] + turned).max() < 2e-4 * np.abs(slope).max()
    assert np.abs(turned).max() > 0.05 * np.abs(slope).max()
    leap = modes.moment([1.0])[:, 0] - modes.moment([1.0 - 1e-9])[:, 0]
    assert leap == pytest.approx(-(modes.angular_frequencies**2) * 0.3 * modes.rotation([1.0])[:, 0], rel=1e-6)


def test_positions_outside_are_refused():
    modes = solve(STEPPED, modes=1)
    for call in (modes.moment, modes.shear, modes.rotation, modes.bending_curvature, modes.shear_strain):
        with pytest.raises(ArgumentError, match="within 0"):
            call([-1.0])
    assert modes.shear_strain([3.0, 40.0]) == pytest.approx(np.zeros((1, 2)), abs=1e-15)


def test_signs_of_moment_shear_force_and_shear_strain():
    girder = Girder([0, 60, 100], [4e4, 6e4, 3e4], [1e13, 3e13, 1e13], shear_rigidity=[2e10, 3e10, 1e10])
    plain = solve(girder, modes=1)
    x = np.linspace(5, 95, 19)
    # mode 1 is up at the ends and down amidships: concave upwards, sagging, which counts positive
    ends, middle = plain.shape([0.0, 100.0])[0], plain.shape([50.0])[0]
    assert (ends > 0).all()
    assert (middle < 0).all()
    assert (plain.moment(x) > 0).all()
    # its inertia forces act upwards where it is up, so that V is positive from the aft end on
    assert plain.shear([5.0])[0, 0] > 0
    assert plain.shear([95.0])[0, 0] < 0
    flexible = solve(girder, TimoshenkoElements(400), modes=2)
    # the strain of an element is linear within it and off by (h / half wave)^2, some 1e-4
    moment = girder.flexural_rigidity(x) * flexible.bending_curvature(x)
    assert flexible.moment(x) == pytest.approx(moment, abs=1e-3 * np.abs(moment).max())
    strain = -flexible.shear(x) / girder.shear_rigidity(x)
    assert flexible.shear_strain(x) == pytest.approx(strain, abs=1e-3 * np.abs(strain).max())
