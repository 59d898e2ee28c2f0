"""Shell area and second moment against a polygon ring that shapely draws round the same curve."""

import numpy as np
import pytest

from hullform.hull import SuperEllipse

shapely = pytest.importorskip("shapely")


def polygon_moments(ring: np.ndarray) -> tuple[float, float, float]:
    """Area, Int z dA and Int z^2 dA of a closed polygon by Green's theorem."""
    y, z = ring[:-1].T
    y1, z1 = ring[1:].T
    cross = y * z1 - y1 * z
    return (
        float(cross.sum() / 2),
        float((cross * (z + z1)).sum() / 6),
        float((cross * (z**2 + z * z1 + z1**2)).sum() / 12),
    )


@pytest.mark.parametrize(
    ("half_breadth", "depth", "p", "q"),
    [
        (16.1, 19.5, 2.0, 2.0),
        (16.1, 19.5, 10.0, 10.0),
        (22.0, 21.5, 20.0, 20.0),
        (6.0, 18.0, 0.8, 1.4),
        (9.0, 12, 1, 3),
    ],
)
def test_shell_against_a_buffered_polygon(half_breadth: float, depth: float, p: float, q: float) -> None:
    thickness = 0.016
    section = SuperEllipse(half_breadth, depth, p, q)
    port = section.points(1201) * [1.0, -1.0]
    starboard = (port * [-1.0, 1.0])[::-1]
    outline = shapely.LinearRing(np.concatenate([port, starboard[:-1]]))
    wall = outline.buffer(thickness / 2, join_style="mitre", quad_segs=4)
    area, first, second = np.array(
        polygon_moments(np.asarray(shapely.geometry.polygon.orient(shapely.Polygon(wall.exterior)).exterior.coords))
    ) - np.array(
        polygon_moments(np.asarray(shapely.geometry.polygon.orient(shapely.Polygon(wall.interiors[0])).exterior.coords))
    )
    shell = section.shell(thickness)
    # A wall of thickness t differs from its mid-line by the curvature, of order (t / R)^2, and by the mitres at the
    # deck edge, of order t^2 in area: t / girth = 2e-4; the polygon's sagitta is smaller.
    assert shell.area == pytest.approx(area, rel=5e-4)
    assert shell.neutral_axis_below_top == pytest.approx(-first / area, rel=5e-4)
    assert shell.second_moment == pytest.approx(second - first**2 / area, rel=5e-4)


def test_section_area_and_centroid_against_a_polygon() -> None:
    section = SuperEllipse(16.1, 19.5, 0.6, 1.3)
    port = section.points(2001) * [1.0, -1.0]
    whole = shapely.Polygon(np.concatenate([port, (port * [-1.0, 1.0])[::-1]]))
    # The polygon has its corners on a hollow curve: too large by its sagitta, of the order of 1 / 2000^2.
    assert whole.area == pytest.approx(section.area, rel=1e-5)
    assert -whole.centroid.y == pytest.approx(section.centroid_below_top, rel=1e-5)
