"""How well traced curves lie on the ink."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from hullform.picture.edits.placing import stored_of_drawing
from hullform.picture.image.reduction import Reduction
from hullform.picture.pieces.half_ink import HalfInk

Array = NDArray[np.float64]

ON_THE_LINE_PX = 4.0  # of the picture that is read: a ridge farther away is another line's, or there is none


class Evidence:
    """The ridges of one half, in pixels of the stored picture."""

    def __init__(self, prepared: HalfInk, reduction: Reduction) -> None:
        frame, peaks = prepared.frame, prepared.peaks
        y, z = frame.to_drawing(np.asarray(peaks.column, dtype=np.float64), peaks.row)
        ridges = stored_of_drawing(np.column_stack([y, z]), frame, reduction)
        self._reach_px = ON_THE_LINE_PX * reduction.across
        self._tree = cKDTree(ridges) if len(ridges) else None

    def residual_px(self, curve: Array) -> float | None:
        """RMS distance across a curve, (n, 2) px, from it to the ridges beside it; None where there are none."""
        if self._tree is None or len(curve) < 2:
            return None
        found = self._tree.query(curve, distance_upper_bound=self._reach_px)
        distances, nearest = (np.asarray(values) for values in found)
        near = np.isfinite(distances)
        if not near.any():
            return None
        tangent = np.gradient(curve, axis=0)
        tangent /= np.maximum(np.hypot(*tangent.T), 1e-9)[:, None]
        apart = self._tree.data[nearest[near]] - curve[near]
        across = apart[:, 0] * tangent[near, 1] - apart[:, 1] * tangent[near, 0]
        return float(np.sqrt(np.mean(across**2)))
