"""The water about a panelled hull by Capytaine, where it is installed: an independent check of `PanelFlow`.

M. Ancellin and F. Dias, Capytaine: a Python-based linear potential flow solver, J. Open Source Software 4 (2019) 1341.
Its direct method is taken: the indirect one is ten times less sharp on the same panels. Deep water alone: at infinite
frequency its finite depth loses added mass as the bottom comes near.
"""

from __future__ import annotations

import logging
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hullvib.errors import ArgumentError
from hullvib.sea import GRAVITY_M_S2, SEA_WATER_KG_M3
from hullvib.wet.added_mass import AddedMass, NeutralAxis, check_density, heights_of
from hullvib.wet.motions import Motions
from hullvib.wet.panel_flow import added_mass_of, waterplane_stiffness
from hullvib.wet.panels import Panels

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class CapytaineFlow:
    """Added mass by Capytaine's direct method, deep water; needs the extra `wet` (capytaine 3).

    Arguments as `PanelFlow` has them; it gives no forces along the hull. Raises ArgumentError.
    """

    panels: Panels
    neutral_axis_m: NeutralAxis = field(kw_only=True)
    density_kg_m3: float = field(default=SEA_WATER_KG_M3, kw_only=True)
    gravity_m_s2: float = field(default=GRAVITY_M_S2, kw_only=True)

    def __post_init__(self) -> None:
        check_density(self.density_kg_m3)
        _capytaine()

    @property
    def breadth_m(self) -> float:
        return 2.0 * float(self.panels.vertices_m[:, 1].max())

    def added_mass(self, motions: Motions) -> AddedMass:
        """Raises ArgumentError for motions that do not reach over the hull."""
        capytaine = _capytaine()
        half = capytaine.Mesh(
            vertices=self.panels.vertices_m, faces=self.panels.faces.tolist(), auto_clean=True, auto_check=False
        )
        mesh = capytaine.ReflectionSymmetricMesh(half, plane="xOz").merged()
        x, z = mesh.faces_centers[:, 0], mesh.faces_centers[:, 2]
        lever = z - heights_of(self.neutral_axis_m, x)
        dofs = {}
        pairs = zip(motions.deflections(x), motions.angles(x), strict=True)
        for n, (deflection, angle) in enumerate(pairs):
            dofs[str(n)] = np.stack([-lever * angle, np.zeros_like(x), deflection], axis=1)
        body = capytaine.FloatingBody(mesh=mesh, dofs=dofs, name="hull")
        solver = capytaine.BEMSolver(method="direct")
        problems = [
            capytaine.RadiationProblem(body=body, radiating_dof=key, omega=np.inf, rho=self.density_kg_m3)
            for key in dofs
        ]
        results = solver.solve_all(problems, keep_details=False, progress_bar=False)
        raw = np.array([[result.added_masses[key] for key in dofs] for result in results], dtype=np.float64)
        record: dict[str, object] = {"flow": "capytaine", "panels": int(mesh.nb_faces)}
        return added_mass_of(raw, np.array(self.panels.extent_m), np.full((len(raw), 1), np.nan), record)

    def hydrostatic_stiffness(self, motions: Motions) -> Array:
        return waterplane_stiffness(self.panels, motions, self.density_kg_m3 * self.gravity_m_s2)


def _capytaine() -> Any:
    try:
        import capytaine
    except ImportError:
        raise ArgumentError(
            "Capytaine is not installed; install the extra 'wet' (pip install 'hullform[wet]'), or take PanelFlow."
        ) from None
    logging.getLogger("capytaine").setLevel(logging.ERROR)
    return capytaine
