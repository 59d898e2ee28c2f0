"""Whether the stations as named make a ship: fair waterlines along her, and the displacement that ship.toml gives.

A curve more or less than stations are listed shifts all names between it and the parallel body. Every curve still
looks right, but the waterlines get a kink where the shift begins and where it ends. So the waterlines are faired as
named, and again as they would be named with a station more or less at each place, and with the halves swapped; where
one of these makes them much fairer, that is probably what is wrong.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Half, Station, TracedCurve
from hullform.picture.naming.fair_lines import MUCH_FAIRER, beside_fair_lines, unfairness
from hullform.ship import Particulars, Water

Array = NDArray[np.float64]
Names = Mapping[Half, Sequence[Sequence[float]]]  # of each curve of a half, from the centre line outwards

LEVELS = (0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 1.0)  # of the draught: the waterlines
LEAST_GAIN = 0.001  # of B/2, mean: less is the noise of tracing
BETWEEN = (0.3, 0.5, 0.7)  # of a spacing: where a station that is not listed may lie
FEWEST_CURVES = 4  # of a half
OUTER_QUARTER, NEAR_END = 0.25, 0.1  # of LOA: where the decks are compared, and what stations must come near to
WIDER_FORE = 0.05  # of B/2: of a dozen hulls of others and eight families drawn none is wider fore by more than 0.01
DISPLACEMENT_LIMIT = (
    0.03  # trapezoids over the stations miss up to 0.7 % on fifteen hulls; shell and appendages add as much
)


def crosscheck(stations: Sequence[Station], particulars: Particulars, water: Water) -> list[str]:
    """What the stations together say of their names and their scale.

    Args:
        stations: of both halves, in metres.
        particulars: of the ship.
        water: that she floats in.

    Returns:
        doubts.
    """
    return [
        *_doubts_of_names(stations, particulars),
        *_doubts_of_ends(stations, particulars),
        *_doubts_of_displacement(stations, particulars, water),
    ]


def _doubts_of_names(stations: Sequence[Station], particulars: Particulars) -> list[str]:
    levels_m = np.array(LEVELS) * particulars.draught_m
    curves: dict[Half, Array] = {}
    names: dict[Half, list[list[float]]] = {}
    halves: tuple[Half, Half] = ("aft", "fore")
    for half in halves:
        ordered = sorted((s for s in stations if s.half == half), key=lambda s: s.x_m if half == "aft" else -s.x_m)
        drawn: list[TracedCurve] = []
        names[half] = []
        for station in ordered:
            if not drawn or station.curves[0] is not drawn[-1]:
                drawn.append(station.curves[0])
                names[half].append([])
            names[half][-1].append(station.x_m)
        rows = [
            half_breadths(curve.half_breadth_m, curve.height_m, levels_m) / (particulars.breadth_m / 2)
            for curve in drawn
        ]
        curves[half] = np.array(rows).reshape(len(rows), len(levels_m))
    as_named = _unfairness(names, curves)
    other = [(_unfairness(naming, seen), words) for naming, seen, words in _other_namings(names, curves)]
    if not other:
        return []
    fairest, words = min(other, key=lambda pair: pair[0])
    if fairest > MUCH_FAIRER * as_named or as_named - fairest < LEAST_GAIN:
        return []
    return [
        f"waterlines: as named, the stations lie {100 * as_named:.2f} % of B/2 beside fair lines on average; "
        f"{100 * fairest:.2f} % {words}"
    ]


def _other_namings(
    names: dict[Half, list[list[float]]], curves: dict[Half, Array]
) -> Iterator[tuple[Names, Mapping[Half, Array], str]]:
    """Namings of the same curves that are wrong by one, or in both halves, with what each would mean."""
    for half, groups in names.items():
        listed = [x for group in groups for x in group]
        if len(groups) < FEWEST_CURVES or any(len(group) > 1 for group in groups[:-1]):
            continue
        for k in range(len(groups) - 1):
            inner, outer = listed[k], listed[k + 1]
            for share in BETWEEN:
                more = [*listed[: k + 1], inner + share * (outer - inner), *listed[k + 1 :]]
                yield (
                    {**names, half: _named(more, len(groups))},
                    curves,
                    f"if one more station lay between {min(inner, outer):g} and {max(inner, outer):g} m ({half} half), "
                    f"which {half}_stations_m would miss: check the list, or mark points of the stations there",
                )
            fewer = [*listed[:k], *listed[k + 1 :]]
            if len(fewer) >= len(groups):
                yield (
                    {**names, half: _named(fewer, len(groups))},
                    curves,
                    f"if station {inner:g} m ({half} half) had no curve of its own: check {half}_stations_m, or mark "
                    "points of the stations there",
                )
    aft, fore = ([x for group in names[half] for x in group] for half in ("aft", "fore"))
    if len(aft) >= len(names["fore"]) >= FEWEST_CURVES and len(fore) >= len(names["aft"]) >= FEWEST_CURVES:
        yield (
            {"aft": _named(aft, len(names["fore"])), "fore": _named(fore, len(names["aft"]))},
            {"aft": curves["fore"], "fore": curves["aft"]},
            "with the halves swapped: check aft_side and whether the picture is mirrored",
        )


def _named(listed: list[float], curves: int) -> list[list[float]]:
    """One name a curve, the rest to the outermost."""
    return [*([x] for x in listed[: curves - 1]), listed[curves - 1 :]]


def _unfairness(names: Names, curves: Mapping[Half, Array]) -> float:
    """Mean distance of half-breadths, in parts of B/2, from fair lines along the ship."""
    x = np.array([x for half in names for group in names[half] for x in group])
    y = np.concatenate([np.repeat(curves[half], [len(group) for group in names[half]], axis=0) for half in names])
    x, first = np.unique(x, return_index=True)
    y = y[first]
    if len(x) < 2 * FEWEST_CURVES:
        return 0.0
    return unfairness(beside_fair_lines(x, y))


def half_breadths(half_breadth: Array, height: Array, levels: Array) -> Array:
    """Half-breadths of a curve, keel to deck, at levels; NaN below it: a waterline ends there with a kink by right."""
    rising = np.maximum.accumulate(height)
    y = np.interp(levels, rising, half_breadth)
    return np.asarray(np.where((levels <= rising[0]) | (y <= 0), np.nan, y))


def _doubts_of_ends(stations: Sequence[Station], particulars: Particulars) -> list[str]:
    """The deck of a ship is at least as wide over her aft quarter as over her fore one: sterns carry, stems part."""
    length, half_breadth = particulars.length_overall_m, particulars.breadth_m / 2
    x, first = np.unique([station.x_m for station in stations], return_index=True)
    y = np.array([float(stations[n].curves[-1].half_breadth_m[-1]) for n in first]) / half_breadth
    nearest = max(float(x[0]), length - float(x[-1]), 0.0)
    if nearest > NEAR_END * length:
        return []
    away = np.linspace(nearest, OUTER_QUARTER * length, 20)
    aft, fore = float(np.interp(away, x, y).mean()), float(np.interp(length - away, x, y).mean())
    if fore - aft <= WIDER_FORE:
        return []
    return [
        f"aft_side: over her fore quarter the deck has {100 * fore:.0f} % of the breadth on average, over her aft "
        f"quarter {100 * aft:.0f} %; ships are wider aft: check aft_side and whether the picture is mirrored; "
        "lcb_from_midships_m, where it is given, shows it too"
    ]


def _doubts_of_displacement(stations: Sequence[Station], particulars: Particulars, water: Water) -> list[str]:
    """The volume between the stations against the displacement or the block coefficient that is given."""
    box_m3 = particulars.length_between_perpendiculars_m * particulars.breadth_m * particulars.draught_m
    if particulars.displacement_t is not None:
        given_m3, key = (
            1e3 * particulars.displacement_t / water.density_kg_m3,
            f"displacement_t = {particulars.displacement_t:g}",
        )
    elif particulars.block_coefficient is not None:
        given_m3 = particulars.block_coefficient * box_m3
        key = f"block_coefficient = {particulars.block_coefficient:g}"
    else:
        return []
    x = np.array([station.x_m for station in stations])
    areas = np.array([station.area_below(particulars.draught_m) for station in stations])
    x, first = np.unique(x, return_index=True)
    read_m3 = float(np.trapezoid(areas[first], x))
    if abs(read_m3 / given_m3 - 1) <= DISPLACEMENT_LIMIT:
        return []
    return [
        f"displacement: the stations enclose {read_m3:.0f} m3 up to the draught, block coefficient "
        f"{read_m3 / box_m3:.3f}; {key} means {given_m3:.0f} m3, {given_m3 / box_m3:.3f}: check the calibration in the "
        "overlay, draught_m and the station lists"
    ]
