"""Sections between and beyond the drawn stations that meet the centre plane where the profile has it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.errors import HullError
from hullform.hull.drawn import FittedStation
from hullform.profile import CentrePlane, Profile

Array = NDArray[np.float64]

# Of the breadth: a section that begins farther from the profile is left as it is drawn, and doubted.
LIMIT = 0.01
# Of the length, by which a profile may miss an end of the ship, and of the depth, by which it may miss the deck there.
_SHORT, _OFF_DECK = 0.005, 0.15
# Of the breadth: lofted sections stand where straight lines between them would leave the profile by more.
_STRAIGHT = 5e-4
# Of the length: no two of those places lie nearer to each other.
_NEAREST = 1e-4
# How fast the shift of a section's foot fades with height, as a power: deadwood that goes down is a strip below the
# hull, a bottom that rises takes the hull above it along.
_FADING_DOWN, _FADING_UP = 6.0, 2.0
_LEAST_HEIGHT = 1e-3  # of its own: what a section keeps whose foot would come up to its top
# Powers of the way to the stem by which waterlines close there: 1/2 a round end, 1 a wedge, more a hollow one.
_BLUNTEST, _HOLLOWEST = 0.5, 2.0
_ON_CENTRE = 1e-6  # of a section's half-breadth
_COLLAPSED = 1e-5  # of its extent: what is left of a contour that has come together in a point

Web = tuple[int, int]


def web_of(section: Array) -> Web | None:
    """Numbers of the points of a section (m, 2) between which it runs up the centre line to its upper contour.

    The first ends a bulb or a gondola, the second begins the body above. None for a section of one contour.
    """
    on = section[:, 0] <= _ON_CENTRE * section[:, 0].max()
    (runs,) = np.nonzero(on[1:-1] & on[:-2])
    if not len(runs) or runs[0] == 0:
        return None
    first = int(runs[0])
    off = np.flatnonzero(~on[first:])
    return first, first + int(off[0]) - 1 if len(off) else len(section) - 1


def has_come_together(lower: Array, of: Array) -> bool:
    """Whether points (k, 2) are one place, beside a contour (k, 2) that they answer to."""
    return bool(np.ptp(lower, axis=0).max() <= _COLLAPSED * np.ptp(of, axis=0).max())


def places_of(profile: Profile, breadth_m: float, length_m: float) -> Array:
    """Places along the ship between which the profile is straight, but for 0.05 % of the breadth."""
    points = np.column_stack([profile.x_m, profile.height_m])
    kept, open_spans = {0, len(points) - 1}, [(0, len(points) - 1)]
    while open_spans:  # Douglas and Peucker, The Canadian Cartographer 10, 1973
        first, last = open_spans.pop()
        if last - first < 2:
            continue
        run = points[last] - points[first]
        way = points[first + 1 : last] - points[first]
        off = np.hypot(*way.T) if not run.any() else np.abs(way @ [run[1], -run[0]]) / np.hypot(*run)
        if off.max() > _STRAIGHT * breadth_m:
            middle = first + 1 + int(off.argmax())
            kept.add(middle)
            open_spans += [(first, middle), (middle, last)]
    apart: list[float] = []
    for x in np.unique(profile.x_m[sorted(kept)]).tolist():
        if not apart or x - apart[-1] >= _NEAREST * length_m:
            apart.append(x)
    return np.array(apart)


def require_whole(profile: Profile, stations: Sequence[FittedStation], length_m: float, depth_m: float) -> None:
    """Refuse a profile that is not the whole contour: the hull would end where it ends, or lose a bulb.

    Raises:
        HullError: it misses an end of the ship, or the deck there; it has no bulb where a station has; the bulb reaches
            beyond the stem.
    """
    if profile.from_m > _SHORT * length_m or profile.to_m < (1 - _SHORT) * length_m:
        raise HullError(
            f"[hull] profile reaches from x = {profile.from_m:g} to {profile.to_m:g} m, the ship from 0 to "
            f"{length_m:g} m; give it from the deck at the stern to the deck at the stem, or correct length_overall_m"
        )
    ordered = sorted(stations, key=lambda station: station.x_m)
    for name, n in (("stern", 0), ("stem", -1)):
        height, deck = float(profile.height_m[n]), float(ordered[n].contours[-1][-1, 1])
        if abs(height - deck) > _OFF_DECK * depth_m:
            raise HullError(
                f"[hull] profile ends at z = {height:g} m at the {name}, and the deck of station {ordered[n].name} "
                f"lies at {deck:g} m; give the profile up to the deck, without bulwark and forecastle"
            )
    for station in ordered:
        sides = [profile.at(np.array([station.x_m]), side) for side in (-1.0, 1.0)]
        if len(station.contours) > 1 and all(np.isnan(plane.stem[0]) for plane in sides):
            raise HullError(
                f"station {station.name} (x = {station.x_m:g} m) has a contour below the hull, a bulb or a gondola, "
                "and [hull] profile crosses it but once or twice; draw the profile round it"
            )
    for inside, station, end in ((1.0, ordered[0], profile.from_m), (-1.0, ordered[-1], profile.to_m)):
        plane = profile.at(np.array([end]), inside)
        if len(station.contours) > 1 and np.isfinite(plane.head[0]) and np.isnan(plane.stem[0]):
            raise HullError(
                f"[hull] profile has the bulb beyond the stem, to x = {end:g} m, which is not lofted from a profile: "
                "leave the key out"
            )


def doubts_of_feet(profile: Profile, stations: Sequence[FittedStation], breadth_m: float) -> tuple[str, ...]:
    """A doubt for every drawn station that begins off the profile by more than 1 % of the breadth."""
    doubts = []
    for station in stations:
        sides = [float(profile.at(np.array([station.x_m]), side).foot[0]) for side in (-1.0, 1.0)]
        drawn = float(station.contours[0][0, 1])
        off = min((height - drawn for height in sides), key=abs)
        if station.model is not None and abs(off) > LIMIT * breadth_m:
            doubts.append(
                f"station {station.name} ({station.half} half, x = {station.x_m:g} m) is drawn from "
                f"z = {drawn:.2f} m, and the profile there is at {drawn + off:.2f} m, limit {LIMIT * breadth_m:.2f} m "
                "apart; the station was kept: check the profile, or the station's x"
            )
    return tuple(doubts)


def follow_between(
    profile: Profile, ends_x: tuple[float, float], ends: Array, x: Array, lofted: Array, limit_m: float
) -> Array:
    """Sections (k, m, 2) at x (k,) between two drawn ones (2, m, 2), shifted near the centre plane to meet the profile.

    Heights of every section are mapped by one function that increases, so that none crosses itself: half-breadths and
    what lies above the feet of both drawn sections stay. Between two that have a lower contour, both of its ends and
    the foot of the upper one are met; one that the next section has not closes in proportion to its height.
    """
    share = (x - ends_x[0]) / (ends_x[1] - ends_x[0])
    wanted = profile.at(x)
    beside = [profile.at(np.array([place]), side) for place, side in zip(ends_x, (1.0, -1.0), strict=True)]
    webs = [web_of(section) for section in ends]
    result = lofted.copy()

    def met(heights: Array, at_ends: Sequence[float], drawn: Sequence[float]) -> Array:
        """Heights of the profile, and the little by which the drawn sections are off it."""
        off = np.array(drawn) - at_ends
        off[~(np.abs(off) <= limit_m)] = 0.0
        return np.asarray(heights + (1 - share) * off[0] + share * off[1])

    web = webs[0] or webs[1]
    one_closes = web is not None and any(
        other is None and has_come_together(section[: web[0] + 1], of[: web[0] + 1])
        for other, section, of in zip(webs, ends, ends[::-1], strict=True)
    )
    if web is None or not (one_closes or all(webs)):
        foot = met(wanted.foot, [float(plane.foot[0]) for plane in beside], ends[:, 0, 1].tolist())
        result[..., 1] = _with_foot(lofted[..., 1], foot, float(ends[:, 0, 1].max()))
        return result
    first, last = web
    stem = met(_upper_foot(wanted), [float(_upper_foot(plane)[0]) for plane in beside], ends[:, last, 1].tolist())
    result[:, last:, 1] = _with_foot(lofted[:, last:, 1], stem, float(ends[:, last, 1].max()))
    if one_closes:
        whole = ends[0 if webs[0] else 1, : first + 1]
        return _closing(whole, result, lofted, web, wanted.foot, np.where(np.isnan(wanted.stem), np.nan, wanted.head))
    foot = met(wanted.foot, [float(plane.foot[0]) for plane in beside], ends[:, 0, 1].tolist())
    head = met(wanted.head, [float(plane.head[0]) for plane in beside], ends[:, first, 1].tolist())
    head = np.minimum(head, result[:, last, 1])
    has_both = np.isfinite(head) & np.isfinite(wanted.stem) & (head > foot)
    z = lofted[:, : first + 1, 1]
    grown = np.divide(head - foot, z[:, -1] - z[:, 0], out=np.ones_like(head), where=z[:, -1] > z[:, 0])
    result[:, : first + 1, 1] = foot[:, None] + grown[:, None] * (z - z[:, :1])
    result = _with_web(result, lofted, web)
    return np.asarray(np.where(has_both[:, None, None], result, lofted))


def follow_outside(
    profile: Profile, last: Array, x: Array, going_on: Array, closes_to: tuple[float, float, float] | None
) -> Array:
    """Sections (k, m, 2) at x (k,) outside the last one (m, 2), their feet and tops where the profile has them.

    going_on: as they are without a profile. closes_to: where waterlines come together at a stem, x of the last section
    and of the stem, and by which power of the way to it; at a stern breadths stay those of `going_on`.
    """
    wanted = profile.at(x)
    web = web_of(last)
    first, start = (0, 0) if web is None else web
    foot = np.where(np.isnan(wanted.stem) | (start == 0), wanted.foot, wanted.stem)
    there = np.isfinite(foot)
    y, z = last[start:].T
    top = going_on[:, -1, 1]
    if start == 0:
        # a stem or a transom that leans inwards ends the section below the deck
        top = np.where(np.isfinite(wanted.head) & np.isnan(wanted.stem), np.minimum(top, wanted.head), top)
    foot = np.where(there, foot, top)
    low = np.minimum(foot, top - _LEAST_HEIGHT * (z[-1] - z[0]))
    result = going_on.copy()
    result[:, start:, 1] = low[:, None] + ((top - low) / max(z[-1] - z[0], 1e-300))[:, None] * (z - z[0])
    if closes_to is not None:
        from_m, to_m, power = closes_to
        left = np.clip((to_m - x) / (to_m - from_m), 0.0, 1.0) ** power
        result[:, start:, 0] = left[:, None] * y
    result[~there, :, 0] = 0.0
    if web is None:
        return result
    return _closing(
        last[: first + 1], result, going_on, web, wanted.foot, np.where(np.isnan(wanted.stem), np.nan, wanted.head)
    )


def stem_beyond(profile: Profile, ends_x: Array, sections: Array) -> tuple[float, float, float]:
    """How waterlines close from the last of sections (n, m, 2) at ends_x (n,) to a stem that the profile has.

    By a power of the way to the stem that goes on as the greatest half-breadths of the last three do.
    """
    widest, web = sections[-3:, :, 0].max(axis=1), web_of(sections[-1])
    foot = sections[-1, 0 if web is None else web[1], 1]
    end = max(float(profile.x_m[profile.height_m >= foot].max(initial=-np.inf)), float(profile.x_m[-1]))
    slope = float(np.polynomial.Polynomial.fit(ends_x[-3:], widest, 2).deriv()(ends_x[-1]))
    length = max(end - float(ends_x[-1]), 1e-9)
    power = -slope * length / max(float(widest[-1]), 1e-300)
    return float(ends_x[-1]), float(ends_x[-1]) + length, float(np.clip(power, _BLUNTEST, _HOLLOWEST))


def _upper_foot(plane: CentrePlane) -> Array:
    return np.asarray(np.where(np.isnan(plane.stem), plane.foot, plane.stem))


def _with_foot(z: Array, foot: Array, free_from_m: float) -> Array:
    """Heights (k, m), the first of each at a foot (k,), those above both feet and a height where they were.

    What the foot is shifted by fades upwards; heights keep their order.
    """
    now, top = z[:, 0], z[:, -1]
    shift = np.where(np.isnan(foot), 0.0, np.minimum(foot, top - _LEAST_HEIGHT * (top - now)) - now)
    least = np.where(shift > 0, _FADING_UP * shift, -shift / 2)
    reach = np.minimum(np.maximum(free_from_m - now, least), top - now)
    reach = np.maximum(reach, 1e-300)
    share = np.clip(1 - (z - now[:, None]) / reach[:, None], 0.0, 1.0)
    # rising by d with the power n keeps the order while n d is no more than the reach
    power = np.where(shift < 0, _FADING_DOWN, np.clip(reach / np.maximum(shift, 1e-300), 1.0, _FADING_UP))
    return np.asarray(z + shift[:, None] * share ** power[:, None])


def _closing(whole: Array, sections: Array, before: Array, web: Web, foot: Array, head: Array) -> Array:
    """Sections whose lower contour is a drawn one (k, 2) grown or shrunk to reach from foot to head; NaN: none left.

    An ellipsoid has sections that are alike. Where none is left its points are where the upper contour begins.
    """
    first, last = web
    y, z = whole[: first + 1].T
    left = np.where(np.isnan(head), 0.0, np.maximum(head - foot, 0.0) / (z[-1] - z[0]))
    middle = np.where(left > 0, (foot + head) / 2, np.nan)
    # the first section without any has its tip
    tip = np.full(len(left), np.nan)
    tip[1:] = middle[:-1]
    tip[:-1] = np.where(np.isnan(tip[:-1]), middle[1:], tip[:-1])
    middle = np.where(left > 0, middle, tip)
    begin = sections[:, last, 1]
    heights = middle[:, None] + left[:, None] * (z - (z[0] + z[-1]) / 2)
    closed = sections.copy()
    closed[:, : first + 1, 0] = left[:, None] * y
    closed[:, : first + 1, 1] = np.fmin(heights, begin[:, None])
    return _with_web(closed, before, web)


def _with_web(sections: Array, before: Array, web: Web) -> Array:
    """Sections with the points between two contours spread up the centre line as they were before."""
    first, last = web
    z = before[:, first : last + 1, 1]
    rise = z[:, -1:] - z[:, :1]
    share = np.divide(z - z[:, :1], rise, out=np.zeros_like(z), where=rise > 0)
    result = sections.copy()
    low, high = sections[:, first, None, 1], sections[:, last, None, 1]
    result[:, first:last, 1] = (low + share * (high - low))[:, :-1]
    return result
