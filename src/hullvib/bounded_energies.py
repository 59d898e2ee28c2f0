"""The energies that bounds are made of, each with a bound of its own error, summed in extended precision.

The curvature of every function is a polynomial on each cell; A2 and A3 are integrals of polynomials and exact but for
rounding, of A4 the truncation of Gauss's rule is bounded in the complex plane, and rounding is bounded a priori.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from hullvib.cells import Cells
from hullvib.errors import NotProven
from hullvib.long_rule import LongOperators, long_operators
from hullvib.stodola_field import StodolaField

Array = NDArray[np.float64]
Long = NDArray[np.longdouble]

_LONG_EPS = float(np.finfo(np.longdouble).eps)
_SAME_PLACE = 4.0 * float(np.finfo(np.float64).eps)  # of the length: what rounding moves an edge by
_RADII = (4.0, 3.0, 2.5, 2.0, 1.75, 1.5, 1.35, 1.25)  # of ellipses about a cell in which EI must not vanish


@dataclass(frozen=True, eq=False)
class BoundedEnergies:
    """A2, A3, A4 (n, n) and, for each, a diagonal (n,) that bounds its error as a quadratic form."""

    bending: Long
    kinetic: Long
    complementary: Long
    margins: tuple[Long, Long, Long]


def bounded_energies(field: StodolaField, count: int) -> BoundedEnergies:
    """The energies of the first `count` functions on a rule that is exact for all polynomials in them.

    The curvature of u is the polynomial on every cell of the field whose Legendre coefficients are the numbers that the
    field gives; the deflection is its exact double integral. Where the field's cells miss a breakpoint or a point mass,
    by round-off or by a snap, cells are cut there, so that the girder is the one given and no other.

    u has the degree q + 1 on a cell, m u with m of degree d has q + 1 + d and w has q + 3 + d, so that q + 3 + d Gauss
    points integrate the load, A2 and A3 exactly. Further points serve w w / EI: on an ellipse with the sum of half
    axes r about a cell of width h, with |w| <= W on the cell and |EI| >= E in the ellipse, p points err by at most
    (h/2) (64/15) (W^2 / E) r^(-2 p) / (1 - r^-2) (L. N. Trefethen, Approximation Theory and Approximation Practice,
    theorem 19.3), where |w| <= W is meant in the ellipse and comes from the Legendre series of w.

    Rounding: the running sums over C cells and p points err by (C + 4 p) eps of the sum of the absolute terms, which
    the integrals of |EI^-1 M|, by the absolute Legendre coefficients, and of m |u| bound; the sums of the energies by
    their number of terms times eps.
    """
    coarse = field.ladder.cells
    girder, terms = coarse.girder, len(coarse.operators.nodes)
    mass_degree = girder.mass_coefficients.shape[1] - 1
    rigidity_degree = girder.flexural_rigidity_coefficients.shape[1] - 1
    place = _exact_places(coarse)
    rigidity = girder.flexural_rigidity_coefficients / np.longdouble(girder.flexural_rigidity_coefficients.max())
    mass = girder.mass_coefficients * (np.longdouble(girder.length) / np.longdouble(coarse.total_mass))
    radius, floor = _clear_ellipse(place, rigidity)
    # r^(-2 extra) of 1e-18, and rounding is the larger part
    extra = max(2, int(np.ceil(18.0 * np.log(10.0) / (2.0 * np.log(radius)))))
    number = terms + 3 + max(mass_degree, rigidity_degree) + extra
    rule = long_operators(number)
    t = place.start[:, None] + place.share[:, None] * rule.nodes
    rigid, inertial = (_polynomials(rows[place.piece], t).ravel() for rows in (rigidity, mass))
    weights = (place.widths[:, None] * rule.weights).ravel()
    flexibility, inertia = weights / rigid, inertial * weights
    # curvatures at the points: of the series on the field's cells, seen from the cells here
    series = (field.deflection.local[:count, :, :-2] @ coarse.operators.legendre).astype(np.longdouble)
    series = series[:, place.parent] / place.parent_widths[:, None] ** 2
    inside = place.parent_start[:, None] + place.parent_share[:, None] * rule.nodes
    basis = np.polynomial.legendre.legvander(2.0 * inside - 1.0, terms - 1)
    curvatures = np.einsum("ncq,cpq->ncp", series, basis)
    functions, at_edges = _integrated_twice(curvatures, place.widths, rule, None)
    lumps = place.lumps
    # without rigid part
    xi = (place.edges[:-1, None] + place.widths[:, None] * rule.nodes).ravel()
    total, first = inertia.sum() + lumps.sum(), inertia @ xi + lumps @ place.edges
    arm, arms = xi - first / total, place.edges - first / total
    pitch = inertia @ arm**2 + lumps @ arms**2
    heaved = (functions @ inertia + at_edges @ lumps) / total
    turned = (functions @ (inertia * arm) + at_edges @ (lumps * arms)) / pitch
    functions -= heaved[:, None] + turned[:, None] * arm
    at_edges -= heaved[:, None] + turned[:, None] * arms
    loads = (functions * inertial).reshape(curvatures.shape)
    moments, _ = _integrated_twice(loads, place.widths, rule, at_edges * lumps)
    flat = curvatures.reshape(count, -1)
    bending = (flat * (rigid * weights)) @ flat.T
    kinetic = (functions * inertia) @ functions.T + (at_edges * lumps) @ at_edges.T
    complementary = (moments * flexibility) @ moments.T
    # truncation of A4, cell by cell: |P_k| <= r^k on the ellipse bounds the Legendre series of w there
    powers = np.abs(moments.reshape(curvatures.shape) @ rule.legendre)
    outside = powers @ np.longdouble(radius) ** (np.arange(number) - number)
    truncation = (64.0 / 30.0) / (1.0 - radius**-2.0) * (outside**2 @ (place.widths / floor))
    # rounding, relative, of the functions
    rounding = _LONG_EPS * (len(place.edges) + 4 * number)
    load = np.abs(functions) @ inertia + np.abs(at_edges) @ lumps
    steepest = np.abs(series).sum(axis=2)
    bent = steepest @ place.widths
    of_curvature = _LONG_EPS * (terms + 20) * np.sqrt(steepest**2 @ (rigid * weights).reshape(t.shape).sum(axis=1))
    soft = np.sqrt(flexibility.sum())
    of_deflection = rounding * bent / np.sqrt(kinetic.diagonal())
    moved = rounding * (load + bent)
    of_moment = moved * soft / np.sqrt(complementary.diagonal())
    of_sum = _LONG_EPS * (weights.size + 20)
    margins = (
        _margin(bending, of_curvature / np.sqrt(bending.diagonal()), of_sum),
        _margin(kinetic, of_deflection, of_sum),
        _margin(complementary, of_moment, of_sum) + count * truncation,
    )
    return BoundedEnergies(bending, kinetic, complementary, margins)


def _margin(energy: Long, error: Long, of_sum: float) -> Long:
    """Diagonal that bounds, as a quadratic form, the error of an energy whose functions err by `error` of their size.

    With s_i^2 = A_ii the entries err by (e_i + e_j + e_i e_j + e_sum) s_i s_j; by x y <= (t x x + y y / t) / 2 with
    t = (e_i / e_j)^(1/2) the functions with little error keep most of that.
    """
    error = error + of_sum
    pairs = error[:, None] + error + error[:, None] * error
    return np.asarray((pairs * np.sqrt(error[:, None] / error)).sum(axis=1) * energy.diagonal(), dtype=np.longdouble)


@dataclass(frozen=True, eq=False)
class _Places:
    """Cells of extended precision on 0..1 whose edges hold every breakpoint and point mass of the girder as given.

    edges (cells + 1,), widths (cells,) and point masses at the edges; start and share of the piece that holds a cell,
    parent_start and parent_share of the field's cell, parent_widths its width in full.
    """

    edges: Long
    widths: Long
    lumps: Long
    piece: NDArray[np.intp]
    start: Long
    share: Long
    parent: NDArray[np.intp]
    parent_start: Long
    parent_share: Long
    parent_widths: Long


def _exact_places(cells: Cells) -> _Places:
    girder = cells.girder
    length = np.longdouble(girder.length)
    breaks = girder.breaks.astype(np.longdouble) / length
    positions = np.array([p.x_m for p in girder.point_masses], dtype=np.longdouble) / length
    parents = cells.edges.astype(np.longdouble)
    # an edge that is a breakpoint or a point mass but for rounding becomes it
    places = np.concatenate([positions, breaks])
    near = np.clip(np.searchsorted(parents, places), 1, len(parents) - 1)
    near -= np.abs(parents[near - 1] - places) < np.abs(parents[near] - places)
    same = np.abs(parents[near] - places) <= _SAME_PLACE
    parents[near[same]] = places[same]
    edges = np.unique(np.concatenate([parents, places]))
    middle = 0.5 * (edges[:-1] + edges[1:])
    piece = np.searchsorted(breaks, middle, side="right") - 1
    parent = np.searchsorted(parents, middle, side="right") - 1
    widths, piece_widths, parent_widths = np.diff(edges), np.diff(breaks)[piece], np.diff(parents)[parent]
    lumps = np.zeros(len(edges), dtype=np.longdouble)
    masses = np.array([p.mass_kg for p in girder.point_masses], dtype=np.longdouble)
    np.add.at(lumps, np.searchsorted(edges, positions), masses / np.longdouble(cells.total_mass))
    return _Places(
        edges,
        widths,
        lumps,
        piece,
        (edges[:-1] - breaks[piece]) / piece_widths,
        widths / piece_widths,
        parent,
        (edges[:-1] - parents[parent]) / parent_widths,
        widths / parent_widths,
        parent_widths,
    )


def _polynomials(coefficients: Long, t: Long) -> Long:
    """Bernstein rows (cells, n + 1) at t (cells, p) by de Casteljau's scheme, in extended precision."""
    columns = [coefficients[:, i, None] + 0.0 * t for i in range(coefficients.shape[1])]
    rest = 1.0 - t
    while len(columns) > 1:
        columns = [left * rest + right * t for left, right in pairwise(columns)]
    return columns[0]


def _integrated_twice(values: Long, widths: Long, rule: LongOperators, jumps: Long | None) -> tuple[Long, Long]:
    """Double integral from the aft end, at the nodes (n, cells * p) and at the edges (n, cells + 1), of values
    (n, cells, p), with jumps of the slope (n, cells + 1) at the edges."""
    local = values * (widths**2)[:, None]
    count, size, points = local.shape
    slopes = np.zeros((count, size), dtype=np.longdouble)
    slopes[:, 1:] = (local[:, :-1] @ rule.weights) / widths[:-1]
    if jumps is not None:
        slopes += jumps[:, :-1]
    slopes = np.cumsum(slopes, axis=1) * widths
    edges = np.zeros((count, size + 1), dtype=np.longdouble)
    np.cumsum(slopes + local @ (rule.weights * (1.0 - rule.nodes)), axis=1, out=edges[:, 1:])
    inside = (local.reshape(-1, points) @ rule.twice).reshape(local.shape)
    inside += edges[:, :-1, None] + slopes[:, :, None] * rule.nodes
    return inside.reshape(count, -1), edges


def _clear_ellipse(place: _Places, rigidity: Long) -> tuple[float, Array]:
    """Sum of half axes of an ellipse about every cell that EI has no zero in, and a lower bound of |EI| there (cells,).

    From the Legendre series of EI on the cell: |P_k| <= r^k on the ellipse, as |P_k| <= 1 on the cell.
    """
    rule = long_operators(rigidity.shape[1])
    t = place.start[:, None] + place.share[:, None] * rule.nodes
    series = (_polynomials(rigidity[place.piece], t) @ rule.legendre).astype(np.float64)
    for radius in _RADII:
        growth = radius ** np.arange(1.0, series.shape[1])
        floor = series[:, 0] - np.abs(series[:, 1:]) @ growth
        if bool(np.all(floor > 0.05 * series[:, 0])):
            return radius, floor * (1.0 - 1e-12)
    raise NotProven("the flexural rigidity falls too steeply within one piece to bound its integral.")
