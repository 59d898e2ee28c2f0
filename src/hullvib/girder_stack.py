"""Many girders on shared breakpoints: the variants of a design, with a leading dimension."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import GirderError
from hullvib.girder import Girder
from hullvib.girder_checks import checked_breaks
from hullvib.point_masses import PointMass

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class GirderStack:
    """Girders whose pieces end at the same places.

    breaks (pieces + 1,) in m from 0; mass (girders, pieces, d + 1) in kg/m and rigidity (girders, pieces, e + 1) in
    N m^2 are the Bernstein coefficients of the pieces, for lines the values at their two ends; all finite, of the mass
    none negative, of the rigidity all positive. Point masses stand at the places point_x (points,) in m, which all
    girders share, with point_mass (girders, points) in kg. The stack keeps copies, which cannot be written to. Raises
    GirderError.
    """

    breaks: Array
    mass: Array
    rigidity: Array
    point_x: Array = field(default_factory=lambda: np.empty(0))
    point_mass: Array | None = None

    def __post_init__(self) -> None:
        breaks = checked_breaks(self.breaks)
        points = _numbers("point_x", self.point_x)
        mass, rigidity = _numbers("mass", self.mass), _numbers("rigidity", self.rigidity)
        count = len(mass) if mass.ndim else 0
        if count == 0:
            raise GirderError(f"mass has the shape {mass.shape}; a stack needs at least one girder.")
        if points.ndim != 1:
            raise GirderError(f"point_x has the shape {points.shape}; give the places in one dimension.")
        lumps = np.zeros((count, len(points)))
        if self.point_mass is not None:
            lumps = _numbers("point_mass", self.point_mass)
        for name, values, positive in (("mass", mass, False), ("rigidity", rigidity, True)):
            if values.ndim != 3 or values.shape[:2] != (count, len(breaks) - 1) or values.shape[2] < 2:
                raise GirderError(
                    f"{name} has the shape {values.shape}; give ({count} girders, {len(breaks) - 1} pieces, 2 or more "
                    "coefficients)."
                )
            wrong = ~np.isfinite(values) | (values <= 0.0 if positive else values < 0.0)
            if wrong.any():
                place = np.argwhere(wrong)[0]
                raise GirderError(
                    f"{name} is {values[tuple(place)]:g} in girder {place[0]}, piece {place[1]}; a stack takes finite "
                    f"numbers, {'positive' if positive else 'not negative'}: solve that girder alone."
                )
        inside = (points >= 0.0) & (points <= breaks[-1])
        if (
            lumps.shape != (count, len(points))
            or not bool(inside.all() and np.isfinite(lumps).all())
            or (lumps < 0).any()
        ):
            raise GirderError(
                f"point masses have the shape {lumps.shape}; give ({count} girders, {len(points)} places), finite and "
                f"not negative, at places within 0 .. {breaks[-1]:g} m."
            )
        own = {"breaks": breaks, "mass": mass, "rigidity": rigidity, "point_x": points, "point_mass": lumps}
        for name, values in own.items():
            values.flags.writeable = False
            object.__setattr__(self, name, values)

    @classmethod
    def from_girders(cls, girders: Sequence[Girder]) -> GirderStack:
        """Stack of girders with equal breakpoints, equal degrees and point masses at equal places."""
        if len(girders) == 0:
            raise GirderError("a stack needs at least one girder.")
        first = girders[0]
        places = [p.x_m for p in first.point_masses]
        for number, girder in enumerate(girders):
            same = (
                np.array_equal(girder.breaks, first.breaks)
                and girder.mass_coefficients.shape == first.mass_coefficients.shape
                and girder.flexural_rigidity_coefficients.shape == first.flexural_rigidity_coefficients.shape
                and [p.x_m for p in girder.point_masses] == places
            )
            if not same:
                raise GirderError(
                    f"girder {number} has other breakpoints, degrees or places of point masses than girder 0; refine "
                    "them to shared breakpoints first."
                )
        return cls(
            first.breaks,
            np.stack([g.mass_coefficients for g in girders]),
            np.stack([g.flexural_rigidity_coefficients for g in girders]),
            np.array(places),
            np.array([[p.mass_kg for p in g.point_masses] for g in girders]).reshape(len(girders), len(places)),
        )

    def __len__(self) -> int:
        return len(self.mass)

    def girder(self, number: int) -> Girder:
        """One girder of the stack."""
        masses = zip(self.point_x, self.lumps[number], strict=True)
        points = [PointMass(float(x), float(mass)) for x, mass in masses]
        return Girder.from_bernstein(self.breaks, self.mass[number], self.rigidity[number], point_masses=points)

    @property
    def lumps(self) -> Array:
        """The point masses in kg, (girders, points), also where none were given."""
        return np.zeros((len(self), 0)) if self.point_mass is None else self.point_mass


def _numbers(name: str, values: ArrayLike) -> Array:
    """A copy as an array of numbers."""
    try:
        return np.array(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise GirderError(f"{name} is not an array of numbers ({error}).") from None
