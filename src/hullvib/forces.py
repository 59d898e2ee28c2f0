"""Bending moment and shear force of a mode from the equilibrium of its inertia loads.

    V' = omega^2 m Phi,   M' = V - omega^2 J psi,   M(0) = V(0) = 0,   dM/dx = V without rotary inertia,

with jumps of V by omega^2 M_p Phi at point masses, and of M by -omega^2 J_p psi. M is positive in sagging, of the sign
of EI psi', and the shear strain w' - psi is -V / kGA. Two integrations of the shape are smoother than its two
derivatives: where EI jumps, a series of smooth functions has a curvature that is wrong by tens of per cent at modes
right to a per mille. M and V vanish at the fore end as far as the mode is orthogonal to the rigid-body motions; the
paper's basis without rigid-body functions is not.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullvib.fields import Field, PiecewiseField, TurningField
from hullvib.girder import Girder
from hullvib.quadrature import composite, gauss

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class InertiaLoads:
    """Inertia loads of the functions of a field vibrating at omega, (modes,), integrated up to the edges of cells.

    edges (cells + 1,) on 0..1; shear in N and moment in N m at the edges, forward of what stands there, both (modes,
    cells + 1), for the function as a deflection in metres; points is the order of the rule within a cell.
    """

    girder: Girder
    field: Field
    squares: Array
    rotary: bool
    edges: Array
    points: int
    shear_at_edges: Array
    moment_at_edges: Array

    def forces(self, xi: Array) -> tuple[Array, Array]:
        """Moment in N m and shear force in N at xi (points,), each (modes, points).

        Forward of a point mass where one stands, and aft of it at the fore end: always a section of the girder.
        """
        cell = np.clip(np.searchsorted(self.edges, xi, side="right") - 1, 0, len(self.edges) - 2)
        nodes, weights = gauss(self.points)
        left = self.edges[cell]
        width = (xi - left)[:, None]
        at = left[:, None] + width * nodes
        # the ends of a part stay within its cell, whatever the last bit says
        load, couple = self._densities(np.clip(at, left[:, None], self.edges[cell + 1][:, None]).ravel())
        rows = (len(self.squares), *at.shape)
        step = width * weights * self.girder.length
        force = load.reshape(rows) * step
        shear = self.shear_at_edges[:, cell] + force.sum(axis=2)
        arm = (xi[:, None] - at) * self.girder.length
        turned = (couple.reshape(rows) * step).sum(axis=2)
        moment = self.moment_at_edges[:, cell] + (force * arm).sum(axis=2) - turned
        moment += self.shear_at_edges[:, cell] * (xi - left) * self.girder.length
        return moment, shear

    def _densities(self, xi: Array) -> tuple[Array, Array]:
        x = xi * self.girder.length
        load = self.squares[:, None] * self.girder.mass_per_length(x) * self.field.evaluate(xi, 0)
        inertia = self.girder.rotary_inertia(x) if self.rotary else None
        if inertia is None:
            return load, np.zeros_like(load)
        return load, self.squares[:, None] * inertia * section_rotation(self.field, xi, 0) / self.girder.length


def section_rotation(field: Field, xi: Array, derivative: int) -> Array:
    """L times the angle of the sections, or its derivative by xi: the slope where the field has no other."""
    if isinstance(field, TurningField):
        return field.rotation(xi, derivative)
    return field.evaluate(xi, derivative + 1)


def cell_edges(girder: Girder, field: Field, modes: int) -> Array:
    """Edges on 0..1 of cells of at most 1/16 of a half wave of the highest mode, broken where anything jumps."""
    grid = np.linspace(0.0, 1.0, 16 * (modes + 1) + 1)
    at = np.array([p.x_m for p in girder.point_masses])
    nodes = field.nodes if isinstance(field, PiecewiseField) else np.empty(0)
    edges = np.unique(np.concatenate([girder.breaks / girder.length, grid, at / girder.length, nodes]))
    edges = edges[np.append(True, np.diff(edges) > 1e-12)]
    edges[-1] = 1.0
    return np.asarray(edges, dtype=np.float64)


def inertia_loads(girder: Girder, field: Field, angular_frequencies: Array, *, rotary: bool) -> InertiaLoads:
    """Integrates the inertia loads of a field from the aft end on."""
    modes, length = len(angular_frequencies), girder.length
    edges = cell_edges(girder, field, modes)
    at = np.array([p.x_m for p in girder.point_masses]) / length
    turning = girder.rotary_inertia_coefficients if rotary else None
    degree = max(c.shape[1] for c in (girder.mass_coefficients, turning) if c is not None) - 1
    # a cubic or a wave of 1/16 of pi times a polynomial of that degree
    points = 5 + (degree + 1) // 2
    rule = composite(girder.breaks / length, edges, points)
    xi, weights = rule.xi.ravel(), rule.weights.ravel() * length
    squares = angular_frequencies**2
    load = squares[:, None] * field.evaluate(xi, 0) * (rule.of(girder.mass_coefficients) * weights)
    cells = (modes, *rule.xi.shape)
    load = load.reshape(cells)
    arm = (edges[1:, None] - rule.xi) * length
    force, lever = load.sum(axis=2), (load * arm).sum(axis=2)
    if turning is not None:
        couple = squares[:, None] * section_rotation(field, xi, 0) * (rule.of(turning) * weights) / length
        lever -= couple.reshape(cells).sum(axis=2)
    jumps, turns = np.zeros((modes, len(edges))), np.zeros((modes, len(edges)))
    for point, place in zip(girder.point_masses, at, strict=True):
        edge = int(np.abs(edges - place).argmin())
        jumps[:, edge] += squares * field.evaluate(np.array([place]), 0)[:, 0] * point.mass_kg
        if rotary and point.rotary_inertia_kg_m2:
            angle = section_rotation(field, np.array([place]), 0)[:, 0] / length
            turns[:, edge] -= squares * angle * point.rotary_inertia_kg_m2
    shear = np.cumsum(jumps, axis=1)
    shear[:, 1:] += np.cumsum(force, axis=1)
    moment = np.cumsum(turns, axis=1)
    moment[:, 1:] += np.cumsum(lever + shear[:, :-1] * (np.diff(edges) * length), axis=1)
    return InertiaLoads(girder, field, squares, rotary, edges, points, shear, moment)
