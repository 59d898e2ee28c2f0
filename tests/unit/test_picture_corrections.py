"""What each correction does to the curves of a half, on lines drawn by formula, and that one of nothing is said."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_half import SIZE_PX, half_of, misses, placed, traced
from numpy.typing import NDArray

from hullform.corrections import (
    Correction,
    Crossing,
    Cut,
    Deleted,
    Drawn,
    Ignored,
    Joined,
    Knuckle,
    RunTogether,
)
from hullform.picture.edits.corrected import correct_ink
from hullform.picture.tracing.half import trace_half

Array = NDArray[np.float64]
Point = tuple[float, float]

T = np.linspace(0.0, 1.0, 400)
# A line two pixels thick is found within some tenths. The first pixels of the keel, where lines leave in one blot or
# turn within a line's width, are a parabola's guess: right within about that width.
ON_LINE_PX = 2.0
BLUNT = 3  # points at the upper end of a line, 4 px: where a stroke ends bluntly its ridge turns off and is left out


def at(line: Array, share: float, off_px: Point = (0.0, 0.0)) -> Point:
    """A pixel of the picture on a line, a share of its points from the keel, beside it by what a hand errs."""
    y, z = line[round(share * (len(line) - 1))]
    return (float(y + off_px[0]), float(-z + off_px[1]))


def frame_line(power: float = 0.5, width: float = 150.0) -> Array:
    return np.column_stack([width * T**power, SIZE_PX * T])


def straight(*points: Point) -> Array:
    corners = np.array(points)
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(corners, axis=0).T))])
    along = np.linspace(0.0, arc[-1], 500)
    return np.column_stack([np.interp(along, arc, corners[:, k]) for k in (0, 1)])


def test_a_deleted_line_is_traced_no_more() -> None:
    station, junk = frame_line(), frame_line(0.8, 400.0)
    half = half_of([station, junk])
    assert len(traced(half, 2).curves) == 2
    reading = traced(half, 2, Deleted(id="a", px=at(junk, 0.4, (2.0, 3.0))))
    assert len(reading.curves) == 1
    assert misses(reading.curves[0], station).max() < ON_LINE_PX


def test_a_line_is_deleted_up_to_the_next_junctions_only() -> None:
    station = frame_line()
    # a branch leaves the station half-way up
    foot = station[200]
    branch = np.column_stack([foot[0] + 120 * T, foot[1] + 150 * T])
    half = half_of([station, branch])
    reading = traced(half, 2, Deleted(id="a", px=at(branch, 0.6)))
    assert len(reading.curves) == 1
    assert misses(reading.curves[0], station).max() < ON_LINE_PX


def test_a_cut_line_is_two() -> None:
    line = frame_line()
    half = half_of([line])
    assert len(traced(half, 2).curves) == 1
    reading = traced(half, 2, Cut(id="a", px=at(line, 0.5, (2.0, 1.0))))
    lower, upper = sorted(reading.curves, key=lambda curve: float(curve[:, 1].mean()))
    assert lower[:, 1].max() < line[200, 1] + ON_LINE_PX
    assert upper[:, 1].min() > line[200, 1] - ON_LINE_PX


def test_a_curve_is_not_led_over_a_gap_that_is_cut() -> None:
    line = frame_line()
    half = half_of([line[:190], line[210:]])
    assert traced(half, 1).curves[0][:, 1].max() > 0.98 * SIZE_PX
    reading = traced(half, 1, Cut(id="a", px=at(line, 0.5)))
    assert reading.unheeded == ()
    assert reading.curves[0][:, 1].max() < line[200, 1]


def test_joined_lines_are_one_curve() -> None:
    line = frame_line()
    # wider than any gap that is bridged unasked
    half = half_of([line[:130], line[270:]])
    assert traced(half, 1).curves[0][:, 1].max() < line[200, 1]
    reading = traced(half, 1, Joined(id="a", px=(at(line, 0.3), at(line, 0.7))))
    assert len(reading.curves) == 1
    # over the gap the curve is led by its ends: it may miss by some pixels, by its deviation from a parabola there
    assert misses(reading.curves[0], line[:130]).max() < ON_LINE_PX
    assert misses(reading.curves[0], line[270:]).max() < ON_LINE_PX
    assert misses(reading.curves[0], line).max() < 6.0


def test_a_join_needs_no_room_among_the_stations() -> None:
    first, second = frame_line(), frame_line(0.8, 400.0)
    half = half_of([first, second[:130], second[270:]])
    reading = traced(half, 1, Joined(id="a", px=(at(second, 0.3), at(second, 0.7))))
    assert min(misses(curve, second[270:]).max() for curve in reading.curves) < ON_LINE_PX


def test_lines_that_overlap_are_joined_half_way_between_the_points() -> None:
    line = frame_line()
    # the upper part is drawn 5 px off, over the last tenth of the lower one too
    beside = line + np.array([5.0, 0.0])
    half = half_of([line[:220], beside[180:]])
    reading = traced(half, 1, Joined(id="a", px=(at(line, 0.4), at(beside, 0.6))))
    curve = reading.curves[0]
    assert len(reading.curves) == 1
    assert misses(curve, line[:160]).max() < ON_LINE_PX
    assert misses(curve, beside[240:-BLUNT]).max() < ON_LINE_PX


@pytest.mark.parametrize("apart_px", [30.0, 60.0])
def test_lines_that_cross_at_a_small_angle_go_straight_on(apart_px: float) -> None:
    lines = []
    for sign in (1, -1):
        y = apart_px / 2 + 270 * T + sign * apart_px * (T - 0.5)
        lines.append(np.column_stack([y, SIZE_PX * T]))
    half = half_of(lines)
    # unasked, curves that run into each other keep their order from the centre line
    unasked = traced(half, 2).curves
    assert min(misses(curve, lines[0]).max() for curve in unasked) > 0.7 * apart_px
    reading = traced(half, 2, Crossing(id="a", px=at(lines[0], 0.5, (1.2, -0.8))))
    for line in lines:
        assert min(misses(curve, line).max() for curve in reading.curves) < ON_LINE_PX


def test_lines_that_run_together_are_shared() -> None:
    common = np.column_stack([300 * T**0.5, 450 * T])
    lines = []
    for number in range(3):
        away = (20 + 40 * number) * T[1:] ** 1.3
        lines.append(np.vstack([common, np.column_stack([300 + away, 450 + 150 * T[1:]])]))
    half = half_of(lines)
    assert len(traced(half, 3).curves) == 1
    reading = traced(half, 3, RunTogether(id="a", px=(at(common, 0.05), at(common, 0.97))))
    assert len(reading.curves) == 3
    for line in lines:
        assert min(misses(curve, line).max() for curve in reading.curves) < ON_LINE_PX


def test_a_knuckle_is_kept() -> None:
    chine = straight((0, 0), (250, 120), (320, 600))
    half = half_of([chine])
    chine = chine[:-BLUNT]
    rounded = misses(traced(half, 1).curves[0], chine)
    kept = misses(traced(half, 1, Knuckle(id="a", px=(253.0, -124.0))).curves[0], chine)
    # Waves shorter than 4.5 % of B/2, 27 px here, are smoothed: a corner that turns by 56 degrees is cut by 2 to 3 px.
    # Kept, it is uncertain by the line's own width, within which its inner side is drawn round.
    assert rounded.max() > 1.5
    assert kept.max() < 1.0
    assert np.sqrt(np.mean(kept**2)) < 0.5 * np.sqrt(np.mean(rounded**2))


def drawn(line: Array, points: int, **options: object) -> Drawn:
    px = tuple(at(line, share) for share in np.linspace(0, 1, points))
    return Drawn.model_validate({"id": "a", "station_m": 1.0, "half": "aft", "px": px} | options)


def test_a_drawn_curve_is_the_curve_and_takes_its_ink() -> None:
    around = np.linspace(-np.pi / 2, np.pi / 2, 200)
    bulb = np.column_stack([120 * np.cos(around), 150 + 120 * np.sin(around)])
    flare = np.column_stack([200 * T**1.5, 330 + 270 * T])
    outer = frame_line(0.5, 300.0)
    half = half_of([bulb, flare, outer])
    reading = traced(half, 2, drawn(bulb, 9), drawn(flare, 6, curve=1))
    assert reading.drawn == ((0, 1.0),)
    assert reading.confidences[0] == 1.0
    # a cubic through nine points of a half circle misses it by 0.4 px, by the step of 22 degrees
    assert misses(reading.curves[0], bulb).max() < 1.0
    ((station, second),) = reading.second_contours
    assert station == 1.0
    assert misses(second, flare).max() < 2.0
    # what is left is the other station alone
    assert len(reading.curves) == 2
    assert misses(reading.curves[1], outer).max() < ON_LINE_PX


def test_a_drawn_curve_may_have_straight_pieces() -> None:
    reading = traced(half_of([frame_line()]), 1, drawn(straight((0, 0), (250, 120), (320, 600)), 2, smooth=False))
    chord = straight((0, 0), (320, 600))
    assert misses(reading.curves[reading.drawn[0][0]], chord).max() < 0.01


def test_curves_drawn_from_deck_to_keel_are_turned() -> None:
    line = frame_line()
    reading = traced(half_of([frame_line(0.8, 400.0)]), 2, drawn(line[::-1], 8))
    assert reading.curves[0][0, 1] < reading.curves[0][-1, 1]


def test_what_is_ignored_is_gone() -> None:
    station, junk = frame_line(), frame_line(0.8, 400.0)
    half, aside = half_of([station, junk]), np.array([12.0, 0.0])
    outline = np.vstack([junk[30:] + aside, junk[:29:-1] - aside])
    ignored = Ignored(id="a", px=tuple((float(y), float(-z)) for y, z in outline))
    less, heeded = correct_ink(half, [placed(ignored)])
    assert heeded == {"a"}
    reading = trace_half(less, 2)
    assert len(reading.curves) == 1
    assert misses(reading.curves[0], station).max() < ON_LINE_PX


EMPTY: Point = (500.0, -80.0)  # of the picture: no line is near


@pytest.mark.parametrize(
    "correction",
    [
        Deleted(id="a", px=EMPTY),
        Cut(id="a", px=EMPTY),
        Crossing(id="a", px=EMPTY),
        Crossing(id="a", px=at(frame_line(), 0.5)),  # one line alone crosses nothing
        Knuckle(id="a", px=EMPTY),
        Joined(id="a", px=(EMPTY, at(frame_line(), 0.5))),
        Joined(id="a", px=(at(frame_line(), 0.5), at(frame_line(), 0.52))),  # a line is not joined to itself
        RunTogether(id="a", px=(at(frame_line(), 0.5), EMPTY)),
    ],
    ids=lambda correction: correction.kind,
)
def test_a_correction_of_nothing_is_said_and_changes_nothing(correction: Correction) -> None:
    half = half_of([frame_line()])
    reading = traced(half, 1, correction)
    assert reading.unheeded == ("a",)
    assert np.array_equal(reading.curves[0], traced(half, 1).curves[0])


def test_an_outline_around_nothing_changes_nothing() -> None:
    half = half_of([frame_line()])
    outline = Ignored(id="a", px=((450.0, -50.0), (550.0, -50.0), (500.0, -150.0)))
    less, heeded = correct_ink(half, [placed(outline)])
    assert heeded == set()
    assert less is half
