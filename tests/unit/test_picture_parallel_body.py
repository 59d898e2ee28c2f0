"""Stations share the outermost curve only where the change of the sections along the ship runs out."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import cast

import numpy as np
import pytest

from hullform.picture.checking.doubts import doubts_of_the_whole
from hullform.picture.checking.parallel_body import doubts_of_parallel_body
from hullform.picture.naming.named_half import NamedHalf
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.tracing.half import HalfReading
from hullform.ship_body_plan import Mark
from hullform.station_names import StationNames

SIZE = 500.0  # B/2, px
FRAME = DiagonalFrame(np.diag([1.0, -1.0, 1.0]), 1, 1.0, SIZE, 450.0)
X = tuple(10.0 * n for n in range(10))


@dataclass(frozen=True)
class Half:
    """What the checks ask of a half with its names."""

    reading: HalfReading
    inner_first: tuple[float, ...]
    assigned: tuple[int, ...]
    names: StationNames
    used_marks: set[Mark] = field(default_factory=set)
    shared: tuple[float, ...] = ()


def half_of(inside: list[float], marked: tuple[float, ...] = (), line_px: float = 0.0) -> NamedHalf:
    """Upright walls that lie so far inside of B/2, px, from the centre line outwards; the last has all other names."""
    curves = tuple(np.column_stack([np.full(300, SIZE - d), np.linspace(0.0, 400.0, 300)]) for d in inside)
    reading = HalfReading("aft", FRAME, curves, (1.0,) * len(curves), None, line_px=line_px)
    assigned = tuple(min(n, len(curves) - 1) for n in range(len(X)))
    marks = {Mark(station_m=x, half="aft", px=(1.0, 1.0)) for x in marked}
    half = Half(reading, X, assigned, StationNames("aft", X), marks, X[len(curves) - 1 :])
    return cast(NamedHalf, half)


def test_sections_that_run_out_into_the_parallel_body_are_believed() -> None:
    # a parabola whose end is where the first of the sharing stations lies
    assert doubts_of_parallel_body([half_of([0.5 * n**2 for n in range(7, -1, -1)])], 300.0) == []


@pytest.mark.parametrize("step", [4.0, 10.0])
def test_sections_that_go_on_changing_share_no_curve(step: float) -> None:
    # equal steps: the next would be one more of them
    (doubt,) = doubts_of_parallel_body([half_of([step * n for n in range(7, -1, -1)])], 300.0)
    assert doubt.startswith("aft half: 70, 80, 90 m share the outermost curve, but the sections still change")
    assert f"{100 * step / SIZE:.1f} % of B/2" in doubt


@pytest.mark.parametrize(("step", "doubts"), [(1.4, 0), (1.6, 1)])
def test_three_per_mille_of_the_half_breadth_are_what_tracing_leaves(step: float, doubts: int) -> None:
    # 2 r2 - 3 r1 + r0 of three curves has sqrt(14) times the error of one: twice that for curves good to 0.04 % of B/2
    assert len(doubts_of_parallel_body([half_of([step * n for n in range(7, -1, -1)])], 300.0)) == doubts


@pytest.mark.parametrize(("line_px", "doubts"), [(3.0, 1), (5.0, 0)])
def test_sections_within_a_line_of_each_other_are_drawn_as_one(line_px: float, doubts: int) -> None:
    steps = [4.0 * n for n in range(7, -1, -1)]
    assert len(doubts_of_parallel_body([half_of(steps, line_px=line_px)], 300.0)) == doubts


@pytest.mark.parametrize(("curves", "words"), [(5, ""), (4, "aft half: 4 curves for 10 stations")])
def test_most_of_a_half_is_no_parallel_body(curves: int, words: str) -> None:
    found = doubts_of_parallel_body([half_of([0.5 * n**2 for n in range(curves - 1, -1, -1)])], 300.0)
    assert "".join(found)[: len(words) or None] == words


def test_a_person_who_marked_each_of_them_is_believed() -> None:
    steps = [10.0 * n for n in range(7, -1, -1)]
    assert doubts_of_parallel_body([half_of(steps, X[7:])], 300.0) == []
    assert doubts_of_parallel_body([half_of(steps, X[8:])], 300.0) != []


def test_many_doubts_have_one_cause_that_is_told_first() -> None:
    assert doubts_of_the_whole(5, 10) == doubts_of_the_whole(7, 27) == []
    (told,) = doubts_of_the_whole(9, 27)
    assert told.startswith("9 doubts for 27 stations: look first whether")
    assert "turned by 90 degrees" in told
