"""What does not fit together: stations and curves, the scale and the main particulars, the drawing and its picture."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.errors import PictureError
from hullform.picture.checking.missing import where_missing
from hullform.picture.image.ink import Ink
from hullform.picture.naming.alignment import NO_CURVE
from hullform.picture.naming.named_half import NamedHalf
from hullform.picture.tracing.half import HalfReading

Array = NDArray[np.float64]

AT_SIDE = 0.97  # of B/2: what the outermost curve of a drawing reaches
NEAR_SIDE = 0.9  # of B/2: stations there end about as high as the midship section
ON_SIDE = 0.996  # of B/2: stations there run up the line of the ship's side
SCALES_APART = 0.015  # between breadth and depth, beyond which a person should look
ENDS_AT_DEPTH = (
    0.25  # of the curves that end near the side: so many amidships end at the depth, others with sheer above
)
HOPELESS = 0.85  # least ratio of the scales of breadth and depth, either way
NEAR_PX = 3  # by which ink is widened: the end of a curve points aside by so much
RUNS_ON = (0.02, 0.06)  # of B/2: where ink beyond the end of a curve means that the curve goes on
BESIDE_STROKE = 0.013  # of B/2: so far beside a curve that goes on there is paper, beside the middle of figures ink
SIDE_WINDOW = 0.08  # of B/2: the stretch of the line of the side that must be drawn for the most part
HIGHEST_KEEL = 0.04  # of D: of the midship section
TRACED_BELOW = 0.012  # of B/2 below the base line: nearer to it flat bottoms waver
DEEPEST = 0.5  # of B/2: how far down is looked
DEEP = 0.06  # of B/2: what hangs down from the base line less far is a label or a box line's end
FEWEST_DOUBTS, MOST_DOUBTED = 6, 0.3  # all in all, and of the stations: so many doubts have a common cause
EDGE_PX = 2.5
FEWEST_CUT = 3  # lines at the picture's edge: one or two may be the scanner's
WIDEST_STROKE_PX = 40


def doubts_of_the_whole(doubts: int, stations: int) -> list[str]:
    """What to look at before the single doubts, where they are so many that something common must be wrong.

    Args:
        doubts: number of all others.
        stations: number that is listed.
    """
    if doubts < max(FEWEST_DOUBTS, MOST_DOUBTED * stations):
        return []
    return [
        f"{doubts} doubts for {stations} stations: look first whether the picture shows a body plan alone, upright and "
        "not turned by 90 degrees or mirrored, and whether scale and base line lie right in the overlay"
    ]


def doubts_of_counts(halves: Sequence[NamedHalf], draught_m: float) -> list[str]:
    """More curves than stations, and halves that fit each other's stations better.

    Args:
        halves: both.
        draught_m: to which waterlines are looked at.
    """
    doubts = []
    for half in halves:
        name, listed, more = half.reading.half, len(half.inner_first), half.reading.unlisted
        seen = len(half.reading.curves)
        if more:
            missing = "one station is" if more == 1 else f"{more} stations are"
            doubts.append(
                f"{name} half: {seen} curves seen but {listed} stations listed; {missing} missing from "
                f"{name}_stations_m{where_missing(half, draught_m)}"
            )
    (a, b), (listed_a, listed_b) = (len(h.reading.curves) for h in halves), (len(h.inner_first) for h in halves)
    if abs(a - listed_b) + abs(b - listed_a) < abs(a - listed_a) + abs(b - listed_b):
        doubts.append(
            f"aft_side: the half taken for aft shows {a} curves for {listed_a} stations, the other {b} for {listed_b}; "
            "the other way round they fit better: check aft_side and whether the picture is mirrored"
        )
    return doubts


def doubts_of_scale(
    path: str, readings: Sequence[HalfReading], ink: Ink, bare: Ink, breadth_m: float, depth_m: float, by_grid: bool
) -> list[str]:
    """The scale of the breadth against the height to which the ship's side is drawn, which is the depth.

    Args:
        path: of the picture.
        readings: of both halves.
        ink: (rows, columns) of the picture.
        bare: the same, its long straight lines taken off.
        breadth_m, depth_m: of ship.toml.
        by_grid: whether a grid fixed the scale, so that no stretched picture can be the reason.

    Raises:
        PictureError: they are so far apart that no figure read would mean anything.
    """
    scale = readings[0].frame.metres_per_px
    sides = [_top_of_side(reading, ink) for reading in readings]
    curves = [(curve, reading) for reading in readings for curve in reading.curves]
    widest = max(float(curve[:, 0].max()) for curve, _ in curves) * scale
    # the lines of a drawing's box may run on above the deck, so curves must do so too
    near_side = [curve for curve, reading in curves if curve[-1, 0] > NEAR_SIDE * reading.frame.half_breadth_px]
    tops_m = [top * scale for top in sides if top is not None] or [
        max(float(curve[-1, 1]) for curve in near_side or [curve for curve, _ in curves]) * scale
    ]
    near = _widened(bare)
    # those that run up the line of B/2 are taken to the depth by its meaning, and along it others go on with sheer
    off_side = [(c, r) for c, r in curves if c[-1, 0] < ON_SIDE * r.frame.half_breadth_px]
    beyond = [_runs_on(curve, reading, near) for curve, reading in off_side or curves]
    cut_off = sum(beyond) > 0.5 * len(beyond)
    ends_m = [
        float(curve[-1, 1]) * scale
        for curve, reading in off_side
        if curve[-1, 0] > NEAR_SIDE * reading.frame.half_breadth_px
    ]
    # the depth is that amidships: with sheer the others end above it, in a stretched picture all do, and as much
    at_depth = sum(abs(end / depth_m - 1) < SCALES_APART for end in ends_m) >= max(2, ENDS_AT_DEPTH * len(ends_m))
    curves_above = cut_off or (not at_depth and any(end > (1 + SCALES_APART) * depth_m for end in ends_m))
    all_above = cut_off or (bool(ends_m) and min(ends_m) > depth_m / HOPELESS)
    top = max(tops_m) if max(tops_m) < depth_m else min(tops_m)
    fits = (top / depth_m > 1 - SCALES_APART) and (top / depth_m < 1 + SCALES_APART or not curves_above)
    if fits and not cut_off and widest > AT_SIDE * breadth_m / 2:
        return []
    words = (
        f"the outermost curves reach {widest:.2f} m from the centre line and {top:.2f} m above the base line at the "
        f"scale found; ship.toml says breadth_m = {breadth_m:g} and depth_m = {depth_m:g}"
    )
    if not (top / depth_m >= HOPELESS and (top / depth_m <= 1 / HOPELESS or not all_above)):
        raise PictureError(
            f"{path}: {words}; these do not fit: check breadth_m, depth_m, [body_plan.calibration] and whether the "
            "picture was stretched or cut off"
        )
    if by_grid:
        return [f"scale: {words}; the grid fixed the scale: check depth_m and breadth_m, and the grid in the overlay"]
    return [
        f"scale: {words}; that is {scale:.5g} m per px by the breadth and {scale * depth_m / top:.5g} m per px by the "
        "depth: check breadth_m, depth_m and whether the picture was stretched"
    ]


def doubts_of_keel(readings: Sequence[HalfReading], depth_m: float) -> list[str]:
    """A midship section that stands clear of the base line: the line is one too low.

    Args:
        readings: of both halves.
        depth_m: of ship.toml.
    """
    scale = readings[0].frame.metres_per_px
    # single curves are led down a wrong line now and then, so the fuller third of them decides
    keels = [float(c[:, 1].min()) for r in readings for c in r.curves[-max(1, len(r.curves) // 3) :]]
    keel_m = float(np.median(keels)) * scale
    if keel_m <= HIGHEST_KEEL * depth_m:
        return []
    return [
        f"base line: the fullest sections end {keel_m:.2f} m above it, and not on it; give baseline_px in "
        "[body_plan.calibration] where it was taken for another line (see the overlay), or check depth_m"
    ]


def doubts_below_base(readings: Sequence[HalfReading], bare: Ink) -> list[str]:
    """Curves that go on below the base line although no station was traced there: a dome, or the wrong base line.

    Args:
        readings: of both halves.
        bare: (rows, columns) ink of the picture without its long straight lines.
    """
    doubts = []
    for reading in readings:
        frame = reading.frame
        size = frame.half_breadth_px
        if min((float(curve[:, 1].min()) for curve in reading.curves), default=0.0) < -TRACED_BELOW * size:
            continue
        y, below = np.meshgrid(np.arange(TRACED_BELOW * size, size), np.arange(TRACED_BELOW * size, DEEPEST * size))
        u, v = frame.to_picture(y.ravel(), -below.ravel())
        at_u, at_v = (px.reshape(y.shape).astype(np.float32) for px in (u, v))
        drawn = cv2.remap(bare, at_u, at_v, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=0) > 0.3
        _, _, found, _ = cv2.connectedComponentsWithStats(drawn.astype(np.uint8), connectivity=8)
        tops = np.asarray(found[1:, cv2.CC_STAT_TOP], dtype=np.float64)
        heights = np.asarray(found[1:, cv2.CC_STAT_HEIGHT], dtype=np.float64)
        curves = (tops < TRACED_BELOW * size) & (heights > DEEP * size)
        if curves.any():
            lowest_m = float((tops + heights)[curves].max() + TRACED_BELOW * size) * frame.metres_per_px
            doubts.append(
                f"{reading.half} half: {int(curves.sum())} curves go on below the base line, to -{lowest_m:.2f} m, "
                "and were not traced there; look at the base line in the overlay, and give baseline_px in "
                "[body_plan.calibration] if it is another line"
            )
    return doubts


def doubts_of_edges(readings: Sequence[HalfReading], bare: Ink) -> list[str]:
    """Curves that run out of the picture."""
    doubts = []
    rows, columns = bare.shape
    for reading in readings:
        out = 0
        for curve in reading.curves:
            u, v = reading.frame.to_picture(curve[:, 0], curve[:, 1])
            beyond = (u < EDGE_PX) | (v < EDGE_PX) | (u > columns - 1 - EDGE_PX) | (v > rows - 1 - EDGE_PX)
            out += bool(beyond.any())
        if out:
            doubts.append(
                f"{reading.half} half: {out} curves reach the edge of the picture; "
                "give a picture of the whole body plan"
            )
    if not doubts:
        cut = sum(_strokes(strip) for strip in (bare[2], bare[:, 2], bare[:, -3]))
        if cut >= FEWEST_CUT:
            doubts.append(
                f"{cut} lines run out of the picture at its top or sides; give a picture of the whole body plan"
            )
    return doubts


def doubts_of_decks(halves: Sequence[NamedHalf], bare: Ink) -> list[str]:
    """Stations near the side that go on above the deck edge, which was taken for level where it could not be seen.

    Args:
        halves: with their stations.
        bare: (rows, columns) ink of the picture without its long straight lines.
    """
    doubts = []
    near = _widened(bare)
    for half in halves:
        reading, sheer = half.reading, half.reading.sheer
        if sheer is None or sheer.falls:
            continue
        by_hand = {number for number, _ in reading.drawn}
        going_on = [
            x
            for x, number in zip(half.inner_first, half.assigned, strict=True)
            if number != NO_CURVE
            and number not in by_hand
            and reading.curves[number][-1, 0] > sheer.seen_to_px
            and _runs_on(reading.curves[number], reading, near)
        ]
        if going_on:
            doubts.append(
                f"{half.names.several(sorted(going_on))} ({reading.half} half): ink goes on above their upper ends, "
                "near the side, where the deck edge could not be seen and was taken to go on level; look at them in "
                "the overlay, or draw the deck edge on the review page"
            )
    return doubts


def _widened(bare: Ink) -> Ink:
    return np.asarray(cv2.dilate(bare, np.ones((2 * NEAR_PX + 1,) * 2, np.uint8)), dtype=np.float32)


def _strokes(strip: Ink) -> int:
    """Number of lines that cross a row or column of the picture."""
    drawn = np.concatenate([[False], strip > 0.3, [False]])
    starts, ends = np.flatnonzero(~drawn[:-1] & drawn[1:]), np.flatnonzero(drawn[:-1] & ~drawn[1:])
    return int(np.count_nonzero(ends - starts <= WIDEST_STROKE_PX))


def _top_of_side(reading: HalfReading, ink: Ink) -> float | None:
    """Height in px to which upright ink is drawn along the line of B/2, broken here and there or not; None without."""
    frame = reading.frame
    z = np.arange(0.2 * frame.half_breadth_px, frame.top_px)
    y = frame.half_breadth_px + np.arange(-3.0, 3.01)
    u, v = frame.to_picture(*np.meshgrid(y, z))
    drawn = cv2.remap(ink, u.astype(np.float32), v.astype(np.float32), cv2.INTER_LINEAR).max(axis=1) > 0.1
    window = round(SIDE_WINDOW * frame.half_breadth_px)
    share = np.convolve(drawn, np.ones(window) / window)[: z.size]  # of the stretch that ends here
    upper = np.flatnonzero(drawn & (share > 0.6))
    if not upper.size or drawn[: upper[-1]].mean() < 0.6:
        return None
    return float(z[upper[-1]])


def _runs_on(curve: Array, reading: HalfReading, near: Ink) -> bool:
    """Whether a stroke goes on in the direction in which a curve ends; figures that stand there are wider.

    Args:
        curve: (n, 2) [y, z].
        reading: of its half.
        near: (rows, columns) ink of the picture, widened by some pixels.
    """
    size = reading.frame.half_breadth_px
    farther = curve[np.hypot(*(curve - curve[-1]).T) > 0.03 * size]
    if not farther.size:
        return False
    heading = (curve[-1] - farther[-1]) / np.hypot(*(curve[-1] - farther[-1]))
    ahead = np.linspace(*RUNS_ON, 40)[:, None] * size * heading + curve[-1]
    beside = max(BESIDE_STROKE * size, NEAR_PX + EDGE_PX) * np.array([-heading[1], heading[0]])
    seen = []
    for offset in (0.0, 1.0, -1.0):
        u, v = reading.frame.to_picture(*(ahead + offset * beside).T)
        ink = cv2.remap(near, u.astype(np.float32)[None], v.astype(np.float32)[None], cv2.INTER_NEAREST)
        seen.append(float((ink > 0.3).mean()))
    return seen[0] > 0.8 and min(seen[1:]) < 0.5
