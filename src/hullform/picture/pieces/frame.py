"""The diagonal frame: one half of the body plan seen along 45 degrees.

A section whose half-breadth does not shrink with height is single-valued over the diagonal a = (y + z) / sqrt 2, with
b = (y - z) / sqrt 2 of slope |db/da| <= 1: keel, bilge and topside alike. Rows of the picture fail at the flat of
bottom, columns at the flat of side.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Calibration
from hullform.picture.image.ink import Ink

Array = NDArray[np.float64]
ROOT_TWO = float(np.sqrt(2.0))
MARGIN = 0.02  # of B/2: how far the frame reaches beyond keel and centre line
OVERHANG = 1.05  # of B/2: how far it reaches outboard


@dataclass(frozen=True, eq=False)
class DiagonalFrame:
    """Columns run along the diagonal from the keel outwards, rows across it; one column is one picture pixel.

    Attributes:
        pixel_from_metres: 3 x 3 homography of the picture.
        side: -1 for the left half of the picture, +1 for the right one.
        metres_per_px: of the picture.
        half_breadth_px: B/2 in px.
        top_px: highest z of the frame, px above the base line.
        bottom_px: lowest z, 0 or below.
    """

    pixel_from_metres: Array
    side: int
    metres_per_px: float
    half_breadth_px: float
    top_px: float
    bottom_px: float = 0.0

    @classmethod
    def of(cls, calibration: Calibration, side: int, breadth_m: float, top_m: float) -> DiagonalFrame:
        """The frame of one half."""
        scale = calibration.metres_per_px
        return cls(np.array(calibration.pixel_from_metres), side, scale, breadth_m / 2 / scale, top_m / scale)

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, columns)."""
        extent = OVERHANG * self.half_breadth_px + self.top_px - self.bottom_px
        size = int(extent / ROOT_TWO + 2 * MARGIN * self.half_breadth_px)
        return size, size

    @property
    def _before_keel_px(self) -> float:
        """Columns before that of the keel point."""
        return MARGIN * self.half_breadth_px - self.bottom_px / ROOT_TWO

    def to_drawing(self, column: Array, row: Array) -> tuple[Array, Array]:
        """(y, z) in px of the drawing."""
        along = np.asarray(column, dtype=np.float64) - self._before_keel_px
        across = np.asarray(row, dtype=np.float64) - self.top_px / ROOT_TWO
        return (along + across) / ROOT_TWO, (along - across) / ROOT_TWO

    def from_drawing(self, y: Array | float, z: Array | float) -> tuple[Array, Array]:
        """(column, row) of points of the drawing in px."""
        y, z = np.asarray(y, dtype=np.float64), np.asarray(z, dtype=np.float64)
        return (y + z) / ROOT_TWO + self._before_keel_px, (y - z) / ROOT_TWO + self.top_px / ROOT_TWO

    def to_picture(self, y: Array, z: Array) -> tuple[Array, Array]:
        """Picture pixels (u, v) of points of the drawing in px."""
        h, scale = self.pixel_from_metres, self.metres_per_px
        across, up = self.side * np.asarray(y) * scale, np.asarray(z) * scale
        depth = h[2, 0] * across + h[2, 1] * up + h[2, 2]
        return (
            (h[0, 0] * across + h[0, 1] * up + h[0, 2]) / depth,
            (h[1, 0] * across + h[1, 1] * up + h[1, 2]) / depth,
        )

    def from_picture(self, u: Array | float, v: Array | float) -> tuple[Array, Array]:
        """(y, z) in px of the drawing of picture pixels; the inverse of `to_picture`."""
        u, v = np.broadcast_arrays(np.asarray(u, dtype=np.float64), np.asarray(v, dtype=np.float64))
        y, z, depth = np.linalg.solve(self.pixel_from_metres, np.stack([u.ravel(), v.ravel(), np.ones(u.size)]))
        scale = depth * self.metres_per_px
        return (self.side * y / scale).reshape(u.shape), (z / scale).reshape(u.shape)

    def sample(self, ink: Ink) -> Ink:
        """(rows, columns) the ink of a picture, resampled once into the frame; paper outside."""
        return np.asarray(self._warped(ink, cv2.INTER_LINEAR), dtype=np.float32)

    def sample_mask(self, mask: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """(rows, columns) a mask of a picture in the frame, by the nearest pixel; 0 outside."""
        return np.asarray(self._warped(mask, cv2.INTER_NEAREST), dtype=np.uint8)

    def _warped(self, image: Ink | NDArray[np.uint8], how: int) -> NDArray[np.generic]:
        rows, columns = self.shape
        margin, drop = self._before_keel_px, self.top_px / ROOT_TWO
        to_drawing = np.array([[1.0, 1.0, -margin - drop], [1.0, -1.0, drop - margin], [0.0, 0.0, ROOT_TWO]]) / ROOT_TWO
        to_metres = np.diag([self.side * self.metres_per_px, self.metres_per_px, 1.0])
        matrix = self.pixel_from_metres @ to_metres @ to_drawing
        return np.asarray(cv2.warpPerspective(image, matrix, (columns, rows), flags=how | cv2.WARP_INVERSE_MAP))
