"""The girder: mass per length and rigidity along the ship, as polynomial pieces between breakpoints."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib import bernstein
from hullvib.errors import GirderError
from hullvib.girder_checks import checked_breaks, checked_pieces, checked_rows, checked_table
from hullvib.girder_fit import fitted_pieces

if TYPE_CHECKING:
    from typing import Self

Array = NDArray[np.float64]
Table = tuple[ArrayLike, ArrayLike]

_NEAR = 1e-9  # of the length: breakpoints of two tables that are closer than this are one


@dataclass(frozen=True, slots=True)
class PointMass:
    """A mass at one position: x_m (m), mass_kg (kg), rotary inertia about its own centre (kg m^2)."""

    x_m: float
    mass_kg: float
    rotary_inertia_kg_m2: float = 0.0

    def __post_init__(self) -> None:
        for key in ("x_m", "mass_kg", "rotary_inertia_kg_m2"):
            value = getattr(self, key)
            if not np.isfinite(value) or (key != "x_m" and value < 0.0):
                raise GirderError(f"point mass: {key} is {value}; give a finite number, not negative.")
            object.__setattr__(self, key, float(value) + 0.0)


class _Content(NamedTuple):
    breaks: bytes
    pieces: tuple[tuple[tuple[int, ...], bytes] | None, ...]
    point_masses: tuple[PointMass, ...]


class Girder:
    """A free-free hull girder, x from the aft end, positive forward.

    The constructor takes tables, linear between breakpoints; two equal x in a row are a jump.

    Arguments: x (n,) in m, from 0; mass_per_length (n,) in kg/m, >= 0; flexural_rigidity (n,) EI in N m^2, > 0 except
    at the two ends of the beam; shear_rigidity (n,) kGA in N, > 0, and rotary_inertia (n,) in kg m, >= 0, both
    optional; point_masses; name. Raises GirderError.

    Shear rigidity and rotary inertia (of point masses too) are kept, written and read back. The methods of this
    package that solve the Euler-Bernoulli beam do not use them, and their results say so: `Modes.theory`.

    A girder is immutable, can be pickled, and is equal to another of the same content; the name is a label and does
    not count. `residual` is the relative residual of the fit of `from_functions`, 0 for every other origin.
    """

    __slots__ = (
        "_hash",
        "breaks",
        "flexural_rigidity_coefficients",
        "mass_coefficients",
        "name",
        "point_masses",
        "residual",
        "rotary_inertia_coefficients",
        "shear_rigidity_coefficients",
    )

    breaks: Array
    mass_coefficients: Array
    flexural_rigidity_coefficients: Array
    shear_rigidity_coefficients: Array | None
    rotary_inertia_coefficients: Array | None
    point_masses: tuple[PointMass, ...]
    name: str
    residual: float
    _hash: int

    def __init__(
        self,
        x: ArrayLike,
        mass_per_length: ArrayLike,
        flexural_rigidity: ArrayLike,
        shear_rigidity: ArrayLike | None = None,
        rotary_inertia: ArrayLike | None = None,
        point_masses: Iterable[PointMass] = (),
        name: str = "",
    ) -> None:
        columns = {
            "mass per length": mass_per_length,
            "flexural rigidity": flexural_rigidity,
            "shear rigidity": shear_rigidity,
            "rotary inertia": rotary_inertia,
        }
        positions, tables = checked_table(x, columns)
        bays = np.flatnonzero(np.diff(positions) > 0.0)
        breaks = np.append(positions[bays], positions[-1])
        pieces = [None if table is None else np.stack([table[bays], table[bays + 1]], axis=1) for table in tables]
        self._fill(breaks, pieces, point_masses, name)

    @classmethod
    def from_tables(
        cls,
        mass: Table,
        rigidity: Table,
        shear_rigidity: Table | None = None,
        rotary_inertia: Table | None = None,
        point_masses: Iterable[PointMass] = (),
        name: str = "",
    ) -> Self:
        """Girder from tables with breakpoints of their own, each (x in m, values), linear between, jumps allowed.

        All tables run from 0 to the same length. Raises GirderError.
        """
        given = {
            "mass per length": mass,
            "flexural rigidity": rigidity,
            "shear rigidity": shear_rigidity,
            "rotary inertia": rotary_inertia,
        }
        tables: list[tuple[Array, Array] | None] = []
        for label, table in given.items():
            if table is None:
                tables.append(None)
                continue
            positions, (values,) = checked_table(table[0], {label: table[1]})
            tables.append((positions, _present(values)))
        lengths = {label: t[0][-1] for label, t in zip(given, tables, strict=True) if t is not None}
        length = lengths["mass per length"]
        for label, end in lengths.items():
            if abs(end - length) > _NEAR * length:
                raise GirderError(
                    f"{label} ends at x = {end:g} m but mass per length at x = {length:g} m; "
                    "let every table run over the whole length."
                )
        merged = np.unique(np.concatenate([t[0] for t in tables if t is not None]))
        merged = merged[np.append(True, np.diff(merged) > _NEAR * length)]
        merged[-1] = length
        pieces = [None if table is None else _on_breaks(*table, merged) for table in tables]
        return cls._of(merged, pieces, point_masses, name)

    @classmethod
    def from_polynomials(
        cls,
        breaks: ArrayLike,
        mass: Sequence[ArrayLike],
        rigidity: Sequence[ArrayLike],
        shear_rigidity: Sequence[ArrayLike] | None = None,
        rotary_inertia: Sequence[ArrayLike] | None = None,
        point_masses: Iterable[PointMass] = (),
        name: str = "",
    ) -> Self:
        """Girder from one polynomial a piece and property.

        Coefficients are those of the power series in s = x - x_left of the piece, lowest power first:
        m(x) = a_0 + a_1 s + a_2 s^2 + ..., with s in metres. breaks (pieces + 1,) in m; mass, rigidity and the two
        optional properties hold `pieces` sequences, which may differ in length. Raises GirderError.
        """
        edges = checked_breaks(breaks)
        given = {
            "mass per length": mass,
            "flexural rigidity": rigidity,
            "shear rigidity": shear_rigidity,
            "rotary inertia": rotary_inertia,
        }
        pieces = [None if p is None else _power_to_bernstein(label, edges, p) for label, p in given.items()]
        return cls._of(edges, pieces, point_masses, name)

    @classmethod
    def from_bernstein(
        cls,
        breaks: ArrayLike,
        mass: ArrayLike,
        rigidity: ArrayLike,
        shear_rigidity: ArrayLike | None = None,
        rotary_inertia: ArrayLike | None = None,
        point_masses: Iterable[PointMass] = (),
        name: str = "",
    ) -> Self:
        """Girder from Bernstein coefficients, (pieces, degree + 1) a property, on breaks (pieces + 1,) in m."""
        edges = checked_breaks(breaks)
        given = {
            "mass per length": mass,
            "flexural rigidity": rigidity,
            "shear rigidity": shear_rigidity,
            "rotary inertia": rotary_inertia,
        }
        pieces = [None if rows is None else checked_rows(label, rows) for label, rows in given.items()]
        return cls._of(edges, pieces, point_masses, name)

    @classmethod
    def from_functions(
        cls,
        length: float,
        mass: Callable[[float], float],
        rigidity: Callable[[float], float],
        breakpoints: Sequence[float] = (),
        point_masses: Iterable[PointMass] = (),
        name: str = "",
    ) -> Self:
        """Girder from callables of x (m), smooth between the breakpoints, fitted by polynomials of degree 8.

        Pieces are halved until the fit holds to round-off at points between its own; what remains, relative to the
        largest value over the beam, is kept as `residual`. The callables are called strictly inside the pieces, so
        they may jump at a breakpoint. A jump or a kink that is not named as a breakpoint leaves a large residual.
        Raises GirderError.
        """
        edges = checked_breaks([0.0, *breakpoints, length])
        breaks, pieces, residual = fitted_pieces(edges, (mass, rigidity))
        girder = cls._of(breaks, [*pieces, None, None], point_masses, name)
        object.__setattr__(girder, "residual", residual)
        return girder

    @classmethod
    def _of(cls, breaks: Array, pieces: Sequence[Array | None], point_masses: Iterable[PointMass], name: str) -> Self:
        girder = cls.__new__(cls)
        girder._fill(breaks, pieces, point_masses, name)
        return girder

    def _fill(
        self, breaks: Array, pieces: Sequence[Array | None], point_masses: Iterable[PointMass], name: str
    ) -> None:
        masses = tuple(sorted(point_masses, key=lambda p: (p.x_m, p.mass_kg, p.rotary_inertia_kg_m2)))
        mass, rigidity, shear, rotary = checked_pieces(breaks, pieces, [(p.x_m, p.mass_kg) for p in masses])
        values = (breaks + 0.0, _present(mass), _present(rigidity), shear, rotary)
        for array in values:
            if array is not None:
                array.flags.writeable = False
        keys = (
            "breaks",
            "mass_coefficients",
            "flexural_rigidity_coefficients",
            "shear_rigidity_coefficients",
            "rotary_inertia_coefficients",
        )
        for key, value in zip(keys, values, strict=True):
            object.__setattr__(self, key, value)
        object.__setattr__(self, "point_masses", masses)
        object.__setattr__(self, "name", str(name))
        object.__setattr__(self, "residual", 0.0)
        object.__setattr__(self, "_hash", hash(self._content()))

    @property
    def length(self) -> float:
        """Length of the girder in m."""
        return float(self.breaks[-1])

    @property
    def total_mass(self) -> float:
        """Mass in kg, point masses included, exact from the coefficients."""
        spread = float(np.diff(self.breaks) @ bernstein.integral(self.mass_coefficients))
        return spread + sum(p.mass_kg for p in self.point_masses)

    @property
    def centre_of_gravity(self) -> float:
        """Position of the centre of mass in m from the aft end, point masses included."""
        widths = np.diff(self.breaks)
        means = bernstein.integral(self.mass_coefficients)
        moments = bernstein.first_moment(self.mass_coefficients)
        spread = float(widths @ (self.breaks[:-1] * means + widths * moments))
        return (spread + sum(p.mass_kg * p.x_m for p in self.point_masses)) / self.total_mass

    def mass_per_length(self, x: ArrayLike) -> Array:
        """m in kg/m at x (m), any shape, without the point masses; at a jump the value forward of it."""
        return self._evaluate(self.mass_coefficients, x)

    def flexural_rigidity(self, x: ArrayLike) -> Array:
        """EI in N m^2 at x (m), any shape; at a jump the value forward of it."""
        return self._evaluate(self.flexural_rigidity_coefficients, x)

    def shear_rigidity(self, x: ArrayLike) -> Array | None:
        """The shear rigidity kGA in N at x (m), or None where the girder has none."""
        coefficients = self.shear_rigidity_coefficients
        return None if coefficients is None else self._evaluate(coefficients, x)

    def rotary_inertia(self, x: ArrayLike) -> Array | None:
        """Mass moment of inertia per length in kg m at x (m), or None where the girder has none."""
        coefficients = self.rotary_inertia_coefficients
        return None if coefficients is None else self._evaluate(coefficients, x)

    def refined(self, positions: ArrayLike) -> Girder:
        """The same girder with further breakpoints at positions (m); the properties do not change."""
        girder = self
        for position in np.atleast_1d(np.asarray(positions, dtype=np.float64)):
            near = np.abs(girder.breaks - position).min() <= _NEAR * self.length
            if not near:
                girder = girder._cut(float(position))
        return girder

    def _cut(self, position: float) -> Girder:
        if not 0.0 < position < self.length:
            raise GirderError(f"cannot cut at x = {position:g} m; the girder runs from 0 to {self.length:g} m.")
        piece = int(np.searchsorted(self.breaks, position)) - 1
        t = (position - self.breaks[piece]) / (self.breaks[piece + 1] - self.breaks[piece])

        def cut(coefficients: Array | None) -> Array | None:
            if coefficients is None:
                return None
            parts = np.stack(bernstein.split(coefficients[piece], t))
            return np.concatenate([coefficients[:piece], parts, coefficients[piece + 1 :]])

        breaks = np.insert(self.breaks, piece + 1, position)
        return Girder._of(breaks, [cut(c) for c in self._properties()], self.point_masses, self.name)

    def _properties(self) -> tuple[Array, Array, Array | None, Array | None]:
        return (
            self.mass_coefficients,
            self.flexural_rigidity_coefficients,
            self.shear_rigidity_coefficients,
            self.rotary_inertia_coefficients,
        )

    def _evaluate(self, coefficients: Array, x: ArrayLike) -> Array:
        positions = np.asarray(x, dtype=np.float64)
        slack = _NEAR * self.length
        if not bool(np.all((positions >= -slack) & (positions <= self.length + slack))):
            raise GirderError(f"x lies outside the girder, which runs from 0 to {self.length:g} m.")
        piece = np.clip(np.searchsorted(self.breaks, positions, side="right") - 1, 0, len(self.breaks) - 2)
        left = self.breaks[piece]
        return bernstein.evaluate(coefficients[piece], (positions - left) / (self.breaks[piece + 1] - left))

    def _content(self) -> _Content:
        pieces = tuple(None if c is None else (c.shape, c.tobytes()) for c in self._properties())
        return _Content(self.breaks.tobytes(), pieces, self.point_masses)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Girder):
            return NotImplemented
        return self is other or (self._hash == other._hash and self._content() == other._content())

    def __hash__(self) -> int:
        return self._hash

    def __setattr__(self, key: str, value: object) -> None:
        raise AttributeError(f"a Girder is immutable: build a new one instead of setting {key!r}")

    def __delattr__(self, key: str) -> None:
        raise AttributeError(f"a Girder is immutable: {key!r} cannot be deleted")

    def __reduce__(self) -> tuple[Any, ...]:
        return _restore, (self.breaks, self._properties(), self.point_masses, self.name, self.residual)

    def __repr__(self) -> str:
        label = f"{self.name!r}, " if self.name else ""
        return (
            f"Girder({label}length={self.length:g} m, mass={self.total_mass / 1000.0:g} t, "
            f"{len(self.breaks) - 1} pieces, {len(self.point_masses)} point masses)"
        )


def _restore(
    breaks: Array,
    pieces: Sequence[Array | None],
    point_masses: Iterable[PointMass],
    name: str,
    residual: float,
) -> Girder:
    girder = Girder._of(breaks, pieces, point_masses, name)
    object.__setattr__(girder, "residual", residual)
    return girder


def _present(values: Array | None) -> Array:
    if values is None:
        raise GirderError("mass per length and flexural rigidity are both needed; one of them is missing.")
    return values


def _on_breaks(x: Array, values: Array, breaks: Array) -> Array:
    """End values of a table's lines on the pieces of a finer partition, (pieces, 2)."""
    middle = 0.5 * (breaks[:-1] + breaks[1:])
    bay = np.clip(np.searchsorted(x, middle, side="right") - 1, 0, len(x) - 2)
    width = x[bay + 1] - x[bay]
    ends = []
    for edge in (breaks[:-1], breaks[1:]):
        t = np.clip((edge - x[bay]) / width, 0.0, 1.0)
        ends.append(values[bay] * (1.0 - t) + values[bay + 1] * t)
    return np.stack(ends, axis=1)


def _power_to_bernstein(label: str, breaks: Array, polynomials: Sequence[ArrayLike]) -> Array:
    rows = [np.atleast_1d(checked_rows(label, p)) for p in polynomials]
    if len(rows) != len(breaks) - 1:
        raise GirderError(
            f"{label} holds {len(rows)} polynomials but {len(breaks)} breaks make {len(breaks) - 1} pieces; "
            "give one polynomial a piece."
        )
    size = max(len(row) for row in rows)
    if size == 0 or any(row.ndim != 1 or len(row) == 0 for row in rows):
        raise GirderError(f"{label} has an empty polynomial; give at least its constant coefficient.")
    power = np.zeros((len(rows), size))
    for row, coefficients in zip(power, rows, strict=True):
        row[: len(coefficients)] = coefficients
    return bernstein.from_power(power, np.diff(breaks))
