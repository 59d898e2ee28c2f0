"""A closed triangle surface through sections."""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from hullform.hull.ears import clipped_ears

Array = NDArray[np.float64]
Faces = NDArray[np.int64]


def _strips(lower: Faces, upper: Faces) -> Faces:
    """Two triangles for every cell between two rows of vertices, lower[j], lower[j+1], upper[j+1], upper[j]."""
    a, b, c, d = lower[..., :-1], lower[..., 1:], upper[..., 1:], upper[..., :-1]
    return np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])


def _end(centre: np.int64, rim: Faces, section: Array) -> Faces:
    """Triangles over one side of an end section, from its rim (k,), keel to deck, with points (k, 2), and deck centre.

    A fan from the deck's centre where the section is star-shaped about it; clipped ears where it is not, contour by
    contour where it comes back to the centre line.
    """
    spoke = section - [0.0, section[-1, 1]]
    if (spoke[:-1, 0] * spoke[1:, 1] - spoke[:-1, 1] * spoke[1:, 0] >= 0).all():
        return np.stack([np.full(len(rim) - 1, centre), rim[:-1], rim[1:]], axis=-1)
    points = np.concatenate([section, [[0.0, section[-1, 1]]]])
    numbers = np.append(rim, centre)
    on_centre = np.flatnonzero(points[:, 0] == 0)
    faces = [
        numbers[start : end + 1][clipped_ears(points[start : end + 1])]
        for start, end in itertools.pairwise(on_centre)
        if end > start + 1
    ]
    return np.concatenate(faces) if faces else np.empty((0, 3), dtype=np.int64)


def closed_surface(x: Array, points: Array) -> tuple[Array, Faces]:
    """Return vertices (n, 3) and faces (m, 3), normals outward, of the closed body through sections at x (stations,).

    points: (stations, k, 2) [half-breadth, height] of one side of each section, from keel to deck; the deck and both
    ends are closed. Where sections shrink to the centre plane port and starboard share their vertices and the faces
    between them vanish.
    """
    y, z = points[..., 0], points[..., 1]
    along = np.broadcast_to(x[:, None], y.shape)
    port = np.stack([along, y, z], axis=-1)
    starboard = port * [1.0, -1.0, 1.0]

    centre = np.stack([x, np.zeros_like(x), z[:, -1]], axis=-1)
    vertices = np.concatenate([port.reshape(-1, 3), starboard.reshape(-1, 3), centre])

    left = np.arange(y.size).reshape(y.shape).T  # rows along the ship, from keel to deck
    right, middle = left + y.size, 2 * y.size + np.arange(len(x))
    faces = np.concatenate(
        [
            _strips(left[:-1], left[1:])[:, ::-1],
            _strips(right[:-1], right[1:]),
            _strips(left[-1], middle)[:, ::-1],
            _strips(right[-1], middle),
            _end(middle[0], left[:, 0], points[0])[:, ::-1],
            _end(middle[0], right[:, 0], points[0]),
            _end(middle[-1], left[:, -1], points[-1]),
            _end(middle[-1], right[:, -1], points[-1])[:, ::-1],
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
