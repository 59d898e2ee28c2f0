"""Paths that touch and part again: stations lie inside one another, so what touches does not cross.

Where two lines run together for a while the flow may leave by either branch at the same cost. Lines that meet at an
angle do cross, as the sections of a transom stern or of a tunnel may.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np
from numpy.typing import NDArray

from hullform.picture.edits.line_edits import Place, end_of, start_of
from hullform.picture.pieces.ridges import Tracklet
from hullform.picture.tracing.flow import Path

Array = NDArray[np.float64]

TOUCHING = 1.5  # of a line's thickness between the axes: ink without paper between
LONGEST_CROSSING = 10.0  # of a line's thickness: lines that cross at 15 degrees touch for so long


def uncrossed(
    paths: Sequence[Path],
    tracklets: Sequence[Tracklet],
    width_px: float,
    made: Collection[tuple[Place, Place]] = (),
) -> list[Path]:
    """The paths, their outer parts exchanged where two of them change sides along a shallow touch.

    Args:
        paths: of one half.
        tracklets: that they consist of; a path that takes other pieces too, which lean back, is left as it is.
        width_px: thickness of one line.
        made: links between tracklets that a person made; over these, paths stay as they are.
    """
    out = list(paths)
    ordinary = [number for number, path in enumerate(out) if max(path.tracklets) < len(tracklets)]
    for first, second in combinations(ordinary, 2):
        links = [link for path in (out[first], out[second]) for link in _links(path, tracklets) if link in made]
        for start, stop in _shallow_crossings(out[first], out[second], tracklets, width_px):
            if not any(before[0] <= stop and after[0] >= start for before, after in links):
                out[first], out[second] = _exchanged(out[first], out[second], tracklets, (start + stop) / 2)
    return out


def _shallow_crossings(a: Path, b: Path, tracklets: Sequence[Tracklet], width_px: float) -> list[tuple[float, float]]:
    """First and last column of the touches along which two paths change sides."""
    (column_a, row_a), (column_b, row_b) = _points(a, tracklets), _points(b, tracklets)
    start, stop = max(column_a[0], column_b[0]), min(column_a[-1], column_b[-1])
    if stop - start < LONGEST_CROSSING * width_px:
        return []
    column = np.arange(start, stop + 1)
    apart = np.interp(column, column_a, row_a) - np.interp(column, column_b, row_b)
    clear = np.flatnonzero(np.abs(apart) > TOUCHING * width_px)
    sides = np.sign(apart[clear])
    turns = np.flatnonzero((sides[1:] != sides[:-1]) & (np.diff(clear) > LONGEST_CROSSING * width_px))
    return [(float(column[clear[turn]]), float(column[clear[turn + 1]])) for turn in turns]


def _links(path: Path, tracklets: Sequence[Tracklet]) -> list[tuple[Place, Place]]:
    return [(end_of(tracklets[a]), start_of(tracklets[b])) for a, b in pairwise(path.tracklets)]


def _points(path: Path, tracklets: Sequence[Tracklet]) -> tuple[Array, Array]:
    column = np.concatenate([tracklets[i].column for i in path.tracklets]).astype(np.float64)
    unique, index = np.unique(column, return_index=True)
    return unique, np.concatenate([tracklets[i].row for i in path.tracklets])[index]


def _exchanged(a: Path, b: Path, tracklets: Sequence[Tracklet], column: float) -> tuple[Path, Path]:
    def parts(path: Path) -> tuple[tuple[int, ...], tuple[int, ...]]:
        outer = [float(tracklets[i].column.mean()) > column for i in path.tracklets]
        first = outer.index(True) if any(outer) else len(outer)
        return path.tracklets[:first], path.tracklets[first:]

    (inner_a, outer_a), (inner_b, outer_b) = parts(a), parts(b)
    if not (inner_a and inner_b and outer_a and outer_b):
        return a, b
    return replace(a, tracklets=inner_a + outer_b), replace(b, tracklets=inner_b + outer_a)
