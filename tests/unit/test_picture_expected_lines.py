"""Level lines that are hull are told from waterlines, and lines of the grid are found beside them."""

from __future__ import annotations

import cv2
import numpy as np

from hullform.picture.calibrating.expected_lines import expected_lines, is_flat_of_bottom
from hullform.picture.calibrating.straight_line import refine_line
from hullform.picture.image.homography import similarity
from hullform.picture.image.ink import ink_of

CENTRE, BASE, HALF = 500, 400, 400  # px


def drawing() -> np.ndarray:
    """A barge's section with its flat of bottom at v = 300, and a waterline at v = 294 from box line to box line."""
    image = np.full((460, 1000), 250, np.uint8)
    angle = np.linspace(0.0, np.pi / 2, 40)
    for side in (-1, 1):
        bilge = np.column_stack([HALF - 40 + 40 * np.sin(angle), 260 + 40 * np.cos(angle)])
        half = np.vstack([[0, 300], bilge, [HALF, 100]]) * (side, 1) + (CENTRE, 0)
        cv2.polylines(image, [np.round(half * 16).astype(np.int32)], False, 10, 2, cv2.LINE_AA, 4)
    cv2.line(image, (CENTRE - 430, 294), (CENTRE + 430, 294), 150, 1)
    return image


def test_a_flat_of_bottom_turns_up_and_a_waterline_does_not() -> None:
    ink = ink_of(drawing())
    flat, waterline = (refine_line(ink, v, 0.0, False, 2.0) for v in (300.0, 294.0))
    assert flat is not None
    assert waterline is not None
    assert is_flat_of_bottom(flat, ink, CENTRE, HALF)
    assert not is_flat_of_bottom(waterline, ink, CENTRE, HALF)


def test_a_waterline_is_found_beside_a_flat_of_bottom() -> None:
    ink = ink_of(drawing())
    flat = refine_line(ink, 300.0, 0.0, False, 2.0)
    assert flat is not None
    calibration = similarity((CENTRE, BASE), 0.01, 0.0, 0.0, "drawn")
    (found,) = expected_lines(ink, calibration, [0.5, 1.06], [flat], vertical=False)
    assert abs(float(found.at(CENTRE)) - 294.0) < 0.3  # the centroid of a line 6 px clear of the next
