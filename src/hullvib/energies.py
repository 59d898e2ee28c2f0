"""Kinetic and strain energy of the functions of a field, for any of the theories, and a rule to integrate them.

    2 T / omega^2 = int m w^2 + J psi^2 dx + sum M_p w^2 + J_p psi^2,     2 U = int EI psi'^2 + kGA (w' - psi)^2 dx

in the terms that the theory has; psi is the slope where the field has no angle of its own.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from hullvib.fields import Field
from hullvib.forces import cell_edges, section_rotation
from hullvib.girder import Girder
from hullvib.quadrature import Quadrature, composite

Array = NDArray[np.float64]
Terms = list[tuple[Array, Array]]


def energy_rule(girder: Girder, fields: list[Field], modes: int, bounds: Array) -> Quadrature:
    """Integrates products of two functions and a property, to round-off, with cells broken at bounds too, on 0..1."""
    grid = [cell_edges(girder, field, modes) for field in fields]
    edges = np.unique(np.concatenate([*grid, bounds]))
    edges = edges[np.append(True, np.diff(edges) > 1e-12)]
    edges[-1] = 1.0
    # cells of at most 1/16 of a half wave: seven points leave round-off only
    return composite(girder.breaks / girder.length, edges, 7 + (_degree(girder) + 1) // 2)


def kinetic_terms(girder: Girder, field: Field, xi: Array, *, rotary: bool) -> Terms:
    """Bernstein coefficients of m (kg/m) and of J / L^2 with the functions whose squares they multiply."""
    terms = [(girder.mass_coefficients, field.evaluate(xi, 0))]
    if rotary and girder.rotary_inertia_coefficients is not None:
        terms.append((girder.rotary_inertia_coefficients / girder.length**2, section_rotation(field, xi, 0)))
    return terms


def strain_terms(girder: Girder, field: Field, xi: Array, *, shear: bool) -> Terms:
    """Bernstein coefficients of EI (N m^2) and of kGA L^2 with the functions, derivatives by xi."""
    terms = [(girder.flexural_rigidity_coefficients, section_rotation(field, xi, 1))]
    if shear and girder.shear_rigidity_coefficients is not None:
        strain = field.evaluate(xi, 1) - section_rotation(field, xi, 0)
        terms.append((girder.shear_rigidity_coefficients * girder.length**2, strain))
    return terms


def point_terms(girder: Girder, field: Field, *, rotary: bool) -> list[tuple[float, float, Array]]:
    """Position on 0..1, mass in kg or J_p / L^2, and the functions it multiplies, (modes,), a point mass."""
    length, terms = girder.length, []
    for point in girder.point_masses:
        at = np.array([point.x_m / length])
        terms.append((float(at[0]), point.mass_kg, field.evaluate(at, 0)[:, 0]))
        if rotary and point.rotary_inertia_kg_m2 > 0.0:
            turn = section_rotation(field, at, 0)[:, 0]
            terms.append((float(at[0]), point.rotary_inertia_kg_m2 / length**2, turn))
    return terms


def energy_matrices(
    girder: Girder, field: Field, rule: Quadrature, *, rotary: bool, shear: bool
) -> tuple[Array, Array]:
    """Mass in kg and stiffness in N/m of the functions as deflections in metres, each (modes, modes)."""
    xi, weights, length = rule.xi.ravel(), rule.weights.ravel(), girder.length

    def products(terms: Terms) -> Array:
        return np.asarray(sum((values * (rule.of(c) * weights)) @ values.T for c, values in terms), dtype=np.float64)

    mass = products(kinetic_terms(girder, field, xi, rotary=rotary)) * length
    for _, inertia, values in point_terms(girder, field, rotary=rotary):
        mass += inertia * np.outer(values, values)
    return mass, products(strain_terms(girder, field, xi, shear=shear)) / length**3


def polished(girder: Girder, field: Field, nodes: Array, *, rotary: bool, shear: bool) -> tuple[Array, Array]:
    """Squares of the frequencies (modes,) and mixture (modes, modes), in columns, by Ritz on the modes of elements.

    The stiffness matrix of short elements has entries of the order h^-3 that nearly cancel, and the eigenvalue carries
    their round-off; the energy of the shape, integrated from its curvatures, does not, and errors of the shape enter
    it squared. The mixture has unit modal mass, 1 kg.
    """
    # cubic times cubic times a property
    rule = composite(girder.breaks / girder.length, nodes, (6 + _degree(girder)) // 2 + 1)
    mass, stiffness = energy_matrices(girder, field, rule, rotary=rotary, shear=shear)
    # solved for 1 / omega^2, so that the lowest modes come out with full relative accuracy
    inverse, vectors = eigh(mass, stiffness, check_finite=False)
    inverse, vectors = inverse[::-1], vectors[:, ::-1]
    return 1.0 / inverse, np.asarray(vectors / np.sqrt(inverse), dtype=np.float64)


def _degree(girder: Girder) -> int:
    present = (
        girder.mass_coefficients,
        girder.flexural_rigidity_coefficients,
        girder.shear_rigidity_coefficients,
        girder.rotary_inertia_coefficients,
    )
    return max(int(c.shape[1]) for c in present if c is not None) - 1
