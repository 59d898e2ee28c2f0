"""Many girders at once: the same methods with a leading dimension, in chunks of bounded memory.

All girders share their breakpoints, so they share the trial functions' values and integrals: K = sum_c EI_c T_c is one
matrix product over the Bernstein coefficients, and Stodola's step is the single girder's with one dimension more. The
small eigenproblems are solved stacked.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hullvib import bernstein
from hullvib.arguments import is_whole
from hullvib.cells import Operators, operators, stack_edges
from hullvib.errors import ArgumentError, SolutionError
from hullvib.girder_stack import GirderStack
from hullvib.quadrature import for_waves
from hullvib.ritz import Ritz
from hullvib.stodola import StodolaRitz
from hullvib.uniform_beam import frequency_parameters, uniform_modes

Array = NDArray[np.float64]

_NUMBERS = 400_000  # doubles in the largest array of a chunk: a few of them stay within a processor's cache


@dataclass(frozen=True, eq=False)
class ManyModes:
    """Elastic modes of a stack of girders, lowest first.

    angular_frequencies (girders, modes) in rad/s; shapes (girders, modes, breaks) at the breakpoints, of unit modal
    mass (1 kg), positive at the aft end; stack and the record of the method.
    """

    angular_frequencies: Array
    shapes: Array
    stack: GirderStack
    method: Mapping[str, Any]

    @property
    def frequencies_hz(self) -> Array:
        """Natural frequencies in Hz, (girders, modes)."""
        return self.angular_frequencies / (2.0 * np.pi)


def solve_many(stack: GirderStack, method: Ritz | StodolaRitz | None = None, modes: int = 5) -> ManyModes:
    """Modes of all girders of a stack, as `solve` gives them one by one, by `StodolaRitz(steps=1)` or another method.

    Methods: `Ritz` with the uniform modes and the rigid-body functions, `StodolaRitz` without shear. Raises
    ArgumentError for other settings, SolutionError where a girder's mass has not so many modes.
    """
    method = StodolaRitz(steps=1) if method is None else method
    if not is_whole(modes, 1, method.functions):
        raise ArgumentError(f"{modes} modes were asked of {method.functions} trial functions.")
    if isinstance(method, StodolaRitz):
        if method.shear:
            raise ArgumentError("solve_many leaves shear out; solve shear-flexible girders one by one.")
        record = {"method": "stodola_ritz", "functions": method.functions, "steps": method.steps}
        batch: _RitzBatch | _StodolaBatch = _StodolaBatch(stack, method.functions, method.steps)
    else:
        if method != Ritz(method.functions):
            raise ArgumentError("solve_many knows Ritz with the uniform modes and rigid-body functions only.")
        record = {"method": "ritz", "functions": method.functions, "rigid_body": True}
        batch = _RitzBatch(stack, method.functions)
    omega = np.empty((len(stack), modes))
    shapes = np.empty((len(stack), modes, len(stack.breaks)))
    size = max(1, _NUMBERS // batch.numbers)
    for start in range(0, len(stack), size):
        chunk = slice(start, min(start + size, len(stack)))
        inverse, shapes[chunk] = batch.solve(chunk, modes)
        if not bool(np.all(inverse[:, -1] > 1e-14 * inverse[:, 0])):
            number = start + int(np.argmin(inverse[:, -1] / inverse[:, 0]))
            raise SolutionError(f"the mass of girder {number} has fewer than {modes} elastic modes; ask for fewer.")
        omega[chunk] = 1.0 / np.sqrt(inverse)
    shapes *= np.where(shapes[:, :, :1] < 0.0, -1.0, 1.0)
    length = float(stack.breaks[-1])
    total, largest = _units(stack)
    omega *= np.sqrt(largest / (total * length**3))[:, None]
    shapes /= np.sqrt(total)[:, None, None]
    wrong = ~np.isfinite(omega) | (omega == 0.0)
    if wrong.any():
        number = int(np.argwhere(wrong)[0][0])
        raise SolutionError(f"the numbers of girder {number} are too large or too small; give kg, m and N.")
    omega.flags.writeable = shapes.flags.writeable = False
    return ManyModes(omega, shapes, stack, record)


def _units(stack: GirderStack) -> tuple[Array, Array]:
    """Total mass in kg and largest coefficient of EI in N m^2, (girders,) each."""
    total = bernstein.integral(stack.mass) @ np.diff(stack.breaks) + stack.lumps.sum(axis=1)
    if not bool(np.all(total > 0.0)):
        raise SolutionError(f"girder {int(np.argmin(total))} has no mass at all; give a mass per length.")
    return np.asarray(total, dtype=np.float64), np.asarray(stack.rigidity.max(axis=(1, 2)), dtype=np.float64)


def _eigen(kinetic: Array, stiffness: Array, modes: int) -> tuple[Array, Array]:
    """Inverse eigenvalues (g, modes), largest first, and vectors (g, modes, n) of unit kinetic energy."""
    size = 1.0 / np.sqrt(np.einsum("gii->gi", stiffness))
    scaling = size[:, :, None] * size[:, None, :]
    try:
        factor = np.linalg.cholesky(stiffness * scaling)
    except np.linalg.LinAlgError:
        raise SolutionError(
            "the trial functions cannot be told apart for one of the girders; give fewer functions or solve one by one."
        ) from None
    half = np.linalg.inv(factor)
    inverse, vectors = np.linalg.eigh(half @ (kinetic * scaling) @ half.transpose(0, 2, 1))
    inverse, vectors = inverse[:, ::-1][:, :modes], vectors[:, :, ::-1][:, :, :modes]
    rows = vectors.transpose(0, 2, 1) @ half
    return inverse, rows * size[:, None, :] / np.sqrt(np.maximum(inverse, 1e-300))[:, :, None]


class _RitzBatch:
    """Stiffness and mass as sums over the Bernstein coefficients times integrals that all girders share."""

    def __init__(self, stack: GirderStack, functions: int) -> None:
        self._stack = stack
        self._total, self._largest = _units(stack)
        length = float(stack.breaks[-1])
        g2 = frequency_parameters(functions)[:, None] ** 2
        degree = max(stack.mass.shape[2], stack.rigidity.shape[2]) - 1
        rule = for_waves(stack.breaks / length, float(frequency_parameters(functions)[-1]), degree)
        xi = rule.xi.ravel()
        shape, curvature = uniform_modes(xi, functions, (0, 2)) / g2
        rigid = np.stack([np.ones_like(xi), 2.0 * xi - 1.0])
        self._bending = self._integrals(rule.piece, rule.t, rule.weights, curvature, stack.rigidity.shape[2])
        self._kinetic = self._integrals(
            rule.piece, rule.t, rule.weights, np.concatenate([rigid, shape]), stack.mass.shape[2]
        )
        at = stack.point_x / length
        self._at_points = np.concatenate([[np.ones_like(at), 2.0 * at - 1.0], uniform_modes(at, functions)[0] / g2])
        ends = stack.breaks / length
        self._at_breaks = np.concatenate(
            [[np.ones_like(ends), 2.0 * ends - 1.0], uniform_modes(ends, functions)[0] / g2]
        )
        self.numbers = (functions + 2) ** 2

    def _integrals(
        self, piece: NDArray[np.intp], t: Array, weights: Array, functions: Array, coefficients: int
    ) -> Array:
        """int B_c f_j f_k over every piece, (pieces * coefficients, n, n)."""
        pieces, points = len(self._stack.breaks) - 1, t.shape[1]
        basis = bernstein.collocation(coefficients - 1, t.ravel()) * weights.reshape(-1, 1)
        out = np.zeros((pieces, coefficients, len(functions), len(functions)))
        for c in range(coefficients):
            values = (functions * basis[:, c]).reshape(len(functions), -1, points).transpose(1, 0, 2)
            products = values @ functions.reshape(len(functions), -1, points).transpose(1, 2, 0)
            np.add.at(out[:, c], piece, products)
        return out.reshape(pieces * coefficients, len(functions), len(functions))

    def solve(self, chunk: slice, modes: int) -> tuple[Array, Array]:
        stack = self._stack
        total, largest = self._total[chunk], self._largest[chunk]
        stiffness = self._sum(stack.rigidity[chunk] / largest[:, None, None], self._bending)
        energy = self._sum(stack.mass[chunk] * (float(stack.breaks[-1]) / total)[:, None, None], self._kinetic)
        lumps = stack.lumps[chunk] / total[:, None]
        energy += (self._at_points * lumps[:, None, :]) @ self._at_points.T
        rigid, coupling = energy[:, :2, :2], energy[:, :2, 2:]
        removal = np.linalg.solve(rigid, coupling)
        inverse, elastic = _eigen(energy[:, 2:, 2:] - coupling.transpose(0, 2, 1) @ removal, stiffness, modes)
        rows = np.concatenate([-elastic @ removal.transpose(0, 2, 1), elastic], axis=2)
        return inverse, rows @ self._at_breaks

    @staticmethod
    def _sum(coefficients: Array, integrals: Array) -> Array:
        n = integrals.shape[1]
        flat = coefficients.reshape(len(coefficients), -1) @ integrals.reshape(len(integrals), n * n)
        return np.asarray(flat.reshape(-1, n, n), dtype=np.float64)


class _StodolaBatch:
    """Stodola's steps on cells that all girders share; arrays (g, functions, cells, q)."""

    def __init__(self, stack: GirderStack, functions: int, steps: int) -> None:
        self._stack, self._steps = stack, steps
        self._total, self._largest = _units(stack)
        length = float(stack.breaks[-1])
        wave = float(frequency_parameters(functions)[-1])
        edges, points = stack_edges(stack.breaks / length, stack.point_x / length, stack.rigidity, wave)
        degree = max(stack.mass.shape[2], stack.rigidity.shape[2]) - 1
        self._rule: Operators = operators(points + max(degree - 1, 0) // 2)
        self._edges, self._widths = edges, np.diff(edges)[:, None]
        breaks = stack.breaks / length
        self._piece = np.searchsorted(breaks, 0.5 * (edges[:-1] + edges[1:]), side="right") - 1
        left = breaks[self._piece][:, None]
        xi = edges[:-1, None] + self._widths * self._rule.nodes
        t = np.clip((xi - left) / (breaks[self._piece + 1][:, None] - left), 0.0, 1.0)
        self._mass_basis = bernstein.collocation(stack.mass.shape[2] - 1, t.ravel())
        self._rigidity_basis = bernstein.collocation(stack.rigidity.shape[2] - 1, t.ravel())
        self._xi = xi.ravel()
        self._start = uniform_modes(self._xi, functions)[0]
        self._lump_places = np.abs(edges[:, None] - stack.point_x / length).argmin(axis=0)
        self._start_edges = uniform_modes(edges, functions)[0]
        self._breaks = np.abs(edges[:, None] - breaks).argmin(axis=0)
        self.numbers = functions * len(self._xi)

    def solve(self, chunk: slice, modes: int) -> tuple[Array, Array]:
        stack, rule = self._stack, self._rule
        total, largest = self._total[chunk], self._largest[chunk]
        weights = (self._widths * rule.weights).ravel()
        mass = self._sampled(stack.mass[chunk], self._mass_basis) * (float(stack.breaks[-1]) / total)[:, None]
        rigidity = self._sampled(stack.rigidity[chunk], self._rigidity_basis) / largest[:, None]
        lumps = np.zeros((len(mass), len(self._edges)))
        for place, column in zip(self._lump_places, (stack.lumps[chunk] / total[:, None]).T, strict=True):
            lumps[:, place] += column
        inertia, flexibility = mass * weights, weights / rigidity
        squares = np.repeat((self._widths**2).ravel(), len(rule.nodes))
        load, bend = mass * squares, squares / rigidity
        centre = inertia @ self._xi + lumps @ self._edges
        arm, arms = self._xi - centre[:, None], self._edges - centre[:, None]
        pitch = 1.0 / np.sqrt((inertia * arm**2).sum(axis=1) + (lumps * arms**2).sum(axis=1))
        rigid = np.stack([np.ones_like(arm), arm * pitch[:, None]], axis=1)
        rigid_edges = np.stack([np.ones_like(arms), arms * pitch[:, None]], axis=1)

        def free(functions: Array, edges: Array) -> None:
            part = functions @ (rigid * inertia[:, None]).transpose(0, 2, 1)
            part += (edges * lumps[:, None]) @ rigid_edges.transpose(0, 2, 1)
            functions -= part @ rigid
            edges -= part @ rigid_edges

        functions = np.repeat(self._start[None], len(mass), axis=0)
        edges = np.repeat(self._start_edges[None], len(mass), axis=0)
        free(functions, edges)
        count = len(self._start)
        inverse = np.empty(0)
        for step in range(self._steps):
            moments, _ = self._integrated(functions * load[:, None], edges * lumps[:, None])
            functions, edges = self._integrated(moments * bend[:, None], None)
            free(functions, edges)
            stiffness = (moments * flexibility[:, None]) @ moments.transpose(0, 2, 1)
            kinetic = (functions * inertia[:, None]) @ functions.transpose(0, 2, 1)
            kinetic += (edges * lumps[:, None]) @ edges.transpose(0, 2, 1)
            last = step == self._steps - 1
            inverse, rows = _eigen(kinetic, stiffness, modes if last else count)
            edges = rows @ edges
            if not last:
                functions = rows @ functions
        return inverse, edges[:, :, self._breaks]

    def _sampled(self, coefficients: Array, basis: Array) -> Array:
        points = len(self._rule.nodes)
        cells = basis.reshape(-1, points, basis.shape[1])
        values = np.einsum("gpc,pqc->gpq", coefficients[:, self._piece], cells, optimize=True)
        return np.asarray(values.reshape(len(coefficients), -1), dtype=np.float64)

    def _integrated(self, scaled: Array, jumps: Array | None) -> tuple[Array, Array]:
        """Double integrals of functions given as h^2 f, (g, n, cells * q), at the nodes and at the edges."""
        rule, widths = self._rule, self._widths[:, 0]
        g, n, size = scaled.shape
        points = len(rule.nodes)
        local = np.empty((g, n, len(widths), points + 2))
        local[..., :points] = scaled.reshape(g, n, len(widths), points)
        totals = local[..., :points] @ rule.moments
        slopes = np.zeros((g, n, len(widths)))
        slopes[..., 1:] = totals[..., :-1, 0] / widths[:-1]
        if jumps is not None:
            slopes += jumps[..., :-1]
        local[..., -1] = np.cumsum(slopes, axis=2) * widths
        edges = np.zeros((g, n, len(widths) + 1))
        np.cumsum(local[..., -1] + totals[..., 1], axis=2, out=edges[..., 1:])
        local[..., -2] = edges[..., :-1]
        values = local.reshape(-1, points + 2) @ rule.twice
        return values.reshape(g, n, size), edges
