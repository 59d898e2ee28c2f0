"""Triangles over a plane polygon: ears clipped off one after another (Meisters 1975)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Faces = NDArray[np.int64]


def clipped_ears(polygon: Array) -> Faces:
    """Triangles (k - 2, 3), indices of the polygon's points (k, 2), counter-clockwise, no two crossing.

    The polygon runs counter-clockwise and does not cross itself; points that repeat or lie in line are allowed, and
    give triangles without area.
    """
    left = list(range(len(polygon)))
    found = []
    while len(left) > 3:
        ear = _best_ear(polygon[left])
        found.append((left[ear - 1], left[ear], left[(ear + 1) % len(left)]))
        del left[ear]
    found.append((left[0], left[1], left[2]))
    return np.array(found, dtype=np.int64)


def _best_ear(points: Array) -> int:
    """Of a polygon's corners that hold no other point in their triangle, the fattest."""
    before, after = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
    a, b = points - before, after - points
    turn = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    longest = np.maximum(np.linalg.norm(before - after, axis=1), np.maximum(*np.linalg.norm([a, b], axis=-1)))
    fatness = np.divide(turn, longest**2, out=np.zeros_like(turn), where=longest > 0)
    for corner in np.argsort(-fatness):
        triangle = np.stack([before[corner], points[corner], after[corner]])
        if not _holds_any(triangle, points):
            return int(corner)
    return int(np.argmax(fatness))


def _holds_any(triangle: Array, points: Array) -> bool:
    """Whether any point other than its corners lies within a triangle or on its sides."""
    inside = np.ones(len(points), dtype=bool)
    for start, end in zip(triangle, np.roll(triangle, -1, axis=0), strict=True):
        side, offset = end - start, points - start
        inside &= side[0] * offset[:, 1] - side[1] * offset[:, 0] >= 0
    corner = (points[:, None] == triangle).all(-1).any(-1)
    return bool((inside & ~corner).any())
