"""Finite elements: cubic Hermite beam elements with the girder's properties integrated inside each."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from hullvib.errors import ArgumentError, SolutionError
from hullvib.fields import HermiteElements, hermite
from hullvib.girder import Girder
from hullvib.modes import Modes, modes_of_field
from hullvib.quadrature import composite, gauss

Array = NDArray[np.float64]

_DENSE = 60  # degrees of freedom up to which a dense solution is the faster one
_DENSE_RESCUE = 2000  # degrees of freedom up to which a dense solution takes seconds at most
_SHIFT = 1.0  # in EI/(m L^4): far below the first elastic eigenvalue, which is of the order of 500
_NEAR = 1e-9  # of the length: a point mass nearer to a breakpoint than this sits on it


@dataclass(frozen=True)
class FiniteElements:
    """Finite element method with about `elements` cubic Hermite elements (Euler-Bernoulli).

    Nodes lie on every breakpoint and every point mass; the elements are shared out among the pieces by length, at
    least one each, so a girder of more pieces than `elements` gets more; the record states the number. Frequencies
    are upper bounds, with an error of the order h^4, until round-off, which grows with h^-4, overtakes it: 1e-9 at 100
    elements, 1e-7 at 400, 1e-6 at 1000. Raises ArgumentError.
    """

    elements: int = 100

    def __post_init__(self) -> None:
        if not 1 <= self.elements <= 20000:
            raise ArgumentError(f"elements is {self.elements}; give 1 to 20000.")

    def solve(self, girder: Girder, modes: int) -> Modes:
        """The first `modes` elastic modes. Raises ArgumentError, SolutionError."""
        nodes = mesh(girder, self.elements)
        size = 2 * len(nodes)
        if not 1 <= modes <= size - 2:
            raise ArgumentError(
                f"{modes} modes were asked of {len(nodes) - 1} elements; ask for 1 to {size - 2} or give more elements."
            )
        stiffness, mass, slope_unit = assemble(girder, nodes)
        # few unknowns or nearly all modes: ARPACK wants more unknowns than vectors
        sparse = size > max(_DENSE, 3 * (modes + 2))
        solver = _sparse_modes if sparse else _dense_modes
        eigenvalues, vectors, solver_name = solver(stiffness, mass, modes)
        omega = np.sqrt(eigenvalues) * _unit_frequency(girder)
        field = HermiteElements(nodes, vectors[0::2].T, vectors[1::2].T / slope_unit)
        record = {
            "method": "finite_element",
            "elements": len(nodes) - 1,
            "solver": solver_name,
        }
        return modes_of_field(girder, omega, field, girder.total_mass, record)


def mesh(girder: Girder, elements: int) -> Array:
    """Nodes (n + 1,) on 0..1: all breakpoints and point masses, and equal elements between them, shared by length."""
    edges = girder.breaks / girder.length
    at = np.array([p.x_m for p in girder.point_masses]) / girder.length
    if len(at):
        edges = np.union1d(edges, at[np.abs(at[:, None] - edges).min(axis=1) > _NEAR])
        edges = edges[np.append(True, np.diff(edges) > _NEAR)]
    widths = np.diff(edges)
    parts = np.maximum(np.floor(elements * widths + 1e-9), 1.0)
    while parts.sum() < elements:
        # rounded, so that equal pieces tie whatever the unit of length and the aftmost wins
        parts[int((widths / parts).round(12).argmax())] += 1.0
    counts = parts.astype(np.intp)
    piece = np.repeat(np.arange(len(counts)), counts)
    within = np.arange(len(piece)) - np.repeat(np.cumsum(counts) - counts, counts)
    return np.append(edges[piece] + (widths / counts)[piece] * within, 1.0)


def assemble(girder: Girder, nodes: Array) -> tuple[Array, Array, float]:
    """Banded stiffness and mass, lower form (4, 2n), non-dimensional, and the unit of the slopes.

    Unknowns: deflection and slope times the mean element length at each node, which keeps them of one size.
    """
    widths = np.diff(nodes)
    unit = 1.0 / len(widths)
    mass_pieces, rigidity_pieces = girder.mass_coefficients, girder.flexural_rigidity_coefficients
    # cubic times cubic times the property; the product of curvatures is four degrees lower
    degree = max(mass_pieces.shape[1] - 1, rigidity_pieces.shape[1] - 5, 0)
    points = (6 + degree) // 2 + 1
    rule = composite(girder.breaks / girder.length, nodes, points)
    t = gauss(points)[0]
    slope_factor = np.stack([np.ones_like(widths), widths / unit] * 2, axis=1)
    shape, curvature = hermite(t, 0), hermite(t, 2)
    cells = (len(widths), points)
    inertia = rule.of(mass_pieces).reshape(cells) * rule.weights * (girder.length / girder.total_mass)
    bending = rule.of(rigidity_pieces).reshape(cells) * rule.weights / float(rigidity_pieces.max())
    scale = slope_factor[:, :, None] * slope_factor[:, None, :]
    stiff = np.einsum("iq,jq,eq->eij", curvature, curvature, bending / widths[:, None] ** 4) * scale
    inert = np.einsum("iq,jq,eq->eij", shape, shape, inertia) * scale
    stiffness, mass = _banded(stiff), _banded(inert)
    for point in girder.point_masses:
        node = int(np.abs(nodes - point.x_m / girder.length).argmin())
        mass[0, 2 * node] += point.mass_kg / girder.total_mass
    return stiffness, mass, unit


def _banded(elements: Array) -> Array:
    count = len(elements)
    band = np.zeros((4, 2 * count + 2))
    for i in range(4):
        for j in range(i + 1):
            band[i - j, j : j + 2 * count : 2] += elements[:, i, j]
    return band


def _unit_frequency(girder: Girder) -> float:
    largest = float(girder.flexural_rigidity_coefficients.max())
    return float(np.sqrt(largest / (girder.total_mass * girder.length**3)))


def _dense_modes(stiffness: Array, mass: Array, modes: int) -> tuple[Array, Array, str]:
    def full(band: Array) -> Array:
        matrix = np.diag(band[0])
        for offset in (1, 2, 3):
            side = np.diag(band[offset, :-offset], -offset)
            matrix += side + side.T
        return matrix

    inertia = full(mass)
    # for 1/(lambda + shift), largest first: K + shift M is positive definite where K alone is singular
    try:
        inverse, vectors = eigh(inertia, full(stiffness) + _SHIFT * inertia, check_finite=False)
    except np.linalg.LinAlgError:
        raise SolutionError(
            "the girder's mass leaves a rigid-body motion without inertia, as when all of it lies at one point; "
            "spread the mass."
        ) from None
    inverse, vectors = inverse[::-1][2 : modes + 2], vectors[:, ::-1][:, 2 : modes + 2]
    if inverse[-1] <= 1e-14:
        raise _too_few_modes(int((inverse > 1e-14).sum()))
    return 1.0 / inverse - _SHIFT, vectors / np.sqrt(inverse), "dense"


def _sparse_modes(stiffness: Array, mass: Array, modes: int) -> tuple[Array, Array, str]:
    from scipy.sparse import csc_array
    from scipy.sparse.linalg import ArpackError, eigsh

    size = stiffness.shape[1]

    def full(band: Array) -> csc_array[np.float64]:
        diagonals = [band[k, : size - k] for k in (0, 1, 2, 3, 1, 2, 3)]
        rows = [np.arange(size - k) + k for k in (0, 1, 2, 3)]
        columns = [np.arange(size - k) for k in (0, 1, 2, 3)]
        place = (np.concatenate([*rows, *columns[1:]]), np.concatenate([*columns, *rows[1:]]))
        return csc_array((np.concatenate(diagonals), place), shape=(size, size))

    start = np.cos(np.arange(size) * 1.7)  # fixed, so that two runs give the same digits
    try:
        eigenvalues, vectors = eigsh(full(stiffness), k=modes + 2, M=full(mass), sigma=-_SHIFT, which="LM", v0=start)
    except (ArpackError, RuntimeError) as error:
        # a mass matrix of very low rank (point masses on a massless girder) leaves ARPACK without directions
        if size <= _DENSE_RESCUE:
            return _dense_modes(stiffness, mass, modes)
        raise SolutionError(f"the sparse eigenvalue solver failed ({error}); try the Ritz method.") from error
    order = np.argsort(eigenvalues)[2:]
    eigenvalues, vectors = eigenvalues[order], vectors[:, order]
    if not eigenvalues[-1] < 1e14:
        raise _too_few_modes(int((eigenvalues < 1e14).sum()))
    return eigenvalues, vectors, "sparse shift-invert"


def _too_few_modes(found: int) -> SolutionError:
    return SolutionError(f"the girder's mass has only {found} elastic modes; ask for no more than that.")
