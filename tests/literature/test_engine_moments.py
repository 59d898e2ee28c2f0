"""Two-stroke engines and hulls as their makers print them."""

from __future__ import annotations

import pytest

from hullvib.engine import moment_at, need_for_compensator, power_related_unbalance
from hullvib.errors import ArgumentError
from hullvib.resonance import find_hits, frequency_bands, sources

# MAN B&W S80MC-C7/ME-C7 project guide 198 46 79-8.2, 17.04: 3880 kW a cylinder at 76 r/min; power-related unbalance of
# the second order 146.4 N m/kW with 6 cylinders. The copy read drops figures of 1: '46,4', and '60 - 20', '20 - 220'
# for the limits 60 - 120 and 120 - 220; the limits can be no others, and with 46.4 the one engine of the row with a
# large moment would be 'not relevant'.
S80_POWER_PER_CYLINDER_KW, S80_RPM = 3880.0, 76.0
S80_SECOND_ORDER_PRU = 146.4


def test_a_4l60mc_meets_a_hull_of_230_cycles_a_minute_with_her_second_order_only() -> None:
    """MAN B&W, An Introduction to Vibration Aspects of Two-stroke Diesel Engines in Ships, the first example.

    A vertical hull vibration of 3.83 Hz (230 cycles/min), a 4L60MC of 117 r/min at MCR: 'no risk of resonance with the
    first order moment', whereas 2 x 117 = 234 cycles/min is 1.8 % from it, resonance at 115 r/min.
    """
    bands = frequency_bands([3.83])
    (hit,) = find_hits([3.83], bands, sources(engine_orders=[1.0, 2.0]), (30.0, 117.0))
    assert hit.source.order == 2.0
    # 3.83 * 60 / 2 = 114.9, printed as 230 cycles/min
    assert hit.critical_rpm == pytest.approx(115.0, abs=0.15)
    # 5 % on either side begin at 109.2 r/min and reach beyond MCR
    assert hit.avoid_rpm == pytest.approx((0.95 * 114.9, 117.0), rel=1e-12)
    assert hit.holds(117.0)


def test_the_six_cylinder_s80_is_likely_to_need_a_compensator() -> None:
    power = 6 * S80_POWER_PER_CYLINDER_KW
    moment = S80_SECOND_ORDER_PRU * power
    # 3.41 MN m, of the size that such engines have
    assert moment == pytest.approx(3.408e6, rel=1e-3)
    unbalance = power_related_unbalance(moment, power)
    assert unbalance == pytest.approx(S80_SECOND_ORDER_PRU, rel=1e-14)
    assert need_for_compensator(unbalance) == "likely"


def test_moments_go_with_the_square_of_the_speed() -> None:
    # the guide: M_A = M_1 (n_A / n_1)^2; at 69 of 76 r/min (69 / 76)^2 = 4761 / 5776
    assert moment_at(3.408e6, S80_RPM, 69.0) == pytest.approx(3.408e6 * 4761 / 5776, rel=1e-14)
    assert moment_at(3.408e6, S80_RPM, S80_RPM) == 3.408e6


@pytest.mark.parametrize(
    ("unbalance", "need"),
    [
        (0.0, "not relevant"),
        (59.9, "not relevant"),
        (60.0, "unlikely"),
        (119.9, "unlikely"),
        (120.0, "likely"),
        (219.9, "likely"),
        (220.0, "most likely"),
        (900.0, "most likely"),
    ],
)
def test_the_four_classes(unbalance: float, need: str) -> None:
    assert need_for_compensator(unbalance) == need


def test_an_engine_without_power_or_speed_is_refused() -> None:
    with pytest.raises(ArgumentError, match="engine power"):
        power_related_unbalance(1e6, 0.0)
    with pytest.raises(ArgumentError, match="engine speeds"):
        moment_at(1e6, 0.0, 70.0)
