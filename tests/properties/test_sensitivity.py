"""Sensitivities against finite differences of solutions with a little more mass or rigidity on a short stretch."""

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
    solve,
)
from hullvib.sensitivity import (
    mass_sensitivity,
    rigidity_sensitivity,
    rotary_inertia_sensitivity,
    shear_rigidity_sensitivity,
)

X = np.array([0, 20, 30, 40, 40, 70, 72, 100.0])
COLUMNS = {
    "mass": np.array([3e4, 5e4, 5e4, 5e4, 9e4, 7e4, 6.6e4, 1e4]),
    "rigidity": np.array([2e12, 8e12, 8e12, 8e12, 3e12, 9e12, 8.4e12, 1e12]),
    "shear": np.array([4e9, 6e9, 6e9, 6e9, 6e9, 6e9, 5.8e9, 3e9]),
    "rotary": np.array([1e6, 2e6, 2e6, 2e6, 2e6, 2e6, 2e6, 1e6]),
}
CURVES = {
    "mass": mass_sensitivity,
    "rigidity": rigidity_sensitivity,
    "shear": shear_rigidity_sensitivity,
    "rotary": rotary_inertia_sensitivity,
}
POINTS = [PointMass(55.0, 3e5, 1e6)]


def girder(key="", factor=0.0, bay=(1, 2)):
    """The girder with one property raised by a constant share of its largest value over one bay (rows of X)."""
    columns = {name: [list(rows)] for name, rows in COLUMNS.items()}
    x = list(X)
    aft, fore = bay
    added = factor * COLUMNS[key].max() if key else 0.0
    for name, (rows,) in columns.items():
        extra = added if name == key else 0.0
        inside = [rows[aft] + extra, *(rows[i] + extra for i in range(aft + 1, fore)), rows[fore] + extra]
        columns[name] = rows[: aft + 1] + inside + rows[fore:]
    x = x[: aft + 1] + x[aft : fore + 1] + x[fore:]
    return Girder(x, *(columns[name] for name in ("mass", "rigidity", "shear", "rotary")), POINTS), added


def predicted(curve, modes, bay):
    """Integral of a curve over the bay by Gauss's rule."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    left, right = X[bay[0]], X[bay[1]]
    half = 0.5 * (right - left)
    return curve(modes, left + half * (1 + nodes)) @ weights * half


@pytest.mark.parametrize("bay", [(1, 2), (5, 6)], ids=["20-30 m", "70-72 m"])
@pytest.mark.parametrize(
    ("method", "keys", "tolerance"),
    [
        (StodolaRitz(12, 2), ("mass", "rigidity"), 1e-5),
        (StodolaRitz(16, 2, shear=True), ("mass", "rigidity", "shear"), 1e-4),
        (FiniteElements(100), ("mass", "rigidity"), 1e-3),
        (Ritz(60, basis="legendre"), ("mass", "rigidity"), 1e-5),
        (TimoshenkoRitz(60), ("mass", "rigidity", "shear", "rotary"), 1e-4),
        (TimoshenkoElements(200), ("mass", "rigidity", "shear", "rotary"), 1e-3),
    ],
    ids=str,
)
def test_curves_are_the_differences(method, keys, tolerance, bay):
    modes = solve(girder()[0], method, modes=3)
    for key in keys:
        (more, added), (less, _) = girder(key, 1e-3, bay), girder(key, -1e-3, bay)
        found = (solve(more, method, 3).angular_frequencies - solve(less, method, 3).angular_frequencies) / 2
        expected = predicted(CURVES[key], modes, bay) * added
        # central differences of a change of 1e-3 on a part of the beam: third-order terms of 1e-6; the rest is what
        # the method leaves in moments and strains: spectral for series (few functions on 2 m), h^2 for elements
        scale = np.abs(predicted(CURVES[key], modes, (0, 1)) * added).max()
        assert found == pytest.approx(expected, rel=tolerance, abs=1e-6 * scale + 1e-9)
        sign = -1.0 if key in ("mass", "rotary") else 1.0
        assert (sign * expected > 0).all()


def test_a_point_mass_lowers_by_the_curve():
    plain = girder()[0]
    modes = solve(plain, StodolaRitz(12, 2), modes=3)
    heavier = Girder.from_bernstein(
        plain.breaks,
        plain.mass_coefficients,
        plain.flexural_rigidity_coefficients,
        point_masses=[*POINTS, PointMass(64.0, 1e3)],
    )
    found = solve(heavier, StodolaRitz(12, 2), modes=3).angular_frequencies - modes.angular_frequencies
    # a tonne in 6000: the second order is 1e-4 of the first, more near a node
    assert found == pytest.approx(1e3 * mass_sensitivity(modes, [64.0])[:, 0], rel=2e-3)


def test_mass_at_a_node_and_normalisations_do_not_matter():
    modes = solve(girder()[0], StodolaRitz(12, 2), modes=2)
    nodes = modes.nodes()[1]
    assert np.abs(mass_sensitivity(modes, nodes)[1]).max() < 1e-20
    x = np.linspace(0, 100, 11)
    for curve in (mass_sensitivity, rigidity_sensitivity, rotary_inertia_sensitivity):
        assert curve(modes.normalised("paper"), x) == pytest.approx(curve(modes, x), rel=1e-11)


def test_scaling_all_mass_or_all_rigidity_adds_up():
    # omega falls with m^(-1/2) and rises with EI^(1/2): the curves' integrals with m and EI are -+ omega / 2
    plain = girder()[0]
    modes = solve(plain, StodolaRitz(12, 2), modes=3)
    x = (np.arange(20000) + 0.5) * 0.005
    mass = (mass_sensitivity(modes, x) * plain.mass_per_length(x)).sum(axis=1) * 0.005
    mass += mass_sensitivity(modes, [55.0])[:, 0] * 3e5
    rigidity = (rigidity_sensitivity(modes, x) * plain.flexural_rigidity(x)).sum(axis=1) * 0.005
    # the midpoint rule with jumps on cell edges: (h g)^2 / 24
    assert mass == pytest.approx(-0.5 * modes.angular_frequencies, rel=1e-6)
    assert rigidity == pytest.approx(0.5 * modes.angular_frequencies, rel=1e-6)


def test_a_sharp_end_has_the_limit_of_the_curve():
    wedge = Girder.from_polynomials([0, 1], [[1, -1]], [[1, -3, 3, -1]])
    modes = solve(wedge, Ritz(16, basis="legendre"), modes=2)
    near, end = rigidity_sensitivity(modes, [0.999])[:, 0], rigidity_sensitivity(modes, [1.0])[:, 0]
    # the curvature is finite and smooth there: 1e-3 of its relative slope, some ten
    assert end == pytest.approx(near, rel=5e-2)


def test_shear_plays_no_part_in_bernoullis_beam():
    with pytest.raises(ArgumentError, match="shear rigidity plays no part"):
        shear_rigidity_sensitivity(solve(girder()[0], Ritz(12)), [5.0])
