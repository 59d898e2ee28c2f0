"""A closed triangle surface through sections."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hullform.hull.arcs import curve_points
from hullform.hull.sections import Sections

Array = NDArray[np.float64]
Faces = NDArray[np.int64]

_SNAP = 1e-7  # of the largest half-breadth: nearer to the centre plane a point lies on it
_THINNEST = 1e-5  # of the greatest depth: a section with breadth but no depth keeps this much, so that it has an inside


def _strips(lower: Faces, upper: Faces) -> Faces:
    """Two triangles for every cell between two rows of vertices, lower[j], lower[j+1], upper[j+1], upper[j]."""
    a, b, c, d = lower[..., :-1], lower[..., 1:], upper[..., 1:], upper[..., :-1]
    return np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])


def _fan(centre: np.int64, rim: Faces) -> Faces:
    """Triangles from the deck's centre to every step along an end section, which is star-shaped about that point."""
    return np.stack([np.full(len(rim) - 1, centre), rim[:-1], rim[1:]], axis=-1)


def closed_surface(x: Array, sections: Sections, points: int) -> tuple[Array, Faces]:
    """Return vertices (n, 3) and faces (m, 3), normals outward, of the closed body through sections at x (stations,).

    Each section has `points` vertices a side from keel to deck; the deck and both ends are closed. Where sections
    shrink to the centre plane port and starboard share their vertices and the faces between them vanish.
    """
    snap = _SNAP * float(sections.half_breadth.max())
    thinnest = _THINNEST * float(sections.depth.max())
    a = np.where(sections.half_breadth > snap, sections.half_breadth, 0.0)
    b = np.where(a > 0, np.maximum(sections.depth, thinnest), sections.depth)
    y, zeta = curve_points(a, b, sections.p, sections.q, points)
    y[y <= snap] = 0.0
    z = sections.top[:, None] - zeta
    along = np.broadcast_to(x[:, None], y.shape)
    port = np.stack([along, y, z], axis=-1)
    starboard = port * [1.0, -1.0, 1.0]

    centre = np.stack([x, np.zeros_like(x), sections.top], axis=-1)
    vertices = np.concatenate([port.reshape(-1, 3), starboard.reshape(-1, 3), centre])

    left = np.arange(y.size).reshape(y.shape).T  # rows along the ship, from keel to deck
    right, middle = left + y.size, 2 * y.size + np.arange(len(x))
    faces = np.concatenate(
        [
            _strips(left[:-1], left[1:])[:, ::-1],
            _strips(right[:-1], right[1:]),
            _strips(left[-1], middle)[:, ::-1],
            _strips(right[-1], middle),
            _fan(middle[0], left[:, 0])[:, ::-1],
            _fan(middle[0], right[:, 0]),
            _fan(middle[-1], left[:, -1]),
            _fan(middle[-1], right[:, -1])[:, ::-1],
        ]
    )
    # -0.0 and 0.0 must be one vertex.
    unique, index = np.unique(vertices + 0.0, axis=0, return_inverse=True)
    faces = index.reshape(-1)[faces]
    has_area = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    # Faces within the centre plane come in pairs, port and starboard, back to back: neither bounds anything.
    off_centre = (unique[faces, 1] != 0).any(axis=1)
    faces = faces[has_area & off_centre]
    used, faces = np.unique(faces, return_inverse=True)
    return unique[used], faces.reshape(-1, 3)
