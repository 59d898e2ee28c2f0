"""The mesh door: a hull through a file and back, dirty files mended or refused, and every message."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from form_ship import SHIP, form_ship
from numpy.typing import NDArray

from hullform import Hull, trace
from hullform.body_plan import BodyPlan
from hullform.errors import BodyPlanError
from hullform.hull.mesh_files import export_mesh

Array = NDArray[np.float64]
DRAUGHT = 11.0


@pytest.fixture(scope="module")
def hull(tmp_path_factory: pytest.TempPathFactory) -> Hull:
    """A bulk carrier with counter, transom, raking stem and flare."""
    ship = form_ship(tmp_path_factory.mktemp("form"))
    return Hull.from_body_plan(trace(ship), ship.particulars)


@pytest.fixture
def mesh(hull: Hull) -> trimesh.Trimesh:
    """The hull as a mesh of the test's own, which it may turn and spoil."""
    return hull.mesh()


def read(folder: Path, mesh: trimesh.Trimesh, keys: str = "", ship: str = SHIP) -> BodyPlan:
    mesh.export(folder / "hull.stl")
    return trace(form_ship(folder, f'[body_plan]\nmesh = "hull.stl"\n{keys}', ship))


def lofted(body_plan: BodyPlan, like: Hull) -> Hull:
    class Particulars:
        length_overall_m = like.length_overall_m
        length_between_perpendiculars_m = like.length_between_perpendiculars_m
        aft_perpendicular_m = like.aft_perpendicular_m
        breadth_m = like.breadth_m
        depth_m = like.depth_moulded_m
        draught_m = like.draught_m

    return Hull.from_body_plan(body_plan, Particulars())


SLIVER = 5e-5


def assert_same(one: Hull, other: Hull, places: Array, volume: float = 1e-3, area: float = 3e-3) -> None:
    """Volume within 0.1 %; every sectional area within 0.3 % of itself, slivers within 0.005 % of the largest.

    Slivers are those below a hundredth of the largest. The reader cuts no more stations where areas between them are
    off by less than 0.02 % of the largest (`mesh_reading._LEAST_OFF`). Of the wedge at the stem, of 0.75 m2 between
    the last two stations, it leaves 0.0035 %, all of it breadth: the wedge begins where it should to 0.1 mm.
    """
    assert one.volume_m3 == pytest.approx(other.volume_m3, rel=volume)
    for draught in (None, DRAUGHT):
        of_one, of_other = one.sectional_areas(draught, places), other.sectional_areas(draught, places)
        assert np.abs(of_one - of_other)[of_other < 0.01 * of_other.max()].max() < SLIVER * of_other.max()
        full = of_other > 0.01 * of_other.max()
        np.testing.assert_allclose(of_one[full], of_other[full], rtol=area)


@pytest.mark.parametrize("suffix", [".stl", ".obj", ".ply", ".glb"])
def test_a_hull_comes_back_through_a_file(tmp_path: Path, hull: Hull, suffix: str) -> None:
    export_mesh(hull, tmp_path / f"hull{suffix}")
    body_plan = trace(form_ship(tmp_path, f'[body_plan]\nmesh = "hull{suffix}"\n'))
    assert (body_plan.source, body_plan.doubts) == ("mesh", ())
    assert_same(lofted(body_plan, hull), hull, hull.x_m[1:-1])
    # and stations in rows of the mesh have the area of the hull there: chords of 49 points a side lose 0.03 %
    in_rows = [s for s in body_plan.stations if np.abs(hull.x_m - s.x_m).min() < 1e-3]
    assert len(in_rows) > 20
    for station in in_rows[1:-1]:
        own = float(hull.sectional_areas(x_m=station.x_m))
        assert station.area_below(np.inf) == pytest.approx(own, rel=1e-3)


def test_stations_stand_where_they_are_asked_for(tmp_path: Path, mesh: trimesh.Trimesh) -> None:
    body_plan = read(tmp_path, mesh, "stations_m = [2.0, 95.0, 150.0, 188.0]")
    assert [station.x_m for station in body_plan.stations] == [2.0, 95.0, 150.0, 188.0]
    assert [station.half for station in body_plan.stations] == ["aft", "aft", "fore", "fore"]


@pytest.mark.parametrize(
    ("turn", "keys"),
    [
        # where x, y, z of the ship go in the mesh, and its unit and origin
        (lambda v: v * 1000, 'unit = "mm"'),
        (lambda v: v / 0.3048, 'unit = "ft"'),
        (lambda v: v[:, [1, 2, 0]] * [1, 1, -1], 'forward = "-z"\nup = "+y"'),
        (lambda v: v[:, [0, 2, 1]] * [-1, 1, 1], 'forward = "-x"\nup = "+y"'),
        (lambda v: v - [5.0, 0, 0], "origin_x_m = 5.0"),
        (lambda v: v - [95.0, 15.0, 11.0], "origin_x_m = 95.0\norigin_y_m = 15.0\norigin_z_m = 11.0"),
    ],
)
def test_the_axes_are_where_the_ship_file_says(
    tmp_path: Path, hull: Hull, mesh: trimesh.Trimesh, turn: object, keys: str
) -> None:
    moved = trimesh.Trimesh(turn(mesh.vertices), mesh.faces, process=False)  # type: ignore[operator]
    # areas of a few stations are enough to tell one axis from another; the hull has neither fore-and-aft nor
    # up-and-down symmetry
    body_plan = read(tmp_path, moved, keys + "\nstations_m = [10.0, 60.0, 120.0, 180.0]")
    assert body_plan.doubts == ()
    for station in body_plan.stations:
        own = float(hull.sectional_areas(DRAUGHT, station.x_m))
        assert station.area_below(DRAUGHT) == pytest.approx(own, rel=3e-3)


def dirty(mesh: trimesh.Trimesh, kind: str) -> trimesh.Trimesh:
    """One of the meshes that CAD hands out."""
    vertices, faces = mesh.vertices.copy(), mesh.faces.copy()
    if kind == "flipped":
        faces[::5] = faces[::5, ::-1]
    elif kind == "inside out":
        faces = faces[:, ::-1]
    elif kind == "doubled":
        # every triangle has vertices of its own, a tenth of a millimetre off
        shaken = np.random.default_rng(3).uniform(-5e-5, 5e-5, (3 * len(faces), 3))
        vertices, faces = vertices[faces].reshape(-1, 3) + shaken, np.arange(3 * len(faces)).reshape(-1, 3)
    elif kind == "hole":
        middle = mesh.triangles_center
        near = (np.abs(middle[:, 0] - 40) < 6) & (np.abs(middle[:, 2] - 6) < 0.8) & (middle[:, 1] > 0)
        assert near.sum() > 10
        faces = faces[~near]
    elif kind == "open":
        normal = mesh.face_normals
        faces = faces[~((normal[:, 2] > 0.99) & (mesh.triangles_center[:, 2] > 16.9))]
    elif kind == "half":
        faces = faces[(vertices[faces, 1] >= 0).all(axis=1)]
    elif kind == "other half":
        faces = faces[(vertices[faces, 1] <= 0).all(axis=1)]
    return trimesh.Trimesh(vertices, faces, process=False)


@pytest.mark.parametrize(
    ("kind", "told"),
    [
        ("flipped", "wound against each other (flipped normals); the sections do not depend on the winding"),
        ("inside out", "the normals of the mesh point inwards"),
        ("doubled", None),
        ("hole", "a hole was closed by straight lines in"),
        ("open", "the mesh is open along"),
        ("half", "the mesh is of one side; the other is taken for its mirror image"),
        ("other half", "the mesh is of one side; the other is taken for its mirror image"),
    ],
)
def test_a_dirty_mesh_is_mended_and_told(
    tmp_path: Path, hull: Hull, mesh: trimesh.Trimesh, kind: str, told: str | None
) -> None:
    spoilt = dirty(mesh, kind)
    assert not (spoilt.is_watertight and spoilt.is_winding_consistent and spoilt.volume > 0)
    # through rows of the mesh, where its facets have the areas of the hull; the hole reaches from 34 to 46 m
    rows = np.sort([*hull.x_m[3:-3:8], hull.x_m[np.abs(hull.x_m - 40.0).argmin()]])
    body_plan = read(tmp_path, spoilt, f"stations_m = {rows.tolist()}")
    assert body_plan.doubts == ()
    if told:
        assert any(told in note for note in body_plan.notes), body_plan.notes
    else:
        # joined again: nothing is left to tell
        assert len(body_plan.notes) == 1
    for station in body_plan.stations:
        own = float(hull.sectional_areas(x_m=station.x_m))
        # of 0.3 % asked for; a tenth of a millimetre off, a triangle more or less is passed
        assert station.area_below(np.inf) == pytest.approx(own, rel=1e-3)


@pytest.mark.parametrize(
    ("turn", "keys", "told"),
    [
        (lambda v: v * 1000, "", 'write unit = "mm" in [body_plan]'),
        (lambda v: v * 100, "", 'write unit = "cm" in [body_plan]'),
        (lambda v: v, 'unit = "in"', 'write unit = "m" in [body_plan]'),
        (lambda v: v[:, [1, 0, 2]], "", 'write forward = "+y" and up = "+z"'),
        (lambda v: 1000 * v[:, [2, 1, 0]], "", 'write unit = "mm", forward = "+z" and up = "+x"'),
        (lambda v: v * [0.5, 1, 1], "", "it is another ship, or only a part of this one"),
        (lambda v: v * [1.02, 1, 1], "", "the mesh is 193.8 m long, the ship 190 m: correct length_overall_m"),
        (lambda v: v - [5.0, 0, 0], "", "from x = -5 to 185 m, the ship from 0 to 190 m"),
        (lambda v: v - [5.0, 0, 0], "", "origin_x_m = 5 for a mesh that begins at the aft end"),
        (lambda v: v - [0, -4.0, 0], "", "write origin_y_m = -4 for a mesh of both sides"),
        (lambda v: v - [0, 0, 11.0], "", "origin_z_m = 11 for a keel on the base line"),
        (lambda v: v * [1, 1, -1], "", 'where she lies on her back, write up = "-z" first'),
    ],
)
def test_a_mesh_of_another_size_or_place_says_what_to_write(
    tmp_path: Path, mesh: trimesh.Trimesh, turn: object, keys: str, told: str
) -> None:
    moved = trimesh.Trimesh(turn(mesh.vertices), mesh.faces, process=False)  # type: ignore[operator]
    with pytest.raises(BodyPlanError) as raised:
        read(tmp_path, moved, keys)
    assert told in str(raised.value)
    assert str(raised.value).startswith(str(tmp_path / "hull.stl"))


@pytest.mark.parametrize(("side", "moved"), [(1, 2.0), (1, -2.0), (-1, 2.0), (-1, -2.0)])
def test_half_a_mesh_off_the_centre_plane_says_what_to_write(
    tmp_path: Path, mesh: trimesh.Trimesh, side: int, moved: float
) -> None:
    half = trimesh.Trimesh(mesh.vertices, mesh.faces[(side * mesh.vertices[mesh.faces, 1] >= 0).all(axis=1)])
    half.apply_translation([0, moved, 0])
    with pytest.raises(BodyPlanError, match=f"write origin_y_m = {-moved:g} for a mesh of one side"):
        read(tmp_path, half)


def test_a_wide_hole_is_refused_with_its_place(tmp_path: Path, mesh: trimesh.Trimesh) -> None:
    middle = mesh.triangles_center
    near = (np.abs(middle[:, 0] - 60) < 9) & (np.abs(middle[:, 2] - 6) < 4) & (middle[:, 1] > 0)
    with pytest.raises(BodyPlanError, match=r"ends in the air at z = \d.*wider than 3 m or at an inner deck"):
        read(tmp_path, trimesh.Trimesh(mesh.vertices, mesh.faces[~near], process=False))


@pytest.mark.parametrize(
    ("extents", "middle", "told"),
    [
        ([60, 20, 6], [95, 0, 6], r"has one contour within another, from z = 3 to 9 m; export the outer shell alone"),
        ([60, 4, 4], [95, 9, 7], None),
    ],
)
def test_tanks_within_the_hull_are_refused_or_left_out(
    tmp_path: Path, mesh: trimesh.Trimesh, extents: list[float], middle: list[float], told: str | None
) -> None:
    tank = trimesh.creation.box(extents, trimesh.transformations.translation_matrix(middle))
    together = trimesh.util.concatenate([mesh, tank])
    if told:
        with pytest.raises(BodyPlanError, match=told):
            read(tmp_path, together)
    else:
        doubts = read(tmp_path, together, "stations_m = [10.0, 60.0, 95.0, 180.0]").doubts
        assert any("1 sections have a part clear of the centre plane, which was left out" in d for d in doubts)


def test_a_deckhouse_is_cut_off_at_a_height(tmp_path: Path, hull: Hull, mesh: trimesh.Trimesh) -> None:
    house = trimesh.creation.box([20, 24, 12], trimesh.transformations.translation_matrix([30, 0, 23.0]))
    keys = "up_to_m = 16.9\nstations_m = [10.0, 30.0, 95.0, 180.0]"
    body_plan = read(tmp_path, trimesh.util.concatenate([mesh, house]), keys)
    assert body_plan.doubts == ()
    for station in body_plan.stations:
        assert station.curves[0].height_m.max() == pytest.approx(16.9)
        own = float(hull.sectional_areas(16.9, station.x_m))
        assert station.area_below(np.inf) == pytest.approx(own, rel=3e-3)


def test_a_deckhouse_that_nobody_cut_off_is_told(tmp_path: Path, mesh: trimesh.Trimesh) -> None:
    house = trimesh.creation.box([20, 24, 12], trimesh.transformations.translation_matrix([30, 0, 23.0]))
    doubts = read(tmp_path, trimesh.util.concatenate([mesh, house]), "stations_m = [10.0, 30.0, 95.0, 180.0]").doubts
    assert any("write up_to_m = " in doubt for doubt in doubts)


def test_a_hull_half_as_high_as_broad_that_lies_on_its_side_is_told(tmp_path: Path, mesh: trimesh.Trimesh) -> None:
    # 15 m high and 30 m broad: on her side she is as broad as one side of the ship alone
    low = mesh.vertices * [1, 1, 15.0 / 17.0]
    on_her_side = trimesh.Trimesh(low[:, [0, 2, 1]], mesh.faces, process=False)
    with pytest.raises(BodyPlanError, match=r'write forward = "\+x" and up = "\+y"'):
        read(tmp_path, on_her_side, ship=SHIP.replace("depth_m = 17.0", "depth_m = 15.0"))


def test_a_mesh_of_topsides_alone_is_read_and_doubted(tmp_path: Path, mesh: trimesh.Trimesh) -> None:
    # all of it above the design draught: there is nothing to measure by below it
    raised = trimesh.Trimesh(mesh.vertices * [1, 1, 0.1] + [0, 0, 2.4], mesh.faces, process=False)
    doubts = read(tmp_path, raised, ship=SHIP.replace("draught_m = 11.0", "draught_m = 2.0")).doubts
    assert doubts == ()


def test_two_hulls_side_by_side_are_refused(tmp_path: Path, mesh: trimesh.Trimesh) -> None:
    hulls = [mesh.copy().apply_scale([1, 0.3, 1]).apply_translation([0, y, 0]) for y in (-10.5, 10.5)]
    with pytest.raises(BodyPlanError, match="no section of the mesh reaches the centre plane"):
        read(tmp_path, trimesh.util.concatenate(hulls))


def test_two_sides_that_differ_are_doubted(tmp_path: Path, mesh: trimesh.Trimesh) -> None:
    vertices = mesh.vertices * np.where(mesh.vertices[:, 1:2] < 0, [1, 0.98, 1], 1.0)
    doubts = read(tmp_path, trimesh.Trimesh(vertices, mesh.faces, process=False)).doubts
    assert any("the two sides differ in" in doubt for doubt in doubts)


def test_a_mesh_that_is_short_broad_or_low_is_doubted(tmp_path: Path, mesh: trimesh.Trimesh) -> None:
    short = read(tmp_path, trimesh.Trimesh(mesh.vertices * [0.95, 1.04, 1], mesh.faces, process=False)).doubts
    assert any("short of the ship's 0 to 190 m by more than 1 %" in doubt for doubt in short)
    assert any("31.2 m broad, +4.0 % off breadth_m, limit 1 %" in doubt for doubt in short)
    low = read(tmp_path, trimesh.Trimesh(mesh.vertices * [1, 1, 0.6], mesh.faces, process=False)).doubts
    assert any("below the design draught of 11 m; export the hull up to her deck" in doubt for doubt in low)


def test_a_station_without_a_section_is_doubted(tmp_path: Path, mesh: trimesh.Trimesh) -> None:
    doubts = read(tmp_path, mesh, "stations_m = [0.0, 20.0, 95.0, 180.0]").doubts
    assert any("there is no section at x = 0 m" in doubt for doubt in doubts)


@pytest.mark.parametrize(
    ("name", "content", "told"),
    [
        ("hull.stl", None, r"hull\.stl: no such file; body_plan\.mesh names it"),
        ("hull.step", b"ISO-10303-21;", r"'\.step' is no mesh that is read here; export the hull as \.stl, \.obj"),
        ("hull.stl", b"", r"hull\.stl: (holds no triangles|cannot be read as STL)"),
        ("hull.stl", b"solid nothing\nendsolid nothing\n", r"hull\.stl: (holds no triangles|cannot be read as STL)"),
        ("hull.ply", b"no ply at all", r"hull\.ply: cannot be read as PLY"),
        ("hull.obj", b"v 0 0 0\nv 1 0 0\nl 1 2\n", r"hull\.obj: (holds no triangles|cannot be read as OBJ)"),
    ],
)
def test_a_file_that_is_no_mesh_is_told(tmp_path: Path, name: str, content: bytes | None, told: str) -> None:
    if content is not None:
        (tmp_path / name).write_bytes(content)
    with pytest.raises(BodyPlanError, match=told):
        trace(form_ship(tmp_path, f'[body_plan]\nmesh = "{name}"\n'))


def test_vertices_that_are_no_numbers_are_told(tmp_path: Path, mesh: trimesh.Trimesh) -> None:
    vertices = mesh.vertices.copy()
    vertices[7] = np.nan
    with pytest.raises(BodyPlanError, match="has vertices that are not finite numbers"):
        read(tmp_path, trimesh.Trimesh(vertices, mesh.faces, process=False))
