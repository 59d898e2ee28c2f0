"""The ends of a traced curve: its lower end, and up to the sheer line, the deck line or the top of the side."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.line_mask import VERTICAL, Mask
from hullform.picture.image.ink import Ink
from hullform.picture.pieces.ends import CLOSE_TO_SIDE
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.sheer import SheerLine
from hullform.picture.tracing.lower_end import FARTHEST, NEAR_AXIS, STRETCH, along_level_line, lower_end
from hullform.picture.tracing.smoothing import WEIGHT_OF_SHARED, Trace
from hullform.picture.tracing.winding import closed

Array = NDArray[np.float64]
Deck = Callable[[Array | float], Array]

NEAR_DECK = 0.09  # of B/2: a top within this of the sheer line belongs on it
AT_DECK = 0.03  # of B/2: ink that ends so near the deck goes to the deck
AT_SIDE = 0.965  # of B/2
LEVEL = 0.35  # dz/ds below which a curve runs along a deck rather than up to it
STEEP_BEFORE = 0.6  # dz/ds of a curve that has met a deck edge
LONGEST_TAIL = 0.12  # of B/2: of a deck edge that a curve was led along
AT_LINE = 0.012  # of B/2: a curve that ends so near the line of B/2 has met it, at whatever angle
TAIL = 0.012  # of B/2: the stretch that shows whether a curve close to the side has begun to turn up
BEGUN = 0.33  # dz/dy there
STEEP_ENOUGH = 0.7  # dz/dy of a curve that is about to join the line of B/2
OFF_SHEER_PX = 2.0  # where the sheer line is known no better, the end of a curve's own ink says where it is
LONGEST_STROKE = 0.06  # of B/2: how far ahead of a trace its ink is followed
COVER_PX = 14  # ahead of an end: a line of the drawing must lie there, if the curve is to go on unseen
LARGEST_BREAK_PX = 4  # in a stroke, where a line of the drawing was taken off


def finish(
    trace: Trace,
    frame: DiagonalFrame,
    ink: Ink,
    hidden: Mask,
    sheer: SheerLine | None,
    depth_px: float | None,
    side_top_px: float | None = None,
    side_steps_px: Sequence[float] = (),
    width_px: float = 0.0,
) -> tuple[Array, Array]:
    """(y, z) of the whole curve in px of the drawing, from keel to deck.

    Args:
        trace: the curve on the columns of the frame.
        frame: of its half.
        ink, hidden: (rows, columns) of the frame, and where lines of the drawing were taken off.
        sheer: of its half, or None.
        depth_px: height of a level deck line, or None where none is drawn.
        side_top_px: height to which the line of B/2 is drawn, for curves that join it, or None.
        side_steps_px: heights at which curves like this one end on that line, ascending.
        width_px: thickness of a curve's line.
    """
    column, row = _visible_part(trace, frame)
    y, z = frame.to_drawing(column, row)
    size = frame.half_breadth_px
    if side_top_px is not None:
        side_top_px = _own_top(y, z, size, side_top_px, side_steps_px)
    y, z = lower_end(y, z, frame, ink, width_px)
    y, z = along_level_line(y, z, trace, hidden, size)
    y, z = _without_level_tail(y, z, size)
    deck_over, reaches = _deck_over(trace, frame, ink, sheer, depth_px)
    y, z = _upper_end(y, z, size, deck_over, reaches, _covered(trace, hidden), side_top_px)
    if side_top_px is None:
        return y, z
    if sheer is None and depth_px is None:
        y, z = _along_own_ink(y, z, _end_of_ink(trace, frame, ink), size, side_top_px)
    deck = depth_px if sheer is None else float(sheer.at(size))
    return _up_the_side(y, z, size, min(side_top_px, np.inf if deck is None else deck))


def _own_top(y: Array, z: Array, size: float, top: float, steps: Sequence[float]) -> float:
    """Where a curve ends that joins the line of B/2: at the first step above the place."""
    joined = z[y > (1 - AT_LINE) * size]
    height = float(joined[0]) if joined.size else float(z[-1])
    return next((step for step in steps if step > height), top)


def finish_contour(trace: Trace, frame: DiagonalFrame) -> tuple[Array, Array]:
    """(y, z) of a contour that comes back to the centre line, in px of the drawing, from its lower end."""
    y, z = lower_end(*frame.to_drawing(trace.column, trace.row), frame)
    return closed(y, z, frame.half_breadth_px)


def _visible_part(trace: Trace, frame: DiagonalFrame) -> tuple[Array, Array]:
    """Cut a merged ribbon off the foot where the curve stands alone close to the axis: continuing it is better."""
    alone = np.flatnonzero(trace.weight > WEIGHT_OF_SHARED)
    if alone.size >= 40:
        y, z = frame.to_drawing(trace.column[alone[0]], trace.row[alone[0]])
        if min(float(y), float(z)) < NEAR_AXIS / 2 * frame.half_breadth_px:
            return trace.column[alone[0] :], trace.row[alone[0] :]
    return trace.column, trace.row


def _deck_over(
    trace: Trace, frame: DiagonalFrame, ink: Ink, sheer: SheerLine | None, depth_px: float | None
) -> tuple[Deck, bool]:
    """Height of the deck over a half-breadth: the sheer line, held to where the curve's own ink ends near it.

    Returns:
        that height, and whether the curve's ink reaches it.
    """

    def drawn(half_breadth: Array | float) -> Array:
        if sheer is not None:
            return sheer.at(half_breadth)
        return np.full(np.shape(half_breadth), depth_px if depth_px is not None else np.inf)

    end_y, end_z = _end_of_ink(trace, frame, ink)
    if sheer is not None and sheer.lost_at(end_y):
        return (lambda half_breadth: np.full(np.shape(half_breadth), end_z)), True
    reaches = bool(float(drawn(end_y)) - end_z < AT_DECK * frame.half_breadth_px)
    if sheer is None or abs(end_z - float(drawn(end_y))) > NEAR_DECK * frame.half_breadth_px:
        return drawn, reaches
    # the line rises or falls steadily between the places where it was seen alone
    lowest, highest = sheer.range_at(end_y)
    if highest - lowest < 2 * OFF_SHEER_PX:
        return drawn, reaches
    height = float(np.clip(end_z, lowest, highest))
    return (lambda half_breadth: np.full(np.shape(half_breadth), height)), reaches


def _end_of_ink(trace: Trace, frame: DiagonalFrame, ink: Ink) -> tuple[float, float]:
    """(y, z) in px of the drawing where the stroke that a trace follows ends."""
    size = min(len(trace.column), 30)
    slope = float(np.polyfit(np.arange(min(size, 12)), trace.row[-min(size, 12) :], 1)[0])
    beyond = np.arange(1, LONGEST_STROKE * frame.half_breadth_px)
    column = np.concatenate([trace.column[-size:], trace.column[-1] + beyond])
    row = np.concatenate([trace.row[-size:], trace.row[-1] + slope * beyond])
    at = np.clip(np.round(column), 0, ink.shape[1] - 1).astype(np.int64)
    rows = np.clip(np.round(row)[:, None] + np.arange(-1, 2), 0, ink.shape[0] - 1).astype(np.int64)
    value = ink[rows, at[:, None]].max(axis=1)
    dark = np.flatnonzero(value >= 0.6 * float(np.median(value[:size])))
    run = dark[: int(np.argmax(np.diff(dark, append=10_000) > LARGEST_BREAK_PX)) + 1] if dark.size else dark
    last = int(run[-1]) if run.size else size - 1
    y, z = frame.to_drawing(column[last], row[last])
    return float(y), float(z)


def _along_own_ink(y: Array, z: Array, end: tuple[float, float], size: float, top: float) -> tuple[Array, Array]:
    """A curve goes on to where its ink ends, where no deck edge is drawn but the side shows how high that may be.

    Figures that stand on a curve hide its axis, not its ink.

    Args:
        end: [y, z] of its ink.
        top: of the side.
    """
    end_y, end_z = end
    if not z[-1] < end_z < top + AT_DECK * size or end_y > (1 - AT_LINE) * size:
        return y, z
    height = min(end_z, top)
    if height <= z[-1]:
        return y, z
    share = (height - z[-1]) / (end_z - z[-1])
    return np.append(y, y[-1] + share * (end_y - y[-1])), np.append(z, height)


def _without_level_tail(y: Array, z: Array, size: float) -> tuple[Array, Array]:
    """Cut off what runs level or down at the very end of a curve that rose before: a piece of a deck edge."""
    step = np.maximum(np.hypot(np.diff(y), np.diff(z)), 1e-9)
    left = np.cumsum(step[::-1])[::-1]  # of the curve, beyond each step
    rising = np.diff(z) / step > LEVEL
    last = int(np.flatnonzero(rising)[-1]) + 1 if rising.any() else 0
    if last >= len(left) or left[last] > LONGEST_TAIL * size or left[0] - left[last] < LONGEST_TAIL * size:
        return y, z
    before = (left > left[last]) & (left < left[last] + LONGEST_TAIL * size)
    steep = float(np.average(np.diff(z)[before] / step[before], weights=step[before]))
    return (y[: last + 1], z[: last + 1]) if steep > STEEP_BEFORE else (y, z)


def _upper_end(
    y: Array, z: Array, size: float, deck: Deck, reaches_deck: bool, covered: bool, side_top: float | None
) -> tuple[Array, Array]:
    # what runs on along the sheer line or above it is not the station
    above = np.flatnonzero(z >= deck(y) - 1.0)
    above = above[above > 0.5 * len(z)]
    if above.size:
        cut = int(above[0])
        gap_before, gap_here = float(deck(y[cut - 1]) - z[cut - 1]), float(deck(y[cut]) - z[cut])
        share = np.clip(gap_before / (gap_before - gap_here), 0.0, 1.0) if gap_before > gap_here else 1.0
        end_y, end_z = y[cut - 1] + share * (y[cut] - y[cut - 1]), z[cut - 1] + share * (z[cut] - z[cut - 1])
        end_z = float(deck(end_y)) if np.isfinite(deck(end_y)) else end_z
        return np.append(y[:cut], end_y), np.append(z[:cut], end_z)
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    part = arc >= arc[-1] - STRETCH * size
    rise, lean = z[-1] - z[part][0], y[-1] - y[part][0]
    at_side = not reaches_deck and covered and y[-1] > AT_SIDE * size and rise > 3 * abs(lean)
    top = float(deck(float(y[-1])))
    end_of_side = min(top, np.inf if side_top is None else max(side_top, z[-1]))
    if at_side and z[-1] < end_of_side < np.inf:
        return _into_the_side(y, z, lean / rise, size, end_of_side)
    if not np.isfinite(top):
        return y, z
    if z[-1] > top:
        first = int(np.argmax(z >= top))
        end = float(np.interp(top, z[first - 1 : first + 1], y[first - 1 : first + 1]))
        return np.append(y[:first], end), np.append(z[:first], top)
    gap = top - z[-1]
    if gap <= NEAR_DECK * size and rise > 0:
        end = y[-1]
        for _ in range(5):  # the deck's height depends on where the curve meets it
            end = y[-1] + lean / rise * (float(deck(end)) - z[-1])
        return np.append(y, end), np.append(z, float(deck(end)))
    return y, z


def _into_the_side(y: Array, z: Array, slope: float, size: float, top: float) -> tuple[Array, Array]:
    """Continue a curve up to `top` by a parabola that turns into the line of B/2, and along that line."""
    height = np.linspace(0.0, top - z[-1], max(3, int((top - z[-1]) / 3)))[1:]
    reach, slope = max(size - y[-1], 1e-6), max(slope, 0.0)
    turning = np.minimum(height, 2 * reach / max(slope, 1e-9))
    across = slope * turning - (slope * turning) ** 2 / (4 * reach)
    return np.concatenate([y, y[-1] + across]), np.concatenate([z, z[-1] + height])


def _covered(trace: Trace, hidden: Mask) -> bool:
    """Whether an upright line of the drawing lies where a curve ends, so that it may go on unseen."""
    size = min(len(trace.column), 12)
    slope = float(np.polyfit(np.arange(size), trace.row[-size:], 1)[0])
    ahead = np.arange(0, COVER_PX)
    column = np.clip(np.round(trace.column[-1] + ahead), 0, hidden.shape[1] - 1).astype(np.int64)
    row = np.clip(np.round(trace.row[-1] + slope * ahead), 0, hidden.shape[0] - 1).astype(np.int64)
    return bool((hidden[row, column] & VERTICAL > 0).mean() > 0.5)


def _up_the_side(y: Array, z: Array, size: float, top: float) -> tuple[Array, Array]:
    """A curve that ends rising close to the line of B/2 joins it and goes up to where that line is drawn."""
    along = np.flatnonzero((y >= (1 - AT_LINE / 2) * size) & (z <= top))
    if z[-1] > top and along.size and z[along[-1]] > top - NEAR_DECK * size / 2:
        return np.append(y[: along[-1] + 1], y[along[-1]]), np.append(z[: along[-1] + 1], top)
    if y[-1] < AT_SIDE * size or top - z[-1] <= NEAR_DECK * size:
        return y, z
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    part = arc >= arc[-1] - STRETCH * size
    rise, lean = z[-1] - z[part][0], y[-1] - y[part][0]
    tail = arc >= arc[-1] - TAIL * size
    turning = y[-1] > CLOSE_TO_SIDE * size and z[-1] - z[tail][0] > BEGUN * (y[-1] - y[tail][0])
    if rise <= STEEP_ENOUGH * abs(lean) and y[-1] < (1 - AT_LINE) * size and not turning:
        return y, z
    if y[-1] < size:  # it turns into the line: an arc needs twice the height of the straight way
        join = min(z[-1] + 2 * (size - y[-1]) * max(rise, 0.0) / max(lean, 1e-6), z[-1] + FARTHEST * size, top)
        share = np.linspace(0.0, 1.0, 8)[1:-1]
        y = np.concatenate([y, y[-1] + (size - y[-1]) * share * (2 - share), [size]])
        z = np.concatenate([z, z[-1] + (join - z[-1]) * share, [join]])
    return np.append(y, y[-1]), np.append(z, top)
