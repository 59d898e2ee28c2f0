"""Mode shapes as Stodola's step gives them: polynomials on cells, twice integrated from the curvature."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from hullvib.cells import integration
from hullvib.ladder import Deflection, Ladder
from hullvib.quadrature import composite

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class StodolaField:
    """Deflections with their bending moments, of unit modal mass (non-dimensional).

    ladder holds the cells; functions (modes, cells * q) and at_edges (modes, cells + 1 or None) are the values,
    deflection their integrals; estimates are the eigenvalues of all trial functions, lowest first, in the unit
    EI_max / (M L^3), of which the first belong to the modes.
    """

    ladder: Ladder
    functions: Array
    at_edges: Array | None
    deflection: Deflection
    estimates: Array

    @property
    def nodes(self) -> Array:
        """Edges of the cells, on 0..1."""
        return self.ladder.cells.edges

    def evaluate(self, xi: Array, derivative: int) -> Array:
        """Derivative by xi; the second is M/EI, so that it jumps where EI does."""
        cell, t = self._place(xi)
        values = _sum(self._series(derivative), cell, t)
        if derivative == 2 and self.deflection.sheared is None:
            rigidity = self._rigidity(xi)
            moment = _sum(_integrals(self._moment.local, self.ladder, 0), cell, t) * self._eigenvalues
            # at a sharp end moment and rigidity vanish together, and the interpolated ratio is the better one
            blunt = ~self._sharp[cell] & (rigidity > 0.0)
            np.divide(moment, rigidity, out=values, where=blunt)
        return values

    def rotation(self, xi: Array, derivative: int) -> Array:
        """L times the angle of the section, or its first derivative by xi: the slope without the shear strain."""
        if self.deflection.sheared is None:
            return self.evaluate(xi, derivative + 1)
        return _sum(_integrals(self.deflection.local, self.ladder, derivative + 1), *self._place(xi))

    def moment(self, xi: Array) -> Array:
        """Bending moment in N m from the equilibrium of the inertia loads, for the function in metres."""
        girder = self.ladder.cells.girder
        unit = float(girder.flexural_rigidity_coefficients.max()) / girder.length**2
        return unit * self._eigenvalues * _sum(_integrals(self._moment.local, self.ladder, 0), *self._place(xi))

    def shear(self, xi: Array) -> Array:
        """dM/dx in N; forward of a point mass where one stands."""
        girder = self.ladder.cells.girder
        unit = float(girder.flexural_rigidity_coefficients.max()) / girder.length**3
        return unit * self._eigenvalues * _sum(_integrals(self._moment.local, self.ladder, 1), *self._place(xi))

    def mean_square(self) -> Array:
        edges = self.nodes
        rule = composite(edges, edges, len(self.ladder.cells.operators.nodes) + 2)
        return np.asarray(self.evaluate(rule.xi.ravel(), 0) ** 2 @ rule.weights.ravel(), dtype=np.float64)

    def end_values(self) -> tuple[Array, Array]:
        """Values at the aft and at the fore end, (modes,) each."""
        local, rule = self.deflection.local, self.ladder.cells.operators
        fore = local[:, -1, -2] + local[:, -1, -1] + local[:, -1, :-2] @ rule.moments[:, 1]
        if self.deflection.sheared is not None:
            fore = fore + self.deflection.sheared[:, -1] @ rule.weights
        return local[:, 0, -2], fore

    def top(self, mode: int, sample: int) -> float:
        """Largest |value| of one mode next to one of its samples: of its polynomials there, at 16 points a sample, then
        at the top of a parabola through the highest three."""
        cell, place = divmod(sample, len(self.ladder.cells.operators.nodes))
        edges, nodes = self.nodes, self.ladder.cells.operators.nodes
        centre = edges[cell] + (edges[cell + 1] - edges[cell]) * nodes[place]
        reach = (edges[cell + 1] - edges[cell]) / len(nodes)
        one = Deflection(
            self.deflection.local[mode : mode + 1],
            None if self.deflection.sheared is None else self.deflection.sheared[mode : mode + 1],
        )
        xi = np.linspace(max(centre - 1.5 * reach, 0.0), min(centre + 1.5 * reach, 1.0), 33)
        alone = StodolaField(self.ladder, self.functions[mode : mode + 1], None, one, self.estimates)
        values = np.abs(alone.evaluate(xi, 0)[0])
        best = int(values.argmax())
        if not 0 < best < len(xi) - 1:
            return float(values[best])
        low, high, next_one = values[best - 1 : best + 2]
        bend = low - 2.0 * high + next_one
        return float(high - 0.125 * (next_one - low) ** 2 / bend) if bend < 0.0 else float(high)

    @property
    def _eigenvalues(self) -> Array:
        return self.estimates[: len(self.functions), None]

    @cached_property
    def _moment(self) -> Deflection:
        return self.ladder.moment_integrals(self.functions, self.at_edges)

    @cached_property
    def _sharp(self) -> NDArray[np.bool_]:
        ends = self._rigidity(self.nodes) <= 1e-9
        return np.asarray(ends[:-1] | ends[1:], dtype=np.bool_)

    def _rigidity(self, xi: Array) -> Array:
        girder = self.ladder.cells.girder
        return girder.flexural_rigidity(xi * girder.length) / float(girder.flexural_rigidity_coefficients.max())

    def _place(self, xi: Array) -> tuple[NDArray[np.intp], Array]:
        edges = self.nodes
        cell = np.clip(np.searchsorted(edges, xi, side="right") - 1, 0, len(edges) - 2)
        return cell, (xi - edges[cell]) / (edges[cell + 1] - edges[cell])

    def _series(self, order: int) -> Array:
        series = _integrals(self.deflection.local, self.ladder, order)
        sheared = self.deflection.sheared
        if sheared is not None:
            rule, widths = self.ladder.cells.operators, self.ladder.cells.widths
            extra = sheared @ rule.legendre / widths**order
            extra = extra @ integration(extra.shape[-1]) if order == 0 else _derived(extra, order - 1)
            series[:, :, : extra.shape[-1]] += extra
        return series


def _integrals(local: Array, ladder: Ladder, order: int) -> Array:
    """Legendre coefficients by t, of a derivative by xi of what `local` integrates twice, (n, cells, terms)."""
    rule, widths = ladder.cells.operators, ladder.cells.widths
    points = len(rule.nodes)
    series = local[:, :, :-2] @ rule.legendre
    if order >= 2:
        series = _derived(series, order - 2)
    elif order == 1:
        series = series @ integration(points)
        series[:, :, 0] += local[:, :, -1]
    else:
        series = series @ (integration(points) @ integration(points + 1))
        series[:, :, 0] += local[:, :, -2] + 0.5 * local[:, :, -1]
        series[:, :, 1] += 0.5 * local[:, :, -1]
    return np.asarray(series / widths**order, dtype=np.float64)


def _derived(series: Array, times: int) -> Array:
    if times == 0:
        return series
    # by t = 0..1, whence the scale 2
    return np.asarray(np.polynomial.legendre.legder(series, times, scl=2.0, axis=-1), dtype=np.float64)


def _sum(series: Array, cell: NDArray[np.intp], t: Array) -> Array:
    basis = np.polynomial.legendre.legvander(2.0 * t - 1.0, series.shape[-1] - 1)
    return np.asarray(np.einsum("npk,pk->np", series[:, cell], basis), dtype=np.float64)
