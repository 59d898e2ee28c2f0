"""Stodola's step on a whole set of functions: inertia load, bending moment, deflection, and the energies between.

    w'' = m u, w(0) = w'(0) = 0;   v'' = w / EI, v without rigid part;   <w, w> = int w w / EI,  <v, v> = int m v v

Both pencils of the energies bound the eigenvalues from above, the later ones ever more sharply (the Schwarz numbers:
L. Collatz, Eigenwertaufgaben mit technischen Anwendungen, section 18; R. Grammel's complementary form is the first).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from hullvib.cells import Cells
from hullvib.errors import SolutionError

Array = NDArray[np.float64]

_CACHED = 40_000  # values of the functions that are integrated together


@dataclass(frozen=True, eq=False)
class Deflection:
    """Functions known twice integrated: local (n, cells, q + 2) holds h^2 f, the start value and h times the start
    slope of every cell; sheared (n, cells, q) holds h times a slope on top, that has no part in f, or None."""

    local: Array
    sheared: Array | None


class Ladder:
    """The steps on one set of cells. Functions are arrays (n, cells * q), with their values at the edges (n, cells + 1)
    where point masses need them."""

    def __init__(self, cells: Cells) -> None:
        self.cells = cells
        widths, weights = cells.widths, cells.operators.weights
        self._weights = (widths * weights).ravel()
        self.inertia = cells.mass.ravel() * self._weights
        self._load = cells.mass * widths**2
        self._bend = widths**2 / cells.rigidity
        self.flexibility = self._weights / cells.rigidity.ravel()
        xi = cells.xi.ravel()
        total, first = float(self.inertia.sum()), float(self.inertia @ xi)
        if cells.lumps is not None:
            total += float(cells.lumps.sum())
            first += float(cells.lumps @ cells.edges)
        self.centre = first / total
        arm = xi - self.centre
        pitch = float(self.inertia @ arm**2)
        if cells.lumps is not None:
            pitch += float(cells.lumps @ (cells.edges - self.centre) ** 2)
        if not pitch > 1e-14 * total:
            raise SolutionError(
                "all mass lies at one point, so the girder has no pitch inertia and no elastic mode; spread the mass."
            )
        # amplitudes of heave, and of pitch about the centre of mass, of unit kinetic energy
        self._heave, self._pitch = 1.0 / sqrt(total), 1.0 / sqrt(pitch)
        self._rigid = self._rigid_functions(xi)
        self._rigid_load = (self._rigid * self.inertia).T
        self._rigid_edges = None if cells.lumps is None else self._rigid_functions(cells.edges)

    def free(self, functions: Array, at_edges: Array | None) -> Array:
        """Takes the rigid-body part off functions and their edge values, in place; returns what was taken (n, 2)."""
        part = functions @ self._rigid_load
        lumps, rigid = self.cells.lumps, self._rigid_edges
        if lumps is not None and rigid is not None and at_edges is not None:
            part += (at_edges * lumps) @ rigid.T
            at_edges -= part @ rigid
        functions -= part @ self._rigid
        return np.asarray(part, dtype=np.float64)

    def moments(self, functions: Array, at_edges: Array | None) -> tuple[Array, Deflection | None]:
        """Bending moments of the inertia loads of functions without rigid part, (n, cells * q).

        With shear flexibility their integrals come too, of which the shear forces are made.
        """
        if self.cells.shear is not None:
            source = self.moment_integrals(functions, at_edges)
            count, size, points = (len(functions), *self.cells.xi.shape)
            rows = source.local.reshape(count * size, points + 2)
            return (rows @ self.cells.operators.twice).reshape(count, size * points), source
        return self._integrated(functions, self._load, self._jumps(at_edges), None), None

    def moment_integrals(self, functions: Array, at_edges: Array | None) -> Deflection:
        """What is integrated to bending moments, on every cell."""
        local = self._local(len(functions))
        self._integrated(functions, self._load, self._jumps(at_edges), local)
        return Deflection(local, None)

    def deflected(self, moments: Array, source: Deflection | None) -> tuple[Array, Array | None]:
        """`deflections` without what is integrated, which then is not kept where nothing needs it."""
        if self.cells.lumps is not None or self.cells.shear is not None:
            return self.deflections(moments, source)[:2]
        functions = self._integrated(moments, self._bend, None, None)
        self.free(functions, None)
        return functions, None

    def deflections(self, moments: Array, source: Deflection | None) -> tuple[Array, Array | None, Deflection]:
        """Deflections under bending moments, without rigid part; their edge values where point masses need them."""
        cells = self.cells
        local = self._local(len(moments))
        functions = self._integrated(moments, self._bend, None, local)
        sheared = None
        edges = None
        if cells.shear is not None and source is not None:
            sheared = -self.shear_forces(source).reshape(local.shape[0], *cells.shear.shape) * (
                cells.widths / cells.shear
            )
            rule = cells.operators
            start = np.zeros((len(local), len(cells.edges)))
            np.cumsum(sheared @ rule.weights, axis=1, out=start[:, 1:])
            functions += (sheared @ rule.once + start[:, :-1, None]).reshape(functions.shape)
            local[:, :, -2] += start[:, :-1]
        if cells.lumps is not None:
            edges = self._edge_values(local, sheared)
        part = self.free(functions, edges)
        heave, pitch = part[:, :1] * self._heave, part[:, 1:] * self._pitch
        local[:, :, -2] -= heave + pitch * (cells.edges[:-1] - self.centre)
        local[:, :, -1] -= pitch * cells.widths[:, 0]
        return functions, edges, Deflection(local, sheared)

    def shear_forces(self, moment: Deflection) -> Array:
        """First derivatives of moments at the Gauss points, (n, cells, q)."""
        local, rule = moment.local, self.cells.operators
        slopes = local[:, :, :-2] @ rule.once + local[:, :, -1:]
        return np.asarray(slopes / self.cells.widths, dtype=np.float64)

    def bending_energy(self, moments: Array, source: Deflection | None) -> Array:
        """int w_i w_j / EI + int w_i' w_j' / kGA, (n, n)."""
        energy = (moments * self.flexibility) @ moments.T
        if self.cells.shear is not None and source is not None:
            forces = self.shear_forces(source).reshape(len(moments), -1)
            energy += (forces * (self._weights / self.cells.shear.ravel())) @ forces.T
        return np.asarray(energy, dtype=np.float64)

    def kinetic_energy(self, functions: Array, at_edges: Array | None) -> Array:
        """int m u_i u_j, point masses included, (n, n)."""
        energy = (functions * self.inertia) @ functions.T
        if self.cells.lumps is not None and at_edges is not None:
            energy += (at_edges * self.cells.lumps) @ at_edges.T
        return np.asarray(energy, dtype=np.float64)

    def _jumps(self, at_edges: Array | None) -> Array | None:
        lumps = self.cells.lumps
        return None if lumps is None or at_edges is None else at_edges * lumps

    def _local(self, count: int) -> Array:
        size, points = self.cells.xi.shape
        return np.empty((count, size, points + 2))

    def _integrated(self, functions: Array, factor: Array, jumps: Array | None, local: Array | None) -> Array:
        """Double integral from the aft end of functions times factor / h^2, with jumps of the slope at the edges.

        What is integrated goes to `local` (n, cells, q + 2) where that is given.
        """
        count, size = functions.shape
        values = np.empty((count, size))
        # a few rows at a time stay in the processor's cache
        step = min(count, max(1, _CACHED // size))
        buffer = self._local(step) if local is None else local
        for first in range(0, count, step):
            rows = slice(first, min(first + step, count))
            held = buffer[rows] if local is not None else buffer[: rows.stop - first]
            self._integrate(functions[rows], factor, None if jumps is None else jumps[rows], held, values[rows])
        return values

    def _integrate(self, functions: Array, factor: Array, jumps: Array | None, local: Array, values: Array) -> None:
        rule, widths = self.cells.operators, self.cells.widths[:, 0]
        count, (size, points) = len(functions), self.cells.xi.shape
        np.multiply(functions.reshape(count, size, points), factor, out=local[:, :, :points])
        rows = local.reshape(count * size, points + 2)
        totals = (rows[:, :points] @ rule.moments).reshape(count, size, 2)
        slopes = np.zeros((count, size))
        if size > 1:
            np.divide(totals[:, :-1, 0], widths[:-1], out=slopes[:, 1:])
        if jumps is not None:
            slopes += jumps[:, :-1]
        np.cumsum(slopes, axis=1, out=slopes)
        slopes *= widths
        local[:, :, -1] = slopes
        local[:, 0, -2] = 0.0
        slopes += totals[:, :, 1]
        np.cumsum(slopes[:, :-1], axis=1, out=local[:, 1:, -2])
        np.matmul(rows, rule.twice, out=values.reshape(count * size, points))

    def _rigid_functions(self, xi: Array) -> Array:
        rows = np.empty((2, len(xi)))
        rows[0] = self._heave
        np.multiply(xi - self.centre, self._pitch, out=rows[1])
        return rows

    def _edge_values(self, local: Array, sheared: Array | None) -> Array:
        rule = self.cells.operators
        values = np.empty((len(local), len(self.cells.edges)))
        values[:, :-1] = local[:, :, -2]
        values[:, -1] = local[:, -1, -2] + local[:, -1, -1] + local[:, -1, :-2] @ rule.moments[:, 1]
        if sheared is not None:
            values[:, -1] += sheared[:, -1] @ rule.weights
        return values
