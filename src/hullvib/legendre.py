"""Trial functions whose second derivatives are Legendre polynomials, on each smooth stretch of a girder.

w_k'' = P_j on one stretch, 0 on the others; the two integrations are done in closed form, with
int P_j = (P_(j+1) - P_(j-1)) / (2 j + 1), so that no high power of x is ever formed and the stiffness matrix of a
uniform girder is the unit matrix. On a smooth girder the set spans the polynomials of degree N + 1. Source: Abramowitz
& Stegun, 22.7.10 and 8.14.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullvib.girder import Girder
from hullvib.quadrature import Quadrature, composite

Array = NDArray[np.float64]

_NEAR = 1e-9  # of the length: a point mass nearer to an end than this sits on it
_SMOOTH = 1e-6  # of the largest value (times L, L^2): a smaller jump of a value (slope, curvature) is a fit's round-off
_PER_STRETCH = 2  # functions a stretch without which one set over the whole length serves as well


@dataclass(frozen=True, eq=False)
class LegendreTrials:
    """Twice integrated Legendre polynomials, counts (stretches,) of them between nodes (stretches + 1,) on 0..1.

    The shear functions are the once integrated polynomials, as many as there are bending functions.
    """

    nodes: Array
    counts: tuple[int, ...]

    @property
    def sizes(self) -> tuple[int, int]:
        return sum(self.counts), sum(self.counts)

    def bending(self, xi: Array, orders: Sequence[int]) -> Array:
        return self._integrals(xi, [2 - order for order in orders])

    def shearing(self, xi: Array, orders: Sequence[int]) -> Array:
        return self._integrals(xi, [1 - order for order in orders])

    def rule(self, breaks: Array, degree: int) -> Quadrature:
        edges = np.union1d(breaks, self.nodes)
        # a node within round-off of a breakpoint is that breakpoint
        edges = edges[np.append(np.diff(edges) > 1e-12, True)]
        edges[0] = 0.0
        return composite(breaks, edges, max(self.counts) + 2 + (degree + 1) // 2)

    def _integrals(self, xi: Array, times: Sequence[int]) -> Array:
        """The orthonormal polynomials integrated 2, 1, 0 times from the aft end, or differentiated (-1)."""
        out = np.zeros((len(times), sum(self.counts), len(xi)))
        home = np.clip(np.searchsorted(self.nodes, xi, side="right") - 1, 0, len(self.counts) - 1)
        first = 0
        for stretch, count in enumerate(self.counts):
            left, right = float(self.nodes[stretch]), float(self.nodes[stretch + 1])
            half = 0.5 * (right - left)
            inside, beyond = home == stretch, home > stretch
            t = (xi[inside] - left) / half - 1.0
            table = _legendre(t, count + 2)
            norm = np.sqrt((np.arange(count) + 0.5) / half)[:, None]
            rows = slice(first, first + count)
            for place, k in enumerate(times):
                out[place, rows, inside] = (_integrated(table, count, k) * (half**k * norm)).T
                if k >= 1:
                    # what leaves the stretch: the area 2 h of the first, and the moments 2 h^2 and -2 h^2 / 3
                    out[place, first, beyond] = 2.0 * half * norm[0, 0]
                if k == 2:
                    out[place, first, beyond] *= xi[beyond] - left - half
                    if count > 1:
                        out[place, first + 1, beyond] = -2.0 / 3.0 * half**2 * norm[1, 0]
            first += count
        return out


def legendre_trials(girder: Girder, functions: int) -> LegendreTrials:
    """`functions` trial functions, shared out among the smooth stretches by length where there are enough for them."""
    nodes = smooth_stretches(girder)
    if functions < _PER_STRETCH * (len(nodes) - 1):
        nodes = np.array([0.0, 1.0])
    widths = np.diff(nodes)
    counts = np.ones(len(widths))
    for _ in range(functions - len(widths)):
        counts[int((widths / counts).argmax())] += 1.0
    return LegendreTrials(nodes, tuple(counts.astype(int).tolist()))


def smooth_stretches(girder: Girder) -> Array:
    """Bounds, as fractions of the length, between which no property has a jump or a kink and no point mass stands."""
    length = girder.length
    widths = np.diff(girder.breaks) / length
    rough = np.zeros(len(widths) - 1, dtype=bool)
    for coefficients in (
        girder.mass_coefficients,
        girder.flexural_rigidity_coefficients,
        girder.shear_rigidity_coefficients,
        girder.rotary_inertia_coefficients,
    ):
        if coefficients is None:
            continue
        limit = _SMOOTH * float(coefficients.max())
        row = coefficients
        for _ in range(3):
            rough |= np.abs(row[1:, 0] - row[:-1, -1]) > limit
            if row.shape[1] == 1:
                break
            row = np.diff(row, axis=1) * ((row.shape[1] - 1) / widths)[:, None]
    bounds = np.concatenate([[0.0], girder.breaks[1:-1][rough] / length, [1.0]])
    at = np.array([p.x_m / length for p in girder.point_masses])
    far = [float(x) for x in at if np.abs(bounds - x).min() > _NEAR]
    return np.unique(np.concatenate([bounds, far]))


def _legendre(t: Array, highest: int) -> Array:
    """P_0 .. P_highest at t (points,), (highest + 1, points)."""
    table = np.empty((highest + 1, len(t)))
    table[0] = 1.0
    table[1] = t
    for n in range(1, highest):
        table[n + 1] = ((2 * n + 1) * t * table[n] - n * table[n - 1]) / (n + 1)
    return table


def _integrated(table: Array, count: int, times: int) -> Array:
    """P_0 .. P_(count - 1) integrated 2, 1 or 0 times from t = -1, or differentiated (times = -1), (count, points)."""
    if times == 0:
        return table[:count]
    j = np.arange(count)[:, None]
    if times == -1:
        out = np.zeros((count, table.shape[1]))
        for n in range(1, count):
            # P_n' = P_(n-2)' + (2 n - 1) P_(n-1)
            out[n] = (2 * n - 1) * table[n - 1] + (out[n - 2] if n > 1 else 0.0)
        return out
    # P_(-1) = -1 gives int P_0 = 1 + t
    once = (table[1:] - np.vstack([-np.ones((1, table.shape[1])), table[:-2]])) / (2 * np.arange(len(table) - 1) + 1)[
        :, None
    ]
    if times == 1:
        return np.asarray(once[:count])
    lower = np.vstack([once[:1], once[: count - 1]])
    twice = (once[1 : count + 1] - lower) / (2 * j + 1)
    # int int P_0 = (1 + t)^2 / 2
    twice[0] = 0.5 * (1.0 + table[1]) ** 2
    return np.asarray(twice)
