"""How well traced curves lie on the ink, and which lines none of them took."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from hullform.picture.half import HalfInk

Array = NDArray[np.float64]

ON_THE_LINE_PX = 4.0  # of the picture that is read: a ridge farther away is another line's, or there is none


class Evidence:
    """The ridges of one half, in pixels of the picture that is read."""

    def __init__(self, prepared: HalfInk) -> None:
        frame = prepared.frame
        self._pieces: list[Array] = []
        for piece in prepared.tracklets:
            y, z = frame.to_drawing(np.asarray(piece.column, dtype=np.float64), piece.row)
            self._pieces.append(np.column_stack(frame.to_picture(y, z)))
        self._tree = cKDTree(np.vstack(self._pieces)) if self._pieces else None

    def residual_px(self, curve: Array) -> float | None:
        """RMS distance across a curve, (n, 2) px, from it to the ridges beside it; None where there are none."""
        if self._tree is None or len(curve) < 2:
            return None
        distances, nearest = self._tree.query(curve, distance_upper_bound=ON_THE_LINE_PX)
        near = np.isfinite(distances)
        if not near.any():
            return None
        tangent = np.gradient(curve, axis=0)
        tangent /= np.maximum(np.hypot(*tangent.T), 1e-9)[:, None]
        apart = self._tree.data[nearest[near]] - curve[near]
        across = apart[:, 0] * tangent[near, 1] - apart[:, 1] * tangent[near, 0]
        return float(np.sqrt(np.mean(across**2)))

    def pieces(self, curves: Sequence[Array]) -> list[tuple[Array, bool]]:
        """Every piece of line, (n, 2) px, and whether one of the curves runs along most of it."""
        if not curves:
            return [(piece, False) for piece in self._pieces]
        taken = cKDTree(np.vstack(list(curves)))
        return [(piece, bool(np.isfinite(_distances(taken, piece)).mean() > 0.5)) for piece in self._pieces]


def _distances(tree: cKDTree, points: Array) -> Array:
    """Of each point from the tree's nearest; infinite where that is farther than a line's own ridge lies."""
    distances, _ = tree.query(points, distance_upper_bound=ON_THE_LINE_PX)
    return np.asarray(distances, dtype=np.float64)
