"""What is a frame of the sheet and what is none: borders, and grids beside the lines of the ship herself."""

from __future__ import annotations

import cv2
import numpy as np

from hullform.picture.calibrating.scale import find_combs
from hullform.picture.image.ink import ink_of

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
