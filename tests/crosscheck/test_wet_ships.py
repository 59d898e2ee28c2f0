"""Wet frequencies of the paper's two ships, with shear, against a model that shares no code with the solvers.

Two hundred textbook elements with lumped masses; the water by Capytaine (extra `wet`; skipped without it) on the
wetted panels. The water is told the motion of every eighth node, by cubic splines through them, deflections and angles
apart, each with a potential of its own: no mode, no trial function comes in.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.linalg import eigh
from textbook_elements import matrices

from hullform import read_ship, trace
from hullform.afloat import load_ship
from hullform.in_water import put_in_water
from hullform.pipeline import hull_of
from hullform.ship import Water
from hullvib.wet.capytaine_flow import CapytaineFlow

ROOT = Path(__file__).parent.parent.parent
ELEMENTS, KNOTS, MODES = 200, 26, 3


@dataclass(frozen=True)
class Splines:
    """Motions that are 1 at one knot and 0 at all others: of the deflection alone, then of the angle alone."""

    knots: np.ndarray

    @property
    def ranks(self) -> np.ndarray:
        return np.arange(1, 2 * len(self.knots) + 1)

    def deflections(self, x: np.ndarray) -> np.ndarray:
        cardinal = CubicSpline(self.knots, np.eye(len(self.knots)))(x).T
        return np.vstack([cardinal, np.zeros_like(cardinal)])

    def angles(self, x: np.ndarray) -> np.ndarray:
        return np.roll(self.deflections(x), len(self.knots), axis=0)


@pytest.mark.parametrize("ship", ["scim-containership", "ds-tanker"])
def test_wet_shear_flexible_frequencies(ship: str) -> None:
    pytest.importorskip("capytaine")
    described = read_ship(ROOT / "bodyplans" / ship / "ship.toml")
    afloat = load_ship(described, hull_of(described, trace(described)))
    for condition in afloat.conditions:
        girder = condition.girder
        run = put_in_water(
            afloat.hull, afloat.structure, girder, condition.at_rest.position, Water(), modes=MODES, functions=12
        )
        nodes, stiffness, mass = matrices(girder, ELEMENTS)
        water = CapytaineFlow(run.panels, neutral_axis_m=run.flow.neutral_axis_m)
        splines = Splines(np.linspace(0.0, girder.length, KNOTS))
        at = np.arange(KNOTS) * (ELEMENTS // (KNOTS - 1))
        told = np.concatenate([2 * at, 2 * at + 1])
        added, springs = np.zeros_like(stiffness), np.zeros_like(stiffness)
        added[np.ix_(told, told)] = water.added_mass(splines).matrix
        springs[np.ix_(told, told)] = water.hydrostatic_stiffness(splines)
        # an angle needs some inertia, or round-off rules: that of a thirtieth of an element's length as radius
        trifle = 1e-3 * mass.sum() / ELEMENTS * (girder.length / ELEMENTS) ** 2
        mass[1::2] += trifle
        squares, shapes = eigh(stiffness + springs, np.diag(mass) + added, subset_by_index=[0, MODES + 1])
        # heave and pitch are the two lowest here: rigid to a per mille
        straight = np.polynomial.polynomial.polyvander(nodes, 1)
        for shape in shapes[::2, :2].T:
            rest = shape - straight @ np.linalg.lstsq(straight, shape, rcond=None)[0]
            assert np.abs(rest).max() < 0.1 * np.abs(shape).max()
        independent = np.sqrt(squares[2:])
        # 1 per cent is demanded; what is left, up to 0.5 in mode 3, halves with 41 knots instead of 26
        np.testing.assert_allclose(
            run.shear.modes.angular_frequencies, independent, rtol=7e-3, err_msg=condition.condition.name
        )
