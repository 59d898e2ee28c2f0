"""Panels of the wetted half hull, and their geometry."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError
from hullvib.wet.sections import Sections

Array = NDArray[np.float64]

MOST_PANELS = 4000  # of half a hull: two full matrices of them fill a quarter of a gigabyte
_SLIVER = 1e-6  # of the largest panel: smaller ones are the closed ends of rows
_GRADING = 0.85  # 0 spaces sections evenly, 1 by a cosine
_TOLERANCE = 1e-6  # of the extent: what a vertex may lie beyond the centre plane or the waterline


@dataclass(frozen=True, eq=False)
class Panels:
    """Flat panels of the half hull to port, below the waterline.

    vertices_m (v, 3) x from the girder's aft end, y >= 0 from the centre plane and z <= 0 from the waterline, in m;
    faces (m, 4) indices of the corners, anticlockwise seen from the water, so that normals point into it; a triangle
    repeats its last corner ((m, 3) is taken too). The hull is closed by its mirror image in the centre plane; the
    waterline stays open. Panels without area are left out. Raises ArgumentError.
    """

    vertices_m: Array
    faces: NDArray[np.intp]

    def __init__(self, vertices_m: ArrayLike, faces: ArrayLike) -> None:
        vertices, corners = np.array(vertices_m, dtype=np.float64), np.array(faces)
        if vertices.ndim != 2 or vertices.shape[1] != 3 or not np.isfinite(vertices).all():
            raise ArgumentError(f"vertices_m has shape {vertices.shape}; give (v, 3) finite numbers, x, y, z in m.")
        if corners.ndim != 2 or corners.shape[1] not in (3, 4) or not np.issubdtype(corners.dtype, np.integer):
            raise ArgumentError(f"faces has shape {corners.shape}; give (m, 4) or (m, 3) indices of vertices.")
        if corners.size == 0 or corners.min() < 0 or corners.max() >= len(vertices):
            raise ArgumentError(f"faces must name vertices 0 to {len(vertices) - 1}.")
        if corners.shape[1] == 3:
            corners = corners[:, [0, 1, 2, 2]]
        extent = float(np.ptp(vertices, axis=0).max())
        if vertices[:, 1].min() < -_TOLERANCE * extent:
            raise ArgumentError(
                f"a vertex has y = {vertices[:, 1].min():g} m; give the half of the hull with y >= 0, it is mirrored."
            )
        if vertices[:, 2].max() > _TOLERANCE * extent:
            raise ArgumentError(f"a vertex has z = {vertices[:, 2].max():g} m; cut the hull at the waterline, z = 0.")
        areas = np.linalg.norm(_doubled_areas(vertices[corners]), axis=1)
        corners = corners[areas > _SLIVER * areas.max()].astype(np.intp)
        if len(corners) > MOST_PANELS:
            raise ArgumentError(f"{len(corners)} panels of half a hull; {MOST_PANELS} are the most, and 500 enough.")
        for name, values in (("vertices_m", vertices), ("faces", corners)):
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        if not self.volume_m3 > 0.0:
            raise ArgumentError(
                "the panels enclose no volume: their corners must run anticlockwise as seen from the water; turn the "
                "order of the corners round."
            )

    @classmethod
    def from_sections(cls, sections: Sections, lengthwise: int | None = None, girthwise: int = 10) -> Panels:
        """Panels between sections: `girthwise` from keel to waterline, shorter where the section turns, and flat ends.

        lengthwise: so many along the hull, closer together at her ends, on lines between the sections; by default as
        many as there are sections to begin and end them. Raises ArgumentError.
        """
        if girthwise < 1 or (lengthwise is not None and lengthwise < 1):
            raise ArgumentError(f"{lengthwise} by {girthwise} panels; give 1 or more in both directions.")
        curves, x = sections.cut(girthwise), sections.x_m
        if lengthwise is not None:
            places = graded_places(float(x[0]), float(x[-1]), lengthwise + 1)
            flat = curves.reshape(len(x), -1)
            curves = np.stack([np.interp(places, x, column) for column in flat.T], axis=1).reshape(len(places), -1, 2)
            x = places
        grid = np.concatenate([np.broadcast_to(x[:, None, None], (*curves.shape[:2], 1)), curves], axis=2)
        across = max(2, girthwise // 4)
        grids = [grid, _cap(grid[0], across), _cap(grid[-1], across)[::-1]]
        faces, first = [], 0
        for one in grids:
            faces.append(first + _quads(*one.shape[:2]))
            first += one.shape[0] * one.shape[1]
        return cls(np.concatenate([one.reshape(-1, 3) for one in grids]), np.concatenate(faces))

    def __len__(self) -> int:
        return len(self.faces)

    @cached_property
    def geometry(self) -> Geometry:
        """Centres, normals and areas of the panels."""
        corners = self.vertices_m[self.faces]
        doubled = _doubled_areas(corners)
        sizes = np.linalg.norm(doubled, axis=1)
        parts = [(corners[:, [0, 1, 2]]), (corners[:, [0, 2, 3]])]
        weights = [
            0.5 * np.linalg.norm(np.cross(part[:, 1] - part[:, 0], part[:, 2] - part[:, 0]), axis=1) for part in parts
        ]
        areas = weights[0] + weights[1]
        centres = sum(w[:, None] * part.mean(axis=1) for w, part in zip(weights, parts, strict=True)) / areas[:, None]
        diagonals = corners[:, 2:] - corners[:, :2]
        diameters = np.linalg.norm(diagonals, axis=2).max(axis=1)
        return Geometry(corners, np.asarray(centres), doubled / sizes[:, None], areas, diameters)

    @property
    def volume_m3(self) -> float:
        """Immersed volume of the whole hull: the integral of z n_z over it."""
        g = self.geometry
        return 2.0 * float(np.sum(g.centres[:, 2] * g.normals[:, 2] * g.areas))

    @property
    def open_share(self) -> float:
        """Area that does not close fore against aft, over the largest cross-section's: 0 for a closed hull."""
        g = self.geometry
        facing = g.normals[:, 0] * g.areas
        return float(abs(facing.sum()) / max(np.abs(facing).sum() / 2.0, 1e-300))

    @property
    def extent_m(self) -> tuple[float, float]:
        """First and last x of the wetted hull."""
        x = self.vertices_m[np.unique(self.faces), 0]
        return float(x.min()), float(x.max())


class Geometry(NamedTuple):
    """Of m panels: corners (m, 4, 3), centres (m, 3), unit normals into the water (m, 3), areas and diameters (m,)."""

    corners: Array
    centres: Array
    normals: Array
    areas: Array
    diameters: Array


def graded_places(first: float, last: float, count: int) -> Array:
    """`count` places from first to last, both included: closer together at the ends, where the flow turns fast."""
    t = np.linspace(0.0, 1.0, count)
    evenly = 1.0 - _GRADING
    places = first + (last - first) * (evenly * t + 0.5 * _GRADING * (1.0 - np.cos(np.pi * t)))
    places[-1] = last  # and not a round-off beyond
    return np.asarray(places)


def _doubled_areas(corners: Array) -> Array:
    return np.asarray(np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]), dtype=np.float64)


def _cap(curve: Array, across: int) -> Array:
    """The flat end inside a section's curve (k, 3), from the centre line outwards, (across + 1, k, 3)."""
    share = np.linspace(0.0, 1.0, across + 1)[:, None]
    cap = np.broadcast_to(curve, (across + 1, *curve.shape)).copy()
    cap[..., 1] = share * curve[:, 1]
    return cap


def _quads(rows: int, columns: int) -> NDArray[np.intp]:
    """Faces of a grid whose rows run from aft forward and whose columns from the keel up, seen from the water."""
    index = np.arange(rows * columns).reshape(rows, columns)
    corners = [index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]]
    return np.stack(corners, axis=-1).reshape(-1, 4)
