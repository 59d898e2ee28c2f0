"""Sections and the hull: from the stations of a body plan to a closed form that floats."""

from hullform.hull.contours import Contours
from hullform.hull.drawn import Extrapolation, FittedStation
from hullform.hull.equilibrium import FloatingPosition, Waterline
from hullform.hull.fitting import SectionFit, fit_super_ellipse
from hullform.hull.hydrostatics import BonjeanCurves, Hydrostatics
from hullform.hull.ladder import SectionModel
from hullform.hull.loft import Hull
from hullform.hull.lofted_stations import Particulars
from hullform.hull.mesh_files import export_mesh
from hullform.hull.sections import Sections
from hullform.hull.super_ellipse import ShellSection, SuperEllipse, shell_section

__all__ = [
    "BonjeanCurves",
    "Contours",
    "Extrapolation",
    "FittedStation",
    "FloatingPosition",
    "Hull",
    "Hydrostatics",
    "Particulars",
    "SectionFit",
    "SectionModel",
    "Sections",
    "ShellSection",
    "SuperEllipse",
    "Waterline",
    "export_mesh",
    "fit_super_ellipse",
    "shell_section",
]
