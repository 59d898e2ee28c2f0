"""From drawn stations to sections along the whole ship: a model for each, the halves merged, the ends extrapolated."""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import BodyPlan
from hullform.errors import HullError
from hullform.hull.drawn import (
    Extrapolation,
    FittedStation,
    doubts_of_gaps,
    extrapolated_spans,
    fit_stations,
    lofted_super_ellipses,
    merge_halves,
    station_places,
)
from hullform.hull.ladder import Choice
from hullform.hull.lofted_contours import lofted_contours, places_with_stations
from hullform.hull.profiled import doubts_of_feet, places_of, require_whole
from hullform.hull.sections import SectionSet
from hullform.hull.turning_back import doubts_of_turning_back

Array = NDArray[np.float64]


class Particulars(Protocol):
    """What a hull takes from the ship's particulars; all in m."""

    @property
    def length_overall_m(self) -> float: ...
    @property
    def length_between_perpendiculars_m(self) -> float: ...
    @property
    def aft_perpendicular_m(self) -> float: ...
    @property
    def breadth_m(self) -> float: ...
    @property
    def depth_m(self) -> float: ...
    @property
    def draught_m(self) -> float: ...


class LoftedStations(NamedTuple):
    """Sections at places x_m (n,) in m, the fits that they come of, spans beyond the drawn stations, and doubts."""

    x_m: Array
    sections: SectionSet
    fits: tuple[FittedStation, ...]
    extrapolated: tuple[Extrapolation, ...]
    doubts: tuple[str, ...]


def loft_stations(body_plan: BodyPlan, particulars: Particulars, stations: int, sections: Choice) -> LoftedStations:
    """Model the drawn stations and loft about `stations` sections over the length overall; raises HullError.

    Each station gets the first model of a ladder that is near enough (`ladder`), or the one that `sections` asks
    for. A ship without a profile whose stations all are super-ellipses is lofted by their parameters; any other by
    matched points of her sections (`Contours`), the drawn stations among the places. Sections stand closer together at
    the ends (`drawn.station_places`). A station drawn on both halves counts once, as the mean; the halves' disagreement
    beyond a pen's width becomes a doubt. Outside the outermost drawn stations the form is extrapolated, and
    `extrapolated` says where.
    """
    length, breadth = float(particulars.length_overall_m), float(particulars.breadth_m)
    if stations < 3:
        raise HullError(f"a hull needs three or more lofted sections; {stations} asked for")
    for station in body_plan.stations:
        if not -1e-6 * length <= station.x_m <= (1 + 1e-6) * length:
            raise HullError(
                f"station {station.name} ({station.half} half) is at x = {station.x_m:g} m, outside the length "
                f"overall 0..{length:g} m; x counts from the aft end of the length overall, forward"
            )
    fits = fit_stations(body_plan, breadth, float(particulars.draught_m), sections)
    merged, disagreements = merge_halves(fits, breadth)
    drawn_x = np.array([station.x_m for station in merged])
    x = station_places(length, stations)
    profile = body_plan.profile
    lofted: SectionSet
    if profile is None and all(station.model is None or station.fit is not None for station in fits):
        lofted = lofted_super_ellipses(merged, x)
        for values in lofted:
            values.setflags(write=False)
    else:
        if profile is not None:
            require_whole(profile, fits, length, float(particulars.depth_m))
            x = places_with_stations(x, places_of(profile, breadth, length))
        x = places_with_stations(x, drawn_x)
        lofted = lofted_contours(fits, x, breadth, profile)
    extrapolated, guesses = extrapolated_spans(drawn_x, length)
    if profile is not None:
        disagreements += doubts_of_feet(profile, fits, breadth)
    guesses += doubts_of_gaps(body_plan, length)
    doubts = disagreements + guesses + doubts_of_turning_back(body_plan, fits, breadth / 2)
    return LoftedStations(x, lofted, fits, extrapolated, doubts)
