"""Shear force and bending moment of a box barge against closed forms, and of ragged loads against their balance."""

import numpy as np
import pytest
from box_barge import BREADTH_M, LENGTH_M, box_barge

from hullform.loading.distributions import Distribution, uniform
from hullform.loading.gravity import GRAVITY_M_S2
from hullform.loading.still_water import StillWater, sampled, still_water

DENSITY = 1000.0
MASS = DENSITY * LENGTH_M * BREADTH_M * 3.0
WEIGHT = MASS * GRAVITY_M_S2


def loaded(*items: Distribution, stations: int = 41) -> StillWater:
    hull = box_barge(stations)
    mass = sum(item.mass_kg for item in items)
    centre = sum(item.moment_kg_m for item in items) / mass
    return still_water(hull, items, hull.equilibrium(mass, centre, DENSITY).waterline, DENSITY)


def test_a_load_that_lies_as_she_is_buoyed_bends_her_not_at_all() -> None:
    found = loaded(uniform("cargo", MASS, 0.0, LENGTH_M))
    # round-off of two hundred sums, and far below the moment of a load over a part of her
    assert found.moment_extremes.size < 1e-12 * WEIGHT * LENGTH_M / 8
    assert found.shear_extremes.size < 1e-12 * WEIGHT


# 41 stations stand where the load ends, 38 do not
@pytest.mark.parametrize("stations", [41, 38])
def test_a_load_over_the_middle_half_sags_by_a_sixteenth(stations: int) -> None:
    found = loaded(uniform("cargo", MASS, LENGTH_M / 4, 3 * LENGTH_M / 4), stations=stations)
    # dM/dx = V, V = -w x up to the load and back to nought amidships; M = -W L / 16 there
    assert found.moment_extremes.least == pytest.approx(-WEIGHT * LENGTH_M / 16, rel=1e-6)
    assert found.moment_extremes.least_x_m == pytest.approx(LENGTH_M / 2, rel=1e-6)
    assert found.shear_extremes.least == pytest.approx(-WEIGHT / 4, rel=1e-6)
    assert found.shear_extremes.least_x_m == pytest.approx(LENGTH_M / 4, rel=1e-9)
    assert found.shear_extremes.greatest == pytest.approx(WEIGHT / 4, rel=1e-6)
    assert found.moment_residual < 1e-12


def test_loads_at_both_ends_hog_her() -> None:
    ends = uniform("aft", MASS / 2, 0.0, LENGTH_M / 4), uniform("fore", MASS / 2, 3 * LENGTH_M / 4, LENGTH_M)
    assert loaded(*ends).moment_extremes.greatest == pytest.approx(WEIGHT * LENGTH_M / 16, rel=1e-6)


def test_a_load_towards_one_end_has_the_moment_of_the_trimmed_box() -> None:
    reach = 0.8 * LENGTH_M
    found = loaded(uniform("cargo", MASS, 0.0, reach))
    lever = reach / 2 - LENGTH_M / 2
    x = np.linspace(0.0, LENGTH_M, 201)
    # wall-sided: b = W/L (1 + 12 e (x - L/2) / L^2), integrated twice
    half = LENGTH_M / 2
    buoyed = x**2 / 2 + 12 * lever / LENGTH_M**2 * (x**3 / 6 - half * x**2 / 2)
    over = np.maximum(x - reach, 0.0)
    expected = WEIGHT / reach * (x**2 - over**2) / 2 - WEIGHT / LENGTH_M * buoyed
    np.testing.assert_allclose(found.bending_moment(x), expected, atol=1e-6 * np.abs(expected).max())
    assert found.moment_residual < 1e-12
    assert found.shear_residual < 1e-12
    assert found.waterline.trim_m == pytest.approx(12 * 3.0 * -lever / LENGTH_M, rel=1e-4)


def test_point_masses_jump_the_shear_force_and_the_ends_close() -> None:
    block = Distribution("blocks", np.array([0.0, LENGTH_M]), np.array([100.0]), np.array([100.0]), ((30.0, 4e5),))
    ends = Distribution("ends", np.array([10.0]), np.array([]), np.array([]), ((0.0, 2e5), (LENGTH_M, 2.5e5)))
    found = loaded(block, ends)
    before, after = found.shear_force(30.0 - 1e-9), found.shear_force(30.0)
    assert after - before == pytest.approx(4e5 * GRAVITY_M_S2, rel=1e-6)
    assert found.shear_force(0.0) == pytest.approx(2e5 * GRAVITY_M_S2, rel=1e-12)
    assert found.shear_residual < 1e-12
    assert found.moment_residual < 1e-12


def test_a_given_waterline_that_carries_too_little_leaves_its_remainder() -> None:
    hull = box_barge()
    found = still_water(hull, [uniform("cargo", MASS, 0.0, LENGTH_M)], hull.waterline(2.0, 2.0), DENSITY)
    assert found.unclosed_shear_n == pytest.approx(WEIGHT / 3, rel=1e-4)
    assert found.shear_residual == pytest.approx(1.0)


def test_samples_keep_the_jumps_of_a_curve_upright() -> None:
    x, weight = sampled(loaded(uniform("cargo", MASS, 21.0, 61.0)).weight, points=3)
    at_start = weight[np.isclose(x, 21.0)]
    assert at_start == pytest.approx([0.0, WEIGHT / 40.0])
    assert x[0] == 0.0
    assert x[-1] == LENGTH_M
