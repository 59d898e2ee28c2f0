"""Hits of propeller and engine, against cases worked by hand."""

from __future__ import annotations

import numpy as np
import pytest

from hullvib import resonance
from hullvib.errors import ArgumentError
from hullvib.resonance import Source, find_hits, frequency_bands, margins, sources, speeds_to_avoid

MODES_HZ = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]


def test_a_constructed_hit_has_the_right_speeds_to_avoid() -> None:
    # four blades against a mode of 2 Hz: critical at 60 * 2 / 4 = 30 rpm, 5 % on either side
    (hit,) = find_hits([2.0], frequency_bands([2.0]), sources(4, harmonics=1), (20.0, 100.0))
    assert (hit.mode, hit.source.name) == (1, "blade rate")
    assert hit.critical_rpm == pytest.approx(30.0, rel=1e-15)
    assert hit.avoid_rpm == pytest.approx((28.5, 31.5), rel=1e-15)
    assert hit.holds(31.0)
    assert not hit.holds(31.6)


def test_the_models_own_uncertainty_widens_the_band() -> None:
    # known to 10 %: from 0.9 * 0.95 to 1.1 * 1.05 of the frequency
    lower, upper = frequency_bands([1.0, 2.0], [0.1, 0.0])
    assert lower == pytest.approx([0.855, 1.9], rel=1e-15)
    assert upper == pytest.approx([1.155, 2.1], rel=1e-15)
    (hit,) = find_hits([2.0], frequency_bands([2.0], 0.1), sources(engine_orders=[2.0]), (10.0, 100.0))
    assert hit.avoid_rpm == pytest.approx((30 * 1.71, 30 * 2.31), rel=1e-14)


def test_a_band_that_reaches_into_the_range_is_a_hit_though_its_middle_does_not() -> None:
    # order 1 and 1 Hz: critical at 60 rpm, the band 57 to 63 rpm; the shaft stops at 58
    (hit,) = find_hits([1.0], frequency_bands([1.0]), sources(engine_orders=[1.0]), (20.0, 58.0))
    assert hit.critical_rpm == pytest.approx(60.0)
    assert hit.avoid_rpm == pytest.approx((57.0, 58.0))
    assert find_hits([1.0], frequency_bands([1.0]), sources(engine_orders=[1.0]), (20.0, 56.9)) == ()


def test_hits_end_with_mode_5_and_are_flagged_from_mode_4_on() -> None:
    hits = find_hits(MODES_HZ, frequency_bands(MODES_HZ), [Source("engine order 1", 1.0, "moment")], (1.0, 1000.0))
    assert [hit.mode for hit in hits] == [1, 2, 3, 4, 5]
    assert [hit.flagged for hit in hits] == [False, False, False, True, True]
    assert resonance.beam_limit_hz(frequency_bands(MODES_HZ)) == pytest.approx(5.25)


def test_speeds_to_avoid_join_where_they_overlap() -> None:
    # order 1 keeps 57 to 63 rpm of 1 Hz; order 2 keeps 60.8 to 67.2 of 2.1333 Hz; order 3 keeps 38 to 42 of 2 Hz
    hits = [
        *find_hits([1.0], frequency_bands([1.0]), sources(engine_orders=[1.0]), (10.0, 100.0)),
        *find_hits([32 / 15], frequency_bands([32 / 15]), sources(engine_orders=[2.0]), (10.0, 100.0)),
        *find_hits([2.0], frequency_bands([2.0]), sources(engine_orders=[3.0]), (10.0, 100.0)),
    ]
    assert np.ravel(speeds_to_avoid(hits)) == pytest.approx([38.0, 42.0, 57.0, 67.2])
    assert speeds_to_avoid([]) == ()


def test_margins_at_a_speed() -> None:
    # blade rate of five blades at 100 rpm: 8.333 Hz, 66.7 % above 5 Hz and 16.7 % below 10 Hz
    found = margins([5.0, 10.0], sources(5, harmonics=1), 100.0)
    assert found == pytest.approx(np.array([[2 / 3, -1 / 6]]), rel=1e-14)


def test_harmonics_and_orders_are_named() -> None:
    names = [(source.name, source.order, source.acts) for source in sources(5, [4.0, 1.0])]
    assert names == [
        ("blade rate", 5, "force"),
        ("2 × blade rate", 10, "force"),
        ("3 × blade rate", 15, "force"),
        ("engine order 1", 1.0, "moment"),
        ("engine order 4", 4.0, "moment"),
    ]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: sources(1), "two blades or more"),
        (lambda: sources(None, [0.0]), "above 0"),
        (lambda: frequency_bands([0.0]), "above 0"),
        (lambda: frequency_bands([1.0], 1.0), "below 1"),
        (lambda: find_hits([1.0], frequency_bands([1.0]), [], (50.0, 50.0)), "lower speed first"),
    ],
)
def test_nonsense_is_refused(call: object, words: str) -> None:
    with pytest.raises(ArgumentError, match=words):
        call()  # type: ignore[operator]
