"""Kinetic and strain energy of the functions of a field, for any of the theories, and a rule to integrate them.

    2 T / omega^2 = int m w^2 + J psi^2 dx + sum M_p w^2 + J_p psi^2,     2 U = int EI psi'^2 + kGA (w' - psi)^2 dx

in the terms that the theory has; psi is the slope where the field has no angle of its own.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from hullvib.errors import SolutionError
from hullvib.fields import Field
from hullvib.forces import cell_edges, section_rotation
from hullvib.girder import Girder
from hullvib.quadrature import Quadrature, composite

Array = NDArray[np.float64]
Terms = list[tuple[Array, Array]]

# of omega^2: what it leaves there of itself, squared and averaged over the shape, is some 1e-6 at most
_ROUND_OFF = 1e-2


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


def polished(
    girder: Girder, field: Field, nodes: Array, eigenvalues: Array, *, rotary: bool, shear: bool
) -> tuple[Array, Array, Array]:
    """Squares of the frequencies (modes,), mixture (modes, modes) in columns and rigid-body parts (2, modes), by Ritz.

    The functions are the modes of elements, with eigenvalues in EI / (m L^4), and the rigid-body functions 1 and
    2 xi - 1. The stiffness matrix of short elements has entries of the order h^-3 that nearly cancel, and the modes
    found carry their round-off, as frequency and as rigid-body motion. The energy of the shape, integrated from its
    curvatures, does not, and errors of the shape enter it squared. The result has unit modal mass, 1 kg.
    Raises SolutionError where what is taken out is too much for that.
    """
    # cubic times cubic times a property
    rule = composite(girder.breaks / girder.length, nodes, (6 + _degree(girder)) // 2 + 1)
    mass, stiffness = energy_matrices(girder, field, rule, rotary=rotary, shear=shear)
    coupling, rigid = _rigid_energies(girder, field, rule, rotary=rotary)
    try:
        removal = np.linalg.solve(rigid, coupling)
        mass = mass - coupling.T @ removal
        # solved for 1 / omega^2, so that the lowest modes come out with full relative accuracy
        inverse, vectors = eigh(0.5 * (mass + mass.T), stiffness, check_finite=False)
    except np.linalg.LinAlgError:
        raise _lost_in_round_off(nodes) from None
    inverse, vectors = inverse[::-1], vectors[:, ::-1]
    unit = float(girder.flexural_rigidity_coefficients.max()) / (girder.total_mass * girder.length**3)
    if not bool(np.all(inverse > 0.0)) or not bool(np.all(np.abs(eigenvalues * unit * inverse - 1.0) < _ROUND_OFF)):
        raise _lost_in_round_off(nodes)
    mixture = np.asarray(vectors / np.sqrt(inverse), dtype=np.float64)
    return 1.0 / inverse, mixture, -(removal @ mixture)


def _lost_in_round_off(nodes: Array) -> SolutionError:
    return SolutionError(
        f"the modes of {len(nodes) - 1} elements, the shortest of {float(np.diff(nodes).min()):.1e} of the length, are "
        "lost in round-off; give fewer elements or take StodolaRitz (with rotary inertia TimoshenkoRitz)."
    )


def _rigid_energies(girder: Girder, field: Field, rule: Quadrature, *, rotary: bool) -> tuple[Array, Array]:
    """Mass in kg of the rigid-body functions 1 and 2 xi - 1 with those of a field, (2, modes), and with themselves."""
    motion = _RigidMotion()
    xi, weights = rule.xi.ravel(), rule.weights.ravel() * girder.length
    pairs = zip(
        kinetic_terms(girder, motion, xi, rotary=rotary), kinetic_terms(girder, field, xi, rotary=rotary), strict=True
    )
    products = [(own * (rule.of(c) * weights), own, values) for (c, own), (_, values) in pairs]
    points = zip(point_terms(girder, motion, rotary=rotary), point_terms(girder, field, rotary=rotary), strict=True)
    products += [(m * own[:, None], own[:, None], values[:, None]) for (_, m, own), (_, _, values) in points]
    coupling = sum(loaded @ values.T for loaded, _, values in products)
    return np.asarray(coupling), np.asarray(sum(loaded @ own.T for loaded, own, _ in products))


class _RigidMotion:
    """The field of 1 and 2 xi - 1."""

    def evaluate(self, xi: Array, derivative: int) -> Array:
        rows = {0: (np.ones_like(xi), 2.0 * xi - 1.0), 1: (np.zeros_like(xi), np.full_like(xi, 2.0))}
        return np.stack(rows.get(derivative, (np.zeros_like(xi), np.zeros_like(xi))))

    def mean_square(self) -> Array:
        return np.array([1.0, 1.0 / 3.0])


def _degree(girder: Girder) -> int:
    present = (
        girder.mass_coefficients,
        girder.flexural_rigidity_coefficients,
        girder.shear_rigidity_coefficients,
        girder.rotary_inertia_coefficients,
    )
    return max(int(c.shape[1]) for c in present if c is not None) - 1
