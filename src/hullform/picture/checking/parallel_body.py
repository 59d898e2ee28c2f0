"""Stations that share the outermost curve: what must hold where they are a parallel body and no fault of a list."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.picture.naming.alignment import NO_CURVE
from hullform.picture.naming.crossings import along_frame
from hullform.picture.naming.named_half import NamedHalf
from hullform.ship_body_plan import SAME_STATION_M

Array = NDArray[np.float64]

LONGEST_PARALLEL_BODY = 0.5  # of LPP: full tankers share one drawn curve over 0.45
MOST_UNDRAWN = 0.5  # of a half's stations: half a parallel body of that length, at the spacing of midships
FULLEST = 0.994  # of B/2: what a curve of the parallel body reaches
SAME_BODY = 0.015  # between the areas of the two halves' curves of the parallel body
MOST_MOVE = 0.003  # of B/2, mean: run-outs into parallel bodies come to 0.0012, lists at fault to 0.0034 and more
COMPARED = 60  # places along the curves


def doubts_of_parallel_body(halves: Sequence[NamedHalf], length_between_perpendiculars_m: float) -> list[str]:
    """Stations that share the outermost curve although they can hardly be a parallel body.

    A list with one station too many looks like a parallel body, too: the names shift until the last two share a curve.
    """
    doubts = []
    sharing = [half for half in halves if half.shared]
    for half in sharing:
        name, curves, listed = half.reading.half, len(set(half.assigned) - {NO_CURVE}), len(half.inner_first)
        words = half.names.several(half.shared)
        reach = float(half.reading.curves[-1][:, 0].max()) / half.reading.frame.half_breadth_px
        if listed - curves > MOST_UNDRAWN * listed:
            doubts.append(
                f"{name} half: {curves} curves for {listed} stations, so that {words} would share the outermost; "
                f"check {name}_stations_m and aft_side"
            )
        elif reach < FULLEST:
            doubts.append(
                f"{name} half: {curves} curves for {listed} stations, but the outermost, which {words} would share, "
                f"reaches only {100 * reach:.1f} % of B/2 and is no parallel body; check {name}_stations_m"
            )
        elif not _said(half) and (move := _next_move(half)) > _most_move(half):
            doubts.append(
                f"{name} half: {words} share the outermost curve, but the sections still change where it begins: as "
                f"the curves inside of it go on, the next would lie {100 * move:.1f} % of B/2 beside it on average; "
                f"check that {name}_stations_m lists no station too many, or mark a point of each of these stations"
            )
    shared = [x for half in sharing for x in half.shared]
    share = (max(shared) - min(shared)) / length_between_perpendiculars_m if shared else 0.0
    if share > LONGEST_PARALLEL_BODY:
        doubts.append(
            f"parallel body: the stations from {min(shared):g} to {max(shared):g} m, {100 * share:.0f} % of LPP, share "
            "the outermost curves; check aft_stations_m and fore_stations_m"
        )
    if len(sharing) == 2:
        areas = [_area(half.reading.curves[-1]) for half in sharing]
        if abs(areas[0] / areas[1] - 1) > SAME_BODY:
            doubts.append(
                f"parallel body: the outermost curves of the two halves enclose areas "
                f"{100 * areas[0] / areas[1]:.1f} : 100 and are not one section; check aft_stations_m, fore_stations_m"
            )
    return doubts


def _most_move(half: NamedHalf) -> float:
    """How far beside the shared curve the next section may lie.

    One station too many makes two share a curve. Three and more are a parallel body of a list that is wrong by more
    than one, or of the ship, whose sections within a line's thickness are drawn as one line.
    """
    reading = half.reading
    return max(MOST_MOVE, reading.line_px / reading.frame.half_breadth_px if len(half.shared) > 2 else 0.0)


def _said(half: NamedHalf) -> bool:
    """Whether a person marked each of the sharing stations on the curve."""
    marked = [mark.station_m for mark in half.used_marks]
    return all(any(abs(x - station) <= SAME_STATION_M for station in marked) for x in half.shared)


def _next_move(half: NamedHalf) -> float:
    """How far beside the shared curve the second of its stations would lie, in parts of B/2; 0 where it may be one.

    The change of the sections along the ship is taken on from the two curves inside of the shared one: into a parallel
    body it runs out. Distances are across the diagonal frame, which sees bottom and side alike.
    """
    inside = [(x, n) for x, n in zip(half.inner_first, half.assigned, strict=True) if n != NO_CURVE]
    inside = [(x, n) for x, n in inside if x not in half.shared]
    if len(inside) < 2:
        return 0.0
    (before_x, before), (beside_x, beside) = inside[-2:]
    first, second = [x for x in half.inner_first if x in half.shared][:2]
    frame = half.reading.frame
    lines = [along_frame(half.reading.curves[n], frame) for n in (before, beside, len(half.reading.curves) - 1)]
    start, stop = max(column[0] for column, _ in lines), min(column[-1] for column, _ in lines)
    if stop - start < COMPARED:
        return 0.0
    columns = np.linspace(start, stop, COMPARED)
    rows = [np.interp(columns, column, row) for column, row in lines]
    steps = [abs(beside_x - before_x), abs(first - beside_x), abs(second - first)]
    if min(steps) <= 0:
        return 0.0
    former, last = (rows[1] - rows[0]) / steps[0], (rows[2] - rows[1]) / steps[1]
    # rates belong to the middles of their steps
    ahead = (steps[1] + steps[2]) / (steps[0] + steps[1])
    going_on = np.maximum(np.sign(last) * (last + ahead * (last - former)), 0.0)
    return float(going_on.mean() * steps[2] / np.sqrt(2.0) / frame.half_breadth_px)


def _area(curve: Array) -> float:
    return float(np.trapezoid(curve[:, 0], curve[:, 1]))
