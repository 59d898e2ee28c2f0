"""Weights as curves along the ship: linear pieces with jumps, and point masses, that add up exactly.

The only module that knows hullvib's Girder.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from hullform.errors import LoadingError
from hullform.loading.places import moved_to
from hullvib.girder import Girder
from hullvib.point_masses import PointMass

Array = NDArray[np.float64]

# Breakpoints closer than this are one: far above the round-off of a length, far below any part of a ship.
SAME_PLACE_M = 1e-9


@dataclass(frozen=True, eq=False)
class Distribution:
    """Mass per length, linear between breakpoints, with point masses; zero outside its breakpoints.

    Attributes:
        name: what is distributed.
        x_m: (k + 1,) increasing breakpoints.
        left_kg_per_m: (k,) value at the left end of each piece.
        right_kg_per_m: (k,) value at its right end.
        points: (x in metres, mass in kg) of what sits at one place.
    """

    name: str
    x_m: Array
    left_kg_per_m: Array
    right_kg_per_m: Array
    points: tuple[tuple[float, float], ...] = field(default=())

    @property
    def mass_kg(self) -> float:
        """The integral of the curve plus the point masses."""
        pieces = 0.5 * (self.left_kg_per_m + self.right_kg_per_m) @ np.diff(self.x_m)
        return float(pieces) + sum(mass for _, mass in self.points)

    @property
    def moment_kg_m(self) -> float:
        """The first moment about x = 0."""
        width, start = np.diff(self.x_m), self.x_m[:-1]
        left, right = self.left_kg_per_m, self.right_kg_per_m
        pieces = width * (start * (left + right) / 2 + width * (left + 2 * right) / 6)
        return float(pieces.sum()) + sum(x * mass for x, mass in self.points)

    @property
    def centre_m(self) -> float:
        """x of the centre of gravity."""
        return self.moment_kg_m / self.mass_kg

    def at_piece_ends(self, breaks: Array) -> tuple[Array, Array]:
        """Left and right end values on finer pieces between `breaks` (k,), which must hold every own breakpoint."""
        if not self.left_kg_per_m.size:
            return np.zeros(breaks.size - 1), np.zeros(breaks.size - 1)
        middle = 0.5 * (breaks[:-1] + breaks[1:])
        piece = np.searchsorted(self.x_m, middle) - 1
        inside = (piece >= 0) & (piece < self.left_kg_per_m.size)
        piece = np.where(inside, piece, 0)
        start, width = self.x_m[piece], np.diff(self.x_m)[piece]
        rise = self.right_kg_per_m[piece] - self.left_kg_per_m[piece]
        left = self.left_kg_per_m[piece] + rise * (breaks[:-1] - start) / width
        right = self.left_kg_per_m[piece] + rise * (breaks[1:] - start) / width
        return np.where(inside, left, 0.0), np.where(inside, right, 0.0)


def uniform(name: str, mass_kg: float, from_m: float, to_m: float) -> Distribution:
    """A mass spread evenly between two places."""
    density = np.array([mass_kg / (to_m - from_m)])
    return Distribution(name, np.array([from_m, to_m]), density, density)


def shaped(
    name: str,
    mass_kg: float,
    x_m: Array,
    shape: Array,
    from_m: float | None = None,
    to_m: float | None = None,
    lumps: tuple[tuple[float, float], ...] = (),
) -> Distribution:
    """A mass spread as a curve has it, the curve linear between its points and cut off outside [from, to].

    Args:
        name: what is distributed.
        mass_kg: its whole mass.
        x_m: (n,) places of the curve; one that stands twice is a jump.
        shape: (n,) its ordinates, of any unit, >= 0.
        from_m, to_m: the part of the length that carries the mass; the whole curve by default.
        lumps: (x in metres, amount in the unit of shape times metre) of what takes part in it at one place.

    Raises:
        LoadingError: the curve has no area in that part.
    """
    first = x_m[0] if from_m is None else from_m
    last = x_m[-1] if to_m is None else to_m
    inside = (x_m > first) & (x_m < last)
    x = np.concatenate([[first], x_m[inside], [last]])
    outer = np.interp([first, last], x_m, shape)
    y = np.concatenate([outer[:1], shape[inside], outer[1:]])
    total = float(0.5 * (y[:-1] + y[1:]) @ np.diff(x)) + sum(amount for _, amount in lumps)
    if not total > 0:
        raise LoadingError(
            f"{name}: nothing to spread {mass_kg / 1e3:g} t over between x = {first:g} and {last:g} m; "
            "the hull has no section there"
        )
    density = mass_kg / total
    points = tuple((at, amount * density) for at, amount in lumps if amount > 0)
    # a jump is no piece of its own
    pieces = np.diff(x) > 0
    breaks = np.concatenate([x[:1], x[1:][pieces]])
    return Distribution(name, breaks, density * y[:-1][pieces], density * y[1:][pieces], points)


def merged_breaks(parts: Iterable[Array]) -> Array:
    """Every breakpoint of every part, once, in order; those that round-off keeps apart become one."""
    breaks = np.unique(np.concatenate(list(parts)))
    apart = np.concatenate([[True], np.diff(breaks) > SAME_PLACE_M])
    return np.asarray(breaks[apart], dtype=np.float64)


def settled(items: Iterable[Distribution], stations: Array) -> tuple[Distribution, ...]:
    """The items with what all but stands on a station, or on an earlier item's breakpoint, put there, mass kept.

    A bay of a few millimetres is no part of a ship, and no beam solution can take it.
    """
    length = float(stations[-1] - stations[0])
    known, found = stations, []
    for item in items:
        x = moved_to(known, item.x_m, length)
        at = moved_to(known, np.array([place for place, _ in item.points]), length)
        if not np.array_equal(x, item.x_m) or at.tolist() != [place for place, _ in item.points]:
            wide = np.diff(x) > 0
            points = tuple((float(place), mass) for place, (_, mass) in zip(at, item.points, strict=True))
            moved = Distribution(
                item.name,
                np.concatenate([x[:1], x[1:][wide]]),
                item.left_kg_per_m[wide],
                item.right_kg_per_m[wide],
                points,
            )
            share = item.mass_kg / moved.mass_kg
            item = Distribution(
                moved.name,
                moved.x_m,
                share * moved.left_kg_per_m,
                share * moved.right_kg_per_m,
                tuple((place, share * mass) for place, mass in points),
            )
        known = np.concatenate([known, item.x_m, [place for place, _ in item.points]])
        found.append(item)
    return tuple(found)


def girder_from(
    name: str,
    items: tuple[Distribution, ...],
    x_m: Array,
    flexural_rigidity: Array,
    shear_rigidity: Array,
    radius_of_gyration_m: float,
) -> Girder:
    """The girder that carries all items.

    Args:
        name: of the girder.
        items: its weights.
        x_m: (n,) stations between which EI and k G A are linear.
        flexural_rigidity, shear_rigidity: (n,) EI in N m2, k G A in N.
        radius_of_gyration_m: of everything on board about the neutral axis; the rotary inertia is m(x)
            times its square.
    """
    items = settled(items, x_m)
    breaks = merged_breaks([item.x_m for item in items if item.left_kg_per_m.size] + [x_m[[0, -1]]])
    ends = [item.at_piece_ends(breaks) for item in items]
    left, right = (np.sum([pair[side] for pair in ends], axis=0) for side in (0, 1))
    mass_x = np.repeat(breaks, 2)[1:-1]
    mass = np.column_stack([left, right]).ravel()
    square = radius_of_gyration_m**2
    return Girder.from_tables(
        mass=(mass_x, mass),
        rigidity=(x_m, flexural_rigidity),
        shear_rigidity=(x_m, shear_rigidity),
        rotary_inertia=(mass_x, square * mass),
        point_masses=tuple(PointMass(x, kg, square * kg) for item in items for x, kg in item.points),
        name=name,
    )
