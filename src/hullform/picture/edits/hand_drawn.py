"""Curves that a person drew: their course between the points, the ink that is theirs, their place among the others."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.spatial import KDTree

from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.ridges import Tracklet

Array = NDArray[np.float64]

STEP_PX = 1.0  # along a drawn curve
ON_LINE_PX = 3.0  # a tracklet so near a drawn curve lies on it,
ON_LINE = 0.006  # of B/2: or so near, where the hand's curve departs from the ink between its points
SHARE_OF_TRACKLET = 0.7  # that must lie there
SHARE_OF_CURVE = 0.5  # of the tracklet's length over which no other tracklet is nearer to the curve
ROOM_FOR_ANOTHER = 1.5  # widths of a line: a ribbon so wide holds another curve too
ON_CENTRE_LINE = 0.006  # of B/2: an end so near the centre line is meant to lie on it


def course(points: Array, smooth: bool, half_breadth_px: float) -> Array:
    """(n, 2) the curve through drawn points, keel to deck, at steps of about one pixel.

    A smooth one is the cubic spline over the centripetal parameter t_i = sum |p_k+1 - p_k|^(1/2), which neither loops
    nor overshoots much where points lie unevenly (Lee, Computer-Aided Design 21(6), 1989).

    Args:
        points: (n, 2) [y, z] in px of the drawing, from either end.
        smooth: whether to round it.
        half_breadth_px: B/2.
    """
    points = points[np.concatenate([[True], np.hypot(*np.diff(points, axis=0).T) > 1e-6])]
    if points[0, 1] > points[-1, 1]:
        points = points[::-1]
    points = points.copy()
    for end in (0, -1):
        if abs(points[end, 0]) < ON_CENTRE_LINE * half_breadth_px:
            points[end, 0] = 0.0
    chord = np.hypot(*np.diff(points, axis=0).T)
    t = np.concatenate([[0.0], np.cumsum(np.sqrt(chord) if smooth else chord)])
    steps = [np.linspace(a, b, max(2, round(c / STEP_PX) + 1))[:-1] for a, b, c in zip(t, t[1:], chord, strict=False)]
    at = np.append(np.concatenate(steps), t[-1]) if steps else t
    if smooth and len(points) > 2:
        curve = np.asarray(CubicSpline(t, points, bc_type="natural" if len(points) < 4 else "not-a-knot")(at))
    else:
        curve = np.column_stack([np.interp(at, t, points[:, k]) for k in (0, 1)])
    return np.column_stack([np.maximum(curve[:, 0], 0.0), curve[:, 1]])


def without_ink_of(
    curve: Array, tracklets: Sequence[Tracklet], frame: DiagonalFrame, width_px: float
) -> list[Tracklet]:
    """The tracklets that do not lie on a drawn curve, and those that do but hold another line beside it."""
    lines = [np.column_stack([t.column, t.row]) for t in tracklets]
    taken = _on(curve, lines, [float(np.median(t.width)) for t in tracklets], frame, width_px)
    return [t for t, gone in zip(tracklets, taken, strict=True) if not gone]


def _on(
    curve: Array, lines: Sequence[Array], widths: Sequence[float], frame: DiagonalFrame, width_px: float
) -> NDArray[np.bool_]:
    """Which lines, (n, 2) [column, row] each, lie on a curve for the most part and are no wider than one line."""
    if not lines:
        return np.zeros(0, dtype=np.bool_)
    on_line = max(ON_LINE_PX, ON_LINE * frame.half_breadth_px)
    line = np.column_stack(frame.from_drawing(curve[:, 0], curve[:, 1]))
    points = np.vstack(lines)
    owner = np.repeat(np.arange(len(lines)), [len(other) for other in lines])
    near = KDTree(line).query(points, distance_upper_bound=on_line)[0] < np.inf
    distance, nearest = (np.asarray(found) for found in KDTree(points).query(line, distance_upper_bound=on_line))
    nearest_of = np.bincount(owner[nearest[distance < np.inf]], minlength=len(lines)) * STEP_PX
    length = np.bincount(owner)
    taken = (np.bincount(owner, near) >= SHARE_OF_TRACKLET * length) & (nearest_of >= SHARE_OF_CURVE * length)
    return np.asarray(taken & (np.array(widths) <= ROOM_FOR_ANOTHER * width_px))


def rank_among(curve: Array, others: Sequence[Array], frame: DiagonalFrame) -> int:
    """How many of the other curves lie inside a curve, all as [y, z] in px of the drawing."""
    column, row = _over_columns(curve, frame)
    inside = 0
    for other in others:
        other_column, other_row = _over_columns(other, frame)
        start, stop = max(column[0], other_column[0]), min(column[-1], other_column[-1])
        if stop > start:
            at = np.linspace(start, stop, 80)
            inside += bool(np.mean(np.interp(at, other_column, other_row) - np.interp(at, column, row)) < 0)
        else:
            inside += bool(other_row.mean() < row.mean())
    return inside


def _over_columns(curve: Array, frame: DiagonalFrame) -> tuple[Array, Array]:
    column, row = frame.from_drawing(curve[:, 0], curve[:, 1])
    unique, index = np.unique(column, return_index=True)
    return unique, row[index]
