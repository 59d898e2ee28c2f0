"""hullform: from a picture of a ship's body plan to the girder that vibrates.

Names are loaded when they are first used, so that importing the package costs nothing.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from hullform.body_plan import BodyPlan as BodyPlan
    from hullform.errors import HullformError as HullformError
    from hullform.hull.fitting import fit_super_ellipse as fit_super_ellipse
    from hullform.hull.loft import Hull as Hull
    from hullform.hull.super_ellipse import SuperEllipse as SuperEllipse
    from hullform.pipeline import girder_of as girder_of
    from hullform.pipeline import run_ship as run_ship
    from hullform.pipeline import trace as trace
    from hullform.ship import read_ship as read_ship
    from hullform.writing import write_run as write_run

_HOMES = {
    "BodyPlan": "body_plan",
    "Hull": "hull.loft",
    "HullformError": "errors",
    "SuperEllipse": "hull.super_ellipse",
    "fit_super_ellipse": "hull.fitting",
    "girder_of": "pipeline",
    "read_ship": "ship",
    "run_ship": "pipeline",
    "trace": "pipeline",
    "write_run": "writing",
}

__all__ = sorted(_HOMES)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'hullform' has no attribute {name!r}")
    return getattr(importlib.import_module(f"hullform.{_HOMES[name]}"), name)
