"""Pixels to metres: what ship.toml gives wins, the rest is found in the lines of the drawing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Calibration
from hullform.errors import PictureError
from hullform.picture.calibrating.axes import base_line, centre_line, convergence, mean_slope, side_px
from hullform.picture.calibrating.expected_lines import is_flat_of_bottom
from hullform.picture.calibrating.frame_lines import frame_lines
from hullform.picture.calibrating.scale import Grid, find_grid, outermost_half_breadth
from hullform.picture.calibrating.straight_line import StraightLine, crossing
from hullform.picture.image.homography import describe, fit_points, fit_without_outliers, similarity
from hullform.picture.image.ink import Ink
from hullform.ship_body_plan import CalibrationGiven

Array = NDArray[np.float64]

LARGEST_AFFINE_RESIDUAL_PX = 0.6  # of the crossings of a flat scan
FEWEST_LINES = 4  # of each family, for a homography
LARGEST_DISAGREEMENT = 0.01  # between scales, beyond which a person should look


@dataclass(frozen=True, eq=False)
class CalibratedSheet:
    """The calibration, and which of the long lines are lines of the drawing's frame (not of the ship).

    `grid_m` is the spacing of the buttocks and of the waterlines in metres, where a regular grid was found.
    """

    calibration: Calibration
    grid_m: tuple[float, float] | None
    frame_lines: tuple[StraightLine, ...]
    notes: tuple[str, ...]
    doubts: tuple[str, ...]


def calibrate(
    ink: Ink,
    horizontal: Sequence[StraightLine],
    vertical: Sequence[StraightLine],
    breadth_m: float,
    depth_m: float,
    given: CalibrationGiven | None = None,
    name: str = "the picture",
    draught_m: float | None = None,
) -> CalibratedSheet:
    """Find centre line, base line, rotation and scale; values that are given are taken as they are.

    Args:
        ink: (rows, columns) map of ink.
        horizontal, vertical: the long lines of the picture.
        breadth_m: moulded breadth: the outermost upright lines are its sides.
        depth_m: depth at side, to tell the base line from a waterline above it.
        given: [body_plan.calibration] of ship.toml.
        name: what to call the picture in an error.
        draught_m: where a design waterline may be drawn.

    Raises:
        PictureError: neither given nor found: centre line, base line or scale.
    """
    levels_m = [depth_m] if draught_m is None else [depth_m, draught_m]
    if given is not None and given.points:
        calibration = _from_points(given, name)
        return CalibratedSheet(
            calibration,
            None,
            frame_lines(ink, horizontal, vertical, calibration, breadth_m, levels_m),
            (f"calibration: {calibration.source}",),
            (),
        )
    skew = mean_slope(horizontal, vertical)
    if given is not None and given.rotation_deg is not None:
        skew = -float(np.tan(np.deg2rad(given.rotation_deg)))
    centre = centre_line(horizontal, vertical)
    u0 = given.centreline_px if given is not None else None
    v0 = given.baseline_px if given is not None else None
    scale = given.metres_per_px if given is not None else None
    if centre is None and u0 is None:
        raise PictureError(
            f"{name}: no centre line found ({len(vertical)} long vertical lines, none in the middle of "
            f"{len(horizontal)} long horizontal ones); give centreline_px in [body_plan.calibration]"
        )
    base = base_line(ink, horizontal, centre, u0, depth_m, breadth_m, skew)
    if base is None and v0 is None:
        raise PictureError(
            f"{name}: no base line found ({len(horizontal)} long horizontal lines); "
            "give baseline_px in [body_plan.calibration]"
        )
    found = crossing(centre, base) if centre is not None and base is not None else (u0 or 0.0, v0 or 0.0)
    if u0 is not None and base is not None:
        found = (u0, float(base.at(u0)))
    elif v0 is not None and centre is not None:
        found = (float(centre.at(v0)), v0)
    origin = (found[0] if u0 is None else u0, found[1] if v0 is None else v0)
    across, up, lean, lean_up = np.zeros(0), np.zeros(0), 0.0, 0.0
    if centre is not None and base is not None:
        across = np.array([crossing(line, base)[0] - origin[0] for line in vertical])
        up = np.array([origin[1] - crossing(centre, line)[1] for line in horizontal])
        lean, lean_up = convergence(up, horizontal), convergence(across, vertical)
    half_breadth_px = outermost_half_breadth(ink, origin, skew, lean=lean)
    if half_breadth_px is None and scale is None:
        raise PictureError(
            f"{name}: no ship's side found beside the centre line; give metres_per_px in [body_plan.calibration]"
        )
    rough = scale or breadth_m / 2 / (half_breadth_px or 1.0)
    levels = list(horizontal)
    if half_breadth_px is not None and up.size:
        flat = np.array([is_flat_of_bottom(line, ink, origin[0], half_breadth_px) for line in horizontal])
        levels, up = [line for line, hull in zip(horizontal, flat, strict=True) if not hull], up[~flat]
    # distances along base line and centre line as they were before a camera leaned
    grid = find_grid(across / (1 - lean * across), up / (1 - lean_up * up), rough, breadth_m, bool(lean or lean_up))
    anything_given = any(value is not None for value in (u0, v0, scale)) or (
        given is not None and given.rotation_deg is not None
    )
    words = [
        f"centre line {'given' if u0 is not None else 'found'}",
        f"base line {'given' if v0 is not None else 'found'}",
        "rotation given" if given is not None and given.rotation_deg is not None else "rotation of the long lines",
    ]
    doubts: list[str] = []
    if grid is not None and not anything_given:
        calibration = _from_grid(grid, levels, vertical, breadth_m, words)
    else:
        if scale is not None:
            words.append("scale given")
        elif grid is not None:
            scale = 0.5 * (grid.across_m / grid.across.spacing_px + grid.up_m / grid.up.spacing_px)
            words.append(f"scale of a grid of {grid.across_m:g} m by {grid.up_m:g} m")
        else:
            scale = (
                breadth_m
                / 2
                / side_px(ink, vertical, base, origin, skew, half_breadth_px or 0.0, 2 * depth_m / breadth_m)
            )
            words.append("no regular grid; scale of the breadth between the outermost lines")
        calibration = similarity(origin, scale, skew, 0.0, "; ".join(words))
    if half_breadth_px is not None:
        measured = half_breadth_px * calibration.metres_per_px
        # the outermost ink is a line's edge, up to three pixels beyond its axis
        if abs(measured / (breadth_m / 2) - 1) > LARGEST_DISAGREEMENT + 3 / half_breadth_px:
            doubts.append(
                f"scale: the outermost line lies {measured:.2f} m from the centre line, but B/2 is "
                f"{breadth_m / 2:.2f} m; check breadth_m and the calibration"
            )
    frame = frame_lines(ink, horizontal, vertical, calibration, breadth_m, levels_m, grid)
    grid_m = (grid.across_m, grid.up_m) if grid is not None else None
    return CalibratedSheet(calibration, grid_m, frame, (f"calibration: {calibration.source}",), tuple(doubts))


def _from_points(given: CalibrationGiven, name: str) -> Calibration:
    metres = np.array([point.m for point in given.points], dtype=np.float64)
    pixels = np.array([point.px for point in given.points], dtype=np.float64)
    try:
        if len(metres) < 2:
            raise np.linalg.LinAlgError("one point")
        with np.errstate(all="raise"):
            matrix, residual = fit_points(metres, pixels)
        if not np.isfinite(matrix).all() or abs(np.linalg.det(matrix)) < 1e-9:
            raise np.linalg.LinAlgError("degenerate")
    except (np.linalg.LinAlgError, ZeroDivisionError, FloatingPointError):
        raise PictureError(
            f"{name}: the {len(metres)} points of [body_plan.calibration] fix no scale; "
            "give two or more apart from each other, not all on one line"
        ) from None
    return describe(matrix, residual, f"{len(metres)} known points, residual {residual:.2f} px")


def _from_grid(
    grid: Grid,
    horizontal: Sequence[StraightLine],
    vertical: Sequence[StraightLine],
    breadth_m: float,
    words: list[str],
) -> Calibration:
    """The homography through the crossings of grid lines.

    The base line and the lines at B/2 are left out where there are others enough: the ship's flat of bottom and flat of
    side lie on them and pull them off their axes.
    """
    up = grid.up.multiples * grid.up_m
    across = grid.across.multiples * grid.across_m
    on_ship = np.abs(np.abs(across) - breadth_m / 2) < 0.01 * breadth_m
    rows, columns = grid.up.members & (up != 0), grid.across.members & ~on_ship
    rows = rows if rows.sum() >= FEWEST_LINES else grid.up.members
    columns = columns if columns.sum() >= FEWEST_LINES else grid.across.members
    metres = [(y, z) for z in up[rows] for y in across[columns]]
    pixels = [crossing(other, line) for line in _chosen(horizontal, rows) for other in _chosen(vertical, columns)]
    there, here = np.array(metres, dtype=np.float64), np.array(pixels, dtype=np.float64)
    matrix, residual, good = fit_without_outliers(there, here, perspective=False)
    if residual > LARGEST_AFFINE_RESIDUAL_PX:
        # a flat scan has no perspective, and fitting one would only turn pulled lines into a false scale
        tilted, residual_tilted, good_tilted = fit_without_outliers(there, here, perspective=True)
        if residual_tilted < 0.5 * residual:
            matrix, residual, good = tilted, residual_tilted, good_tilted
    words.append(
        f"grid of {grid.across_m:g} m by {grid.up_m:g} m, {int(good.sum())} crossings, residual {residual:.2f} px"
    )
    return describe(matrix, residual, "; ".join(words))


def _chosen(lines: Sequence[StraightLine], members: NDArray[np.bool_]) -> list[StraightLine]:
    return [line for line, member in zip(lines, members, strict=True) if member]
