"""One half of the body plan: from its ink to finished curves, the innermost first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Half
from hullform.corrections import Drawn, Knuckle
from hullform.picture.edits.constraints import constrain
from hullform.picture.edits.hand_drawn import course, rank_among, without_ink_of
from hullform.picture.edits.placing import REACH, Placed
from hullform.picture.edits.turning_edits import without_deleted, without_ink_of_drawn
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.half_ink import HalfInk
from hullform.picture.pieces.sheer import SheerLine
from hullform.picture.tracing.finishing import finish, finish_contour
from hullform.picture.tracing.flow import MarkInFrame, find_paths
from hullform.picture.tracing.resampling import evenly
from hullform.picture.tracing.smoothing import Trace, smooth_traces
from hullform.picture.tracing.uncrossing import uncrossed
from hullform.picture.tracing.winding import Pieces, ends_at_centre

Array = NDArray[np.float64]

SHORTEST_UNUSED_PX = 12  # of a line that is shown as one that no curve took
HIDDEN_BY_GRID = 0.7  # share of a curve that can be seen through a close grid: more missing counts against it


@dataclass(frozen=True, eq=False)
class Loop:
    """A contour that comes back to the centre line: (n, 2) [y, z], px of the drawing, and the confidence 0..1 in it."""

    points: Array
    confidence: float


@dataclass(frozen=True, eq=False)
class HalfReading:
    """The curves of one half, from the centre line outwards.

    Attributes:
        curves: (n, 2) [y, z] of each, px of the drawing, keel to deck.
        confidences: 0..1 of each.
        sheer: the deck edge, or None where none was found.
        unlisted: by how many the curves are more than the stations that are listed.
        loops: contours that come back to the centre line, from the innermost outwards.
        drawn: which of the curves were drawn by hand, and the station of each, m.
        second_contours: station, m, and points as in `curves` of second contours drawn by hand.
        unused: (n, 2) [y, z] of lines that no curve took.
        unheeded: ids of the corrections that changed nothing.
        decks_px: heights of level decks and of the side's top, px above the base line.
        line_px: thickness of a line.
    """

    half: Half
    frame: DiagonalFrame
    curves: tuple[Array, ...]
    confidences: tuple[float, ...]
    sheer: SheerLine | None
    unlisted: int = 0
    loops: tuple[Loop, ...] = ()
    drawn: tuple[tuple[int, float], ...] = ()
    second_contours: tuple[tuple[float, Array], ...] = ()
    unused: tuple[Array, ...] = ()
    unheeded: tuple[str, ...] = ()
    decks_px: tuple[float, ...] = ()
    line_px: float = 0.0


def trace_half(
    prepared: HalfInk,
    most: int,
    marks: Sequence[tuple[int, float, float]] = (),
    placed: Sequence[Placed] = (),
) -> HalfReading:
    """Trace the curves of one half.

    Args:
        prepared: its ink.
        most: number of stations of the half.
        marks: station, and (y, z) in px of the drawing, of the user's marks.
        placed: the user's corrections.
    """
    here, frame, sheer, tracklets = prepared.ink, prepared.frame, prepared.sheer, prepared.tracklets
    side_top, size = prepared.side_top_px, prepared.frame.half_breadth_px
    turning, placed = without_deleted(prepared.turning, tracklets, placed, size)
    by_hand = {}
    for item in placed:
        if isinstance(item.correction, Drawn):
            curve = course(item.yz, item.correction.smooth, size)
            by_hand[item.correction.curve, item.correction.station_m] = curve
            tracklets = without_ink_of(curve, tracklets, frame, prepared.single_px)
            turning = without_ink_of_drawn(turning, curve, frame)
    tracklets, constraints, unheeded = constrain(tracklets, placed, size)
    whole = sorted((station, curve) for (number, station), curve in by_hand.items() if number == 0)
    ends = np.array([(t.column[-1], t.row[-1]) for t in tracklets], dtype=np.float64).reshape(-1, 2)
    end_y, _ = frame.to_drawing(ends[:, 0], ends[:, 1])
    top = sheer.at(end_y) if sheer is not None else np.full(len(tracklets), prepared.depth_px)
    seeds = [MarkInFrame(n, *(float(value) for value in frame.from_drawing(y, z))) for n, y, z in marks]
    paths, unlisted = find_paths(
        tracklets,
        here,
        prepared.hidden,
        frame,
        prepared.single_px,
        top,
        most - len(whole),
        seeds,
        side_top,
        constraints,
        turning,
    )
    paths = uncrossed(paths, tracklets, prepared.single_px, constraints.made)
    knuckles = [item for item in placed if isinstance(item.correction, Knuckle)]
    pieces = Pieces(tracklets, turning)
    every = smooth_traces(paths, pieces, prepared.single_px, frame, [tuple(item.at[0]) for item in knuckles])
    closed = [t.winds and ends_at_centre(frame.to_drawing(t.column, t.row)[0], size) for t in every]
    traces = [trace for trace, loop in zip(every, closed, strict=True) if not loop]
    loops = tuple(
        Loop(evenly(np.column_stack(finish_contour(trace, frame))), _confidence(trace))
        for trace, loop in zip(every, closed, strict=True)
        if loop
    )
    corners = [np.array(trace.corners).reshape(-1, 2) for trace in traces]
    unheeded += [
        item.correction.id
        for item in knuckles
        if not any((np.hypot(*(at - item.at[0]).T) < 2 * REACH * size).any() for at in corners)
    ]
    level = prepared.deck_level_px
    steps = prepared.side_steps_px if side_top is not None else ()
    curves = []
    for number, (trace, at) in enumerate(zip(traces, corners, strict=True)):
        # where the side thins, stations end; what goes on is the outermost
        own_steps = steps if number < len(traces) - 1 else ()
        finished = finish(trace, frame, here, prepared.hidden, sheer, level, side_top, own_steps, prepared.single_px)
        curves.append(evenly(np.column_stack(finished), np.column_stack(frame.to_drawing(at[:, 0], at[:, 1]))))
    confidences = [_confidence(trace) for trace in traces]
    # from the centre line outwards, as the half shows its stations
    drawn: list[tuple[int, float]] = []
    for station, curve in whole if prepared.half == "aft" else whole[::-1]:
        rank = max(rank_among(curve, curves, frame), drawn[-1][0] + 1 if drawn else 0)
        curves.insert(rank, evenly(curve))
        confidences.insert(rank, 1.0)
        drawn.append((rank, station))
    unused = tuple(
        np.column_stack(frame.to_drawing(*line)) for line in pieces.unused(paths) if len(line[0]) >= SHORTEST_UNUSED_PX
    )
    second = tuple((station, evenly(curve)) for (number, station), curve in by_hand.items() if number == 1)
    return HalfReading(
        prepared.half,
        frame,
        tuple(curves),
        tuple(confidences),
        sheer,
        max(0, unlisted - len(loops)),
        loops,
        tuple(drawn),
        second,
        unused,
        tuple(unheeded),
        tuple(z for z in (level, side_top, *prepared.side_steps_px) if z is not None),
        prepared.single_px,
    )


def _confidence(trace: Trace) -> float:
    """Share of the curve that was seen, less for what it shared, less for ends that hang in the air."""
    alone = 0.5 + 0.5 * min(1.0, trace.own / 0.5)
    seen = min(1.0, trace.visible / HIDDEN_BY_GRID)
    return float(np.clip(seen * alone * np.exp(-max(trace.end_cost, 0.0) / 200.0), 0.0, 1.0))
