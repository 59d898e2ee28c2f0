"""The hull below a waterline: the curves and the panels that the water about her is solved on.

All that it asks of a hull are her sections' curves at given places, from keel to deck.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hullform.errors import HullError
from hullform.hull.equilibrium import Waterline
from hullform.hull.loft import Hull
from hullvib.wet.panels import Panels, graded_places
from hullvib.wet.sections import Sections

Array = NDArray[np.float64]

LENGTHWISE = 46
GIRTHWISE = 11
CURVE_POINTS = 65
# Places between sections at which the keel is looked at; rounds, of so many parts, that find where it leaves the water.
_LOOKS = 4
_ROUNDS, _PARTS = 5, 16


def wetted_sections(hull: Hull, waterline: Waterline, count: int = LENGTHWISE + 1) -> Sections:
    """`count` half sections below a waterline, closer together at the ends of what is wet.

    z counts from the waterline; a trimmed one is taken as level, section by section, which costs the sine of the trim.
    Above the deck the sides go on upright, as they do for the buoyancy. Of two stretches that are wet, apart from each
    other, the longer is taken.

    Raises:
        HullError: nothing of her is under the waterline.
    """
    places = graded_places(*_wet_stretch(hull, waterline), count)
    curves = hull.section_points(CURVE_POINTS, places)
    heights = waterline.heights(places)
    return Sections(places, np.stack([_below(curve, height) for curve, height in zip(curves, heights, strict=True)]))


def wetted_panels(sections: Sections, girthwise: int = GIRTHWISE) -> Panels:
    """Panels of the half hull between wetted sections, `girthwise` from keel to waterline."""
    return Panels.from_sections(sections, girthwise=girthwise)


def _wet_stretch(hull: Hull, waterline: Waterline) -> tuple[float, float]:
    """The longest stretch of x in which the keel is under water."""
    x = np.interp(np.arange(_LOOKS * (len(hull.x_m) - 1) + 1) / _LOOKS, np.arange(len(hull.x_m)), hull.x_m)
    wet = _keel_depths(hull, waterline, x) > 0.0
    bounds = np.flatnonzero(np.diff(np.concatenate([[False], wet, [False]]).astype(int)))
    if not len(bounds):
        raise HullError("nothing of the hull is under water; check the draughts and the weights")
    first, last = max(zip(bounds[::2], bounds[1::2] - 1, strict=True), key=lambda span: x[span[1]] - x[span[0]])
    start = x[first] if first == 0 else _leaves_water(hull, waterline, x[first], x[first - 1])
    end = x[last] if last == len(x) - 1 else _leaves_water(hull, waterline, x[last], x[last + 1])
    return float(start), float(end)


def _leaves_water(hull: Hull, waterline: Waterline, wet: float, dry: float) -> float:
    for _ in range(_ROUNDS):
        places = np.linspace(wet, dry, _PARTS + 1)
        first_dry = int(np.argmax(_keel_depths(hull, waterline, places)[1:] <= 0.0)) + 1
        wet, dry = float(places[first_dry - 1]), float(places[first_dry])
    return wet


def _keel_depths(hull: Hull, waterline: Waterline, x: Array) -> Array:
    """Depths of the sections' lowest points below the waterline; where a section has no breadth, -1."""
    curves = hull.section_points(CURVE_POINTS, x)
    depths = waterline.heights(x) - curves[..., 1].min(axis=1)
    return np.where(curves[..., 0].max(axis=1) > 0.0, depths, -1.0)


def _below(curve: Array, height: float) -> Array:
    """A section's curve (k, 2) up to a height, which becomes 0, in as many points along its arc."""
    y, z = curve[:, 0], curve[:, 1] - height
    above = np.flatnonzero(z > 0.0)
    if len(above) == 0:
        y, z = np.append(y, y[-1]), np.append(z, 0.0)
    elif above[0] == 0:
        y, z = y[:1], np.zeros(1)
    else:
        cut = int(above[0])
        share = z[cut - 1] / (z[cut - 1] - z[cut])
        y = np.append(y[:cut], y[cut - 1] + share * (y[cut] - y[cut - 1]))
        z = np.append(z[:cut], 0.0)
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    # the curve's own points, which stand closer where it turns, and more of them where it was cut
    along = np.interp(np.linspace(0.0, len(arc) - 1.0, len(curve)), np.arange(len(arc)), arc)
    return np.stack([np.interp(along, arc, y), np.interp(along, arc, z)], axis=1)
