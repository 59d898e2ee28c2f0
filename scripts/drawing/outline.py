"""Ships drawn from rectellipses: a table of stations, monotone cubics between them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from drawing.interpolation import interpolate
from drawing.moulded import Moulded
from drawing.tables import DS_TANKER, SCIM_CONTAINERSHIP, Particulars

Array = NDArray[np.float64]

_TABLES = {"scim-containership": SCIM_CONTAINERSHIP, "ds-tanker": DS_TANKER}
_SAMPLES = 1200


@dataclass(frozen=True)
class Station:
    """One rectellipse: half-breadth, sheer height and depth in m, exponents p, q."""

    half_breadth: float
    top: float
    depth: float
    p: float
    q: float

    @property
    def keel(self) -> float:
        """Height of the station's lowest point above the base line, m."""
        return self.top - self.depth

    def half_breadth_at(self, height: float) -> float:
        """Return y at a height z: y = a (1 - ((top - z) / b)^q)^(1/p), nought below the keel."""
        if height <= self.keel:
            return 0.0
        share = min(max(self.top - height, 0.0) / self.depth, 1.0)
        return float(self.half_breadth * (1.0 - share**self.q) ** (1.0 / self.p))

    def curve(self, samples: int = _SAMPLES) -> Array:
        """Return points (y, z) from keel to deck, graded towards both ends of the curve.

        Below the point where both terms of the equation are 1/2 the height follows from y, above it y from the height:
        neither is then taken where it is steep. Steps u = t^(1/p) (p < 1) keep a cusp as finely divided as a bilge.
        """
        t = np.linspace(0.0, 1.0, samples)
        y_share = 0.5 ** (1.0 / self.p) * t ** max(1.0, 1.0 / self.p)
        z_share = 0.5 ** (1.0 / self.q) * t ** max(1.0, 1.0 / self.q)
        lower_z = (1.0 - y_share**self.p) ** (1.0 / self.q)
        upper_y = (1.0 - z_share**self.q) ** (1.0 / self.p)
        y = self.half_breadth * np.concatenate([y_share, upper_y[-2::-1]])
        down = self.depth * np.concatenate([lower_z, z_share[-2::-1]])
        return np.column_stack([y, self.top - down])


@dataclass(frozen=True)
class Outline(Moulded):
    """A ship whose every section is a rectellipse."""

    name: str
    particulars: Particulars

    def station(self, x: float) -> Station:
        """Return the rectellipse at x; between table stations a, sheer, keel, 1/p and 1/q are monotone cubics."""
        if not 0.0 <= x <= self.particulars.length_overall_m:
            raise ValueError(f"x = {x} m is outside {self.name}: 0 to {self.particulars.length_overall_m} m")
        if self.name == "wigley":
            length, breadth = self.particulars.length_overall_m, self.particulars.breadth_m
            draught = self.particulars.draught_m
            return Station(0.5 * breadth * (1.0 - (2.0 * x / length - 1.0) ** 2), draught, draught, 1.0, 2.0)
        table = np.array(_TABLES[self.name])
        columns = (table[:, 1], table[:, 2], table[:, 2] - table[:, 3], 1.0 / table[:, 4], 1.0 / table[:, 5])
        a, top, keel, p, q = (float(interpolate(table[:, 0], c, np.array([x]))[0]) for c in columns)
        return Station(a, top, top - keel, 1.0 / p, 1.0 / q)

    def section(self, x: float, n: int = 400) -> Array:
        """Return n points (y, z) from keel to deck at x, at equal steps of arc length; shape (n, 2)."""
        fine = self.station(x).curve()
        arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(fine, axis=0).T))])
        at = np.linspace(0.0, arc[-1], n)
        return np.column_stack([np.interp(at, arc, fine[:, 0]), np.interp(at, arc, fine[:, 1])])

    def section_area(self, x: float, draught: float) -> float:
        """Return the immersed sectional area at x, both sides, m^2 (trapezoids over the fine curve)."""
        station = self.station(x)
        if draught <= station.keel or station.depth == 0.0:
            return 0.0
        points = station.curve()
        below = points[points[:, 1] < draught]
        end = min(draught, station.top)
        points = np.vstack([below, [station.half_breadth_at(end), end]])
        return float(np.sum((points[1:, 0] + points[:-1, 0]) * np.diff(points[:, 1])))

    def curves(self, x: float, n: int = 400) -> list[Array]:
        """Return the one curve of the section."""
        return [self.section(x, n)]

    def deck_edge(self, x: float) -> tuple[float, float]:
        """Return half-breadth and height of the deck edge at x."""
        station = self.station(x)
        return station.half_breadth, station.top

    def half_breadth_at(self, x: float, height: float) -> float:
        """Return the half-breadth at a height, nought below the keel."""
        return self.station(x).half_breadth_at(height)

    def breaks(self) -> Array:
        """Return the table's places; forty equal steps for Wigley's hull, which has no table."""
        if self.name == "wigley":
            return np.linspace(0.0, self.particulars.length_overall_m, 41)
        return np.array([row[0] for row in _TABLES[self.name]])
