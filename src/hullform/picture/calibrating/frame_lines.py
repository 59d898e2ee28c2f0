"""Lines of the drawing's frame, which are no part of a station: grid, deck and water lines, border."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Calibration
from hullform.picture.calibrating.expected_lines import drawn_alike, expected_lines, is_flat_of_bottom
from hullform.picture.calibrating.scale import Comb, Grid
from hullform.picture.calibrating.straight_line import StraightLine
from hullform.picture.image.ink import Ink

Array = NDArray[np.float64]

ON_LEVEL_PX = 3.0  # of a waterline from where the grid has one


def frame_lines(
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
