"""Rayleigh-Ritz with the modes of the uniform free-free beam, or with Legendre polynomials."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve, eigh

from hullvib.arguments import is_whole
from hullvib.errors import ArgumentError, SolutionError
from hullvib.fields import Field, TrialSeries, UniformModeSeries
from hullvib.girder import Girder
from hullvib.legendre import LegendreTrials, legendre_trials
from hullvib.modes import Modes, modes_of_field
from hullvib.trials import Trials, UniformTrials
from hullvib.uniform_beam import frequency_parameters

Array = NDArray[np.float64]
Basis = Literal["uniform", "legendre"]


@dataclass(frozen=True)
class Ritz:
    """Rayleigh-Ritz method with `functions` elastic trial functions.

    basis="uniform" (the default) takes modes of the uniform beam, basis="legendre" polynomials: of degree up to
    functions + 1 over the whole length or, where there are two functions a stretch at least, of lower degree on each
    stretch between jumps, kinks and point masses. Polynomials converge fast where the ends are sharp and where a few
    steps or point masses part smooth stretches; the record tells the number of stretches.

    With rigid_body=True (the default) the two rigid-body functions 1 and 2x/L - 1 come on top, and are removed by the
    exact Schur complement M_eff = M_ee - M_er M_rr^-1 M_re; the frequencies are then upper bounds of the exact ones.
    With rigid_body=False the trial functions are the elastic uniform modes alone, as in the paper: for a mass that is
    not uniform that set is not complete, and the frequencies come out low by 1 to 30 per cent; they bound nothing.
    Raises ArgumentError.
    """

    functions: int = 12
    rigid_body: bool = True
    basis: Basis = "uniform"

    def __post_init__(self) -> None:
        check_basis(self.basis, self.functions)
        if self.basis == "legendre" and not self.rigid_body:
            raise ArgumentError(
                "basis 'legendre' needs rigid_body=True: its functions are clamped at the aft end; give one or the "
                "other."
            )

    def solve(self, girder: Girder, modes: int) -> Modes:
        """The first `modes` elastic modes. Raises ArgumentError, SolutionError."""
        if not is_whole(modes, 1, self.functions):
            raise ArgumentError(
                f"{modes} modes were asked of {self.functions} trial functions; ask for 1 to {self.functions} "
                "or give more functions."
            )
        trials = trials_of(girder, self.functions, self.basis)
        pencil = ritz_pencil(girder, self.functions, trials)
        eigenvalues, elastic, rigid = pencil.solve(modes, rigid_body=self.rigid_body)
        record: dict[str, Any] = {"method": "ritz", "functions": self.functions, "rigid_body": self.rigid_body}
        field: Field = UniformModeSeries(rigid, elastic)
        if isinstance(trials, LegendreTrials):
            record |= {"basis": self.basis, "stretches": len(trials.counts)}
            field = TrialSeries(trials, rigid, elastic)
        omega = np.sqrt(eigenvalues) * pencil.unit_frequency
        return modes_of_field(girder, omega, field, pencil.unit_mass, record)


def check_basis(basis: str, functions: int) -> None:
    """Raises ArgumentError for a basis that does not exist and a number of functions outside 1 to 400."""
    if basis not in ("uniform", "legendre"):
        raise ArgumentError(f"basis is {basis!r}; give 'uniform' or 'legendre'.")
    if not is_whole(functions, 1, 400):
        raise ArgumentError(f"functions is {functions!r}; give 1 to 400 elastic trial functions.")


def trials_of(girder: Girder, functions: int, basis: Basis) -> Trials:
    """The trial functions that a basis has for a girder."""
    return UniformTrials(functions) if basis == "uniform" else legendre_trials(girder, functions)


@dataclass(frozen=True, eq=False)
class RitzPencil:
    """Generalised stiffness and mass of a girder on the uniform modes, non-dimensional.

    Lengths in L, masses in the total mass, rigidities in the largest coefficient of EI. Trial function j is
    phi_j / g_j^2, which brings the stiffness near the unit matrix. stiffness and mass (N, N), coupling (2, N) with and
    rigid (2, 2) of the functions 1 and 2 xi - 1; divisors (N,) are the g_j^2, or ones for functions that need none;
    unit_frequency in rad/s, unit_mass in kg.
    """

    stiffness: Array
    mass: Array
    coupling: Array
    rigid: Array
    divisors: Array
    unit_frequency: float
    unit_mass: float

    def solve(self, modes: int, *, rigid_body: bool, functions: int | None = None) -> tuple[Array, Array, Array]:
        """Eigenvalues (modes,) and, for unit mass, elastic (modes, N) and rigid (modes, 2) coefficients."""
        n = len(self.stiffness) if functions is None else functions
        stiffness, mass, coupling = self.stiffness[:n, :n], self.mass[:n, :n], self.coupling[:, :n]
        # what is below it in 1/lambda is round-off of the removal of the rigid part
        smallest = 1e-14 * float((mass.diagonal() / stiffness.diagonal()).max())
        removal = np.zeros_like(coupling)
        if rigid_body:
            removal = self._rigid_part(coupling)
            mass = mass - coupling.T @ removal
            mass = 0.5 * (mass + mass.T)
        # solved for 1/lambda, largest first: the lowest modes come out with full relative accuracy, and a bay
        # without mass only adds zeros
        try:
            inverse, vectors = eigh(mass, stiffness, check_finite=False, driver="gvd")
        except np.linalg.LinAlgError:
            raise SolutionError(
                f"{n} trial functions cannot be told apart where the rigidity nearly vanishes; give fewer functions "
                "or use finite elements."
            ) from None
        inverse, vectors = inverse[::-1][:modes], vectors[:, ::-1][:, :modes]
        if inverse[-1] <= smallest:
            found = int((inverse > smallest).sum())
            raise SolutionError(f"the girder's mass has only {found} elastic modes; ask for no more than that.")
        vectors = vectors / np.sqrt(inverse)
        divisors = self.divisors[:n, None]
        return 1.0 / inverse, np.ascontiguousarray((vectors / divisors).T), np.ascontiguousarray(-(removal @ vectors).T)

    def _rigid_part(self, coupling: Array) -> Array:
        try:
            factor = cho_factor(self.rigid, check_finite=False)
        except np.linalg.LinAlgError:
            factor = None
        if factor is None or np.linalg.cond(self.rigid) > 1e14:
            raise SolutionError(
                "all mass lies at one point, so the girder has no pitch inertia and no elastic mode; spread the mass."
            )
        return np.asarray(cho_solve(factor, coupling, check_finite=False), dtype=np.float64)


def ritz_pencil(girder: Girder, functions: int, trials: Trials | None = None) -> RitzPencil:
    """Assembles K_jk = int EI phi_j'' phi_k'' dx and M_jk = int m phi_j phi_k dx, exact to round-off on every piece.

    The trial functions are the uniform beam's unless others are given.
    """
    length, total = girder.length, girder.total_mass
    mass_pieces, rigidity_pieces = girder.mass_coefficients, girder.flexural_rigidity_coefficients
    largest = float(rigidity_pieces.max())
    divisors = np.ones(functions)
    if trials is None or isinstance(trials, UniformTrials):
        trials, divisors = UniformTrials(functions), frequency_parameters(functions) ** 2
    degree = max(mass_pieces.shape[1], rigidity_pieces.shape[1]) - 1
    rule = trials.rule(girder.breaks / length, degree)
    xi, weights = rule.xi.ravel(), rule.weights.ravel()
    shape, curvature = trials.bending(xi, (0, 2))
    bending = rule.of(rigidity_pieces) * (weights / largest)
    inertia = rule.of(mass_pieces) * (weights * (length / total))
    stiffness = (curvature * bending) @ curvature.T
    loaded = shape * inertia
    rigid_functions = np.stack([np.ones_like(xi), 2.0 * xi - 1.0])
    mass = loaded @ shape.T
    coupling = rigid_functions @ loaded.T
    rigid = (rigid_functions * inertia) @ rigid_functions.T
    if girder.point_masses:
        at = np.array([p.x_m for p in girder.point_masses]) / length
        parts = np.array([p.mass_kg for p in girder.point_masses]) / total
        points = trials.bending(at, (0,))[0]
        rigid_points = np.stack([np.ones_like(at), 2.0 * at - 1.0])
        mass += (points * parts) @ points.T
        coupling += (rigid_points * parts) @ points.T
        rigid += (rigid_points * parts) @ rigid_points.T
    unit = float(np.sqrt(largest / (total * length**3)))
    return RitzPencil(stiffness, mass, coupling, rigid, divisors, unit, total)
