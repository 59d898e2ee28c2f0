"""How large the drawing is: the outermost ink for a rough scale, the spacing of a regular grid for a fine one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.image.ink import Ink

Array = NDArray[np.float64]

ROUND_NUMBERS = (1.0, 1.2, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5, 8.0)  # times powers of ten, in metres
ROUGH_TOLERANCE = 0.03  # between the rough scale and a round grid spacing
AXES_TOLERANCE = 0.004  # between the scales of the two families of a grid
AXES_TOLERANCE_LEANING = 0.012  # the same where the camera leaned
COMB_TOLERANCE_PX = 1.5  # how far a grid line may lie from its multiple
FEWEST_TEETH = 3  # different multiples, zero included, that make a grid: the two sides alone are the ship's
FULL, LEAST_FULL = 0.6, 0.45  # share of the teeth up to the last that are there
LEAST_HALF_BREADTH = 0.05  # of the picture's width: less is the centre line itself
LEAST_SIDE = 0.05  # of the height above the base line: upright ink that counts as a ship's side
LEAST_PIECE = 0.05  # of the centre line's ink: a piece of it
HIGHEST_FIGURE = 0.024  # of the picture's width: figures beside the waterlines may touch them, in two rows
BREAK_OF_SIDE = 0.003  # of the picture's width: of dashes, and of lost ink
SIDE_WINDOW = 0.004  # of the picture's width: how far a ship's side may lean within that


def outermost_half_breadth(
    ink: Ink, origin: tuple[float, float], skew: float, height_px: float | None = None, lean: float = 0.0
) -> float | None:
    """Distance in px from the centre line to the outermost upright ink that hangs together with it.

    Args:
        ink: (rows, columns) map of ink.
        origin: pixel where the centre line meets the base line.
        skew: slope dv/du of the base line.
        height_px: how far above the base line to look; to the picture's top by default.
        lean: of the camera, per px: a distance d along the base line would be d / (1 - lean d) in a flat scan.
    """
    rows, columns = ink.shape
    u0, v0 = origin
    turn = np.array([[1.0, -skew, skew * v0], [skew, 1.0, -skew * u0]])
    upright = cv2.warpAffine(ink, turn, (columns, rows), flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP)
    bottom = round(v0)
    top = max(0, round(v0 - (height_px or v0)))
    drawn = (upright[top : bottom + 8] > 0.25).astype(np.uint8)
    _, labels = cv2.connectedComponents(drawn, connectivity=8)
    centre = round(u0)
    keys = labels[:, max(centre - 2, 0) : centre + 3].ravel()
    keys = keys[keys > 0]
    if keys.size == 0:
        return None
    # lost ink may break the centre line, and the base line off it: what hangs on any of them counts; a border only
    # crosses the centre line
    pieces = np.bincount(keys)
    at_origin = labels[bottom - top - 3 : bottom - top + 4, max(centre - 3, 0) : centre + 4]
    known = np.union1d(np.flatnonzero(pieces > LEAST_PIECE * pieces.sum()), at_origin[at_origin > 0])
    body = np.isin(labels, known)
    body = body[: -8 - max(4, round(0.02 * (bottom - top)))]
    if not body.any():
        return None
    reach = max(1, round(SIDE_WINDOW * columns))
    near = cv2.dilate(body.astype(np.uint8), np.ones((1, 2 * reach + 1), np.uint8))
    # a horizontal line fills few rows, and so does each of the figures that stand above each other at its end; a ship's
    # side fills many in one stroke
    height = float(np.ptp(np.flatnonzero(body.any(axis=1)))) + 1
    stroke = round(max(LEAST_SIDE * height, HIGHEST_FIGURE * columns))
    for operation, rows in ((cv2.MORPH_CLOSE, max(1, round(BREAK_OF_SIDE * columns))), (cv2.MORPH_OPEN, stroke)):
        near = cv2.morphologyEx(near, operation, np.ones((rows, 1), np.uint8))
    sides = np.flatnonzero(near.any(axis=0))
    if sides.size == 0:
        return None
    # the window widens the body by its reach on either side
    left, right = u0 - (sides[0] + reach), (sides[-1] - reach) - u0
    half_breadth = float(max(left / (1 + lean * left), right / (1 - lean * right)))
    return half_breadth if half_breadth > LEAST_HALF_BREADTH * columns else None


@dataclass(frozen=True, eq=False)
class Comb:
    """Lines at multiples of one spacing from an origin."""

    spacing_px: float
    multiples: NDArray[np.int64]
    members: NDArray[np.bool_]


def find_combs(distances: Array, largest: int = 40) -> list[Comb]:
    """Regular spacings among signed distances from the origin, the one with most members first."""
    combs: list[Comb] = []
    far = np.abs(distances)
    steps = {round(float(d) / n, 1): float(d) / n for d in far[far > 12] for n in range(1, 9)}
    steps |= {round(float(d), 1): float(d) for d in np.abs(np.diff(np.sort(distances))) if d > 12}
    for step in steps.values():
        if far.max() / step > largest:
            continue
        multiples = np.round(distances / step).astype(np.int64)
        members = np.abs(distances - multiples * step) < COMB_TOLERANCE_PX + 0.01 * step
        weight = multiples[members].astype(np.float64)
        if len(set(np.abs(multiples[members]))) < FEWEST_TEETH or not weight.any():
            continue
        fine = float((weight @ distances[members]) / (weight @ weight))
        multiples = np.round(distances / fine).astype(np.int64)
        members = np.abs(distances - multiples * fine) < COMB_TOLERANCE_PX
        teeth = multiples[members]
        different = len(set(np.abs(teeth)))
        # teeth that are missing inside the range speak for a multiple of this spacing, where they have one
        full = different / (np.abs(teeth).max() + 1) if teeth.size else 0
        no_multiple = full >= LEAST_FULL and different > FEWEST_TEETH and np.gcd.reduce(teeth) == 1
        if different >= FEWEST_TEETH and (full >= FULL or no_multiple):
            combs.append(Comb(fine, multiples, members))
    return sorted(combs, key=lambda comb: -_regularity(comb))[:12]


def _regularity(comb: Comb) -> float:
    """Members beyond those that chance alone would bring: a fine comb has a tooth near every line."""
    chance = min(1.0, 2 * COMB_TOLERANCE_PX / comb.spacing_px)
    return float(comb.members.sum()) - 2 * chance * len(comb.members)


def round_spacing(spacing_px: float, metres_per_px: float, breadth_m: float, tolerance: float) -> list[float]:
    """Round numbers of metres that a spacing may stand for, near a rough scale."""
    rough = spacing_px * metres_per_px
    power = 10.0 ** np.floor(np.log10(rough))
    numbers = [n * p for n in ROUND_NUMBERS for p in (power / 10, power, power * 10)]
    numbers += [breadth_m / (2 * n) for n in range(1, 13)]
    return sorted({n for n in numbers if abs(n / rough - 1) < tolerance}, key=lambda n: abs(n / rough - 1))


@dataclass(frozen=True, eq=False)
class Grid:
    """A regular grid: metres and multiples of the lines of each family."""

    across: Comb
    across_m: float
    up: Comb
    up_m: float


def find_grid(
    across_px: Sequence[float] | Array,
    up_px: Sequence[float] | Array,
    metres_per_px: float,
    breadth_m: float,
    leaning: bool = False,
) -> Grid | None:
    """The grid of round spacings whose two scales agree with each other and with the rough scale.

    Args:
        across_px: signed distances of the vertical lines from the centre line.
        up_px: heights of the horizontal lines above the base line.
        metres_per_px: the rough scale.
        breadth_m: moulded breadth (spacings may be fractions of it).
        leaning: whether the camera leaned, so that the two scales differ a little.
    """
    axes_tolerance = AXES_TOLERANCE_LEANING if leaning else AXES_TOLERANCE
    if len(across_px) < FEWEST_TEETH or len(up_px) < FEWEST_TEETH:
        return None
    best: tuple[float, Grid] | None = None
    for across in find_combs(np.asarray(across_px)):
        for up in find_combs(np.asarray(up_px)):
            for across_m in round_spacing(across.spacing_px, metres_per_px, breadth_m, ROUGH_TOLERANCE):
                scale = across_m / across.spacing_px
                for up_m in round_spacing(up.spacing_px, scale, breadth_m, axes_tolerance):
                    score = (
                        _regularity(across)
                        + _regularity(up)
                        - 60 * abs(scale / metres_per_px - 1)
                        - 200 * abs(up_m / up.spacing_px / scale - 1)
                        - 0.5 * (_awkward(across_m) + _awkward(up_m))
                    )
                    if best is None or score > best[0]:
                        best = (score, Grid(across, across_m, up, up_m))
    return best[1] if best else None


def _awkward(number: float) -> float:
    """0 for 1, 2, 5 and their powers of ten, 1 for rarer round numbers, 2 for fractions of the breadth."""
    lead = number / 10.0 ** np.floor(np.log10(number) + 1e-9)
    if min(abs(lead - n) for n in (1, 2, 5)) < 1e-6:
        return 0.0
    return 1.0 if min(abs(lead - n) for n in ROUND_NUMBERS) < 1e-6 else 2.0
