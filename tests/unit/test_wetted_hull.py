"""The wetted hull as curves and panels, at level and trimmed waterlines, of boxes, fine hulls and raked ends."""

from __future__ import annotations

import numpy as np
import pytest
from box_barge import BREADTH_M, DEPTH_M, LENGTH_M, box_barge

from hullform.errors import HullError
from hullform.hull import Hull
from hullform.wetted import GIRTHWISE, LENGTHWISE, wetted_panels, wetted_sections

DRAUGHT_M = 5.0


def raked() -> Hull:
    """Keel rising to the deck at both ends, sections full amid and fine at the ends."""
    x = np.linspace(0.0, 100.0, 61)
    t = x / 100.0
    keel = 8.0 * np.clip(1 - t / 0.25, 0, 1) ** 2 + 7.0 * np.clip((t - 0.8) / 0.2, 0, 1) ** 2
    fine = 1.5 + 3.0 * np.sin(np.pi * t) ** 2
    half = 8.0 * np.minimum(1.0, 0.2 + 4 * t) * np.sqrt(np.clip(5 * (1 - t), 0, 1))
    return Hull(x, half, np.maximum(8.0 - keel, 0.0), np.full(61, 8.0), fine, fine, 100.0, 90.0, 5.0, 16.0, 8.0, 5.0)


def test_box() -> None:
    barge = box_barge()
    sections = wetted_sections(barge, barge.waterline(DRAUGHT_M, DRAUGHT_M))
    volume = LENGTH_M * BREADTH_M * DRAUGHT_M
    assert sections.x_m[[0, -1]].tolist() == [0.0, LENGTH_M]
    assert sections.volume_m3 == pytest.approx(volume, rel=1e-3)
    panels = wetted_panels(sections)
    # the bilge is cut off by the shortest of eleven pieces
    assert panels.volume_m3 == pytest.approx(volume, rel=3e-3)
    assert panels.open_share < 1e-9
    assert len(panels) >= LENGTHWISE * GIRTHWISE


@pytest.mark.parametrize(("aft", "fore"), [(5.0, 5.0), (6.5, 4.0), (2.0, 2.5), (7.9, 7.9)])
def test_raked_hull_ends_where_her_keel_leaves_the_water(aft: float, fore: float) -> None:
    hull = raked()
    waterline = hull.waterline(aft, fore)
    sections = wetted_sections(hull, waterline)
    panels = wetted_panels(sections)
    displaced = hull.floating_at(waterline).volume_m3
    assert sections.volume_m3 == pytest.approx(displaced, rel=5e-3)
    assert panels.volume_m3 == pytest.approx(displaced, rel=1e-2)
    assert panels.open_share < 0.02
    start = float(sections.x_m[0])
    assert hull.section_points(9, [start])[0, 0, 1] == pytest.approx(float(waterline.heights(start)), abs=1e-3)
    g = panels.geometry
    assert g.centres[:, 2].max() < 0.0
    assert g.areas.min() > 1e-6 * g.areas.max()


def test_a_deck_under_water_goes_on_upright() -> None:
    """As the buoyancy has it: the hull drawn to her waterline floats, a shade deeper than drawn."""
    barge = box_barge()
    sections = wetted_sections(barge, barge.waterline(DEPTH_M + 0.5, DEPTH_M + 0.5))
    assert sections.half_breadth_m == pytest.approx(BREADTH_M / 2)
    assert sections.volume_m3 == pytest.approx(LENGTH_M * BREADTH_M * (DEPTH_M + 0.5), rel=1e-3)


def test_nothing_under_water() -> None:
    barge = box_barge()
    with pytest.raises(HullError, match="nothing of the hull is under water"):
        wetted_sections(barge, barge.waterline(-1.0, -1.0))


def test_of_two_wet_stretches_the_longer_is_taken() -> None:
    x = np.linspace(0.0, 100.0, 101)
    keel = np.where((x > 30) & (x < 40), 6.0, 0.0)
    one = np.ones(101)
    hull = Hull(x, 5 * one, 8 - keel, 8 * one, 4 * one, 4 * one, 100.0, 100.0, 0.0, 10.0, 8.0, 4.0)
    sections = wetted_sections(hull, hull.waterline(4.0, 4.0))
    assert 39.0 < sections.x_m[0] < 40.5
    assert sections.x_m[-1] == 100.0
