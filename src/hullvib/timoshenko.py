"""Timoshenko's beam by a Ritz series in two fields: the deflection and the angle of the sections.

    2 U = int EI psi'^2 + kGA (w' - psi)^2 dx,   2 T = int m w_t^2 + J psi_t^2 dx

(S. Timoshenko, Vibration Problems in Engineering, 3rd ed., section 54). Each bending function turns the sections by its
own slope, each shear function leaves them upright; so one has no shear strain and the other no curvature, the stiffness
matrix falls into two blocks without small differences of large numbers, and nothing locks as kGA grows.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hullvib.arguments import is_whole
from hullvib.errors import ArgumentError
from hullvib.fields import TimoshenkoSeries
from hullvib.finite_elements import has_rotary_inertia, rotary_note
from hullvib.girder import Girder
from hullvib.legendre import LegendreTrials
from hullvib.modes import Modes, modes_of_field
from hullvib.ritz import Basis, RitzPencil, check_basis, trials_of
from hullvib.timoshenko_elements import shear_rigidity_of, theory_name
from hullvib.trials import Trials

Array = NDArray[np.float64]


@dataclass(frozen=True)
class TimoshenkoRitz:
    """Rayleigh-Ritz method for Timoshenko's beam with `functions` elastic functions of bending and as many of shear.

    basis="legendre" (the default) or "uniform", as `Ritz` has them; rigid-body motion comes on top, exactly. The girder
    must have a shear rigidity. Its rotary inertia takes part where it has any, unless rotary_inertia=False; without it
    the theory is called "shear-flexible". Frequencies are upper bounds. On girders with many jumps, more than one for
    every other function, `TimoshenkoElements` is the sharper method. Raises ArgumentError.
    """

    functions: int = 20
    basis: Basis = "legendre"
    rotary_inertia: bool = True

    def __post_init__(self) -> None:
        check_basis(self.basis, self.functions)

    def solve(self, girder: Girder, modes: int) -> Modes:
        """The first `modes` elastic modes. Raises ArgumentError, SolutionError."""
        if not is_whole(modes, 1, self.functions):
            raise ArgumentError(
                f"{modes} modes were asked of {self.functions} trial functions; ask for 1 to {self.functions} "
                "or give more functions."
            )
        shear_rigidity_of(girder)
        rotary = self.rotary_inertia and has_rotary_inertia(girder)
        trials = trials_of(girder, self.functions, self.basis)
        pencil = two_field_pencil(girder, trials, rotary=rotary)
        eigenvalues, elastic, rigid = pencil.solve(modes, rigid_body=True)
        record: dict[str, Any] = {"method": "timoshenko_ritz", "functions": self.functions, "basis": self.basis}
        if isinstance(trials, LegendreTrials):
            record["stretches"] = len(trials.counts)
        record["rotary_inertia"] = rotary_note(girder, wanted=self.rotary_inertia)
        bending = trials.sizes[0]
        field = TimoshenkoSeries(trials, rigid, elastic[:, :bending], elastic[:, bending:])
        omega = np.sqrt(eigenvalues) * pencil.unit_frequency
        return modes_of_field(girder, omega, field, pencil.unit_mass, record, theory_name(rotary), rotary=rotary)


def two_field_pencil(girder: Girder, trials: Trials, *, rotary: bool) -> RitzPencil:
    """Assembles stiffness and mass of the bending functions followed by the shear functions."""
    length, total = girder.length, girder.total_mass
    shear_pieces, turning = shear_rigidity_of(girder), girder.rotary_inertia_coefficients if rotary else None
    mass_pieces, rigidity_pieces = girder.mass_coefficients, girder.flexural_rigidity_coefficients
    largest = float(rigidity_pieces.max())
    pieces = [p for p in (mass_pieces, rigidity_pieces, shear_pieces, turning) if p is not None]
    rule = trials.rule(girder.breaks / length, max(p.shape[1] for p in pieces) - 1)
    xi, weights = rule.xi.ravel(), rule.weights.ravel()
    bent, turned, curved = trials.bending(xi, (0, 1, 2))
    sheared, strained = trials.shearing(xi, (0, 1))
    n, total_size = len(bent), len(bent) + len(sheared)
    stiffness = np.zeros((total_size, total_size))
    stiffness[:n, :n] = (curved * (rule.of(rigidity_pieces) * weights / largest)) @ curved.T
    stiffness[n:, n:] = (strained * (rule.of(shear_pieces) * weights * (length**2 / largest))) @ strained.T
    inertia = rule.of(mass_pieces) * (weights * (length / total))
    mass, coupling, rigid = _inertia(np.vstack([bent, sheared]), _rigid_deflections(xi), inertia)
    angles, rigid_angles = np.vstack([turned, np.zeros_like(sheared)]), _rigid_angles(xi)
    at = np.array([p.x_m for p in girder.point_masses]) / length
    contributions = []
    if turning is not None:
        contributions.append(_inertia(angles, rigid_angles, rule.of(turning) * weights / (length * total)))
    if len(at):
        parts = np.array([p.mass_kg for p in girder.point_masses]) / total
        deflections = np.vstack([trials.bending(at, (0,))[0], trials.shearing(at, (0,))[0]])
        contributions.append(_inertia(deflections, _rigid_deflections(at), parts))
    if len(at) and rotary:
        parts = np.array([p.rotary_inertia_kg_m2 for p in girder.point_masses]) / (total * length**2)
        turns = np.vstack([trials.bending(at, (1,))[0], np.zeros((len(sheared), len(at)))])
        contributions.append(_inertia(turns, _rigid_angles(at), parts))
    for more_mass, more_coupling, more_rigid in contributions:
        mass += more_mass
        coupling += more_coupling
        rigid += more_rigid
    unit = float(np.sqrt(largest / (total * length**3)))
    return RitzPencil(stiffness, mass, coupling, rigid, np.ones(total_size), unit, total)


def _rigid_deflections(xi: Array) -> Array:
    return np.stack([np.ones_like(xi), 2.0 * xi - 1.0])


def _rigid_angles(xi: Array) -> Array:
    return np.stack([np.zeros_like(xi), np.full_like(xi, 2.0)])


def _inertia(functions: Array, rigid: Array, weights: Array) -> tuple[Array, Array, Array]:
    loaded = functions * weights
    return loaded @ functions.T, rigid @ loaded.T, (rigid * weights) @ rigid.T
