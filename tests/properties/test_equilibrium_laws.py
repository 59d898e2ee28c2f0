"""Equilibrium and still water of any hull: nothing is left over, mirrored ships mirror."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hullform.hull import Hull
from hullform.loading.distributions import Distribution, uniform
from hullform.loading.still_water import still_water

LENGTH = 100.0


def hull(seed: int) -> Hull:
    """A ship-like hull of random fullness, rake, bottom and flare."""
    rng = np.random.default_rng(seed)
    x = np.linspace(0.0, LENGTH, 41)
    run, entrance = rng.uniform(0.6, 2.5, 2)
    breadth = (
        8 * np.minimum(1.0, 2.2 * (x / LENGTH + 0.02) ** run) * np.minimum(1.0, 2.2 * (1.02 - x / LENGTH) ** entrance)
    )
    keel = rng.uniform(0.0, 3.0) * np.maximum(0.0, 0.2 - x / LENGTH) / 0.2
    top = 12 + rng.uniform(0.0, 2.0) * (2 * x / LENGTH - 1) ** 2
    p, q = np.exp(rng.uniform(-0.3, 1.5, (2, 41)).cumsum(axis=1) / np.arange(1, 42))
    return Hull.of_super_ellipses(x, breadth, top - keel, top, p, q, LENGTH, LENGTH, 0.0, 16.0, 12.0, 6.0)


def mirrored(found: Hull) -> Hull:
    turned = [
        values[::-1] for values in (found.half_breadth_m, found.depth_m, found.top_height_m, *found.sections.shape[2:])
    ]
    return Hull.of_super_ellipses(LENGTH - found.x_m[::-1], *turned, LENGTH, LENGTH, 0.0, 16.0, 12.0, 6.0)


def cargo(mass_kg: float, centre_m: float) -> Distribution:
    reach = min(centre_m, LENGTH - centre_m)
    return uniform("cargo", mass_kg, centre_m - reach, centre_m + reach)


@settings(deadline=None, max_examples=40)
@given(st.integers(0, 10**6), st.floats(0.05, 0.9), st.floats(-0.5, 0.5))
def test_the_waterline_carries_the_mass_where_it_lies(seed: int, share: float, slope: float) -> None:
    ship = hull(seed)
    level = ship.floating_at(ship.waterline(6.0, 6.0))
    mass = share * 1025 * ship.volume_m3
    # within the few metres that any ship can be trimmed by
    centre = level.lcb_x_m + 6.0 * slope
    found = ship.equilibrium(mass, centre)
    assert found.volume_m3 * 1025 == pytest.approx(mass, rel=1e-12)
    assert found.lcb_x_m == pytest.approx(centre, rel=1e-12)
    bent = still_water(ship, [cargo(mass, centre)], found.waterline, 1025.0)
    assert bent.shear_residual < 1e-9
    assert bent.moment_residual < 1e-9


@settings(deadline=None, max_examples=40)
@given(st.integers(0, 10**6), st.floats(-2.5, 2.5))
def test_a_mirrored_ship_trims_and_bends_the_other_way_round(seed: int, lever: float) -> None:
    ship = hull(seed)
    mass = 0.5 * 1025 * ship.volume_m3
    centre = ship.floating_at(ship.waterline(6.0, 6.0)).lcb_x_m + lever
    one, other = ship.equilibrium(mass, centre), mirrored(ship).equilibrium(mass, LENGTH - centre)
    # both are sharp to round-off of some metres
    assert one.waterline.draught_aft_m == pytest.approx(other.waterline.draught_fore_m, abs=1e-9)
    here = still_water(ship, [cargo(mass, centre)], one.waterline, 1025.0)
    there = still_water(mirrored(ship), [cargo(mass, LENGTH - centre)], other.waterline, 1025.0)
    scale = here.moment_extremes.size
    assert here.moment_extremes.greatest == pytest.approx(there.moment_extremes.greatest, abs=1e-9 * scale)
    assert here.moment_extremes.least == pytest.approx(there.moment_extremes.least, abs=1e-9 * scale)
    assert here.shear_extremes.greatest == pytest.approx(
        -there.shear_extremes.least, abs=1e-9 * here.shear_extremes.size
    )
