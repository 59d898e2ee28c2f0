"""The profile: the contour of a hull in her centre plane, from the deck at the stern round the keel to the stem."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hullform.errors import BodyPlanError

Array = NDArray[np.float64]

# Of the profile's length: so far inside its ends the centre plane is looked at, where an end is upright.
_INSIDE = 1e-9
# Contours of one section have three ends below the deck.
_ENDS = 3


class CentrePlane(NamedTuple):
    """Where sections meet the centre plane, in m above the base line, each of the shape of x.

    foot: where the section begins. head, stem: where its lower contour, a bulb or a gondola, ends, and the upper one
    begins. NaN where there is none of them: no section at all, no lower contour, no upper one above it.
    """

    foot: Array
    head: Array
    stem: Array


@dataclass(frozen=True, eq=False)
class Profile:
    """The contour of a hull in her centre plane, as a polyline from aft to fore; what is above it is the ship.

    Attributes:
        x_m: (n,) places from the aft end of the length overall, n >= 2; need not increase, as at a bulb.
        height_m: (n,) heights above the base line.

    Raises:
        BodyPlanError: fewer than two points, arrays of unequal length, numbers that are not finite, no length.
    """

    x_m: Array
    height_m: Array

    def __post_init__(self) -> None:
        for name in ("x_m", "height_m"):
            values = np.array(getattr(self, name), dtype=np.float64)
            values.setflags(write=False)
            object.__setattr__(self, name, values)
        x, z = self.x_m, self.height_m
        if x.ndim != 1 or x.shape != z.shape or x.size < 2:
            raise BodyPlanError(
                f"a profile needs two or more points (x, z); got {x.shape} places and {z.shape} heights"
            )
        if not (np.isfinite(x).all() and np.isfinite(z).all()) or np.ptp(x) == 0:
            raise BodyPlanError("a profile has a place or height that is not a finite number, or no length")

    @property
    def from_m(self) -> float:
        """Its aftmost place."""
        return float(self.x_m.min())

    @property
    def to_m(self) -> float:
        """Its foremost place."""
        return float(self.x_m.max())

    def at(self, x: Array, side: float = 0.0) -> CentrePlane:
        """Where sections at x (n,) meet the centre plane; just before x for side = -1, just after it for 1."""
        near = _INSIDE * (self.to_m - self.from_m)
        place = np.clip(x + side * near, self.from_m + near, self.to_m - near)[:, None]
        one, other = self.x_m[:-1], self.x_m[1:]
        crossed = (one <= place) != (other <= place)
        run = np.where(one == other, 1.0, other - one)
        heights = self.height_m[:-1] + np.diff(self.height_m) * (place - one) / run
        ends = np.sort(np.where(crossed, heights, np.nan), axis=1)
        ends = np.pad(ends, ((0, 0), (0, _ENDS)), constant_values=np.nan)[:, :_ENDS]
        ends[(x < self.from_m - near) | (x > self.to_m + near)] = np.nan
        return CentrePlane(*ends.T)
