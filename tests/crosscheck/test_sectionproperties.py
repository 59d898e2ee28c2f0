"""The thin-walled kernel against sectionproperties, finite elements of the solid section, on a double-hull tanker.

The midship section is our own: 40 m by 20 m, plates of 60 to 100 mm so that a mesh can follow them. Thin-wall theory
leaves out what is of the order of t over the spacing of the plates, 0.1 m in 2 m of double bottom, at the corners
alone: below 1 % of each figure. Poisson's ratio is 0, for sectionproperties' shear area takes its effect along.
"""

from __future__ import annotations

from itertools import pairwise

import pytest
from plated import Plate, network
from sectionproperties.analysis import Section
from sectionproperties.pre import Geometry
from shapely import unary_union
from shapely.geometry import LineString, Polygon

from hullform.loading.thin_walled import SectionProperties, section_properties

HALF_BREADTH, DEPTH = 20.0, 20.0
BOTTOM, SKIN = 2.4, 2.4  # height of the inner bottom, breadth of the double side
INNER = HALF_BREADTH - SKIN


def half_section(deck_from: float) -> list[Plate]:
    """Port side: shell, inner bottom to the shell, inner skin, a bulkhead and, from a place outboard, the deck."""
    bulkhead = 8.0
    deck = [y for y in (0.0, bulkhead, INNER, HALF_BREADTH) if y >= deck_from]
    levels = [(0.0, BOTTOM), (bulkhead, BOTTOM), (INNER, BOTTOM), (HALF_BREADTH, BOTTOM)]
    keel = [(0.0, 0.0), (bulkhead, 0.0), (HALF_BREADTH, 0.0)]
    plates = [(a, b, 0.08) for a, b in pairwise(keel)]
    plates += [
        ((HALF_BREADTH, 0.0), (HALF_BREADTH, BOTTOM), 0.07),
        ((HALF_BREADTH, BOTTOM), (HALF_BREADTH, DEPTH), 0.07),
    ]
    plates += [(a, b, 0.07) for a, b in pairwise(levels)]
    plates += [((INNER, BOTTOM), (INNER, DEPTH), 0.06), ((bulkhead, 0.0), (bulkhead, BOTTOM), 0.06)]
    plates += [((bulkhead, BOTTOM), (bulkhead, DEPTH), 0.06)]
    return plates + [((a, DEPTH), (b, DEPTH), 0.1) for a, b in pairwise(deck)]


def both_sides(plates: list[Plate]) -> list[Plate]:
    return plates + [((-a[0], a[1]), (-b[0], b[1]), t) for a, b, t in plates]


def solid(plates: list[Plate]) -> dict[str, float]:
    """sectionproperties' figures of the plates drawn out to their thickness."""
    walls = unary_union([LineString([a, b]).buffer(t / 2, cap_style="square") for a, b, t in plates])
    assert isinstance(walls, Polygon)
    geometry = Geometry(walls)
    geometry.create_mesh(mesh_sizes=[0.5])
    section = Section(geometry)
    section.calculate_geometric_properties()
    section.calculate_warping_properties()
    ixx, iyy, _ = section.get_ic()
    return {
        "area_m2": section.get_area(),
        "neutral_axis_m": section.get_c()[1],
        "second_moment_m4": ixx,
        "horizontal_second_moment_m4": iyy,
        "shear_area_m2": section.get_as()[1],
        "torsion_constant_m4": section.get_j(),
    }


@pytest.fixture(scope="module", params=[0.0, INNER], ids=["tanker", "open"])
def pair(request: pytest.FixtureRequest) -> tuple[dict[str, float], SectionProperties]:
    """The tanker, and the same hull as an open ship whose deck ends at the inner skin."""
    plates = half_section(request.param)
    return solid(both_sides(plates)), section_properties(network(plates, mirrored=True))


@pytest.mark.parametrize(
    "name",
    [
        "area_m2", "neutral_axis_m", "second_moment_m4", "horizontal_second_moment_m4", "shear_area_m2",
        "torsion_constant_m4",
    ],
)  # fmt: skip
def test_figures_agree(pair: tuple[dict[str, float], SectionProperties], name: str) -> None:
    theirs, ours = pair
    assert float(getattr(ours, name)) == pytest.approx(theirs[name], rel=0.01)
