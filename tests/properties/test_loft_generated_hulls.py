"""Hulls of eight families with proportions drawn at random, lofted from 21 stations: whole, and of their own volume.

The generator that draws body plans knows every hull at every place by formulas of its own: waterlines, bulbs, knuckles.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from generator import families

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.hull import Hull
from hullform.hull.crossings import crossing_triangles

# The usual eleven ordinates, halves and quarters at the ends.
ORDINATES = (0, 0.25, 0.5, 0.75, 1, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 7.5, 8, 8.5, 9, 9.25, 9.5, 9.75, 10)


@dataclass(frozen=True)
class Particulars:
    length_overall_m: float
    length_between_perpendiculars_m: float
    aft_perpendicular_m: float
    breadth_m: float
    depth_m: float
    draught_m: float


@pytest.mark.parametrize(
    ("family", "seed"),
    [
        ("container", 1),
        ("bulb", 2),
        ("bulb", 5),
        ("ferry", 3),
        ("tanker", 4),
        ("frigate", 5),
        ("chine", 6),
        ("barge", 7),
    ],
)
def test_a_generated_hull_is_lofted_whole(family: str, seed: int) -> None:
    drawn = getattr(families, family)(np.random.default_rng(seed))
    size = drawn.dimensions
    length, draught = size.length_m, size.draught_m

    def station(x: float) -> Station | None:
        curves = tuple(TracedCurve(*c.T) for c in drawn.section(x) if len(c) > 1 and c[:, 0].max() > 1e-6)
        return Station(x, "aft" if x < length / 2 else "fore", curves) if curves else None

    stations = tuple(s for ordinate in ORDINATES if (s := station(ordinate * length / 10)))
    main = Particulars(length, length, 0.0, size.breadth_m, size.depth_m, draught)
    hull = Hull.from_body_plan(BodyPlan(stations, "offsets"), main)
    x = np.linspace(0.0, length, 401)
    areas = [s.area_below(draught) if (s := station(float(place))) else 0.0 for place in x]
    # 21 stations: what lies between them is the loft's guess, 0.2 % of the volume
    assert hull.hydrostatics(draught).volume_m3 == pytest.approx(np.trapezoid(areas, x), rel=3e-3)
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(hull.volume_m3, rel=1e-3)
    assert len(crossing_triangles(mesh.vertices, mesh.faces)) == 0
