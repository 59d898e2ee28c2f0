"""A beam of uniform parts that is nowhere stiffer and nowhere lighter than a girder: its eigenvalues lie below.

The number of eigenvalues of such a beam below a trial value is exact: the signs of its dynamic stiffness matrix count
them (W. H. Wittrick and F. W. Williams, Quart. J. Mech. Appl. Math. 24 (1971) 263-284), as the parts are so short
that none vibrates between clamped ends, and by the monotony principle the girder has no more of them there.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import factorial

import numpy as np
from numpy.typing import NDArray

from hullvib import bernstein
from hullvib.girder import Girder

Array = NDArray[np.float64]

_LONGEST = 2.0  # largest (lambda m / EI)^(1/4) h of a part; clamped ends vibrate from 4.73 on
_SERIES = 0.7  # below it the closed forms lose more than three digits; the series' terms fall by (0.7 / 4.73)^4
_TERMS = 7
_ROUND_OFF = 1e-12  # relative, on the safe side of the properties' evaluation
_ROUNDING = 1e-13  # of the absolute terms that an entry is the sum of: hundreds of additions, each good to 1e-16
_NEAR = 1e-9  # of the length: point masses nearer to an edge sit on it; the count's distance from rho covers that


@dataclass(frozen=True, eq=False)
class ComparisonBeam:
    """Uniform parts: widths (parts,) in L, mass (parts,), rigidity (parts,), and lumps (parts + 1,) at their ends.

    Masses in the girder's total, rigidities in its largest coefficient of EI.
    """

    widths: Array
    mass: Array
    rigidity: Array
    lumps: Array

    def count_below(self, eigenvalue: float) -> int | None:
        """Number of eigenvalues below, the two rigid-body ones included; None where a pivot's sign is not sure."""
        diagonal, coupling = self._stiffness(eigenvalue)
        size = np.abs(diagonal)[:, (0, 1), (0, 1)]
        count = 0
        # odd-even elimination: the inertia of a symmetric matrix is that of its pivots and of the Schur complement
        while True:
            nodes = len(diagonal)
            pivots, of_pivots = (diagonal[1::2], size[1::2]) if nodes > 1 else (diagonal, size)
            determinant = pivots[:, 0, 0] * pivots[:, 1, 1] - pivots[:, 0, 1] ** 2
            rounding = _ROUNDING * of_pivots
            doubt = rounding[:, 0] * np.abs(pivots[:, 1, 1]) + rounding[:, 1] * np.abs(pivots[:, 0, 0])
            doubt += 2.0 * np.abs(pivots[:, 0, 1]) * np.sqrt(rounding[:, 0] * rounding[:, 1])
            if bool(np.any(np.abs(determinant) <= doubt + rounding[:, 0] * rounding[:, 1])):
                return None
            trace = pivots[:, 0, 0] + pivots[:, 1, 1]
            count += int((determinant < 0.0).sum()) + 2 * int(((determinant > 0.0) & (trace < 0.0)).sum())
            if nodes == 1:
                return count
            inverse = np.empty_like(pivots)
            inverse[:, 0, 0], inverse[:, 1, 1] = pivots[:, 1, 1], pivots[:, 0, 0]
            inverse[:, 0, 1] = inverse[:, 1, 0] = -pivots[:, 0, 1]
            inverse /= determinant[:, None, None]
            aft, fore = coupling[0::2], coupling[1::2]
            through = aft @ inverse
            to_aft = through @ aft.transpose(0, 2, 1)
            to_fore = fore.transpose(0, 2, 1) @ inverse[: len(fore)] @ fore
            kept, size = diagonal[0::2].copy(), size[0::2].copy()
            kept[: len(aft)] -= to_aft
            kept[1 : len(fore) + 1] -= to_fore
            size[: len(aft)] += np.abs(to_aft)[:, (0, 1), (0, 1)]
            size[1 : len(fore) + 1] += np.abs(to_fore)[:, (0, 1), (0, 1)]
            diagonal, coupling = kept, -(through[: len(fore)] @ fore)

    def _stiffness(self, eigenvalue: float) -> tuple[Array, Array]:
        """Block-tridiagonal dynamic stiffness: diagonal (parts + 1, 2, 2) and coupling (parts, 2, 2)."""
        h = self.widths
        x = eigenvalue * self.mass * h**4 / self.rigidity
        shear, moment, carry_shear, carry_moment, turn, carry_turn = _functions(x)
        unit = self.rigidity / h
        shear, carry_shear = shear * unit / h**2, carry_shear * unit / h**2
        moment, carry_moment = moment * unit / h, carry_moment * unit / h
        turn, carry_turn = turn * unit, carry_turn * unit
        diagonal = np.zeros((len(h) + 1, 2, 2))
        diagonal[:, 0, 0] = -eigenvalue * self.lumps
        for part, sign in ((slice(None, -1), 1.0), (slice(1, None), -1.0)):
            diagonal[part, 0, 0] += shear
            diagonal[part, 0, 1] += sign * moment
            diagonal[part, 1, 0] += sign * moment
            diagonal[part, 1, 1] += turn
        coupling = np.empty((len(h), 2, 2))
        coupling[:, 0, 0], coupling[:, 0, 1] = carry_shear, carry_moment
        coupling[:, 1, 0], coupling[:, 1, 1] = -carry_moment, carry_turn
        return diagonal, coupling


def comparison_beam(girder: Girder, eigenvalue: float, variation: float, shortest: float) -> ComparisonBeam | None:
    """Parts over which m and EI vary by about `variation` of themselves; pieces shorter than `shortest` are merged.

    Bounds are the extreme Bernstein coefficients on each part. None where those of EI do not stay positive.
    """
    length, total = girder.length, girder.total_mass
    mass = girder.mass_coefficients * (length / total)
    rigidity = girder.flexural_rigidity_coefficients / float(girder.flexural_rigidity_coefficients.max())
    edges, most, least = _parts(girder.breaks / length, mass, rigidity, eigenvalue, variation)
    positions = np.array([p.x_m for p in girder.point_masses]) / length
    if len(positions):
        nearest = edges[np.abs(edges[:, None] - positions).argmin(axis=0)]
        positions = np.where(np.abs(nearest - positions) <= _NEAR, nearest, positions)
        positions = positions[np.argsort(positions)]
        for i in np.flatnonzero(np.diff(positions) <= _NEAR):
            positions[i + 1] = positions[i]
        cell = np.clip(np.searchsorted(edges, positions, side="right") - 1, 0, len(most) - 1)
        inside = positions[(positions > edges[cell]) & (positions < edges[cell + 1])]
        all_edges = np.union1d(edges, inside)
        cell = np.searchsorted(edges, 0.5 * (all_edges[1:] + all_edges[:-1]), side="right") - 1
        edges, most, least = all_edges, most[cell], least[cell]
    kept = _kept_edges(edges, positions, shortest)
    starts = np.flatnonzero(kept[:-1])
    most, least = np.maximum.reduceat(most, starts), np.minimum.reduceat(least, starts)
    edges = edges[kept]
    if not float(least.min()) > 0.0:
        return None
    lumps = np.zeros(len(edges))
    np.add.at(lumps, np.searchsorted(edges, positions), [p.mass_kg / total for p in girder.point_masses])
    beam = (np.maximum(most, 0.0) * (1.0 + _ROUND_OFF), least * (1.0 - _ROUND_OFF))
    widths = np.diff(edges)
    if float((eigenvalue * beam[0] / beam[1] * widths**4).max()) > _LONGEST**4:
        return None
    return ComparisonBeam(widths, *beam, lumps * (1.0 + _ROUND_OFF))


def _parts(
    breaks: Array, mass: Array, rigidity: Array, eigenvalue: float, variation: float
) -> tuple[Array, Array, Array]:
    """Edges of the parts, the largest mass and the smallest rigidity on each."""
    widths = np.diff(breaks)
    floor = 0.2  # of the mean mass: what little mass there is need not be known well
    heavy, light = mass.max(axis=1), mass.min(axis=1)
    stiff, soft = rigidity.max(axis=1), rigidity.min(axis=1)
    uneven = np.maximum((heavy - light) / np.maximum(heavy, floor), (stiff - soft) / np.maximum(stiff, 1e-300))
    # a steep fall of EI is shared out by its logarithm
    steep = np.log(np.maximum(stiff, 1e-300) / np.maximum(soft, 1e-3 * stiff))
    wave = (eigenvalue * heavy / np.maximum(soft, 1e-3 * stiff)) ** 0.25 * widths
    counts = np.ceil(np.maximum(np.maximum(uneven, steep) / variation, wave / (0.75 * _LONGEST)))
    counts = np.clip(counts, 1.0, 64.0 / variation).astype(np.intp)
    order, left, most, least = [], [], [], []
    for count in np.unique(counts):
        pieces = np.flatnonzero(counts == count)
        rest_m, rest_e = mass[pieces], rigidity[pieces]
        for part in range(count):
            here_m, here_e = rest_m, rest_e
            if part < count - 1:
                here_m, rest_m = bernstein.split(rest_m, 1.0 / (count - part))
                here_e, rest_e = bernstein.split(rest_e, 1.0 / (count - part))
            order.append(pieces)
            left.append(breaks[pieces] + widths[pieces] * (part / count))
            most.append(here_m.max(axis=1))
            least.append(here_e.min(axis=1))
    edges = np.concatenate(left)
    place = np.argsort(edges, kind="stable")
    return np.append(edges[place], 1.0), np.concatenate(most)[place], np.concatenate(least)[place]


def _kept_edges(edges: Array, positions: Array, shortest: float) -> NDArray[np.bool_]:
    """Edges that stay when neighbouring parts shorter than `shortest` are merged; point masses keep theirs."""
    short = np.diff(edges) < shortest
    kept = np.ones(len(edges), dtype=np.bool_)
    bins = np.floor(edges / shortest)
    kept[1:-1] = ~(short[:-1] & short[1:]) | (bins[1:-1] != bins[:-2])
    kept[np.searchsorted(edges, positions)] = True
    return kept


def _functions(x: Array) -> tuple[Array, ...]:
    """The six dynamic stiffness functions of x = k^4, k = (lambda m / EI)^(1/4) h, in EI/h^3, EI/h^2 and EI/h.

    In the order shear, moment and turn at the near end and carried over: 12, 6, -12, 6, 4, 2 at x = 0.
    """
    k = np.sqrt(np.sqrt(x))
    c, s = np.cos(k), np.sin(k)
    ch, sh = np.cosh(k), np.sinh(k)
    small = k < _SERIES
    fraction = 1.0 / np.where(small, 1.0, 1.0 - c * ch)
    exact = (
        k**3 * (s * ch + c * sh) * fraction,
        k**2 * s * sh * fraction,
        -(k**3) * (s + sh) * fraction,
        k**2 * (ch - c) * fraction,
        k * (s * ch - c * sh) * fraction,
        k * (sh - s) * fraction,
    )
    powers = np.where(small, x, 0.0) ** np.arange(_TERMS)[:, None]
    near = _series() @ powers
    return tuple(np.where(small, series, closed) for series, closed in zip(near, exact, strict=True))


@lru_cache(maxsize=1)
def _series() -> Array:
    """Power series of the six functions in x = k^4, (6, terms), by exact division of those of their closed forms."""
    from fractions import Fraction

    size = 4 * _TERMS + 12

    def circular(parity: int, sign: int) -> list[Fraction]:
        return [Fraction(sign ** (n // 2), factorial(n)) if n % 2 == parity else Fraction(0) for n in range(size)]

    def times(a: list[Fraction], b: list[Fraction]) -> list[Fraction]:
        return [sum((a[i] * b[n - i] for i in range(n + 1)), Fraction(0)) for n in range(size)]

    def combined(a: list[Fraction], b: list[Fraction], sign: int) -> list[Fraction]:
        return [p + sign * q for p, q in zip(a, b, strict=True)]

    c, s, ch, sh = circular(0, -1), circular(1, -1), circular(0, 1), circular(1, 1)
    one = [Fraction(int(n == 0)) for n in range(size)]
    below = combined(one, times(c, ch), -1)[4::4]
    tops = (
        (3, combined(times(s, ch), times(c, sh), 1)),
        (2, times(s, sh)),
        (3, [-value for value in combined(s, sh, 1)]),
        (2, combined(ch, c, -1)),
        (1, combined(times(s, ch), times(c, sh), -1)),
        (1, combined(sh, s, -1)),
    )
    rows = []
    for power, top in tops:
        above = top[4 - power :: 4]
        row: list[Fraction] = []
        for n in range(_TERMS):
            row.append((above[n] - sum((row[i] * below[n - i] for i in range(n)), Fraction(0))) / below[0])
        rows.append([float(value) for value in row])
    return np.array(rows)
