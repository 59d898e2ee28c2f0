"""Our own cut of a mesh: exact on shapes that are known, and whole on meshes that are not."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

from hullform.doors.cutting import cut
from hullform.doors.half_sections import HalfSection, Sizes, half_section
from hullform.doors.surface import Surface

Array = NDArray[np.float64]
SIZES = Sizes(centre=1e-5, seam=1e-3, bridge=1.0, deck=5.0)


def surface(mesh: trimesh.Trimesh) -> Surface:
    return Surface(np.asarray(mesh.vertices), np.asarray(mesh.faces))


def box(length: float = 20.0, breadth: float = 10.0, depth: float = 8.0) -> trimesh.Trimesh:
    """A barge on the base line, from x = 0."""
    return trimesh.creation.box([length, breadth, depth], trimesh.transformations.translation_matrix([10, 0, 4]))


def cylinder(radius: float, height: float, low: float = 0.0) -> trimesh.Trimesh:
    """A round body along the ship, 24 to 30 m, its lowest point at `low`."""
    round_body = trimesh.creation.cylinder(radius, height, sections=64)
    round_body.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 2, [0, 1, 0]))
    round_body.apply_translation([10, 0, low + radius])
    return round_body


def halves(mesh: trimesh.Trimesh, x: float, side: int = 1, sizes: Sizes = SIZES) -> HalfSection:
    return half_section(cut(surface(mesh), x), side, sizes)


def area(section: HalfSection) -> float:
    return sum(float(np.sum((c[1:, 0] + c[:-1, 0]) * np.diff(c[:, 1])) / 2) for c in section.curves)


@pytest.mark.parametrize("x", [1e-6, 3.3, 10.0, 20.0 - 1e-6])
def test_a_box_is_cut_into_its_rectangle_without_its_deck(x: float) -> None:
    (chain,) = cut(surface(box()), x)
    assert chain.closed
    y, z = chain.points.T
    assert abs(0.5 * np.sum(y * np.roll(z, -1) - z * np.roll(y, -1))) == pytest.approx(80.0, rel=1e-12)
    (curve,) = halves(box(), x).curves
    assert curve[0].tolist() == [0.0, 0.0]
    assert curve[-1] == pytest.approx([5.0, 8.0])
    assert (curve[:, 0] <= 5.0).all()


def test_a_plane_off_the_mesh_cuts_nothing_and_one_through_vertices_cuts_what_is_abaft() -> None:
    assert cut(surface(box()), -1.0) == []
    assert cut(surface(box()), 0.0) == []
    assert len(cut(surface(box()), 20.0)) == 1


def test_every_triangle_is_cut_once_where_planes_go_through_vertices() -> None:
    # an ellipsoid of rings: every plane of its vertices gives one closed chain
    ball = trimesh.creation.uv_sphere(5.0, count=[24, 24])
    ball.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 2, [0, 1, 0]))
    for x in np.unique(ball.vertices[:, 0].round(12))[1:]:
        (chain,) = cut(surface(ball), float(x))
        assert chain.closed


def test_the_winding_of_triangles_does_not_matter() -> None:
    mesh = cylinder(3.0, 6.0)
    turned = mesh.faces.copy()
    turned[::3] = turned[::3, ::-1]
    assert area(halves(trimesh.Trimesh(mesh.vertices, turned, process=False), 9.0)) == area(halves(mesh, 9.0))


def test_a_round_top_below_the_water_is_no_deck() -> None:
    # 64 sides: the polygon's half area is 32 r^2 sin(pi / 32) / 2
    expected = 0.5 * 32 * 3.0**2 * np.sin(np.pi / 32)
    deep = Sizes(centre=1e-5, seam=1e-3, bridge=1.0, deck=7.0)
    (curve,) = halves(cylinder(3.0, 6.0), 9.0, sizes=deep).curves
    assert curve[-1] == pytest.approx([0.0, 6.0])
    assert area(halves(cylinder(3.0, 6.0), 9.0, sizes=deep)) == pytest.approx(expected, rel=1e-9)


def test_a_cambered_deck_is_left_out_and_a_flare_is_not() -> None:
    # half section, keel to deck, of a flared body with a deck that rises to the middle
    y, z = np.array([0.0, 2.0, 6.0, 0.0]), np.array([0.0, 3.0, 8.0, 8.4])
    rim = np.array([[x, s * b, h] for x in (0.0, 20.0) for s in (1, -1) for b, h in zip(y, z, strict=True)])
    hull = trimesh.convex.convex_hull(rim)
    (curve,) = halves(hull, 10.0).curves
    assert curve[-1] == pytest.approx([6.0, 8.0])


def test_a_bulb_below_a_flare_gives_two_curves_the_lower_first() -> None:
    flare = box(depth=8.0)
    flare.apply_translation([0, 0, 7.0])
    both = trimesh.util.concatenate([flare, cylinder(2.0, 20.0, low=0.5)])
    low, high = halves(both, 10.0, sizes=Sizes(1e-5, 1e-3, 1.0, 6.0)).curves
    assert (low[0], low[-1]) == (pytest.approx([0.0, 0.5]), pytest.approx([0.0, 4.5]))
    assert (high[0], high[-1]) == (pytest.approx([0.0, 7.0]), pytest.approx([5.0, 15.0]))


@pytest.mark.parametrize("side", [1, -1])
def test_one_side_and_an_open_deck_are_enough(side: int) -> None:
    whole = box()
    port = trimesh.intersections.slice_mesh_plane(whole, [0, side, 0], [0, 0, 0])
    no_deck = port.faces[~(port.vertices[port.faces, 2] == 8.0).all(axis=1)]
    open_half = trimesh.Trimesh(port.vertices, no_deck, process=False)
    open_half.merge_vertices()
    (chain,) = cut(surface(open_half), 7.0)
    assert not chain.closed
    (curve,) = halves(open_half, 7.0, side).curves
    assert curve[0].tolist() == [0.0, 0.0]
    assert curve[-1] == pytest.approx([5.0, 8.0])


def holed(mesh: trimesh.Trimesh, low: Array, high: Array) -> trimesh.Trimesh:
    """A mesh of small triangles without those whose middle lies between two corners."""
    fine = mesh.subdivide_to_size(0.4)
    middle = fine.triangles_center
    inside = ((middle > low) & (middle < high)).all(axis=1)
    assert inside.any()
    return trimesh.Trimesh(fine.vertices, fine.faces[~inside], process=False)


@pytest.mark.parametrize(
    ("low", "high"),
    [
        # in the side, in the bottom beside the keel, and through the keel
        ([5, 4.9, 3], [15, 5.1, 4]),
        ([5, 2.0, -0.1], [15, 2.8, 0.1]),
        ([5, -0.4, -0.1], [15, 0.4, 0.1]),
    ],
)
def test_a_small_hole_is_bridged_and_told(low: list[float], high: list[float]) -> None:
    section = halves(holed(box(), np.array(low), np.array(high)), 10.0)
    ((_, width),) = section.bridged
    assert 0.4 <= width <= 1.0
    assert section.open_at_m is None
    # flat faces: a straight line puts back what was there
    assert area(section) == pytest.approx(40.0, rel=1e-9)


def test_a_wide_hole_is_told_with_its_height() -> None:
    section = halves(holed(box(), np.array([5, 4.9, 2]), np.array([15, 5.1, 6])), 10.0)
    assert section.open_at_m == pytest.approx(2.0, abs=0.5)


def test_hatches_in_the_deck_leave_the_section_as_it_is() -> None:
    section = halves(holed(box(), np.array([2, -2.5, 7.9]), np.array([18, 2.5, 8.1])), 10.0)
    (curve,) = section.curves
    assert curve[-1] == pytest.approx([5.0, 8.0])
    assert (section.open_at_m, section.bridged) == (None, ())
    assert area(section) == pytest.approx(40.0)


def test_what_is_clear_of_the_centre_plane_is_left_out_with_its_area() -> None:
    pods = [cylinder(0.5, 20.0, low=-2.0).apply_translation([0, s * 3.0, 0]) for s in (1, -1)]
    section = halves(trimesh.util.concatenate([box(), *pods]), 10.0)
    assert area(section) == pytest.approx(40.0)
    assert section.apart_m2 == pytest.approx(np.pi * 0.25, rel=0.01)


def test_a_section_is_cut_off_at_a_height() -> None:
    section = half_section(cut(surface(box()), 10.0), 1, SIZES, up_to_m=6.5)
    (curve,) = section.curves
    assert curve[-1] == pytest.approx([5.0, 6.5])
