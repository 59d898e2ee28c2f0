"""Timoshenko's beam by finite elements that neither lock nor lose the order of the cubic element.

The textbook element of exact shape interpolates between nodes by the deflection of a prismatic beam under end loads
only: one parameter phi = 12 EI / (kGA h^2), a cubic deflection, a quadratic rotation, a constant shear strain. Under
inertia loads the shear force varies within the element, which that shape cannot follow: its error in omega^2 is of the
order s^2 h^2. Here the four nodal functions are the cubics without shear strain, and two functions of the element's
own add a constant and a linear strain (`fields.ShearFlexibleElements`). Their sum holds the exact shape for every phi,
whatever EI and kGA do within the element; it turns into the cubic element as kGA grows, and the error is of the order
h^4 throughout. Condensed statically, a prismatic element gives the textbook's stiffness matrix (J. S. Przemieniecki,
Theory of Matrix Structural Analysis, eq. (5.116)).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hullvib.arguments import is_whole
from hullvib.banded import banded, elastic_modes
from hullvib.energies import polished
from hullvib.errors import ArgumentError, SolutionError
from hullvib.fields import ShearFlexibleElements, hermite, shear_functions
from hullvib.finite_elements import (
    add_point_masses,
    check_elements,
    has_rotary_inertia,
    mesh,
    rigid_motion,
    rotary_note,
)
from hullvib.girder import Girder
from hullvib.modes import Modes, modes_of_field
from hullvib.quadrature import composite, gauss

Array = NDArray[np.float64]

# of the six unknowns of an element: two at its aft node, its own two, two at its fore node
_ORDER = [0, 1, 4, 5, 2, 3]


@dataclass(frozen=True)
class TimoshenkoElements:
    """Finite element method for Timoshenko's beam with about `elements` elements, nodes as `FiniteElements` has them.

    The girder must have a shear rigidity. Its rotary inertia takes part where it has any, unless rotary_inertia=False;
    without it the theory is called "shear-flexible". Frequencies are upper bounds with an error of the order h^4 in
    omega^2; short elements are refused as `FiniteElements` refuses them. Raises ArgumentError.
    """

    elements: int = 100
    rotary_inertia: bool = True

    def __post_init__(self) -> None:
        check_elements(self.elements)

    def solve(self, girder: Girder, modes: int) -> Modes:
        """The first `modes` elastic modes. Raises ArgumentError, SolutionError."""
        shear_rigidity_of(girder)
        nodes = mesh(girder, self.elements)
        most = 4 * (len(nodes) - 1)
        if not is_whole(modes, 1, most):
            raise ArgumentError(
                f"{modes} modes were asked of {len(nodes) - 1} elements; ask for 1 to {most} or give more elements."
            )
        rotary = self.rotary_inertia and has_rotary_inertia(girder)
        stiffness, mass, unit = assemble(girder, nodes, rotary=rotary)
        eigenvalues, vectors, solver = elastic_modes(stiffness, mass, modes)

        def field_of(rows: Array) -> ShearFlexibleElements:
            angles, constant, linear = (rows[:, first::4] / unit for first in (1, 2, 3))
            return ShearFlexibleElements(nodes, rows[:, 0::4], angles, constant, linear)

        squares, mixture, rigid = polished(girder, field_of(vectors.T), nodes, eigenvalues, rotary=rotary, shear=True)
        own = field_of(mixture.T @ vectors.T)
        values, slopes = rigid_motion(nodes, rigid)
        field = replace(own, values=own.values + values, rotations=own.rotations + slopes)
        record = {
            "method": "timoshenko_element",
            "elements": len(nodes) - 1,
            "solver": solver,
            "rotary_inertia": rotary_note(girder, wanted=self.rotary_inertia),
        }
        return modes_of_field(girder, np.sqrt(squares), field, 1.0, record, theory_name(rotary), rotary=rotary)


def shear_rigidity_of(girder: Girder) -> Array:
    """Bernstein coefficients of kGA in N. Raises SolutionError where the girder has none."""
    if girder.shear_rigidity_coefficients is None:
        raise SolutionError(
            "the girder has no shear rigidity, which Timoshenko's beam needs; give kGA in N (shear_rigidity_N in a "
            "girder file), or take a method of the Euler-Bernoulli beam."
        )
    return girder.shear_rigidity_coefficients


def theory_name(rotary: bool) -> str:
    """The theory's name in results: with or without rotary inertia."""
    return "Timoshenko" if rotary else "shear-flexible"


def assemble(girder: Girder, nodes: Array, *, rotary: bool) -> tuple[Array, Array, float]:
    """Banded stiffness and mass, lower form (6, 4 elements + 2), non-dimensional, and the unit of angles and strains.

    Unknowns at a node: deflection, angle; then those of the element forward of it: constant and linear strain.
    """
    length, total = girder.length, girder.total_mass
    widths = np.diff(nodes)
    unit = 1.0 / len(widths)
    mass_pieces, rigidity_pieces = girder.mass_coefficients, girder.flexural_rigidity_coefficients
    shear_pieces, largest = shear_rigidity_of(girder), float(rigidity_pieces.max())
    turning = girder.rotary_inertia_coefficients if rotary else None
    # degrees of the products: deflections 6, angles 4, strains and curvatures 2
    degrees = [6 + mass_pieces.shape[1], 2 + rigidity_pieces.shape[1], 2 + shear_pieces.shape[1]]
    points = max([*degrees, 0 if turning is None else 4 + turning.shape[1]]) // 2 + 1
    rule = composite(girder.breaks / length, nodes, points)
    t, nothing = gauss(points)[0], np.zeros((4, points))
    cells = (len(widths), points)

    def integrated(functions: Array, density: Array, power: int) -> Array:
        weighted = density / widths[:, None] ** power
        return np.asarray(np.einsum("iq,jq,eq->eij", functions, functions, weighted) * scale, dtype=np.float64)

    def of(coefficients: Array) -> Array:
        return rule.of(coefficients).reshape(cells) * rule.weights

    angle = widths / unit
    factors = np.stack([np.ones_like(widths), angle, np.ones_like(widths), angle, angle, angle], axis=1)[:, _ORDER]
    scale = factors[:, :, None] * factors[:, None, :]
    constant = -6.0 * t * (1.0 - t)
    deflection = np.vstack([hermite(t, 0), shear_functions(t, 0)])[_ORDER]
    turn = np.vstack([hermite(t, 1), constant, 0.0 * t])[_ORDER]
    curvature = np.vstack([hermite(t, 2), 12.0 * t - 6.0, 0.0 * t])[_ORDER]
    strain = np.vstack([nothing, np.ones_like(t), 1.0 - 2.0 * t])[_ORDER]
    stiff = integrated(curvature, of(rigidity_pieces) / largest, 4)
    stiff += integrated(strain, of(shear_pieces) * (length**2 / largest), 2)
    inert = integrated(deflection, of(mass_pieces) * (length / total), 0)
    if turning is not None:
        inert += integrated(turn, of(turning) / (length * total), 2)
    mass = banded(inert, 4)
    add_point_masses(girder, nodes, mass, 4, 1.0 / unit if rotary else 0.0)
    return banded(stiff, 4), mass, unit
