"""The part of the flow's network that leans back: how curves go over into pieces across the frame, and return."""

from __future__ import annotations

from dataclasses import dataclass
from heapq import heapify, heappop, heappush

import numpy as np
from numpy.typing import NDArray

from hullform.picture.pieces.ends import DEAREST_ENTRY, DEAREST_EXIT, REACH_OF_KEEL_PX, Ends
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.joints import Cover, Tips, joints, unit_vectors
from hullform.picture.pieces.ridges import Tracklet
from hullform.picture.pieces.turning import Turning

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Bends:
    """Nodes and links that the pieces across the frame add to those along it.

    A piece is two nodes, one for each way it may be walked: nodes n..n+m-1 go inboard and up, n+m..n+2m-1 outboard and
    down, where n pieces lie along the frame and m across it.

    Attributes:
        first, last: ends of the added nodes, in the frame.
        source, target, cost: of the added links.
        entry, leave: what it costs to begin or end at an added node.
    """

    first: Ends
    last: Ends
    source: Indices
    target: Indices
    cost: Array
    entry: Array
    leave: Array


def find_bends(
    tracklets: list[Tracklet],
    first: Ends,
    last: Ends,
    turning: Turning,
    cover: Cover,
    frame: DiagonalFrame,
    scale: float,
) -> Bends:
    """How the pieces that lean back may be joined to the others and to each other.

    Args:
        tracklets: pieces along the frame; first, last: their ends.
        turning: pieces across it.
        cover: what may hide a curve in the frame.
        frame: of the half.
        scale: of the costs, by the size of the drawing.
    """
    n, m = len(tracklets), len(turning.pieces)
    length = np.array([len(t.column) for t in tracklets], dtype=np.float64)
    across_length = np.array([len(piece.column) for piece in turning.pieces], dtype=np.float64)
    low, high = turning.ends(last=False), turning.ends(last=True)
    starts, stops = _along(first, length), _along(last, length)
    up = _across(low, across_length, upwards=True), _across(high, across_length, upwards=True)
    down = _across(high, across_length, upwards=False), _across(low, across_length, upwards=False)
    size = frame.half_breadth_px
    parts = []
    for (out, a), (into, b) in (
        ((stops, 0), (up[0], n)),
        ((up[1], n), (starts, 0)),
        ((up[1], n), (up[0], n)),
        ((stops, 0), (down[0], n + m)),
        ((down[1], n + m), (starts, 0)),
        ((down[1], n + m), (down[0], n + m)),
        ((down[1], n + m), (up[0], n)),
        ((up[1], n), (down[0], n + m)),
    ):
        source, target, cost = joints(out, into, cover, size, scale)
        other = source + a - n != target + b - n
        parts.append((source[other] + a, target[other] + b, cost[other]))
    source, target, cost = (np.concatenate([part[k] for part in parts]) for k in range(3))
    # a piece does not follow itself the other way round
    one_way = np.concatenate([np.zeros(n + m, dtype=np.bool_), turning.inboard_only])
    allowed = (np.abs(source - target) != m) & ~one_way[source] & ~one_way[target]
    begin = Ends(*(np.concatenate(pair) for pair in _pairs(low, high)))
    end = Ends(*(np.concatenate(pair) for pair in _pairs(high, low)))
    outboard = np.where(turning.inboard_only, DEAREST_ENTRY * scale, _at_centre(high, frame, scale, DEAREST_ENTRY))
    entry = np.concatenate([np.full(m, DEAREST_ENTRY * scale), outboard])
    leave = np.concatenate([_at_centre(high, frame, scale, DEAREST_EXIT), np.full(m, DEAREST_EXIT * scale)])
    return Bends(begin, end, source[allowed], target[allowed], cost[allowed], entry, leave)


def _pairs(one: Ends, other: Ends) -> tuple[tuple[Array, Array], ...]:
    return (one.column, other.column), (one.row, other.row), (one.slope, other.slope)


def _along(ends: Ends, length: Array) -> Tips:
    return Tips(ends.column, ends.row, unit_vectors(np.ones_like(ends.slope), ends.slope), length)


def _across(ends: Ends, length: Array, upwards: bool) -> Tips:
    way = 1.0 if upwards else -1.0
    return Tips(ends.column, ends.row, unit_vectors(way * ends.slope, np.full_like(ends.slope, -way)), length)


def _at_centre(ends: Ends, frame: DiagonalFrame, scale: float, dearest: float) -> Array:
    """Little at the centre line, else too much."""
    y, _ = frame.to_drawing(ends.column, ends.row)
    away, reach = np.abs(y), REACH_OF_KEEL_PX * scale
    return np.where(away < reach, 0.3 * away, np.minimum(3 + 4 * (away - reach), dearest * scale))


def walking_order(preferred: Indices, source: Indices, target: Indices) -> list[int]:
    """The nodes, each after those that links lead from to it, else as preferred; those of rings come last."""
    place = np.empty(len(preferred), dtype=np.int64)
    place[preferred] = np.arange(len(preferred))
    following: list[list[int]] = [[] for _ in preferred]
    waiting = np.bincount(target, minlength=len(preferred))
    for a, b in zip(source.tolist(), target.tolist(), strict=True):
        following[a].append(b)
    ready = [int(place[node]) for node in np.flatnonzero(waiting == 0)]
    heapify(ready)
    order = []
    while ready:
        node = int(preferred[heappop(ready)])
        order.append(node)
        for other in following[node]:
            waiting[other] -= 1
            if waiting[other] == 0:
                heappush(ready, int(place[other]))
    return order + [node for node in preferred.tolist() if waiting[node] > 0]
