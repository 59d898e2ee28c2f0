"""What every drawn ship can tell of her moulded form, and what follows from it: volume and coefficients."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np
from numpy.typing import NDArray

from drawing.tables import Particulars

Array = NDArray[np.float64]

SALT_WATER_T_PER_M3 = 1.025
_GAUSS_NODES, _GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(6)


class Moulded(ABC):
    """A drawn ship's moulded surface; x from the aft end, y from the centreline, z from the base line, metres."""

    name: str
    particulars: Particulars

    @abstractmethod
    def curves(self, x: float, n: int = 400) -> list[Array]:
        """Return the section's curves at x, each n points (y, z) from its keel upwards at equal steps of arc."""

    @abstractmethod
    def deck_edge(self, x: float) -> tuple[float, float]:
        """Return half-breadth and height of the deck edge at x."""

    @abstractmethod
    def half_breadth_at(self, x: float, height: float) -> float:
        """Return the half-breadth at a height, nought outside the hull."""

    @abstractmethod
    def section_area(self, x: float, draught: float) -> float:
        """Return the immersed sectional area at x, both sides, m^2."""

    @abstractmethod
    def breaks(self) -> Array:
        """Return places along the ship between which her form is smooth, the two ends among them."""

    def _places(self) -> tuple[Array, Array]:
        """Return Gauss points and weights over the length, six to each half of an interval between breaks."""
        breaks = self.breaks()
        breaks = np.sort(np.concatenate([breaks, 0.5 * (breaks[1:] + breaks[:-1])]))
        half = 0.5 * np.diff(breaks)[:, None]
        x = 0.5 * (breaks[1:] + breaks[:-1])[:, None] + half * _GAUSS_NODES
        return x.ravel(), (half * _GAUSS_WEIGHTS).ravel()

    def volume(self, draught: float) -> float:
        """Return the moulded volume below a draught on even keel, m^3."""
        x, weights = self._places()
        return float(weights @ [self.section_area(float(s), draught) for s in x])

    def coefficients(self) -> dict[str, float]:
        """Return displacement (t), block, midship, prismatic and waterplane coefficients and LCB at the draught.

        Lengths are those between perpendiculars; LCB is in per cent of it, forward of midships positive.
        """
        main = self.particulars
        length, breadth, draught = main.length_between_perpendiculars_m, main.breadth_m, main.draught_m
        midships = main.aft_perpendicular_m + 0.5 * length
        x, weights = self._places()
        areas = np.array([self.section_area(float(s), draught) for s in x])
        breadths = np.array([2.0 * self.half_breadth_at(float(s), draught) for s in x])
        volume = float(weights @ areas)
        block = volume / (length * breadth * draught)
        midship = self.section_area(midships, draught) / (breadth * draught)
        return {
            "displacement_t": SALT_WATER_T_PER_M3 * volume,
            "block": block,
            "midship": midship,
            "prismatic": block / midship,
            "waterplane": float(weights @ breadths) / (length * breadth),
            "lcb_percent": 100.0 * (float(weights @ (areas * x)) / volume - midships) / length,
        }
