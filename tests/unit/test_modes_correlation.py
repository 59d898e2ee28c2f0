"""Orthogonality residuals and the modal assurance criterion."""

from dataclasses import replace

import numpy as np
import pytest

from hullvib import (
    ArgumentError,
    FiniteElements,
    Girder,
    PointMass,
    Ritz,
    StodolaRitz,
    TimoshenkoElements,
    TimoshenkoRitz,
    mac,
    orthogonality,
    solve,
)
from hullvib.distortion import energy_split

GIRDER = Girder(
    [0, 20, 20, 70, 100],
    [3e4, 5e4, 9e4, 7e4, 1e4],
    [2e12, 8e12, 8e12, 9e12, 1e12],
    [4e9, 6e9, 6e9, 6e9, 3e9],
    [2e6] * 5,
    point_masses=[PointMass(12.0, 4e5, 3e6), PointMass(100.0, 1e5)],
)


@pytest.mark.parametrize(
    "method",
    [
        StodolaRitz(16, 2),
        StodolaRitz(16, 2, shear=True),
        Ritz(20),
        Ritz(24, basis="legendre"),
        TimoshenkoRitz(24),
        TimoshenkoRitz(12, basis="uniform"),
        FiniteElements(60, rotary_inertia=True),
        TimoshenkoElements(14),
        TimoshenkoElements(60),
    ],
    ids=str,
)
def test_galerkin_modes_are_orthogonal_in_their_own_theory(method):
    result = orthogonality(solve(GIRDER, method, modes=5))
    # the small eigenproblem is solved to round-off; stiffness of 60 elements carries (60)^4 of it
    assert np.abs(result.mass).max() < 1e-11
    assert np.abs(result.stiffness).max() < 1e-8
    assert result.largest == max(np.abs(result.mass).max(), np.abs(result.stiffness).max())


def test_the_residual_tells_when_something_is_left_out():
    modes = solve(GIRDER, TimoshenkoRitz(24), modes=3)
    assert orthogonality(modes).largest < 1e-10
    # without their rotary inertia the masses do not fit, without the shear energy the stiffnesses do not
    assert np.abs(np.diag(orthogonality(replace(modes, rotary=False)).mass)).max() > 1e-3
    bending_only = orthogonality(replace(modes, theory="Euler-Bernoulli")).stiffness
    assert np.diag(bending_only).min() < -0.05
    # frequencies that belong to other shapes
    wrong = replace(modes, angular_frequencies=modes.angular_frequencies * 1.01)
    assert np.diag(orthogonality(wrong).stiffness) == pytest.approx(np.full(3, 1.01**-2 - 1), rel=1e-6)


def test_the_papers_basis_is_told_by_no_residual_of_its_own():
    # modes of the incomplete set are orthogonal among themselves; only the rigid-body motions are not kept out
    modes = solve(GIRDER, Ritz(12, rigid_body=False), modes=3)
    assert orthogonality(modes).largest < 1e-10
    assert np.abs(modes.shear([100.0])).max() > 1e-3 * np.abs(modes.shear(np.linspace(0, 100, 50))).max()


def test_mac_of_a_set_with_itself_and_with_another_method():
    ritz, elements = solve(GIRDER, Ritz(24), modes=4), solve(GIRDER, FiniteElements(100), modes=3)
    own = mac(ritz, ritz)
    assert np.diag(own) == pytest.approx(np.ones(4), rel=1e-12)
    assert own == pytest.approx(own.T, abs=1e-14)
    cross = mac(ritz, elements)
    assert cross.shape == (4, 3)
    assert np.diag(cross) == pytest.approx(np.ones(3), abs=1e-5)
    # signs and scales do not matter
    assert mac(ritz.normalised("unit-modal-mass"), elements) == pytest.approx(cross, rel=1e-12)


def test_mac_of_the_uniform_beams_modes_is_the_unit_matrix():
    modes = solve(Girder([0, 1], [1, 1], [1, 1]), modes=5)
    assert mac(modes, modes) == pytest.approx(np.eye(5), abs=1e-12)


def test_mac_against_measured_amplitudes():
    modes = solve(GIRDER, modes=3)
    x = np.linspace(5, 95, 12)
    measured = -3.0 * modes.shape(x)[[1, 0]]
    table = mac(modes, measured, x)
    assert table.shape == (3, 2)
    assert [table[1, 0], table[0, 1]] == pytest.approx([1.0, 1.0], rel=1e-14)
    # by hand, from the definition
    a, b = modes.shape(x)[2], measured[0]
    assert table[2, 0] == pytest.approx((a @ b) ** 2 / ((a @ a) * (b @ b)), rel=1e-13)


def test_senseless_comparisons_are_refused():
    modes = solve(GIRDER, modes=2)
    other = solve(Girder([0, 99], [1, 1], [1, 1]), modes=2)
    with pytest.raises(ArgumentError, match="100 m and 99 m long"):
        mac(modes, other)
    with pytest.raises(ArgumentError, match="need x"):
        mac(modes, [1.0, 2.0])
    with pytest.raises(ArgumentError, match="leave it out"):
        mac(modes, modes, [1.0])
    with pytest.raises(ArgumentError, match=r"shape \(1, 2\), but x has 3 positions"):
        mac(modes, [1.0, 2.0], [1.0, 2.0, 3.0])
    with pytest.raises(ArgumentError, match="zero at every position"):
        mac(modes, [0.0, 0.0], [1.0, 2.0])


def test_energies_are_split_in_the_theory_of_the_modes():
    modes = solve(GIRDER, TimoshenkoRitz(24), modes=2)
    split = energy_split(modes, (0.0, 0.2, 1.0))
    # midpoint rule with cells on the jump at 20 m: (h g)^2 / 24
    x = (np.arange(10000) + 0.5) * 0.01
    strain = GIRDER.flexural_rigidity(x) * modes.bending_curvature(x) ** 2
    sheared = GIRDER.shear_rigidity(x) * modes.shear_strain(x) ** 2
    total = strain + sheared
    assert split.strain[:, 0] == pytest.approx(total[:, :2000].sum(axis=1) / total.sum(axis=1), rel=1e-5)
    assert (sheared.sum(axis=1) > 0.1 * strain.sum(axis=1)).all()
    moved = (GIRDER.mass_per_length(x) * modes.shape(x) ** 2 + 2e6 * modes.rotation(x) ** 2) * 0.01
    aft = 4e5 * modes.shape([12.0])[:, 0] ** 2 + 3e6 * modes.rotation([12.0])[:, 0] ** 2
    fore = 1e5 * modes.shape([100.0])[:, 0] ** 2
    expected = (moved[:, :2000].sum(axis=1) + aft) / (moved.sum(axis=1) + aft + fore)
    assert split.kinetic[:, 0] == pytest.approx(expected, rel=1e-5)
