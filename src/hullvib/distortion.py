"""How far a girder's modes depart from those of the uniform beam, and which part of the ship makes them do so."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.energies import energy_rule, kinetic_terms, point_terms, strain_terms
from hullvib.errors import ArgumentError
from hullvib.fields import UniformModeSeries
from hullvib.girder import Girder
from hullvib.modes import Modes, zero_positions
from hullvib.quadrature import Quadrature
from hullvib.ritz import Ritz, ritz_pencil

Array = NDArray[np.float64]

SHIP_REGIONS = (0.0, 0.2, 0.9, 1.0)
"""Bounds of aft fifth, middle and fore tenth, as fractions of the length."""


def weight_vectors(modes: Modes) -> Array:
    """Weights a_jk of the uniform modes k in each mode j, (modes, functions), the largest of a row being 1.

    Of a result of `Ritz`; the rigid-body part is left out. Source: the paper, eq. (5) and section 3.1.3.
    Raises ArgumentError.
    """
    if not isinstance(modes.field, UniformModeSeries):
        raise ArgumentError(
            f"weights of uniform modes exist for the Ritz method only, in its uniform basis, not for "
            f"{modes.method['method']!r}."
        )
    elastic = modes.field.elastic
    largest = elastic[np.arange(len(elastic)), np.abs(elastic).argmax(axis=1)]
    return np.asarray(elastic / largest[:, None], dtype=np.float64)


def diagonal_dominance(weights: Array) -> Array:
    """|a_jj| / sum_(k != j) |a_jk| of each row, (modes,); above 1 the mode is mostly the uniform one of its order."""
    size = np.abs(weights)
    diagonal = size[np.arange(len(size)), np.arange(len(size))]
    others = size.sum(axis=1) - diagonal
    ratio: Array = np.divide(diagonal, others, out=np.full(len(size), np.inf), where=others > 0.0)
    return ratio


@dataclass(frozen=True, eq=False)
class Shift:
    """Positions of one mode's nodes or antinodes in m, and those of the uniform beam of the same length."""

    positions: Array
    uniform_positions: Array

    @property
    def shift(self) -> Array | None:
        """Position less uniform position in m, positive forward; None where the counts differ."""
        if len(self.positions) != len(self.uniform_positions):
            return None
        return self.positions - self.uniform_positions


def node_shifts(modes: Modes) -> list[Shift]:
    """Nodes of each mode against those of the uniform beam of the same length."""
    return _shifts(modes, modes.nodes(), 0)


def antinode_shifts(modes: Modes) -> list[Shift]:
    """Interior antinodes of each mode against those of the uniform beam of the same length."""
    return _shifts(modes, modes.antinodes(), 1)


def _shifts(modes: Modes, positions: list[Array], derivative: int) -> list[Shift]:
    count = len(positions)
    uniform = zero_positions(UniformModeSeries(np.zeros((count, 2)), np.eye(count)), derivative, count)
    return [Shift(own, modes.girder.length * xi) for own, xi in zip(positions, uniform, strict=True)]


def nondimensional_frequencies(modes: Modes) -> Array:
    """omega / sqrt(EI_mid / (m_mean L^4)), (modes,), with EI at L/2 and the mean mass M/L, point masses included."""
    girder = modes.girder
    middle = float(girder.flexural_rigidity(0.5 * girder.length))
    unit = float(np.sqrt(middle / (girder.total_mass * girder.length**3)))
    return modes.angular_frequencies / unit


@dataclass(frozen=True, eq=False)
class EnergySplit:
    """Shares of each mode's kinetic and strain energy, both (modes, regions) adding up to 1 a row.

    bounds_m (regions + 1,) are the regions' bounds in m.
    """

    bounds_m: Array
    kinetic: Array
    strain: Array


def energy_split(modes: Modes, bounds: Sequence[float] = SHIP_REGIONS) -> EnergySplit:
    """Shares of int m Phi^2 dx and of int EI Phi''^2 dx by region; bounds as fractions of the length, 0 to 1.

    Rotary inertia and shear strain count where the theory has them, and EI then goes with the sections' curvature.

    A point mass on a bound counts to the region forward of it, at the fore end to the last. Raises ArgumentError.
    """
    edges = np.asarray(bounds, dtype=np.float64)
    if len(edges) < 2 or edges[0] != 0.0 or edges[-1] != 1.0 or not bool(np.all(np.diff(edges) > 0.0)):
        raise ArgumentError(f"bounds are {list(bounds)}; let them ascend from 0 to 1.")
    rule, kinetic, strain = _energies(modes, edges)
    region = np.searchsorted(edges, 0.5 * (rule.edges[:-1] + rule.edges[1:])) - 1
    shares = []
    for cells in (kinetic, strain):
        total = np.zeros((len(cells), len(edges) - 1))
        np.add.at(total.T, region, cells.T)
        shares.append(total)
    for point, energy in _point_energies(modes):
        home = min(int(np.searchsorted(edges, point, side="right")) - 1, len(edges) - 2)
        shares[0][:, home] += energy
    kinetic_share, strain_share = (s / s.sum(axis=1, keepdims=True) for s in shares)
    return EnergySplit(edges * modes.girder.length, kinetic_share, strain_share)


def cumulative_energy(modes: Modes, x: ArrayLike) -> EnergySplit:
    """Fractions of kinetic and strain energy that lie aft of x (points,) in m; bounds_m is x.

    Both arrays are (modes, points), rising from 0 to 1. Raises ArgumentError.
    """
    positions = np.atleast_1d(np.asarray(x, dtype=np.float64))
    xi = positions / modes.girder.length
    if not bool(np.all((xi >= 0.0) & (xi <= 1.0))):
        raise ArgumentError(f"x must lie within 0 .. {modes.girder.length:g} m.")
    rule, kinetic, strain = _energies(modes, np.unique(np.concatenate([[0.0, 1.0], xi])))
    # an edge of the rule may stand a last bit off the x it was made from
    upto = np.abs(rule.edges - xi[:, None]).argmin(axis=1)
    curves = []
    for cells, points in ((kinetic, _point_energies(modes)), (strain, [])):
        running = np.concatenate([np.zeros((len(cells), 1)), cells.cumsum(axis=1)], axis=1)
        total = running[:, -1] + sum(energy for _, energy in points)
        curve = running[:, upto]
        for point, energy in points:
            curve = curve + np.where(xi >= point, energy[:, None], 0.0)
        curves.append(curve / total[:, None])
    return EnergySplit(positions, *curves)


@dataclass(frozen=True, eq=False)
class SpatialCorrelation:
    """Pearson correlation along x of m with phi_j^2 and of EI with phi_j''^2, each (modes,); 0 for a constant m or EI.

    mass below 0: the girder is light where the uniform mode moves most. rigidity above 0: it is stiff where that mode
    bends most. Both raise the frequency over the uniform beam's.
    """

    mass: Array
    rigidity: Array


def spatial_correlation(modes: Modes, *, with_uniform_modes: bool = True) -> SpatialCorrelation:
    """Correlation over x, uniformly weighted, of the girder's properties with the squares of its modes.

    with_uniform_modes takes the uniform beam's phi_j (the paper, sections 1.3 and 4.2), otherwise the girder's own.
    Point masses are left out.
    """
    count = len(modes.angular_frequencies)
    field = UniformModeSeries(np.zeros((count, 2)), np.eye(count)) if with_uniform_modes else modes.field
    rule = energy_rule(modes.girder, [modes.field], count, np.array([0.0, 1.0]))
    xi, weights = rule.xi.ravel(), rule.weights.ravel()
    results = []
    for coefficients, derivative in (
        (modes.girder.mass_coefficients, 0),
        (modes.girder.flexural_rigidity_coefficients, 2),
    ):
        values, squares = rule.of(coefficients), field.evaluate(xi, derivative) ** 2
        values = values - weights @ values
        squares = squares - (squares @ weights)[:, None]
        covariance = squares @ (weights * values)
        variance, scale = float(weights @ values**2), float(coefficients.max()) ** 2
        product = np.sqrt(variance * (squares**2 @ weights))
        # round-off of a constant property correlates with anything
        constant = variance <= 1e-24 * scale
        results.append(np.zeros(count) if constant else covariance / product)
    return SpatialCorrelation(*results)


def ritz_convergence(
    girder: Girder, functions: Iterable[int] = range(4, 13), modes: int = 3, *, rigid_body: bool = True
) -> Array:
    """Angular frequencies in rad/s by `Ritz` with each number of functions, (len(functions), modes).

    Assembled once for the largest number; the smaller ones are its leading blocks. Raises ArgumentError.
    """
    numbers = [Ritz(n).functions for n in functions]
    if not numbers or min(numbers) < modes or modes < 1:
        raise ArgumentError(f"{modes} modes were asked of {numbers} functions; let every number be at least the modes.")
    pencil = ritz_pencil(girder, max(numbers))
    eigenvalues = [pencil.solve(modes, rigid_body=rigid_body, functions=n)[0] for n in numbers]
    return np.sqrt(np.stack(eigenvalues)) * pencil.unit_frequency


def _energies(modes: Modes, bounds: Array) -> tuple[Quadrature, Array, Array]:
    """Twice the energies of each cell, (modes, cells): kinetic in units of omega^2 L, strain in units of L^-3."""
    rule = energy_rule(modes.girder, [modes.field], len(modes.scale), bounds)
    xi, weights, cells = rule.xi.ravel(), rule.weights.ravel(), rule.xi.shape
    results = []
    for terms in (
        kinetic_terms(modes.girder, modes.field, xi, rotary=modes.rotary),
        strain_terms(modes.girder, modes.field, xi, shear=modes.shear_flexible),
    ):
        density = sum(values**2 * (rule.of(coefficients) * weights) for coefficients, values in terms)
        results.append(np.asarray(density).reshape(-1, *cells).sum(axis=2))
    return rule, results[0], results[1]


def _point_energies(modes: Modes) -> list[tuple[float, Array]]:
    terms = point_terms(modes.girder, modes.field, rotary=modes.rotary)
    return [(xi, values**2 * (inertia / modes.girder.length)) for xi, inertia, values in terms]
