"""A table of offsets as a body plan: one row a point, or half-breadths by waterline and station."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import BodyPlan, Half, Station, TracedCurve
from hullform.doors.csv_rows import CsvTable, read_csv
from hullform.doors.points import enough_points
from hullform.doors.wide_table import FORMS, is_wide, read_wide
from hullform.errors import BodyPlanError
from hullform.ship import Particulars, Ship
from hullform.ship_body_plan import METRES_PER, OffsetsSource

Array = NDArray[np.float64]

REQUIRED = ("station_x_m", "half_breadth_m", "height_m")
# Of B/2, by which moulded offsets may lie beyond it without a word: plating, or a pen.
_BROADER = 0.02
# Of the ship's size: a table that is larger or smaller by more is in another unit.
_OTHER_UNIT = 3.0
# Of the breadth: what is smaller may be the rounding of points, or a bow that runs out in a sliver.
_ROUNDING = 1e-3
# Of the breadth: a table sliced from a surface may run to and fro by so much where a stem closes.
_GLITCH = 0.01
# Cosine of a turn of 155 degrees: the sharpest knuckle of a chine or a bulwark is far from it.
_BACK = -0.9


class _Point(NamedTuple):
    half_breadth_m: float
    height_m: float
    confidence: float
    order: float


def read_offsets(ship: Ship, source: OffsetsSource) -> BodyPlan:
    """Read a ship's table of offsets; `docs/ship-file.md` has its two forms.

    Args:
        ship: whose particulars the table is held against.
        source: [body_plan] of her ship.toml.

    Raises:
        BodyPlanError: no such file, no such columns, a cell that is no number, stations outside the ship.
    """
    table = read_csv(source.file)
    scale, main = METRES_PER[source.unit], ship.particulars
    midships = main.aft_perpendicular_m + main.length_between_perpendiculars_m / 2
    by_station: dict[tuple[float, Half], tuple[TracedCurve, ...]] = {}
    notes: tuple[str, ...] = ()
    if is_wide(table):
        wide = read_wide(table, scale, source.origin_z_m)
        notes = wide.notes
        for x, curve in wide.curves:
            place = _place(x, scale, source)
            by_station[place, _half_of(place, midships)] = (curve,)
    else:
        by_station = _curves_of_points(table, source, scale, midships, main.breadth_m)
    _require_within(table.path, source, [x for x, _ in by_station], main)
    stations = tuple(Station(x, half, curves) for (x, half), curves in by_station.items())
    doubts = _doubts_of_size(table.path, stations, main)
    try:
        return BodyPlan(
            stations, "offsets", notes=(f"{len(stations)} stations of {table.path.name}", *notes), doubts=doubts
        )
    except BodyPlanError as error:
        raise BodyPlanError(f"{table.path}: {error}") from None


def _place(x: float, scale: float, source: OffsetsSource) -> float:
    return round(x * scale + source.origin_x_m, 6)


def _half_of(x_m: float, midships_m: float) -> Half:
    return "aft" if x_m < midships_m else "fore"


def _curves_of_points(
    table: CsvTable, source: OffsetsSource, scale: float, midships_m: float, breadth_m: float
) -> dict[tuple[float, Half], tuple[TracedCurve, ...]]:
    """The long form: the points of every curve of every station, keel to deck or deck to keel."""
    header = [name.lower() for name in table.rows[0][1]]
    missing = [name for name in REQUIRED if name not in header]
    if missing:
        raise BodyPlanError(
            f"{table.path}, line {table.rows[0][0]}: has no column {', '.join(missing)}; it has {', '.join(header)}. "
            f"{FORMS}"
        )
    points: dict[tuple[float, Half], dict[int, list[_Point]]] = {}
    for order, (line, cells) in enumerate(table.rows[1:]):
        if len(cells) < len(header):
            raise BodyPlanError(
                f"{table.path}, line {line}: has {len(cells)} cells, the header {len(header)}; fill it up"
            )
        row = dict(zip(header, cells, strict=False))

        def value(name: str, default: float, row: dict[str, str] = row, line: int = line) -> float:
            return table.number(line, name, row[name]) if row.get(name) else default

        for name in REQUIRED:
            if not row[name]:
                raise BodyPlanError(f"{table.path}, line {line}: {name} is empty; give it or remove the row")
        x, y, z = (table.number(line, name, row[name]) for name in REQUIRED)
        if y < 0:
            raise BodyPlanError(
                f"{table.path}, line {line}: half_breadth_m = {y:g} is negative; half-breadths are those of one side"
            )
        place = _place(x, scale, source)
        half = row.get("half") or _half_of(place, midships_m)
        if half not in ("aft", "fore"):
            raise BodyPlanError(f"{table.path}, line {line}: half = '{half}'; it is aft or fore")
        number = value("curve", 0.0)
        if number != round(number):
            raise BodyPlanError(f"{table.path}, line {line}: curve = {number:g}; curves are numbered 0, 1, 2")
        curves = points.setdefault((place, "aft" if half == "aft" else "fore"), {})
        curves.setdefault(int(number), []).append(
            _Point(y * scale, z * scale + source.origin_z_m, value("confidence", 1.0), value("point", float(order)))
        )
    return {
        station: tuple(_curve(table.path, station[0], curves[n], breadth_m) for n in sorted(curves))
        for station, curves in points.items()
    }


def _curve(path: Path, x_m: float, points: Sequence[_Point], breadth_m: float) -> TracedCurve:
    ordered = sorted(points, key=lambda point: point.order)
    if len(ordered) < 2:
        raise BodyPlanError(f"{path}: the station at x = {x_m:g} m has a curve of one point; give two or more")
    for point in ordered:
        if not 0 <= point.confidence <= 1:
            raise BodyPlanError(f"{path}: confidence = {point.confidence:g} at x = {x_m:g} m; it is from 0 to 1")
    line = np.array([[point.half_breadth_m, point.height_m] for point in ordered])
    if float(np.trapezoid(line[:, 0], line[:, 1])) < 0:
        line = line[::-1]  # from deck to keel
    _require_order(path, x_m, line, breadth_m)
    line = enough_points(line)
    return TracedCurve(line[:, 0], line[:, 1], min(point.confidence for point in ordered))


def _require_order(path: Path, x_m: float, line: Array, breadth_m: float) -> None:
    """No section crosses itself or turns back the way it came, but for what rounding does: points out of order do."""
    import shapely

    drawn = shapely.LineString(line)
    rounded = drawn.simplify(_ROUNDING * breadth_m, preserve_topology=False)
    corners = np.asarray(rounded.coords)
    step = np.diff(corners, axis=0)
    size = np.hypot(*step.T)
    ways = step / np.maximum(size, 1e-300)[:, None]
    long = np.minimum(size[1:], size[:-1]) > _GLITCH * breadth_m
    back = np.flatnonzero(long & ((ways[1:] * ways[:-1]).sum(axis=1) < _BACK))
    if back.size or not (drawn.is_simple or rounded.is_simple):
        y, z = corners[int(back[0]) + 1] if back.size else corners[0]
        what = f"turns back at y = {y:g} m, z = {z:g} m" if back.size else "crosses itself"
        raise BodyPlanError(
            f"{path}: the curve of the station at x = {x_m:g} m {what}; give its points in order from keel to deck, or "
            "number them in a column named point"
        )


def _require_within(path: Path, source: OffsetsSource, places_m: Sequence[float], main: Particulars) -> None:
    length = main.length_overall_m
    first, last = min(places_m), max(places_m)
    if first >= -1e-6 * length and last <= (1 + 1e-6) * length:
        return
    if last - first > _OTHER_UNIT * length:
        remedy = f'lengths are taken for {source.unit}: write unit = "mm" (or "cm", "ft", "in") in [body_plan]'
    elif last - first <= (1 + 1e-6) * length:
        remedy = (
            "x runs from the aft end of the length overall: write the x of the table's zero there as origin_x_m in "
            f"[body_plan], as origin_x_m = {main.aft_perpendicular_m:g} where it counts from the aft perpendicular"
        )
    else:
        remedy = "correct length_overall_m or the stations; they are places in metres, not numbers of stations"
    raise BodyPlanError(
        f"{path}: its stations lie from x = {first:g} to {last:g} m, the ship from 0 to {length:g} m; {remedy}"
    )


def _doubts_of_size(path: Path, stations: Sequence[Station], main: Particulars) -> tuple[str, ...]:
    """Doubt a table that is broader than the ship; refuse one that is of another size altogether."""
    broadest = max(float(curve.half_breadth_m.max()) for station in stations for curve in station.curves)
    half = main.breadth_m / 2
    if not half / _OTHER_UNIT < broadest < _OTHER_UNIT * half:
        raise BodyPlanError(
            f"{path}: its greatest half-breadth is {broadest:g} m, and half the breadth of the ship {half:g} m; write "
            'unit = "mm" (or "cm", "ft", "in") in [body_plan], or correct breadth_m'
        )
    if abs(broadest / half - 1) <= _BROADER:
        return ()
    return (
        f"{path.name}: its greatest half-breadth is {broadest:.4g} m, {100 * (broadest / half - 1):+.1f} % off half "
        f"of breadth_m, limit {100 * _BROADER:g} %; check both",
    )
