"""Joints in the plane: where one piece of curve may follow another whose direction no single diagonal can hold."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.line_mask import Mask
from hullform.picture.image.ink import Ink

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

LONGEST_GAP = 0.09  # of B/2
DEAREST_LINK = 120.0  # px of ink, as all costs
COST_OF_KNUCKLE = 25.0
COST_OF_MISS = 2.2  # per px by which the two ends, drawn on, miss each other in the middle of a gap
COST_OF_BEND = 28.0  # per unit of slope, or radian, between the two ends
COST_OF_DETOUR = 22.0  # the same, between an end and the way across the gap
COST_OF_PAPER = 0.8  # per px of gap where nothing is drawn
COST_OF_HIDDEN = 0.25  # per px of gap where a long line or another curve hides what is drawn
LEAST_COVER = 0.4  # ink that hides a curve
LARGEST_OVERLAP = 0.012  # of B/2: how far a piece may start before the end of the one that it follows
LEAST_CORNER = 0.35  # rad: less is a bend
LARGEST_TURN = 1.75  # rad, at a corner: 100 degrees
LARGEST_TURN_TO_LEVEL = 1.05  # rad, outboard: a station that meets the deck edge does not go on along it
LEVEL = 0.35  # sqrt 2 times the sine of the rise of a line that is level, or falls
SHARPEST_BEND = 0.9  # rad, of a smooth joint
LARGEST_BREAK = 0.03  # of B/2: gap at a corner


@dataclass(frozen=True, eq=False)
class Tips:
    """One end of each of several pieces: (column, row) in the frame, and the direction of the walk there.

    Attributes:
        column, row: (n,) place.
        ahead: (n, 2) unit vectors.
        length: (n,) of the pieces, px.
    """

    column: Array
    row: Array
    ahead: Array
    length: Array


@dataclass(frozen=True, eq=False)
class Cover:
    """What may hide a curve in the frame: (rows, columns) where long lines lay, and the ink of other curves.

    The ink of a curve hides another one where the two cross or run together, without a break; a label has breaks.
    """

    mask: Mask
    ink: Ink

    def hides(self, columns: Array, rows: Array) -> Array:
        """(gaps,) share of each gap that is hidden, of (gaps, places) in the frame."""
        column = np.clip(np.round(columns), 0, self.mask.shape[1] - 1).astype(np.int64)
        row = np.clip(np.round(rows), 0, self.mask.shape[0] - 1).astype(np.int64)
        line = self.mask[row, column] > 0
        whole = (line | (self.ink[row, column] > LEAST_COVER)).all(axis=1)
        return np.where(whole, 1.0, line.mean(axis=1))


def unit_vectors(column: Array, row: Array) -> Array:
    """(n, 2) directions of the given vectors."""
    vectors = np.column_stack([column, row])
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-9))


def joints(last: Tips, first: Tips, cover: Cover, size: float, scale: float) -> tuple[Indices, Indices, Array]:
    """Which piece may follow which, and the cost: mismatch in the middle of the gap, bend, gap length; or a corner.

    Args:
        last: where pieces end; first: where others start.
        cover: what may hide a curve in the frame.
        size: B/2 in px.
        scale: of the costs, by the size of the drawing.
    """
    none = np.zeros(0, dtype=np.int64)
    if last.column.size == 0 or first.column.size == 0:
        return none, none, np.zeros(0)
    gap = np.stack([first.column[None] - last.column[:, None], first.row[None] - last.row[:, None]], axis=-1)
    distance = np.linalg.norm(gap, axis=-1)
    near = distance < LONGEST_GAP * size
    source, target = np.nonzero(near)
    gap, distance = gap[near], distance[near]
    out, into = last.ahead[source], first.ahead[target]
    along = out + into
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    forward = np.sum(gap * along, axis=1)
    turn = np.arccos(np.clip(np.sum(out * into, axis=1), -1.0, 1.0))
    middle = gap - (out + into) * (forward / 2)[:, None]
    miss = np.linalg.norm(middle, axis=1)
    ways = np.stack([(gap * out).sum(axis=1), (gap * into).sum(axis=1)]) / np.maximum(distance, 1e-9)
    straight = np.arccos(np.clip(ways, -1.0, 1.0))
    detour = np.where(distance > 6, straight.max(axis=0), turn)
    certain = np.minimum(1.0, np.minimum(last.length[source], first.length[target]) / 12.0)
    steps = np.linspace(0.0, 1.0, 9)
    columns = last.column[source][:, None] + gap[:, :1] * steps
    rows = last.row[source][:, None] + gap[:, 1:] * steps
    hidden = np.where(distance > 3, cover.hides(columns, rows), 1.0)
    span = np.maximum(distance, 1.0)
    cost = COST_OF_MISS * miss / (1 + 0.03 * span) + certain * (COST_OF_BEND * turn + COST_OF_DETOUR * detour)
    cost += span * (COST_OF_PAPER - (COST_OF_PAPER - COST_OF_HIDDEN) * hidden)
    cost = np.where((turn > SHARPEST_BEND) | (forward < -LARGEST_OVERLAP * size), np.inf, cost)
    # a corner: both ends, drawn on, meet between them
    across = out[:, 0] * into[:, 1] - out[:, 1] * into[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        beyond = (gap[:, 0] * into[:, 1] - gap[:, 1] * into[:, 0]) / across
        before = (gap[:, 1] * out[:, 0] - gap[:, 0] * out[:, 1]) / across
    meet = (np.minimum(beyond, before) > -4) & (np.maximum(beyond, before) < span + 8)
    # across > 0 turns outboard; the height grows with column - row
    levels_out = (across > 0) & (into[:, 0] - into[:, 1] < LEVEL)
    largest = np.where(levels_out, LARGEST_TURN_TO_LEVEL, LARGEST_TURN)
    corner = (turn > LEAST_CORNER) & (turn < largest) & (distance < LARGEST_BREAK * size) & meet
    cost = np.where(corner, np.minimum(cost, COST_OF_KNUCKLE * scale + span), cost)
    good = cost < DEAREST_LINK
    return source[good].astype(np.int64), target[good].astype(np.int64), cost[good]
