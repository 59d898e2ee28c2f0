"""Two-sided bounds of the first frequencies of the Euler-Bernoulli beam, with their proof.

Upper bounds: Rayleigh-Ritz on the deflections u of a Stodola step. Lower bounds: Lehmann-Goerisch (F. Goerisch and
H. Haunhorst, ZAMM 65 (1985) 129-135): with A2 = int EI u'' u'', A3 = int m u u, A4 = int w w / EI, w'' = m u, and any
rho with Lambda_n < rho <= lambda_(n+1), every eigenvalue mu < 0 of (A2 - rho A3, A2 - 2 rho A3 + rho^2 A4) gives
lambda >= rho - rho / (1 - mu). That no more than n elastic eigenvalues lie below rho is proven by a comparison beam
and a Wittrick-Williams count.

What the computer adds is bounded, not neglected: the energies come with bounds of their own errors
(`bounded_energies`), and each pencil is shifted to the safe side. Extended precision, where the machine has it (64 bits
on x86), narrows the bounds a thousandfold and no more: elsewhere they are as sure. The arithmetic is not interval
arithmetic: the small eigenproblems, of nearly orthogonal functions, are taken to be good to 32 n eps of their largest
eigenvalue, which is charged too.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigvalsh

from hullvib.bounded_energies import Long, bounded_energies
from hullvib.comparison_beam import comparison_beam
from hullvib.errors import ArgumentError, NotProven, SolutionError
from hullvib.girder import Girder
from hullvib.modes import Modes
from hullvib.stodola import stodola_field
from hullvib.stodola_field import StodolaField

Array = NDArray[np.float64]

_EPS = float(np.finfo(np.float64).eps)
_SMALL_PROBLEM = 32.0 * _EPS  # error charged for an eigenproblem, per row and of its largest eigenvalue
_SAFETY = 1e-6  # the count is made this much above rho
_VARIATIONS = (0.3, 0.1, 0.03, 0.01)  # of m and EI on the parts of the comparison beam, tried in this order
_SHORT_BAY = 1e-5  # of the length
_NARROWEST_GAP = 1.02  # of neighbouring eigenvalues between which rho is looked for


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
    field, steps = None, 2
    if isinstance(source, Modes):
        if source.theory != "Euler-Bernoulli" or source.medium != "dry":
            raise NotProven(
                f"the modes are those of a {source.theory} beam, {source.medium}; bounds exist for the dry "
                "Euler-Bernoulli beam only."
            )
        if isinstance(source.field, StodolaField):
            field = source.field
            functions, steps = len(field.estimates), int(source.method["steps"])
    wanted = modes if modes is not None else 5 if isinstance(source, Girder) else len(source.angular_frequencies)
    if field is not None and wanted >= functions:
        field, functions = None, wanted + 3  # a mode beyond the last wanted must be estimated
    if not 1 <= wanted < functions:
        raise ArgumentError(f"{wanted} modes are to be bounded with {functions} functions; give 1 to {functions - 1}.")
    _refuse_unprovable(girder)
    if field is None:
        field = stodola_field(girder, functions, steps, wanted)
    last = "no gap between neighbouring eigenvalues is wide enough"
    unit = field.ladder.cells.unit_frequency
    for count in range(wanted, len(field.estimates)):
        estimates = field.estimates
        if estimates[count] < _NARROWEST_GAP * estimates[count - 1]:
            continue
        rho = _proven_rho(girder, float(estimates[count - 1]), float(estimates[count]), count)
        if rho is None:
            last = f"no comparison beam separates mode {count} from mode {count + 1}{_shortest_bay(girder)}"
            continue
        if len(field.functions) < count:
            try:
                field = stodola_field(girder, functions, steps, count)
            except SolutionError as reason:
                last = str(reason)
                break
        lower, upper = _enclosure(field, count, rho)
        if lower is None or upper is None:
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


def _shortest_bay(girder: Girder) -> str:
    """Where a bay is so short that it alone may spoil the count, a remark that names it."""
    places = np.unique(np.concatenate([girder.breaks, [p.x_m for p in girder.point_masses]]))
    widths = np.diff(places)
    bay = int(widths.argmin())
    if widths[bay] > _SHORT_BAY * girder.length:
        return ""
    return f" (the bay of {widths[bay]:.2g} m at x = {places[bay]:g} m may be too short for the count; merge it)"


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


def _enclosure(field: StodolaField, count: int, rho: float) -> tuple[Array | None, Array | None]:
    """Lower bounds, None where functions do not lie below rho, and upper bounds of the first `count` eigenvalues."""
    energies = bounded_energies(field, count)
    two, three, four = energies.bending, energies.kinetic, energies.complementary
    d2, d3, d4 = (np.diag(margin) for margin in energies.margins)
    left = two + d2 - rho * (three - d3)
    right = two + d2 - 2.0 * rho * (three - d3) + rho**2 * (four + d4)
    # a small eigenproblem errs by a share of its largest eigenvalue: one way round the lowest modes keep their digits,
    # the other way round the highest do
    direct, inverse = _eigenvalues(left, right), _eigenvalues(right, -left)
    lower = np.zeros(count)
    if direct is not None and direct[0][-1] + direct[1] < 0.0:
        mu = direct[0] + direct[1]
        lower = np.maximum(lower, (-rho * mu / (1.0 - mu))[::-1])
    if inverse is not None and inverse[0][0] - inverse[1] > 0.0:
        lower = np.maximum(lower, (rho / (1.0 + inverse[0] + inverse[1]))[::-1])
    upper = np.full(count, np.inf)
    direct, inverse = _eigenvalues(three + d3, four - d4), _eigenvalues(four - d4, three + d3)
    if direct is not None:
        upper = np.minimum(upper, direct[0] + direct[1])
    if inverse is not None and inverse[0][0] > inverse[1]:
        upper = np.minimum(upper, 1.0 / (inverse[0] - inverse[1])[::-1])
    if not (lower[0] > 0.0 and upper[-1] < rho):
        return None, None
    return lower * (1.0 - 8.0 * _EPS), upper * (1.0 + 8.0 * _EPS)


def _eigenvalues(left: Long, right: Long) -> tuple[Array, float] | None:
    """Eigenvalues of (left, right), ascending, and a bound of their error; None where right is not safely positive."""
    diagonal = right.diagonal()
    if not float(diagonal.min()) > 0.0:
        return None
    scale = 1.0 / np.sqrt(diagonal)
    scaling = scale[:, None] * scale
    a, b = (left * scaling).astype(np.float64), (right * scaling).astype(np.float64)
    # the unit diagonal less the rest of a row bounds the smallest eigenvalue of b (S. Gerschgorin)
    smallest = 2.0 - float(np.abs(b).sum(axis=1).max()) - len(b) * _EPS
    if smallest < 0.5:
        smallest = float(eigvalsh(b)[0]) - _SMALL_PROBLEM * len(b)
        if smallest < 0.01:
            return None
    try:
        values = np.asarray(eigvalsh(a, b), dtype=np.float64)
    except np.linalg.LinAlgError:
        return None
    size = max(float(np.abs(a).sum(axis=1).max()), float(np.abs(values).max()))
    return values, _SMALL_PROBLEM * len(b) * size / smallest**2
