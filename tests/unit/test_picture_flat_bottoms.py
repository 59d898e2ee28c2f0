"""What a flat-bottomed hull shows: bilges alone between base line and side, a column of numbers, flats on lines."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from hullform.picture.calibrating.line_mask import HORIZONTAL, VERTICAL
from hullform.picture.checking.doubts import _runs_on
from hullform.picture.image.ink import Ink
from hullform.picture.pieces.ends import Ends, entry_cost
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.ridges import Tracklet, find_peaks, find_tracklets
from hullform.picture.pieces.turning import find_turning
from hullform.picture.tracing.finishing import finish
from hullform.picture.tracing.flow import find_paths
from hullform.picture.tracing.half import HalfReading
from hullform.picture.tracing.lower_end import lower_end
from hullform.picture.tracing.smoothing import Trace

Array = NDArray[np.float64]
HALF_BREADTH, HEIGHT = 600, 320  # px
MARGIN = 40  # px of paper below the base line and inside of the centre line
WIDTH = 4  # px, of a station's line
RADIUS = 40.0  # px, of a bilge


def frame() -> DiagonalFrame:
    """The right half of a picture at 1 m per px, origin MARGIN px from the left and from the bottom."""
    to_pixels = np.array([[1.0, 0.0, MARGIN], [0.0, -1.0, HEIGHT], [0.0, 0.0, 1.0]])
    return DiagonalFrame(to_pixels, 1, 1.0, float(HALF_BREADTH), float(HEIGHT - 5))


def picture(*lines: list[tuple[float, float]]) -> Ink:
    """Polylines of (y, z) px as a map of ink."""
    image = np.zeros((HEIGHT + MARGIN, HALF_BREADTH + 2 * MARGIN), np.uint8)
    for points in lines:
        pixels = np.array([(y + MARGIN, HEIGHT - z) for y, z in points])
        cv2.polylines(image, [np.round(pixels * 16).astype(np.int32)], False, 255, WIDTH, cv2.LINE_AA, 4)
    return (image / 255).astype(np.float32)


def bilge(foot: float) -> list[tuple[float, float]]:
    """A quarter of a circle from the level line at a height to the side."""
    angle = np.linspace(0.0, np.pi / 2, 40)
    y, z = HALF_BREADTH - RADIUS * (1 - np.sin(angle)), foot + RADIUS * (1 - np.cos(angle))
    return list(zip(y.tolist(), z.tolist(), strict=True))


def hidden(foot: float) -> NDArray[np.uint8]:
    """Where in the frame the level line at a height and the line of B/2 were taken off."""
    mask = np.zeros((HEIGHT + MARGIN, HALF_BREADTH + 2 * MARGIN), np.uint8)
    for height in {0.0, foot}:
        mask[round(HEIGHT - height) - 4 : round(HEIGHT - height) + 5] |= HORIZONTAL
    mask[:, HALF_BREADTH + MARGIN - 4 : HALF_BREADTH + MARGIN + 5] |= VERTICAL
    return frame().sample_mask(mask)


def pieces(foot: float) -> tuple[Ink, list[Tracklet]]:
    """Ink in the frame and pieces of the one bilge, as far as it can be seen beside the lines."""
    ink = frame().sample(picture(bilge(foot)))
    ink[hidden(foot) > 0] = 0.0
    return ink, find_tracklets(find_peaks(ink, float(WIDTH)))


@pytest.mark.parametrize("foot", [0.0, 120.0])
def test_a_bilge_alone_is_a_curve(foot: float) -> None:
    # its flat lies on the base line or on a waterline, its side on the line of B/2
    ink, tracklets = pieces(foot)
    top = np.full(len(tracklets), 280.0)
    paths, _ = find_paths(tracklets, ink, hidden(foot), frame(), float(WIDTH), top, 5, side_top_px=280.0)
    assert len(paths) == 1


def test_a_stroke_that_begins_in_the_air_is_dear() -> None:
    _, tracklets = pieces(120.0)
    first, last = (Ends.of(tracklets, last=end) for end in (False, True))
    on_line = entry_cost(first, last, hidden(120.0), frame(), 1.0)
    on_paper = entry_cost(first, last, hidden(0.0), frame(), 1.0)
    crossing = entry_cost(first, first, hidden(120.0), frame(), 1.0)  # goes on as it began
    assert on_line.min() < 20
    assert min(on_paper.min(), crossing.min()) > 200


def test_a_flat_on_a_waterline_is_led_to_the_centre_line() -> None:
    ink, tracklets = pieces(120.0)
    part = max(tracklets, key=lambda t: len(t.column))
    column = part.column.astype(np.float64)
    ones = np.ones(len(column))
    trace = Trace(column, part.row, ones, 1.0, 1.0, 0.0)
    y, z = finish(trace, frame(), ink, hidden(120.0), None, 280.0, 280.0)
    assert (y[0], z[0]) == pytest.approx((0.0, 120.0), abs=6)  # the bilge leaves the line unseen within its width


def test_a_bottom_with_rise_of_floor_goes_straight_to_the_keel_in_the_ink_of_its_fan() -> None:
    rises = (0.055, 0.065, 0.075)
    ink = frame().sample(picture(*([(0.0, 0.0), (500.0, 500.0 * rise)] for rise in rises)))
    y = np.arange(240.0, 360.0)
    # as traced where it leaves the fan: bent by its neighbour, so that a parabola misses the base line
    z = 0.055 * y + 2.0 * np.exp(-(y - 240.0) / 10)
    found_y, found_z = lower_end(y, z, frame(), ink, float(WIDTH))
    assert (found_y[0], found_z[0]) == (0.0, 0.0)
    at = np.linspace(0.0, 240.0, 50)
    assert np.abs(np.interp(at, found_y, found_z) - 0.055 * at).max() <= 2.0


@pytest.mark.parametrize("seen_from", [6.5, 8.0, 13.0, 20.0])  # px, of a line of 4 px
def test_a_bottom_that_turns_into_a_flat_touches_the_base_line(seen_from: float) -> None:
    turn = [(y, (y - 120.0) ** 2 / 400) for y in np.arange(120.0, 300.0)]
    ink = frame().sample(picture(turn))
    y, z = np.array([(y, z) for y, z in turn if z > seen_from]).T
    found_y, found_z = lower_end(y, z, frame(), ink, float(WIDTH))
    assert (found_y[0], found_z[0]) == (0.0, 0.0)
    at = np.linspace(0.0, float(y[0]), 50)
    # the parabola is the curve's own
    assert np.interp(at, found_y, found_z) == pytest.approx(np.maximum(at - 120.0, 0.0) ** 2 / 400, abs=0.4)


def test_a_flat_of_bottom_is_no_top_of_a_bulb() -> None:
    long = picture([(0.0, 120.0), (560.0, 120.0), (598.0, 160.0)])
    ink = frame().sample(long)
    tracklets = find_tracklets(find_peaks(ink, float(WIDTH)))
    mask = np.zeros(ink.shape, np.uint8)
    found = find_turning(ink, mask, tracklets, frame(), float(WIDTH), 280.0, lambda y: np.full(np.shape(y), 280.0))
    assert found.pieces == []
    short = frame().sample(picture([(0.0, 120.0), (150.0, 120.0)]))
    tracklets = find_tracklets(find_peaks(short, float(WIDTH)))
    found = find_turning(short, mask, tracklets, frame(), float(WIDTH), 280.0, lambda y: np.full(np.shape(y), 280.0))
    assert len(found.pieces) == 1


def test_figures_above_the_side_are_no_curve_that_goes_on() -> None:
    curve = np.array([(600.0, 40.0), (600.0, 200.0)])
    reading = HalfReading("fore", frame(), (curve,), (1.0,), None)
    near = np.ones((7, 7), np.uint8)
    figures = [[(590.0, z), (610.0, z), (610.0, z + 8), (590.0, z + 8)] for z in (207.0, 221.0, 235.0)]
    assert not _runs_on(curve, reading, np.asarray(cv2.dilate(picture(*figures), near), np.float32))
    stroke = picture([(600.0, 40.0), (600.0, 260.0)])
    assert _runs_on(curve, reading, np.asarray(cv2.dilate(stroke, near), np.float32))
