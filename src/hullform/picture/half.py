"""One half of the body plan: from its ink to finished curves, the innermost first.

What depends on the picture alone is prepared once; tracing is quick and can be done again with other marks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Half
from hullform.picture.finishing import finish
from hullform.picture.flow import MarkInFrame, Path, find_paths
from hullform.picture.frame import DiagonalFrame
from hullform.picture.ink import Ink
from hullform.picture.lines import HORIZONTAL, VERTICAL, Mask
from hullform.picture.ridges import Tracklet, find_peaks, find_tracklets, line_width, usable, without_hair_lines
from hullform.picture.sheer import SheerLine, find_sheer
from hullform.picture.side import find_side
from hullform.picture.smoothing import Trace, smooth_traces
from hullform.picture.uncrossing import uncrossed

Array = NDArray[np.float64]

SHEER_FLANK_PX = 3.5  # flat ridges so near the sheer line are the sheer line
FLAT_SLOPE = 0.6  # db/da of a ridge within 14 degrees of level
DECK_ZONE = 0.84  # of the depth: without a sheer line found, level ridges above it are taken for the deck
LEVEL_SLOPE = 0.8
NEAR_DEPTH = 0.12  # of the depth: a side drawn so high goes to the depth, by its meaning; lower, the deck is stepped
POINT_SPACING_PX = 2.0  # along a traced curve
HIDDEN_BY_GRID = 0.7  # share of a curve that can be seen through a close grid: more missing counts against it


@dataclass(frozen=True, eq=False)
class HalfReading:
    """The curves of one half, from the centre line outwards.

    Attributes:
        curves: (n, 2) [y, z] of each, px of the drawing, keel to deck.
        confidences: 0..1 of each.
        sheer: the deck edge, or None where none was found.
        unlisted: by how many the curves are more than the stations that are listed.
        decks_px: heights of level decks and of the side's top, px above the base line.
        unread_px: [y, z] of the middle and length of each piece that no curve took, px of the drawing.
    """

    half: Half
    frame: DiagonalFrame
    curves: tuple[Array, ...]
    confidences: tuple[float, ...]
    sheer: SheerLine | None
    line_width_px: float
    unlisted: int = 0
    decks_px: tuple[float, ...] = ()
    unread_px: tuple[tuple[float, float, float], ...] = ()


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
        tracklets: pieces of curve.
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
    tracklets: list[Tracklet]


def prepare_half(
    half: Half, frame: DiagonalFrame, ink: Ink, bare: Ink, mask: Mask, depth_px: float, deck_line: bool
) -> HalfInk:
    """Find the deck edge and the pieces of curve of one half.

    Args:
        half: which.
        frame: its diagonal frame.
        ink: of the picture; bare: the same, its long lines taken off; mask: where they lay.
        depth_px: depth at side.
        deck_line: whether a level line is drawn at the depth.
    """
    here = frame.sample(bare)
    width = line_width(here)
    hidden = _widened(frame.sample_mask(mask), width)
    side = find_side(ink, frame, width)
    side_top = side.top_px
    if side_top is not None and abs(side_top / depth_px - 1) < NEAR_DEPTH:
        side_top = depth_px
    sheer = find_sheer(bare, frame, depth_px, side_top)
    peaks = find_peaks(here, width)
    peaks = peaks.chosen(usable(peaks, hidden, frame))
    y, z = frame.to_drawing(peaks.column.astype(np.float64), peaks.row)
    if sheer is not None:
        deck = sheer.at(y)
        on_deck = (np.abs(z - deck) < SHEER_FLANK_PX) & (peaks.slope > FLAT_SLOPE)
        above = z > deck + SHEER_FLANK_PX
    else:
        on_deck = (z > DECK_ZONE * depth_px) & (peaks.slope > LEVEL_SLOPE)
        above = z > (1.01 if deck_line else 1.6) * depth_px
    tracklets = without_hair_lines(find_tracklets(peaks.chosen(~(on_deck | above))), width)
    single = float(np.percentile(np.concatenate([t.width for t in tracklets]), 35)) if tracklets else width
    level = depth_px if deck_line else None
    return HalfInk(half, frame, here, hidden, width, single, depth_px, level, side_top, side.steps_px, sheer, tracklets)


def trace_half(prepared: HalfInk, most: int, marks: Sequence[tuple[int, float, float]] = ()) -> HalfReading:
    """Trace the curves of one half.

    Args:
        prepared: its ink.
        most: number of stations of the half.
        marks: station, and (y, z) in px of the drawing, of the user's marks.
    """
    here, frame, sheer, tracklets = prepared.ink, prepared.frame, prepared.sheer, prepared.tracklets
    side_top, width = prepared.side_top_px, prepared.line_width_px
    if not tracklets:
        return HalfReading(prepared.half, frame, (), (), sheer, width)
    ends = np.array([(t.column[-1], t.row[-1]) for t in tracklets], dtype=np.float64)
    end_y, _ = frame.to_drawing(ends[:, 0], ends[:, 1])
    top = sheer.at(end_y) if sheer is not None else np.full(len(tracklets), prepared.depth_px)
    seeds = [MarkInFrame(n, *(float(value) for value in frame.from_drawing(y, z))) for n, y, z in marks]
    paths, unlisted = find_paths(
        tracklets, here, prepared.hidden, frame, prepared.single_px, top, most, seeds, side_top
    )
    paths = uncrossed(paths, tracklets, prepared.single_px)
    traces = smooth_traces(paths, tracklets, prepared.single_px, frame)
    level = prepared.deck_level_px
    steps = [*prepared.side_steps_px] if side_top is not None else []
    finished = []
    for number, trace in enumerate(traces):
        # where the side thins, stations end; what goes on is the outermost
        own_steps = steps if number < len(traces) - 1 else []
        finished.append(finish(trace, frame, here, prepared.hidden, sheer, level, side_top, own_steps))
    curves = tuple(_evenly(np.column_stack(curve)) for curve in finished)
    confidences = tuple(_confidence(trace) for trace in traces)
    decks = tuple(z for z in (level, side_top, *prepared.side_steps_px) if z is not None)
    unread = _unread(paths, tracklets, frame)
    return HalfReading(prepared.half, frame, curves, confidences, sheer, width, unlisted, decks, unread)


def _widened(mask: Mask, width_px: float) -> Mask:
    """The mask, each family wider by half a line: a curve that touches a line is lost in it."""
    kernel = np.ones((2 * round(width_px / 2) + 3,) * 2, np.uint8)
    vertical = np.asarray(cv2.dilate(mask & VERTICAL, kernel), dtype=np.uint8)
    horizontal = np.asarray(cv2.dilate(mask & HORIZONTAL, kernel), dtype=np.uint8)
    return vertical | horizontal


def _confidence(trace: Trace) -> float:
    """Share of the curve that was seen, less for what it shared, less for ends that hang in the air."""
    alone = 0.5 + 0.5 * min(1.0, trace.own / 0.5)
    seen = min(1.0, trace.visible / HIDDEN_BY_GRID)
    return float(np.clip(seen * alone * np.exp(-max(trace.end_cost, 0.0) / 200.0), 0.0, 1.0))


def _unread(
    paths: Sequence[Path], tracklets: Sequence[Tracklet], frame: DiagonalFrame
) -> tuple[tuple[float, float, float], ...]:
    """The middle and the length of every piece that no path runs along, px of the drawing."""
    used = {piece for path in paths for piece in path.tracklets}
    out = []
    for number, piece in enumerate(tracklets):
        if number not in used:
            y, z = frame.to_drawing(piece.column.astype(np.float64), piece.row)
            middle = len(y) // 2
            out.append((float(y[middle]), float(z[middle]), float(np.hypot(np.diff(y), np.diff(z)).sum())))
    return tuple(out)


def _evenly(points: Array) -> Array:
    """The curve at even steps of arc length, its ends kept."""
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    keep = np.concatenate([[True], np.diff(arc) > 1e-9])
    at = np.linspace(0.0, arc[-1], max(3, round(arc[-1] / POINT_SPACING_PX) + 1))
    return np.column_stack([np.interp(at, arc[keep], points[keep, k]) for k in (0, 1)])
