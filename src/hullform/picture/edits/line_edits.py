"""Lines as a person edits them: tracklets taken out, cut, parted at a crossing, trimmed to be joined."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from hullform.picture.pieces.ends import Ends
from hullform.picture.pieces.ridges import Tracklet

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Place = tuple[float, float]  # [column, row] of the frame

LEAST_PIECE = 3  # peaks of a tracklet that is left over
CUT_PX = 1  # peaks taken out to either side of a cut
BEFORE_JUNCTION = 0.05  # of B/2: a line that goes on farther beyond the place to join is cut there
ARM = 0.1  # of B/2: how far from a crossing its arms may end, where the lines run into each other
MERGED = 1.2  # usual widths of a line: a ribbon so wide between the arms is both lines, and no arm
CROSSING_PX = 5.0  # a line that passes so near goes through the crossing
BLOT_PX = 5.0  # around a crossing, where no line has a direction of its own
AIM_PX = 7.0  # by which an arm may miss the crossing
RUN_GAP = 0.03  # of B/2: gaps of a line that is deleted
RUN_MISS_PX = 3.0  # by which the line may miss its own continuation,
RUN_LEAN = 0.15  # and more for each pixel of the gap


@dataclass(frozen=True)
class Under:
    """What lies under a place: the nearest tracklet, its peak there, and how far away; -1 and infinity for nothing."""

    tracklet: int
    peak: int
    distance_px: float


@dataclass(frozen=True)
class Straight:
    """A crossing: the last places of the arms that lead in, the first of those that lead out, and which goes on as."""

    inward: tuple[Place, ...]
    outward: tuple[Place, ...]
    pairs: tuple[tuple[Place, Place], ...]


def start_of(line: Tracklet) -> Place:
    """The place of a tracklet's first peak."""
    return float(line.column[0]), float(line.row[0])


def end_of(line: Tracklet) -> Place:
    """The place of a tracklet's last peak."""
    return float(line.column[-1]), float(line.row[-1])


def under(tracklets: Sequence[Tracklet], at: Place) -> Under:
    """The peak nearest to a place."""
    if not tracklets:
        return Under(-1, -1, np.inf)
    distance = np.concatenate([np.hypot(t.column - at[0], t.row - at[1]) for t in tracklets])
    place = int(np.argmin(distance))
    starts = np.cumsum([0] + [len(t.column) for t in tracklets])
    index = int(np.searchsorted(starts, place, side="right")) - 1
    return Under(index, place - int(starts[index]), float(distance[place]))


def without_run(tracklets: list[Tracklet], index: int, half_breadth_px: float) -> list[Tracklet]:
    """The tracklets without one, and without what alone continues it over gaps, up to the next junctions."""
    first, last = Ends.of(tracklets, last=False), Ends.of(tracklets, last=True)
    gap = first.column[None, :] - last.column[:, None]
    miss = np.abs(last.row[:, None] + last.slope[:, None] * gap - first.row[None, :])
    follows = (gap > 0) & (gap < RUN_GAP * half_breadth_px) & (miss < RUN_MISS_PX + RUN_LEAN * gap)
    alone = follows & (follows.sum(axis=0) == 1)[None, :] & (follows.sum(axis=1) == 1)[:, None]
    run = {index}
    for onward in (alone, alone.T):
        here = index
        while (following := np.flatnonzero(onward[here])).size:
            here = int(following[0])
            run.add(here)
    return [t for number, t in enumerate(tracklets) if number not in run]


def cut(tracklets: list[Tracklet], at: Under) -> tuple[list[Tracklet], tuple[Place, Place]]:
    """The tracklets, one of them cut at a peak, and the two places to either side of it."""
    line = tracklets[at.tracklet]
    before, after = max(at.peak - CUT_PX, 0), min(at.peak + CUT_PX + 1, len(line.column))
    loose = (
        line.chosen(np.arange(max(before, 1))),
        line.chosen(np.arange(min(after, len(line.column) - 1), len(line.column))),
    )
    pieces = ((0, before), (after, len(line.column)))
    return _replaced(tracklets, at.tracklet, pieces), (end_of(loose[0]), start_of(loose[1]))


def crossed(tracklets: list[Tracklet], at: Place, half_breadth_px: float) -> tuple[list[Tracklet], Straight]:
    """The tracklets, cut clear of the blot in the middle of a crossing, and which arm goes straight on as which."""
    arm = ARM * half_breadth_px
    usual = float(np.median([np.median(line.width) for line in tracklets]))
    pieces: list[Tracklet] = []
    for line in tracklets:
        away = np.hypot(line.column - at[0], line.row - at[1])
        if away.min() > CROSSING_PX:
            pieces.append(line)
            continue
        clear = np.concatenate([[False], away > BLOT_PX, [False]])
        edges = np.flatnonzero(np.diff(clear.astype(np.int8)))
        for start, stop in edges.reshape(-1, 2).tolist():
            merged = float(np.median(line.width[start:stop])) > MERGED * usual and away[start:stop].max() < arm
            if stop - start >= LEAST_PIECE and not merged:
                pieces.append(line.chosen(np.arange(start, stop)))
    first, last = Ends.of(pieces, last=False), Ends.of(pieces, last=True)
    inward, outward = _arms(last, at, 1, arm), _arms(first, at, -1, arm)
    bend = np.abs(last.slope[inward][:, None] - first.slope[outward][None, :])
    into, out = [end_of(pieces[i]) for i in inward], [start_of(pieces[i]) for i in outward]
    onward = zip(*linear_sum_assignment(bend), strict=True)
    return pieces, Straight(tuple(into), tuple(out), tuple((into[a], out[b]) for a, b in onward))


def joined(
    tracklets: list[Tracklet], first: Under, second: Under, half_breadth_px: float
) -> tuple[list[Tracklet], tuple[Place, Place]]:
    """The tracklets, two of them cut where they go on beyond the places to join, and the two ends to be joined."""
    lower, upper = sorted((first, second), key=lambda at: float(tracklets[at.tracklet].column[at.peak]))
    before, after = tracklets[lower.tracklet], tracklets[upper.tracklet]
    farthest = BEFORE_JUNCTION * half_breadth_px
    stop = len(before.column) if len(before.column) - 1 - lower.peak <= farthest else lower.peak + 1
    start = 0 if upper.peak <= farthest else upper.peak
    if after.column[start] <= before.column[stop - 1]:  # they overlap: each up to half-way between the two places
        middle = 0.5 * (float(before.column[lower.peak]) + float(after.column[upper.peak]))
        stop = max(lower.peak + 1, int(np.searchsorted(before.column, middle)))
        start = min(upper.peak, int(np.searchsorted(after.column, middle + 1)))
    stop, start = max(stop, LEAST_PIECE), min(start, len(after.column) - LEAST_PIECE)
    pair = end_of(before.chosen(np.arange(stop))), start_of(after.chosen(np.arange(start, len(after.column))))
    for index, place in sorted(((lower.tracklet, stop), (upper.tracklet, start)), reverse=True):
        tracklets = _replaced(tracklets, index, pairwise((0, place, len(tracklets[index].column))))
    return tracklets, pair


def _replaced(tracklets: Sequence[Tracklet], index: int, pieces: Iterable[tuple[int, int]]) -> list[Tracklet]:
    """The tracklets with pieces [from, to) of one of them in its place."""
    old = tracklets[index]
    new = [old.chosen(np.arange(a, b)) for a, b in pieces if b - a >= LEAST_PIECE]
    return [*tracklets[:index], *new, *tracklets[index + 1 :]]


def _arms(ends: Ends, at: Place, sign: int, arm_px: float) -> Indices:
    """Tracklets that end (sign 1) or begin (-1) near a crossing and point at it."""
    ahead = sign * (at[0] - ends.column)
    miss = np.abs(ends.row + ends.slope * (at[0] - ends.column) - at[1])
    near = (np.hypot(ends.column - at[0], ends.row - at[1]) < arm_px) & (ahead > -BLOT_PX)
    return np.flatnonzero(near & (miss < AIM_PX * np.hypot(1.0, ends.slope))).astype(np.int64)
