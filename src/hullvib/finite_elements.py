"""Finite elements: cubic Hermite beam elements with the girder's properties integrated inside each."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullvib.arguments import is_whole
from hullvib.banded import banded, elastic_modes
from hullvib.energies import polished
from hullvib.errors import ArgumentError, SolutionError
from hullvib.fields import HermiteElements, hermite
from hullvib.girder import Girder
from hullvib.modes import Modes, modes_of_field
from hullvib.quadrature import composite, gauss

Array = NDArray[np.float64]

_SHORTEST = 9e-6  # of the length: what round-off leaves of the modes of shorter elements cannot be polished
_NEAR = 1e-9  # of the length: a point mass nearer to a breakpoint than this sits on it


@dataclass(frozen=True)
class FiniteElements:
    """Finite element method with about `elements` cubic Hermite elements (Euler-Bernoulli).

    Nodes lie on every breakpoint and every point mass; the elements are shared out among the pieces by length, at
    least one each, so a girder of more pieces than `elements` gets more; the record states the number. Frequencies
    are upper bounds, with an error of the order h^4. The round-off of the stiffness matrix, which grows with h^-4, is
    taken out by Ritz on the modes found and rigid-body motion: in modes 1 to 3 of a uniform beam 1e-11 is left in all
    at 1000 elements, 1e-9 at 4000, 1e-7 at 10,000. Refused are a mesh with an element below 9e-6 of the length, and
    modes of which round-off had moved an omega^2 by more than 1 %.

    With rotary_inertia=True the rotary inertia of the girder and of its point masses takes part, with the slope as the
    sections' angle (Rayleigh's beam); a girder that has none is solved without, and the record says so. Raises
    ArgumentError.
    """

    elements: int = 100
    rotary_inertia: bool = False

    def __post_init__(self) -> None:
        check_elements(self.elements)

    def solve(self, girder: Girder, modes: int) -> Modes:
        """The first `modes` elastic modes. Raises ArgumentError, SolutionError."""
        nodes = mesh(girder, self.elements)
        size = 2 * len(nodes)
        if not is_whole(modes, 1, size - 2):
            raise ArgumentError(
                f"{modes} modes were asked of {len(nodes) - 1} elements; ask for 1 to {size - 2} or give more elements."
            )
        rotary = self.rotary_inertia and has_rotary_inertia(girder)
        stiffness, mass, slope_unit = assemble(girder, nodes, rotary=rotary)
        eigenvalues, vectors, solver_name = elastic_modes(stiffness, mass, modes)

        def field_of(rows: Array) -> HermiteElements:
            return HermiteElements(nodes, rows[:, 0::2], rows[:, 1::2] / slope_unit)

        squares, mixture, rigid = polished(girder, field_of(vectors.T), nodes, eigenvalues, rotary=rotary, shear=False)
        own = field_of(mixture.T @ vectors.T)
        values, slopes = rigid_motion(nodes, rigid)
        field = HermiteElements(nodes, own.values + values, own.slopes + slopes)
        record = {
            "method": "finite_element",
            "elements": len(nodes) - 1,
            "solver": solver_name,
        }
        if self.rotary_inertia:
            record["rotary_inertia"] = rotary_note(girder, wanted=True)
        theory = "Euler-Bernoulli with rotary inertia" if rotary else "Euler-Bernoulli"
        return modes_of_field(girder, np.sqrt(squares), field, 1.0, record, theory, rotary=rotary)


def rigid_motion(nodes: Array, parts: Array) -> tuple[Array, Array]:
    """Deflections (modes, n) and slopes by xi (modes, 1) of the parts (2, modes) of 1 and 2 xi - 1."""
    return parts[0][:, None] + parts[1][:, None] * (2.0 * nodes - 1.0), 2.0 * parts[1][:, None]


def check_elements(elements: int) -> None:
    """Raises ArgumentError for what is not a whole number of elements from 1 to 10000."""
    if not is_whole(elements, 1, 10000):
        raise ArgumentError(f"elements is {elements!r}; give a whole number from 1 to 10000.")


def has_rotary_inertia(girder: Girder) -> bool:
    """Whether the girder or one of its point masses has a rotary inertia that is not zero."""
    spread = girder.rotary_inertia_coefficients
    points = any(point.rotary_inertia_kg_m2 > 0.0 for point in girder.point_masses)
    return points or (spread is not None and bool(spread.any()))


def rotary_note(girder: Girder, *, wanted: bool) -> str:
    """What a method's record says of the rotary inertia."""
    if not wanted:
        return "left out"
    return "as the girder has it" if has_rotary_inertia(girder) else "none given, taken as zero"


def mesh(girder: Girder, elements: int) -> Array:
    """Nodes (n + 1,) on 0..1: all breakpoints and point masses, and equal elements between them, shared by length.

    Raises SolutionError where two breakpoints or point masses are too near each other.
    """
    edges = girder.breaks / girder.length
    at = np.array([p.x_m for p in girder.point_masses]) / girder.length
    if len(at):
        edges = np.union1d(edges, at[np.abs(at[:, None] - edges).min(axis=1) > _NEAR])
        edges = edges[np.append(True, np.diff(edges) > _NEAR)]
    widths = np.diff(edges)
    if widths.min() < _SHORTEST:
        bay = int(widths.argmin())
        raise SolutionError(
            f"the bay from x = {edges[bay] * girder.length:.10g} m to {edges[bay + 1] * girder.length:.10g} m is "
            f"{widths[bay]:.1e} of the length; finite elements need {_SHORTEST:g} at least: join breakpoints, or take "
            "StodolaRitz (with rotary inertia TimoshenkoRitz)."
        )
    parts = np.maximum(np.floor(elements * widths + 1e-9), 1.0)
    while parts.sum() < elements:
        # rounded, so that equal pieces tie whatever the unit of length and the aftmost wins
        parts[int((widths / parts).round(12).argmax())] += 1.0
    counts = parts.astype(np.intp)
    piece = np.repeat(np.arange(len(counts)), counts)
    within = np.arange(len(piece)) - np.repeat(np.cumsum(counts) - counts, counts)
    return np.append(edges[piece] + (widths / counts)[piece] * within, 1.0)


def assemble(girder: Girder, nodes: Array, *, rotary: bool = False) -> tuple[Array, Array, float]:
    """Banded stiffness and mass, lower form (4, 2n), non-dimensional, and the unit of the slopes.

    Unknowns: deflection and slope times the mean element length at each node, which keeps them of one size.
    """
    length, total = girder.length, girder.total_mass
    widths = np.diff(nodes)
    unit = 1.0 / len(widths)
    mass_pieces, rigidity_pieces = girder.mass_coefficients, girder.flexural_rigidity_coefficients
    turning = girder.rotary_inertia_coefficients if rotary else None
    # cubic times cubic times the property; the product of slopes is two degrees lower, that of curvatures four
    degree = max(mass_pieces.shape[1] - 1, rigidity_pieces.shape[1] - 5, 0 if turning is None else turning.shape[1] - 3)
    points = (6 + degree) // 2 + 1
    rule = composite(girder.breaks / length, nodes, points)
    t = gauss(points)[0]
    slope_factor = np.stack([np.ones_like(widths), widths / unit] * 2, axis=1)
    shape, slope, curvature = hermite(t, 0), hermite(t, 1), hermite(t, 2)
    cells = (len(widths), points)
    inertia = rule.of(mass_pieces).reshape(cells) * rule.weights * (length / total)
    bending = rule.of(rigidity_pieces).reshape(cells) * rule.weights / float(rigidity_pieces.max())
    scale = slope_factor[:, :, None] * slope_factor[:, None, :]
    stiff = np.einsum("iq,jq,eq->eij", curvature, curvature, bending / widths[:, None] ** 4) * scale
    inert = np.einsum("iq,jq,eq->eij", shape, shape, inertia) * scale
    if turning is not None:
        turn = rule.of(turning).reshape(cells) * rule.weights / (length * total) / widths[:, None] ** 2
        inert += np.einsum("iq,jq,eq->eij", slope, slope, turn) * scale
    stiffness, mass = banded(stiff, 2), banded(inert, 2)
    add_point_masses(girder, nodes, mass, 2, 1.0 / unit if rotary else 0.0)
    return stiffness, mass, unit


def add_point_masses(girder: Girder, nodes: Array, mass: Array, stride: int, angle_factor: float) -> None:
    """Adds point masses to the diagonal of a banded mass matrix whose nodes carry deflection and angle.

    angle_factor is d(L psi) by the unknown: 1 over the unit of the angles, or 0 to leave their rotary inertia out.
    """
    length, total = girder.length, girder.total_mass
    for point in girder.point_masses:
        node = int(np.abs(nodes - point.x_m / length).argmin())
        mass[0, stride * node] += point.mass_kg / total
        mass[0, stride * node + 1] += point.rotary_inertia_kg_m2 / (total * length**2) * angle_factor**2
