"""How fair a hull is between her drawn stations: waves of her waterlines, her distance from a form that is known."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.hull import Hull
from hullform.hull.outlines import largest_distance

if TYPE_CHECKING:
    from drawing.moulded import Moulded

Array = NDArray[np.float64]

# Of the depth amidships: the heights of the waterlines, close together where a flat bottom ends.
HEIGHTS = (0.01, 0.02, 0.03, 0.05, 0.08, 0.12, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
STEPS = 8  # between two stations
POINTS = 161  # of a section
THINNEST = 1.25e-3  # of the breadth: a form that is thinner is not there
LEAST_SAGITTA = 5e-4  # of the breadth, over the distance of two stations: a flatter bend is straight


class Waves(NamedTuple):
    """How many bends too many the waterlines have between stations, and the largest of them."""

    count: int
    largest_percent: float


def waves(half_breadths: Callable[[Array, float], Array], x_m: Array, depth_m: float, breadth_m: float) -> Waves:
    """Of the waterlines between stations at x_m (n,), increasing, all but the first and the last.

    A bend is a stretch of a waterline that curves one way, its size the sagitta, in per cent of the breadth, that its
    greatest curvature would have over the distance of the two stations. What the stations themselves ask for is one
    bend, or two of opposite sense where second differences of their half-breadths have opposite signs; every other is
    one too many. Waterlines that come to the centre line at one of the four stations about are left out.

    half_breadths: (n,) at places (n,) and a height, 0 where there is none; depth_m: amidships.
    """
    count, largest = 0, 0.0
    for height in np.array(HEIGHTS) * depth_m:
        drawn = half_breadths(x_m, height)
        curving = np.diff(np.diff(drawn) / np.diff(x_m))
        for n in range(1, len(x_m) - 2):
            if drawn[n - 1 : n + 3].min() <= 0:
                continue
            y = half_breadths(np.linspace(x_m[n], x_m[n + 1], STEPS + 1), height)
            bends = _bends(np.diff(y, 2) * STEPS**2 / 8 / breadth_m)
            wanted = 2 if curving[n - 1] * curving[n] < 0 else 1
            if len(bends) > wanted:
                count += len(bends) - wanted
                largest = max(largest, float(np.sort(np.abs(bends))[-wanted - 1]))
    return Waves(count, 100 * largest)


def waves_of(hull: Hull, x_m: Array) -> Waves:
    """Of a lofted hull between her stations at x_m."""

    def half_breadths(places: Array, height_m: float) -> Array:
        outline = hull.sections_at(places).mesh_points(POINTS)
        y, z = outline[..., 0], outline[..., 1]
        low, high = np.minimum(z[:, :-1], z[:, 1:]), np.maximum(z[:, :-1], z[:, 1:])
        crossed = (low <= height_m) & (high > height_m)
        share = np.divide(height_m - z[:, :-1], np.diff(z), out=np.zeros_like(low), where=crossed)
        return np.asarray(np.where(crossed, y[:, :-1] + share * np.diff(y), 0.0).max(axis=1))

    return waves(half_breadths, x_m, hull.depth_amidships_m, hull.breadth_m)


def waves_of_form(form: Moulded, x_m: Array) -> Waves:
    """Of a form that is known everywhere, between the same stations: what she has of her own."""
    main = form.particulars

    def half_breadths(places: Array, height_m: float) -> Array:
        found = np.array([form.half_breadth_at(float(x), height_m) for x in places])
        return np.where(found > THINNEST * main.breadth_m, found, 0.0)

    return waves(half_breadths, x_m, main.depth_m, main.breadth_m)


def _bends(sagitta: Array) -> Array:
    """The sagitta of each bend in turn, those too flat left out."""
    curved = sagitta[np.abs(sagitta) > LEAST_SAGITTA]
    if not len(curved):
        return curved
    parts = np.split(curved, np.flatnonzero(np.diff(np.sign(curved))) + 1)
    return np.array([part[np.argmax(np.abs(part))] for part in parts])


def drawn_plan(form: Moulded, points: int = 400) -> BodyPlan:
    """The body plan of a ship's own stations, without a picture: the form's sections as they are."""
    main = form.particulars
    halves = (("aft", main.aft_stations), ("fore", main.fore_stations))
    return BodyPlan(
        tuple(
            Station(x, half, tuple(TracedCurve(*curve.T) for curve in form.curves(x, points)), name)  # type: ignore[arg-type]
            for half, stations in halves
            for name, x in stations
        ),
        "offsets",
    )


def distances(hull: Hull, form: Moulded, x_m: Array) -> Array:
    """(n,) Hausdorff distances of the hull's sections at x_m from the form's, in per cent of the breadth."""
    found = []
    for x in x_m:
        true = [np.concatenate([[[0.0, curve[0, 1]]], curve]) for curve in form.curves(float(x))]
        lofted = list(hull.section_curves(float(x)))
        if len(true) != len(lofted):
            true, lofted = [np.concatenate(true)], [np.concatenate(lofted)]
        found.append(max(largest_distance(a, b) for a, b in zip(true, lofted, strict=True)))
    return 100 * np.array(found) / hull.breadth_m
