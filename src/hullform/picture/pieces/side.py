"""The ship's side: how high it is drawn where many stations run up the line of B/2 together.

There the sheet often has a box line or a grid line too, which goes on above the deck. A station covers that line with
a thicker one, so the side ends where the ink across the line falls back to what the line has by itself.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.image.ink import Ink
from hullform.picture.pieces.frame import DiagonalFrame

Array = NDArray[np.float64]

FOOT = 0.04  # of B/2: so near the base line no station has reached the line of B/2
REACH_PX = 3.5  # to either side of the line
REACH_INBOARD_PX = 12.0
LEAST_INK = 0.25  # of what touches the line
STEP_PX = 0.5
SHARE_OF_STATION = 0.5  # of the way from the line's own thickness to a station's: more ink is a station
CLEARLY_THICKER = 1.8  # a station than the line by itself; else the whole line is taken for the side
SHORTEST = 0.04  # of B/2: shorter strokes are labels, waterlines or curves that pass
LONGEST_GAP = 0.045  # of B/2: of a label that stands on the line; strokes above it go on with the side
SHORTEST_STROKE_PX = 6  # of those strokes
STEP_WINDOW_PX = 14  # over which the thickness below and above a step is compared
STEP_BLUR_PX = 3  # over which a stroke's end is blurred
LEAST_STEP = 0.12  # of a station's thickness, by which the line thins where a station ends inside the outermost one
LEAST_AT_ONCE = 0.8  # of a step, within the blur of a stroke's end
STEADY_PX = 36  # below and above a step, where the thickness stays
MOST_RESTLESS = 0.4  # of the step
STROKE_END_PX = 5  # over which the thickness just below and above it is averaged
LEAST_BESIDE_STEP = 0.8  # of a station's thickness, which the line keeps above and below
AT_DEPTH = 0.02  # of the depth: a long stroke that ends so near it ends there, by the meaning of the depth
FAINTEST_BOX_LINE_PX = 0.5  # ink across the line below the base line, where no station is


@dataclass(frozen=True)
class ShipSide:
    """Where stations run along the line of B/2, px above the base line.

    Attributes:
        top_px: the highest of them; None where none runs along it.
        steps_px: where the line thins at once: stations end there, the outermost one goes on.
    """

    top_px: float | None
    steps_px: tuple[float, ...] = ()


def find_side(ink: Ink, frame: DiagonalFrame, width_px: float, depth_px: float) -> ShipSide:
    """How far stations are drawn along the line of B/2.

    Args:
        ink: (rows, columns) of the picture, its long lines not taken off.
        frame: of the half.
        width_px: thickness of a station's line.
        depth_px: depth at side.
    """
    size = frame.half_breadth_px
    z = np.arange(-FOOT * size, frame.top_px)
    y = size + np.arange(-REACH_PX, REACH_PX + 0.01, STEP_PX)
    u, v = frame.to_picture(*np.meshgrid(y, z))
    across = cv2.remap(ink, u.astype(np.float32), v.astype(np.float32), cv2.INTER_LINEAR).sum(axis=1) * STEP_PX
    own = float(np.median(across[np.abs(z) < FOOT * size]))
    # a station lies on the line, so that the thicker of the two is seen
    tells = width_px > CLEARLY_THICKER * own
    least = own + SHARE_OF_STATION * (width_px - own) if tells else 0.5 * own
    drawn = (across > least) & (z > FOOT * size)
    kernel = np.ones((max(3, round(SHORTEST * size)), 1), np.uint8)
    runs = np.flatnonzero(cv2.morphologyEx(drawn.astype(np.uint8)[:, None], cv2.MORPH_OPEN, kernel)[:, 0])
    if not runs.size:
        return ShipSide(None)
    ends = z[runs[np.diff(runs, append=runs[-1] + 2) > 1]]
    at_depth = np.abs(ends - depth_px) < AT_DEPTH * depth_px
    # a box line as bold as stations goes on above them, and says nothing of where they end
    beyond_telling = not tells and own > FAINTEST_BOX_LINE_PX and ends[-1] > depth_px
    if at_depth.any() or beyond_telling:
        top = float(ends[at_depth][0]) if at_depth.any() else depth_px
        return ShipSide(top, _steps(z[z <= top], _thickness(ink, frame, z[z <= top]), width_px))
    strokes = cv2.morphologyEx(
        drawn.astype(np.uint8)[:, None], cv2.MORPH_OPEN, np.ones((SHORTEST_STROKE_PX, 1), np.uint8)
    )
    further = np.flatnonzero(strokes[runs[-1] :, 0])
    breaks = np.flatnonzero(np.diff(further) > LONGEST_GAP * size)
    last = int(runs[-1]) + int(further[breaks[0] if breaks.size else -1])
    return ShipSide(float(z[last]), _steps(z[: last + 1], _thickness(ink, frame, z[: last + 1]), width_px))


def _thickness(ink: Ink, frame: DiagonalFrame, z: Array) -> Array:
    """Ink across the line of B/2 and what touches it inboard, px."""
    total = np.zeros(len(z))
    for sign, reach in ((1.0, REACH_PX), (-1.0, REACH_INBOARD_PX)):
        y = frame.half_breadth_px + sign * np.arange(STEP_PX / 2, reach, STEP_PX)
        u, v = frame.to_picture(*np.meshgrid(y, z))
        section = cv2.remap(ink, u.astype(np.float32), v.astype(np.float32), cv2.INTER_LINEAR)
        total += (section * np.cumprod(section > LEAST_INK, axis=1)).sum(axis=1) * STEP_PX
    return total


def _steps(z: Array, across: Array, width_px: float) -> tuple[float, ...]:
    """Heights where a line thins at once and goes on no thinner than a station."""
    length = STEP_WINDOW_PX + STEP_BLUR_PX
    if len(z) < 2 * length:
        return ()
    windows = np.sort(np.lib.stride_tricks.sliding_window_view(across, STEP_WINDOW_PX), axis=1)
    thin, thick = windows[:, STEP_WINDOW_PX // 5], windows[:, -1 - STEP_WINDOW_PX // 5]  # labels and crossings disturb
    offset = STEP_WINDOW_PX + 2 * STEP_BLUR_PX  # from a window below a place to the one above it
    drop = np.where(thin[offset:] > LEAST_BESIDE_STEP * width_px, thin[:-offset] - thick[offset:], 0.0)
    # a curve that nears the line thickens it too, but less and less
    short = np.convolve(across, np.ones(STROKE_END_PX) / STROKE_END_PX, "valid")
    first = STEP_WINDOW_PX - STROKE_END_PX
    gap = STROKE_END_PX + 2 * STEP_BLUR_PX
    sharp = (short[: len(short) - gap] - short[gap:])[first:][: len(drop)]
    middle = np.pad(windows[:, STEP_WINDOW_PX // 2], STEADY_PX, mode="edge")
    count = np.arange(len(drop)) + STEADY_PX
    below = np.array([middle[count - k] for k in range(0, STEADY_PX, 6)])
    above = np.array([middle[count + offset + k] for k in range(0, STEADY_PX, 6)])
    restless = np.maximum(np.ptp(below, axis=0), np.ptp(above, axis=0))
    drop[(sharp < LEAST_AT_ONCE * (below[0] - above[0])) | (restless > MOST_RESTLESS * drop)] = 0.0
    steps = []
    while drop.size and drop.max() > LEAST_STEP * width_px:
        at = int(np.argmax(drop))
        steps.append(float(z[at + length]))
        drop[max(0, at - 2 * offset) : at + 2 * offset] = 0.0
    # stations that end inside the outermost one do so at one deck; several steps are those of a coarse raster
    return tuple(steps) if len(steps) == 1 else ()
