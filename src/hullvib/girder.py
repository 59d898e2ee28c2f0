"""The girder: mass per length and rigidity along the ship, as polynomial pieces between breakpoints."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib import bernstein
from hullvib.errors import GirderError
from hullvib.girder_checks import checked_breaks, checked_pieces, checked_rows
from hullvib.girder_fit import fitted_pieces
from hullvib.girder_pieces import (
    NEAR,
    Table,
    cut,
    labelled,
    pieces_of_polynomials,
    pieces_of_table,
    pieces_of_tables,
    present,
)
from hullvib.point_masses import PointMass

if TYPE_CHECKING:
    from typing import Self

Array = NDArray[np.float64]


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

    Who uses the optional properties: `TimoshenkoRitz` and `TimoshenkoElements` the shear rigidity and, unless told
    otherwise, the rotary inertia, of point masses too; `StodolaRitz(shear=True)` the shear rigidity alone;
    `FiniteElements(rotary_inertia=True)` the rotary inertia alone. `StodolaRitz()`, `Ritz`, `FiniteElements()` and
    `solve_many` solve the Euler-Bernoulli beam without either; results say so in `Modes.theory`.

    A girder is immutable, can be pickled, and is equal to another of the same content; the name is a label and does
    not count. `residual` is the relative residual of the fit of `from_functions`, 0 for a girder of any other origin.
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
        columns = labelled(mass_per_length, flexural_rigidity, shear_rigidity, rotary_inertia)
        breaks, pieces = pieces_of_table(x, columns)
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
        given = labelled(mass, rigidity, shear_rigidity, rotary_inertia)
        breaks, pieces = pieces_of_tables(given)
        return cls._of(breaks, pieces, point_masses, name)

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
        given = labelled(mass, rigidity, shear_rigidity, rotary_inertia)
        edges, pieces = pieces_of_polynomials(breaks, given)
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
        given = labelled(mass, rigidity, shear_rigidity, rotary_inertia)
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
        values = (breaks + 0.0, present(mass), present(rigidity), shear, rotary)
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
            near = np.abs(girder.breaks - position).min() <= NEAR * self.length
            if not near:
                girder = girder._cut(float(position))
        return girder

    def _cut(self, position: float) -> Girder:
        if not 0.0 < position < self.length:
            raise GirderError(f"cannot cut at x = {position:g} m; the girder runs from 0 to {self.length:g} m.")
        piece = int(np.searchsorted(self.breaks, position)) - 1
        t = (position - self.breaks[piece]) / (self.breaks[piece + 1] - self.breaks[piece])
        pieces = [None if c is None else cut(c, piece, t) for c in self._properties()]
        breaks = np.insert(self.breaks, piece + 1, position)
        return _restore(breaks, pieces, self.point_masses, self.name, self.residual)

    def _properties(self) -> tuple[Array, Array, Array | None, Array | None]:
        return (
            self.mass_coefficients,
            self.flexural_rigidity_coefficients,
            self.shear_rigidity_coefficients,
            self.rotary_inertia_coefficients,
        )

    def _evaluate(self, coefficients: Array, x: ArrayLike) -> Array:
        positions = np.asarray(x, dtype=np.float64)
        slack = NEAR * self.length
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
