"""From paths of tracklets to smooth curves: merged lines are spread over their ribbon, noise and gaps bridged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cmp_to_key

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solveh_banded

from hullform.picture.edits.corners import bends_freely, corner_near, without_blur
from hullform.picture.edits.placing import REACH
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.ridges import Tracklet
from hullform.picture.tracing.flow import Path
from hullform.picture.tracing.winding import Pieces, bridged

Array = NDArray[np.float64]

SHORTEST_WAVE = 0.045  # of B/2: shorter waves along a curve are taken for noise
WEIGHT_OF_SHARED = 0.04  # of a point in a ribbon of several curves, against 1 for one of its own
WEIGHT_OF_GAP = 1e-5  # of a point that nothing shows
WEIGHT_OF_BLOT = 4e-3  # of a point on the straight way from the keel point to where a curve comes out of the blot
SAME_PLACE_PX = 2.0  # curves that lie so near each other at a knuckle all have it
PASSES = 4  # of the robust fit
BLOT = 0.25  # of B/2: how far from the keel point curves may still be merged
STEEPEST = 0.12  # least ratio of y and z there: a flatter or steeper curve touches its axis elsewhere
AIM = 0.15  # of the distance: by how much a curve that heads for the keel point may miss it
STRETCH_PX = 40  # that shows where a curve heads


@dataclass(frozen=True, eq=False)
class Trace:
    """A smooth curve on every column of the diagonal frame, and how well it was seen.

    Attributes:
        column, row: in the frame, keel to deck.
        weight: 1 where the curve stands alone, 0.04 in a ribbon, 0.004 in gaps.
        visible: share of the columns with ink; `own`: share where it stands alone.
        end_cost: of the flow, at both ends.
        corners: [column, row] of the knuckles that were kept.
        winds: whether the curve turns back, so that its columns do not increase throughout.
    """

    column: Array
    row: Array
    weight: Array
    visible: float
    own: float
    end_cost: float
    corners: tuple[tuple[float, float], ...] = ()
    winds: bool = False


def smooth_traces(
    paths: Sequence[Path],
    pieces: Pieces,
    width_px: float,
    frame: DiagonalFrame,
    knuckles: Sequence[tuple[float, float]] = (),
) -> list[Trace]:
    """The curves of a half from the centre line outwards; (column, row) of the user's knuckles are not rounded."""
    raw = [_joined(path, pieces) for path in paths]
    winds = [pieces.winds(path.tracklets) for path in paths]
    level = [_over_height(path, pieces, frame) for path in paths] if any(winds) else raw

    def inside_first(first: int, second: int) -> int:
        seen = level if winds[first] or winds[second] else raw
        return _compare(seen[first], seen[second], first, second)

    order = sorted(range(len(paths)), key=cmp_to_key(inside_first))
    users: dict[int, list[int]] = {}
    for rank in order:
        for piece in paths[rank].tracklets:
            users.setdefault(piece, []).append(rank)
    near = _under(knuckles, raw, REACH * frame.half_breadth_px)
    return [_trace(number, paths[number], pieces, users, width_px, frame, near[number]) for number in order]


def _under(
    knuckles: Sequence[tuple[float, float]], raw: Sequence[tuple[Array, Array]], reach: float
) -> list[list[float]]:
    """The columns of the knuckles of each curve: those that lie nearest to it, or no farther than on that one."""
    out: list[list[float]] = [[] for _ in raw]
    for column, row in knuckles:
        away = [float(np.hypot(c - column, r - row).min()) for c, r in raw]
        least = min(away, default=np.inf)
        for number, distance in enumerate(away):
            if least <= reach and distance <= least + SAME_PLACE_PX:
                out[number].append(column)
    return out


def _joined(path: Path, pieces: Pieces) -> tuple[Array, Array]:
    points = [pieces.points(number) for number in path.tracklets]
    column, row = (np.concatenate([p[k] for p in points]) for k in (0, 1))
    unique, index = np.unique(column, return_index=True)
    return unique, row[index]


def _over_height(path: Path, pieces: Pieces, frame: DiagonalFrame) -> tuple[Array, Array]:
    """Heights, and the half-breadths there: curves that turn back are told apart by them."""
    points = [pieces.points(number) for number in path.tracklets]
    y, z = frame.to_drawing(*(np.concatenate([p[k] for p in points]) for k in (0, 1)))
    order = np.argsort(z, kind="stable")
    return z[order], y[order]


def _compare(a: tuple[Array, Array], b: tuple[Array, Array], first: int, second: int) -> int:
    """-1 where a lies inside b, over the columns that both have."""
    start, stop = max(a[0][0], b[0][0]), min(a[0][-1], b[0][-1])
    if stop > start:
        x = np.linspace(start, stop, 80)
        difference = float(np.sum(np.interp(x, *a) - np.interp(x, *b)))
    else:
        difference = float(a[1].mean() - b[1].mean())
    if abs(difference) < 1e-6:
        return -1 if first < second else 1
    return -1 if difference < 0 else 1


def _trace(
    number: int,
    path: Path,
    pieces: Pieces,
    users: dict[int, list[int]],
    width_px: float,
    frame: DiagonalFrame,
    knuckles: Sequence[float],
) -> Trace:
    columns, rows, weights = [], [], []
    for piece in path.tracklets:
        sharers = users[piece]
        column, row = pieces.points(piece)
        if len(sharers) > 1 and piece < len(pieces.along):
            row = _spread(pieces.along[piece], sharers.index(number), len(sharers), width_px)
        columns.append(column)
        rows.append(row)
        weights.append(np.full(len(row), 1.0 if len(sharers) == 1 else WEIGHT_OF_SHARED))
    wave = max(14.0, SHORTEST_WAVE * frame.half_breadth_px)
    if pieces.winds(path.tracklets):
        column, row, weight = bridged(columns, rows, weights, WEIGHT_OF_GAP)
        seen = np.concatenate(weights)
        return Trace(
            column=_robust_smooth(column, weight, wave),
            row=_robust_smooth(row, weight, wave),
            weight=weight,
            visible=len(seen) / len(weight),
            own=int((seen == 1.0).sum()) / len(weight),
            end_cost=path.end_cost,
            winds=True,
        )
    column, index = np.unique(np.concatenate(columns), return_index=True)
    row, seen = np.concatenate(rows)[index], np.concatenate(weights)[index]
    found, own = len(column), int((seen == 1.0).sum())
    held = _held_to_keel(column, row, seen, frame)
    every = np.arange(held[0][0], held[0][-1] + 1)
    weight = np.full(len(every), WEIGHT_OF_GAP)
    if len(held[0]) != len(column) or held[0][0] != column[0]:
        weight[: int(held[0][1] - held[0][0])] = WEIGHT_OF_BLOT
    column, row, seen = held
    weight[(column - column[0]).astype(np.int64)] = seen
    raw = np.interp(every, column, row)
    found_corners = [corner_near(every, raw, weight, at, frame.half_breadth_px) for at in knuckles]
    corners = sorted({corner for corner in found_corners if corner is not None})
    smooth = _robust_smooth(raw, weight, wave, corners)
    return Trace(
        column=every,
        row=smooth,
        weight=weight,
        visible=found / len(every),
        own=own / len(every),
        end_cost=path.end_cost,
        corners=tuple((float(every[corner]), float(smooth[corner])) for corner in corners),
    )


def _held_to_keel(column: Array, row: Array, weight: Array, frame: DiagonalFrame) -> tuple[Array, Array, Array]:
    """Start a curve that heads for the keel point there, instead of in the blot where many such curves meet."""
    alone = np.flatnonzero(weight == 1.0)
    if alone.size < STRETCH_PX:
        return column, row, weight
    first = int(alone[0])
    y, z = (float(value) for value in frame.to_drawing(column[first], row[first]))
    distance = float(np.hypot(y, z))
    if distance > BLOT * frame.half_breadth_px or min(y, z) < STEEPEST * max(y, z):
        return column, row, weight
    keel_column, keel_row = (float(value) for value in frame.from_drawing(0.0, 0.0))
    stretch = alone[:STRETCH_PX]
    slope, offset = np.polyfit(column[stretch] - keel_column, row[stretch] - keel_row, 1)
    if abs(offset) > AIM * distance or column[first] <= keel_column + 1:
        return column, row, weight
    start = np.round(keel_column)
    return (
        np.append(start, column[first:]),
        np.append(keel_row + slope * (start - keel_column), row[first:]),
        np.append(1.0, weight[first:]),
    )


def _spread(tracklet: Tracklet, rank: int, sharers: int, width_px: float) -> Array:
    """The axis of one of several lines that merged into a ribbon: between its edges, half a line width inside."""
    across = width_px * np.hypot(1.0, np.clip(tracklet.slope, -1.2, 1.2))
    free = np.maximum(0.0, tracklet.high - tracklet.low - across)
    free = np.where(free > across * (sharers + 0.5), 0.0, free)  # wider than its lines: something else lies there
    middle = 0.5 * (tracklet.low + tracklet.high)
    row = np.where(free > 0, middle + free * (rank / (sharers - 1) - 0.5), tracklet.row)
    if len(row) > 9:
        row = np.convolve(np.pad(row, 4, mode="edge"), np.ones(9) / 9, "valid")
    return row


def _robust_smooth(values: Array, weights: Array, shortest_wave: float, corners: Sequence[int] = ()) -> Array:
    """Whittaker's smoother (third differences), reweighted by Tukey's function of the residuals; it keeps corners."""
    if len(values) < 12:
        return values
    free = bends_freely(len(values), corners)
    weights = without_blur(weights, corners, WEIGHT_OF_GAP)
    stiffness = (shortest_wave / (2 * np.pi)) ** 6
    current = weights
    for _ in range(PASSES):
        smooth = _whittaker(values, current, np.where(free, 0.0, stiffness))
        residual = np.abs(smooth - values)
        certain = weights > 0.5
        scale = max(0.2, 1.4826 * float(np.median(residual[certain]))) if certain.sum() > 5 else 0.3
        current = weights * np.clip(1 - (residual / (5 * scale)) ** 2, 0.001, 1.0) ** 2
    return smooth


def _whittaker(values: Array, weights: Array, stiffness: Array) -> Array:
    """Minimise sum w (f - values)^2 + sum stiffness * (third difference of f)^2."""
    difference = np.array([-1.0, 3.0, -3.0, 1.0])
    size = len(values)
    bands = np.zeros((4, size))
    for i in range(4):
        for j in range(4 - i):
            bands[3 - i, i + j : size - 3 + i + j] += stiffness * difference[j] * difference[i + j]
    bands[3] += weights
    return np.asarray(solveh_banded(bands, weights * values), dtype=np.float64)
