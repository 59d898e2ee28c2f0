"""Whether a triangle surface goes through itself: triangles that cross, found over a grid of cells."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Faces = NDArray[np.int64]

# Of the surface's greatest extent: an edge that goes through a triangle by less touches it.
_TOUCH = 1e-8
# Of the triangles' mean extent each way: the side of a cell.
_CELL = 3.0
_PAIRS_AT_ONCE = 500_000


def crossing_triangles(vertices: Array, faces: Faces) -> Faces:
    """Pairs (k, 2) of triangles, numbers of faces (m, 3), that cross and have no vertex in common.

    Two triangles cross where an edge of either goes through the other; those that touch, or lie in one plane, do not.
    Candidates are triangles whose bounding boxes enter one cell of a grid and overlap (Ericson, Real-Time Collision
    Detection, 2005, 7.1); edges are tested by signed volumes (5.3.4).
    """
    corner = vertices[faces]
    low, high = corner.min(axis=1), corner.max(axis=1)
    tolerance = _TOUCH * float((high.max(axis=0) - low.min(axis=0)).max())
    one, other = _sharing_a_cell(low, high)
    # x last: most triangles of a hull's frame bay overlap in it
    for lowest, highest in zip(low.T[::-1], high.T[::-1], strict=True):
        overlap = (lowest[one] <= highest[other]) & (lowest[other] <= highest[one])
        one, other = one[overlap], other[overlap]
    apart = (faces[one][:, :, None] != faces[other][:, None, :]).all(axis=(1, 2))
    pairs = np.unique(np.stack([one[apart], other[apart]], axis=-1), axis=0)
    crossing = [
        _goes_through(corner[part[:, 0]], corner[part[:, 1]], tolerance)
        | _goes_through(corner[part[:, 1]], corner[part[:, 0]], tolerance)
        for part in np.array_split(pairs, 1 + len(pairs) // _PAIRS_AT_ONCE)
    ]
    return pairs[np.concatenate(crossing)]


def doubts_of_crossing(vertices: Array, faces: Faces) -> tuple[str, ...]:
    """One doubt that says where a hull's surface goes through itself, or none."""
    pairs = crossing_triangles(vertices, faces)
    if not len(pairs):
        return ()
    x = vertices[faces[pairs]][..., 0]
    return (
        f"the hull's surface goes through itself between x = {x.min():.2f} and {x.max():.2f} m ({len(pairs)} pairs of "
        "triangles); the sections drawn about there do not answer to each other: check their curves, or add a station",
    )


def _sharing_a_cell(low: Array, high: Array) -> tuple[Faces, Faces]:
    """Pairs of boxes, the lesser number first, that enter a cell together; a pair may come more than once."""
    cell = _CELL * np.maximum((high - low).mean(axis=0), 1e-6 * (high.max(axis=0) - low.min(axis=0)).max())
    first = np.floor((low - low.min(axis=0)) / cell).astype(np.int64)
    cells = np.floor((high - low.min(axis=0)) / cell).astype(np.int64) - first + 1
    entries = cells.prod(axis=1)
    box = np.repeat(np.arange(len(low)), entries)
    within = np.arange(len(box)) - np.repeat(np.cumsum(entries) - entries, entries)
    steps = np.stack(
        [within // (cells[box, 1] * cells[box, 2]), within // cells[box, 2] % cells[box, 1], within % cells[box, 2]], -1
    )
    place = first[box] + steps
    extent = place.max(axis=0) + 1
    key = (place[:, 0] * extent[1] + place[:, 1]) * extent[2] + place[:, 2]
    order = np.argsort(key, kind="stable")
    key, box = key[order], box[order]
    # every entry with each of those that follow it in its cell
    ends = np.searchsorted(key, key, side="right")
    following = ends - np.arange(len(key)) - 1
    at = np.repeat(np.arange(len(key)), following)
    ahead = np.arange(len(at)) - np.repeat(np.cumsum(following) - following, following) + 1
    return box[at], box[at + ahead]


def _goes_through(edges_of: Array, through: Array, tolerance: float) -> NDArray[np.bool_]:
    """Whether any edge of triangles (n, 3, 3) goes through the inside of triangles (n, 3, 3)."""
    a, b, c = through.transpose(1, 0, 2)
    normal = np.cross(b - a, c - a)
    size = np.linalg.norm(normal, axis=-1)
    unit = normal / np.where(size > 0, size, 1.0)[:, None]
    height = ((edges_of - a[:, None]) * unit[:, None]).sum(-1)
    found = np.zeros(len(a), dtype=bool)
    for start, end in ((0, 1), (1, 2), (2, 0)):
        above, below = height[:, start], height[:, end]
        apart = ((above > tolerance) & (below < -tolerance)) | ((above < -tolerance) & (below > tolerance))
        apart &= size > 0
        if not apart.any():
            continue
        where = np.flatnonzero(apart)
        p, q = edges_of[where, start], edges_of[where, end]
        share = (above[where] / (above[where] - below[where]))[:, None]
        foot = p + share * (q - p)
        inside = np.ones(len(where), dtype=bool)
        for corner, following in ((a, b), (b, c), (c, a)):
            side = following[where] - corner[where]
            distance = (np.cross(side, foot - corner[where]) * unit[where]).sum(-1)
            inside &= distance > tolerance * np.linalg.norm(side, axis=-1)
        found[where] |= inside
    return found
