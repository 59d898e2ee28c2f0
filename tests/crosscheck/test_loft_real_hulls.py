"""Hulls of other authors, lofted from their offsets, against their stations and the volumes that came with them.

The hulls carry licences of their own and lie outside the repository: HULLFORM_SHARED points at them. The volumes are
those of 301 slices of a mesh, of a table's stations or of a formula; the loft sees some 25 stations, so that it has to
find what is between them.
"""

import numpy as np
import pytest
from lofting_accuracy import measured
from offsets_hull import HULLS, hull_names, offsets_hull

pytestmark = pytest.mark.skipif(not hull_names(), reason=f"no offsets of other hulls at {HULLS}")


@pytest.mark.parametrize("name", hull_names())
def test_a_real_hull_is_followed_station_by_station_and_lofted_whole(name: str) -> None:
    found = measured(offsets_hull(name))
    assert found.deviation_percent < 1.0
    assert found.area_error_percent < 1.0
    assert abs(found.volume_error_percent) < 0.3
    assert found.watertight
    assert found.crossings == 0
    assert abs(found.mesh_error_percent) < 0.2


@pytest.mark.parametrize("name", hull_names())
def test_one_super_ellipse_a_station_still_finds_the_volume(name: str) -> None:
    # Moulded forms without bulb 0.5 %; bulbs, chines and skegs, which the section cannot follow, 1 and 2.5 %.
    limits = {"wigley": 0.01, "container165": 0.01, "dtc": 0.01, "patrol27": 0.025, "dtmb5415": 0.03, "gunnerus": 0.03}
    found = measured(offsets_hull(name), sections="super-ellipse")
    assert found.volume_error_percent / 100 == pytest.approx(0.0, abs=limits.get(name, 0.006))
    assert found.watertight
    assert np.isfinite(found.deviation_percent)
