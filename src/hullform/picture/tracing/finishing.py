"""A traced curve made whole: down to the keel, the base line or the centre line; its upper end is in `upper_ends`.

Near a straight line of the drawing a curve cannot be seen; there it is continued by a parabola through its last
visible stretch, which meets the line or touches it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.line_mask import Mask
from hullform.picture.image.ink import Ink
from hullform.picture.pieces.ends import LEAST_FLAT, LEAST_TURN, Ends, begins_on_level_line, end_fit
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.sheer import SheerLine
from hullform.picture.tracing.smoothing import WEIGHT_OF_SHARED, Trace
from hullform.picture.tracing.upper_ends import FARTHEST, STRETCH, own_top, with_upper_end
from hullform.picture.tracing.winding import closed

Array = NDArray[np.float64]
Shows = Callable[[Array, Array], NDArray[np.bool_]]

NEAR_AXIS = 0.06  # of B/2: an end within this of the centre line or the base line belongs on it
NEAR_KEEL = 0.012  # of B/2: a start within this of the keel point is the keel point
BILGE = 0.08  # of B/2: columns over which a bilge turns up from a flat
FAINTEST_BESIDE = 0.25  # ink that a curve shows beside the centre line which hides its axis
LARGEST_BREAK_BESIDE = 0.012  # of B/2: in that ink, where another line crosses


def finish(
    trace: Trace,
    frame: DiagonalFrame,
    ink: Ink,
    hidden: Mask,
    sheer: SheerLine | None,
    depth_px: float | None,
    side_top_px: float | None = None,
    side_steps_px: Sequence[float] = (),
    width_px: float = 0.0,
) -> tuple[Array, Array]:
    """(y, z) of the whole curve in px of the drawing, from keel to deck.

    Args:
        trace: the curve on the columns of the frame.
        frame: of its half.
        ink, hidden: (rows, columns) of the frame, and where lines of the drawing were taken off.
        sheer: of its half, or None.
        depth_px: height of a level deck line, or None where none is drawn.
        side_top_px: height to which the line of B/2 is drawn, for curves that join it, or None.
        side_steps_px: heights at which curves like this one end on that line, ascending.
        width_px: thickness of a curve's line.
    """
    column, row = _visible_part(trace, frame)
    y, z = frame.to_drawing(column, row)
    size = frame.half_breadth_px
    if side_top_px is not None:
        side_top_px = own_top(y, z, size, side_top_px, side_steps_px)
    y, z = _lower_end(y, z, size, lambda y, z: _shown(y, z, frame, ink, width_px))
    y, z = _along_level_line(y, z, trace, hidden, size)
    return with_upper_end(y, z, trace, frame, ink, hidden, sheer, depth_px, side_top_px)


def finish_contour(trace: Trace, frame: DiagonalFrame) -> tuple[Array, Array]:
    """(y, z) of a contour that comes back to the centre line, in px of the drawing, from its lower end."""
    y, z = _lower_end(*frame.to_drawing(trace.column, trace.row), frame.half_breadth_px, lambda y, _: y >= 0)
    return closed(y, z, frame.half_breadth_px)


def _visible_part(trace: Trace, frame: DiagonalFrame) -> tuple[Array, Array]:
    """Cut a merged ribbon off the foot where the curve stands alone close to the axis: continuing it is better."""
    alone = np.flatnonzero(trace.weight > WEIGHT_OF_SHARED)
    if alone.size >= 40:
        y, z = frame.to_drawing(trace.column[alone[0]], trace.row[alone[0]])
        if min(float(y), float(z)) < NEAR_AXIS / 2 * frame.half_breadth_px:
            return trace.column[alone[0] :], trace.row[alone[0] :]
    return trace.column, trace.row


def _continued(t: Array, n: Array, level: float, farthest: float) -> tuple[Array, Array]:
    """Continue n(t) before its first point to n = level, by a parabola that meets the level or touches it.

    Args:
        t: positions along, increasing away from the end.
        n: distances across.
        level: where the curve shall end.
        farthest: longest continuation along t.

    Returns:
        t and n of the added points, the farthest first.
    """
    if t[-1] - t[0] < 2.0:
        return np.array([t[0]]), np.array([level])
    start = t[0]
    fit = np.polynomial.polynomial.polyfit(t - start, n - level, 2 if len(t) >= 12 else 1)
    fit[0] = n[0] - level
    if len(fit) == 3 and abs(fit[2]) > 1e-9:
        discriminant = fit[1] ** 2 - 4 * fit[2] * fit[0]
        ends = (
            [(-fit[1] + sign * np.sqrt(discriminant)) / (2 * fit[2]) for sign in (-1, 1)]
            if discriminant >= 0
            else [-fit[1] / (2 * fit[2])]
        )
        before = [end for end in ends if end <= 0]
        end = max(before) if before else 0.0
    else:
        end = -fit[0] / fit[1] if abs(fit[1]) > 1e-9 else 0.0
    end = float(np.clip(end, -farthest, 0.0))
    s = np.linspace(end, 0.0, max(2, int(abs(end) / 3) + 2))[:-1]
    values = level + np.polynomial.polynomial.polyval(s, fit)
    values[0] = level
    return np.asarray(start + s), np.asarray(values)


def _shown(y: Array, z: Array, frame: DiagonalFrame, ink: Ink, width_px: float) -> NDArray[np.bool_]:
    """Whether ink beside the centre line shows a curve whose axis lies at (y, z), hidden by that line.

    A curve that runs into the centre line at a small angle makes it thicker on this side, less and less.
    """
    outboard = y[:, None] + np.linspace(0.0, width_px / 2, 5)
    column, row = frame.from_drawing(outboard, np.broadcast_to(z[:, None], outboard.shape))
    beside = cv2.remap(ink, column.astype(np.float32), row.astype(np.float32), cv2.INTER_LINEAR)
    return np.asarray(beside.max(axis=1) > FAINTEST_BESIDE)


def _seen_down_to(z: Array, shown: NDArray[np.bool_], largest_break: float) -> int:
    """From which point on a continuation, whose last point is where the curve was seen, still shows without a break."""
    lowest, first = z[-1], len(z)
    for index in range(len(z) - 1, -1, -1):
        if shown[index]:
            lowest, first = z[index], index
        elif lowest - z[index] > largest_break:
            return first
    return 0


def _lower_end(y: Array, z: Array, size: float, shows: Shows) -> tuple[Array, Array]:
    reach = NEAR_AXIS * size
    if z[0] < -NEAR_KEEL * size:
        return _on_centre_below(y, z, size)
    if min(y[0], z[0]) > reach:
        return y, z
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    part = arc <= STRETCH * size
    if z[0] <= y[0]:
        along, across = _continued(y[part], z[part], 0.0, FARTHEST * size)
        inside = along > 0
        added_y, added_z = along[inside], np.maximum(across[inside], 0.0)
        if inside.all():  # reached the base line before the centre line: a flat of bottom
            added_y, added_z = np.append(0.0, added_y), np.append(0.0, added_z)
        elif not inside.any() or added_y[0] > 0:
            height = float(np.interp(0.0, along, across)) if len(along) > 1 else 0.0
            added_y, added_z = np.append(0.0, added_y), np.append(max(height, 0.0), added_z)
    elif y[part][-1] - y[0] > z[part][-1] - z[0]:
        # flatter than 45 degrees: the height follows from the half-breadth
        fit = np.polynomial.polynomial.polyfit(y[part], z[part], 2 if part.sum() >= 12 else 1)
        added_y = np.linspace(0.0, y[0], max(2, int(y[0] / 3) + 2))[:-1]
        step = z[0] - float(np.polynomial.polynomial.polyval(y[0], fit))
        added_z = np.maximum(np.polynomial.polynomial.polyval(added_y, fit) + step, 0.0)
    else:
        along, across = _continued(z[part], y[part], 0.0, FARTHEST * size)
        first = _seen_down_to(along, shows(across, along), LARGEST_BREAK_BESIDE * size)
        along, across = along[first:], across[first:]
        inside = along > 0
        added_y, added_z = np.maximum(across[inside], 0.0), along[inside]
        if first > 0:  # it ends in the ink of the centre line, higher than its direction says
            height = float(added_z[0]) if added_z.size else float(z[0])
            added_y, added_z = np.append(0.0, added_y), np.append(height, added_z)
        elif not inside.all():
            added_y, added_z = np.append(0.0, added_y), np.append(0.0, added_z)
    y, z = np.concatenate([added_y, y]), np.concatenate([added_z, z])
    if np.hypot(y[0], z[0]) < NEAR_KEEL * size:
        y[0] = z[0] = 0.0
    return np.maximum(y, 0.0), np.maximum(z, 0.0)


def _along_level_line(y: Array, z: Array, trace: Trace, hidden: Mask, size: float) -> tuple[Array, Array]:
    """A curve that begins level on a waterline lies on that line from the centre line on."""
    if min(y[0], z[0]) <= NEAR_AXIS * size or y[0] < LEAST_FLAT * size:
        return y, z
    row, slope = end_fit(trace.column, trace.row, last=False)
    beyond = trace.column < trace.column[0] + BILGE * size
    if slope - end_fit(trace.column[beyond], trace.row[beyond], last=True)[1] < LEAST_TURN:
        return y, z
    if not begins_on_level_line(Ends(trace.column[:1], np.array([row]), np.array([slope])), hidden)[0]:
        return y, z
    return np.append(0.0, y), np.append(z[0], z)


def _on_centre_below(y: Array, z: Array, size: float) -> tuple[Array, Array]:
    """A contour that begins below the base line begins on the centre line there, level."""
    if y[0] > NEAR_AXIS * size:
        return y, z
    return np.append(0.0, np.maximum(y, 0.0)), np.append(z[0], z)
