"""Which tracklets belong to which station: one min-cost flow for all curves of a half.

Every curve is a unit of flow from the keel or centre line to the deck. A tracklet pays for its length once; a second
curve may share it only where the ink is wide enough for two lines; links across gaps cost what they bend. Solving for
all curves at once keeps one curve from taking its neighbour's continuation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.line_mask import Mask
from hullform.picture.edits.constraints import UNCONSTRAINED, Constraints, Links
from hullform.picture.edits.line_edits import end_of, start_of
from hullform.picture.image.ink import Ink
from hullform.picture.pieces.ends import STEEPEST, Ends, entry_cost, exit_cost
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.joints import (
    COST_OF_BEND,
    COST_OF_DETOUR,
    COST_OF_HIDDEN,
    COST_OF_KNUCKLE,
    COST_OF_MISS,
    COST_OF_PAPER,
    DEAREST_LINK,
    LONGEST_GAP,
    Cover,
)
from hullform.picture.pieces.ridges import Tracklet
from hullform.picture.pieces.turning import NOTHING_TURNS, Turning
from hullform.picture.tracing.bends import find_bends, walking_order
from hullform.picture.tracing.network import Flow, Network, cheapest_flow

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

REFERENCE_PX = 800.0  # per B/2: the costs below are for a drawing of this size and scale with it
COST_OF_CURVE = 45.0  # what a curve must gather: half of the shortest station that is drawn, twice a label's stroke
MARGIN_OF_ORDER = 0.02  # of B/2: starts nearer than this to an axis lie on it
BESIDE_CENTRE = 2.0  # of a line's thickness: pieces nearer to the centre line run along it
LARGEST_BEND_AT_CENTRE = 0.3  # of slope, where a curve leaves it
REWARD_OF_MARK = 1500.0  # for each curve that runs along the tracklet under a user's mark, one a marked station
FARTHEST_MARK_PX = 9.0  # from a tracklet that it means
MOST_UNLISTED = 8  # curves beyond the listed stations that are looked for
LEAST_GAIN_UNLISTED = 20.0  # of each of them, px of ink: half of the shortest station that is drawn


@dataclass(frozen=True, eq=False)
class Path:
    """One curve: its tracklets from keel to deck, and what its ends cost (px of ink).

    With n tracklets along the frame and m pieces across it, numbers from n are pieces walked inboard and up, numbers
    from n + m the same pieces walked outboard and down.
    """

    tracklets: tuple[int, ...]
    end_cost: float


def find_paths(
    tracklets: list[Tracklet],
    ink: Ink,
    mask: Mask,
    frame: DiagonalFrame,
    width_px: float,
    top_px: Array,
    most: int,
    marks: Sequence[MarkInFrame] = (),
    side_top_px: float | None = None,
    constraints: Constraints = UNCONSTRAINED,
    turning: Turning = NOTHING_TURNS,
) -> tuple[list[Path], int]:
    """The curves of one half, each worth more than it costs, and how many of them are more than `most`.

    Args:
        tracklets: of the half.
        ink, mask: (rows, columns) of the frame.
        frame: of the half.
        width_px: thickness of one line.
        top_px: (len(tracklets),) height of the deck edge over the last end of each, px of the drawing.
        most: number of stations that the half may show.
        marks: points that a user put on curves.
        side_top_px: height to which the line of B/2 is drawn by stations, or None where none runs along it.
        constraints: what the user says of links, ends and shared lines.
        turning: pieces that lean back, walked across the frame.

    Returns:
        the curves, and by how many they are more than listed; further ones must gain as a station does.
    """
    if not tracklets or most < 1:
        return [], 0
    scale = frame.half_breadth_px / REFERENCE_PX
    first, last = Ends.of(tracklets, last=False), Ends.of(tracklets, last=True)
    cover = Cover(mask, ink)
    links = constraints.of_links(tracklets, *_links(tracklets, first, last, cover, frame, width_px, scale))
    entry = constraints.at_ends(entry_cost(first, last, mask, frame, scale), [start_of(t) for t in tracklets], scale)
    entry += COST_OF_CURVE * scale
    leave = exit_cost(last, ink, frame, top_px, side_top_px, scale)
    leave = constraints.at_ends(leave, [end_of(t) for t in tracklets], scale)
    reward, share = _worth(tracklets, width_px)
    share[constraints.shared(tracklets, links)] = 0.0
    marked, called = _marked(tracklets, marks, width_px)
    if turning.pieces:
        bends = find_bends(tracklets, first, last, turning, cover, frame, scale)
        gain, again = _worth(turning.pieces, width_px)
        across = [MarkInFrame(mark.station, mark.row, turning.rows - 1.0 - mark.column) for mark in marks]
        there, called_there = _marked(turning.pieces, across, width_px)
        once, called = np.minimum(there, 1), called | called_there
        reward, share = np.concatenate([reward, gain, gain]), np.concatenate([share, again, again])
        marked = np.concatenate([marked, once, once])
        entry = np.concatenate([entry, bends.entry + COST_OF_CURVE * scale])
        leave = np.concatenate([leave, bends.leave])
        first, last = first.with_others(bends.first), last.with_others(bends.last)
        passable = constraints.passable(
            np.column_stack([last.column, last.row])[bends.source],
            np.column_stack([first.column, first.row])[bends.target],
        )
        links = links.with_others(bends.source[passable], bends.target[passable], bends.cost[passable])
    reward[marked > 0] -= REWARD_OF_MARK * scale
    network = Network(
        reward, share, links, entry, leave, marked, REWARD_OF_MARK * scale, len(turning.pieces), len(called)
    )

    def solve(units: int) -> Flow | None:
        return cheapest_flow(network, units)

    flow, unlisted = solve(most), 0
    while flow is None and unlisted < MOST_UNLISTED:  # more lines are to be joined than there are stations
        unlisted += 1
        flow = solve(most + unlisted)
    if flow is None:
        return [], 0
    if flow.units == most:  # the bound may have kept curves out
        before = flow
        while unlisted < MOST_UNLISTED and (further := solve(most + unlisted + 1)) is not None:
            if further.units == before.units or before.cost - further.cost < LEAST_GAIN_UNLISTED * scale:
                break
            unlisted, before = unlisted + 1, further
        flow = before
    walks = _decompose(first, last, frame, links, flow)
    ends = [float(entry[walk[0]] - COST_OF_CURVE * scale + leave[walk[-1]]) / scale for walk in walks]
    return [Path(tuple(walk), cost) for walk, cost in zip(walks, ends, strict=True)], unlisted


def _worth(tracklets: list[Tracklet], width_px: float) -> tuple[Array, Array]:
    """What the first curve gains on each tracklet (negative: it pays), and what every further one pays."""
    length = np.array([len(t.column) for t in tracklets], dtype=np.float64)
    strength = np.array([float(t.strength.mean()) for t in tracklets])
    width = np.array([float(np.median(t.width)) for t in tracklets])
    spare = np.clip(1.0 - 2.0 * np.clip(width / width_px - 1.0, 0.0, 4.0), 0.0, 1.0)
    return -length * np.minimum(1.0, strength / 0.5), length * (0.02 + 0.4 * spare) + 0.5


@dataclass(frozen=True)
class MarkInFrame:
    """A user's point on the curve of a station, on the diagonal frame."""

    station: int
    column: float
    row: float


def _marked(tracklets: list[Tracklet], marks: Sequence[MarkInFrame], width_px: float) -> tuple[Indices, set[int]]:
    """Number of stations that are marked on each tracklet, and all stations that are marked on any."""
    stations: list[set[int]] = [set() for _ in tracklets]
    for mark in marks:
        misses = [_miss(mark, tracklet) for tracklet in tracklets]
        if misses and min(misses)[0] < FARTHEST_MARK_PX:
            stations[misses.index(min(misses))].add(mark.station)
    # two marks on the ink of one line mean neighbours that nearly touch: it has room for one
    room = np.array([max(1, round(float(np.median(t.width)) / width_px)) for t in tracklets])
    counts = np.minimum([len(there) for there in stations], room)
    return counts.astype(np.int64), set().union(*stations)


def _miss(mark: MarkInFrame, tracklet: Tracklet) -> tuple[float, float]:
    """How far a mark lies from the ink of a tracklet, which may be a ribbon of several lines, and from its axis, px."""
    if not tracklet.column[0] - 4 <= mark.column <= tracklet.column[-1] + 4:
        return np.inf, np.inf
    low, axis, high = (
        float(np.interp(mark.column, tracklet.column, rows)) for rows in (tracklet.low, tracklet.row, tracklet.high)
    )
    return max(low - mark.row, mark.row - high, 0.0), abs(mark.row - axis)


def _links(
    tracklets: list[Tracklet],
    first: Ends,
    last: Ends,
    cover: Cover,
    frame: DiagonalFrame,
    width_px: float,
    scale: float,
) -> tuple[Indices, Indices, Array]:
    """Which tracklet may follow which, and the cost: mismatch in the middle of the gap, bend, gap length."""
    size = frame.half_breadth_px
    gap = first.column[None, :] - last.column[:, None]
    possible = (gap > -4) & (gap <= LONGEST_GAP * size) & (last.column[None, :] > last.column[:, None])
    np.fill_diagonal(possible, False)
    source, target = np.nonzero(possible)
    if source.size == 0:
        return source.astype(np.int64), target.astype(np.int64), np.zeros(0)
    distance = gap[source, target]
    span = np.maximum(distance, 1.0)
    from_row, from_slope = last.row[source], last.slope[source]
    to_row, to_slope = first.row[target], first.slope[target]
    miss = np.abs((from_row + from_slope * distance / 2) - (to_row - to_slope * distance / 2))
    bend = np.abs(from_slope - to_slope)
    direct = (to_row - from_row) / span
    detour = np.where(span > 6, np.maximum(np.abs(direct - from_slope), np.abs(direct - to_slope)), bend)
    length = np.array([len(t.column) for t in tracklets], dtype=np.float64)
    certain = np.minimum(1.0, np.minimum(length[source], length[target]) / 12.0)
    steps = np.linspace(0.0, 1.0, 9)
    columns = last.column[source][:, None] + span[:, None] * steps
    rows = from_row[:, None] + (to_row - from_row)[:, None] * steps
    hidden = np.where(span > 3, cover.hides(columns, rows), 1.0)
    cost = COST_OF_MISS * miss / (1 + 0.03 * span) + certain * (COST_OF_BEND * bend + COST_OF_DETOUR * detour)
    cost += span * (COST_OF_PAPER - (COST_OF_PAPER - COST_OF_HIDDEN) * hidden)
    # a knuckle: the two extrapolations meet inside the gap
    turn = to_slope - from_slope
    with np.errstate(divide="ignore", invalid="ignore"):
        meet = (to_row - to_slope * distance - from_row) / -turn
    knuckle = (np.abs(turn) > 0.35) & (span <= 0.03 * size) & (meet >= -4) & (meet <= span + 4)
    # a curve that meets the centre line at an angle meets its mirror image there
    in_centre = frame.to_drawing(last.column, last.row)[0][source] < BESIDE_CENTRE * width_px
    knuckle &= ~in_centre
    cost = np.where(knuckle, np.minimum(cost, COST_OF_KNUCKLE * scale + span), cost)
    steep = np.abs(to_row - from_row) > (STEEPEST + 0.1) * span + 4
    broken = (certain >= 1.0) & (bend > 0.9) & ~knuckle | in_centre & (turn > LARGEST_BEND_AT_CENTRE)
    good = (cost < DEAREST_LINK) & ~steep & ~broken
    return source[good].astype(np.int64), target[good].astype(np.int64), cost[good]


def _decompose(first: Ends, last: Ends, frame: DiagonalFrame, links: Links, flow: Flow) -> list[list[int]]:
    """Single curves out of the flow; where several share a tracklet they keep their order from the centre outwards."""
    n = len(first.column)
    outgoing: list[list[int]] = [[] for _ in range(n)]
    for index in np.flatnonzero(flow.links > 0).tolist():
        outgoing[links.source[index]] += [int(links.target[index])] * int(flow.links[index])
    y, z = frame.to_drawing(first.column, first.row)
    edge = MARGIN_OF_ORDER * frame.half_breadth_px
    paths: list[list[int]] = []
    arriving: list[list[tuple[float, int]]] = [[] for _ in range(n)]
    used = flow.links > 0
    for node in walking_order(np.lexsort((last.column, first.column)), links.source[used], links.target[used]):
        here = arriving[node]
        for _ in range(int(flow.entries[node])):
            # a curve that starts on the centre line lies inside, one from the base line outside
            rank = -np.inf if y[node] < edge <= z[node] else np.inf if z[node] < edge else 0.0
            here.append((float(rank), len(paths)))
            paths.append([])
        here.sort()
        for _, path in here:
            paths[path].append(node)
        # the inner ones end first, at the deck
        going = [path for _, path in here][int(flow.exits[node]) :]
        ordered = sorted(outgoing[node], key=lambda other: float(first.row[other] + 6 * first.slope[other]))
        for position, (path, other) in enumerate(zip(going, ordered, strict=False)):
            arriving[other].append((float(last.row[node]) + 1e-3 * position, path))
    return [path for path in paths if path]
