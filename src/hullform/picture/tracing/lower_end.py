"""The lower end of a traced curve: on to the keel, the base line or the centre line.

Near a straight line of the drawing a curve cannot be seen; there it is continued by a parabola through its last
visible stretch, which meets the line or touches it.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.line_mask import Mask
from hullform.picture.image.ink import Ink
from hullform.picture.pieces.ends import LEAST_FLAT, LEAST_TURN, Ends, begins_on_level_line, end_fit
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.tracing.smoothing import Trace

Array = NDArray[np.float64]

STRETCH = 0.05  # of B/2: the visible stretch that a continuation follows
FARTHEST = 0.15  # of B/2: no continuation is longer, but along the line that it touched
NEAR_AXIS = 0.06  # of B/2: an end within this of the centre line or the base line belongs on it
NEAR_KEEL = 0.012  # of B/2: a start within this of the keel point is the keel point
BILGE = 0.08  # of B/2: columns over which a bilge turns up from a flat
FAINTEST_BESIDE = 0.25  # ink that a curve shows beside the centre line which hides its axis
LEAST_RISE = 1.5  # line widths above the base line, from which on ink is not that line's
DRAWN = 0.9  # of the way to the keel that is inked, where a curve goes that way
LARGEST_BREAK_BESIDE = 0.012  # of B/2: in that ink, where another line crosses


def lower_end(
    y: Array, z: Array, frame: DiagonalFrame, ink: Ink | None = None, width_px: float = 0.0
) -> tuple[Array, Array]:
    """(y, z) in px of the drawing of a curve with its lower end, where that lies near the base line or centre line.

    Args:
        y, z: the curve as seen, from its lower end.
        frame: of its half.
        ink: (rows, columns) of the frame, which tells how far a curve is still to be seen; None for a contour that
            is closed by its own turn.
        width_px: thickness of a curve's line.
    """
    size = frame.half_breadth_px
    if z[0] < -NEAR_KEEL * size:
        return _on_centre_below(y, z, size)
    if min(y[0], z[0]) > NEAR_AXIS * size:
        return y, z
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    part = arc <= STRETCH * size
    near = y[part], z[part]
    if z[0] <= y[0]:
        clear = z[0] > 2 * LEAST_RISE * width_px  # half of the way to the keel can be looked at
        fans = ink is not None and clear and _drawn_to_keel(y[0], z[0], frame, ink, width_px)
        added_y, added_z = (np.zeros(1), np.zeros(1)) if fans else _down_to_base_line(*near, size)
    elif near[0][-1] - y[0] > near[1][-1] - z[0]:
        added_y, added_z = _level_to_centre_line(*near)
    else:
        added_y, added_z = _down_along_centre_line(*near, frame, ink, width_px)
    y, z = np.concatenate([added_y, y]), np.concatenate([added_z, z])
    if np.hypot(y[0], z[0]) < NEAR_KEEL * size:
        y[0] = z[0] = 0.0
    return np.maximum(y, 0.0), np.maximum(z, 0.0)


def _drawn_to_keel(y: float, z: float, frame: DiagonalFrame, ink: Ink, width_px: float) -> bool:
    """Whether there is ink all along the straight way to the keel, as far as it can be told from the base line.

    Bottoms with a rise of floor come together in a fan there, in whose ink no curve is seen alone; a curve that turns
    into a flat of bottom leaves the paper white above it.
    """
    share = np.linspace(LEAST_RISE * width_px / z, 1.0, max(2, int(y / 2)))
    column, row = frame.from_drawing(share * y, share * z)
    along = cv2.remap(ink, column.astype(np.float32), row.astype(np.float32), cv2.INTER_LINEAR)
    return bool((along > FAINTEST_BESIDE).mean() > DRAWN)


def _down_to_base_line(y: Array, z: Array, size: float) -> tuple[Array, Array]:
    """What leads to the keel before a curve that nears the base line: it meets or touches it, and runs along it."""
    along, across = _continued(y, z, 0.0, FARTHEST * size)
    inside = along > 0
    added_y, added_z = along[inside], np.maximum(across[inside], 0.0)
    if inside.all():  # reached the base line before the centre line: a flat of bottom
        return np.append(0.0, added_y), np.append(0.0, added_z)
    if not inside.any() or added_y[0] > 0:
        height = float(np.interp(0.0, along, across)) if len(along) > 1 else 0.0
        return np.append(0.0, added_y), np.append(max(height, 0.0), added_z)
    return added_y, added_z


def _level_to_centre_line(y: Array, z: Array) -> tuple[Array, Array]:
    """The same of one that nears the centre line flatter than 45 degrees: its height follows from the half-breadth."""
    fit = np.polynomial.polynomial.polyfit(y, z, 2 if len(y) >= 12 else 1)
    added = np.linspace(0.0, y[0], max(2, int(y[0] / 3) + 2))[:-1]
    step = z[0] - float(np.polynomial.polynomial.polyval(y[0], fit))
    return added, np.maximum(np.polynomial.polynomial.polyval(added, fit) + step, 0.0)


def _down_along_centre_line(
    y: Array, z: Array, frame: DiagonalFrame, ink: Ink | None, width_px: float
) -> tuple[Array, Array]:
    """The same of one that nears the centre line steeply: it goes on as far as ink beside that line shows it."""
    size = frame.half_breadth_px
    along, across = _continued(z, y, 0.0, FARTHEST * size)
    shown = across >= 0 if ink is None else _shown(across, along, frame, ink, width_px)
    first = _seen_down_to(along, shown, LARGEST_BREAK_BESIDE * size)
    along, across = along[first:], across[first:]
    inside = along > 0
    added_y, added_z = np.maximum(across[inside], 0.0), along[inside]
    if first > 0:  # it ends in the ink of the centre line, higher than its direction says
        height = float(added_z[0]) if added_z.size else float(z[0])
        return np.append(0.0, added_y), np.append(height, added_z)
    if not inside.all():
        return np.append(0.0, added_y), np.append(0.0, added_z)
    return added_y, added_z


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


def along_level_line(y: Array, z: Array, trace: Trace, hidden: Mask, size: float) -> tuple[Array, Array]:
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
