"""Wet modes by Rayleigh-Ritz: (K + C - omega^2 (M + A)) a = 0 over heave, pitch and the girder's dry modes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from hullvib.arguments import is_whole
from hullvib.energies import energy_matrices, energy_rule
from hullvib.errors import ArgumentError, SolutionError
from hullvib.girder import Girder
from hullvib.modes import Modes, largest_amplitude
from hullvib.solving import Method
from hullvib.stodola import StodolaRitz
from hullvib.wet.added_mass import Flow
from hullvib.wet.motions import RIGID, GirderMotions, MixedField
from hullvib.wet.wet_modes import RigidMotion, WetModes

Array = NDArray[np.float64]

FUNCTIONS = 12
"""Dry modes in a wet mode."""
_TAIL_STEPS = 50
_LEAST_TAIL = 0.5  # of the added mass: the tail is the first term of a series


def solve(
    girder: Girder,
    flow: Flow,
    method: Method | None = None,
    modes: int = 5,
    *,
    functions: int = FUNCTIONS,
    hydrostatics: bool = True,
    frequency_tail: bool = False,
) -> WetModes:
    """Natural frequencies and shapes of the first elastic modes of a girder afloat.

    Arguments: girder; flow, the water about the hull, `PanelFlow` for instance; method, what solves the dry girder, by
    default `StodolaRitz(functions=functions)`: its theory is that of the wet modes (`StodolaRitz(12, shear=True)` for a
    girder with shear deflection); modes, how many; functions, the number of dry elastic modes that the wet ones are
    made of, heave and pitch on top; hydrostatics, whether the waterline's buoyancy stiffens her; frequency_tail,
    whether the added mass has the factor 1 - 4 / (3 pi k), k = omega^2 B / (2 g), by which a semicircle's falls short
    of its limit (F. Ursell, 1953; the modes are then no longer quite orthogonal).

    Frequencies are upper bounds of those of the girder with the flow's added mass. Raises ArgumentError, SolutionError.
    """
    if not is_whole(functions, 1, 400):
        raise ArgumentError(f"functions is {functions!r}; give 1 to 400 dry modes.")
    if not is_whole(modes, 1, functions):
        raise ArgumentError(
            f"{modes} wet modes were asked of {functions} dry ones; ask for 1 to {functions} or give more functions."
        )
    dry = (StodolaRitz(functions=functions) if method is None else method).solve(girder, functions)
    motions = GirderMotions(dry)
    rule = energy_rule(girder, [motions.field], functions + RIGID, np.array([0.0, 1.0]))
    mass, strain = energy_matrices(girder, motions.field, rule, rotary=dry.rotary, shear=dry.shear_flexible)
    added = flow.added_mass(motions)
    buoyancy = flow.hydrostatic_stiffness(motions) if hydrostatics else np.zeros_like(mass)
    stiffness = strain + buoyancy

    def eigen(factor: float) -> tuple[Array, Array, Array]:
        return _eigenpairs(stiffness, mass + factor * added.matrix, mass)

    squares, vectors, shares = eigen(1.0)
    heave, pitch = _rigid_modes(shares)
    elastic = [n for n in range(len(squares)) if n not in (heave, pitch)][:modes]
    factors = np.ones(modes)
    if frequency_tail:
        pick = [_with_tail(eigen, n, mass + added.matrix, flow.breadth_m / flow.gravity_m_s2) for n in elastic]
        squares, vectors = squares.copy(), vectors.copy()
        for n, (square, vector, _) in zip(elastic, pick, strict=True):
            squares[n], vectors[:, n] = square, vector
        factors = np.array([factor for _, _, factor in pick])
    coefficients = vectors[:, elastic].T
    field = MixedField(dry, coefficients)
    aft = field.evaluate(np.array([0.0]), 0)[:, 0]
    scale = np.where(aft < 0.0, -1.0, 1.0) / largest_amplitude(field)
    coefficients = coefficients * scale[:, None]
    of_ship, of_water, of_buoyancy, whole = (
        np.einsum("nj,jk,nk->n", coefficients, matrix, coefficients)
        for matrix in (mass, added.matrix, buoyancy, stiffness)
    )
    of_water = of_water * factors
    record: dict[str, Any] = {
        **{f"dry_{key}" if key == "method" else key: value for key, value in dry.method.items()},
        "method": "wet_ritz",
        "functions": functions,
        "hydrostatics": hydrostatics,
        "frequency_tail": frequency_tail,
        **added.record,
        "asymmetry": added.asymmetry,
    }
    wet = Modes(
        np.sqrt(squares[elastic]),
        of_ship + of_water,
        girder,
        MixedField(dry, coefficients),
        np.ones(modes),
        record,
        theory=dry.theory,
        medium="wet",
        rotary=dry.rotary,
    )

    def rigid(n: int) -> RigidMotion:
        return RigidMotion(float(np.sqrt(max(squares[n], 0.0))), float(shares[:, n].sum()))

    return WetModes(
        modes=wet,
        dry=dry,
        heave=rigid(heave),
        pitch=rigid(pitch),
        added_mass=added,
        coefficients=coefficients,
        generalised_mass=of_ship,
        generalised_added_mass=of_water,
        hydrostatic_stiffness_share=of_buoyancy / whole,
        tail=factors,
    )


def _eigenpairs(stiffness: Array, inertia: Array, mass: Array) -> tuple[Array, Array, Array]:
    """Squares of the frequencies, vectors in columns, and the shares of heave and of pitch in each, (2, n).

    The shares are those of the kinetic energy, water included, that the two rigid-body motions hold: 1 in all for a
    mode that is nothing else. Pitch is taken about the point where it is free of heave.
    """
    size = 1.0 / np.sqrt(mass.diagonal())
    scaled = inertia * np.outer(size, size)
    try:
        squares, vectors = eigh(stiffness * np.outer(size, size), scaled)
    except np.linalg.LinAlgError:
        raise SolutionError(
            "the mass with the added mass is not positive definite; check the panels, or give fewer functions."
        ) from None
    momentum = scaled[:RIGID] @ vectors
    heave = momentum[0] / np.sqrt(scaled[0, 0])
    pitch = momentum[1] - momentum[0] * scaled[0, 1] / scaled[0, 0]
    pitch /= np.sqrt(scaled[1, 1] - scaled[0, 1] ** 2 / scaled[0, 0])
    return squares, vectors * size[:, None], np.stack([heave**2, pitch**2])


def _rigid_modes(shares: Array) -> tuple[int, int]:
    """Which vectors are heave and pitch: the two with most rigid-body motion in them."""
    first, second = np.argsort(-shares.sum(axis=0), kind="stable")[:RIGID]
    if shares[0, first] + shares[1, second] >= shares[1, first] + shares[0, second]:
        return int(first), int(second)
    return int(second), int(first)


def _with_tail(
    eigen: Callable[[float], tuple[Array, Array, Array]], mode: int, inertia: Array, breadth_over_gravity: float
) -> tuple[float, Array, float]:
    """One mode's square, vector and the factor of its added mass, which depends on the frequency.

    The mode is followed by its shape, over the whole inertia, from step to step.
    """
    squares, vectors, _ = eigen(1.0)
    square, vector = float(squares[mode]), vectors[:, mode]
    for _ in range(_TAIL_STEPS):
        waves = square * breadth_over_gravity / 2.0
        factor = 1.0 - 4.0 / (3.0 * np.pi * max(waves, 1e-300))
        if factor < _LEAST_TAIL:
            break
        squares, vectors, _ = eigen(factor)
        mode = int(np.argmax(np.abs(vector @ inertia @ vectors) / np.sqrt(np.diagonal(vectors.T @ inertia @ vectors))))
        change, square, vector = abs(float(squares[mode]) / square - 1.0), float(squares[mode]), vectors[:, mode]
        if change < 1e-12:
            return square, vector, factor
    raise SolutionError(
        f"a mode near {np.sqrt(square) / (2 * np.pi):.3g} Hz makes waves: its added mass lies far from the limit of "
        "high frequency, and frequency_tail does not hold; leave it out."
    )
