"""What labels propose, where no text needs to be read: their places, costs and contradictions are made here."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from hullform.picture.image.labels import Label
from hullform.picture.naming.alignment import assign_stations, half_breadths_at
from hullform.picture.naming.label_doubts import doubts_of_labels, doubts_of_sides
from hullform.picture.naming.proposals import LabelledHalf, clear_labels, label_costs, label_half, labels_in_half
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.station_names import StationNames

Array = NDArray[np.float64]
# 0.05 m per px, centre line at u = 500, base line at v = 600; B/2 = 20 m = 400 px
SCALE, HIGH = 0.05, 12.0
PIXELS = np.array([[1 / SCALE, 0.0, 500.0], [0.0, -1 / SCALE, 600.0], [0.0, 0.0, 1.0]])
FRAME = DiagonalFrame(PIXELS, 1, SCALE, 400.0, 500.0)
# upright curves 40 px apart
CURVES = [np.column_stack([np.full(50, y), np.linspace(0.0, 400.0, 50)]) for y in range(40, 400, 40)]
X = tuple(float(x) for x in range(100, 100 - 10 * len(CURVES), -10))
NAMES = tuple(str(n) for n in range(19, 19 - len(CURVES), -1))


def label(text: str, y: float, z: float) -> Label:
    return Label(text, 0.95, (500.0 + y, 600.0 - z), 10.0 * len(text), HIGH)


def half_of(labels: list[Label], names: tuple[str, ...] = NAMES, x: tuple[float, ...] = X) -> LabelledHalf:
    return label_half(labels, FRAME, StationNames("fore", x, names), x)


def at_curves(shift: int = 0) -> list[Label]:
    """The name of every second station just above the end of its curve, or of the next one."""
    return [label(NAMES[n], CURVES[n + shift][-1, 0], 410.0) for n in range(1, len(CURVES) - 1, 2)]


@pytest.mark.parametrize(
    ("text", "y", "z"),
    [
        ("12", 420.0, 150.0),  # the scale of the heights, beside the frame
        ("5", 200.0, -20.0),  # the scale of the half-breadths, under the base line
        ("15", 200.0, 300.0),  # 15 m above the base line
        ("15000", 200.0, 302.0),  # the same in mm
        ("17", -60.0, 410.0),  # in the other half
    ],
)
def test_words_that_are_no_labels_of_this_half(text: str, y: float, z: float) -> None:
    assert labels_in_half([label(text, y, z)], FRAME) == ()


def test_strokes_at_the_ends_of_a_word_are_dropped_and_ranges_name_all_their_stations() -> None:
    labels = half_of([label("|17-", 120.0, 410.0), label("12-14", 320.0, 408.0), label("DWL", 200.0, 200.0)])
    assert [index for index, _ in labels.named] == [2, 5, 6, 7]
    assert [found.text for _, found in labels.named] == ["17", "12-14", "12-14", "12-14"]
    assert clear_labels(labels.named, CURVES) == [(2, 2), (5, 7), (6, 7), (7, 7)]


def test_a_label_costs_nothing_at_its_own_curve_and_less_than_a_mark_elsewhere() -> None:
    costs = label_costs(half_of([label("18", 80.0, 410.0)]).named, CURVES, len(X))
    assert costs is not None
    assert costs[1, 1] == 0
    assert (np.delete(costs[1], 1) > 0).all()
    assert costs.max() < 60.0  # what a curve without a name costs: one label alone pushes no curve out
    assert not np.delete(costs, 1, axis=0).any()
    assert label_costs((), CURVES, len(X)) is None


def test_labels_at_their_curves_raise_no_doubt() -> None:
    assert doubts_of_labels(half_of(at_curves()), CURVES, range(len(X))) == []


def test_labels_that_all_stand_one_curve_farther_are_told() -> None:
    (doubt,) = doubts_of_labels(half_of(at_curves(1)), CURVES, range(len(X)))
    assert doubt.startswith("fore half: the labels 12, 14, 16, 18 stand at other curves")


def test_one_misplaced_label_is_no_doubt() -> None:
    labels = [*at_curves()[1:], label("18", CURVES[3][-1, 0] + 40.0, 410.0)]
    assert doubts_of_labels(half_of(labels), CURVES, range(len(X))) == []


def test_labels_of_which_only_an_end_was_read_are_no_doubt() -> None:
    # '5' stands where '15' does and '4' where '14' does: ends of names that were not read whole
    names = (*NAMES[:7], "5", "4")
    ends = [label("5", CURVES[4][-1, 0], 410.0), label("4", CURVES[5][-1, 0], 410.0)]
    assert doubts_of_labels(half_of(ends, names), CURVES, range(len(X))) == []
    # where '15' and '14' were read elsewhere, they are no ends of them
    whole = [label("15", 220.0, 150.0), label("14", 260.0, 152.0)]
    (doubt,) = doubts_of_labels(half_of([*ends, *whole], names), CURVES, range(len(X)))
    assert "the labels 4, 5 stand at other curves" in doubt


def test_an_end_of_a_listed_number_is_not_missing_from_the_list() -> None:
    names = ("1", "2", "3", "4", "5", "6", "7", "9", "18")
    read = [label("8", 220.0, 300.0)]
    assert doubts_of_labels(half_of([label("1", 40.0, 410.0), *read], names), CURVES, range(len(X))) == []
    (doubt,) = doubts_of_labels(half_of([label("18", 360.0, 410.0), *read], names), CURVES, range(len(X)))
    assert "labelled '8', which fore_station_names does not list" in doubt


def test_a_label_that_no_list_has() -> None:
    names, x = tuple(n for n in NAMES if n != "16"), X[:3] + X[4:]
    labels = half_of(at_curves(), names, x)
    (doubt,) = doubts_of_labels(labels, CURVES, [0, 1, 2, 4, 5, 6, 7, 8])
    assert "labelled '16', which fore_station_names does not list" in doubt
    # outside the half's numbers, or between its steps: a piece of another number
    for text in ("1", "15.5", "20", "DWL"):
        assert doubts_of_labels(half_of([*at_curves(), label(text, 200.0, 100.0)]), CURVES, range(len(X))) == []


def test_labels_of_the_other_half() -> None:
    aft = label_half(at_curves(), FRAME, StationNames("aft", X, tuple(str(n) for n in range(9))), X)
    fore = half_of([label(str(n), 40.0 * n + 40, 410.0) for n in range(9)])
    (doubt,) = doubts_of_sides((aft, fore))
    assert doubt.startswith("aft_side: 13 labels of the drawing are names of stations of the half")
    assert doubts_of_sides((half_of(at_curves()), label_half([], FRAME, StationNames("aft", X), X))) == []


def test_a_station_left_out_of_the_list_shifts_no_name_where_labels_stand_at_the_curves() -> None:
    # eight curves 40 px apart, evenly named; ten stations, of which the last three share the outermost curve. With
    # one left out of the list there are still more names than curves, and even spacing tells nothing of which it was.
    curves = CURVES[:8]
    x = [10.0 * n for n in range(10)]
    left_out = 3
    listed = tuple(v for n, v in enumerate(x) if n != left_out)
    names = tuple(str(n) for n in range(10) if n != left_out)
    rows, certain = half_breadths_at(curves, 400.0), [0.5] * 8
    labels = [label(str(n), curves[n][-1, 0], 410.0) for n in (1, 2, 4, 5, 6)]
    costs = label_costs(half_of(labels, names, listed).named, curves, 9)
    right = [0, 1, 2, 4, 5, 6, 7, 7, 7]
    assert assign_stations(listed, rows, certain) != right
    assert assign_stations(listed, rows, certain, label_cost=costs) == right
