"""Which waterline a loaded box barge takes, and what is said where it is not her equilibrium."""

from __future__ import annotations

import pytest
from box_barge import BREADTH_M, LENGTH_M, box_barge

from hullform.at_rest import AtRest, at_rest
from hullform.loading.distributions import Distribution, uniform

DENSITY = 1000.0
# LPP of trim for a metre of lever, at a draught of 4 m: 12 T / L^2
SLOPE_PER_M = 12 * 4.0 / LENGTH_M**2


def load(lever: float, draught: float = 4.0) -> Distribution:
    """A load that floats the barge at a draught, its centre forward of midships by a lever."""
    half = LENGTH_M / 2 - abs(lever)
    middle = LENGTH_M / 2 + lever
    return uniform("cargo", DENSITY * LENGTH_M * BREADTH_M * draught, middle - half, middle + half)


def laid(lever: float, draught: float = 4.0, given: tuple[float, float] | None = None) -> AtRest:
    hull = box_barge()
    item = load(lever, draught)
    level = min(hull.depth_amidships_m, draught)
    return at_rest(hull, [item], DENSITY, level, None if given is None else hull.waterline(*given))


def failed(found: AtRest) -> set[str]:
    return {check.id for check in found.checks if not check.ok}


@pytest.mark.parametrize("lever", [0.0, -1.9, 0.6])
def test_a_moderate_trim_is_hers(lever: float) -> None:
    found = laid(lever)
    assert found.adopted == "equilibrium"
    assert found.reason == ""
    assert found.position is found.equilibrium
    assert not failed(found)
    assert found.position.waterline.slope == pytest.approx(SLOPE_PER_M * lever, rel=1e-3, abs=1e-12)
    (trim,) = (check for check in found.checks if check.id == "trim")
    assert trim.value == pytest.approx(-100 * SLOPE_PER_M * lever, rel=1e-3, abs=1e-12)
    assert trim.limits == (-0.5, 1.5)


# 1.5 % of LPP by the stern is a lever of 2 m, 0.5 % by the bow one of 0.67 m
@pytest.mark.parametrize("lever", [-2.1, 0.7])
def test_beyond_the_limits_she_is_level_and_still_closes(lever: float) -> None:
    found = laid(lever)
    assert found.adopted == "even keel"
    assert failed(found) == {"trim"}
    assert f"LCG {abs(lever):.2f}"[:7] in found.reason
    assert ("abaft" if lever < 0 else "forward of") in found.reason
    assert found.position.waterline.trim_m == 0.0
    assert found.still_water.waterline.slope == pytest.approx(SLOPE_PER_M * lever, rel=1e-3)
    assert found.still_water.moment_residual < 1e-10


def test_a_deck_under_water_is_told() -> None:
    found = laid(-1.0, draught=7.8)
    assert failed(found) == {"freeboard"}
    assert found.adopted == "even keel"
    assert "deck above the waterline" in found.reason


def test_given_draughts_are_hers_and_held_against_the_equilibrium() -> None:
    found = laid(-1.0, given=(4.3, 3.7))
    assert found.adopted == "given draughts"
    assert found.position.waterline.draught_aft_m == pytest.approx(4.3)
    assert not failed(found)
    assert found.equilibrium is not None
    assert found.still_water.waterline is found.equilibrium.waterline


def test_given_draughts_of_another_mass_or_trim_are_told() -> None:
    assert failed(laid(-1.0, given=(4.4, 3.8))) == {"given-draughts"}
    # 0.5 % of LPP is 0.4 m
    assert failed(laid(-1.0, given=(3.9, 4.1))) == {"given-trim"}


def test_weights_that_no_water_carries_leave_a_remainder_that_is_told() -> None:
    found = laid(0.0, draught=8.5)
    assert found.equilibrium is None
    assert found.adopted == "even keel"
    assert "less than the" in found.reason
    # 8.5 m of weight on 8 m of buoyancy: M at the fore end is w L^2 / 2, the largest there is
    assert failed(found) == {"closing"}
    assert found.still_water.moment_residual == pytest.approx(1.0)
