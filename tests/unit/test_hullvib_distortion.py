"""Distortion of the modes: weights, shifts, energies, correlations, convergence study."""

import numpy as np
import pytest

from hullvib import ArgumentError, FiniteElements, Girder, PointMass, Ritz, distortion, solve

UNIFORM = Girder([0, 80], [2e4, 2e4], [3e12, 3e12])
HULL = Girder([0, 16, 72, 80], [4e4, 9e4, 2e4, 1e4], [1e12, 6e12, 3e12, 5e11])


def test_a_uniform_beam_is_not_distorted():
    modes = solve(UNIFORM, Ritz())
    weights = distortion.weight_vectors(modes)
    assert np.abs(weights - np.eye(5, 12)).max() < 1e-10
    assert (distortion.diagonal_dominance(weights) > 1e9).all()
    for shift in [*distortion.node_shifts(modes), *distortion.antinode_shifts(modes)]:
        assert np.abs(shift.shift).max() < 1e-9 * 80
    # (g_j L)^2, Blevins table 8-1; half a unit of the last of nine digits is 2.2e-9 of the first
    expected = [22.3732854, 61.6728229, 120.9033917, 199.8594481, 298.5555353]
    assert distortion.nondimensional_frequencies(modes) == pytest.approx(expected, rel=3e-9)
    correlation = distortion.spatial_correlation(modes)
    assert correlation.mass.tolist() == [0.0] * 5
    assert correlation.rigidity.tolist() == [0.0] * 5


def test_weights_reproduce_the_shape():
    modes = solve(HULL, Ritz(14, rigid_body=False), modes=3)
    from hullvib.uniform_beam import uniform_modes

    x = np.linspace(0, 80, 301)
    weights = distortion.weight_vectors(modes)
    series = weights @ uniform_modes(x / 80, 14)[0]
    shape = modes.shape(x)
    assert series / series[:, :1] == pytest.approx(shape / shape[:, :1], abs=1e-11)
    assert np.abs(weights).max(axis=1).tolist() == [1.0] * 3
    assert distortion.diagonal_dominance(np.array([[4.0, -1.0, 1.0], [0.5, 1.0, 0.0]])).tolist() == [2.0, 2.0]
    assert distortion.diagonal_dominance(np.eye(2)).tolist() == [np.inf, np.inf]
    with pytest.raises(ArgumentError, match="Ritz method only"):
        distortion.weight_vectors(solve(HULL, FiniteElements(20)))


def test_a_heavy_stern_draws_the_aft_node_aft():
    # the node nearest to a heavy end moves towards it
    modes = solve(Girder([0, 80], [2e4, 2e4], [3e12, 3e12], point_masses=[PointMass(0, 8e5)]))
    shift = distortion.node_shifts(modes)[0]
    assert shift.shift[0] < -1.0
    assert distortion.Shift(np.array([1.0]), np.array([1.0, 2.0])).shift is None


def test_energy_shares_add_up_and_match_the_uniform_beams_symmetry():
    split = distortion.energy_split(solve(UNIFORM), bounds=(0.0, 0.5, 1.0))
    assert split.kinetic == pytest.approx(np.full((5, 2), 0.5), abs=1e-12)
    assert split.strain == pytest.approx(np.full((5, 2), 0.5), abs=1e-12)
    hull = distortion.energy_split(solve(HULL))
    assert hull.bounds_m.tolist() == pytest.approx([0, 16, 72, 80])
    assert hull.kinetic.sum(axis=1) == pytest.approx(np.ones(5), rel=1e-14)
    with pytest.raises(ArgumentError, match="ascend from 0 to 1"):
        distortion.energy_split(solve(HULL), bounds=(0.0, 0.7))


@pytest.mark.parametrize("method", [Ritz(), FiniteElements(60)], ids=str)
def test_energies_match_a_fine_sum(method):
    girder = Girder(HULL.breaks, [4e4, 9e4, 2e4, 1e4], [1e12, 6e12, 3e12, 5e11], point_masses=[PointMass(80, 3e5)])
    modes = solve(girder, method, modes=3)
    split = distortion.energy_split(modes)
    x = (np.arange(40000) + 0.5) * (80 / 40000)
    kinetic = girder.mass_per_length(x) * modes.shape(x) ** 2 * (80 / 40000)
    point = 3e5 * modes.shape([80.0])[:, 0] ** 2
    total = kinetic.sum(axis=1) + point
    assert split.kinetic[:, 0] == pytest.approx(kinetic[:, x < 16].sum(axis=1) / total, rel=1e-5)
    assert split.kinetic[:, 2] == pytest.approx((kinetic[:, x > 72].sum(axis=1) + point) / total, rel=1e-5)
    strain = girder.flexural_rigidity(x) * modes.curvature(x) ** 2
    # a cubic element's curvature is a broken line, which the rule's cells cut at places of their own
    assert split.strain[:, 1] == pytest.approx(
        strain[:, (x > 16) & (x < 72)].sum(axis=1) / strain.sum(axis=1), rel=1e-3
    )
    curve = distortion.cumulative_energy(modes, [0.0, 16.0, 79.999, 80.0])
    assert curve.kinetic[:, 1] == pytest.approx(split.kinetic[:, 0], rel=1e-9)
    assert curve.kinetic[:, 3] == pytest.approx(np.ones(3), rel=1e-12)
    assert (curve.kinetic[:, 2] < 1 - 0.9 * point / total).all()
    assert curve.strain[:, [0, 3]] == pytest.approx(np.tile([0.0, 1.0], (3, 1)), abs=1e-12)
    with pytest.raises(ArgumentError, match="within"):
        distortion.cumulative_energy(modes, [81.0])


def test_correlation_is_pearsons():
    modes = solve(HULL)
    correlation = distortion.spatial_correlation(modes, with_uniform_modes=False)
    x = (np.arange(40000) + 0.5) * (80 / 40000)
    for n in range(3):
        mass = np.corrcoef(HULL.mass_per_length(x), modes.shape(x)[n] ** 2)[0, 1]
        rigidity = np.corrcoef(HULL.flexural_rigidity(x), modes.curvature(x)[n] ** 2)[0, 1]
        assert correlation.mass[n] == pytest.approx(mass, abs=1e-6)
        assert correlation.rigidity[n] == pytest.approx(rigidity, abs=1e-6)
    # a hull is light and slender at the ends, where mode 1 moves most and bends least
    uniform = distortion.spatial_correlation(modes)
    assert uniform.mass[0] < 0 < uniform.rigidity[0]


@pytest.mark.parametrize("rigid_body", [True, False])
def test_the_convergence_study_equals_separate_solutions(rigid_body):
    table = distortion.ritz_convergence(HULL, range(4, 13), rigid_body=rigid_body)
    assert table.shape == (9, 3)
    for row, n in zip(table, range(4, 13), strict=True):
        assert row == pytest.approx(solve(HULL, Ritz(n, rigid_body), modes=3).angular_frequencies, rel=1e-11)
    with pytest.raises(ArgumentError, match="3 modes were asked"):
        distortion.ritz_convergence(HULL, [2, 4])
