"""Contours that close on the centre line, joints in the plane, and what lies below the base line."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from hullform.picture.naming.contours import NO_LOOP, marks_on_loops, pair_loops
from hullform.picture.naming.marks import PlacedMark, near_curves
from hullform.picture.pieces.dome import find_dome, only_contours
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.joints import Cover, Tips, joints
from hullform.picture.tracing.bends import walking_order
from hullform.picture.tracing.winding import closed, ends_at_centre
from hullform.ship_body_plan import Mark

Array = NDArray[np.float64]
SIZE = 400.0  # px per B/2
FRAME = DiagonalFrame(np.array([[1.0, 0.0, 0.0], [0.0, -1.0, 500.0], [0.0, 0.0, 1.0]]), 1, 1.0, SIZE, SIZE)


def loop(top: float) -> Array:
    around = np.linspace(-np.pi / 2, np.pi / 2, 30)
    return np.column_stack([40 * np.cos(around), top / 2 + top / 2 * np.sin(around)])


def flare(start: float) -> Array:
    return np.array([[0.0, start], [60.0, SIZE]])


def test_loops_go_to_the_stations_next_to_those_of_one_curve() -> None:
    whole = np.array([[0.0, 0.0], [80.0, 100.0], [150.0, SIZE]])
    curves = [flare(300.0), flare(250.0), flare(200.0), whole, whole]
    assert pair_loops([loop(80.0), loop(120.0)], curves, SIZE) == [NO_LOOP, 0, 1, NO_LOOP, NO_LOOP]


def test_a_mark_on_a_loop_goes_before_the_order() -> None:
    curves = [flare(300.0), flare(250.0), flare(200.0)]
    assert pair_loops([loop(80.0), loop(120.0)], curves, SIZE, [(0, 0)]) == [0, NO_LOOP, 1]


@pytest.mark.parametrize(("place", "contour"), [((40.0, 60.0), 0), ((30.0, 325.0), None)])
def test_a_mark_of_a_second_contour_means_a_loop_and_is_doubted_elsewhere(
    place: tuple[float, float], contour: int | None
) -> None:
    mark = PlacedMark(Mark(station_m=97.0, half="fore", px=(0.0, 0.0), curve=1), 0, *place)
    curve = np.column_stack([np.linspace(0.0, 60.0, 50), np.linspace(250.0, SIZE, 50)])
    others, chosen = marks_on_loops([mark], [curve], [loop(120.0)], SIZE)
    assert [number for _, number in chosen] == ([] if contour is None else [contour])
    used, doubts = near_curves(others, [curve], SIZE)
    assert len(used) == len(doubts) == (0 if contour is not None else 1)
    assert all("second contour" in doubt for doubt in doubts)


def test_a_loop_needs_a_flare_that_starts_above_it() -> None:
    assert pair_loops([loop(200.0)], [flare(120.0)], SIZE) == [NO_LOOP]


def test_a_station_that_was_not_found_has_a_loop_only_inside_of_all_others() -> None:
    whole = np.array([[0.0, 0.0], [150.0, SIZE]])
    assert pair_loops([loop(80.0)], [None, whole], SIZE) == [0, NO_LOOP]
    assert pair_loops([loop(80.0)], [whole, None], SIZE) == [NO_LOOP, NO_LOOP]


def tips(column: float, row: float, direction_deg: float) -> Tips:
    angle = np.radians(direction_deg)
    return Tips(np.array([column]), np.array([row]), np.array([[np.cos(angle), np.sin(angle)]]), np.array([50.0]))


@pytest.mark.parametrize(
    ("start", "direction_deg", "joined"),
    [
        ((110.0, 100.0), 0.0, True),  # straight on
        ((110.0, 102.0), 20.0, True),  # a bend
        ((104.0, 96.0), -85.0, True),  # a corner, its ends nearly touch
        ((110.0, 100.0), 180.0, False),  # back
        ((90.0, 100.0), 0.0, False),  # behind
        ((110.0, 100.0 + SIZE), 0.0, False),  # elsewhere
    ],
)
def test_joints_go_on_bend_or_turn_a_corner(start: tuple[float, float], direction_deg: float, joined: bool) -> None:
    blank = np.zeros((800, 800), np.uint8)
    source, _, _ = joints(
        tips(100.0, 100.0, 0.0), tips(*start, direction_deg), Cover(blank, blank.astype(np.float32)), SIZE, 1.0
    )
    assert (source.size == 1) == joined


def test_a_walk_visits_what_leads_to_a_node_first_and_rings_last() -> None:
    preferred = np.array([0, 1, 2, 3, 4])
    # 2 leads to 0; 3 and 4 lead to each other
    assert walking_order(preferred, np.array([2, 3, 4]), np.array([0, 4, 3])) == [1, 2, 0, 3, 4]


def test_a_contour_below_the_base_line_is_told_from_letters() -> None:
    ink = np.zeros((700, 500), np.float32)  # the base line is at v = 500
    ink[500:600, 60:63] = ink[597:600, 0:63] = 1.0  # a contour 100 px deep, from the centre line
    ink[520:530, 200:210] = 1.0  # a letter
    dome = find_dome(ink, FRAME)
    # the closing of gaps and the flank make the mask some pixels wider than the line
    assert 99 <= dome.depth_px <= 110
    frame = DiagonalFrame(FRAME.pixel_from_metres, 1, 1.0, SIZE, SIZE, bottom_px=-dome.depth_px)
    seen = only_contours(frame.sample(ink), frame, dome)
    column, row = (int(v) for v in frame.from_drawing(61.0, -50.0))
    assert seen[row - 2 : row + 3, column - 2 : column + 3].max() > 0.5
    column, row = (int(v) for v in frame.from_drawing(205.0, -25.0))
    assert seen[row - 8 : row + 9, column - 8 : column + 9].max() == 0.0


def test_nothing_below_the_base_line_leaves_the_frame_as_it_is() -> None:
    assert find_dome(np.zeros((700, 500), np.float32), FRAME).depth_px == 0.0


def test_places_below_the_base_line_have_columns_of_their_own() -> None:
    frame = DiagonalFrame(FRAME.pixel_from_metres, 1, 1.0, SIZE, SIZE, bottom_px=-100.0)
    y, z = np.array([0.0, 50.0, 400.0]), np.array([-100.0, -20.0, 400.0])
    column, row = frame.from_drawing(y, z)
    rows, columns = frame.shape
    assert ((column >= 0) & (column < columns)).all()
    assert ((row >= 0) & (row < rows)).all()
    assert np.allclose(frame.to_drawing(column, row), (y, z))


def test_a_loop_is_closed_straight_on() -> None:
    y, z = np.linspace(60.0, 10.0, 51), np.linspace(100.0, 150.0, 51)
    assert ends_at_centre(y, SIZE)
    assert not ends_at_centre(y[::-1], SIZE)
    at_y, at_z = closed(y, z, SIZE)
    assert (at_y[-1], at_z[-1]) == pytest.approx((0.0, 160.0))
