"""The form of a drawn ship: sections, areas, volume and coefficients by the drawing's own integration."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from drawing.interpolation import interpolate
from drawing.tables import DS_TANKER, PARTICULARS, SCIM_CONTAINERSHIP, Particulars

Array = NDArray[np.float64]

SALT_WATER_T_PER_M3 = 1.025
_TABLES = {"scim-containership": SCIM_CONTAINERSHIP, "ds-tanker": DS_TANKER}
_GAUSS_NODES, _GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(6)
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
class Outline:
    """A drawn ship's moulded surface; x from the aft end, y from the centreline, z from the base line, metres."""

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

    def _places(self) -> tuple[Array, Array]:
        """Return Gauss points and weights over the length, six to each interval of the table (or of 40)."""
        length = self.particulars.length_overall_m
        breaks = np.linspace(0.0, length, 41) if self.name == "wigley" else np.array([r[0] for r in _TABLES[self.name]])
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
        breadths = np.array([2.0 * self.station(float(s)).half_breadth_at(draught) for s in x])
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


def outline(ship: str) -> Outline:
    """Return the outline of one of the drawn ships; raise ValueError for a name that is not among them."""
    if ship not in PARTICULARS:
        raise ValueError(f"there is no drawn ship {ship!r}; there are {', '.join(PARTICULARS)}")
    return Outline(ship, PARTICULARS[ship])
