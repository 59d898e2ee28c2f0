"""Where curves end, which line is no station, and who goes on where two touch, on small drawings of known truth."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from hullform.picture.image.ink import Ink
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.ridges import Tracklet, without_hair_lines
from hullform.picture.pieces.sheer import find_sheer
from hullform.picture.pieces.side import find_side
from hullform.picture.tracing.flow import MarkInFrame, Path, find_paths
from hullform.picture.tracing.uncrossing import uncrossed

Array = NDArray[np.float64]
HALF_BREADTH, HEIGHT = 600, 700  # px
MARGIN = 40  # px of paper below the base line and inside of the centre line
WIDTH = 5  # px, of a station's line


def frame() -> DiagonalFrame:
    """The right half of a picture at 1 m per px, origin MARGIN px from the left and from the bottom."""
    to_pixels = np.array([[1.0, 0.0, MARGIN], [0.0, -1.0, HEIGHT], [0.0, 0.0, 1.0]])
    return DiagonalFrame(to_pixels, 1, 1.0, float(HALF_BREADTH), float(HEIGHT - 5))


def drawing(*lines: tuple[list[tuple[float, float]], int]) -> Ink:
    """Polylines of (y, z) px and their widths as a map of ink."""
    image = np.zeros((HEIGHT + MARGIN, HALF_BREADTH + 2 * MARGIN), np.uint8)
    for points, width in lines:
        pixels = np.array([(y + MARGIN, HEIGHT - z) for y, z in points])
        cv2.polylines(image, [np.round(pixels * 16).astype(np.int32)], False, 255, width, cv2.LINE_AA, 4)
    return (image / 255).astype(np.float32)


def piece(column: Array, row: Array, width: float = float(WIDTH)) -> Tracklet:
    ones = np.ones(len(column))
    return Tracklet(
        column.astype(np.int64), row, ones, np.gradient(row, column), row - width / 2 * ones, row + width / 2 * ones
    )


def test_the_side_thins_where_an_inner_station_ends() -> None:
    # the inner station lies 1.5 px inside of the outermost one and ends at 320
    ink = drawing(([(600, 60), (600, 600)], WIDTH), ([(598.5, 60), (598.5, 320)], WIDTH))
    side = find_side(ink, frame(), float(WIDTH), 600.0)
    assert side.top_px == pytest.approx(600, abs=4)  # round caps of half a width
    assert len(side.steps_px) == 1
    assert side.steps_px[0] == pytest.approx(320, abs=6)  # cap, and the blur that a step may have


def test_a_station_that_turns_into_the_side_is_no_step() -> None:
    z = np.linspace(60, 400, 60)
    turning = [(float(600 - 40 * (1 - t) ** 2), float(h)) for t, h in zip(np.linspace(0, 1, 60), z, strict=True)]
    side = find_side(drawing(([(600, 60), (600, 600)], WIDTH), (turning, WIDTH)), frame(), float(WIDTH), 400.0)
    assert side.steps_px == ()


def test_labels_on_the_side_do_not_end_it() -> None:
    parts = [[(600.0, 60.0), (600.0, 380.0)], [(600.0, 402.0), (600.0, 420.0)], [(600.0, 442.0), (600.0, 520.0)]]
    side = find_side(drawing(*((part, WIDTH) for part in parts)), frame(), float(WIDTH), 520.0)
    assert side.top_px == pytest.approx(520, abs=4)


def test_labels_above_the_deck_are_no_side() -> None:
    parts = [[(600.0, 60.0), (600.0, 500.0)], [(600.0, 515.0), (600.0, 530.0)], [(600.0, 545.0), (600.0, 560.0)]]
    side = find_side(drawing(*((part, WIDTH) for part in parts)), frame(), float(WIDTH), 500.0)
    assert side.top_px == pytest.approx(500, abs=4)  # the round cap of the stroke


def test_a_bold_box_line_does_not_say_where_the_side_ends() -> None:
    ink = drawing(([(600.0, -30.0), (600.0, 650.0)], WIDTH))
    assert find_side(ink, frame(), float(WIDTH), 500.0).top_px == pytest.approx(500)


def test_a_low_steep_deck_edge_is_found() -> None:
    # stations end on a thin line that falls from 480 at the centre line to 330 at the side: depth is 600 px
    def deck(y: float) -> float:
        return 480 - 150 * (y / 600) ** 3

    edge = [(y, deck(y)) for y in np.linspace(0.0, 600.0, 61).tolist()]
    stations = [([(0.35 * y, 40.0), (y, deck(y))], WIDTH) for y in (80.0, 200.0, 320.0, 440.0, 560.0)]
    sheer = find_sheer(drawing((edge, 1), *stations), frame(), 600.0)
    assert sheer is not None
    inner = np.array([120.0, 250.0, 380.0, 500.0])
    assert np.abs(sheer.at(inner) - [deck(y) for y in inner.tolist()]).max() < 1.5  # a pixel, and the path's steps


def test_a_row_of_labels_is_no_deck_edge() -> None:
    strokes = [([(y, 560.0), (y + 14, 560.0)], 2) for y in range(20, 590, 40)]
    stations = [([(0.4 * y, 40.0), (y, 580.0)], WIDTH) for y in (100.0, 250.0, 400.0, 550.0)]
    assert find_sheer(drawing(*strokes, *stations), frame(), 600.0) is None


def test_hair_lines_and_hooks_are_left_out() -> None:
    column = np.arange(100, 300).astype(np.float64)
    hooked = np.where(column > 296, 50 + 2.0 * (column - 296), 50.0)
    bold = [piece(column, hooked), piece(column, np.full(200, 70.0))]
    kept = without_hair_lines([*bold, piece(column, np.full(200, 90.0), width=2.0)], float(WIDTH))
    assert len(kept) == 2
    assert np.abs(kept[0].row - 50.0).max() < 0.5
    assert kept[0].column[0] == 100


def test_stations_that_touch_do_not_cross() -> None:
    # two lines come together, run as one from 200 to 300, and part; the flow left by the wrong branches
    before, middle, after = np.arange(100.0, 200.0), np.arange(200.0, 300.0), np.arange(300.0, 400.0)
    away = np.linspace(30.0, 0.0, 100)
    pieces = [
        piece(before, 100 - away),
        piece(before, 100 + away),
        piece(middle, np.full(100, 100.0)),
        piece(after, 100 - away[::-1]),
        piece(after, 100 + away[::-1]),
    ]
    inner, outer = uncrossed([Path((0, 2, 4), 0.0), Path((1, 2, 3), 0.0)], pieces, float(WIDTH))
    assert inner.tracklets == (0, 2, 3)
    assert outer.tracklets == (1, 2, 4)


def test_lines_that_cross_at_an_angle_stay_crossed() -> None:
    column = np.arange(100.0, 400.0)
    pieces = [piece(column, column - 150.0), piece(column, 350.0 - column)]
    paths = [Path((0,), 0.0), Path((1,), 0.0)]
    assert uncrossed(paths, pieces, float(WIDTH)) == paths


@pytest.mark.parametrize("stations", [1, 2, 3])
def test_each_marked_station_gets_a_curve(stations: int) -> None:
    # one line as thin as one station, so that nothing but the marks asks for more than one curve
    column = np.arange(40, 500)
    row = np.full(len(column), frame().from_drawing(0.0, 0.0)[1] + 40.0)
    line = piece(column.astype(np.float64), row)
    ink = np.zeros(frame().shape, np.float32)
    marks = [MarkInFrame(n, 200.0 + 10 * n, float(row[0]) + 2.0) for n in range(stations)]
    top = np.array([300.0])
    paths, _ = find_paths([line], ink, np.zeros(ink.shape, np.uint8), frame(), float(WIDTH), top, 5, marks)
    assert len(paths) == stations
