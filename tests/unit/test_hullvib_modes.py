"""The result object: normalisation, sign, nodes, modal mass; and the refusals of the methods."""

from dataclasses import replace

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
    TimoshenkoElements,
    TimoshenkoRitz,
    solve,
)

GIRDER = Girder(
    [0, 20, 20, 70, 100],
    [3e4, 5e4, 9e4, 7e4, 1e4],
    [2e12, 8e12, 8e12, 9e12, 1e12],
    point_masses=[PointMass(12.0, 4e5), PointMass(100.0, 1e5)],
)
METHODS = [Ritz(20), FiniteElements(200), FiniteElements(8)]


@pytest.mark.parametrize("method", METHODS, ids=str)
def test_default_shapes_reach_one_and_are_positive_aft(method):
    modes = solve(GIRDER, method, modes=4)
    x = np.linspace(0, 100, 20001)
    shape = modes.shape(x)
    # the grid misses a smooth maximum by (h g)^2 / 8 < 1e-6
    assert np.abs(shape).max(axis=1) == pytest.approx(np.ones(4), abs=1e-6)
    assert (shape[:, 0] > 0).all()


@pytest.mark.parametrize("method", METHODS, ids=str)
def test_modal_mass_is_the_integral(method):
    modes = solve(GIRDER, method, modes=4)
    # midpoint rule on a grid with points on the jumps: error (h g / L)^2 / 24 of the integrand < 1e-6
    x = (np.arange(20000) + 0.5) * 0.005
    spread = (GIRDER.mass_per_length(x) * modes.shape(x) ** 2).sum(axis=1) * 0.005
    points = 4e5 * modes.shape([12.0])[:, 0] ** 2 + 1e5 * modes.shape([100.0])[:, 0] ** 2
    assert modes.modal_mass == pytest.approx(spread + points, rel=1e-5)
    assert modes.modal_stiffness == pytest.approx(modes.angular_frequencies**2 * modes.modal_mass, rel=1e-15)
    unit = modes.normalised("unit-modal-mass")
    assert unit.modal_mass == pytest.approx(np.ones(4), rel=1e-13)
    assert unit.shape(x)[:, 0] == pytest.approx(modes.shape(x)[:, 0] / np.sqrt(modes.modal_mass), rel=1e-12)
    paper = modes.normalised("paper")
    assert (paper.shape(x) ** 2).sum(axis=1) * 0.005 == pytest.approx(np.full(4, 100.0), rel=1e-5)
    back = paper.normalised("largest-amplitude")
    assert back.modal_mass == pytest.approx(modes.modal_mass, rel=1e-13)
    assert "positive at the aft end" in back.normalisation_note


def test_the_papers_normalisation_gives_the_uniform_beam_two_at_the_end():
    modes = solve(Girder([0, 50], [1e3, 1e3], [1e10, 1e10])).normalised("paper")
    assert modes.shape([0.0])[:, 0] == pytest.approx(np.full(5, 2.0), rel=1e-12)


@pytest.mark.parametrize("method", METHODS, ids=str)
def test_the_largest_amplitude_may_lie_inside(method):
    # heavy ends pull the nodes of mode 1 to the ends, so that it moves most amidships
    girder = Girder([0, 1], [1, 1], [1, 1], point_masses=[PointMass(0, 10), PointMass(1, 10)])
    modes = solve(girder, method, modes=1)
    assert abs(modes.shape([0.5])[0, 0]) == pytest.approx(1.0, rel=1e-9)
    assert 0 < modes.shape([0.0])[0, 0] < 0.2


def test_nodes_and_antinodes_of_the_uniform_beam():
    modes = solve(Girder([0, 1], [1, 1], [1, 1]), modes=3)
    # Blevins, table 8-1, case 1, nodal points x/L of the free-free beam: 0.224 0.776 | 0.132 0.5 0.868 | 0.094 ...
    nodes = modes.nodes()
    assert nodes[0] == pytest.approx([0.224, 0.776], abs=5e-4)
    assert nodes[1] == pytest.approx([0.132, 0.500, 0.868], abs=5e-4)
    assert nodes[2] == pytest.approx([0.0944, 0.3558, 0.6442, 0.9056], abs=5e-5)
    assert modes.node_counts.tolist() == [2, 3, 4]
    assert modes.antinodes()[0] == pytest.approx([0.5], abs=1e-12)
    for zeros, shape in zip(nodes, range(3), strict=True):
        assert np.abs(modes.shape(zeros)[shape]).max() < 1e-12
    for zeros, shape in zip(modes.antinodes(), range(3), strict=True):
        assert np.abs(modes.slope(zeros)[shape]).max() < 1e-11


@pytest.mark.parametrize("method", METHODS, ids=str)
def test_slope_and_curvature_are_the_derivatives(method):
    modes = solve(GIRDER, method, modes=3)
    x, h = np.linspace(1.3, 98.7, 50), 1e-3
    slope = (modes.shape(x + h) - modes.shape(x - h)) / (2 * h)
    assert np.abs(modes.slope(x) - slope).max() < 1e-6 * np.abs(slope).max()
    curvature = (modes.slope(x + h) - modes.slope(x - h)) / (2 * h)
    # a cubic element's curvature jumps at nodes, of which the grid may hit a few within h
    assert np.median(np.abs(modes.curvature(x) - curvature)) < 1e-6 * np.abs(curvature).max()
    # sections of an Euler-Bernoulli beam turn by the slope
    assert np.array_equal(modes.rotation(x), modes.slope(x))
    assert np.array_equal(modes.bending_curvature(x), modes.curvature(x))


def test_units_and_records():
    modes = solve(GIRDER, FiniteElements(7), modes=2)
    assert modes.cycles_per_minute == pytest.approx(60 * modes.frequencies_hz, rel=1e-14)
    assert modes.frequencies_hz == pytest.approx(modes.angular_frequencies / (2 * np.pi), rel=1e-15)
    assert (modes.theory, modes.medium) == ("Euler-Bernoulli", "dry")
    assert modes.method == {"method": "finite_element", "elements": 7, "solver": "dense"}
    assert solve(GIRDER, Ritz()).method == {"method": "ritz", "functions": 12, "rigid_body": True}
    # three pieces, cut once more by the point mass at 12 m
    assert solve(GIRDER, FiniteElements(1), modes=2).method["elements"] == 4


def test_dense_and_sparse_solutions_agree():
    # 60 unknowns are solved densely, 62 sparsely; both against the fine answer, at their own h^4 error
    fine = solve(GIRDER, FiniteElements(400), modes=3).angular_frequencies
    for elements, solver in ((29, "dense"), (30, "sparse shift-invert")):
        modes = solve(GIRDER, FiniteElements(elements), modes=3)
        assert modes.method["solver"] == solver
        assert modes.angular_frequencies == pytest.approx(fine, rel=1e-4)


@pytest.mark.parametrize("method", [Ritz(), FiniteElements(20), FiniteElements(100)], ids=str)
def test_a_massless_bay_is_solved(method):
    girder = Girder([0, 4, 4, 6, 6, 10], [2, 2, 0, 0, 1, 1], [5, 5, 1, 1, 5, 5])
    reference = Girder([0, 4, 4, 6, 6, 10], [2, 2, 1e-9, 1e-9, 1, 1], [5, 5, 1, 1, 5, 5])
    assert solve(girder, method).angular_frequencies == pytest.approx(
        solve(reference, method).angular_frequencies, rel=1e-7
    )


@pytest.mark.parametrize("method", [Ritz(), FiniteElements(20), FiniteElements(100)], ids=str)
def test_three_masses_on_a_massless_girder_have_one_elastic_mode(method):
    girder = Girder([0, 2], [0, 0], [3, 3], point_masses=[PointMass(x, 1.0) for x in (0, 1, 2)])
    modes = solve(girder, method, modes=1)
    # m, m, m at distance l: w = (1, -2, 1) a / 6 ...; stiffness of the three-point bend 48 EI / (2 l)^3 on the
    # deflection of the middle against the ends, reduced mass m (2 m) / (3 m): omega^2 = 6 EI / l^3 * 3 / (2 m)
    exact = np.sqrt(6 * 3 * 3 / 2)
    # cubic elements hold the exact shape; uniform modes have no kink of the moment at midships: N^-3
    tolerance = 1e-9 if isinstance(method, FiniteElements) else 5e-3
    assert modes.angular_frequencies == pytest.approx([exact], rel=tolerance)
    with pytest.raises(SolutionError, match="only 1 elastic modes"):
        solve(girder, method, modes=2)


@pytest.mark.parametrize("method", [Ritz(), FiniteElements(20), FiniteElements(100)], ids=str)
def test_masses_at_one_or_two_points_have_no_elastic_mode(method):
    girder = Girder([0, 2], [0, 0], [3, 3], point_masses=[PointMass(0.5, 1.0)])
    with pytest.raises(SolutionError, match="one point"):
        solve(girder, method)
    girder = Girder([0, 2], [0, 0], [3, 3], point_masses=[PointMass(0.5, 1.0), PointMass(2.0, 3.0)])
    with pytest.raises(SolutionError, match="only 0 elastic modes"):
        solve(girder, method)


def test_senseless_arguments_are_refused():
    with pytest.raises(ArgumentError, match="functions is 0"):
        Ritz(0)
    with pytest.raises(ArgumentError, match="elements is 0"):
        FiniteElements(0)
    with pytest.raises(ArgumentError, match="6 modes were asked of 5"):
        solve(GIRDER, Ritz(5), modes=6)
    with pytest.raises(ArgumentError, match="0 modes"):
        solve(GIRDER, modes=0)
    with pytest.raises(ArgumentError, match="13 modes were asked of 5 elements"):
        solve(GIRDER, FiniteElements(5), modes=13)
    modes = solve(GIRDER)
    with pytest.raises(ArgumentError, match="within 0"):
        modes.shape([101.0])
    with pytest.raises(ArgumentError, match="not known"):
        modes.normalised("rms")


@pytest.mark.parametrize("method", [Ritz, StodolaRitz, TimoshenkoRitz])
@pytest.mark.parametrize("functions", [12.5, 12.0, "12", None, True, 0, 401])
def test_a_number_of_functions_that_is_not_whole_is_refused(method, functions):
    with pytest.raises(ArgumentError, match="functions is"):
        method(functions=functions)


@pytest.mark.parametrize("method", [FiniteElements, TimoshenkoElements])
@pytest.mark.parametrize("elements", [12.5, "12", True, 0, 10001])
def test_a_number_of_elements_that_is_not_whole_is_refused(method, elements):
    with pytest.raises(ArgumentError, match="elements is"):
        method(elements=elements)


def test_numpys_whole_numbers_are_whole_and_half_a_mode_is_none():
    assert len(solve(GIRDER, Ritz(np.int64(8)), modes=np.int32(2)).angular_frequencies) == 2
    with pytest.raises(ArgumentError, match=r"2\.5 modes"):
        solve(GIRDER, modes=2.5)


def test_the_arrays_of_a_result_cannot_be_written_to():
    modes = solve(GIRDER, modes=2)
    for array in (modes.angular_frequencies, modes.modal_mass, modes.scale):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0


@pytest.mark.parametrize("key", ["angular_frequencies", "modal_mass", "scale"])
@pytest.mark.parametrize("value", [0.0, np.nan, np.inf])
def test_a_result_that_is_no_number_is_refused(key, value):
    modes = solve(GIRDER, modes=2)
    with pytest.raises(SolutionError, match="too large or too"):
        replace(modes, **{key: np.array([1.0, value])})
