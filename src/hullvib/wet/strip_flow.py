"""The water about a hull by strips: two-dimensional sections with a correction for the flow along the hull."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError
from hullvib.quadrature import composite
from hullvib.sea import GRAVITY_M_S2, SEA_WATER_KG_M3
from hullvib.wet.added_mass import AddedMass, check_density
from hullvib.wet.motions import RIGID, Motions
from hullvib.wet.sections import Sections
from hullvib.wet.spheroid import bending_factors, sliding_factors
from hullvib.wet.two_dimensional import lewis_added_mass, section_added_mass

Array = NDArray[np.float64]
SectionMethod = Literal["panels", "lewis"]
LengthwiseFlow = Literal["spheroid", "townsin", "lewis", "taylor", "none"]

_TERMS = 40  # of the spheroid's series
_POINTS = 4  # of Gauss's rule between two sections


@dataclass(frozen=True, eq=False)
class StripFlow:
    """Added mass by strip theory, deep water: a cross-check of the panels, and quick enough for sweeps.

    sections below the waterline; section_method "panels" (Green's identity on each curve) or "lewis", or the added mass
    per length itself, (n,) in kg/m; lengthwise, the correction for the flow along the hull:

    - "spheroid": A_jk = sum_n J_n <sqrt(m) w_j, e_n> <sqrt(m) w_k, e_n> with the sliding spheroid's factors and
      e_n its orthonormal sqrt(1 - mu^2) P_n'(mu) over the wetted length; exact for the sliding spheroid. Far from a
      section its flow is a dipole of the strength (m + rho S) / rho, S being the immersed area, and that is what one
      section feels of the others: the spheroid's breadth is that of the semicircle with the largest, for which both
      terms are equal, sqrt(4 (m + rho S) / (rho pi)).
    - "lewis", "taylor", "townsin": sqrt(J_j J_k) on each product, with the factors of a spheroid of the hull's length
      and breadth that slides or turns, or R. L. Townsin's J = 1.02 - 3 (1.2 - 1/n) B / L for n nodes (Trans. RINA 111
      (1969); heave and pitch after Lewis).
    - "none": J = 1.

    density_kg_m3; gravity_m_s2. The sections are taken not to turn. Raises ArgumentError.
    """

    sections: Sections
    section_method: SectionMethod | ArrayLike = "panels"
    lengthwise: LengthwiseFlow = "spheroid"
    density_kg_m3: float = field(default=SEA_WATER_KG_M3, kw_only=True)
    gravity_m_s2: float = field(default=GRAVITY_M_S2, kw_only=True)

    def __post_init__(self) -> None:
        check_density(self.density_kg_m3)
        if isinstance(self.section_method, str) and self.section_method not in ("panels", "lewis"):
            raise ArgumentError(f"section_method is {self.section_method!r}; give 'panels', 'lewis' or kg/m.")
        if self.lengthwise not in ("spheroid", "townsin", "lewis", "taylor", "none"):
            raise ArgumentError(
                f"lengthwise is {self.lengthwise!r}; give 'spheroid', 'townsin', 'lewis', 'taylor' or 'none'."
            )

    @property
    def breadth_m(self) -> float:
        return 2.0 * float(self.sections.half_breadth_m.max())

    @cached_property
    def section_kg_per_m(self) -> Array:
        """Added mass of the sections per length in two dimensions, (n,)."""
        if isinstance(self.section_method, str):
            method = lewis_added_mass if self.section_method == "lewis" else section_added_mass
            return method(self.sections, self.density_kg_m3)
        given = np.array(self.section_method, dtype=np.float64)
        if given.shape != self.sections.x_m.shape or not (np.isfinite(given).all() and given.min() >= 0.0):
            raise ArgumentError(f"section_method has shape {given.shape}; give one finite kg/m, 0 or more, a section.")
        return given

    def added_mass(self, motions: Motions) -> AddedMass:
        """Raises ArgumentError for motions that do not reach over the hull, or a hull not longer than broad."""
        x, weights, strips = self._rule
        shapes = motions.deflections(x)
        if self.lengthwise == "spheroid":
            forces = self._spheroid_forces(shapes)
            matrix = (shapes * weights) @ forces.T
        else:
            factors = self._factors(motions.ranks)
            matrix = np.sqrt(np.outer(factors, factors)) * ((shapes * (weights * strips)) @ shapes.T)
            forces = factors[:, None] * shapes * strips
        cells = len(self.sections.x_m) - 1
        means = (forces * weights).reshape(len(shapes), cells, _POINTS).sum(axis=2) / np.diff(self.sections.x_m)
        record = {"flow": "strips", "sections": len(self.sections.x_m), "lengthwise": self.lengthwise}
        return AddedMass(0.5 * (matrix + matrix.T), 0.0, self.sections.x_m, means, record)

    def strip_mass(self, motions: Motions) -> Array:
        """Added mass with J = 1, (n, n) in kg: what factors refer to."""
        x, weights, strips = self._rule
        shapes = motions.deflections(x)
        return np.asarray((shapes * (weights * strips)) @ shapes.T, dtype=np.float64)

    def hydrostatic_stiffness(self, motions: Motions) -> Array:
        x, weights, _ = self._rule
        shapes = motions.deflections(x)
        breadth = 2.0 * np.interp(x, self.sections.x_m, self.sections.half_breadth_m)
        weight = self.density_kg_m3 * self.gravity_m_s2
        return np.asarray((shapes * (weights * breadth * weight)) @ shapes.T, dtype=np.float64)

    @cached_property
    def _rule(self) -> tuple[Array, Array, Array]:
        """Points along the hull, their weights, and the two-dimensional added mass there, linear between sections."""
        places = self.sections.x_m
        rule = composite(places, places, _POINTS)
        x = rule.xi.ravel()
        return x, rule.weights.ravel(), np.interp(x, places, self.section_kg_per_m)

    def _spheroid_forces(self, shapes: Array) -> Array:
        """Force per length and unit acceleration of each motion at the rule's points, (n, points)."""
        x, weights, strips = self._rule
        length = self.sections.length_m
        displaced = self.density_kg_m3 * np.interp(x, self.sections.x_m, self.sections.area_m2)
        equal = float(np.sqrt(4.0 * (strips + displaced).max() / (self.density_kg_m3 * np.pi)))
        mu = 2.0 * (x - self.sections.x_m[0]) / length - 1.0
        loads = np.sqrt(strips)
        forces = np.zeros_like(shapes)
        for n, factor in enumerate(sliding_factors(length / equal, _TERMS), 1):
            wave = np.sqrt(np.maximum(1.0 - mu**2, 0.0)) * legendre.legval(mu, legendre.legder([0.0] * n + [1.0]))
            wave /= np.sqrt(weights @ wave**2)
            forces += factor * ((shapes * loads) @ (weights * wave))[:, None] * (loads * wave)
        return forces

    def _factors(self, ranks: NDArray[np.intp]) -> Array:
        slenderness = self.sections.length_m / self.breadth_m
        if self.lengthwise == "none":
            return np.ones(len(ranks))
        count = int(ranks.max())
        if self.lengthwise == "taylor":
            return bending_factors(slenderness, count)[ranks - 1]
        factors = sliding_factors(slenderness, count)
        if self.lengthwise == "townsin":
            nodes = np.arange(1, count + 1) - 1
            elastic = nodes >= RIGID
            factors[elastic] = townsin_factor(nodes[elastic], slenderness)
        return np.asarray(factors[ranks - 1], dtype=np.float64)


def townsin_factor(nodes: ArrayLike, length_over_breadth: float) -> Array:
    """J = 1.02 - 3 (1.2 - 1/n) B / L of the shape with n = 2 to 7 nodes, not below 0."""
    n = np.asarray(nodes, dtype=np.float64)
    return np.asarray(np.maximum(1.02 - 3.0 * (1.2 - 1.0 / n) / length_over_breadth, 0.0), dtype=np.float64)
