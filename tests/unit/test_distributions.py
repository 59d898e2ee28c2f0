"""Weights along the ship: totals, centres and the girder that carries them all."""

from __future__ import annotations

import numpy as np
import pytest

from hullform.errors import LoadingError
from hullform.loading.distributions import girder_from, settled, shaped, uniform

X = np.linspace(0.0, 100.0, 101)


def test_a_uniform_weight_has_its_mass_at_its_middle() -> None:
    item = uniform("machinery", 5000.0, 10.0, 30.0)
    assert item.mass_kg == pytest.approx(5000.0, rel=1e-14)
    assert item.centre_m == pytest.approx(20.0, rel=1e-14)


def test_a_triangle_has_its_centre_at_two_thirds() -> None:
    item = shaped("cargo", 900.0, X, X)
    assert item.mass_kg == pytest.approx(900.0, rel=1e-13)
    assert item.centre_m == pytest.approx(200.0 / 3, rel=1e-13)


def test_what_all_but_stands_on_a_station_is_put_there_with_its_mass() -> None:
    ramp = shaped("cargo", 900.0, X, X, 20.0004, 89.9996, lumps=((55.0003, 40.0), (70.2, 10.0)))
    other = uniform("stores", 500.0, 33.3, 66.6)
    near = uniform("water", 100.0, 33.3005, 71.0)
    first, second, third = settled((ramp, other, near), X)
    assert (first.x_m[0], first.x_m[-1]) == (20.0, 90.0)
    assert [x for x, _ in first.points] == [55.0, 70.2]
    assert first.mass_kg == pytest.approx(900.0, rel=1e-13)
    assert first.centre_m == pytest.approx(ramp.centre_m, abs=1e-3)
    assert second is other
    # on the breakpoint of the item before it
    assert third.x_m.tolist() == [33.3, 71.0]
    assert third.mass_kg == pytest.approx(100.0, rel=1e-13)


def test_a_cut_triangle_integrates_to_its_own_total() -> None:
    # over a..b the centre of a linear ramp is 2/3 (b^3 - a^3) / (b^2 - a^2); 20.5 and 90.25 lie between breakpoints
    a, b = 20.5, 90.25
    item = shaped("cargo", 900.0, X, X, a, b)
    assert item.mass_kg == pytest.approx(900.0, rel=1e-13)
    assert item.centre_m == pytest.approx(2 / 3 * (b**3 - a**3) / (b**2 - a**2), rel=1e-13)


def test_end_plates_carry_their_share_at_the_ends() -> None:
    # girth 2 over 100 m is 200 m2 of shell; plates of 30 and 20 m2 take 12 and 8 % of the whole
    item = shaped("steel", 1000.0, X, np.full(101, 2.0), lumps=((0.0, 30.0), (100.0, 20.0)))
    assert item.points == ((0.0, pytest.approx(120.0)), (100.0, pytest.approx(80.0)))
    assert item.mass_kg == pytest.approx(1000.0, rel=1e-13)
    assert item.moment_kg_m == pytest.approx(800.0 * 50 + 80.0 * 100, rel=1e-13)


def test_nothing_to_spread_over_is_told() -> None:
    with pytest.raises(LoadingError, match=r"cargo: nothing to spread 2 t over between x = 10 and 20 m"):
        shaped("cargo", 2000.0, X, np.zeros(101), 10.0, 20.0)


def test_the_girder_carries_every_items_mass_and_first_moment() -> None:
    items = (
        uniform("machinery", 5e5, 0.0, 20.0),
        uniform("deck machinery", 2e5, 90.0, 100.0),
        shaped("steel", 3e6, X, 5 + np.sin(X / 20) ** 2, lumps=((0.0, 3.0), (100.0, 0.0))),
        shaped("cargo", 7e6, X, X * (100 - X), 20.0, 90.0),
    )
    girder = girder_from("test", items, X, np.full(101, 1e12), np.full(101, 1e10), 4.0)
    mass = sum(item.mass_kg for item in items)
    moment = sum(item.moment_kg_m for item in items)
    # sums of a few hundred terms: round-off of 1e-13 at most
    assert girder.total_mass == pytest.approx(mass, rel=1e-12)
    assert girder.centre_of_gravity == pytest.approx(moment / mass, rel=1e-12)
    jump = girder.mass_per_length(np.array([20.0 - 1e-6, 20.0 + 1e-6]))
    assert jump[1] - jump[0] == pytest.approx(-5e5 / 20 + items[3].left_kg_per_m[0], rel=1e-4)


def test_breakpoints_that_round_off_keeps_apart_become_one() -> None:
    items = (uniform("a", 1.0, 0.0, 100.0), uniform("b", 1.0, 0.0, 0.3 * 100 + 4e-15))
    girder = girder_from("test", items, X, np.full(101, 1e12), np.full(101, 1e10), 4.0)
    assert np.diff(girder.breaks).min() > 0.5


def test_rotary_inertia_is_the_mass_times_the_square_of_the_radius() -> None:
    items = (uniform("hull", 1e6, 0.0, 100.0), shaped("plates", 1e4, X, np.ones(101), lumps=((0.0, 3.0), (100.0, 0.0))))
    girder = girder_from("test", items, X, np.full(101, 1e12), np.full(101, 1e10), 4.0)
    x = np.array([5.0, 50.0, 99.0])
    assert girder.rotary_inertia(x) == pytest.approx(16.0 * girder.mass_per_length(x), rel=1e-12)
    (plate,) = girder.point_masses
    assert plate.rotary_inertia_kg_m2 == pytest.approx(16.0 * plate.mass_kg, rel=1e-12)
    assert girder.shear_rigidity(x) == pytest.approx([1e10] * 3, rel=1e-12)
