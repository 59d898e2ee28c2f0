"""One half of the body plan: from its ink to finished curves, the innermost first.

What depends on the picture alone is prepared once; tracing is quick and can be done again with other marks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Half
from hullform.corrections import Drawn, Knuckle
from hullform.picture.constraints import constrain
from hullform.picture.dome import find_dome, only_contours
from hullform.picture.finishing import finish, finish_contour
from hullform.picture.flow import MarkInFrame, find_paths
from hullform.picture.frame import DiagonalFrame
from hullform.picture.hand_drawn import course, rank_among, without_ink_of
from hullform.picture.ink import Ink
from hullform.picture.lines import BOLD, HORIZONTAL, VERTICAL, Mask
from hullform.picture.placing import REACH, Placed
from hullform.picture.resampling import evenly
from hullform.picture.ridges import (
    Peaks,
    Tracklet,
    find_peaks,
    find_tracklets,
    line_width,
    usable,
    without_hair_lines,
)
from hullform.picture.sheer import SheerLine, find_sheer
from hullform.picture.side import find_side
from hullform.picture.smoothing import Trace, smooth_traces
from hullform.picture.turning import NOTHING_TURNS, Turning, find_turning
from hullform.picture.turning_edits import without_deleted, without_ink_of_drawn
from hullform.picture.uncrossing import uncrossed
from hullform.picture.winding import Pieces, ends_at_centre

Array = NDArray[np.float64]

SHEER_FLANK_PX = 3.5  # flat ridges so near the sheer line are the sheer line
FLAT_SLOPE = 0.6  # db/da of a ridge within 14 degrees of level
DECK_ZONE = 0.84  # of the depth: without a sheer line found, level ridges above it are taken for the deck
LEVEL_SLOPE = 0.8
CLEAR_OF_DECK = 0.03  # of B/2: a piece that ends so far above a line has passed it
TALLER_THAN_FIGURES = 0.07  # of B/2: twice the height of a station's number
FEWEST_PASSING = 2  # pieces that tell that a line is no deck
NEAR_DEPTH = 0.12  # of the depth: a side drawn so high goes to the depth, by its meaning; lower, the deck is stepped
OUTBOARD = 0.012  # of B/2: beyond the line of B/2, where stations run along it, are figures and lines of the sheet
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
    """

    half: Half
    frame: DiagonalFrame
    curves: tuple[Array, ...]
    confidences: tuple[float, ...]
    sheer: SheerLine | None
    line_width_px: float
    unlisted: int = 0
    loops: tuple[Loop, ...] = ()
    drawn: tuple[tuple[int, float], ...] = ()
    second_contours: tuple[tuple[float, Array], ...] = ()
    unused: tuple[Array, ...] = ()
    unheeded: tuple[str, ...] = ()
    decks_px: tuple[float, ...] = ()


@dataclass(frozen=True, eq=False)
class HalfInk:
    """The ink of one half, ready to be traced.

    Attributes:
        half: which.
        frame: its diagonal frame.
        ink: (rows, columns) of the frame, the long lines of the sheet taken off.
        hidden: where they lay.
        line_width_px: usual thickness of a line; `single_px`: of a ribbon that is one line.
        depth_px: depth at side.
        deck_level_px: height of a level deck line at the depth, or None where none is drawn.
        side_top_px: height to which stations run along the line of B/2, or None where none does.
        side_steps_px: heights at which stations end on it inside the outermost one.
        sheer: the deck edge, or None where none was found.
        peaks: of the ridges that may be curves; `tracklets`: pieces of curve, of the peaks below the deck edge;
            `turning`: pieces that lean back.
    """

    half: Half
    frame: DiagonalFrame
    ink: Ink
    hidden: Mask
    line_width_px: float
    single_px: float
    depth_px: float
    deck_level_px: float | None
    side_top_px: float | None
    side_steps_px: tuple[float, ...]
    sheer: SheerLine | None
    peaks: Peaks
    tracklets: list[Tracklet]
    turning: Turning = NOTHING_TURNS


def prepare_half(
    half: Half, frame: DiagonalFrame, ink: Ink, bare: Ink, mask: Mask, depth_px: float, deck_line: bool
) -> HalfInk:
    """Find the deck edge and the pieces of curve of one half.

    Args:
        half: which.
        frame: its diagonal frame; it is made to reach down to contours below the base line.
        ink: of the picture; bare: the same, its long lines taken off; mask: where they lay.
        depth_px: depth at side.
        deck_line: whether a level line is drawn at the depth.
    """
    here = frame.sample(bare)
    width = line_width(here)
    dome = find_dome(bare, frame)
    if dome.depth_px > 0:
        frame = replace(frame, bottom_px=-dome.depth_px)
        here = only_contours(frame.sample(bare), frame, dome)
    lines = frame.sample_mask(mask)
    hidden = _widened(lines, width)
    side = find_side(ink, frame, width, depth_px)
    side_top = side.top_px
    if side_top is not None and abs(side_top / depth_px - 1) < NEAR_DEPTH:
        side_top = depth_px
    sheer = find_sheer(bare, frame, depth_px, side_top)
    peaks = find_peaks(here, width)
    peaks = peaks.chosen(usable(peaks, lines, hidden, frame))
    if side_top is not None:
        y, _ = frame.to_drawing(peaks.column.astype(np.float64), peaks.row)
        peaks = peaks.chosen(y < frame.half_breadth_px + max(OUTBOARD * frame.half_breadth_px, 2 * width))
    level = depth_px if deck_line else None
    prepared = HalfInk(
        half, frame, here, hidden, width, width, depth_px, level, side_top, side.steps_px, sheer, peaks, []
    )
    if level is not None and _passed(prepared):
        prepared = replace(prepared, deck_level_px=None)
    tracklets = pieces_of_curve(prepared)
    single = float(np.percentile(np.concatenate([t.width for t in tracklets]), 35)) if tracklets else width
    prepared = replace(prepared, single_px=single, tracklets=tracklets)
    return replace(prepared, turning=_pieces_that_turn(prepared))


def _passed(prepared: HalfInk) -> bool:
    """Whether stations go on above the level line at the depth, which is then a waterline."""
    size, passing = prepared.frame.half_breadth_px, 0
    for piece in pieces_of_curve(replace(prepared, deck_level_px=None)):
        _, z = prepared.frame.to_drawing(piece.column.astype(np.float64), piece.row)
        passing += bool(z[-1] > prepared.depth_px + CLEAR_OF_DECK * size and np.ptp(z) > TALLER_THAN_FIGURES * size)
    return passing >= FEWEST_PASSING


def pieces_of_curve(prepared: HalfInk, flank_px: float | None = None) -> list[Tracklet]:
    """The tracklets of a half below its deck edge.

    Args:
        prepared: the half; its tracklets are not looked at.
        flank_px: how near the deck edge flat ridges are the deck edge.
    """
    peaks, sheer, depth_px = prepared.peaks, prepared.sheer, prepared.depth_px
    y, z = prepared.frame.to_drawing(peaks.column.astype(np.float64), peaks.row)
    if sheer is not None:
        flank = SHEER_FLANK_PX if flank_px is None else flank_px
        deck = sheer.at(y)
        on_deck = (np.abs(z - deck) < flank) & (peaks.slope > FLAT_SLOPE)
        above = z > deck + flank
    else:
        on_deck = (z > DECK_ZONE * depth_px) & (peaks.slope > LEVEL_SLOPE)
        above = z > (1.01 if prepared.deck_level_px is not None else 1.6) * depth_px
    return without_hair_lines(find_tracklets(peaks.chosen(~(on_deck | above))), prepared.line_width_px)


def _pieces_that_turn(prepared: HalfInk) -> Turning:
    sheer, depth_px = prepared.sheer, prepared.depth_px

    def ceiling(half_breadth: Array) -> Array:
        if sheer is not None:
            return sheer.at(half_breadth) - SHEER_FLANK_PX
        return np.full(np.shape(half_breadth), DECK_ZONE * depth_px)

    return find_turning(
        prepared.ink, prepared.hidden, prepared.tracklets, prepared.frame, prepared.line_width_px, depth_px, ceiling
    )


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
    side_top, width, size = prepared.side_top_px, prepared.line_width_px, prepared.frame.half_breadth_px
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
        finished = finish(trace, frame, here, prepared.hidden, sheer, level, side_top, own_steps)
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
        width,
        max(0, unlisted - len(loops)),
        loops,
        tuple(drawn),
        second,
        unused,
        tuple(unheeded),
        tuple(z for z in (level, side_top, *prepared.side_steps_px) if z is not None),
    )


def _widened(mask: Mask, width_px: float) -> Mask:
    """The mask, each kind of line wider by half a line: a curve that touches a line is lost in it."""
    kernel = np.ones((2 * round(width_px / 2) + 3,) * 2, np.uint8)
    vertical, horizontal, bold = (
        np.asarray(cv2.dilate(mask & bit, kernel), dtype=np.uint8) for bit in (VERTICAL, HORIZONTAL, BOLD)
    )
    return vertical | horizontal | bold


def _confidence(trace: Trace) -> float:
    """Share of the curve that was seen, less for what it shared, less for ends that hang in the air."""
    alone = 0.5 + 0.5 * min(1.0, trace.own / 0.5)
    seen = min(1.0, trace.visible / HIDDEN_BY_GRID)
    return float(np.clip(seen * alone * np.exp(-max(trace.end_cost, 0.0) / 200.0), 0.0, 1.0))
