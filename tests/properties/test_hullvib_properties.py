"""Laws that every girder obeys: scaling, mirror image, splitting, round trips, bounds."""

import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hullvib import FiniteElements, Girder, PointMass, Ritz, parse_girder, solve
from hullvib.girder_files import girder_csv, girder_json

SETTINGS = settings(max_examples=25, derandomize=True, deadline=None)
VALUES = st.floats(0.2, 5.0)


@st.composite
def tables(draw):
    """Columns of a table of up to 6 bays with jumps at will: x, m, EI."""
    bays = draw(st.integers(1, 6))
    widths = draw(st.lists(st.floats(0.2, 3.0), min_size=bays, max_size=bays))
    edges = np.concatenate([[0.0], np.cumsum(widths)])
    x, m, ei = [0.0], [draw(VALUES)], [draw(VALUES)]
    for i, edge in enumerate(edges[1:], 1):
        for _ in range(2 if i < bays and draw(st.booleans()) else 1):
            x.append(float(edge))
            m.append(draw(VALUES))
            ei.append(draw(VALUES))
    return np.array(x), np.array(m), np.array(ei)


@st.composite
def point_masses(draw, length):
    count = draw(st.integers(0, 3))
    return [PointMass(draw(st.floats(0.0, 1.0)) * length, draw(st.floats(0.0, 2.0))) for _ in range(count)]


@st.composite
def girders(draw):
    x, m, ei = draw(tables())
    return Girder(x, m, ei, point_masses=draw(point_masses(x[-1])), name=draw(st.text(max_size=5)))


METHOD = st.sampled_from([Ritz(10), FiniteElements(20), FiniteElements(60), Ritz(10, rigid_body=False)])


@SETTINGS
@given(tables(), METHOD, st.floats(1e-3, 1e3), st.floats(1e-6, 1e6), st.floats(1e-6, 1e14))
def test_frequencies_scale_with_length_mass_and_rigidity(table, method, length, mass, rigidity):
    x, m, ei = table
    plain = solve(Girder(x, m, ei), method, modes=3)
    scaled = solve(Girder(x * length, m * mass, ei * rigidity), method, modes=3)
    factor = np.sqrt(rigidity / mass) / length**2
    # sparse finite elements carry round-off of 1e-9, measured on the girders of data/bench_cases.json
    assert scaled.angular_frequencies == pytest.approx(plain.angular_frequencies * factor, rel=1e-8)
    assert scaled.modal_mass == pytest.approx(plain.modal_mass * mass * length, rel=1e-7)


@SETTINGS
@given(tables(), METHOD)
def test_the_mirror_image_has_the_same_frequencies(table, method):
    x, m, ei = table
    plain = solve(Girder(x, m, ei), method, modes=3)
    mirror = solve(Girder((x[-1] - x)[::-1], m[::-1], ei[::-1]), method, modes=3)
    # elements are shared out by length with ties broken from aft, so the mirror's mesh may differ by one element in 20
    tolerance = 1e-9 if isinstance(method, Ritz) else 2e-4
    assert mirror.angular_frequencies == pytest.approx(plain.angular_frequencies, rel=tolerance)


@SETTINGS
@given(girders(), st.lists(st.floats(0.05, 0.95), min_size=1, max_size=4))
def test_splitting_a_piece_changes_nothing(girder, cuts):
    finer = girder.refined(np.array(cuts) * girder.length)
    assert len(finer.breaks) >= len(girder.breaks)
    assert finer.total_mass == pytest.approx(girder.total_mass, rel=1e-13)
    assert finer.centre_of_gravity == pytest.approx(girder.centre_of_gravity, rel=1e-13)
    assert solve(finer).angular_frequencies == pytest.approx(solve(girder).angular_frequencies, rel=1e-11)


@SETTINGS
@given(girders())
def test_round_trips_keep_every_bit(girder):
    assert pickle.loads(pickle.dumps(girder)) == girder
    again = parse_girder(girder_json(girder))
    assert again == girder
    assert hash(again) == hash(girder)
    assert again.name == girder.name
    if not girder.point_masses:
        assert parse_girder(girder_csv(girder)) == girder


@SETTINGS
@given(girders())
def test_ritz_bounds_from_above_and_the_elastic_basis_interlaces(girder):
    ritz = solve(girder, Ritz(12), modes=5).angular_frequencies
    elastic = solve(girder, Ritz(12, rigid_body=False), modes=5).angular_frequencies
    fine = solve(girder, FiniteElements(300), modes=5).angular_frequencies
    # 300 elements are within 1e-6 above the exact answer
    assert (ritz > fine * (1 - 1e-6)).all()
    # two functions fewer: lambda_j(elastic only) lies between full eigenvalues j and j + 2, rigid ones counted
    assert (elastic <= ritz * (1 + 1e-10)).all()
    assert (elastic[2:] >= ritz[:-2] * (1 - 1e-10)).all()


@SETTINGS
@given(girders(), VALUES)
def test_more_mass_lowers_and_more_rigidity_raises_every_frequency(girder, amount):
    heavier = Girder.from_bernstein(
        girder.breaks,
        girder.mass_coefficients,
        girder.flexural_rigidity_coefficients,
        point_masses=[*girder.point_masses, PointMass(0.3 * girder.length, amount)],
    )
    stiffer = Girder.from_bernstein(
        girder.breaks,
        girder.mass_coefficients,
        girder.flexural_rigidity_coefficients + amount,
        point_masses=girder.point_masses,
    )
    # within one trial space both follow from Courant's principle; 1e-10 is round-off
    plain = solve(girder).angular_frequencies
    assert (solve(heavier).angular_frequencies <= plain * (1 + 1e-10)).all()
    assert (solve(stiffer).angular_frequencies > plain).all()


@SETTINGS
@given(girders())
def test_elastic_modes_are_free_of_net_momentum(girder):
    # an elastic mode of a free girder moves neither the centre of mass nor the angular momentum
    modes = solve(girder, Ritz(10), modes=4).normalised("unit-modal-mass")
    nodes, weights = np.polynomial.legendre.leggauss(24)
    widths = np.diff(girder.breaks)
    x = (girder.breaks[:-1, None] + widths[:, None] * (0.5 + 0.5 * nodes)).ravel()
    loaded = modes.shape(x) * (girder.mass_per_length(x) * (widths[:, None] * 0.5 * weights).ravel())
    momentum, angular = loaded.sum(axis=1), loaded @ x
    for point in girder.point_masses:
        shape = modes.shape([point.x_m])[:, 0] * point.mass_kg
        momentum, angular = momentum + shape, angular + shape * point.x_m
    size = np.sqrt(girder.total_mass)
    assert np.abs(momentum).max() < 1e-9 * size
    assert np.abs(angular).max() < 1e-9 * size * girder.length
