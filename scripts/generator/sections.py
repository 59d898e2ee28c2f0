"""From half-breadths at heights to the curves of a section, keel to deck."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_HEIGHTS = 4000  # at which a section is computed
_POINTS = 500  # of a curve, at even steps of arc length
_CROWDING = 4.0  # heights near the keel lie as t^4: a section may leave the centre line almost level
_SMALL = 0.00125  # of the breadth: no deadwood is thinner, and a stroke so near the centre line lies inside its line


@dataclass(frozen=True)
class Dimensions:
    """Length overall, breadth, depth at side and draught of a generated hull, metres."""

    length_m: float
    breadth_m: float
    depth_m: float
    draught_m: float


class Hull(Protocol):
    """A hull by formula; x from the aft end, positive forward."""

    dimensions: Dimensions

    def sheer(self, x_m: float) -> float:
        """Return the height of the deck edge at x, metres."""

    def section(self, x_m: float) -> list[Array]:
        """Return the curves [y, z] of the section at x, metres, keel to deck; none where there is no hull."""


def curves_of(half_breadth: Callable[[Array], Array], top_m: float, breadth_m: float) -> list[Array]:
    """Return the curves of a section whose half-breadth is a function of height, from z = 0 to its top.

    A run of heights with some half-breadth is one curve, so a bulb below a raked stem gives two. A half-breadth that
    starts abruptly is a flat bottom: the curve then begins on the centre line.
    """
    z = np.linspace(0.0, top_m, _HEIGHTS)
    wet = half_breadth(z) > _SMALL * breadth_m
    edges = np.flatnonzero(np.diff(np.concatenate([[False], wet, [False]]).astype(int)))
    curves = []
    for first, last in edges.reshape(-1, 2):
        low = _edge(half_breadth, z[first - 1], z[first], breadth_m) if first > 0 else float(z[0])
        high = _edge(half_breadth, z[last], z[last - 1], breadth_m) if last < z.size else float(z[-1])
        t = np.linspace(0.0, 1.0, _HEIGHTS) ** _CROWDING
        if last < z.size:  # a closed end above, as of a bulb: crowded at both ends
            t = np.concatenate([0.5 * t, 1.0 - 0.5 * t[-2::-1]])
        heights = low + (high - low) * t
        y = np.maximum(half_breadth(heights), 0.0)
        points = np.column_stack([y, heights])
        if last < z.size:
            points[-1, 0] = 0.0
        points = np.vstack([[0.0, low], points])
        curves.append(evenly(points, _POINTS))
    return curves


def _edge(half_breadth: Callable[[Array], Array], dry: float, wet: float, breadth_m: float) -> float:
    """Bisect for the height where the half-breadth begins; the answer is wet."""
    for _ in range(40):
        middle = 0.5 * (dry + wet)
        if float(half_breadth(np.array([middle]))[0]) > _SMALL * breadth_m:
            wet = middle
        else:
            dry = middle
    return wet


def evenly(line: Array, count: int) -> Array:
    """Return points at even steps of arc length along a polyline; its corners are rounded by half a step."""
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
    at = np.linspace(0.0, arc[-1], count)
    return np.column_stack([np.interp(at, arc, line[:, k]) for k in (0, 1)])
