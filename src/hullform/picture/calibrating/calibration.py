"""Pixels to metres: what ship.toml gives wins, the rest is found in the lines of the drawing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Calibration
from hullform.errors import PictureError
from hullform.picture.calibrating.expected_lines import drawn_alike, expected_lines, is_flat_of_bottom
from hullform.picture.calibrating.scale import Comb, Grid, find_grid, outermost_half_breadth
from hullform.picture.calibrating.straight_line import StraightLine, crossing
from hullform.picture.image.homography import describe, fit_points, fit_without_outliers, similarity
from hullform.picture.image.ink import Ink
from hullform.ship_body_plan import CalibrationGiven

Array = NDArray[np.float64]

OFF_CENTRE = 0.06  # of the horizontal lines' length: how far the centre line may lie from their middle
WHOLE_LINE = 0.75  # of the longest horizontal line: shorter ones may belong to one half
BOTH_SIDES = 0.35  # of a horizontal line's length that must lie on either side of the centre line
PAST_CENTRE = 0.05  # of the centre line's length: how far below its end the base line may lie, where a gap ends it
LARGEST_AFFINE_RESIDUAL_PX = 0.6  # of the crossings of a flat scan
FEWEST_LINES = 4  # of each family, for a homography
LEAST_CONVERGENCE = 0.0008  # change of slope over a family: less is how lines are pulled by curves on them
ON_LEVEL_PX = 3.0  # of a waterline from where the grid has one
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
            _frame(ink, horizontal, vertical, calibration, breadth_m, levels_m),
            (f"calibration: {calibration.source}",),
            (),
        )
    skew = _mean_slope(horizontal, vertical)
    if given is not None and given.rotation_deg is not None:
        skew = -float(np.tan(np.deg2rad(given.rotation_deg)))
    centre = _centre_line(horizontal, vertical)
    u0 = given.centreline_px if given is not None else None
    v0 = given.baseline_px if given is not None else None
    scale = given.metres_per_px if given is not None else None
    if centre is None and u0 is None:
        raise PictureError(
            f"{name}: no centre line found ({len(vertical)} long vertical lines, none in the middle of "
            f"{len(horizontal)} long horizontal ones); give centreline_px in [body_plan.calibration]"
        )
    base = _base_line(ink, horizontal, centre, u0, depth_m, breadth_m, skew)
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
        lean, lean_up = _convergence(up, horizontal), _convergence(across, vertical)
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
                / _side_px(ink, vertical, base, origin, skew, half_breadth_px or 0.0, 2 * depth_m / breadth_m)
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
    frame = _frame(ink, horizontal, vertical, calibration, breadth_m, levels_m, grid)
    grid_m = (grid.across_m, grid.up_m) if grid is not None else None
    return CalibratedSheet(calibration, grid_m, frame, (f"calibration: {calibration.source}",), tuple(doubts))


def _convergence(places: Array, lines: Sequence[StraightLine]) -> float:
    """Change of a family's slopes per px, the median over pairs of lines; 0 where it is too small to matter.

    With u = k y / (1 + p y + r z) and v likewise, horizontal lines have the slopes p z and vertical ones r y, while
    k y = d / (1 - d p / k) at a distance d along the base line: p / k is the change of the horizontal lines' slopes.
    """
    if len(lines) < FEWEST_LINES:
        return 0.0
    slopes = np.array([line.slope for line in lines])
    first, second = np.triu_indices(len(lines), 1)
    apart = places[second] - places[first]
    far = np.abs(apart) > 0.2 * np.ptp(places)
    change = float(np.median((slopes[second] - slopes[first])[far] / apart[far]))
    return change if abs(change) * np.ptp(places) > LEAST_CONVERGENCE else 0.0


def _mean_slope(horizontal: Sequence[StraightLine], vertical: Sequence[StraightLine]) -> float:
    """dv/du of the horizontal family, from both families: median, so that a straight ship's side does no harm."""
    slopes = [line.slope for line in horizontal] + [-line.slope for line in vertical]
    return float(np.median(slopes)) if slopes else 0.0


def _centre_line(horizontal: Sequence[StraightLine], vertical: Sequence[StraightLine]) -> StraightLine | None:
    if not vertical:
        return None
    if horizontal:
        # flat bottoms are level lines too, but end at the centre line
        longest = max(line.length for line in horizontal)
        whole = [line for line in horizontal if line.length > WHOLE_LINE * longest]
        middle = float(np.median([(line.start + line.end) / 2 for line in whole]))
        breadth = float(np.median([line.length for line in whole]))
        v = float(np.median([line.at(middle) for line in horizontal]))
    else:
        v = float(np.mean([(line.start + line.end) / 2 for line in vertical]))
        ends = [float(line.at(v)) for line in vertical]
        middle, breadth = (min(ends) + max(ends)) / 2, max(ends) - min(ends)
    near = [line for line in vertical if abs(float(line.at(v)) - middle) < OFF_CENTRE * breadth]
    return min(near, key=lambda line: abs(float(line.at(v)) - middle) / (1 + line.weight), default=None)


def _base_line(
    ink: Ink,
    horizontal: Sequence[StraightLine],
    centre: StraightLine | None,
    u0: float | None,
    depth_m: float,
    breadth_m: float,
    skew: float,
) -> StraightLine | None:
    """The lowest bold line of those with a whole depth of drawing above them; the lowest line where none is bold.

    The centre line reaches it: the border of a sheet or of its title block lies lower.
    """
    wide = []
    for line in horizontal:
        u = float(crossing(centre, line)[0]) if centre is not None else float(u0 or 0.0)
        if min(u - line.start, line.end - u) >= BOTH_SIDES * line.length:
            wide.append((line, u))
    if centre is not None:
        foot = centre.end + PAST_CENTRE * centre.length
        wide = [(line, u) for line, u in wide if float(line.at(u)) < foot] or wide
    if not wide:
        return None
    lowest, u = max(wide, key=lambda pair: float(pair[0].at(pair[1])))
    half_breadth = outermost_half_breadth(ink, (u, float(lowest.at(u))), skew)
    if half_breadth is not None:
        wide = [(line, u) for line, u in wide if line is lowest or not is_flat_of_bottom(line, ink, u, half_breadth)]
    drawn = np.flatnonzero((ink > 0.25).any(axis=1))
    if half_breadth is None or drawn.size == 0:
        return lowest
    depth_px = depth_m * half_breadth / (breadth_m / 2)
    deep = [line for line, u in wide if float(line.at(u)) - drawn[0] >= 0.97 * depth_px]
    boldest = max((line.weight for line in deep), default=0.0)
    bold = [line for line in deep if line.weight > 0.6 * boldest]
    return max(bold, key=lambda line: float(line.at(u)), default=lowest)


def _side_px(
    ink: Ink,
    vertical: Sequence[StraightLine],
    base: StraightLine | None,
    origin: tuple[float, float],
    skew: float,
    rough_px: float,
    depth: float,
) -> float:
    """B/2 in px without a grid: from upright lines on both sides near the rough one, else the side's own axis."""
    near = []
    for sign in (-1, 1):
        distances = [
            sign * ((crossing(line, base)[0] if base else float(line.at(origin[1]))) - origin[0]) for line in vertical
        ]
        # of two that lie side by side the inner one is a station
        near += sorted(d for d in distances if abs(d - rough_px) < 6)[-1:]
    if near:
        return float(np.mean(near))
    # axis of the outermost upright ink: the centroid of the outermost run of each row, its outer twentieth
    # up to the depth, in parts of B/2: above it stand numbers
    z = np.arange(0.02, depth, 0.002) * rough_px
    reach = np.arange(-12, 6.01, 0.25)
    axes = []
    for sign in (-1, 1):
        across = sign * (rough_px + reach)
        u = (origin[0] + across[None] + z[:, None] * skew).astype(np.float32)
        v = (origin[1] + across[None] * skew - z[:, None]).astype(np.float32)
        section = np.asarray(cv2.remap(ink, u, v, cv2.INTER_LINEAR), dtype=np.float64)
        outer = np.cumsum(section[:, ::-1] > 0.25, axis=1)[:, ::-1]
        section *= (outer > 0) & (outer <= 20)
        seen = section.max(axis=1) > 0.5
        if seen.sum() >= 5:
            centroid = (section[seen] @ reach) / section[seen].sum(axis=1)
            axes.append(rough_px + float(np.percentile(centroid, 95)))
    return max(axes, default=rough_px)


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


def _frame(
    ink: Ink,
    horizontal: Sequence[StraightLine],
    vertical: Sequence[StraightLine],
    calibration: Calibration,
    breadth_m: float,
    levels_m: Sequence[float],
    grid: Grid | None = None,
) -> tuple[StraightLine, ...]:
    """Lines that are no part of a station: horizontals across both halves, verticals that reach the base line."""
    scale, u0, v0 = calibration.metres_per_px, calibration.centreline_px, calibration.baseline_px
    half_breadth_px = breadth_m / 2 / scale
    heights, buttocks = np.array(levels_m), np.array([-breadth_m / 2, breadth_m / 2])
    if grid is not None:
        heights = np.append(heights, _teeth(grid.up) * grid.up_m)
        buttocks = np.append(buttocks, _teeth(grid.across, both_sides=True) * grid.across_m)
    vertical = [*vertical, *expected_lines(ink, calibration, buttocks.tolist(), vertical, vertical=True)]
    hull = [
        line
        for line in horizontal
        if abs(v0 - float(line.at(u0))) > ON_LEVEL_PX and is_flat_of_bottom(line, ink, u0, half_breadth_px)
    ]
    expected = expected_lines(ink, calibration, heights.tolist(), horizontal, vertical=False)
    horizontal = [*(line for line in horizontal if line not in hull), *expected]
    if grid is not None:
        on_grid = [line for line in horizontal if _on_tooth(v0 - float(line.at(u0)), grid)]
        horizontal = [line for line in horizontal if line not in on_grid]
        horizontal += drawn_alike(on_grid, ink, u0, half_breadth_px)
    frame = [line for line in horizontal if min(u0 - line.start, line.end - u0) > 0.7 * half_breadth_px]
    frame += [
        line for line in vertical if line.end > v0 - 0.02 * half_breadth_px or _is_side(line, u0, v0, half_breadth_px)
    ]
    return tuple(frame)


def _on_tooth(height_px: float, grid: Grid) -> bool:
    """Whether a height is that of a waterline of the grid, the base line left aside."""
    tooth = round(height_px / grid.up.spacing_px)
    return tooth != 0 and abs(height_px - tooth * grid.up.spacing_px) < ON_LEVEL_PX


def _teeth(comb: Comb, both_sides: bool = False) -> Array:
    """All multiples between the outermost members of a comb; of one about the centre line, alike on both sides."""
    members = comb.multiples[comb.members]
    if both_sides:
        members = np.concatenate([members, -members])
    return np.arange(int(members.min()), int(members.max()) + 1).astype(np.float64)


def _is_side(line: StraightLine, u0: float, v0: float, half_breadth_px: float) -> bool:
    """On B/2: the flat of side or the box line, which a station follows to the deck anyway."""
    return abs(abs(float(line.at(v0)) - u0) - half_breadth_px) < 0.006 * half_breadth_px
