"""A mesh file as triangles in the ship's axes, with its vertices joined where they meet."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree

from hullform.errors import BodyPlanError
from hullform.hull.mesh_files import MESH_SUFFIXES
from hullform.ship_body_plan import METRES_PER, Axis, MeshSource

Array = NDArray[np.float64]
Faces = NDArray[np.int64]

# Of the mesh's size: vertices that are nearer to each other are one. STL keeps seven digits.
_SAME_VERTEX = 1e-6


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles in the ship's axes.

    Attributes:
        vertices: (n, 3) x, y, z in m: from the aft end forward, to port, above the base line.
        faces: (m, 3) their numbers.
    """

    vertices: Array
    faces: Faces

    @property
    def bounds(self) -> Array:
        """(2, 3) least and greatest x, y, z in m, of the vertices that a face has."""
        used = self.vertices[np.unique(self.faces)]
        return np.stack([used.min(axis=0), used.max(axis=0)])

    @cached_property
    def spans_m(self) -> Array:
        """(2, m) least and greatest x in m of every triangle."""
        x = self.vertices[self.faces, 0]
        return np.stack([x.min(axis=1), x.max(axis=1)])


def axis_vector(axis: Axis) -> Array:
    """The unit vector of an axis of the mesh."""
    vector = np.zeros(3)
    vector["xyz".index(axis[1])] = 1.0 if axis[0] == "+" else -1.0
    return vector


def in_axes_of_the_ship(vertices: Array, source: MeshSource) -> Array:
    """(n, 3) vertices of the mesh, turned, scaled to metres and moved as [body_plan] says."""
    forward, up = axis_vector(source.forward), axis_vector(source.up)
    turned = vertices @ np.stack([forward, np.cross(up, forward), up], axis=-1)
    return np.asarray(METRES_PER[source.unit] * turned + [source.origin_x_m, source.origin_y_m, source.origin_z_m])


def load_surface(source: MeshSource) -> Surface:
    """Load a mesh file.

    Raises:
        BodyPlanError: no such file, no mesh format of ours, no triangles in it.
    """
    vertices, faces = _loaded(source.file)
    if not len(faces):
        raise BodyPlanError(f"{source.file}: holds no triangles; export the hull's surface, not its lines or points")
    if not np.isfinite(vertices).all():
        raise BodyPlanError(f"{source.file}: has vertices that are not finite numbers; export it anew")
    exact, joined = (_renumbered(faces, _same(vertices, near)) for near in (0.0, _SAME_VERTEX))
    faces = joined if _open_edges(joined) < _open_edges(exact) else exact
    return Surface(in_axes_of_the_ship(vertices, source), faces)


def edges_of(faces: Faces) -> tuple[Faces, Faces, Faces]:
    """Edges (k, 2), lower number first, how many triangles each has, and how many of those run along it upwards."""
    directed = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    edges, number, count = np.unique(np.sort(directed, axis=1), axis=0, return_inverse=True, return_counts=True)
    upwards = np.bincount(number.reshape(-1), directed[:, 0] < directed[:, 1], len(edges))
    return edges, count, upwards.astype(np.int64)


def _open_edges(faces: Faces) -> int:
    return int((edges_of(faces)[1] == 1).sum())


def _renumbered(faces: Faces, number: Faces) -> Faces:
    """The triangles of joined vertices, without those that vanish and those that stand twice."""
    faces = number[faces]
    faces = faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]
    _, first = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
    return faces[np.sort(first)]


def _loaded(path: Path) -> tuple[Array, Faces]:
    if path.suffix.lower() not in MESH_SUFFIXES:
        raise BodyPlanError(
            f"{path}: '{path.suffix}' is no mesh that is read here; export the hull as {', '.join(MESH_SUFFIXES)}"
        )
    if not path.is_file():
        raise BodyPlanError(f"{path}: no such file; body_plan.mesh names it")
    import trimesh

    try:
        with warnings.catch_warnings():
            # what it has to say of a broken file is numbers that overflow; the faults are told below
            warnings.simplefilter("ignore")
            mesh = trimesh.load(path, force="mesh", process=False)
    except Exception as error:
        raise BodyPlanError(f"{path}: cannot be read as {path.suffix[1:].upper()} ({error}); export it anew") from None
    vertices, faces = getattr(mesh, "vertices", np.zeros((0, 3))), getattr(mesh, "faces", np.zeros((0, 3)))
    return np.asarray(vertices, dtype=np.float64).reshape(-1, 3), np.asarray(faces, dtype=np.int64).reshape(-1, 3)


def _same(vertices: Array, near: float) -> Faces:
    """(n,) for every vertex the number of the one that stands for all within `near` of the mesh's size."""
    distinct, group = np.unique(vertices, axis=0, return_inverse=True)
    if near > 0:
        size = float(np.linalg.norm(np.ptp(vertices, axis=0)))
        pairs = KDTree(distinct).query_pairs(near * size, output_type="ndarray")
        links = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(distinct), len(distinct)))
        group = np.asarray(connected_components(links, directed=False)[1], dtype=np.int64)[group.reshape(-1)]
    group = group.reshape(-1)
    first = np.unique(group, return_index=True)[1]
    return np.asarray(first[group], dtype=np.int64)
