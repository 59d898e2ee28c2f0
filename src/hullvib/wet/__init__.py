"""Girders in water: added mass in the limit of high frequency, and wet modes.

>>> import numpy as np, hullvib
>>> from hullvib import wet
>>> angle = np.linspace(0.0, np.pi / 2, 30)
>>> x = np.linspace(0.0, 200.0, 41)
>>> radius = 10.0 * np.sqrt(np.maximum(1.0 - (x / 100.0 - 1.0) ** 2, 0.0))
>>> half = np.stack([np.sin(angle), -np.cos(angle)], axis=-1)  # keel to waterline
>>> sections = wet.Sections(x, radius[:, None, None] * half)
>>> flow = wet.PanelFlow(wet.Panels.from_sections(sections), neutral_axis_m=0.0)
>>> girder = hullvib.Girder([0.0, 200.0], [160e3, 160e3], [2e13, 2e13], name="a uniform girder in a spheroid")
>>> afloat = wet.solve(girder, flow, modes=2)
>>> (hullvib.solve(girder, modes=2).frequencies_hz.round(2), afloat.modes.frequencies_hz.round(2))
(array([0.99, 2.74]), array([0.79, 2.21]))
"""

from hullvib.wet.added_mass import AddedMass, Flow
from hullvib.wet.motions import GirderMotions, MixedField, Motions
from hullvib.wet.panel_flow import PanelFlow
from hullvib.wet.panels import Panels, graded_places
from hullvib.wet.sections import Sections
from hullvib.wet.solving import solve
from hullvib.wet.spheroid import bending_factors, sliding_factors, spheroid_added_mass
from hullvib.wet.strip_flow import StripFlow, townsin_factor
from hullvib.wet.two_dimensional import lewis_added_mass, lewis_coefficient, section_added_mass
from hullvib.wet.wet_modes import RigidMotion, WetModes

__all__ = [
    "AddedMass",
    "Flow",
    "GirderMotions",
    "MixedField",
    "Motions",
    "PanelFlow",
    "Panels",
    "RigidMotion",
    "Sections",
    "StripFlow",
    "WetModes",
    "bending_factors",
    "graded_places",
    "lewis_added_mass",
    "lewis_coefficient",
    "section_added_mass",
    "sliding_factors",
    "solve",
    "spheroid_added_mass",
    "townsin_factor",
]
