"""What is a frame of the sheet and what is none: borders, and grids beside the lines of the ship herself."""

from __future__ import annotations

from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from hullform.errors import PictureError
from hullform.picture.calibrating.calibration import calibrate
from hullform.picture.calibrating.lines import find_lines
from hullform.picture.calibrating.scale import find_combs, outermost_half_breadth
from hullform.picture.image.ink import ink_of
from hullform.picture.image.paper import beyond_paper
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.sheet.likeness import require_upright

WHITE = 255


def paper() -> np.ndarray:
    return np.full((900, 1200), WHITE, np.uint8)


def test_a_border_round_a_drawing_is_left_out() -> None:
    sheet = paper()
    cv2.rectangle(sheet, (20, 20), (1180, 880), 0, 3)
    cv2.rectangle(sheet, (900, 780), (1180, 880), 0, 2)  # its title block
    cv2.rectangle(sheet, (200, 200), (1000, 700), 0, 2)
    ink = ink_of(sheet)
    # what is left is the blur beside the line, fainter than anything that counts as drawn
    assert ink[450, 15:30].max() < 0.25
    assert ink[450, 195:205].max() > 0.5


def test_a_drawing_that_is_torn_apart_is_no_border() -> None:
    # base line, centre line and sides hang together; a waterline between them, broken off by lost ink, does not
    sheet = paper()
    cv2.line(sheet, (100, 800), (1100, 800), 0, 3)
    for u in (100, 600, 1100):
        cv2.line(sheet, (u, 100), (u, 800), 0, 3)
    cv2.line(sheet, (620, 500), (1080, 500), 0, 2)
    cv2.line(sheet, (110, 400), (590, 400), 0, 2)
    ink = ink_of(sheet)
    assert ink[795:806, 300].max() > 0.5
    assert ink[300, 595:606].max() > 0.5


def test_the_sides_of_the_ship_alone_make_no_grid() -> None:
    assert find_combs(np.array([-675.6, 0.0, 675.6])) == []


def test_a_buttock_at_half_the_breadth_makes_one() -> None:
    combs = find_combs(np.array([-675.6, -337.8, 0.0, 337.8, 675.6]))
    assert any(abs(comb.spacing_px - 337.8) < 0.1 for comb in combs)


def test_a_half_that_goes_round_pieces_has_no_top_and_is_no_border() -> None:
    # the outer stations of both halves hang together, the centre line and what is inside was torn off
    sheet = paper()
    cv2.polylines(sheet, [np.array([(100, 100), (150, 790), (1050, 790), (1100, 100)])], False, 0, 3)
    cv2.polylines(sheet, [np.array([(250, 150), (300, 500), (595, 700)])], False, 0, 3)
    cv2.polylines(sheet, [np.array([(605, 700), (900, 500), (950, 150)])], False, 0, 3)
    ink = ink_of(sheet)
    assert ink[785:796, 300].max() > 0.5


def photograph() -> tuple[np.ndarray, np.ndarray]:
    """A turned sheet on a table under a lamp, its far corner as dark as the table; and where the sheet lies."""
    v, u = np.mgrid[0:900, 0:1200].astype(np.float64)
    corners = np.array([(90, 60), (1130, 90), (1110, 840), (70, 810)])
    sheet = cv2.fillPoly(np.zeros((900, 1200), np.uint8), [corners], 1) > 0
    lamp = 1 - 0.5 * np.hypot(u - 950, v - 700) / 1150
    return np.where(sheet, 255 * lamp, 96).astype(np.uint8), sheet


def test_a_sheet_is_found_by_its_edge_however_dark_its_corner() -> None:
    grey, sheet = photograph()
    assert grey[sheet].min() < 1.45 * 96  # a threshold between table and lamp would cut through the sheet
    beyond = beyond_paper(grey)
    assert beyond is not None
    core = cv2.erode(sheet.astype(np.uint8), np.ones((61, 61), np.uint8)) > 0
    assert not beyond[core].any()
    assert beyond[~sheet].mean() > 0.98  # corners are cut to the pixel of a small picture


def test_figures_in_a_column_are_no_side() -> None:
    ink = np.zeros((700, 1200), np.float32)
    cv2.line(ink, (600, 50), (600, 660), 1.0, 3)
    cv2.line(ink, (60, 650), (1140, 650), 1.0, 3)
    for side in (-1, 1):
        cv2.line(ink, (600 + side * 400, 150), (600 + side * 400, 650), 1.0, 3)
        for v in range(200, 650, 90):  # waterlines, each with a figure on its end
            cv2.line(ink, (600, v), (600 + side * 470, v), 1.0, 1)
            cv2.rectangle(ink, (600 + side * 470 - 9, v - 6), (600 + side * 470 + 9, v + 6), 1.0, 2)
    found = outermost_half_breadth(ink, (600.0, 650.0), 0.0)
    assert found == pytest.approx(400, abs=4)


def test_sides_are_found_though_ink_is_lost_along_the_centre_line_and_where_the_base_line_leaves_it() -> None:
    ink = np.zeros((700, 1200), np.float32)
    cv2.line(ink, (600, 40), (600, 660), 1.0, 2)
    cv2.line(ink, (150, 650), (1050, 650), 1.0, 2)
    for side in (-1, 1):
        cv2.line(ink, (600 + side * 400, 100), (600 + side * 400, 650), 1.0, 2)  # the line of B/2
        cv2.line(ink, (600, 600), (600 + side * 300, 100), 1.0, 2)  # a station, short of it
    ink[300:330, 590:610] = 0.0  # a blot of white on the centre line, and one between the station's foot and the base
    ink[620:635, 590:610] = 0.0
    assert outermost_half_breadth(ink, (600.0, 650.0), 0.0) == pytest.approx(400, abs=4)


def test_waterlines_may_be_missing_where_the_rest_has_no_multiple() -> None:
    assert any(abs(comb.spacing_px - 93.7) < 0.2 for comb in find_combs(np.array([0.0, 434.2, 468.5, 562.2, 655.9])))


def lines_of(*ends: tuple[tuple[float, float], tuple[float, float], int]) -> np.ndarray:
    sheet = paper()
    for start, end, width in ends:
        points = np.round(np.array([start, end]) * 16).astype(np.int32)
        cv2.polylines(sheet, [points], False, 40, width, cv2.LINE_AA, 4)
    return ink_of(sheet)


def test_a_flat_beside_the_base_line_hides_it_not() -> None:
    levels = [((100.0, v), (1100.0, v), 3) for v in (300.0, 450.0, 600.0, 760.0)]
    flat = ((140.0, 753.0), (1060.0, 753.0), 4)
    upright = [((u, 150.0), (u, 780.0), 2) for u in (200.0, 400.0, 600.0, 800.0, 1000.0)]
    horizontal, _ = find_lines(lines_of(*levels, flat, *upright))
    found = [float(line.at(600.0)) for line in horizontal]
    assert min(abs(v - 760.0) for v in found) < 0.5
    assert min(abs(v - 753.0) for v in found) < 0.5


def test_a_line_that_curves_pull_askew_stays_in_a_converging_family() -> None:
    # upright lines fan out by 0.006; strokes beside the middle one lean on it at its foot
    def at(u: float, v: float) -> float:
        return u + 1e-5 * (u - 600.0) * (v - 450.0)

    places = [150.0, 300.0, 450.0, 600.0, 750.0, 900.0, 1050.0]
    upright = [((at(u, 100.0), 100.0), (at(u, 800.0), 800.0), 2) for u in places]
    levels = [((100.0, v), (1100.0, v), 2) for v in (200.0, 350.0, 500.0, 650.0, 800.0)]
    keels = [((602.0 + d, 640.0 - 60 * d), (601.5, 798.0), 2) for d in (1.0, 2.0, 3.0)]
    _, vertical = find_lines(lines_of(*upright, *levels, *keels))
    middle = [line for line in vertical if abs(float(line.at(450.0)) - 600.0) < 3]
    assert len(middle) == 1
    assert abs(middle[0].slope) < 0.0011
    assert len(vertical) == len(places)


def test_the_border_below_the_centre_line_is_no_base_line() -> None:
    upright = [((u, 120.0), (u, 610.0), 2) for u in (200.0, 300.0, 400.0, 500.0, 700.0, 800.0, 900.0, 1000.0)]
    levels = [((180.0, v), (1020.0, v), 2) for v in (200.0, 300.0, 400.0, 500.0)]
    frame = [((600.0, 100.0), (600.0, 620.0), 3), ((180.0, 600.0), (1020.0, 600.0), 3)]
    border = [((40.0, 850.0), (1160.0, 850.0), 3), ((40.0, 40.0), (40.0, 850.0), 3)]
    ink = lines_of(*upright, *levels, *frame, *border)
    horizontal, vertical = find_lines(ink)
    found = calibrate(ink, horizontal, vertical, breadth_m=8.0, depth_m=5.0).calibration
    assert found.baseline_px == pytest.approx(600.0, abs=0.5)
    assert found.metres_per_px == pytest.approx(0.01, rel=2e-3)


@pytest.mark.parametrize("upside_down", [False, True])
def test_diagonals_do_not_turn_a_barge_over(upside_down: bool) -> None:
    frame = DiagonalFrame(np.array([[1.0, 0.0, 20.0], [0.0, -1.0, 420.0], [0.0, 0.0, 1.0]]), 1, 1.0, 1000.0, 400.0)
    image = np.zeros((440, 1060), np.uint8)
    for foot in (40, 100, 160, 220):
        corner = [
            (1010 - 60 + int(60 * np.sin(a)), 420 - foot - 60 + int(60 * np.cos(a))) for a in np.linspace(0, 1.57, 20)
        ]
        cv2.polylines(image, [np.array([(20, 420 - foot), *corner, (1010, 20)])], False, 255, 3, cv2.LINE_AA)
    if upside_down:
        image = image[::-1].copy()
    for start in (250, 390):
        cv2.line(image, (20, 420 - start), (20 + start, 420), 255, 3, cv2.LINE_AA)
    bare = (image / 255).astype(np.float32)
    half = SimpleNamespace(frame=frame, depth_px=400.0)
    if upside_down:
        with pytest.raises(PictureError, match="upside down"):
            require_upright("plan.png", bare, [half])  # type: ignore[list-item]
    else:
        require_upright("plan.png", bare, [half])  # type: ignore[list-item]
