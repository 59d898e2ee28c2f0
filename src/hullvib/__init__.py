"""Natural frequencies of hull girders in vertical bending: a Girder in, Modes out.

>>> import hullvib
>>> girder = hullvib.Girder([0.0, 100.0], [50e3, 50e3], [1e13, 1e13], name="a uniform girder")
>>> hullvib.solve(girder).frequencies_hz.round(4).tolist()
[5.0358, 13.8813, 27.2128, 44.9842, 67.1986]
"""

from hullvib import distortion, empirical, errors
from hullvib.distortion import ritz_convergence
from hullvib.errors import ArgumentError, GirderError, GirderFileError, HullvibError, SolutionError
from hullvib.finite_elements import FiniteElements
from hullvib.girder import Girder, PointMass
from hullvib.girder_files import parse_girder, read_girder, write_girder
from hullvib.modes import Modes
from hullvib.ritz import Ritz
from hullvib.solving import Method, solve

__all__ = [
    "ArgumentError",
    "FiniteElements",
    "Girder",
    "GirderError",
    "GirderFileError",
    "HullvibError",
    "Method",
    "Modes",
    "PointMass",
    "Ritz",
    "SolutionError",
    "distortion",
    "empirical",
    "errors",
    "parse_girder",
    "read_girder",
    "ritz_convergence",
    "solve",
    "write_girder",
]
