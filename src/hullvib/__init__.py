"""Natural frequencies of hull girders in vertical bending: a Girder in, Modes out.

>>> import hullvib
>>> girder = hullvib.Girder([0.0, 100.0], [50e3, 50e3], [1e13, 1e13], name="a uniform girder")
>>> hullvib.solve(girder).frequencies_hz.round(4).tolist()
[5.0358, 13.8813, 27.2128, 44.9842, 67.1986]
"""

from hullvib import distortion, empirical, engine, errors, real_ships, resonance, sensitivity, springing, wet
from hullvib.bounds import Bracket, bracket
from hullvib.correlation import Orthogonality, mac, orthogonality
from hullvib.distortion import ritz_convergence
from hullvib.errors import (
    ArgumentError,
    GirderError,
    GirderFileError,
    HullvibError,
    ModeFileError,
    NotProven,
    SolutionError,
)
from hullvib.finite_elements import FiniteElements
from hullvib.forced import ForcedResponse, HarmonicLoad, forced_response, participation
from hullvib.girder import Girder
from hullvib.girder_files import parse_girder, read_girder, write_girder
from hullvib.girder_stack import GirderStack
from hullvib.many import ManyModes, solve_many
from hullvib.mode_files import write_modes
from hullvib.model_spread import model_uncertainty, ratio_uncertainty
from hullvib.modes import Modes
from hullvib.point_masses import PointMass
from hullvib.ritz import Ritz
from hullvib.solving import Method, solve
from hullvib.stodola import StodolaRitz
from hullvib.timoshenko import TimoshenkoRitz
from hullvib.timoshenko_elements import TimoshenkoElements

__all__ = [
    "ArgumentError",
    "Bracket",
    "FiniteElements",
    "ForcedResponse",
    "Girder",
    "GirderError",
    "GirderFileError",
    "GirderStack",
    "HarmonicLoad",
    "HullvibError",
    "ManyModes",
    "Method",
    "ModeFileError",
    "Modes",
    "NotProven",
    "Orthogonality",
    "PointMass",
    "Ritz",
    "SolutionError",
    "StodolaRitz",
    "TimoshenkoElements",
    "TimoshenkoRitz",
    "bracket",
    "distortion",
    "empirical",
    "engine",
    "errors",
    "forced_response",
    "mac",
    "model_uncertainty",
    "orthogonality",
    "parse_girder",
    "participation",
    "ratio_uncertainty",
    "read_girder",
    "real_ships",
    "resonance",
    "ritz_convergence",
    "sensitivity",
    "solve",
    "solve_many",
    "springing",
    "wet",
    "write_girder",
    "write_modes",
]
