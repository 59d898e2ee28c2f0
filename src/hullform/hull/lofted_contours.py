"""From stations of any curve to polyline sections along the whole ship."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from hullform.errors import HullError
from hullform.hull.contours import Contours
from hullform.hull.correspondence import matched_points
from hullform.hull.drawn import FittedStation, outer_breadths, outer_heights, with_ends
from hullform.hull.fair_sections import fair_sections
from hullform.hull.profiled import (
    LIMIT,
    follow_between,
    follow_outside,
    has_come_together,
    stem_beyond,
    web_of,
)
from hullform.profile import Profile

Array = NDArray[np.float64]

# Points of a section from keel to deck, corners on top of them.
POINTS = 141
# Of the distance between lofted sections: one that comes nearer to a drawn station gives way to it.
_NEAREST = 0.4
# Of the length: a station so near an end that the two are one place.
_AT_END = 1e-4
# Of its depth: what is left of the last section, at the least, where its keel rises to the deck outside it.
_LEAST_DEPTH = 0.1


def places_with_stations(x: Array, drawn_x: Array) -> Array:
    """Places x of lofted sections with every drawn station within them among them; those too near to one left out."""
    margin = _AT_END * (x[-1] - x[0])
    inside = drawn_x[(drawn_x > x[0] + margin) & (drawn_x < x[-1] - margin)]
    spacing = np.gradient(x)
    apart = np.abs(x[:, None] - inside).min(axis=1, initial=np.inf)
    ends = np.isin(np.arange(len(x)), [0, len(x) - 1])
    return np.union1d(x[(apart > _NEAREST * spacing) | ends], inside)


def lofted_contours(
    stations: Sequence[FittedStation], x: Array, breadth_m: float, profile: Profile | None = None
) -> Contours:
    """Loft stations, of several at one x the mean, to the places x.

    Matched points (`correspondence`) follow cubics without overshoot between the drawn stations (`fair_sections`). A
    bulb or gondola apart from the body above it closes as half an ellipsoid where the next station has none, or where
    there is no next. Beyond the outermost stations the last section goes on, its breadth as the parabola through the
    greatest breadths of the last three has it, held to 0..its own and never growing outwards, its keel and deck in
    straight lines, by no more than their last drawn step and not quite to each other. A profile, where there is one,
    says where sections between and beyond the stations meet the centre plane (`profiled`).

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
    lofted = fair_sections(drawn_x, matched)(held)
    for number, beside in _lower_contours_that_end(matched):
        reach = np.abs(x - drawn_x[number])
        first, second = sorted((drawn_x[number], drawn_x[beside]))
        between = (x > first) & (x < second)
        lofted[between] = _closing(matched[number], lofted[between], reach[between])
    if profile is not None:
        for section, (aft, fore) in enumerate(itertools.pairwise(drawn_x.tolist())):
            inside = (x > aft) & (x < fore)
            if inside.any():
                ends = matched[section : section + 2]
                limit = LIMIT * breadth_m
                lofted[inside] = follow_between(profile, (aft, fore), ends, x[inside], lofted[inside], limit)
    widest, top, keel = matched[..., 0].max(axis=1), matched[:, -1, 1], matched[..., 1].min(axis=1)
    wide = with_ends(drawn_x, widest, x, outer_breadths)
    high, low = (with_ends(drawn_x, values, x, outer_heights) for values in (top, keel))
    for last, outside in ((matched[0], x < drawn_x[0]), (matched[-1], x > drawn_x[-1])):
        if outside.any():
            reach = np.abs(x - held)[outside]
            going_on = _going_on(last, wide[outside], high[outside], low[outside])
            lofted[outside] = _closing(last, going_on, reach)
    if profile is not None and profile.from_m <= drawn_x[0] and x[0] < drawn_x[0]:
        outside = x < drawn_x[0]
        lofted[outside] = follow_outside(profile, matched[0], x[outside], lofted[outside], None)
    if profile is not None and profile.to_m >= drawn_x[-1] and x[-1] > drawn_x[-1]:
        outside, stem = x > drawn_x[-1], stem_beyond(profile, drawn_x, matched)
        lofted[outside] = follow_outside(profile, matched[-1], x[outside], lofted[outside], stem)
    lofted[..., 0] = np.maximum(lofted[..., 0], 0.0)
    return Contours(lofted)


def _lower_points(section: Array) -> int:
    """How many points of a section (m, 2) make a lower contour of its own, a bulb or a gondola; 0 for none."""
    web = web_of(section)
    return 0 if web is None else web[0] + 1


def _lower_contours_that_end(matched: Array) -> list[tuple[int, int]]:
    """Of every lower contour that the section beside it has not: the numbers of its section and of that one."""
    found = []
    for number, section in enumerate(matched):
        lower = _lower_points(section)
        for beside in (number - 1, number + 1):
            if lower and 0 <= beside < len(matched) and has_come_together(matched[beside, :lower], section[:lower]):
                found.append((number, beside))
    return found


def _closing(last: Array, others: Array, reach: Array) -> Array:
    """Sections (k, m, 2) at distances (k,) from one (m, 2) whose lower contour, if it has one, closes among them.

    It closes as half an ellipsoid does, over a length of its own height or up to the farthest of them. Beyond its tip
    its points are where the rest of the section begins, so that nothing of it is left there.
    """
    lower = _lower_points(last)
    if not lower or not len(reach):
        return others
    y, z = last[:lower].T
    left = np.sqrt(np.maximum(1 - (reach / min(float(np.ptp(z)), float(reach.max()))) ** 2, 0.0))
    middle = (z.max() + z.min()) / 2
    tip = int(np.argmin(np.where(left > 0, np.inf, reach)))
    there = (left > 0) | (np.arange(len(reach)) == tip)
    closed = others.copy()
    closed[:, :lower, 0] = left[:, None] * y
    shrunk = middle + left[:, None] * (z - middle)
    closed[:, :lower, 1] = np.where(there[:, None], shrunk, others[:, lower : lower + 1, 1])
    return closed


def _going_on(last: Array, wide: Array, high: Array, low: Array) -> Array:
    """Sections (k, m, 2) outside the last one (m, 2), of given breadths and heights (k,)."""
    y, z = last.T
    deck, bottom = z[-1], z.min()
    low = np.minimum(low, high - _LEAST_DEPTH * (deck - bottom))
    breadths = (wide / max(float(y.max()), 1e-300))[:, None] * y
    heights = low[:, None] + ((high - low) / max(float(deck - bottom), 1e-300))[:, None] * (z - bottom)
    return np.stack([breadths, heights], axis=-1)


def _mean(outlines: Sequence[Array], breadth_m: float) -> Array:
    return np.asarray(matched_points(outlines, POINTS, breadth_m).mean(axis=0))
