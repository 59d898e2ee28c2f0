"""Places for the station numbers: at the curves, clear of every curve and of one another."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# All in sizes of the type but the last: free space round a label; a gap between curves that is as good as any wider
# one; the width and height of a figure; and what the rounding of a box to whole pixels may take.
_CLEARANCE = 0.2
_ROOMY = 2.0
_DIGIT_WIDTH, _FRACTION_WIDTH, _HEIGHT = 0.64, 0.97, 0.80
_ROUNDING_PX = 2.0


@dataclass(frozen=True)
class Label:
    """A station number, its centre in pixels, and the leader from it to its curve where it stands off."""

    text: str
    u: float
    v: float
    leader: Array | None = None


def place_labels(
    curves: list[tuple[str, Array]], sheer: list[Array], margin: NDArray[np.bool_], size: float, seed: int
) -> list[Label]:
    """Return a place for every curve's label.

    Tried in turn: above the curve's upper end; beside the curve, where the seed decides which way along it is looked
    first; at last in a row above the sheer line with a leader. Arguments: the curves' names and points (px, keel to
    deck), the sheer lines, the part of the sheet where no label may stand, the size of the type (px) and the seed.
    """
    random = np.random.default_rng(seed)
    ink = margin.copy()
    for points in [p for _, p in curves] + sheer:
        _mark(ink, points)
    labels = []
    ends = np.array([points[-1] for _, points in curves])
    for number, (text, points) in enumerate(curves):
        wide, high = _extent(text, size)
        others = np.vstack([p[::3] for n, (_, p) in enumerate(curves) if n != number])
        candidates = _beside(points, others, wide, high, size, seed, random)
        alone = np.count_nonzero(np.hypot(*(ends - points[-1]).T) < 0.5 * size) == 1
        if alone:
            above = _above(points[-1], high, size)
            candidates = candidates + above if seed % 2 else above + candidates
        label = next((Label(text, u, v) for u, v in candidates if not _taken(ink, u, v, wide, high, size)), None)
        if label is None:
            label = _with_leader(ink, text, points, wide, high, size)
        labels.append(label)
        rows, columns = _box(label.u, label.v, wide, high, 0.0)
        ink[rows, columns] = True
    return labels


def _extent(text: str, size: float) -> tuple[float, float]:
    return size * sum(_DIGIT_WIDTH if c.isascii() else _FRACTION_WIDTH for c in text), size * _HEIGHT


def _mark(ink: NDArray[np.bool_], points: Array) -> None:
    steps = np.hypot(*np.diff(points, axis=0).T)
    arc = np.concatenate([[0.0], np.cumsum(steps)])
    at = np.arange(0.0, arc[-1], 0.5)
    columns = np.round(np.interp(at, arc, points[:, 0])).astype(int)
    rows = np.round(np.interp(at, arc, points[:, 1])).astype(int)
    ink[np.clip(rows, 0, ink.shape[0] - 1), np.clip(columns, 0, ink.shape[1] - 1)] = True


def _box(u: float, v: float, wide: float, high: float, margin: float) -> tuple[slice, slice]:
    rows = slice(int(v - 0.5 * high - margin), int(v + 0.5 * high + margin) + 2)
    columns = slice(max(int(u - 0.5 * wide - margin), 0), int(u + 0.5 * wide + margin) + 2)
    return rows, columns


def _taken(ink: NDArray[np.bool_], u: float, v: float, wide: float, high: float, size: float) -> bool:
    return bool(ink[_box(u, v, wide, high, _CLEARANCE * size)].any())


def _above(end: Array, high: float, size: float) -> list[tuple[float, float]]:
    return [(float(end[0]), float(end[1] - 0.5 * high - gap * size)) for gap in (0.45, 0.6, 0.75)]


def _beside(
    points: Array, others: Array, wide: float, high: float, size: float, seed: int, random: np.random.Generator
) -> list[tuple[float, float]]:
    """Return places on either side of the curve, first where it runs well clear of all others."""
    indices = np.linspace(0.93, 0.12, 120) * (len(points) - 1)
    if seed:
        indices = np.roll(indices, int(random.integers(len(indices))))
    chosen = indices.astype(int)
    gaps = np.array([np.hypot(*(others - points[n]).T).min() for n in chosen])
    order = np.argsort(-np.minimum(np.round(gaps / size, 1), _ROOMY), kind="stable")
    places = []
    for n in chosen[order]:
        along = points[min(n + 3, len(points) - 1)] - points[max(n - 3, 0)]
        normal = np.array([-along[1], along[0]]) / np.hypot(*along)
        margin = 2.0 * _CLEARANCE * size + _ROUNDING_PX
        reach = 0.5 * (abs(normal[0]) * (wide + margin) + abs(normal[1]) * (high + margin)) + _ROUNDING_PX
        for side in (1.0, -1.0):
            u, v = points[n] + side * reach * normal
            places.append((float(u), float(v)))
    return places


def _with_leader(ink: NDArray[np.bool_], text: str, points: Array, wide: float, high: float, size: float) -> Label:
    end = points[-1]
    for lift in np.arange(1.2, 6.0, 0.3):
        for shift in (0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0):
            u, v = float(end[0] + shift * wide), float(end[1] - lift * size)
            if v > high and not _taken(ink, u, v, wide, high, size):
                return Label(text, u, v, np.array([[u, v + 0.55 * high], end]))
    raise ValueError(f"no room for the number of station {text}; draw fewer stations or a wider sheet")
