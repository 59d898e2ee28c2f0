"""Which curve is which station: one alignment of names and curves that keeps their order from the centre line outwards.

The aft half shows its aftmost station innermost, the fore half its foremost. Stations of a parallel body are drawn
once: where there are fewer curves than names, the outermost curve has several. A curve that is no station (a piece of
a bulb, a deck edge, a label's stroke) and a station that was not found must not shift the names that follow: either
may be left out at a cost, and what decides is the fairness of the half-breadths along the ship and the user's marks.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.picture.naming.fair_lines import LARGEST_UNFAIRNESS

Array = NDArray[np.float64]

COST_OF_SHARING_INSIDE = 30.0  # px of mark distance that sharing any but the outermost curve is worth
COST_OF_SHARING_OUTSIDE = 0.5
COST_OF_UNNAMED_CURVE = 60.0  # of a whole curve; of a piece by its certainty
COST_OF_UNDRAWN_STATION = 40.0
COST_OF_UNFAIRNESS = 700.0  # per B/2 of half-breadth beside the line between the two neighbours
MOST_UNDRAWN_TOGETHER = 2
MARK_NOISE_PX = 5.0  # a hand's error and half a line: curves so near are all meant
FARTHEST_MARK_PX = 200.0  # a mark farther from every curve says no more than this
LEVELS = (0.08, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95)  # of the highest curve: where fairness is judged
COST_OF_ANOTHER = 1e5  # curve than the one drawn for a station
LEVEL = 0.06  # rise over run: a deck with camber or sheer rises less, a section more
HIGH = 0.5  # of the highest curve: no section lies wholly above it that is level
CERTAINTY_OF_LEVEL = 0.1
END = 0.03  # of the breadth of a curve, its outermost part
NO_CURVE = -1


def assign_stations(
    positions_m: Sequence[float],
    half_breadths: Array,
    certainty: Sequence[float],
    mark_distance_px: Array | None = None,
    fixed: Sequence[tuple[int, int]] = (),
    label_cost: Array | None = None,
) -> list[int]:
    """The curve of each station, both counted from the centre line outwards; never decreasing; -1 without a curve.

    The alignment of least cost: second differences of the half-breadths along x, marks, what is shared or left out.

    Args:
        positions_m: x of each name, strictly monotone.
        half_breadths: (curves, levels) at fixed heights in parts of B/2, NaN where a curve does not reach.
        certainty: 0..1 of each curve: how dear it is to leave it without a name.
        mark_distance_px: (stations, curves) distance of each station's mark from each curve, NaN where it has none.
        fixed: station and curve that a person drew for it, both by index and in the same order.
        label_cost: (stations, curves) what speaks against each pair by the labels of the drawing.
    """
    stations, curves = len(positions_m), len(half_breadths)
    x = np.asarray(positions_m, dtype=np.float64)
    marks = np.zeros((stations, curves)) if mark_distance_px is None else np.nan_to_num(mark_distance_px)
    at = np.clip(marks - MARK_NOISE_PX, 0.0, FARTHEST_MARK_PX)
    undrawn = COST_OF_UNDRAWN_STATION + np.where(np.ptp(at, axis=1) > 0, FARTHEST_MARK_PX, 0.0)
    if label_cost is not None:
        at = at + label_cost
    for station, curve in fixed:
        at[station] = COST_OF_ANOTHER
        at[station, curve] = 0.0
        undrawn[station] += COST_OF_ANOTHER
    left_out = np.concatenate([[0.0], np.cumsum(COST_OF_UNNAMED_CURVE * np.asarray(certainty, dtype=np.float64))])
    before, after = left_out[:-1], left_out[-1] - left_out[1:]
    # from curve b to curve c of the next name: what lies between has no name
    step = left_out[None, :-1] - left_out[1:, None]
    np.fill_diagonal(step, COST_OF_SHARING_INSIDE)
    step[-1, -1] = COST_OF_SHARING_OUTSIDE
    step[np.tril_indices(curves, -1)] = np.inf
    skipped = np.concatenate([[0.0], np.cumsum(undrawn)])
    # best[i, g][b, c]: names i - g and i have the curves b and c, those between them none
    best: dict[tuple[int, int], Array] = {}
    came: dict[tuple[int, int], tuple[NDArray[np.int64], Array]] = {}
    reach = MOST_UNDRAWN_TOGETHER + 1
    first = [skipped[i] + before + at[i] for i in range(stations)]
    for i in range(1, stations):
        for g in range(1, min(reach, i) + 1):
            middle = i - g
            edge = step + at[i][None, :] + (skipped[i] - skipped[middle + 1])
            value = (first[middle] if middle < reach else np.full(curves, np.inf))[:, None] + edge
            origin, gap = np.full((curves, curves), -1), np.zeros((curves, curves))
            for h in range(1, min(reach, middle) + 1):
                share = (x[middle] - x[middle - h]) / (x[i] - x[middle - h])
                through = best[middle, h][:, :, None] + _unfairness(half_breadths, float(share)) + edge[None]
                nearest = np.argmin(through, axis=0)
                reached = np.take_along_axis(through, nearest[None], axis=0)[0]
                better = reached < value
                value, origin, gap = (
                    np.where(better, reached, value),
                    np.where(better, nearest, origin),
                    np.where(better, h, gap),
                )
            best[i, g], came[i, g] = value, (origin, gap)
    ends = [(float((first[i] + after + skipped[-1] - skipped[i + 1]).min()), i, 0) for i in range(min(reach, stations))]
    ends += [
        (float((value + after[None, :]).min() + skipped[-1] - skipped[i + 1]), i, g) for (i, g), value in best.items()
    ]
    _, i, g = min(end for end in ends if end[1] >= stations - reach)
    assigned = [NO_CURVE] * stations
    if g == 0:
        assigned[i] = int(np.argmin(first[i] + after))
        return assigned
    b, c = np.unravel_index(int(np.argmin(best[i, g] + after[None, :])), (curves, curves))
    assigned[i], assigned[i - g] = int(c), int(b)
    while came[i, g][0][b, c] >= 0:
        origin, gap = came[i, g]
        i, g, b, c = i - g, int(gap[b, c]), origin[b, c], b
        assigned[i - g] = int(b)
    return assigned


def _unfairness(half_breadths: Array, share: float) -> Array:
    """(a, b, c) cost of curve b between a and c, `share` of the way from a to c along the ship."""
    between = half_breadths[:, None, :] * (1 - share) + half_breadths[None, :, :] * share
    beside = np.minimum(np.abs(half_breadths[None, :, None, :] - between[:, None, :, :]), LARGEST_UNFAIRNESS)
    known = np.isfinite(beside)
    total = np.where(known, beside, 0.0).sum(axis=-1)
    return np.asarray(COST_OF_UNFAIRNESS * total / np.maximum(known.sum(axis=-1), 1))


def certainties(curves: Sequence[Array], confidences: Sequence[float]) -> list[float]:
    """How surely each curve is a station's: its confidence, but little for a level line high up, a deck's.

    Args:
        curves: (n, 2) points of each, px, keel to deck.
        confidences: 0..1 of each.
    """
    top = max((float(curve[:, 1].max()) for curve in curves), default=1.0)
    certain = []
    for curve, confidence in zip(curves, confidences, strict=True):
        across, up = np.ptp(curve, axis=0)
        # a flat of bottom high up, at a raked end, turns up into its bilge
        rise, run = np.ptp(curve[curve[:, 0] >= curve[-1, 0] - END * across], axis=0)[::-1]
        level = up < LEVEL * across and curve[:, 1].min() > HIGH * top and rise < run
        certain.append(confidence * (CERTAINTY_OF_LEVEL if level else 1.0))
    return certain


def half_breadths_at(curves: Sequence[Array], half_breadth_px: float) -> Array:
    """(curves, levels) half-breadths in parts of B/2 at levels up to the highest end.

    Below its start a curve that starts on the centre line has none, above its end at the side that of its end; else
    NaN.
    """
    top = max((float(curve[:, 1].max()) for curve in curves), default=1.0)
    levels = top * np.array(LEVELS)
    out = np.full((len(curves), len(levels)), np.nan)
    for number, curve in enumerate(curves):
        rising = np.maximum.accumulate(curve[:, 1])
        y = np.interp(levels, rising, curve[:, 0]) / half_breadth_px
        y[(levels < rising[0]) & (curve[0, 0] > 0.03 * half_breadth_px)] = np.nan
        y[levels < rising[0]] *= 0.0
        y[levels > rising[-1] + 0.1 * top] = np.nan
        out[number] = y
    return out


def mark_distances(
    curves: Sequence[NDArray[np.float64]], marks: Sequence[tuple[int, float, float]], stations: int
) -> Array | None:
    """(stations, curves) distance in px of each station's mark from each curve; NaN without a mark, None without any.

    Args:
        curves: (n, 2) points of each, px.
        marks: station index, and the point in the same px.
        stations: number of names.
    """
    if not marks:
        return None
    out = np.full((stations, len(curves)), np.nan)
    for station, first, second in marks:
        out[station] = [float(np.hypot(*(points - (first, second)).T).min()) for points in curves]
    return out
