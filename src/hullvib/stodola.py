"""Rayleigh-Ritz after Stodola's steps: the frequencies of girders with jumps to many digits."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh, lapack

from hullvib.arguments import is_whole
from hullvib.cells import Cells, girder_cells, refined_cells
from hullvib.errors import ArgumentError, SolutionError
from hullvib.girder import Girder
from hullvib.ladder import Deflection, Ladder
from hullvib.modes import Modes
from hullvib.stodola_field import StodolaField
from hullvib.uniform_beam import frequency_parameters

Array = NDArray[np.float64]

_REMEMBERED = 20_000  # values of trial functions at the points of one set of breakpoints, which variants share
_REFINEMENTS = 3  # of the cells, after a solution each
_ROUND_OFF = 1e-14  # of the largest inverse eigenvalue: a smaller one is round-off
_DEPENDENT = 3e-7  # of a function: what is left of it beside the others, when round-off has half of its digits


@dataclass(frozen=True)
class StodolaRitz:
    """Rayleigh-Ritz method with `functions` modes of the uniform beam after `steps` steps of Stodola's iteration.

    Each step replaces every trial function by its deflection under its own inertia load, w'' = m u and v'' = w / EI,
    integrated on the girder's own pieces, and tells the functions apart anew, so that the set keeps its rank. The
    rigid-body motions are taken out exactly; the frequencies are upper bounds but for round-off and for what is left
    of Gauss's rule, 1e-12. Two steps on 12 functions leave 1e-8 and mostly 1e-11 in modes 1 to 3 of hull girders, jumps
    of EI and point masses or not. A girder whose last 3 per cent have 1e-5 of the rigidity and 1e4 times the mass is
    not so easy: 3e-4 is left in mode 3, and `bracket` tells. With shear=True shear deflection takes part:
    int w' w' / kGA comes to the energy and -w' / kGA to the slope (S. Timoshenko's beam without rotary inertia), and
    the girder needs a shear rigidity. Raises ArgumentError.
    """

    functions: int = 12
    steps: int = 2
    shear: bool = False

    def __post_init__(self) -> None:
        if not is_whole(self.functions, 1, 400):
            raise ArgumentError(f"functions is {self.functions!r}; give 1 to 400 elastic trial functions.")
        if not is_whole(self.steps, 1, 10):
            raise ArgumentError(f"steps is {self.steps!r}; give 1 to 10 steps of the iteration.")

    def solve(self, girder: Girder, modes: int) -> Modes:
        """The first `modes` elastic modes. Raises ArgumentError, SolutionError."""
        if not is_whole(modes, 1, self.functions):
            raise ArgumentError(
                f"{modes} modes were asked of {self.functions} trial functions; ask for 1 to {self.functions} "
                "or give more functions."
            )
        if self.shear and girder.shear_rigidity_coefficients is None:
            raise ArgumentError(
                "shear=True needs the girder's shear rigidity kGA; give shear_rigidity in N, or leave shear out."
            )
        field = stodola_field(girder, self.functions, self.steps, modes, shear=self.shear)
        cells = field.ladder.cells
        record = {"method": "stodola_ritz", "functions": self.functions, "steps": self.steps}
        omega = np.sqrt(field.estimates[:modes]) * cells.unit_frequency
        scale = 1.0 / _signed_amplitudes(field)
        return Modes(
            omega,
            scale**2 * cells.total_mass,
            girder,
            field,
            scale,
            record,
            theory="shear-flexible" if self.shear else "Euler-Bernoulli",
        )


def stodola_field(girder: Girder, functions: int, steps: int, modes: int, *, shear: bool = False) -> StodolaField:
    """The first `modes` modes after `steps` steps on `functions` uniform modes. Raises SolutionError."""
    cells = girder_cells(girder, float(frequency_parameters(functions)[-1]), shear=shear)
    for _ in range(_REFINEMENTS):
        field = _on_cells(cells, functions, steps, modes)
        # the trial functions' waves size the cells at first; where EI is small or m large the girder's own are shorter
        finer = refined_cells(cells, float(field.estimates[modes - 1]))
        if finer is None:
            return field
        cells = finer
    return _on_cells(cells, functions, steps, modes)


def _on_cells(cells: Cells, functions: int, steps: int, modes: int) -> StodolaField:
    ladder = Ladder(cells)
    shape = _start(cells.xi.ravel(), functions)
    at_edges = None if cells.lumps is None else _uniform_shapes(cells.edges, functions)
    ladder.free(shape, at_edges)
    for _ in range(steps - 1):
        moments, source = ladder.moments(shape, at_edges)
        shape, at_edges = ladder.deflected(moments, source)
        _, vectors = _ritz(ladder, moments, source, shape, at_edges)
        shape = vectors.T @ shape
        at_edges = None if at_edges is None else vectors.T @ at_edges
    moments, source = ladder.moments(shape, at_edges)
    shape, at_edges, deflection = ladder.deflections(moments, source)
    inverse, vectors = _ritz(ladder, moments, source, shape, at_edges)
    if len(inverse) < modes:
        raise SolutionError(
            f"only {len(inverse)} elastic modes of the girder can be told from round-off, {modes} were asked; "
            "ask for no more than that."
        )
    vectors = vectors[:, :modes]
    at_edges = None if at_edges is None else vectors.T @ at_edges
    return StodolaField(ladder, vectors.T @ shape, at_edges, _combined(vectors, deflection), 1.0 / inverse)


def _ritz(
    ladder: Ladder, moments: Array, source: Deflection | None, shape: Array, at_edges: Array | None
) -> tuple[Array, Array]:
    return inverse_eigenvalues(ladder.kinetic_energy(shape, at_edges), ladder.bending_energy(moments, source))


def _start(xi: Array, functions: int) -> Array:
    """The uniform modes at xi, an array to write on; of small sets of points they are remembered."""
    if functions * len(xi) > _REMEMBERED:
        return _uniform_shapes(xi, functions)
    return _remembered_shapes(xi.tobytes(), functions).copy()


@lru_cache(maxsize=16)
def _remembered_shapes(xi: bytes, functions: int) -> Array:
    return _uniform_shapes(np.frombuffer(xi), functions)


def _uniform_shapes(xi: Array, functions: int) -> Array:
    """The uniform modes (see `hullvib.uniform_beam`) in one pass over both parities, (functions, points).

    cos(g u) and -sin(g u) are cos(g u + shift), u = x - 1/2.
    """
    g, shift, wave, aft, fore = _wave_terms(functions)
    angle = g * (xi - 0.5)
    angle += shift
    shapes = np.cos(angle, out=angle)
    shapes *= wave
    decay = np.exp(-g * xi)
    decay *= aft
    shapes += decay
    decay = np.exp(g * (xi - 1.0))
    decay *= fore
    shapes += decay
    return np.asarray(shapes, dtype=np.float64)


@lru_cache(maxsize=32)
def _wave_terms(functions: int) -> tuple[Array, Array, Array, Array, Array]:
    """Wave numbers, phases, and the scales of the circular and of both exponential terms, (functions, 1) each."""
    g = frequency_parameters(functions)
    symmetric = np.arange(functions) % 2 == 0
    decay = np.exp(-g)
    wave = np.where(symmetric, 1.0 / np.cos(0.5 * g), 1.0 / np.sin(0.5 * g))
    fore = np.where(symmetric, 1.0 / (1.0 + decay), -1.0 / (1.0 - decay))
    rows = (g, np.where(symmetric, 0.0, 0.5 * np.pi), wave, np.abs(fore), fore)
    return tuple(row[:, None] for row in rows)  # type: ignore[return-value]


def inverse_eigenvalues(kinetic: Array, stiffness: Array) -> tuple[Array, Array]:
    """Eigenvalues 1/lambda, largest first, and vectors (n, r) of unit kinetic energy, of an n x n pencil of rank r.

    Solved for 1/lambda the lowest modes keep full relative accuracy. Functions that round-off alone tells from the
    others are left out, and so are vectors whose eigenvalue is round-off of the largest: masses on a massless girder
    have as many elastic modes as they have freedoms.
    """
    diagonal = stiffness.diagonal()
    size = 1.0 / np.sqrt(np.maximum(diagonal, 1e-300))
    scaling = size[:, None] * size
    stiffness, kinetic = stiffness * scaling, kinetic * scaling
    inverse, vectors, info = lapack.dsygvd(kinetic, stiffness)
    # vectors of unit stiffness grow as the functions become dependent
    if info != 0 or not float(np.abs(vectors).max()) < 1.0 / _DEPENDENT:
        energy, basis = eigh(stiffness)
        kept = energy > _DEPENDENT**2 * energy[-1]
        basis = basis[:, kept] / np.sqrt(energy[kept])
        inverse, vectors = eigh(basis.T @ kinetic @ basis)
        vectors = basis @ vectors
    inverse, vectors = inverse[::-1], vectors[:, ::-1]
    if not inverse[-1] > _ROUND_OFF * inverse[0]:
        usable = int((inverse > _ROUND_OFF * inverse[0]).sum())
        inverse, vectors = inverse[:usable], vectors[:, :usable]
    vectors = vectors / np.sqrt(inverse)
    return inverse, vectors * size[:, None]


def _combined(vectors: Array, deflection: Deflection) -> Deflection:
    def combine(rows: Array) -> Array:
        return np.asarray((vectors.T @ rows.reshape(len(rows), -1)).reshape(-1, *rows.shape[1:]), dtype=np.float64)

    return Deflection(combine(deflection.local), None if deflection.sheared is None else combine(deflection.sheared))


def _signed_amplitudes(field: StodolaField) -> Array:
    """Largest |value| of each mode, with the sign of the value at the aft end, (modes,)."""
    aft, fore = field.end_values()
    ends = np.maximum(np.abs(aft), np.abs(fore))
    samples = np.abs(field.functions)
    cell = len(field.ladder.cells.operators.nodes)
    # in the cells at the ends a shape falls from its end, or a sample shows that it does not; inside, a top between two
    # samples exceeds them by two per cent at most
    amid = (samples.max(axis=1) > ends) | (samples[:, cell:-cell].max(axis=1, initial=0.0) > 0.97 * ends)
    amplitude = ends
    for mode in np.flatnonzero(amid):
        row = samples[mode]
        tops = np.flatnonzero((row[1:-1] >= row[:-2]) & (row[1:-1] >= row[2:]) & (row[1:-1] > 0.9 * row.max())) + 1
        amplitude[mode] = max([ends[mode], row.max(), *(field.top(int(mode), int(sample)) for sample in tops)])
    return np.asarray(np.where(aft < 0.0, -amplitude, amplitude), dtype=np.float64)
