"""Watson & Gilfillan's weights for the paper's ships, worked by hand from the formulas' own steps."""

from __future__ import annotations

import pytest

from hullform.loading import watson
from hullform.ship import Particulars
from hullform.ship_structure import Superstructure


def ship(type_: str, loa: float, lpp: float, b: float, d: float, t: float) -> Particulars:
    return Particulars(
        name="x",
        type=type_,  # type: ignore[arg-type]
        length_overall_m=loa,
        length_between_perpendiculars_m=lpp,
        aft_perpendicular_m=0.0,
        breadth_m=b,
        depth_m=d,
        draught_m=t,
    )


CONTAINER = ship("container", 262.0, 248.0, 32.2, 19.5, 13.2)
TANKER = ship("tanker", 249.98, 239.0, 44.0, 21.5, 15.1)


def test_numeral() -> None:
    # by hand: 248 (32.2 + 13.2) + 0.85 * 248 (19.5 - 13.2); 239 (44 + 15.1) + 0.85 * 239 (21.5 - 15.1)
    assert watson.hull_numeral(CONTAINER) == pytest.approx(12587.24, abs=0.01)
    assert watson.hull_numeral(TANKER) == pytest.approx(15425.06, abs=0.01)


def test_houses_count_in_the_numeral_and_the_steel() -> None:
    # a forecastle from side to side, 20 m by 2.5 m at 0.85, and a house, 30 m by 12 m at 0.75 (p. 82)
    forecastle = Superstructure(height_m=2.5, breadth_m=32.0, from_m=242.0)
    house = Superstructure(height_m=12.0, breadth_m=26.0, from_m=30.0, to_m=60.0)
    with_houses = watson.hull_numeral(CONTAINER, [forecastle, house])
    assert with_houses - watson.hull_numeral(CONTAINER) == pytest.approx(0.85 * 20 * 2.5 + 0.75 * 30 * 12)
    steel = [watson.steel_weight(CONTAINER, 0.691, houses).weight_t for houses in ((), (forecastle, house))]
    assert steel[1] / steel[0] == pytest.approx((with_houses / 12587.24) ** 1.36, rel=1e-6)


@pytest.mark.parametrize(
    ("of_ship", "block", "weight", "lower", "upper"),
    # By hand, with K = 0.036 +- 0.003 and 0.032 +- 0.003 of table 4.1: E^1.36 = 376622 and 496579,
    # Cb' = 0.70973 and 0.84360. Printed steel weights of the two ships: 15103 t and 16747 t.
    [(CONTAINER, 0.691, 13624.0, 12489.0, 14760.0), (TANKER, 0.836, 17031.0, 15435.0, 18628.0)],
)
def test_steel_weight(of_ship: Particulars, block: float, weight: float, lower: float, upper: float) -> None:
    estimate = watson.steel_weight(of_ship, block)
    # the hand figures are rounded to a tonne, and their Cb' to five digits
    assert estimate.weight_t == pytest.approx(weight, abs=1.0)
    assert estimate.lower_t == pytest.approx(lower, abs=1.0)
    assert estimate.upper_t == pytest.approx(upper, abs=1.0)


def test_guessed_power_is_of_the_size_of_such_ships() -> None:
    # A 248 m container ship has 30-45 MW (36560 kW in a ship of this size), a 136000 t tanker 11-17 MW.
    assert 30e3 < watson.installed_power_kw(CONTAINER, 74660.0, 0.25) < 45e3
    assert 11e3 < watson.installed_power_kw(TANKER, 136011.0, 0.16) < 17e3


def test_machinery_and_outfit_of_the_container_ship() -> None:
    # at 36560 kW: 0.037 * 36560 = 1353 t, 0.69 * 36560^0.7 = 1079 t, outfit 0.34 * 248 * 32.2 = 2715 t: 5147 t;
    # the guessed power is some per cent off, and its part of the sum is half
    parts = watson.machinery_and_outfit(CONTAINER, 74660.0)
    assert parts is not None
    estimate = parts.together
    assert estimate.weight_t == pytest.approx(5147.0, rel=0.10)
    assert estimate.lower_t == estimate.weight_t / 2


def test_types_without_a_source_get_no_estimate() -> None:
    assert watson.machinery_and_outfit(ship("tug", 30.0, 28.0, 9.0, 4.5, 3.8), 500.0) is None
