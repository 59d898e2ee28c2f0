"""The parts of the picture reader on small drawings whose truth is known exactly."""

from __future__ import annotations

import math

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from hullform.errors import PictureError
from hullform.picture.calibrating.calibration import calibrate
from hullform.picture.calibrating.line_mask import subtract_lines
from hullform.picture.calibrating.lines import find_lines
from hullform.picture.image.ink import ink_of
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.ridges import find_peaks, find_tracklets
from hullform.picture.tracing.flow import find_paths
from hullform.ship_body_plan import CalibrationGiven

Array = NDArray[np.float64]
SIZE = (700, 900)  # rows, columns
CENTRE, BASE, SCALE = (450.0, 600.0), 600.0, 0.05  # px, px, metres per px


def blank() -> NDArray[np.uint8]:
    return np.full(SIZE, 250, np.uint8)


def stroke(image: NDArray[np.uint8], points: Array, width: int = 2) -> None:
    """An anti-aliased polyline, its points given to 1/16 px."""
    cv2.polylines(image, [np.round(points * 16).astype(np.int32)], False, 10, width, cv2.LINE_AA, 4)


def grid_drawing(turn_deg: float) -> NDArray[np.uint8]:
    """B = 30 m, D = 22 m at 0.05 m per px: lines every 5 m, box lines at B/2, turned counter-clockwise."""
    image = blank()
    turn = math.radians(turn_deg)

    def at(y: float, z: float) -> tuple[float, float]:
        u, v = y / SCALE, -z / SCALE
        return (
            CENTRE[0] + u * math.cos(turn) + v * math.sin(turn),
            CENTRE[1] - u * math.sin(turn) + v * math.cos(turn),
        )

    for y in (-15, -10, -5, 0, 5, 10, 15):
        stroke(image, np.array([at(y, -0.5), at(y, 23)]), 3 if y == 0 else 1)
    for z in (0, 5, 10, 15, 20):
        stroke(image, np.array([at(-15.5, z), at(15.5, z)]), 3 if z == 0 else 1)
    return image


def test_ridges_lie_on_the_axis_of_a_slanted_line() -> None:
    image = blank()
    stroke(image, np.array([[20.0, 100.3], [880.0, 400.7]]))
    peaks = find_peaks(ink_of(image), 2.0)
    inner = (peaks.column > 40) & (peaks.column < 860)
    truth = 100.3 + (peaks.column - 20.0) * 300.4 / 860.0
    error = (peaks.row - truth)[inner]
    assert inner.sum() >= 815
    # OpenCV draws to 1/16 px and shades in steps, so single points waver by some hundredths more
    assert np.sqrt(np.mean(error**2)) < 0.1
    assert abs(error.mean()) < 0.05
    assert np.median(peaks.slope[inner]) == pytest.approx(300.4 / 860.0, abs=0.02)


@pytest.mark.parametrize("turn_deg", [0.0, 0.73, -1.9])
def test_a_turned_grid_gives_rotation_scale_and_origin(turn_deg: float) -> None:
    ink = ink_of(grid_drawing(turn_deg))
    horizontal, vertical = find_lines(ink)
    assert (len(horizontal), len(vertical)) == (5, 7)
    sheet = calibrate(ink, horizontal, vertical, breadth_m=30.0, depth_m=22.0)
    found = sheet.calibration
    assert found.rotation_deg == pytest.approx(turn_deg, abs=0.02)
    assert found.metres_per_px == pytest.approx(SCALE, rel=5e-4)
    assert (found.centreline_px, found.baseline_px) == pytest.approx(CENTRE, abs=0.4)
    assert sheet.grid_m == (5.0, 5.0)
    assert sheet.doubts == ()
    assert found.residual_px < 0.5


def test_given_calibration_wins_over_what_the_picture_shows() -> None:
    ink = ink_of(grid_drawing(0.0))
    horizontal, vertical = find_lines(ink)
    given = CalibrationGiven(centreline_px=448.0, metres_per_px=0.06)
    sheet = calibrate(ink, horizontal, vertical, 30.0, 22.0, given)
    assert sheet.calibration.centreline_px == 448.0
    assert sheet.calibration.metres_per_px == pytest.approx(0.06)
    assert sheet.calibration.baseline_px == pytest.approx(BASE, abs=0.4)
    # 300 px at 0.06 m are 18 m, not B/2 = 15 m
    assert any("B/2 is 15.00 m" in doubt for doubt in sheet.doubts)


def test_two_given_points_fix_scale_and_rotation() -> None:
    given = CalibrationGiven.model_validate(
        {"points": [{"px": [450, 600], "m": [0, 0]}, {"px": [750, 200], "m": [15, 20]}]}
    )
    calibration = calibrate(ink_of(grid_drawing(0.0)), [], [], 30.0, 22.0, given).calibration
    assert calibration.metres_per_px == pytest.approx(0.05)
    assert calibration.rotation_deg == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("points", [[[0, 0]], [[0, 0], [0, 0]], [[0, 0], [1, 1], [2, 2]]])
def test_points_that_fix_no_scale_are_refused(points: list[list[float]]) -> None:
    given = CalibrationGiven.model_validate({"points": [{"px": [450 + p[0], 600 - p[1]], "m": p} for p in points]})
    with pytest.raises(PictureError, match="fix no scale"):
        calibrate(ink_of(grid_drawing(0.0)), [], [], 30.0, 22.0, given)


def test_no_long_lines_says_which_key_to_give() -> None:
    image = blank()
    cv2.circle(image, (450, 350), 200, 10, 2, cv2.LINE_AA)
    ink = ink_of(image)
    horizontal, vertical = find_lines(ink)
    with pytest.raises(PictureError, match="centreline_px"):
        calibrate(ink, horizontal, vertical, 30.0, 22.0)


def test_subtracted_lines_leave_the_curve_that_crosses_them() -> None:
    image = grid_drawing(0.0)
    stroke(image, np.array([[460.0, 590.0], [700.0, 250.0]]))
    ink = ink_of(image)
    horizontal, vertical = find_lines(ink)
    bare, mask = subtract_lines(ink, horizontal + vertical)
    assert bare[400, 500:540].max() < 0.1  # a waterline, away from the curve
    u = 460.0 + 240.0 * (590 - 450) / 340
    assert bare[450, round(u) - 1 : round(u) + 2].max() > 0.6  # the curve between lines
    assert mask[round(BASE), 300] & 2
    assert not mask[450, round(u)]


def test_flow_keeps_two_curves_apart_that_touch() -> None:
    frame = DiagonalFrame(np.diag([1.0, 1.0, 1.0]), 1, 1.0, 300.0, 300.0)
    rows, columns = frame.shape
    image = np.full((rows, columns), 250, np.uint8)
    a = np.arange(8.0, 380.0)
    middle = float(frame.from_drawing(0.0, 0.0)[1])
    gap = 3.0 + 0.0012 * (a - 190.0) ** 2  # 3 px apart in the middle, 43 px at the ends
    for sign in (-0.5, 0.5):
        stroke(image, np.column_stack([a, middle + sign * gap]), 2)
    ink = ink_of(image)
    tracklets = find_tracklets(find_peaks(ink, 2.0))
    top = np.full(len(tracklets), 200.0)
    mask = np.zeros(ink.shape, np.uint8)
    paths, unlisted = find_paths(tracklets, ink, mask, frame, 2.0, top, most=5)
    assert (len(paths), unlisted) == (2, 0)
    for path in paths:
        row = np.concatenate([tracklets[i].row for i in path.tracklets]) - middle
        assert np.all(row > -0.8) or np.all(row < 0.8)  # neither crosses over
        assert abs(row[0]) > 15 or len(row) > 250


def test_dashes_are_no_specks() -> None:
    # a chain-dotted centre line 2 px thick in a picture of 2300 px, its dashes of 15 px a piece of 30 px each
    page = np.full((400, 2300), 250, np.uint8)
    page[50:350, 600:602] = 0
    for top in range(50, 330, 24):
        page[top : top + 15, 1149:1151] = 0
        page[top + 19 : top + 21, 1149:1151] = 0
    page[200:205, 1700:1705] = 0
    ink = ink_of(page)
    assert (ink[52, 1149:1151] > 0.9).all()
    assert ink[202, 1702] == 0.0
