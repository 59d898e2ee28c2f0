"""The profile of a ship as a table: x and z of the contour in the centre plane, from the stern's deck to the stem's."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from hullform.doors.csv_rows import read_csv
from hullform.errors import BodyPlanError
from hullform.profile import Profile
from hullform.ship import Particulars, Ship

COLUMNS = ("x_m", "z_m")
_KEY = "hull.profile"
# Of the length overall: a place outside the ship by less is rounding.
_OUTSIDE = 1e-3
# Of the depth: so far above it a bow with sheer ends, and so far below the base line a keel with rake.
_ABOVE, _BELOW = 1.0, 0.5


def read_profile(ship: Ship, path: Path) -> Profile:
    """Read a ship's profile; `docs/ship-file.md` says what it holds. Points from fore to aft are turned round.

    Raises:
        BodyPlanError: no such file or columns, a cell that is no number, a point outside the ship, a contour that
            crosses itself or ends where it began.
    """
    table, main = read_csv(path, _KEY), ship.particulars
    line, names = table.rows[0]
    header = [name.lower() for name in names]
    missing = [name for name in COLUMNS if name not in header]
    if missing:
        raise BodyPlanError(
            f"{path}, line {line}: has no column {', '.join(missing)}; it has {', '.join(header)}. A profile has x_m "
            "and z_m, a row a point, from the deck at the stern round the keel to the deck at the stem"
        )
    columns = [header.index(name) for name in COLUMNS]
    points = []
    for line, row in table.rows[1:]:
        cells = [row[column] if column < len(row) else "" for column in columns]
        x, z = (table.number(line, name, cell) for name, cell in zip(COLUMNS, cells, strict=True))
        _require_of_the_ship(f"{path}, line {line}", x, z, main)
        points.append((np.clip(x, 0.0, main.length_overall_m), z))
    contour = np.array(points)
    contour = contour[np.append(True, (np.diff(contour, axis=0) != 0).any(axis=1))]
    _require_simple(path, contour)
    if contour[0, 0] > contour[-1, 0]:
        contour = contour[::-1]
    return Profile(contour[:, 0], contour[:, 1])


def _require_of_the_ship(where: str, x: float, z: float, main: Particulars) -> None:
    length, depth = main.length_overall_m, main.depth_m
    if not -_OUTSIDE * length <= x <= (1 + _OUTSIDE) * length:
        raise BodyPlanError(
            f"{where}: x_m = {x:g} lies outside the ship, 0 to {length:g} m; x counts from the aft end of the length "
            "overall, forward, in metres"
        )
    if not -_BELOW * depth <= z <= (1 + _ABOVE) * depth:
        raise BodyPlanError(
            f"{where}: z_m = {z:g} is no height of a hull of {depth:g} m depth, {-_BELOW * depth:g} to "
            f"{(1 + _ABOVE) * depth:g} m; z counts from the base line, upwards, in metres"
        )


def _require_simple(path: Path, contour: np.ndarray) -> None:
    import shapely

    if len(contour) < 2 or contour[0, 0] == contour[-1, 0]:
        raise BodyPlanError(
            f"{path}: the profile begins and ends at x_m = {contour[0, 0]:g}; give its points in order from the "
            "deck at the stern round the keel to the deck at the stem, the deck itself left out"
        )
    drawn = shapely.LineString(contour)
    if drawn.is_simple:
        return
    pieces = shapely.node(drawn).geoms
    x, z = pieces[0].coords[-1]
    raise BodyPlanError(
        f"{path}: the profile crosses itself at x_m = {x:g}, z_m = {z:g}; give its points in order from the deck at "
        "the stern round the keel to the deck at the stem"
    )
