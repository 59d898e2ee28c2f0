"""Which curve stands for a station: a ladder of models, climbed until one lies near enough to what was drawn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from hullform.hull.fair_curve import fair_curve
from hullform.hull.fitting import SectionFit, fit_super_ellipse
from hullform.hull.flared import flared_rectellipse
from hullform.hull.outlines import area_below, corners_of, largest_distance, resampled
from hullform.hull.stacked import stacked_super_ellipses

Array = NDArray[np.float64]
Kind = Literal["super-ellipse", "flared rectellipse", "two super-ellipses", "spline", "traced polyline"]
Choice = Literal["auto", "super-ellipse", "traced"]

# A model is near enough within these: of the breadth, and of the station's area below the waterline and to the deck.
LARGEST_DEVIATION = 0.005
LARGEST_AREA_ERROR = 0.005
# Of breadth times draught: an area below the waterline counts as no less than this.
_LEAST_AREA = 1e-4
_CURVE_POINTS = 161
_FEWEST_FITTED = 9  # points of a curve of two or three straight lines that the super-ellipse sees
# The most corners that one super-ellipse can follow, its bilge, and two can, a knuckle between their bilges.
_CORNERS_OF_ONE, _CORNERS_OF_TWO = 1, 3
# Of the breadth: a contour whose height falls by less goes up all the way.
_LEVEL = 1e-3


@dataclass(frozen=True, eq=False)
class SectionModel:
    """What stands for a station, and how near it is.

    Attributes:
        kind: the model.
        contours: its curves (k, 2) [half-breadth, height] in m, the lowest contour first.
        largest_deviation_m: Hausdorff distance from the drawn contours, in m.
        area_error: area below the waterline less the drawn one, as a share of the drawn one.
        area_error_to_deck: the same of the whole section.
        ellipse: the fitted super-ellipse, where the model is one.
    """

    kind: Kind
    contours: tuple[Array, ...]
    largest_deviation_m: float
    area_error: float
    area_error_to_deck: float
    ellipse: SectionFit | None = None


def super_ellipse_model(drawn: tuple[Array, ...], breadth_m: float, draught_m: float) -> SectionModel:
    """The super-ellipse of a station's contours.

    Raises:
        HullError: the station has no shape that it could fit.
    """
    points = np.concatenate(drawn)
    fit = fit_super_ellipse(points if len(points) > 3 else resampled(points, _FEWEST_FITTED))
    return _measured("super-ellipse", (fit.points(_CURVE_POINTS),), drawn, breadth_m, draught_m, fit)


def chosen_model(
    drawn: tuple[Array, ...], breadth_m: float, draught_m: float, choice: Choice, first: SectionModel
) -> SectionModel:
    """The first model of the ladder that is near enough.

    Args:
        drawn: the station's contours, closed to the centre line (`outlines.contours_of`).
        breadth_m, draught_m: the ship's.
        choice: "auto" for the whole ladder, "super-ellipse" for its first rung alone, "traced" for splines and traces.
        first: the super-ellipse.
    """
    if choice == "super-ellipse" or (choice == "auto" and near_enough(first, breadth_m)):
        return first
    for kind, contours in _rungs(drawn, breadth_m, draught_m, choice):
        model = _measured(kind, contours, drawn, breadth_m, draught_m)
        if near_enough(model, breadth_m):
            return model
    return _measured("traced polyline", drawn, drawn, breadth_m, draught_m)


def near_enough(model: SectionModel, breadth_m: float) -> bool:
    """Whether a model may stand for its station."""
    areas = max(abs(model.area_error), abs(model.area_error_to_deck))
    return model.largest_deviation_m <= LARGEST_DEVIATION * breadth_m and areas <= LARGEST_AREA_ERROR


def _rungs(
    drawn: tuple[Array, ...], breadth_m: float, draught_m: float, choice: Choice
) -> Iterator[tuple[Kind, tuple[Array, ...]]]:
    """Each model above the super-ellipse in turn; those of y(z) where the station has one contour that goes up."""
    if choice == "auto" and len(drawn) == 1:
        (points,) = drawn
        fall = float(np.max(np.maximum.accumulate(points[:, 1]) - points[:, 1]))
        if fall <= _LEVEL * breadth_m and points[-1, 1] - points[0, 1] > _LEVEL * breadth_m and len(points) > 3:
            corners = len(corners_of(points, breadth_m))
            if corners <= _CORNERS_OF_ONE:
                yield "flared rectellipse", (flared_rectellipse(points, _CURVE_POINTS),)
            if corners <= _CORNERS_OF_TWO:
                stacked = stacked_super_ellipses(points, breadth_m, draught_m, _CURVE_POINTS)
                if stacked is not None:
                    yield "two super-ellipses", (stacked,)
    yield "spline", tuple(fair_curve(points, breadth_m) for points in drawn)


def _measured(
    kind: Kind,
    contours: tuple[Array, ...],
    drawn: tuple[Array, ...],
    breadth_m: float,
    draught_m: float,
    ellipse: SectionFit | None = None,
) -> SectionModel:
    if len(contours) == len(drawn):
        deviation = max(largest_distance(one, other) for one, other in zip(contours, drawn, strict=True))
    else:
        deviation = largest_distance(np.concatenate(contours), np.concatenate(drawn))
    least = _LEAST_AREA * breadth_m * draught_m

    def area_error(height_m: float) -> float:
        true, found = (sum(area_below(points, height_m) for points in curves) for curves in (drawn, contours))
        return (found - true) / max(true, least)

    return SectionModel(kind, contours, deviation, area_error(draught_m), area_error(np.inf), ellipse)
