"""Curves that turn back: smoothed along their own length, closed on the centre line where they end there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.picture.pieces.ridges import Tracklet
from hullform.picture.pieces.turning import Turning
from hullform.picture.tracing.flow import Path

Array = NDArray[np.float64]

AT_CENTRE = 0.08  # of B/2: a contour that heads inboard and ends so near the centre line ends on it
STRETCH = 0.03  # of B/2: that shows where an end heads


@dataclass(frozen=True, eq=False)
class Pieces:
    """All pieces that a path may be made of, numbered as the flow numbers them."""

    along: Sequence[Tracklet]
    turning: Turning

    def winds(self, numbers: Sequence[int]) -> bool:
        """Whether a path leans back anywhere."""
        return max(numbers) >= len(self.along)

    def points(self, number: int) -> tuple[Array, Array]:
        """(column, row) in the frame of a piece, in the order of the walk."""
        if number < len(self.along):
            return self.along[number].column.astype(np.float64), self.along[number].row
        back, number = divmod(number - len(self.along), len(self.turning.pieces))
        column, row = self.turning.points(number)
        return (column[::-1], row[::-1]) if back else (column, row)

    def unused(self, paths: Sequence[Path]) -> list[tuple[Array, Array]]:
        """(column, row) of the pieces that no path takes, of lines that lean back one of both walks."""
        n, m = len(self.along), len(self.turning.pieces)
        taken = {number for path in paths for number in path.tracklets}
        left = [number for number in range(n) if number not in taken]
        seen_on_columns = self.turning.inboard_only
        left += [n + i for i in range(m) if not seen_on_columns[i] and not {n + i, n + m + i} & taken]
        return [self.points(number) for number in left]


def bridged(columns: list[Array], rows: list[Array], weights: list[Array], in_gap: float) -> tuple[Array, Array, Array]:
    """One polyline of steps of about a pixel through several, its gaps filled with points of little weight.

    Args:
        columns, rows, weights: of each piece, in the order of the walk.
        in_gap: weight of the points between pieces.
    """
    column, row, weight = [columns[0]], [rows[0]], [weights[0]]
    for a, b, w in zip(columns[1:], rows[1:], weights[1:], strict=True):
        gap = np.array([a[0] - column[-1][-1], b[0] - row[-1][-1]])
        steps = int(np.hypot(*gap))
        share = np.arange(1, steps) / max(steps, 1)
        column += [column[-1][-1] + share * gap[0], a]
        row += [row[-1][-1] + share * gap[1], b]
        weight += [np.full(len(share), in_gap), w]
    return np.concatenate(column), np.concatenate(row), np.concatenate(weight)


def ends_at_centre(y: Array, size: float) -> bool:
    """Whether a contour comes back to the centre line: its last stretch heads inboard, and ends near it."""
    return bool(y[-1] < AT_CENTRE * size and y[-1] < y[-max(2, min(len(y), int(STRETCH * size)))] - 2.0)


def closed(y: Array, z: Array, size: float) -> tuple[Array, Array]:
    """The contour continued to the centre line, straight on.

    Args:
        y, z: px of the drawing, the end that comes back last.
        size: B/2, px.
    """
    first = -max(2, min(len(y), int(STRETCH * size)))
    inboard, rise = y[first] - y[-1], z[-1] - z[first]
    height = z[-1] + float(np.clip(rise / max(inboard, 1e-6), -1.0, 1.0)) * max(y[-1], 0.0)
    return np.append(np.maximum(y, 0.0), 0.0), np.append(z, height)
