"""Hulls of eight families with proportions drawn at random, lofted from 21 stations: whole, and of their own volume.

The generator that draws body plans knows every hull at every place by formulas of its own: waterlines, bulbs, knuckles.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from generator import families
from generator.sections import Hull as Drawn

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.hull import Hull
from hullform.hull.crossings import crossing_triangles
from hullform.profile import Profile

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


def station_of(drawn: Drawn, x: float) -> Station | None:
    """The section of a generated hull, if she has one there."""
    curves = tuple(TracedCurve(*c.T) for c in drawn.section(x) if len(c) > 1 and c[:, 0].max() > 1e-6)
    return Station(x, "aft" if x < drawn.dimensions.length_m / 2 else "fore", curves) if curves else None


def profile_of(drawn: Drawn) -> Profile:
    """Where 340 sections of a generated hull meet the centre plane, closed to the deck at both ends."""
    length = drawn.dimensions.length_m
    shares = np.concatenate([np.linspace(0, 0.25, 151), np.linspace(0.26, 0.74, 39), np.linspace(0.75, 1, 151)])
    sections = [(x, s.curves) for x in (shares * length).tolist() if (s := station_of(drawn, x))]
    feet = [(x, curves[0].height_m[0]) for x, curves in sections]
    bulb = [(x, curves[0].height_m[-1], curves[1].height_m[0]) for x, curves in sections if len(curves) == 2]
    tip = bulb[-1][0] if bulb else length
    points = [
        (feet[0][0], drawn.sheer(feet[0][0])),
        *(foot for foot in feet if foot[0] <= tip),
        *((x, head) for x, head, _ in bulb[::-1]),
        *((x, stem) for x, _, stem in bulb),
        *(foot for foot in feet if foot[0] > tip),
        (length, drawn.sheer(length)),
    ]
    return Profile(*np.array(points).T)


@pytest.mark.parametrize("with_profile", [False, True], ids=["estimated", "profile"])
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
def test_a_generated_hull_is_lofted_whole(family: str, seed: int, with_profile: bool) -> None:
    drawn = getattr(families, family)(np.random.default_rng(seed))
    size = drawn.dimensions
    length, draught = size.length_m, size.draught_m

    stations = tuple(s for ordinate in ORDINATES if (s := station_of(drawn, ordinate * length / 10)))
    main = Particulars(length, length, 0.0, size.breadth_m, size.depth_m, draught)
    profile = profile_of(drawn) if with_profile else None
    hull = Hull.from_body_plan(BodyPlan(stations, "offsets", profile=profile), main)
    assert hull.doubts == ()
    x = np.linspace(0.0, length, 401)
    areas = [s.area_below(draught) if (s := station_of(drawn, float(place))) else 0.0 for place in x]
    # 21 stations: what lies between them is the loft's guess, 0.2 % of the volume
    assert hull.hydrostatics(draught).volume_m3 == pytest.approx(np.trapezoid(areas, x), rel=3e-3)
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(hull.volume_m3, rel=1e-3)
    assert len(crossing_triangles(mesh.vertices, mesh.faces)) == 0
    if profile is not None:
        # estimated feet lie up to 16 % of the breadth off; straight lines between lofted places, and a bulb's tip that
        # falls between two of them, leave a hundredth of the length out
        place = np.linspace(profile.from_m, profile.to_m, 601)[3:-3]
        off = np.abs(hull.sections_at(place).keel - profile.at(place).foot)
        assert np.nanquantile(off, 0.99) < 0.005 * size.breadth_m
