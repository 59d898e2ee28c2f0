"""Laws that Stodola-Ritz keeps for every girder: scaling, mirror image, splitting, monotony, interlacing."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hullvib import Girder, PointMass, StodolaRitz, solve

SETTINGS = settings(max_examples=40, derandomize=True, deadline=None)
VALUES = st.floats(0.2, 5.0)


@st.composite
def girders(draw):
    """1 to 6 bays of lines with jumps at every breakpoint, and up to three point masses anywhere."""
    bays = draw(st.integers(1, 6))
    edges = np.concatenate([[0.0], np.cumsum(draw(st.lists(st.floats(0.2, 3.0), min_size=bays, max_size=bays)))])
    x = np.repeat(edges, 2)[1:-1]
    columns = [draw(st.lists(VALUES, min_size=2 * bays, max_size=2 * bays)) for _ in range(2)]
    places = draw(st.lists(st.tuples(st.floats(0.0, 1.0), st.floats(0.0, 2.0)), max_size=3))
    return Girder(x, *columns, point_masses=[PointMass(place * edges[-1], mass) for place, mass in places])


def remade(girder: Girder, length: float = 1.0, mass: float = 1.0, rigidity: float = 1.0, **more) -> Girder:
    points = [PointMass(p.x_m * length, p.mass_kg * mass * length) for p in girder.point_masses]
    return Girder.from_bernstein(
        girder.breaks * length,
        girder.mass_coefficients * mass,
        girder.flexural_rigidity_coefficients * rigidity,
        point_masses=[*points, *more.get("points", [])],
    )


@SETTINGS
@given(girders(), st.floats(1e-3, 1e3), st.floats(1e-6, 1e6), st.floats(1e-6, 1e14))
def test_scaling(girder, length, mass, rigidity):
    plain = solve(girder, modes=4).angular_frequencies
    scaled = solve(remade(girder, length, mass, rigidity), modes=4).angular_frequencies
    # round-off alone
    assert scaled == pytest.approx(plain * np.sqrt(rigidity / mass) / length**2, rel=1e-11)


@SETTINGS
@given(girders())
def test_mirror_image(girder):
    length = girder.length
    mirror = Girder.from_bernstein(
        (length - girder.breaks)[::-1] + 0.0,
        girder.mass_coefficients[::-1, ::-1],
        girder.flexural_rigidity_coefficients[::-1, ::-1],
        point_masses=[PointMass(min(max(length - p.x_m, 0.0), length), p.mass_kg) for p in girder.point_masses],
    )
    plain, turned = solve(girder, modes=4), solve(mirror, modes=4)
    assert turned.angular_frequencies == pytest.approx(plain.angular_frequencies, rel=1e-10)


@SETTINGS
@given(girders(), st.lists(st.floats(0.05, 0.95), min_size=1, max_size=4))
def test_splitting_changes_nothing(girder, cuts):
    finer = girder.refined(np.array(cuts) * girder.length)
    # the number of points follows the cells, and leaves 1e-12 at most
    assert solve(finer, modes=4).angular_frequencies == pytest.approx(
        solve(girder, modes=4).angular_frequencies, rel=1e-10
    )


@SETTINGS
@given(girders(), st.floats(0.0, 1.0), VALUES)
def test_mass_lowers_rigidity_raises_and_one_mass_interlaces(girder, place, amount):
    fine = StodolaRitz(16, 3)
    plain = solve(girder, fine, modes=5).angular_frequencies
    heavier = solve(remade(girder, points=[PointMass(place * girder.length, amount)]), fine, modes=5)
    # modes 1 to 5 of 16 functions after three steps: 1e-8 where a heavy mass stands between jumps
    assert (heavier.angular_frequencies <= plain * (1 + 1e-8)).all()
    # one point mass is one constraint's worth: lambda_(j) falls to lambda_(j - 1) of the lighter girder at most
    assert (heavier.angular_frequencies[1:] >= plain[:-1] * (1 - 1e-8)).all()
    stiffer = solve(remade(girder, rigidity=1.0 + 0.1 * amount), fine, modes=5).angular_frequencies
    assert stiffer == pytest.approx(plain * np.sqrt(1.0 + 0.1 * amount), rel=1e-11)
    locally = girder.flexural_rigidity_coefficients.copy()
    locally[0] += amount
    partly = Girder.from_bernstein(girder.breaks, girder.mass_coefficients, locally, point_masses=girder.point_masses)
    assert (solve(partly, fine, modes=5).angular_frequencies >= plain * (1 - 1e-8)).all()


@SETTINGS
@given(girders())
def test_upper_bounds_fall_with_the_functions(girder):
    rows = [solve(girder, StodolaRitz(n, 1), modes=4).angular_frequencies for n in (6, 9, 13)]
    for more, fewer in ((rows[1], rows[0]), (rows[2], rows[1])):
        # one step on nested sets gives nested sets; 1e-10 is what quadrature leaves of the shortest waves
        assert (more <= fewer * (1 + 1e-10)).all()


@SETTINGS
@given(girders())
def test_shapes_are_orthogonal_and_free_of_momentum(girder):
    modes = solve(girder, modes=4).normalised("unit-modal-mass")
    edges = np.union1d(girder.breaks, [p.x_m for p in girder.point_masses])
    edges = np.union1d(edges, np.linspace(0, girder.length, 11))
    nodes, weights = np.polynomial.legendre.leggauss(12)
    widths = np.diff(edges)
    x = (edges[:-1, None] + widths[:, None] * (0.5 + 0.5 * nodes)).ravel()
    loaded = modes.shape(x) * (girder.mass_per_length(x) * (widths[:, None] * 0.5 * weights).ravel())
    at = np.array([p.x_m for p in girder.point_masses])
    heavy = modes.shape(at) * [p.mass_kg for p in girder.point_masses] if len(at) else np.zeros((4, 0))
    shapes = modes.shape(at) if len(at) else np.zeros((4, 0))
    gram = loaded @ modes.shape(x).T + heavy @ shapes.T
    assert gram == pytest.approx(np.eye(4), abs=1e-9)
    assert np.abs(loaded.sum(axis=1) + heavy.sum(axis=1)).max() < 1e-9 * np.sqrt(girder.total_mass)
    assert np.abs(loaded @ x + heavy @ at).max() < 1e-9 * np.sqrt(girder.total_mass) * girder.length
