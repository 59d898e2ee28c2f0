"""The panel method against Capytaine's direct one on the same panels: another code, another quadrature.

Capytaine (extra `wet`) is optional; without it these tests are skipped, and one shows what its absence says.
"""

import sys

import numpy as np
import pytest
from floating_bodies import SEMICIRCLE, prism_sections, rectangle, spheroid_sections, uniform_girder

from hullvib import StodolaRitz, wet
from hullvib.errors import ArgumentError
from hullvib.wet.capytaine_flow import CapytaineFlow

LENGTH = 200.0


def hull_like():
    """A transom that is immersed, a parallel body, a raked bow that ends in a point."""
    t = np.linspace(0.0, 1.0, 41)
    breadth = np.minimum(1.0, 0.6 + 2.0 * t) * np.sqrt(np.clip(4.0 * (1.0 - t), 0.0, 1.0))
    draught = np.minimum(1.0, 0.3 + 3.0 * t)
    curve = SEMICIRCLE / np.maximum(np.hypot(*SEMICIRCLE.T**3), 1e-300)[:, None] ** (1 / 3)
    curve[0, 0], curve[-1, 1] = 0.0, 0.0
    return wet.Sections(LENGTH * t, curve * np.stack([14.0 * breadth, 9.0 * draught], axis=-1)[:, None])


@pytest.mark.parametrize(
    ("name", "sections", "lengthwise"),
    [
        ("spheroid", spheroid_sections(LENGTH, 25.0, 41), None),
        ("box", prism_sections(rectangle(30.0, 6.0), LENGTH), 40),
        ("hull", hull_like(), 40),
    ],
)
@pytest.mark.parametrize("shear", [False, True], ids=["euler", "shear"])
def test_wet_frequencies(name, sections, lengthwise, shear):
    pytest.importorskip("capytaine")
    panels = wet.Panels.from_sections(sections, lengthwise, 9)
    girder = uniform_girder(LENGTH, 150e3, 3e13, 8e10)
    method = StodolaRitz(12, shear=shear)
    own = wet.solve(girder, wet.PanelFlow(panels, neutral_axis_m=-2.0), method)
    theirs = wet.solve(girder, CapytaineFlow(panels, neutral_axis_m=-2.0), method)
    error = np.abs(own.modes.angular_frequencies / theirs.modes.angular_frequencies - 1.0)
    assert error.max() < 1e-3
    assert theirs.modes.method["flow"] == "capytaine"
    np.testing.assert_allclose(own.added_mass.matrix, theirs.added_mass.matrix, atol=4e-3 * own.added_mass.matrix.max())


def test_its_absence_is_told(monkeypatch):
    monkeypatch.setitem(sys.modules, "capytaine", None)
    panels = wet.Panels.from_sections(prism_sections(rectangle(30.0, 6.0), LENGTH), 6, 4)
    with pytest.raises(ArgumentError, match=r"pip install 'hullform\[wet\]'"):
        CapytaineFlow(panels, neutral_axis_m=0.0)
