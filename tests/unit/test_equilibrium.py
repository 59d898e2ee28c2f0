"""The inclined waterline that carries a mass: a box in closed form, a parabolic hull, what cannot be."""

import numpy as np
import pytest
from box_barge import BREADTH_M, LENGTH_M, box_barge

from hullform.errors import HullError
from hullform.hull import Hull

DENSITY = 1000.0


def parabolic_hull() -> Hull:
    """Parabolic waterlines of 100 x 10 m on super-ellipse sections of 4 m depth and 3 m freeboard above 6 m."""
    x = np.linspace(0.0, 100.0, 101)
    parabola = 1 - (2 * x / 100 - 1) ** 2
    one = np.ones(101)
    return Hull.of_super_ellipses(x, 5 * parabola, 9 * one, 9 * one, one, 2 * one, 100, 100, 0, 10, 9, 6)


@pytest.mark.parametrize("lever", [-9.0, -2.5, 0.0, 0.3, 8.0])
def test_a_box_trims_by_its_lever_over_the_metacentric_radius(lever: float) -> None:
    draught = 4.0
    # the volume of a box whose corners miss next to nothing; the draught of the mass is then within 1e-5 of 4 m
    mass = DENSITY * LENGTH_M * BREADTH_M * draught
    found = box_barge().equilibrium(mass, LENGTH_M / 2 + lever, DENSITY)
    slope = lever / (LENGTH_M**2 / (12 * draught))
    # The corner left out, 1e-5 of the section, makes BM_L that much longer or shorter; the rest is round-off.
    assert found.waterline.slope == pytest.approx(slope, rel=2e-5, abs=1e-13)
    assert found.waterline.draught_aft_m == pytest.approx(draught - slope * LENGTH_M / 2, abs=1e-4)
    assert found.waterline.draught_fore_m == pytest.approx(draught + slope * LENGTH_M / 2, abs=1e-4)
    assert found.waterline.trim_m == pytest.approx(-slope * LENGTH_M, rel=2e-5, abs=1e-12)
    assert found.volume_m3 * DENSITY == pytest.approx(mass, rel=1e-13)
    assert found.lcb_x_m == pytest.approx(LENGTH_M / 2 + lever, rel=1e-13)
    assert found.least_freeboard_m == pytest.approx(8 - draught - abs(slope) * LENGTH_M / 2, abs=1e-4)


def test_without_a_lever_she_floats_as_on_even_keel() -> None:
    hull = parabolic_hull()
    level = hull.hydrostatics(5.0)
    found = hull.equilibrium(level.displacement_kg, level.lcb_x_m)
    assert found.waterline.slope == pytest.approx(0.0, abs=1e-12)
    assert found.waterline.draught_m == pytest.approx(5.0, abs=1e-10)


def test_a_small_lever_trims_her_by_the_longitudinal_metacentre() -> None:
    hull = parabolic_hull()
    level = hull.hydrostatics(5.0)
    lever = 1e-3
    found = hull.equilibrium(level.displacement_kg, level.lcb_x_m + lever)
    # the second order of the slope, 1e-5, times curvatures of order one
    assert found.waterline.slope == pytest.approx(lever / level.bm_longitudinal_m, rel=1e-4)


def test_a_far_lever_carries_her_on_a_hull_with_dry_ends() -> None:
    hull = parabolic_hull()
    mass = hull.hydrostatics(3.0).displacement_kg
    found = hull.equilibrium(mass, 70.0)
    assert found.volume_m3 * 1025 == pytest.approx(mass, rel=1e-13)
    assert found.lcb_x_m == pytest.approx(70.0, rel=1e-13)
    assert found.waterline.draught_aft_m < 0 < found.waterline.trim_m * -1


def test_a_deck_under_water_is_told_and_her_sides_go_on() -> None:
    lever, draught = 3.0, 7.0
    found = box_barge().equilibrium(DENSITY * LENGTH_M * BREADTH_M * draught, LENGTH_M / 2 + lever, DENSITY)
    rise = 6 * draught * lever / LENGTH_M
    assert found.least_freeboard_m == pytest.approx(8.0 - draught - rise, abs=1e-3)
    assert found.least_freeboard_m < 0
    assert found.lcb_x_m == pytest.approx(LENGTH_M / 2 + lever, rel=1e-12)


def test_a_hull_drawn_to_her_waterline_floats_there() -> None:
    mass = DENSITY * LENGTH_M * BREADTH_M * 8.02
    assert box_barge().equilibrium(mass, 40.0, DENSITY).waterline.draught_m == pytest.approx(8.02, rel=1e-4)


def test_given_draughts_make_a_waterline() -> None:
    hull = box_barge()
    found = hull.floating_at(hull.waterline(aft_m=5.0, fore_m=3.0))
    assert found.volume_m3 == pytest.approx(LENGTH_M * BREADTH_M * 4.0, rel=2e-5)
    assert found.waterline.heights([0.0, 20.0, 80.0]) == pytest.approx([5.0, 4.5, 3.0])
    assert found.lcb_x_m == pytest.approx(40 - 80 * 2.0 / (12 * 4.0), rel=2e-5)


def test_what_cannot_float_is_refused() -> None:
    hull = box_barge()
    with pytest.raises(HullError, match=r"to her deck, less than the"):
        hull.equilibrium(DENSITY * LENGTH_M * BREADTH_M * 8.1, 40.0, DENSITY)
    with pytest.raises(HullError, match="give a positive one"):
        hull.equilibrium(-1.0, 40.0)
    with pytest.raises(HullError, match=r"no trim of up to 0.1 of the length .* x = 79 m"):
        hull.equilibrium(DENSITY * LENGTH_M * BREADTH_M * 4.0, 79.0, DENSITY)
    with pytest.raises(HullError, match="nothing of the hull is under water"):
        hull.floating_at(hull.waterline(-2.0, -1.0))
