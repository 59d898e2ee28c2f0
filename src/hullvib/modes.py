"""The result of a solution: natural frequencies, mode shapes and what is read off them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError, SolutionError
from hullvib.fields import Field, LoadedField
from hullvib.forces import InertiaLoads, inertia_loads, section_rotation
from hullvib.girder import Girder

Array = NDArray[np.float64]
Normalisation = Literal["largest-amplitude", "unit-modal-mass", "paper"]

SHEAR_THEORIES = ("Timoshenko", "shear-flexible")
"""Theories with shear strain, with and without rotary inertia."""

_NORMALISATIONS: dict[str, str] = {
    "largest-amplitude": "largest |amplitude| 1, positive at the aft end",
    "unit-modal-mass": "unit modal mass (1 kg), positive at the aft end",
    "paper": "integral of the square over x equal to L, positive at the aft end",
}


@dataclass(frozen=True, eq=False)
class Modes:
    """Elastic modes of a girder, lowest first; rigid-body modes are never among them.

    angular_frequencies (modes,) in rad/s; modal_mass (modes,) in kg for the normalisation in force; theory and medium
    say what was solved; method is the record of how (`{"method": "ritz", "functions": 12, ...}`); rotary tells whether
    the girder's rotary inertia took part. A shape is a deflection in metres where its largest value counts as 1 m:
    rotations are then in rad, moments in N m, shear forces in N.

    Signs: Phi is positive up and x forward. The bending moment M = EI d psi/dx (EI Phi'' without shear) is positive in
    sagging, keel in tension, opposite to still-water diagrams that count hogging positive. The shear force is
    V = omega^2 int_0^x m Phi, dM/dx = V without rotary inertia, and the shear strain is -V / kGA.
    Raises SolutionError for a frequency, modal mass or scale that is 0 or not finite.
    """

    angular_frequencies: Array
    modal_mass: Array
    girder: Girder
    field: Field
    scale: Array
    method: Mapping[str, Any]
    normalisation: Normalisation = "largest-amplitude"
    theory: str = "Euler-Bernoulli"
    medium: str = "dry"
    rotary: bool = False

    def __post_init__(self) -> None:
        for key in ("angular_frequencies", "modal_mass", "scale"):
            own = np.array(getattr(self, key), dtype=np.float64)
            wrong = ~np.isfinite(own) | (own == 0.0)
            if wrong.any():
                raise SolutionError(
                    f"{key.replace('_', ' ')} {own[wrong][0]:g} came out: the girder's numbers are too large or too "
                    "small for each other; give mass in kg, length in m and rigidity in N m^2."
                )
            own.flags.writeable = False
            object.__setattr__(self, key, own)

    @property
    def frequencies_hz(self) -> Array:
        """Natural frequencies in Hz, (modes,)."""
        return self.angular_frequencies / (2.0 * np.pi)

    @property
    def cycles_per_minute(self) -> Array:
        """Natural frequencies in cycles per minute, (modes,)."""
        return self.angular_frequencies * (30.0 / np.pi)

    @property
    def modal_stiffness(self) -> Array:
        """omega^2 times the modal mass in N/m, (modes,), for the normalisation in force."""
        return self.angular_frequencies**2 * self.modal_mass

    @property
    def shear_flexible(self) -> bool:
        """Whether the theory admits shear strain."""
        return self.theory in SHEAR_THEORIES

    @property
    def normalisation_note(self) -> str:
        """The normalisation and the sign rule in words, for legends."""
        return _NORMALISATIONS[self.normalisation]

    def shape(self, x: ArrayLike) -> Array:
        """Phi at x (points,) in m, (modes, points)."""
        return self._evaluate(x, 0)

    def slope(self, x: ArrayLike) -> Array:
        """dPhi/dx in 1/m at x (points,) in m, (modes, points)."""
        return self._evaluate(x, 1)

    def curvature(self, x: ArrayLike) -> Array:
        """d2Phi/dx2 in 1/m^2 at x (points,) in m, (modes, points)."""
        return self._evaluate(x, 2)

    def rotation(self, x: ArrayLike) -> Array:
        """Angle psi of the sections in rad/m at x (points,) in m, (modes, points): the slope but for Timoshenko."""
        return self._rotation(x, 0)

    def bending_curvature(self, x: ArrayLike) -> Array:
        """d psi/dx in 1/m^2 at x (points,) in m, (modes, points): what EI turns into the bending moment."""
        return self._rotation(x, 1)

    def shear_strain(self, x: ArrayLike) -> Array:
        """dPhi/dx - psi in 1/m at x (points,) in m, (modes, points): -V / kGA; 0 but for a shear-flexible theory."""
        return self.slope(x) - self.rotation(x)

    def moment(self, x: ArrayLike) -> Array:
        """Bending moment in N m per metre of the shape at x (points,) in m, (modes, points), positive in sagging.

        Of the sign of EI d psi/dx: positive where the girder is bent concave upwards.

        From the equilibrium of the inertia loads (`hullvib.forces`), which is smooth where the curvature is poor;
        forward of a point mass where one stands, aft of it at the fore end.
        """
        xi = self._checked(x)
        own = self.field.moment(xi) if isinstance(self.field, LoadedField) else self._loads.forces(xi)[0]
        return np.asarray(self.scale[:, None] * own, dtype=np.float64)

    def shear(self, x: ArrayLike) -> Array:
        """Shear force V in N per metre of the shape at x (points,) in m, (modes, points), V = omega^2 int_0^x m Phi.

        dM/dx = V where no rotary inertia acts, and the shear strain is -V / kGA; forward of a point mass where one
        stands, aft of it at the fore end.
        """
        xi = self._checked(x)
        own = self.field.shear(xi) if isinstance(self.field, LoadedField) else self._loads.forces(xi)[1]
        return np.asarray(self.scale[:, None] * own, dtype=np.float64)

    def normalised(self, normalisation: Normalisation) -> Modes:
        """The same modes scaled anew.

        "largest-amplitude": largest |Phi| is 1 (the default); "unit-modal-mass": integral m Phi^2 dx = 1 kg;
        "paper": integral Phi^2 dx = L, for which the uniform beam has Phi_j(0) = 2. Always positive at the aft end.
        Raises ArgumentError.
        """
        unit = self.scale / np.sqrt(self.modal_mass)
        if normalisation == "unit-modal-mass":
            scale = unit
        elif normalisation == "paper":
            scale = np.sign(self.scale) / np.sqrt(self.field.mean_square())
        elif normalisation == "largest-amplitude":
            scale = np.sign(self.scale) / largest_amplitude(self.field)
        else:
            known = ", ".join(repr(key) for key in _NORMALISATIONS)
            raise ArgumentError(f"normalisation {normalisation!r} is not known; choose one of {known}.")
        return replace(self, scale=scale, modal_mass=(scale / unit) ** 2, normalisation=normalisation)

    def nodes(self) -> list[Array]:
        """Positions in m where each shape is zero, ascending, one array a mode."""
        return list(self._nodes)

    def antinodes(self) -> list[Array]:
        """Positions in m inside the girder where each shape is stationary, ascending, one array a mode."""
        return [self.girder.length * xi for xi in zero_positions(self.field, 1, len(self.scale))]

    @property
    def node_counts(self) -> NDArray[np.intp]:
        """Number of nodes of each mode, (modes,): n + 1 for mode n in the usual case."""
        return np.array([len(zeros) for zeros in self._nodes], dtype=np.intp)

    @cached_property
    def _nodes(self) -> list[Array]:
        return [self.girder.length * xi for xi in zero_positions(self.field, 0, len(self.scale))]

    @cached_property
    def _loads(self) -> InertiaLoads:
        return inertia_loads(self.girder, self.field, self.angular_frequencies, rotary=self.rotary)

    def _checked(self, x: ArrayLike) -> Array:
        xi = np.atleast_1d(np.asarray(x, dtype=np.float64)) / self.girder.length
        if xi.ndim != 1 or not bool(np.all((xi >= -1e-9) & (xi <= 1.0 + 1e-9))):
            raise ArgumentError(f"x must be one-dimensional and lie within 0 .. {self.girder.length:g} m.")
        return np.asarray(np.clip(xi, 0.0, 1.0), dtype=np.float64)

    def _evaluate(self, x: ArrayLike, derivative: int) -> Array:
        values = self.field.evaluate(self._checked(x), derivative)
        return np.asarray(self.scale[:, None] / self.girder.length**derivative * values, dtype=np.float64)

    def _rotation(self, x: ArrayLike, derivative: int) -> Array:
        values = section_rotation(self.field, self._checked(x), derivative)
        return np.asarray(self.scale[:, None] / self.girder.length ** (derivative + 1) * values, dtype=np.float64)


def zero_positions(field: Field, derivative: int, modes: int) -> list[Array]:
    """Sign changes inside 0..1 of a derivative of each mode of a field: a grid, then Newton kept in its bracket."""
    # an even number of points never puts midships, a zero of every second symmetric mode, on the grid
    grid = np.linspace(0.0, 1.0, 40 * (modes + 4) + 2)
    positive = field.evaluate(grid, derivative) >= 0.0
    mode, cell = np.nonzero(positive[:, 1:] != positive[:, :-1])
    if len(mode) == 0:
        return [np.empty(0) for _ in range(modes)]
    low, high = grid[cell], grid[cell + 1]
    rising = positive[mode, cell + 1]
    pick = (mode, np.arange(len(mode)))
    x = 0.5 * (low + high)
    for _ in range(60):  # as many halvings as a double has bits, should Newton fail throughout
        value = field.evaluate(x, derivative)[pick]
        below = (value >= 0.0) != rising
        low, high = np.where(below, x, low), np.where(below, high, x)
        gradient = field.evaluate(x, derivative + 1)[pick]
        newton = x - np.divide(value, gradient, out=np.full_like(x, np.inf), where=gradient != 0.0)
        following = np.where((newton >= low) & (newton <= high), newton, 0.5 * (low + high))
        step, x = np.abs(following - x).max(), following
        if step < 1e-15:
            break
    return [x[mode == n] for n in range(modes)]


def largest_amplitude(field: Field) -> Array:
    """Largest |value| of each function of a field over 0..1, (modes,): a grid, then one parabola's top a mode."""
    first = field.evaluate(np.array([0.0]), 0)
    grid = np.linspace(0.0, 1.0, 40 * (len(first) + 4) + 2)
    values = np.abs(field.evaluate(grid, 0))
    rows = np.arange(len(values))
    best = values.argmax(axis=1)
    position = grid[best]
    inside = (best > 0) & (best < len(grid) - 1)
    if inside.any():
        for _ in range(3):  # Newton on the slope, from a start good to 1/200 of the length
            slope = field.evaluate(position, 1)[rows, rows]
            curvature = field.evaluate(position, 2)[rows, rows]
            step = np.divide(slope, curvature, out=np.zeros_like(slope), where=inside & (curvature != 0.0))
            position = np.clip(
                position - step, grid[np.maximum(best - 1, 0)], grid[np.minimum(best + 1, len(grid) - 1)]
            )
    refined = np.abs(field.evaluate(position, 0)[rows, rows])
    return np.asarray(np.maximum(refined, values[rows, best]), dtype=np.float64)


def modes_of_field(
    girder: Girder,
    angular_frequencies: Array,
    field: Field,
    modal_mass_kg: float,
    method: Mapping[str, Any],
    theory: str = "Euler-Bernoulli",
    *,
    rotary: bool = False,
) -> Modes:
    """Modes in the default normalisation from a field whose functions all have the given modal mass in kg."""
    aft = field.evaluate(np.array([0.0]), 0)[:, 0]
    scale = np.where(aft < 0.0, -1.0, 1.0) / largest_amplitude(field)
    return Modes(
        angular_frequencies, scale**2 * modal_mass_kg, girder, field, scale, dict(method), theory=theory, rotary=rotary
    )
