"""Stations that a super-ellipse was asked for and cannot follow: two contours, bulbs, tunnels."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from hullform.body_plan import BodyPlan, Station
from hullform.hull.drawn import FittedStation

# Of B/2: a curve that comes back towards the centre line, or sinks, by less is fair.
_TURN = 0.02

# Of B/2: a section that misses its station by less is a fair likeness.
_LARGEST_MISS = 0.03


def turns_back(station: Station, half_breadth_m: float) -> bool:
    """Whether a station has two contours, or one that comes back towards the centre line or sinks before it ends."""
    if len(station.curves) > 1:
        return True
    for values in (station.curves[0].half_breadth_m, station.curves[0].height_m):
        if float(np.max(np.maximum.accumulate(values) - values)) > _TURN * half_breadth_m:
            return True
    return False


def doubts_of_turning_back(
    body_plan: BodyPlan, fitted: Sequence[FittedStation], half_breadth_m: float
) -> tuple[str, ...]:
    """One doubt that names the stations whose contours a section of one super-ellipse cannot follow, or none.

    Args:
        body_plan: the drawn stations.
        fitted: of each of them, in the same order.
        half_breadth_m: B/2.
    """
    missed = [
        (station, fit.fit)
        for station, fit in zip(body_plan.stations, fitted, strict=True)
        if fit.fit is not None
        and fit.fit.largest_deviation_m > _LARGEST_MISS * half_breadth_m
        and turns_back(station, half_breadth_m)
    ]
    if not missed:
        return ()
    names = ", ".join(station.name for station, _ in missed)
    miss = max(fit.largest_deviation_m for _, fit in missed)
    area = max((fit.area_error for _, fit in missed), key=abs)
    return (
        f"stations {names} m have a bulb, a tunnel or two contours, which one super-ellipse cannot follow: it misses "
        f"them by up to {miss:.2f} m, limit {_LARGEST_MISS * half_breadth_m:.2f} m, and their area by {area:+.0%}; "
        "the hull is approximate there: set [hull] sections to 'auto'",
    )
