"""Thin-walled sections for tests, out of lists of straight plates."""

from __future__ import annotations

import numpy as np

from hullform.loading.thin_walled import Network

Point = tuple[float, float]
Plate = tuple[Point, Point, float]


def network(plates: list[Plate], *, mirrored: bool = False) -> Network:
    """Plates ((y, z), (y, z), thickness) that meet at their ends."""
    places = sorted({point for start, end, _ in plates for point in (start, end)})
    points = np.array([[start, end] for start, end, _ in plates])
    thickness = np.array([[t] for _, _, t in plates])
    joints = np.array([[places.index(start), places.index(end)] for start, end, _ in plates])
    return Network(points[..., 0], points[..., 1], thickness, thickness, joints, mirrored)
