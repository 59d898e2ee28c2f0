"""Maps from metres to pixels, without and with perspective, and the figures that describe them."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Calibration

Array = NDArray[np.float64]


def similarity_matrix(origin: tuple[float, float], metres_per_px: float, skew: float) -> Array:
    """(y, z, 1) to pixels without perspective."""
    unit = np.array([1.0, skew]) / np.hypot(1.0, skew) / metres_per_px
    return np.array([[unit[0], unit[1], origin[0]], [unit[1], -unit[0], origin[1]], [0.0, 0.0, 1.0]])


def describe(matrix: Array, residual_px: float, source: str) -> Calibration:
    """The calibration of a homography, its figures taken at the origin."""
    matrix = matrix / matrix[2, 2]
    origin = matrix[:2, 2]
    across = matrix[:2, 0] - origin * matrix[2, 0]
    up = matrix[:2, 1] - origin * matrix[2, 1]
    scale = float(2 / (np.hypot(*across) + np.hypot(*up)))
    rotation = float(np.rad2deg(np.arctan2(-across[1], across[0])))
    first, second, third = (tuple(float(x) for x in row) for row in matrix)
    return Calibration(
        pixel_from_metres=(first, second, third),  # type: ignore[arg-type]
        centreline_px=float(origin[0]),
        baseline_px=float(origin[1]),
        metres_per_px=scale,
        rotation_deg=rotation,
        residual_px=residual_px,
        source=source,
    )


def similarity(
    origin: tuple[float, float], metres_per_px: float, skew: float, residual_px: float, source: str
) -> Calibration:
    return describe(similarity_matrix(origin, metres_per_px, skew), residual_px, source)


def fit_points(metres: Array, pixels: Array, perspective: bool = True) -> tuple[Array, float]:
    """The least-squares map of points: similarity of two, affine of three, homography of four and more.

    Without perspective it is affine for four and more points too.
    """
    if len(metres) == 2:
        dy, dz = metres[1] - metres[0]
        du, dv = pixels[1] - pixels[0]
        turn = complex(du, -dv) / complex(dy, dz)
        matrix = np.array([[turn.real, -turn.imag, 0.0], [-turn.imag, -turn.real, 0.0], [0.0, 0.0, 1.0]])
        matrix[:2, 2] = pixels[0] - matrix[:2, :2] @ metres[0]
    elif len(metres) == 3 or not perspective:
        design = np.column_stack([metres, np.ones(len(metres))])
        fit, _, rank, _ = np.linalg.lstsq(design, pixels, rcond=None)
        if rank < 3:
            raise np.linalg.LinAlgError("points on one line")
        matrix = np.vstack([fit.T, [0.0, 0.0, 1.0]])
    else:
        found, _ = cv2.findHomography(metres, pixels, 0)
        if found is None:
            raise np.linalg.LinAlgError("no homography")
        matrix = np.asarray(found, dtype=np.float64)
    mapped = np.column_stack([metres, np.ones(len(metres))]) @ matrix.T
    residual = float(np.abs(mapped[:, :2] / mapped[:, 2:] - pixels).max())
    return matrix, residual


def fit_without_outliers(metres: Array, pixels: Array, perspective: bool) -> tuple[Array, float, NDArray[np.bool_]]:
    """The map of the crossings, its residual in px, and which crossings it rests on.

    Crossings with lines that a ship's side pulls off their axes are left out, the worst first.
    """
    good = np.ones(len(metres), dtype=np.bool_)
    matrix, residual = fit_points(metres, pixels, perspective)
    for _ in range(6):
        mapped = np.column_stack([metres, np.ones(len(metres))]) @ matrix.T
        misfit = np.hypot(*(mapped[:, :2] / mapped[:, 2:] - pixels).T)
        good = misfit < max(0.12, 2 * float(np.median(misfit)))
        matrix, residual = fit_points(metres[good], pixels[good], perspective)
    return matrix, residual, good
