"""From the drawn stations of a body plan to sections along the whole ship."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import groupby, pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

from hullform.body_plan import BodyPlan, Half, Station
from hullform.errors import HullError
from hullform.hull.fitting import SectionFit
from hullform.hull.ladder import Choice, SectionModel, chosen_model, super_ellipse_model
from hullform.hull.outlines import contours_of
from hullform.hull.sections import Sections

Array = NDArray[np.float64]

# Below this share of the half-breadth a station is a line in the drawing, of the width of the pen: its breadth and
# heights are taken, exponents are not fitted.
THINNEST_FITTED = 0.005

# Halves that draw the same station may differ by this share of the breadth (a pen's width or two) without a word.
_HALVES_TOLERANCE = 0.005

# A loft beyond the outermost station by more than this share of the length is a guess that a person should look at.
_EXTRAPOLATION_TOLERANCE = 0.03
# Of the length, and of the area: drawn ships have stations a tenth apart, but for their parallel body.
_LONGEST_GAP, _ALIKE = 0.25, 0.05


@dataclass(frozen=True, slots=True)
class FittedStation:
    """A drawn station, its contours (`outlines.contours_of`), and the model that stands for it.

    The model is None where the station is too thin to have a shape.
    """

    x_m: float
    half: Half
    name: str
    model: SectionModel | None
    contours: tuple[Array, ...]
    half_breadth_m: float
    top_height_m: float
    keel_height_m: float

    @property
    def fit(self) -> SectionFit | None:
        """The super-ellipse, where that is the model."""
        return None if self.model is None else self.model.ellipse

    @property
    def outline(self) -> Array:
        """(k, 2) [half-breadth, height] from keel to deck, of the model or as drawn, contour after contour."""
        return np.concatenate(self.contours if self.model is None else self.model.contours)


@dataclass(frozen=True, slots=True)
class Extrapolation:
    """A span of the ship, from_m to to_m, that no drawn station bounds on its outer side."""

    from_m: float
    to_m: float


def fit_stations(
    body_plan: BodyPlan, breadth_m: float, draught_m: float, choice: Choice = "auto"
) -> tuple[FittedStation, ...]:
    """Find the model of every drawn station (`ladder`); stations that share a curve share its model.

    Raises:
        HullError: a station has no shape; the message names it.
    """
    known: dict[bytes, FittedStation] = {}
    fitted = []
    for station in body_plan.stations:
        contours = contours_of(station)
        key = b"|".join(points.tobytes() for points in contours)
        found = known.get(key)
        if found is None:
            try:
                found = _fit(station, contours, breadth_m, draught_m, choice)
            except HullError as error:
                raise HullError(
                    f"station {station.name} ({station.half} half, x = {station.x_m:g} m): {error}"
                ) from error
            known[key] = found
        fitted.append(replace(found, x_m=station.x_m, half=station.half, name=station.name))
    return tuple(fitted)


def _fit(
    station: Station, contours: tuple[Array, ...], breadth_m: float, draught_m: float, choice: Choice
) -> FittedStation:
    place = station.x_m, station.half, station.name
    y, z = np.concatenate(contours).T
    extent = max(float(y.max()), 0.0), float(z.max()), float(z.min())
    if y.max() <= THINNEST_FITTED * breadth_m / 2:
        return FittedStation(*place, None, contours, *extent)
    first = super_ellipse_model(contours, breadth_m, draught_m)
    model = chosen_model(contours, breadth_m, draught_m, choice, first)
    if model.ellipse is not None:
        fit = model.ellipse
        extent = fit.ellipse.half_breadth, fit.top_height_m, fit.keel_height_m
    return FittedStation(*place, model, contours, *extent)


def merge_halves(
    stations: Sequence[FittedStation], breadth_m: float
) -> tuple[tuple[FittedStation, ...], tuple[str, ...]]:
    """Return one station per x, the mean of the halves that both draw it, and a doubt where the halves disagree."""
    merged, doubts = [], []
    for x, group in groupby(sorted(stations, key=lambda station: station.x_m), key=lambda station: station.x_m):
        same = list(group)
        extent = np.array([[s.half_breadth_m, s.top_height_m, s.keel_height_m] for s in same])
        spread = np.ptp(extent, axis=0)
        if spread.max() > _HALVES_TOLERANCE * breadth_m:
            what = ("half-breadth", "top height", "keel height")[int(np.argmax(spread))]
            doubts.append(
                f"station {same[0].name} (x = {x:g} m) is drawn more than once and its {what} differs by "
                f"{spread.max():.2f} m, limit {_HALVES_TOLERANCE * breadth_m:.2f} m; the mean is used: check the "
                "stations' x"
            )
        a, top, keel = (float(v) for v in extent.mean(axis=0))
        best = min(same, key=_miss)
        merged.append(replace(best, half_breadth_m=a, top_height_m=top, keel_height_m=keel))
    return tuple(merged), tuple(doubts)


def _miss(station: FittedStation) -> float:
    """By which the fit that stands for all halves is found: the one that misses its points the least."""
    if station.fit is not None:
        return station.fit.rms_m
    return np.inf if station.model is None else station.model.largest_deviation_m


def station_places(length_m: float, count: int) -> Array:
    """Return x of lofted stations over 0..length, about three times as dense at the ends as amidships.

    x = L (0.3 u + 0.7 (1 - cos pi u) / 2), u even over 0..1: the ends, where a form changes fast and stations are drawn
    close together, keep their detail; the middle is a parallel body or nearly so.
    """
    u = np.linspace(0.0, 1.0, count)
    x = length_m * (0.3 * u + 0.35 * (1 - np.cos(np.pi * u)))
    x[-1] = length_m
    return x


def lofted_super_ellipses(stations: Sequence[FittedStation], x: Array) -> Sections:
    """Interpolate stations that are super-ellipses, one per x, to the places x.

    Between drawn stations half-breadth, top and keel height and the logarithms of p and q follow monotone cubics.
    Beyond the outermost ones the half-breadth follows the parabola through the last three, held to 0..its last value
    and never growing outwards; top and keel go on in a straight line, by no more than their last drawn step;
    exponents stay. Stations too thin to have a shape take the exponents of their neighbours.
    """
    drawn_x = np.array([station.x_m for station in stations])
    shaped = [station for station in stations if station.fit is not None]
    if len(stations) < 3 or not shaped:
        raise HullError(
            f"a hull needs three or more stations at different x, one of them with a shape; the body plan has "
            f"{len(stations)} and {len(shaped)}"
        )
    a = with_ends(drawn_x, np.array([station.half_breadth_m for station in stations]), x, outer_breadths)
    top = with_ends(drawn_x, np.array([station.top_height_m for station in stations]), x, outer_heights)
    keel = with_ends(drawn_x, np.array([station.keel_height_m for station in stations]), x, outer_heights)
    shaped_x = np.array([station.x_m for station in shaped])
    exponents = np.log([[s.fit.ellipse.p, s.fit.ellipse.q] for s in shaped if s.fit is not None])
    inside = np.clip(x, shaped_x[0], shaped_x[-1])
    p, q = np.exp(PchipInterpolator(shaped_x, exponents)(inside) if len(shaped) > 1 else exponents[[0] * len(x)]).T
    return Sections(np.maximum(a, 0.0), np.maximum(top - keel, 0.0), top, p, q)


def extrapolated_spans(drawn_x: Array, length_m: float) -> tuple[tuple[Extrapolation, ...], tuple[str, ...]]:
    """The spans outside the outermost of stations at drawn_x, increasing, and a doubt for each long one."""
    ends = (Extrapolation(0.0, float(drawn_x[0])), Extrapolation(float(drawn_x[-1]), length_m))
    spans = tuple(span for span in ends if span.to_m - span.from_m > 1e-6 * length_m)
    doubts = tuple(
        f"no station is drawn between x = {span.from_m:.2f} and {span.to_m:.2f} m, more than "
        f"{_EXTRAPOLATION_TOLERANCE:.0%} of the length; the form there is extrapolated: add a station near the end"
        for span in spans
        if span.to_m - span.from_m > _EXTRAPOLATION_TOLERANCE * length_m
    )
    return spans, doubts


def doubts_of_gaps(body_plan: BodyPlan, length_m: float) -> tuple[str, ...]:
    """A doubt for each long gap between stations that are not those of a parallel body."""
    areas: dict[float, float] = {}
    for station in body_plan.stations:
        areas[station.x_m] = max(areas.get(station.x_m, 0.0), station.area_below(np.inf))
    return tuple(
        f"no station is drawn between x = {aft:g} and {fore:g} m, {(fore - aft) / length_m:.0%} of the length, and the "
        "sections there are not alike; stations are places in metres, not numbers: add those that are missing"
        for (aft, one), (fore, other) in pairwise(sorted(areas.items()))
        if fore - aft > _LONGEST_GAP * length_m and abs(one - other) > _ALIKE * max(one, other)
    )


def outer_breadths(drawn_x: Array, values: Array, x: Array) -> Array:
    """Beyond the foremost: by the parabola through the last three, held to 0..the last and never growing."""
    parabola = np.polynomial.Polynomial.fit(drawn_x[-3:], values[-3:], 2)
    return np.minimum.accumulate(np.clip(parabola(x), 0.0, values[-1]))


def outer_heights(drawn_x: Array, values: Array, x: Array) -> Array:
    """Beyond the foremost: on in a straight line, by no more than the last step."""
    step = values[-1] - values[-2]
    change = step * (x - drawn_x[-1]) / (drawn_x[-1] - drawn_x[-2])
    return np.asarray(values[-1] + np.clip(change, -abs(step), abs(step)))


def with_ends(drawn_x: Array, values: Array, x: Array, outer: Callable[[Array, Array, Array], Array]) -> Array:
    """Values at drawn_x by monotone cubics at x, and by `outer` beyond the outermost."""
    result = np.asarray(PchipInterpolator(drawn_x, values)(np.clip(x, drawn_x[0], drawn_x[-1])), dtype=np.float64)
    aft, fore = x < drawn_x[0], x > drawn_x[-1]
    if aft.any():
        # Mirrored, so that both ends run away from the drawn stations.
        result[aft] = outer(-drawn_x[::-1], values[::-1], -x[aft][::-1])[::-1]
    if fore.any():
        result[fore] = outer(drawn_x, values, x[fore])
    return result
