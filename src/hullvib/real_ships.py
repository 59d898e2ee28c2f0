"""Frequencies of ships as they are, and the ratios that every one of them keeps to.

Source: E. C. Tupper, Introduction to Naval Architecture, table 11.1, 'Typical ship vibration frequencies', vertical, in
water; in cycles/min by their size, as the copy read shows no unit. Whether each figure was measured is not said there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Kind = Literal["tanker", "passenger", "cargo", "destroyer"]

RATIO_LIMITS: tuple[tuple[float, float], ...] = ((1.70, 2.15), (2.8, 3.2))
"""Of the 3-node and of the 4-node to the 2-node frequency: what the table spans, rounded outwards to 0.05 and 0.1."""
LIKE_LENGTH = 0.25
"""Ships are of a length where they differ by less than this share of it."""


@dataclass(frozen=True)
class PublishedFrequencies:
    """One line of the table: frequencies of the 2-, 3- and 4-node vertical modes as far as printed, cycles/min."""

    kind: Kind
    length_m: float
    condition: str
    cycles_per_minute: tuple[float, ...]

    @property
    def ratios(self) -> tuple[float, ...]:
        """Of the higher modes to the first."""
        first, *higher = self.cycles_per_minute
        return tuple(value / first for value in higher)


SHIPS: tuple[PublishedFrequencies, ...] = (
    PublishedFrequencies("tanker", 227.0, "light", (59.0, 121.0, 188.0)),
    PublishedFrequencies("tanker", 227.0, "loaded", (52.0, 108.0, 166.0)),
    PublishedFrequencies("passenger", 136.0, "", (104.0, 177.0)),
    PublishedFrequencies("cargo", 85.0, "light", (150.0, 290.0)),
    PublishedFrequencies("cargo", 85.0, "loaded", (135.0, 283.0)),
    PublishedFrequencies("cargo", 130.0, "light", (106.0, 210.0)),
    PublishedFrequencies("cargo", 130.0, "loaded", (85.0, 168.0)),
    PublishedFrequencies("destroyer", 160.0, "average action", (85.0, 180.0, 240.0)),
)


def ratios(frequencies: ArrayLike) -> tuple[float, float]:
    """Second and third mode's frequency over the first's, as (3-node / 2-node, 4-node / 2-node); any unit."""
    first, second, third = np.asarray(frequencies, dtype=np.float64)[:3]
    return float(second / first), float(third / first)


def widened(limits: tuple[float, float], uncertainty: float) -> tuple[float, float]:
    """Limits of a ratio for a model that knows it to a relative uncertainty: (1 - u) low to (1 + u) high.

    The table has few figures and the model has a spread of its own: only what lies beyond both is told.
    """
    low, high = limits
    return low * (1.0 - uncertainty), high * (1.0 + uncertainty)


def ships_like(kind: Kind, length_m: float) -> tuple[PublishedFrequencies, ...]:
    """The published ships of a kind and of about a length; there may be none."""
    return tuple(ship for ship in SHIPS if ship.kind == kind and abs(ship.length_m / length_m - 1.0) <= LIKE_LENGTH)
