"""The closed mesh: watertight, outward, of the right volume, also where sections vanish; and its files."""

from pathlib import Path

import numpy as np
import pytest
import trimesh

from hullform.errors import OutputError
from hullform.hull import Hull, export_mesh


def hull_of(half_breadth: list[float], keel: list[float], p: float = 2.0, q: float = 2.0, top: float = 8.0) -> Hull:
    n = len(half_breadth)
    one = np.ones(n)
    return Hull.of_super_ellipses(
        np.linspace(0.0, 60.0, n), np.array(half_breadth), top - np.array(keel), top * one, p * one, q * one,
        60.0, 60.0, 0.0, 10.0, 8.0, 4.0,
    )  # fmt: skip


BODY = [4.5, 5.0, 5.0, 5.0, 4.0]
HULLS = {
    "transoms at both ends": hull_of([3.0, *BODY, 2.0], [0.0] * 7),
    "a plumb stem and stern post": hull_of([0.0, *BODY, 0.0], [0.0] * 7),
    "ends that are points": hull_of([0.0, *BODY, 0.0], [8.0, 3.0, 0.0, 0.0, 0.0, 0.0, 8.0]),
    "a transom of no depth": hull_of([4.0, *BODY, 0.0], [8.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
    "hollow sections with a cusp at the keel": hull_of([1.0, *BODY, 0.0], [0.0] * 7, p=0.3, q=0.5),
    "sharp bilges": hull_of([4.0, *BODY, 3.0], [0.0] * 7, p=40.0, q=40.0),
    "two sections of no breadth at the stem": hull_of([3.0, *BODY, 0.0, 0.0], [0.0] * 8),
}


@pytest.mark.parametrize("name", HULLS)
def test_mesh_is_a_closed_body_with_outward_normals(name: str) -> None:
    mesh = HULLS[name].mesh()
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume > 0
    assert mesh.euler_number == 2
    assert len(np.unique(np.sort(mesh.faces, axis=1), axis=0)) == len(mesh.faces)
    assert mesh.area_faces.min() > 0
    # A plate without thickness, between two sections of no breadth, has no inside and is left out.
    breadth = HULLS[name].half_breadth_m > 0
    bounds_a_body = breadth | np.append(breadth[1:], False) | np.insert(breadth[:-1], 0, False)
    assert mesh.bounds[:, 0] == pytest.approx(HULLS[name].x_m[bounds_a_body][[0, -1]])
    centre = mesh.center_mass
    assert centre[1] == pytest.approx(0.0, abs=1e-9)


SMOOTH = np.linspace(-1.0, 1.0, 100)


@pytest.mark.parametrize(
    ("ends", "middle"), [((2.0, 1.5), (8.0, 4.5)), ((0.35, 1.8), (12.0, 12.0)), ((0.9, 0.8), (20.0, 20.0))]
)
@pytest.mark.parametrize("keel_rise", [0.0, 6.0, 8.0])
@pytest.mark.parametrize("end_breadth", [0.0, 2.0])
def test_mesh_of_a_lofted_hull_has_the_volume_of_its_sections(
    ends: tuple[float, float], middle: tuple[float, float], keel_rise: float, end_breadth: float
) -> None:
    full = 1 - SMOOTH**4
    p, q = (np.exp(np.log(end) * (1 - full) + np.log(mid) * full) for end, mid in zip(ends, middle, strict=True))
    top = 8.0 + 0.5 * SMOOTH**2
    hull = Hull.of_super_ellipses(
        30.0 * (1 + SMOOTH), end_breadth + (5.0 - end_breadth) * full, (8.0 - keel_rise * SMOOTH**6) + top - 8.0, top,
        p, q, 60.0, 60.0, 0.0, 10.0, 8.0, 4.0,
    )  # fmt: skip
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(hull.volume_m3, rel=1e-3)


def test_deck_lies_at_the_sheer_and_ends_are_plane() -> None:
    hull = HULLS["transoms at both ends"]
    mesh = hull.mesh()
    deck = mesh.area_faces[mesh.face_normals[:, 2] > 1 - 1e-12].sum()
    assert deck == pytest.approx(np.trapezoid(2 * hull.half_breadth_m, hull.x_m), rel=1e-12)
    for x, normal in ((0.0, -1.0), (60.0, 1.0)):
        at_end = (np.abs(mesh.triangles_center[:, 0] - x) < 1e-9) & (mesh.face_normals[:, 0] * normal > 1 - 1e-9)
        area = hull.sectional_areas()[0 if x == 0 else -1]
        assert mesh.area_faces[at_end].sum() == pytest.approx(area, rel=1e-3)


@pytest.mark.parametrize("suffix", [".stl", ".obj", ".ply", ".glb", ".STL"])
def test_files_read_back_with_the_same_volume(tmp_path: Path, suffix: str) -> None:
    hull = HULLS["a plumb stem and stern post"]
    path = export_mesh(hull, tmp_path / f"hull{suffix}")
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]
    read = trimesh.load_mesh(path)
    # STL and PLY hold single precision.
    assert read.volume == pytest.approx(hull.mesh().volume, rel=1e-5)
    assert read.is_watertight


def test_another_suffix_is_refused_with_the_four_that_serve(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match=r"\.stl, \.obj, \.ply, \.glb, not in '\.step'"):
        export_mesh(HULLS["sharp bilges"], tmp_path / "hull.step")
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match=r"nowhere/hull\.stl: cannot be written"):
        export_mesh(HULLS["sharp bilges"], tmp_path / "nowhere" / "hull.stl")


def test_an_existing_file_is_replaced_whole(tmp_path: Path) -> None:
    target = tmp_path / "hull.stl"
    target.write_text("old")
    export_mesh(HULLS["sharp bilges"], target)
    assert target.stat().st_size > 1000
