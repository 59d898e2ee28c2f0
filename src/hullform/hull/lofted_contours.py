"""From stations of any curve to polyline sections along the whole ship."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

from hullform.errors import HullError
from hullform.hull.contours import Contours
from hullform.hull.correspondence import matched_points
from hullform.hull.drawn import FittedStation, outer_breadths, outer_heights, with_ends

Array = NDArray[np.float64]

# Points of a section from keel to deck, corners on top of them.
POINTS = 121
# Of the distance between lofted sections: one that comes nearer to a drawn station gives way to it.
_NEAREST = 0.4
# Of its depth: what is left of the last section, at the least, where its keel rises to the deck outside it.
_LEAST_DEPTH = 0.1
_ON_CENTRE = 1e-6  # of the greatest half-breadth


def places_with_stations(x: Array, drawn_x: Array) -> Array:
    """Places x of lofted sections with every drawn station within them among them; those too near to one left out."""
    inside = drawn_x[(drawn_x >= x[0]) & (drawn_x <= x[-1])]
    spacing = np.gradient(x)
    apart = np.abs(x[:, None] - inside).min(axis=1)
    ends = np.isin(np.arange(len(x)), [0, len(x) - 1])
    return np.union1d(x[(apart > _NEAREST * spacing) | ends], inside)


def lofted_contours(stations: Sequence[FittedStation], x: Array, breadth_m: float) -> Contours:
    """Loft stations, of several at one x the mean, to the places x.

    Matched points (`correspondence`) follow monotone cubics between the drawn stations. Beyond the outermost ones the
    last section goes on, its breadth as the parabola through the greatest breadths of the last three has it, held to
    0..its own and never growing outwards, its keel and deck in straight lines, by no more than their last drawn step
    and not quite to each other; a bulb of its own closes there.

    Raises:
        HullError: there are fewer than three stations at different x, or none has a shape.
    """
    ordered = sorted(stations, key=lambda station: station.x_m)
    groups = [(at, [s.outline for s in same]) for at, same in groupby(ordered, key=lambda station: station.x_m)]
    shaped = sum(station.model is not None for station in stations)
    if len(groups) < 3 or not shaped:
        raise HullError(
            f"a hull needs three or more stations at different x, one of them with a shape; the body plan has "
            f"{len(groups)} and {shaped}"
        )
    drawn_x = np.array([at for at, _ in groups])
    outlines = [outline[0] if len(outline) == 1 else _mean(outline, breadth_m) for _, outline in groups]
    matched = matched_points(outlines, POINTS, breadth_m)
    matched[..., 0] = np.maximum(matched[..., 0], 0.0)
    held = np.clip(x, drawn_x[0], drawn_x[-1])
    lofted = PchipInterpolator(drawn_x, matched, axis=0)(held)
    widest, top, keel = matched[..., 0].max(axis=1), matched[:, -1, 1], matched[..., 1].min(axis=1)
    wide = with_ends(drawn_x, widest, x, outer_breadths)
    high, low = (with_ends(drawn_x, values, x, outer_heights) for values in (top, keel))
    for last, outside in ((matched[0], x < drawn_x[0]), (matched[-1], x > drawn_x[-1])):
        if outside.any():
            reach = np.abs(x - held)[outside]
            lofted[outside] = _going_on(last, reach, wide[outside], high[outside], low[outside])
    lofted[..., 0] = np.maximum(lofted[..., 0], 0.0)
    return Contours(lofted)


def _going_on(last: Array, reach: Array, wide: Array, high: Array, low: Array) -> Array:
    """Sections (k, m, 2) outside the last one (m, 2), at distances (k,) from it, of given breadths and heights.

    A lower contour of its own, a bulb or a gondola, does not go on with the rest: it closes as half an ellipse does,
    over a length of its own height, or what there is of the ship.
    """
    y, z = last.T
    deck, bottom = z[-1], z.min()
    low = np.minimum(low, high - _LEAST_DEPTH * (deck - bottom))
    breadths = (wide / max(float(y.max()), 1e-300))[:, None] * y
    heights = low[:, None] + ((high - low) / max(float(deck - bottom), 1e-300))[:, None] * (z - bottom)
    centre_line = np.flatnonzero((y[:-1] <= _ON_CENTRE * y.max()) & (y[1:] <= _ON_CENTRE * y.max()))
    if len(centre_line) and 0 < centre_line[0] < len(y) - 2:
        lower = slice(0, int(centre_line[0]) + 1)
        length = min(float(np.ptp(z[lower])), float(reach.max()))
        left = np.sqrt(np.maximum(1 - (reach / length) ** 2, 0.0))[:, None]
        middle = (z[lower].max() + z[lower].min()) / 2
        breadths[:, lower] = left * y[lower]
        heights[:, lower] = middle + left * (z[lower] - middle)
    return np.stack([breadths, heights], axis=-1)


def _mean(outlines: Sequence[Array], breadth_m: float) -> Array:
    return np.asarray(matched_points(outlines, POINTS, breadth_m).mean(axis=0))
