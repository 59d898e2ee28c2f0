"""Two-sided bounds of the first frequencies of the Euler-Bernoulli beam, with their proof.

Upper bounds: Rayleigh-Ritz on the deflections u of a Stodola step. Lower bounds: Lehmann-Goerisch (F. Goerisch and
H. Haunhorst, ZAMM 65 (1985) 129-135): with A2 = int EI u'' u'', A3 = int m u u, A4 = int w w / EI, w'' = m u, and any
rho with Lambda_n < rho <= lambda_(n+1), every eigenvalue mu < 0 of (A2 - rho A3, A2 - 2 rho A3 + rho^2 A4) gives
lambda >= rho - rho / (1 - mu). That no more than n elastic eigenvalues lie below rho is proven by a comparison beam
and a Wittrick-Williams count.

What the computer adds is bounded, not neglected (`_Energies`): A2 and A3 are integrals of polynomials and exact but
for rounding; of A4 the truncation of Gauss's rule is bounded in the complex plane; rounding is bounded a priori. Each
pencil is then shifted to the safe side. The arithmetic is not interval arithmetic: the small eigenproblems are taken
to be good to 1e-12 of their largest term, which is charged too.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from hullvib.cells import Cells, integration, operators, resampled
from hullvib.comparison_beam import comparison_beam
from hullvib.errors import ArgumentError, NotProven
from hullvib.girder import Girder
from hullvib.ladder import Ladder
from hullvib.modes import Modes
from hullvib.stodola import stodola_field
from hullvib.stodola_field import StodolaField

Array = NDArray[np.float64]

_EPS = float(np.finfo(np.float64).eps)
_SMALL_PROBLEM = 1e-12  # relative error charged for an eigenproblem of a few rows
_SAFETY = 1e-6  # the count is made this much above rho
_VARIATIONS = (0.3, 0.1, 0.03, 0.01)  # of m and EI on the parts of the comparison beam, tried in this order
_NARROWEST_GAP = 1.02  # of neighbouring eigenvalues between which rho is looked for
_RADII = (4.0, 3.0, 2.5, 2.0, 1.75, 1.5, 1.35, 1.25)  # of ellipses about a cell in which EI must not vanish


@dataclass(frozen=True, eq=False)
class Bracket:
    """Lower and upper bounds (modes,) in rad/s of the first elastic modes, Euler-Bernoulli, dry.

    rho in (rad/s)^2 separates the first `separated` elastic eigenvalues from all others; proof says how that is known.
    It is the numerical error of the beam solution that they enclose; they say nothing of the model.
    """

    lower: Array
    upper: Array
    rho: float
    proof: str

    @property
    def relative_width(self) -> Array:
        """(upper - lower) / upper, (modes,)."""
        return (self.upper - self.lower) / self.upper


def bracket(source: Girder | Modes, modes: int | None = None, functions: int = 12) -> Bracket:
    """Proven two-sided bounds of the first `modes` frequencies (default 5) of a girder.

    Modes of StodolaRitz may stand for their girder: their functions are then used again, all their modes by default.
    Raises ArgumentError, SolutionError, and NotProven with the reason where nothing can be proven.
    """
    girder = source if isinstance(source, Girder) else source.girder
    field = None
    if isinstance(source, Modes):
        if source.theory != "Euler-Bernoulli" or source.medium != "dry":
            raise NotProven(
                f"the modes are those of a {source.theory} beam, {source.medium}; bounds exist for the dry "
                "Euler-Bernoulli beam only."
            )
        if isinstance(source.field, StodolaField):
            field = source.field
            functions = len(field.estimates)
    wanted = modes if modes is not None else 5 if isinstance(source, Girder) else len(source.angular_frequencies)
    if not 1 <= wanted < functions:
        raise ArgumentError(f"{wanted} modes are to be bounded with {functions} functions; give 1 to {functions - 1}.")
    _refuse_unprovable(girder)
    if field is None:
        field = stodola_field(girder, functions, 2, wanted)
    last = "no gap between neighbouring eigenvalues is wide enough"
    unit = field.ladder.cells.unit_frequency
    for count in range(wanted, len(field.estimates)):
        estimates = field.estimates
        if estimates[count] < _NARROWEST_GAP * estimates[count - 1]:
            continue
        rho = _proven_rho(girder, float(estimates[count - 1]), float(estimates[count]), count)
        if rho is None:
            last = f"no comparison beam separates mode {count} from mode {count + 1}"
            continue
        if len(field.functions) < count:
            field = stodola_field(girder, functions, 2, len(estimates))
        lower, upper = _enclosure(field, count, rho)
        if lower is None:
            last = f"with {functions} functions the bounds of {count} modes do not lie below rho; give more functions"
            continue
        proof = (
            f"Lehmann-Goerisch with {count} functions after Stodola steps on {functions}; that {count} elastic "
            "eigenvalues lie below rho is counted (Wittrick-Williams) on a beam nowhere stiffer and nowhere lighter"
        )
        return Bracket(
            np.sqrt(lower[:wanted]) * unit * (1.0 - 4.0 * _EPS),
            np.sqrt(upper[:wanted]) * unit * (1.0 + 4.0 * _EPS),
            rho * unit**2,
            proof,
        )
    raise NotProven(f"the first {wanted} modes of the girder cannot be bounded: {last}.")


def _refuse_unprovable(girder: Girder) -> None:
    rigidity = girder.flexural_rigidity_coefficients
    for end, x in ((rigidity[0, 0], 0.0), (rigidity[-1, -1], girder.length)):
        if end <= 1e-9 * rigidity.max():
            raise NotProven(
                f"the flexural rigidity vanishes at x = {x:g} m: no comparison beam lies below a sharp end."
            )
    if girder.residual > 0.0:
        raise NotProven(
            "the girder was fitted to functions whose extremes are not known; give tables or polynomials instead."
        )


def _proven_rho(girder: Girder, below: float, above: float, count: int) -> float | None:
    """A rho, as high in the gap as a quick proof reaches: more than `below`, at most the (count + 1)-th eigenvalue."""
    shortest = 0.05 / above**0.25
    for variation in _VARIATIONS:
        beam = comparison_beam(girder, above, variation, shortest)
        shortest *= 0.3
        if beam is None:
            continue
        for part in (0.8, 0.5, 0.25):
            rho = below + part * (above - below)
            # a pivot that happens to vanish stands aside after a small change of the trial value
            found = next(
                (
                    n
                    for nudge in (1.0, 1.003, 1.007)
                    if (n := beam.count_below(rho * nudge * (1.0 + _SAFETY))) is not None
                ),
                None,
            )
            if found is not None and found <= count + 2:
                return rho
    return None


def _enclosure(field: StodolaField, count: int, rho: float) -> tuple[Array | None, Array]:
    energies = _energies(field, count)
    two, three, four = energies.bending, energies.kinetic, energies.complementary
    d2, d3, d4 = (np.diag(margin) for margin in energies.margins)
    upper = 1.0 / eigh(four - d4, three + d3, eigvals_only=True)[::-1]
    left = two + d2 - rho * (three - d3)
    right = two + d2 - 2.0 * rho * (three - d3) + rho**2 * (four + d4)
    try:
        mu = eigh(left, right, eigvals_only=True)
    except np.linalg.LinAlgError:
        return None, upper
    if not mu[-1] < 0.0:
        return None, upper
    lower = (rho - rho / (1.0 - mu))[::-1] - _SMALL_PROBLEM * rho
    if not (lower[0] > 0.0 and upper[-1] < rho):
        return None, upper
    return lower, upper * (1.0 + _SMALL_PROBLEM)


@dataclass(frozen=True, eq=False)
class _Energies:
    """A2, A3, A4 (n, n) and, for each, a diagonal (n,) that bounds its error as a quadratic form."""

    bending: Array
    kinetic: Array
    complementary: Array
    margins: tuple[Array, Array, Array]


def _energies(field: StodolaField, count: int) -> _Energies:
    """The energies of the first `count` functions on a rule that is exact for all polynomials in them.

    u has the degree q + 1 on a cell, m u with m of degree d has q + 1 + d and w has q + 3 + d, so that q + 3 + d Gauss
    points integrate the load, A2 and A3 exactly. Further points serve w w / EI: on an ellipse with the sum of half
    axes r about a cell of width h, with |w| <= W on the cell and |EI| >= E in the ellipse, p points err by at most
    (h/2) (64/15) (W^2 / E) r^(-2 p) / (1 - r^-2) (L. N. Trefethen, Approximation Theory and Approximation Practice,
    theorem 19.3), where |w| <= W is meant in the ellipse and comes from the Legendre series of w.

    Rounding: the running sums over C cells and p points err by (C + 4 p) eps of the sum of the absolute terms, which
    the integrals of |EI^-1 M| and of m |u| bound; the sums of the energies by their number of terms times eps.
    """
    coarse = field.ladder.cells
    girder, points = coarse.girder, len(coarse.operators.nodes)
    mass_degree = girder.mass_coefficients.shape[1] - 1
    rigidity_degree = girder.flexural_rigidity_coefficients.shape[1] - 1
    degree = points + 3 + max(mass_degree, rigidity_degree)
    radius, floor = _clear_ellipse(resampled(coarse, rigidity_degree + 1))
    # r^(-2 extra) of 1e-15, and rounding is the larger part
    extra = max(2, int(np.ceil(15.0 * np.log(10.0) / (2.0 * np.log(radius)))))
    cells = resampled(coarse, degree + extra)
    ladder = Ladder(cells)
    local = field.deflection.local[:count]
    deflect, bend = _carry(points, degree + extra)
    functions = (local @ deflect).reshape(count, -1)
    edges = None if field.at_edges is None else field.at_edges[:count].copy()
    ladder.free(functions, edges)
    weights = (cells.operators.weights * cells.widths).ravel()
    curvatures = ((local[:, :, :-2] / cells.widths**2) @ bend).reshape(count, -1)
    bending = (curvatures * (cells.rigidity.ravel() * weights)) @ curvatures.T
    moments, source = ladder.moments(functions, edges)
    kinetic = ladder.kinetic_energy(functions, edges)
    complementary = ladder.bending_energy(moments, source)
    # truncation of A4, cell by cell: |P_k| <= r^k on the ellipse bounds the Legendre series of w there
    series = np.abs(moments.reshape(count, *cells.xi.shape) @ cells.operators.legendre)
    number = len(cells.operators.nodes)
    outside = series @ radius ** (np.arange(number) - float(number))
    truncation = (64.0 / 30.0) / (1.0 - radius**-2.0) * (outside**2 @ (cells.widths[:, 0] / floor))
    # rounding, relative, of the functions
    rounding = _EPS * (len(cells.edges) + 4 * len(cells.operators.nodes))
    load = np.abs(functions) @ ladder.inertia
    if edges is not None and cells.lumps is not None:
        load += np.abs(edges) @ cells.lumps
    bent = np.abs(curvatures) @ weights
    soft = float(np.sqrt(ladder.flexibility.sum()))
    of_deflection = rounding * bent / np.sqrt(kinetic.diagonal())
    of_moment = (rounding * load + of_deflection) * soft / np.sqrt(complementary.diagonal())
    of_sum = _EPS * (cells.xi.size + 20)

    def margin(energy: Array, error: Array | float) -> Array:
        worst = float(np.max(error))
        return np.asarray(count * (2.0 * worst + worst**2 + of_sum) * energy.diagonal(), dtype=np.float64)

    margins = (
        margin(bending, of_sum),
        margin(kinetic, of_deflection),
        margin(complementary, of_moment) + count * truncation,
    )
    return _Energies(bending, kinetic, complementary, margins)


def _clear_ellipse(cells: Cells) -> tuple[float, Array]:
    """Sum of half axes of an ellipse about every cell that EI has no zero in, and a lower bound of |EI| there (cells,).

    From the Legendre series of EI on the cell: |P_k| <= r^k on the ellipse, as |P_k| <= 1 on the cell.
    """
    series = cells.rigidity @ cells.operators.legendre
    for radius in _RADII:
        growth = radius ** np.arange(1.0, series.shape[1])
        floor = series[:, 0] - np.abs(series[:, 1:]) @ growth
        if bool(np.all(floor > 0.05 * series[:, 0])):
            return radius, floor
    raise NotProven("the flexural rigidity falls too steeply within one piece to bound its integral.")


@lru_cache(maxsize=32)
def _carry(old: int, new: int) -> tuple[Array, Array]:
    """From what `Deflection.local` holds for `old` Gauss points to deflections (old + 2, new), and from its first
    `old` values to the twice integrated function (old, new), at `new` Gauss points."""
    legendre, nodes = operators(old).legendre, operators(new).nodes
    basis = np.polynomial.legendre.legvander(2.0 * nodes - 1.0, old + 1).T
    twice = legendre @ integration(old) @ integration(old + 1) @ basis
    return np.concatenate([twice, np.ones((1, new)), nodes[None, :]]), legendre @ basis[:old]
