"""The water about a panelled hull: Green's identity with constant panels, solved once for any number of motions.

    2 pi phi(p) = int phi d(1/r)/dn dS - int (1/r) v_n dS  over the hull and her images,   A_jk = -rho int phi_j v_k dS

with n into the water, v_n = w n_z - (z - z_NA) psi n_x and phi = 0 on the free surface: the limit of high frequency, in
which no waves are made and A does not depend on it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import lu_factor, lu_solve

from hullvib.errors import ArgumentError, SolutionError
from hullvib.sea import GRAVITY_M_S2, SEA_WATER_KG_M3
from hullvib.wet.added_mass import AddedMass, NeutralAxis, check_density, heights_of
from hullvib.wet.influence import influence
from hullvib.wet.motions import Motions
from hullvib.wet.panels import Panels

Array = NDArray[np.float64]

_CELLS = 40  # along the hull, in which forces per length are given where the panels stand in no rows
_FEWEST_IN_A_ROW = 4  # panels between two cross-sections that make a row


@dataclass(frozen=True, eq=False)
class PanelFlow:
    """Added mass by a three-dimensional panel method, in water of any depth.

    panels of the half hull; neutral_axis_m, height of the girder's neutral axis above the waterline (negative below
    it), about which the sections turn: a number, (x, z) or a function of x; density_kg_m3; depth_m of the water from
    its surface, infinite by default; gravity_m_s2. In deep water 500 panels of the half hull are good to some 0.1 per
    cent of the frequency, below a flat bottom in water of 1.1 draughts to 0.3, and where the gap is narrower to less.
    Raises ArgumentError.
    """

    panels: Panels
    neutral_axis_m: NeutralAxis = field(kw_only=True)
    density_kg_m3: float = field(default=SEA_WATER_KG_M3, kw_only=True)
    depth_m: float = field(default=np.inf, kw_only=True)
    gravity_m_s2: float = field(default=GRAVITY_M_S2, kw_only=True)

    def __post_init__(self) -> None:
        check_density(self.density_kg_m3)
        draught = float(-self.panels.vertices_m[:, 2].min())
        if not self.depth_m > draught:
            raise ArgumentError(
                f"depth_m is {self.depth_m:g} m and the hull reaches down to {draught:g} m; she must float clear."
            )

    @property
    def breadth_m(self) -> float:
        return 2.0 * float(self.panels.vertices_m[:, 1].max())

    def added_mass(self, motions: Motions) -> AddedMass:
        """Raises ArgumentError for motions that do not reach over the hull, SolutionError for panels that repeat."""
        g = self.panels.geometry
        speeds = normal_speeds(self.panels, motions, self.neutral_axis_m)
        factors, source = self._factors
        potentials = lu_solve(factors, source @ speeds.T, check_finite=False)
        raw = -2.0 * self.density_kg_m3 * (speeds * g.areas) @ potentials
        pressures = -2.0 * self.density_kg_m3 * potentials.T * (g.normals[:, 2] * g.areas)
        record: dict[str, object] = {"flow": "panels", "panels": 2 * len(self.panels)}
        if np.isfinite(self.depth_m):
            record["depth_m"] = self.depth_m
        return added_mass_of(raw, *spread(self.panels, pressures), record)

    def hydrostatic_stiffness(self, motions: Motions) -> Array:
        return waterplane_stiffness(self.panels, motions, self.density_kg_m3 * self.gravity_m_s2)

    @cached_property
    def _factors(self) -> tuple[tuple[Array, NDArray[Any]], Array]:
        source, dipole = influence(self.panels, self.depth_m)
        dipole.flat[:: len(dipole) + 1] -= 2.0 * np.pi
        factors = lu_factor(dipole, overwrite_a=True, check_finite=False)
        if not float(np.abs(factors[0].diagonal()).min()) > 1e-9:
            raise SolutionError("the panels make no flow: two of them are the same, or one faces another too closely.")
        return factors, source


def normal_speeds(panels: Panels, motions: Motions, neutral_axis: NeutralAxis) -> Array:
    """w n_z - (z - z_NA) psi n_x at the panels' centres, (n, m)."""
    g = panels.geometry
    x, z = g.centres[:, 0], g.centres[:, 2]
    lever = z - heights_of(neutral_axis, x)
    return np.asarray(motions.deflections(x) * g.normals[:, 2] - motions.angles(x) * (lever * g.normals[:, 0]))


def waterplane_stiffness(panels: Panels, motions: Motions, weight_density: float) -> Array:
    """rho g int B w_j w_k dx: by Gauss's theorem the waterplane's integral is minus that of w_j w_k n_z over the hull.

    Each panel takes the mean over its corners and, four times as heavy, its centre.
    """
    g = panels.geometry
    down = -2.0 * weight_density * g.normals[:, 2] * g.areas
    corners = motions.deflections(g.corners[..., 0].ravel()).reshape(-1, len(down), 4)
    centres = motions.deflections(g.centres[:, 0])
    stiffness = np.einsum("jmc,kmc,m->jk", corners, corners, down / 12.0, optimize=True)
    stiffness += (centres * (down * 2.0 / 3.0)) @ centres.T
    return np.asarray(stiffness, dtype=np.float64)


def spread(panels: Panels, forces: Array) -> tuple[Array, Array]:
    """Forces of the panels (n, m) as forces per length (n, cells) in cells along the hull, and the cells' edges.

    Each panel's is spread evenly over its extent in x: gathered at the centres they would come in bursts. Cells are the
    rows of panels between cross-sections, where they stand in rows, else of equal length.
    """
    x = panels.geometry.corners[..., 0]
    first, last = x.min(axis=1), x.max(axis=1)
    places = np.unique(np.concatenate([first, last]))
    edges = places[np.append(True, np.diff(places) > 1e-6 * (places[-1] - places[0]))]
    if _FEWEST_IN_A_ROW * len(edges) > len(panels):
        edges = np.linspace(places[0], places[-1], _CELLS + 1)
    width = np.maximum(last - first, 1e-12 * (edges[-1] - edges[0]))
    below = np.clip((edges[:, None] - first) / width, 0.0, 1.0)
    below[0], below[-1] = 0.0, 1.0
    return edges, np.asarray(forces @ np.diff(below, axis=0).T / np.diff(edges), dtype=np.float64)


def added_mass_of(raw: Array, edges: Array, forces: Array, record: dict[str, object]) -> AddedMass:
    """The symmetric part of a matrix, with what it took."""
    asymmetry = float(np.abs(raw - raw.T).max() / np.abs(raw).max())
    return AddedMass(0.5 * (raw + raw.T), asymmetry, edges, forces, record)
