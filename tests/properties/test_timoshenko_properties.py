"""Laws that Timoshenko's beam obeys as solved here: scaling, mirror image, splitting, bounds, monotonicity."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hullvib import FiniteElements, Girder, PointMass, Ritz, TimoshenkoElements, TimoshenkoRitz, orthogonality, solve

SETTINGS = settings(max_examples=15, derandomize=True, deadline=None)
VALUES = st.floats(0.3, 3.0)
METHOD = st.sampled_from([TimoshenkoRitz(24), TimoshenkoElements(16), TimoshenkoElements(40)])


@st.composite
def columns(draw):
    """x and columns m, EI, kGA, J of up to four bays with jumps, length about 1 .. 8, and point masses."""
    bays = draw(st.integers(1, 4))
    widths = draw(st.lists(st.floats(0.3, 2.0), min_size=bays, max_size=bays))
    x = np.repeat(np.concatenate([[0.0], np.cumsum(widths)]), 2)[1:-1]
    size = 2 * bays
    m, ei, kga, j = (np.array(draw(st.lists(VALUES, min_size=size, max_size=size))) for _ in range(4))
    # on a breakpoint or well clear of it: finite elements refuse bays of less than 9e-6 of the length
    places = x[-1] * np.array(draw(st.lists(st.integers(0, 1000), max_size=2)), dtype=float) / 1000
    nearest = [x[np.abs(x - place).argmin()] for place in places]
    places = [near if abs(place - near) < 5e-4 * x[-1] else place for place, near in zip(places, nearest, strict=True)]
    points = [(place, draw(st.floats(0.1, 1.0)), draw(st.floats(0.0, 0.1))) for place in places]
    return x, m, ei, 60 * kga, 0.01 * j, points


def girder(x, m, ei, kga, j, points):
    return Girder(x, m, ei, kga, j, [PointMass(*point) for point in points])


@SETTINGS
@given(columns(), METHOD, st.floats(1e-2, 1e3), st.floats(1e-6, 1e6), st.floats(1e-6, 1e14))
def test_frequencies_scale(given_columns, method, length, mass, rigidity):
    x, m, ei, kga, j, points = given_columns
    plain = solve(girder(x, m, ei, kga, j, points), method, modes=3)
    moved = [(place * length, p * mass * length, r * mass * length**3) for place, p, r in points]
    scaled = girder(x * length, m * mass, ei * rigidity, kga * rigidity / length**2, j * mass * length**2, moved)
    factor = np.sqrt(rigidity / mass) / length**2
    # round-off of matrices of at most 96 and of 40 elements
    assert solve(scaled, method, 3).angular_frequencies == pytest.approx(plain.angular_frequencies * factor, rel=1e-8)


@SETTINGS
@given(columns(), METHOD)
def test_the_mirror_image_sounds_the_same(given_columns, method):
    x, m, ei, kga, j, points = given_columns
    there = solve(girder(x, m, ei, kga, j, points), method, modes=3)
    back = [(x[-1] - place, *rest) for place, *rest in points]
    mirrored = girder((x[-1] - x)[::-1], m[::-1], ei[::-1], kga[::-1], j[::-1], back)
    # who gets the odd function or element of two equal stretches may differ, so the answer does, at its own error
    assert solve(mirrored, method, 3).angular_frequencies == pytest.approx(there.angular_frequencies, rel=2e-3)


@SETTINGS
@given(columns(), st.floats(0.01, 0.99))
def test_splitting_a_bay_changes_nothing(given_columns, share):
    plain = girder(*given_columns)
    split = plain.refined([share * plain.length])
    for method in (TimoshenkoRitz(20), TimoshenkoRitz(12, basis="uniform")):
        # the breakpoint that changes nothing parts no stretch
        expected = solve(plain, method, modes=3).angular_frequencies
        assert solve(split, method, modes=3).angular_frequencies == pytest.approx(expected, rel=1e-9)


@SETTINGS
@given(columns())
def test_upper_bounds_fall_and_both_methods_meet(given_columns):
    plain = girder(*given_columns)
    coarse, fine = (solve(plain, TimoshenkoElements(n), modes=3).angular_frequencies for n in (25, 200))
    assert (coarse >= fine * (1 - 1e-9)).all()
    # two more elements a point mass or bay than asked for; (g h)^4 / 720 at g about 14, h = 1 / 25: 1.4e-4
    assert fine == pytest.approx(coarse, rel=3e-3)
    ritz = solve(plain, TimoshenkoRitz(60), modes=3).angular_frequencies
    # at least eight polynomials on each of at most six stretches
    assert ritz == pytest.approx(fine, rel=1e-4)


@SETTINGS
@given(columns(), METHOD)
def test_shear_and_rotary_inertia_lower_and_modes_are_orthogonal(given_columns, method):
    x, m, ei, kga, j, points = given_columns
    plain = girder(*given_columns)
    modes = solve(plain, method, modes=3)
    assert orthogonality(modes).largest < 1e-8
    stiffer = solve(girder(x, m, ei, 2 * kga, j, points), method, modes=3).angular_frequencies
    heavier = solve(girder(x, m, ei, kga, 2 * j, points), method, modes=3).angular_frequencies
    assert (stiffer > modes.angular_frequencies).all()
    assert (heavier < modes.angular_frequencies).all()
    bernoulli = Ritz(24, basis="legendre") if isinstance(method, TimoshenkoRitz) else FiniteElements(method.elements)
    assert (solve(plain, bernoulli, modes=3).angular_frequencies > modes.angular_frequencies).all()
