"""Waves that meet the ship with a given frequency: the roots of the two quadratics, one by one."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hullvib.errors import ArgumentError
from hullvib.sea import GRAVITY_M_S2
from hullvib.springing import (
    encounter_frequency,
    exciting_waves,
    met_waves,
    wave_frequencies,
    wave_length,
)

HEAD, BEAM, FOLLOWING = math.pi, math.pi / 2, 0.0


def test_a_ship_that_lies_still_meets_waves_of_her_own_frequency() -> None:
    for heading in (HEAD, 2.0, BEAM, FOLLOWING):
        roots = wave_frequencies(1.7, 0.0, heading)
        assert roots[0] == pytest.approx(1.7, rel=1e-15)
        assert np.isnan(roots[1:]).all()


def test_in_beam_seas_speed_does_not_matter() -> None:
    roots = wave_frequencies(1.7, 12.0, BEAM)
    assert roots[0] == pytest.approx(1.7, rel=1e-15)
    # the cosine of a right angle is 6e-17 in floating point: no wave of a millionth of a metre comes of it
    assert np.isnan(roots[1:]).all()


def test_head_seas_worked_by_hand() -> None:
    # U / g = 1 s: w + w^2 = 6 has the root 2
    roots = wave_frequencies(6.0, GRAVITY_M_S2, HEAD)
    assert roots[0] == pytest.approx(2.0, rel=1e-14)
    assert np.isnan(roots[1:]).all()


def test_following_seas_have_three_waves_while_she_is_slow() -> None:
    # U / g = 1 s: w - w^2 = 3/16 has the roots 1/4 and 3/4, and w^2 - w = 3/16 the root (1 + sqrt(7) / 2) / 2
    roots = wave_frequencies(3 / 16, GRAVITY_M_S2, FOLLOWING)
    assert roots == pytest.approx([0.25, 0.75, (1 + math.sqrt(1.75)) / 2], rel=1e-14)


def test_two_of_them_coincide_at_the_tangent() -> None:
    # U / g = 1 s: w - w^2 has its largest value, 1/4, at w = 1/2
    roots = wave_frequencies(0.25, GRAVITY_M_S2, FOLLOWING)
    assert roots[0] == pytest.approx(0.5, rel=1e-12)
    assert np.isnan(roots[1])
    assert roots[2] == pytest.approx((1 + math.sqrt(2)) / 2, rel=1e-14)


def test_beyond_the_tangent_only_the_wave_that_she_overtakes_is_left() -> None:
    roots = wave_frequencies(0.26, GRAVITY_M_S2, FOLLOWING)
    assert np.isnan(roots[:2]).all()
    assert roots[2] == pytest.approx((1 + math.sqrt(2.04)) / 2, rel=1e-14)


@given(
    met=st.floats(0.05, 20.0),
    speed=st.floats(0.0, 25.0),
    heading=st.floats(0.0, math.pi),
)
def test_every_root_is_met_with_the_frequency_asked_for(met: float, speed: float, heading: float) -> None:
    roots = wave_frequencies(met, speed, heading)
    found = roots[np.isfinite(roots)]
    assert found.size >= 1
    # a long wave is the small difference of two large numbers where k w^2 is large
    size = found + found**2 * speed * abs(math.cos(heading)) / GRAVITY_M_S2
    assert np.abs(encounter_frequency(found, speed, heading) - met).max() <= 1e-11 * size.max()


@given(met=st.floats(0.05, 20.0), speed=st.floats(0.0, 25.0), heading=st.floats(0.0, math.pi))
def test_there_are_no_other_roots(met: float, speed: float, heading: float) -> None:
    """Sign changes of w_e - |..| on a fine grid, against the closed form."""
    k = speed * math.cos(heading) / GRAVITY_M_S2
    roots = wave_frequencies(met, speed, heading)
    known = np.sort(roots[np.isfinite(roots)])
    if known[-1] > 1e3 or abs(1 - 4 * k * met) < 1e-3 or (k != 0 and abs(k) < 1e-4):
        return  # too near a tangent, or too far out, for a grid
    grid = np.geomspace(1e-4, 2e3, 200_001)
    changes = np.count_nonzero(np.diff(np.sign(np.abs(grid - k * grid**2) - met)))
    assert changes == known.size


def test_lengths_for_a_container_ship() -> None:
    """A two-node mode of 0.631 Hz at 20 and 24 knots in head seas, worked apart from this code.

    w = g / (2 U) (sqrt(1 + 4 U w_e / g) - 1) = 1.526 rad/s at 20 knots: 26.5 m and 4.1 s; second order 64 m; at 24
    knots 30.5 and 72.9 m.
    """
    for knots, linear, second in ((20.0, 26.5, 64.4), (24.0, 30.5, 72.9)):
        first, half = exciting_waves(2 * math.pi * 0.631, knots * 1852 / 3600, HEAD)
        assert (first.order, half.order) == (1, 2)
        assert first.length_m == pytest.approx(linear, abs=0.1)
        assert half.length_m == pytest.approx(second, abs=0.1)
        assert not first.overtaken
    slow, _ = exciting_waves(2 * math.pi * 0.631, 20.0 * 1852 / 3600, HEAD)
    assert slow.period_s == pytest.approx(4.1, abs=0.05)
    assert wave_length(slow.angular_frequency) == pytest.approx(slow.length_m, rel=1e-14)


def test_in_following_seas_at_speed_she_overtakes_the_wave() -> None:
    waves = exciting_waves(2 * math.pi * 0.631, 20.0 * 1852 / 3600, FOLLOWING)
    assert [(wave.order, wave.overtaken) for wave in waves] == [(1, True), (2, True)]
    for wave in waves:
        # faster than the crests of the wave, g / w
        assert GRAVITY_M_S2 / wave.angular_frequency < 20.0 * 1852 / 3600


def test_a_depth_of_many_lengths_is_deep_water() -> None:
    for met, speed, heading in ((3.0, 8.0, HEAD), (0.4, 8.0, FOLLOWING), (3.0, 8.0, FOLLOWING), (2.0, 0.0, HEAD)):
        deep, far = (met_waves(met, speed, heading, depth_m=depth) for depth in (math.inf, 1e5))
        np.testing.assert_allclose(far, deep, rtol=1e-10)


@given(
    met=st.floats(0.05, 20.0), speed=st.floats(0.0, 20.0), heading=st.floats(0.0, math.pi), depth=st.floats(3.0, 300.0)
)
def test_waves_of_any_depth_are_met_with_the_frequency_asked_for(
    met: float, speed: float, heading: float, depth: float
) -> None:
    waves, lengths = met_waves(met, speed, heading, depth_m=depth)
    there = np.isfinite(waves)
    assert there.any()
    number = 2 * np.pi / lengths[there]
    np.testing.assert_allclose(waves[there] ** 2, GRAVITY_M_S2 * number * np.tanh(number * depth), rtol=1e-10)
    along = speed * math.cos(heading)
    size = np.maximum(waves[there], number * abs(along))
    np.testing.assert_allclose(np.abs(waves[there] - number * along) / size, met / size, rtol=1e-8, atol=1e-9)


@pytest.mark.parametrize("off", [0.0, 1e-15, -1e-15, 1e-9, -1e-9, -2e-6])
def test_a_ship_as_fast_as_the_fastest_wave_meets_waves_all_the_same(off: float) -> None:
    for depth in np.linspace(3.0, 60.0, 20):
        speed = math.sqrt(GRAVITY_M_S2 * depth) * (1 + off)
        waves, lengths = met_waves(1.3, speed, FOLLOWING, depth_m=float(depth))
        there = np.isfinite(waves)
        assert there[2]
        np.testing.assert_allclose(np.abs(waves - 2 * np.pi / lengths * speed)[there], 1.3, rtol=1e-9)


def test_long_waves_in_shallow_water_travel_with_the_root_of_g_h() -> None:
    # at 0.05 rad/s in 4 m of water k h is 0.03: w = k sqrt(g h) to 1.7e-4, and head seas at U = sqrt(g h) meet twice
    celerity = math.sqrt(GRAVITY_M_S2 * 4.0)
    assert float(wave_length(0.05, depth_m=4.0)) == pytest.approx(2 * math.pi * celerity / 0.05, rel=3e-4)
    waves, _ = met_waves(0.1, celerity, HEAD, depth_m=4.0)
    assert waves[0] == pytest.approx(0.05, rel=3e-4)


def test_no_ripple_is_told_near_beam_seas() -> None:
    lengths = [wave.length_m for wave in exciting_waves(4.0, 10.0, math.radians(89.9))]
    assert lengths
    assert min(lengths) >= 0.1


def test_arrays_broadcast() -> None:
    speeds, headings = np.array([0.0, 5.0, 10.0]), np.array([[0.0], [HEAD]])
    found = wave_frequencies(3.0, speeds, headings)
    assert found.shape == (2, 3, 3)
    for row, heading in enumerate((0.0, HEAD)):
        for column, speed in enumerate(speeds):
            np.testing.assert_array_equal(found[row, column], wave_frequencies(3.0, speed, heading))


def test_nonsense_is_refused() -> None:
    with pytest.raises(ArgumentError, match="encounter frequency"):
        wave_frequencies(0.0, 5.0, HEAD)
    with pytest.raises(ArgumentError, match="speed is below 0"):
        wave_frequencies(1.0, -5.0, HEAD)
