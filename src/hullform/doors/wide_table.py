"""The wide table of offsets: half-breadths by waterline and station, as they stand on old lines plans."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator

from hullform.body_plan import TracedCurve
from hullform.doors.csv_rows import CsvTable
from hullform.doors.points import enough_points
from hullform.errors import BodyPlanError

FORMS = (
    "A table of offsets has one row a point (station_x_m, half_breadth_m, height_m), or is wide: its first cell is "
    "height_m and stations' x stand beside it in the header, or it is station_x_m and heights stand there"
)
# Of the whole height, which tables round to the millimetre: a waterline so near the base line, or a keel, lies on it.
_ON_BASE = 1e-4

# Points that the curve gets from one waterline to the next.
_BETWEEN = 6
# The rows, or columns, beside the waterlines: where the keel lies, and where the deck at side.
_HEIGHTS = ("keel_height_m", "deck_height_m")
_EXTRAS = ("keel_height_m", "deck_half_breadth_m", "deck_height_m")


@dataclass(frozen=True, eq=False)
class WideOffsets:
    """What a wide table has.

    Attributes:
        curves: (x in the table's unit, curve in m) of each station.
        notes: what was assumed.
    """

    curves: tuple[tuple[float, TracedCurve], ...]
    notes: tuple[str, ...]


def is_wide(table: CsvTable) -> bool:
    """Whether the header has a column of heights or of stations, and numbers beside it."""
    first, *rest = (cell.lower() for cell in table.rows[0][1])
    return first in ("height_m", "station_x_m") and any(_is_number(table, cell) for cell in rest)


def read_wide(table: CsvTable, metres: float, origin_z_m: float) -> WideOffsets:
    """Read half-breadths by waterline and station; an empty cell says that the station does not reach there.

    Heights below the keel may be empty or 0. Extra rows (or columns, where stations are rows) keel_height_m,
    deck_half_breadth_m and deck_height_m give the ends of the curves.

    Args:
        table: of which `is_wide` holds.
        metres: in the table's unit.
        origin_z_m: height of the table's zero above the base line.

    Raises:
        BodyPlanError: names the line and the cell.
    """
    header = table.rows[0][1]
    by_waterline = header[0].lower() == "height_m"
    across = [cell.lower() for cell in header[1:]]
    down = [cells[0].lower() for _, cells in table.rows[1:]]
    cells = _cells(table, len(across))
    lines = [line for line, _ in table.rows[1:]]
    if not by_waterline:
        # turned, so that rows are waterlines
        across, down, cells = down, across, [list(column) for column in zip(*cells, strict=True)]
    waterlines = [(name, i) for i, name in enumerate(down) if name not in _EXTRAS]
    extras = {name: i for i, name in enumerate(down) if name in _EXTRAS}
    if ("deck_height_m" in extras) != ("deck_half_breadth_m" in extras):
        raise BodyPlanError(f"{table.path}: deck_height_m and deck_half_breadth_m go together; give both or none")
    heights = np.array([_named(table, lines, name, i, by_waterline) for name, i in waterlines])
    if len(set(heights)) < len(heights):
        raise BodyPlanError(f"{table.path}: a height stands twice; give each waterline once")
    curves, open_below = [], []
    for column, name in enumerate(across):
        x = _named(table, lines, name, column, not by_waterline)
        breadths = np.array([cells[row][column] for _, row in waterlines])
        ends = {key: cells[row][column] for key, row in extras.items()}
        curve, closed = _curve(table, x, heights, breadths, ends, metres, origin_z_m)
        curves.append((x, curve))
        if not closed:
            open_below.append(f"{x:g}")
    if len({x for x, _ in curves}) < len(curves):
        raise BodyPlanError(f"{table.path}: a station stands twice; give each once")
    notes: tuple[str, ...] = ()
    if open_below:
        notes = (
            f"{table.path.name}: the lowest waterlines of stations {', '.join(open_below)} lie above the keel and off "
            "the centre line; the sections go straight on from there, to the centre line, the base line or the next "
            "waterline: give keel_height_m or lower waterlines where that is wrong",
        )
    return WideOffsets(tuple(curves), notes)


def _is_number(table: CsvTable, cell: str) -> bool:
    try:
        return math.isfinite(float(cell.replace(",", ".") if table.decimal_comma else cell))
    except ValueError:
        return False


def _named(table: CsvTable, lines: list[int], name: str, index: int, along_rows: bool) -> float:
    """The number that names a row or a column."""
    where = lines[index] if along_rows else table.rows[0][0]
    if not name:
        raise BodyPlanError(f"{table.path}, line {where}: a row or column has no height or station; name it")
    if not _is_number(table, name):
        raise BodyPlanError(
            f"{table.path}, line {where}: '{name}' is no number, nor one of {', '.join(_EXTRAS)}; heights and "
            "stations are lengths, not names"
        )
    return table.number(where, "1", name)


def _cells(table: CsvTable, columns: int) -> list[list[float]]:
    """Half-breadths, rows as in the file; nan where a cell is empty."""
    found = []
    are_breadths = [name.lower() not in _HEIGHTS for name in table.rows[0][1][1:]]
    for line, cells in table.rows[1:]:
        if len(cells) > columns + 1 and any(cells[columns + 1 :]):
            raise BodyPlanError(f"{table.path}, line {line}: has {len(cells)} cells, the header {columns + 1}")
        filled = (*cells[1 : columns + 1], *[""] * (columns + 1 - len(cells)))
        row = [
            table.number(line, str(column), cell) if cell and cell != "-" else math.nan
            for column, cell in enumerate(filled, start=2)
        ]
        breadths = [] if cells[0].lower() in _HEIGHTS else itertools.compress(row, are_breadths)
        if any(breadth < 0 for breadth in breadths):
            raise BodyPlanError(
                f"{table.path}, line {line}: has a half-breadth below 0; half-breadths are those of one side"
            )
        found.append(row)
    return found


def _curve(
    table: CsvTable,
    x: float,
    heights: np.ndarray,
    breadths: np.ndarray,
    ends: dict[str, float],
    metres: float,
    origin_z_m: float,
) -> tuple[TracedCurve, bool]:
    """One station, keel to deck, in m; and whether the table shows where it begins."""
    order = np.argsort(heights)
    known = order[np.isfinite(breadths[order])]
    z, y = heights[known], breadths[known]
    keel = ends.get("keel_height_m", math.nan)
    apart = _ON_BASE * float(np.ptp(heights))
    if math.isfinite(keel):
        # a waterline at the keel's height has the flat of bottom
        above, flat = z > keel + apart, y[(np.abs(z - keel) <= apart) & (y > 0)]
        _require_nothing(table, x, z[(z < keel - apart) & (y > 0)], "below keel_height_m", keel)
        z, y = np.concatenate([[keel], np.full(flat.size, keel), z[above]]), np.concatenate([[0.0], flat, y[above]])
    elif (y > 0).any():
        # of noughts below the keel only the last is hers
        first = max(int(np.argmax(y > 0)) - 1, 0)
        z, y = z[first:], y[first:]
    deck = ends.get("deck_height_m", math.nan), ends.get("deck_half_breadth_m", math.nan)
    if math.isfinite(deck[0]) and math.isfinite(deck[1]):
        below = z < deck[0] - apart
        _require_nothing(table, x, z[z > deck[0] + apart], "above deck_height_m", deck[0])
        z, y = np.append(z[below], deck[0]), np.append(y[below], deck[1])
    if z.size < 2:
        raise BodyPlanError(f"{table.path}: the station at {x:g} has {z.size} half-breadths; give two or more")
    if y[0] == 0:
        return _smooth(y, z, metres, origin_z_m), True
    base = -origin_z_m / metres
    if z[0] - base <= apart:
        # a flat of bottom
        return _smooth(np.append(0.0, y), np.append(z[0], z), metres, origin_z_m), True
    # straight on, but not below a waterline that she does not reach
    floor = float(heights[heights < z[0]].max(initial=base))
    lean = (y[1] - y[0]) / (z[1] - z[0])
    at_floor = y[0] - lean * (z[0] - floor)
    if at_floor > 0:
        z, y = np.concatenate([[floor, floor], z]), np.concatenate([[0.0, at_floor], y])
    else:
        z, y = np.append(z[0] - y[0] / lean, z), np.append(0.0, y)
    return _smooth(y, z, metres, origin_z_m), False


def _require_nothing(table: CsvTable, x: float, heights: np.ndarray, where: str, end: float) -> None:
    if heights.size:
        raise BodyPlanError(
            f"{table.path}: the station at {x:g} has a half-breadth at the height {heights[0]:g}, {where} = {end:g}; "
            "correct one of the two, or leave the cell empty"
        )


def _smooth(y: np.ndarray, z: np.ndarray, metres: float, origin_z_m: float) -> TracedCurve:
    """The curve through half-breadths at heights that rise, but for a level start: a monotone cubic (PCHIP) y(z)."""
    start = int(np.flatnonzero(z == z[0])[-1])
    if z.size - start > 2:
        steps = np.arange(1, _BETWEEN + 1) / _BETWEEN
        fine = (z[start:-1, None] + np.diff(z[start:])[:, None] * steps).ravel()
        between = PchipInterpolator(z[start:], y[start:])(fine)
        y, z = np.append(y[: start + 1], between), np.append(z[: start + 1], fine)
    points = enough_points(np.column_stack([y * metres, z * metres + origin_z_m]))
    return TracedCurve(points[:, 0], points[:, 1])
