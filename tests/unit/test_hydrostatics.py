"""A barge, a counter above the water, floating positions that cannot be."""

import numpy as np
import pytest

from hullform.errors import HullError
from hullform.hull import Hull, Sections
from hullform.hull.hydrostatics import buoyancy


def barge(exponent: float = 1e5, **changes: float) -> Hull:
    x = np.linspace(0.0, 80.0, 41)
    one = np.ones(41)
    values = {"length": 80.0, "aft_perpendicular": 0.0, "depth": 8.0} | changes
    return Hull.of_super_ellipses(
        x, 6.0 * one, 8.0 * one, 8.0 * one, exponent * one, exponent * one, 80.0, values["length"],
        values["aft_perpendicular"], 12.0, 8.0, 4.0,
    )  # fmt: skip


def test_a_box_barge_has_the_figures_of_a_box() -> None:
    found = barge().hydrostatics(4.0, density=1000.0)
    # The corner missing from a section of exponents 1e5 is of that order.
    assert found.volume_m3 == pytest.approx(80 * 12 * 4, rel=1e-4)
    assert found.displacement_kg == pytest.approx(80 * 12 * 4e3, rel=1e-4)
    assert found.kb_m == pytest.approx(2.0, rel=1e-4)
    assert found.bm_transverse_m == pytest.approx(12**2 / (12 * 4), rel=1e-4)
    assert found.bm_longitudinal_m == pytest.approx(80**2 / (12 * 4), rel=1e-4)
    assert found.block_coefficient == pytest.approx(1.0, rel=1e-4)
    assert found.midship_coefficient == pytest.approx(1.0, rel=1e-4)
    assert found.waterplane_coefficient == pytest.approx(1.0, rel=1e-4)
    assert found.wetted_surface_m2 == pytest.approx(80 * (12 + 2 * 4), rel=1e-4)


def test_coefficients_use_the_length_between_perpendiculars_and_midships_between_them() -> None:
    found = barge(length=70.0, aft_perpendicular=8.0).hydrostatics(4.0)
    assert found.block_coefficient == pytest.approx(80 / 70, rel=1e-4)
    assert found.lcb_x_m == pytest.approx(40.0, rel=1e-9)
    assert found.lcb_from_midships_m == pytest.approx(40.0 - (8.0 + 35.0), rel=1e-9)


def test_a_counter_above_the_water_displaces_nothing() -> None:
    x = np.linspace(0.0, 80.0, 81)
    keel = np.where(x < 20.0, 6.0, 0.0)
    one = np.ones(81)
    hull = Hull.of_super_ellipses(x, 6.0 * one, 8.0 - keel, 8.0 * one, 1e4 * one, 1e4 * one, 80, 80, 0, 12.0, 8.0, 4.0)
    # Between the last station aft, at 19 m, and 20 m the keel comes down: the volume begins somewhere there.
    assert 60 * 48 < hull.hydrostatics(4.0).volume_m3 * (1 + 1e-3) < 61 * 48
    areas = hull.sectional_areas(4.0)
    assert (areas[x < 20] == 0).all()
    np.testing.assert_allclose(areas[x >= 20], 48.0, rtol=1e-3)
    np.testing.assert_allclose(hull.sectional_areas()[x < 20], 24.0, rtol=1e-3)


def test_a_trimmed_waterline_has_a_draught_for_every_section() -> None:
    hull = barge()
    draughts = np.linspace(2.0, 6.0, 41)
    np.testing.assert_allclose(hull.sectional_areas(draughts), 12 * draughts, rtol=1e-3)


def test_kernels_take_many_hulls_at_once() -> None:
    x = np.linspace(0.0, 50.0, 21)
    rng = np.random.default_rng(5)
    a, depth, p, q = (rng.uniform(low, high, (3, 21)) for low, high in ((2, 5), (6, 8), (0.8, 6), (0.8, 6)))
    many = Sections(a, depth, np.full((3, 21), 7.0), p, q)
    draught = np.array([[3.0], [4.0], [5.0]])
    together = buoyancy(x, many, draught)
    areas = many.areas_below(draught)
    for i in range(3):
        one = Sections(*(field[i] for field in many))
        for field, alone in zip(together, buoyancy(x, one, draught[i]), strict=True):
            assert field[i] == pytest.approx(float(alone), rel=1e-12)
        np.testing.assert_allclose(areas[i], one.areas_below(draught[i]), rtol=1e-12)


@pytest.mark.parametrize("draught", [0.0, -1.0, 8.2, float("nan")])
def test_a_draught_that_cannot_be_is_refused(draught: float) -> None:
    with pytest.raises(HullError, match=r"not between 0 and the hull's depth amidships, 8.00 m; correct draught_m"):
        barge().hydrostatics(draught)


def test_a_hull_drawn_to_her_waterline_may_be_read_a_pixel_short() -> None:
    found = barge().hydrostatics(8.02)
    assert found.waterplane_area_m2 == pytest.approx(80 * 12, rel=1e-4)


def test_weights_that_do_not_float_are_refused() -> None:
    with pytest.raises(HullError, match="less than the"):
        barge().draught_for(1.1 * 1025 * 80 * 12 * 8)
    with pytest.raises(HullError, match="give a positive one"):
        barge().draught_for(-5.0)
    with pytest.raises(HullError, match="sea water has 1025"):
        barge().hydrostatics(4.0, density=0.0)


def test_the_default_draught_is_the_designs() -> None:
    assert barge().hydrostatics().draught_m == 4.0
