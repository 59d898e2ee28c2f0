"""Where curves meet lines and each other, on small drawings: the centre line, a ribbon of several, a corner, a bulb."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from hullform.picture.image.ink import Ink
from hullform.picture.pieces.ends import Ends
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.joints import Cover
from hullform.picture.pieces.ridges import Peaks, Tracklet, find_peaks, find_tracklets, in_half, usable
from hullform.picture.pieces.turning import find_turning
from hullform.picture.tracing.finishing import finish
from hullform.picture.tracing.smoothing import Trace

Array = NDArray[np.float64]
HALF_BREADTH, HEIGHT = 600, 700  # px
MARGIN = 40  # px of paper below the base line and inside of the centre line
WIDTH = 5  # px, of a station's line


def frame() -> DiagonalFrame:
    """The right half of a picture at 1 m per px, origin MARGIN px from the left and from the bottom."""
    to_pixels = np.array([[1.0, 0.0, MARGIN], [0.0, -1.0, HEIGHT], [0.0, 0.0, 1.0]])
    return DiagonalFrame(to_pixels, 1, 1.0, float(HALF_BREADTH), float(HEIGHT - 5))


def drawing(*lines: tuple[Array, int]) -> Ink:
    """Polylines of (y, z) px and their widths, as ink of the picture."""
    image = np.zeros((HEIGHT + MARGIN, HALF_BREADTH + 2 * MARGIN), np.uint8)
    for points, width in lines:
        pixels = np.column_stack([points[:, 0] + MARGIN, HEIGHT - points[:, 1]])
        cv2.polylines(image, [np.round(pixels * 16).astype(np.int32)], False, 255, width, cv2.LINE_AA, 4)
    return (image / 255).astype(np.float32)


def pieces(ink: Ink) -> list[Tracklet]:
    """The tracklets of an ink in the frame, without long lines."""
    nothing = np.zeros(ink.shape, np.uint8)
    peaks = find_peaks(ink, float(WIDTH))
    return find_tracklets(peaks.chosen(usable(peaks, nothing, nothing, frame())))


def test_a_curve_beyond_the_centre_line_is_the_other_halfs() -> None:
    z = np.array([100.0, 300.0])
    there = frame().sample(drawing((np.column_stack([[-5.0, -3.5], z]), 2)))
    here = frame().sample(drawing((np.column_stack([[3.5, 5.0], z]), 2)))
    assert pieces(there) == []
    assert sum(len(t.column) for t in pieces(here)) > 100  # of 141 columns
    # a curve of this half that ends on the line is not shortened by the noise of its last point
    assert in_half(np.array([-1.0]), np.array([50.0]), frame()).all()


@pytest.mark.parametrize("pen_ends_at", [270.0, 215.0])
def test_a_curve_ends_in_the_centre_line_where_that_line_gets_no_thicker(pen_ends_at: float) -> None:
    # a parabola that touches the centre line at z = 200; within 3 px of it nothing of the line's axis is seen
    z = np.arange(pen_ends_at, 600.0)
    ink = drawing((np.column_stack([0.0008 * (z - 200) ** 2, z]), WIDTH))
    ink[:, MARGIN - 3 : MARGIN + 3] = 0.0
    seen = np.arange(285.0, 600.0)
    column, row = frame().from_drawing(0.0008 * (seen - 200) ** 2, seen)
    every = np.arange(np.ceil(column[0]), np.floor(column[-1]))
    one = np.ones(len(every))
    trace = Trace(every, np.interp(every, column, row), one, 1.0, 1.0, 0.0)
    hidden = np.zeros(frame().shape, np.uint8)
    y, height = finish(trace, frame(), frame().sample(ink), hidden, None, None, width_px=float(WIDTH))
    assert y[0] == 0.0
    # the cap of the pen is half a line long; below z = 225 less than half a px of its ink shows beside the line
    assert pen_ends_at - WIDTH <= height[0] <= max(pen_ends_at, 225.0) + WIDTH


def test_an_end_points_where_its_last_straight_stretch_does() -> None:
    column = np.arange(100)
    row = np.where(column < 90, 50.0 + 0.9 * column, 131.0 - 0.8 * (column - 90))
    one = np.ones(100)
    line = Tracklet(column, row, one, one, row - 2, row + 2)
    assert Ends.of([line], last=True).slope[0] == pytest.approx(-0.8, abs=0.02)
    assert Ends.of([line], last=False).slope[0] == pytest.approx(0.9, abs=0.02)


@pytest.mark.parametrize(("slope", "cuts"), [(0.2, 1), (1.0, 0)])
def test_a_ribbon_is_cut_where_a_curve_leaves_its_edge_at_a_small_angle(slope: float, cuts: int) -> None:
    ribbon = np.arange(100)
    branch = np.arange(60, 100)
    column = np.concatenate([ribbon, branch])
    row = np.concatenate([50 + 0.1 * ribbon, 63.5 + slope * (branch - 60)])  # 7.5 px from the axis there
    half = np.where(np.arange(140) < 100, 8.0, 2.0)
    lean = np.where(np.arange(140) < 100, 0.1, slope)
    order = np.lexsort((row, column))
    peaks = Peaks(*(v[order] for v in (column, row, np.ones(140), lean, row - half, row + half)))
    found = find_tracklets(peaks)
    ends = [int(t.column[-1]) for t in found if t.width[0] > 10]
    assert sorted(ends) == [59, 99][-1 - cuts :]


def test_ink_hides_a_gap_where_it_has_no_break() -> None:
    mask, ink = np.zeros((50, 50), np.uint8), np.zeros((50, 50), np.float32)
    mask[10, :10], ink[20], ink[30, :10] = 1, 1.0, 1.0
    columns = np.tile(np.arange(0.0, 20.0, 2.0), (3, 1))
    rows = np.array([[10.0], [20.0], [30.0]]) + np.zeros((1, 10))
    # a long line over half of the gap; a curve along all of it; a stroke of a letter over half of it
    assert Cover(mask, ink).hides(columns, rows) == pytest.approx([0.5, 1.0, 0.0])


def test_the_crown_of_a_bulb_is_followed_to_the_centre_line() -> None:
    angle = np.linspace(-np.pi / 2, np.pi / 2, 100)
    ink = frame().sample(drawing((np.column_stack([60 * np.cos(angle), 180 + 110 * np.sin(angle)]), WIDTH)))
    nothing = np.zeros(ink.shape, np.uint8)
    turning = find_turning(
        ink, nothing, pieces(ink), frame(), float(WIDTH), 600.0, lambda y: np.full(np.shape(y), 600.0)
    )
    ends = [frame().to_drawing(*(values[-1] for values in turning.points(n))) for n in range(len(turning.pieces))]
    inmost = min(ends, key=lambda end: float(end[0]))
    assert float(inmost[0]) < 2 * WIDTH
    assert float(inmost[1]) == pytest.approx(290.0, abs=3.0)
