"""Cells on a girder's own pieces: where its properties are sampled, and exact integration of what is sampled.

Every breakpoint and every point mass is an edge of a cell, so no rule straddles a jump. A function is known by its
values at the Gauss points of a cell, that is as a polynomial of degree q - 1 on it; its integrals from the aft end are
then polynomials too, and their values at the same points are one matrix product and two running sums.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import ceil, log, sqrt

import numpy as np
from numpy.typing import NDArray

from hullvib import bernstein
from hullvib.girder import Girder
from hullvib.quadrature import gauss

Array = NDArray[np.float64]

_LONGEST = 2.6  # rad of the highest wave in a cell
_MOST_PARTS = 64  # of a cell that is cut for the girder's own waves
_STEEPEST = 4.0  # largest ratio of a rigidity's values in a cell
_SHARP = 1e-9  # of the largest rigidity: an end of the girder below this is sharp, and its moment vanishes there too
_SHORTEST = 1e-11  # of a piece: the narrowest part that is cut in two for its steepness
_NEAR = 1e-12  # of the length: a point mass nearer to a breakpoint than this sits on it
_WAVE_TRUNCATION = 1e-12  # of the energy of the shortest wave; waves half as short leave 1e-16
_POLE_TRUNCATION = 1e-13  # of any energy, in the mean over the girder


@dataclass(frozen=True, eq=False)
class Operators:
    """Integration of the interpolating polynomial on the unit cell, for q Gauss points.

    nodes and weights (q,). Row vectors of q values are multiplied from the right: `once` (q, q) gives the integral
    from 0 at the nodes; `moments` (q, 2) the integral over the cell and the double integral at its end; `twice`
    (q + 2, q) the double integral at the nodes of q values followed by the start value and the start slope.
    """

    nodes: Array
    weights: Array
    once: Array
    moments: Array
    twice: Array
    legendre: Array


@lru_cache(maxsize=32)
def operators(points: int) -> Operators:
    """Integration matrices by way of Legendre series, whose integrals have closed forms (Abramowitz & Stegun 22.7)."""
    nodes, weights = gauss(points)
    vandermonde = np.polynomial.legendre.legvander(2.0 * nodes - 1.0, points + 1)
    # the discrete orthogonality of the Gauss points inverts the Vandermonde matrix
    legendre = vandermonde[:, :points] * (weights[:, None] * (2.0 * np.arange(points) + 1.0))
    first, second = integration(points), integration(points + 1)
    once = legendre @ first @ vandermonde[:, : points + 1].T
    double = legendre @ first @ second @ vandermonde.T
    twice = np.concatenate([double, np.ones((1, points)), nodes[None, :]])
    moments = np.stack([weights, weights * (1.0 - nodes)], axis=1)
    for array in (once, moments, twice, legendre):
        array.flags.writeable = False
    return Operators(nodes, weights, once, moments, twice, np.asarray(legendre, dtype=np.float64))


@lru_cache(maxsize=64)
def integration(size: int) -> Array:
    """Matrix from the Legendre coefficients of f on 0..1 to those of its integral from 0, (size, size + 1)."""
    matrix = np.zeros((size, size + 1))
    matrix[0, :2] = 0.5
    for k in range(1, size):
        matrix[k, k + 1] = 0.5 / (2.0 * k + 1.0)
        matrix[k, k - 1] = -0.5 / (2.0 * k + 1.0)
    matrix.flags.writeable = False
    return matrix


@dataclass(frozen=True, eq=False)
class Cells:
    """A girder's properties at the Gauss points of its cells, non-dimensional.

    Lengths in L, masses in the total mass, rigidities in the largest Bernstein coefficient of EI, shear rigidities in
    that over L^2. edges (cells + 1,); piece (cells,) is the piece that holds a cell, None where the
    cells are the pieces; widths (cells, 1); xi, mass, rigidity and shear (cells, q); lumps (cells + 1,)
    are the point masses at the edges, None where there are none; unit_frequency in rad/s, total_mass in kg.
    """

    girder: Girder
    edges: Array
    piece: NDArray[np.intp] | None
    widths: Array
    xi: Array
    mass: Array
    rigidity: Array
    shear: Array | None
    lumps: Array | None
    operators: Operators
    unit_frequency: float
    total_mass: float


def girder_cells(girder: Girder, wave_number: float, *, shear: bool = False) -> Cells:
    """Cells that carry waves up to wave_number (by x/L), with Gauss points for an energy good to round-off."""
    mass, length = girder.mass_coefficients, girder.length
    flexibilities = [girder.flexural_rigidity_coefficients]
    if shear and girder.shear_rigidity_coefficients is not None:
        flexibilities.append(girder.shear_rigidity_coefficients)
    breaks = girder.breaks / length
    positions = np.array([p.x_m for p in girder.point_masses]) / length
    edges, piece, steepest = _edges(breaks, positions, flexibilities, wave_number)
    degree = max(mass.shape[1], *(c.shape[1] for c in flexibilities)) - 1
    points = _points(edges[1:] - edges[:-1], wave_number, steepest) + max(degree - 1, 0) // 2
    return _sampled(girder, edges, piece, operators(points), len(flexibilities) == 2)


def refined_cells(cells: Cells, eigenvalue: float) -> Cells | None:
    """Cells cut where the girder's own wave of an eigenvalue is longer in phase than a cell carries; None: nowhere.

    The phase over a cell is the integral of (lambda m / EI)^(1/4), and of (lambda m / kGA)^(1/2) beside it.
    """
    ratio = cells.mass / cells.rigidity
    if cells.shear is None and eigenvalue * float(ratio.max()) * float(cells.widths.max()) ** 4 <= _LONGEST**4:
        return None
    phase = np.sqrt(np.sqrt(eigenvalue * ratio)) @ cells.operators.weights * cells.widths[:, 0]
    if cells.shear is not None:
        shear = np.sqrt(eigenvalue * cells.mass / cells.shear) @ cells.operators.weights
        phase += np.minimum(shear * cells.widths[:, 0], _MOST_PARTS * _LONGEST)
    if not phase.max() > _LONGEST:
        return None
    counts = np.clip(np.ceil(phase / _LONGEST), 1.0, _MOST_PARTS).astype(np.intp)
    edges, cell = _divided(cells.edges, counts)
    piece = cell if cells.piece is None else cells.piece[cell]
    # enough for the phase of a cell and for a pole as near as any is left
    points = max(len(cells.operators.nodes), _points(np.ones(1), _LONGEST, np.array([_STEEPEST])))
    return _sampled(cells.girder, edges, piece, operators(points), cells.shear is not None)


def _sampled(girder: Girder, edges: Array, piece: NDArray[np.intp] | None, rule: Operators, with_shear: bool) -> Cells:
    length, total = girder.length, girder.total_mass
    breaks, largest = girder.breaks / length, float(girder.flexural_rigidity_coefficients.max())
    widths = edges[1:] - edges[:-1]
    lumps = None
    if girder.point_masses:
        lumps = np.zeros(len(edges))
        positions = np.array([p.x_m for p in girder.point_masses]) / length
        place = np.abs(edges[:, None] - positions).argmin(axis=0)
        np.add.at(lumps, place, [p.mass_kg / total for p in girder.point_masses])
    shear = None
    if with_shear and girder.shear_rigidity_coefficients is not None:
        relative = girder.shear_rigidity_coefficients * (length**2 / largest)
        shear = _at_nodes(relative, breaks, edges, piece, rule)
    return Cells(
        girder,
        edges,
        piece,
        widths[:, None],
        edges[:-1, None] + widths[:, None] * rule.nodes,
        _at_nodes(girder.mass_coefficients * (length / total), breaks, edges, piece, rule),
        _at_nodes(girder.flexural_rigidity_coefficients * (1.0 / largest), breaks, edges, piece, rule),
        shear,
        lumps,
        rule,
        sqrt(largest / (total * length**3)),
        total,
    )


def _at_nodes(
    coefficients: Array, breaks: Array, edges: Array, piece: NDArray[np.intp] | None, rule: Operators
) -> Array:
    """Values of a property, Bernstein coefficients (pieces, n + 1), at the nodes of every cell, (cells, q)."""
    if piece is None:
        return np.asarray(coefficients @ _bernstein_matrix(coefficients.shape[1] - 1, len(rule.nodes)))
    left, width = breaks[piece], breaks[piece + 1] - breaks[piece]
    start, share = (edges[:-1] - left) / width, (edges[1:] - edges[:-1]) / width
    t = np.clip(start[:, None] + share[:, None] * rule.nodes, 0.0, 1.0)
    return bernstein.evaluate(coefficients[piece][:, None, :], t)


@lru_cache(maxsize=64)
def _bernstein_matrix(degree: int, points: int) -> Array:
    return np.ascontiguousarray(bernstein.collocation(degree, gauss(points)[0]).T)


def _edges(
    breaks: Array, positions: Array, flexibilities: list[Array], wave_number: float
) -> tuple[Array, NDArray[np.intp] | None, Array]:
    """Edges of the cells on 0..1, the piece that holds each (None: they are the pieces), and its steepness.

    The steepness is the largest ratio of the extreme Bernstein coefficients of a rigidity, 1 at sharp ends.
    """
    widths = breaks[1:] - breaks[:-1]
    steepness = _steepness(flexibilities)
    parts = np.ceil(widths * (wave_number / _LONGEST))
    if len(positions) == 0 and parts.max() <= 1.0 and steepness.max() <= _STEEPEST:
        return breaks, None, steepness
    edges = breaks
    last = len(widths) - 1
    for piece in np.flatnonzero(steepness > _STEEPEST):
        cuts = _gentle_cuts([c[piece] for c in flexibilities], bool(piece == 0), bool(piece == last))
        edges = np.append(edges, breaks[piece] + widths[piece] * cuts)
    if len(positions):
        edges = np.append(edges, positions[np.abs(positions[:, None] - breaks).min(axis=1) > _NEAR])
    edges = np.unique(edges)
    edges = edges[np.append(True, np.diff(edges) > _NEAR)]
    edges[-1] = 1.0
    widths = np.diff(edges)
    counts = np.maximum(np.ceil(widths * (wave_number / _LONGEST)), 1.0).astype(np.intp)
    edges, _ = _divided(edges, counts)
    holder = np.searchsorted(breaks, 0.5 * (edges[:-1] + edges[1:]), side="right") - 1
    return edges, holder, np.minimum(steepness[holder], _STEEPEST)


def _divided(edges: Array, counts: NDArray[np.intp]) -> tuple[Array, NDArray[np.intp]]:
    """Edges on 0..1 with every cell in `counts` equal parts, and the cell that each part comes from."""
    cell = np.repeat(np.arange(len(counts)), counts)
    within = np.arange(len(cell)) - np.repeat(np.cumsum(counts) - counts, counts)
    return np.append(edges[:-1][cell] + (np.diff(edges) / counts)[cell] * within, 1.0), cell


def stack_edges(breaks: Array, positions: Array, rigidity: Array, wave_number: float) -> tuple[Array, int]:
    """Edges of cells on 0..1 that suit every girder of a stack, rigidity (girders, pieces, n + 1), and Gauss points.

    What is steep in any girder is cut from both sides, as lines of the largest ratio would need it; where coefficients
    of a girder's piece vanish or are negative it is cut as that girder needs it, too.
    """
    low, high = rigidity.min(axis=2), rigidity.max(axis=2)
    dipping = low <= _SHARP * high.max(axis=1, keepdims=True)
    ratio = np.divide(high, low, out=np.ones_like(high), where=~dipping).max(axis=0)
    lines = np.stack([np.ones_like(ratio), ratio], axis=1) / ratio[:, None]
    own = list(rigidity[dipping.any(axis=1)])
    edges, _, steepest = _edges(breaks, positions, [lines, lines[:, ::-1], *own], wave_number)
    return edges, _points(np.diff(edges), wave_number, steepest)


def _steepness(flexibilities: list[Array], aft: bool = True, fore: bool = True) -> Array:
    """Largest ratio of the extreme coefficients (pieces, n + 1) of a piece; infinite where one is not positive.

    It is 1 where a rigidity runs out at an end of the girder, to which the first piece reaches with `aft` and the last
    with `fore`.
    """
    worst = np.ones(len(flexibilities[0]))
    for coefficients in flexibilities:
        low, high = coefficients.min(axis=1), coefficients.max(axis=1)
        ratio = np.divide(high, low, out=np.full_like(high, np.inf), where=low > 0.0)
        floor = _SHARP * float(high.max())
        if (aft and coefficients[0, 0] <= floor) or (fore and coefficients[-1, -1] <= floor):
            for piece, ends in ((0, (aft, False)), (-1, (False, fore))):
                row = coefficients[piece]
                ends = (aft, fore) if len(coefficients) == 1 else ends
                above = np.flatnonzero(row > floor)
                if not len(above):
                    continue
                first = above[0] if ends[0] else 0
                last = above[-1] if ends[1] else len(row) - 1
                # what is left of the sharp end is gentle by itself: moment and rigidity vanish together
                if (first > 0 or last < len(row) - 1) and row[first : last + 1].min() > floor:
                    ratio[piece] = 1.0
        worst = np.maximum(worst, ratio)
    return worst


def _gentle_cuts(rows: list[Array], aft: bool, fore: bool) -> Array:
    """Positions on the unit interval that cut polynomials (Bernstein rows) into parts of gentle slope, by halving.

    aft and fore: the interval begins, ends with the girder.
    """
    cuts: list[float] = []
    waiting = [(0.0, 1.0, rows)]
    while waiting:
        left, right, parts = waiting.pop()
        ends = (aft and left == 0.0, fore and right == 1.0)
        if right - left < _SHORTEST or float(_steepness([part[None, :] for part in parts], *ends)[0]) <= _STEEPEST:
            continue
        middle = 0.5 * (left + right)
        halves = [bernstein.split(part, 0.5) for part in parts]
        cuts.append(middle)
        waiting += [(left, middle, [half[0] for half in halves]), (middle, right, [half[1] for half in halves])]
    return np.array(cuts)


def _points(widths: Array, wave_number: float, steepness: Array) -> int:
    """Gauss points a cell, 2 to 16, that leave an energy good to round-off.

    On a cell with the phase p, q points interpolate a wave up to (p/4)^q / q!, and 1/EI, whose pole lies where a line
    through the extremes r, 1 has its zero, up to y^q with y = (sqrt(r) - 1) / (sqrt(r) + 1) (L. N. Trefethen,
    Approximation Theory and Approximation Practice, theorem 8.2). The energy errs by the squares, in the mean over
    the cells.
    """
    root = np.sqrt(steepness)
    pole = (root - 1.0) / (root + 1.0)
    worst = float(pole.max())
    phase = 0.25 * wave_number * float(widths.max())
    enough = 2 if worst < 1e-4 else ceil(log(_POLE_TRUNCATION) / (2.0 * log(worst)))
    points, wave = 2, 0.5 * phase**2
    while wave**2 > _WAVE_TRUNCATION:
        points += 1
        wave *= phase / points
    if enough <= points:
        return min(points, 16)
    while points < min(enough, 16) and float(widths @ pole ** (2 * points)) > _POLE_TRUNCATION:
        points += 1
    return points
