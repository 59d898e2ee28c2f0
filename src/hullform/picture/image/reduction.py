"""Large pictures are read at a smaller size; what is said of pixels still means those of the picture as stored."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Calibration
from hullform.picture.image.homography import describe
from hullform.picture.image.image_files import Picture
from hullform.ship_body_plan import CalibrationGiven, CalibrationPoint

Array = NDArray[np.float64]
Coordinate = TypeVar("Coordinate", float, Array)

LARGEST_WIDTH_PX = 4500  # lines are told apart at 1600 px; more costs time and memory and brings nothing
REDUCED_WIDTH_PX = 3600
LARGEST_PX = 20_000_000  # of a picture taller than wide


@dataclass(frozen=True)
class Reduction:
    """How many stored pixels one pixel that is read stands for, across and down.

    Pixel centres lie at integers, so u_stored = (u_read + 1/2) * across - 1/2, and likewise down.
    """

    across: float = 1.0
    down: float = 1.0

    def read(self, px: tuple[Coordinate, Coordinate]) -> tuple[Coordinate, Coordinate]:
        """The place in the picture that is read of a pixel (or of arrays of pixels) of the stored one."""
        return (px[0] + 0.5) / self.across - 0.5, (px[1] + 0.5) / self.down - 0.5

    def given(self, given: CalibrationGiven | None) -> CalibrationGiven | None:
        """What ship.toml gives of the calibration, for the picture that is read."""
        if given is None:
            return None
        u, v, scale = given.centreline_px, given.baseline_px, given.metres_per_px
        return given.model_copy(
            update={
                "centreline_px": None if u is None else self.read((u, 0.0))[0],
                "baseline_px": None if v is None else self.read((0.0, v))[1],
                "metres_per_px": None if scale is None else scale * self.across,
                "points": tuple(CalibrationPoint(px=self.read(point.px), m=point.m) for point in given.points),
            }
        )

    def stored(self, calibration: Calibration) -> Calibration:
        """The calibration of the stored picture."""
        if self == Reduction():
            return calibration
        matrix = np.array(
            [[self.across, 0.0, (self.across - 1) / 2], [0.0, self.down, (self.down - 1) / 2], [0.0, 0.0, 1.0]]
        )
        return describe(
            matrix @ np.array(calibration.pixel_from_metres),
            calibration.residual_px * self.across,
            f"{calibration.source}; read at {1 / self.across:.3g} of the stored size",
        )


def reduced(grey: Picture) -> tuple[Picture, Reduction]:
    """The picture at a width that is worth reading, by area, and what was done to it."""
    height, width = grey.shape
    shrink = REDUCED_WIDTH_PX / width if width > LARGEST_WIDTH_PX else 1.0
    shrink = min(shrink, float(np.sqrt(LARGEST_PX / grey.size)))
    if shrink == 1.0:
        return grey, Reduction()
    rows, columns = round(height * shrink), round(width * shrink)
    small = cv2.resize(grey, (columns, rows), interpolation=cv2.INTER_AREA)
    return np.asarray(small, dtype=np.uint8), Reduction(width / columns, height / rows)
