"""The picture along one curve, straightened, so that a person sees at a glance where the two part."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Station
from hullform.picture.reading import PictureReading

Array = NDArray[np.float64]

REACH_PX = 12.0  # to either side of the curve
ACROSS_PX = 49
LONGEST_PX = 2400


def straightened(reading: PictureReading, station: Station, curve: int) -> NDArray[np.uint8]:
    """(49, n) grey: the curve runs along the middle row from keel to deck, outboard is up.

    Args:
        reading: that the station is of.
        station: whose curve.
        curve: its number.
    """
    side = reading.side_of(station.half)
    stored = reading.calibration.pixels(station.curves[curve].points * np.array([side, 1]))
    px = np.column_stack(reading.reduction.read((stored[:, 0], stored[:, 1])))
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(px, axis=0).T))])
    at = np.linspace(0.0, arc[-1], int(np.clip(arc[-1], 2, LONGEST_PX)))
    u, v = (np.interp(at, arc, px[:, k]) for k in (0, 1))
    tangent = np.column_stack([np.gradient(u), np.gradient(v)])
    tangent /= np.maximum(np.hypot(*tangent.T), 1e-9)[:, None]
    # outboard: to the right of a curve that rises on the right half, to its left on the left half
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]]) * side
    offsets = np.linspace(REACH_PX, -REACH_PX, ACROSS_PX)[:, None]
    strip = cv2.remap(
        reading.grey,
        (u + offsets * normal[:, 0]).astype(np.float32),
        (v + offsets * normal[:, 1]).astype(np.float32),
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_CONSTANT,
        borderValue=255.0,
    )
    return np.asarray(strip, dtype=np.uint8)
