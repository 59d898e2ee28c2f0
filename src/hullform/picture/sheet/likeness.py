"""What a picture that is no body plan looks like, or one that stands on its head, in words that help to mend it."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import contextmanager

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.errors import PictureError
from hullform.picture.calibrating.line_mask import subtract_lines
from hullform.picture.calibrating.lines import find_lines
from hullform.picture.image.ink import Ink
from hullform.picture.pieces.half_ink import HalfInk

Array = NDArray[np.float64]

DRAWN = 0.25  # ink of a pixel that counts as drawn
HALF_TONE = (0.1, 0.4)  # ink of a pixel that is neither paper nor line
MANY_HALF_TONES = 0.13  # of the pixels: poor scans of drawings have up to 0.11
LETTER = 0.06  # of the picture's width: larger pieces that hang together are no letters
MOSTLY = 0.6  # of the ink
WORD = 0.12  # of the picture's width: likewise, for words in the cells of a table
GAP = 0.004  # of the picture's width: what a line that was taken off leaves in a curve that crosses it
FEWEST_ROWS = 4  # lines of each family that make a table
MUCH_WIDER = 1.6  # than B / D: a body plan with a high bow is narrower, one with margins little wider
MUCH_NARROWER = 0.5
EDGE_BLUR_PX = 1.5
ORIENTATION_BLUR = 0.008  # of B/2: over which the corners of lines that were cut off, which lean both ways, cancel out
RISING = 0.3  # real body plans have 0.7 and more, a barge with a tunnel 0.53 in her aft half
DIAGONAL = 0.35  # of B/2: a straight stroke so long that falls outwards is a diagonal
DIAGONAL_GAP = 0.012  # of B/2
FAINTEST_FALL = 0.02  # of the strongest product of gradients
STRAIGHT = 0.03  # of B/2: RMS of the points of a stroke, or of two beside each other, about its axis
LEAST_LEFT = 0.25  # of what rises or falls, without diagonals: of less nothing can be said
AXIS = 0.02  # of B/2 and of D: left out beside the centre line and the base line


@contextmanager
def explained(name: str, ink: Ink, breadth_m: float, depth_m: float) -> Iterator[None]:
    """Say what a picture looks like when it cannot be read.

    Args:
        name: of the picture.
        ink: (rows, columns) of it.
        breadth_m, depth_m: of the ship.

    Raises:
        PictureError: that of the block, begun with what the picture looks like where that is known.
    """
    try:
        yield
    except PictureError as error:
        words = likeness(ink, breadth_m / depth_m)
        if words is None:
            raise
        raise PictureError(
            f"{name}: {words}; give the body plan alone, upright. (The reader stopped at: "
            f"{str(error).removeprefix(f'{name}: ')})"
        ) from None


def likeness(ink: Ink, breadth_by_depth: float) -> str | None:
    """What a picture that is no body plan looks like, with the figure that says so; None where it may be one.

    Args:
        ink: (rows, columns).
        breadth_by_depth: B / D of the ship.
    """
    width = ink.shape[1]
    drawn = (ink > DRAWN).astype(np.uint8)
    tones = float(np.mean((ink > HALF_TONE[0]) & (ink < HALF_TONE[1])))
    if tones > MANY_HALF_TONES:
        return f"it looks like a photograph or a shaded picture: {100 * tones:.0f} % of its pixels are half-tones"
    if (small := _share_of_small(drawn, LETTER * width)) > MOSTLY:
        return f"it looks like text: {100 * small:.0f} % of its ink lies in pieces as small as letters"
    horizontal, vertical = find_lines(ink)
    if min(len(horizontal), len(vertical)) >= FEWEST_ROWS:
        bare, _ = subtract_lines(ink, [*horizontal, *vertical])
        brush = np.ones((1 + round(GAP * width), 1 + round(GAP * width)), np.uint8)
        rest = np.asarray(cv2.morphologyEx((bare > DRAWN).astype(np.uint8), cv2.MORPH_CLOSE, brush), dtype=np.uint8)
        if not rest.any() or _share_of_small(rest, WORD * width) > MOSTLY:
            return (
                f"it looks like a table or an empty grid: {len(horizontal)} by {len(vertical)} long lines with nothing "
                "but small pieces between them"
            )
    _, _, statistics, _ = cv2.connectedComponentsWithStats(drawn, connectivity=8)
    largest = statistics[1 + int(np.argmax(statistics[1:, cv2.CC_STAT_WIDTH]))]
    aspect = float(largest[cv2.CC_STAT_WIDTH]) / float(largest[cv2.CC_STAT_HEIGHT])
    size = f"the drawing is {aspect:.1f} times as wide as high, and this ship's B / D is {breadth_by_depth:.1f}"
    if aspect > MUCH_WIDER * breadth_by_depth:
        return f"it looks like a profile or a waterlines plan, or breadth_m or depth_m is wrong: {size}"
    if aspect < MUCH_NARROWER * breadth_by_depth:
        return f"it looks like half a body plan or one that lies on its side: {size}"
    return None


def require_upright(name: str, bare: Ink, halves: Collection[HalfInk]) -> None:
    """Refuse a picture whose curves do not rise from the centre line outwards, as those of every body plan do.

    Args:
        name: of the picture.
        bare: (rows, columns) its ink without the long straight lines.
        halves: both, prepared.

    Raises:
        PictureError: the curves fall outwards (upside down), or do neither (another drawing).
    """
    rise = float(np.mean([_rise(bare, half) for half in halves]))
    if rise < RISING:
        # a barge shows little that rises, and diagonals that fall
        without = float(np.mean([_rise(bare, half, diagonals=False) for half in halves]))
        rise = without if without > RISING else rise
    if rise < -RISING:
        raise PictureError(
            f"{name}: upside down: its curves fall from the centre line outwards; turn the picture by 180 degrees, or "
            "flip it where it was mirrored too"
        )
    if rise < RISING:
        raise PictureError(
            f"{name}: no body plan: its curves rise from the centre line outwards no more than they fall ({rise:.2f} "
            "on a scale from -1 to 1), as in another view or a photograph; give a body plan, fore and aft "
            "half beside each other on one centre line"
        )


def _rise(bare: Ink, half: HalfInk, diagonals: bool = True) -> float:
    """How much more ink rises outwards than falls, from -1 to 1, by the products of its gradients.

    Args:
        bare: (rows, columns) ink of the picture.
        half: of it.
        diagonals: whether long straight strokes that fall outwards count too; without them little may be left, which
            then tells little.
    """
    frame = half.frame
    size, depth = frame.half_breadth_px, half.depth_px
    y, z = np.meshgrid(np.arange(AXIS * size, size), np.arange(AXIS * depth, depth))
    u, v = frame.to_picture(y.ravel(), z.ravel())
    smooth = cv2.GaussianBlur(bare, (0, 0), EDGE_BLUR_PX)
    gradients = cv2.Sobel(smooth, cv2.CV_32F, 1, 0) * cv2.Sobel(smooth, cv2.CV_32F, 0, 1) * frame.side
    product = cv2.GaussianBlur(gradients, (0, 0), max(3.0, ORIENTATION_BLUR * size))
    here = cv2.remap(
        product, u.reshape(y.shape).astype(np.float32), v.reshape(y.shape).astype(np.float32), cv2.INTER_LINEAR
    )
    least = 1e-9
    if not diagonals:
        least = LEAST_LEFT * float(np.abs(here).sum())
        here = np.where(_diagonals(here, size), 0.0, here)
    return float(here.sum() / max(float(np.abs(here).sum()), least, 1e-9))


def _diagonals(product: NDArray[np.generic], size: float) -> NDArray[np.bool_]:
    """Where long straight strokes fall outwards, on a half's upright raster."""
    falling = np.asarray(product, dtype=np.float32)
    drawn = (falling < -FAINTEST_FALL * float(np.abs(falling).max())).astype(np.uint8)
    # lines of the drawing that were taken off break it
    gap = 2 * round(DIAGONAL_GAP * size / 2) + 1
    _, labels, boxes, _ = cv2.connectedComponentsWithStats(
        cv2.morphologyEx(drawn, cv2.MORPH_CLOSE, np.ones((gap, gap)))
    )
    longest = np.hypot(boxes[:, cv2.CC_STAT_WIDTH], boxes[:, cv2.CC_STAT_HEIGHT])
    straight = np.zeros(len(boxes), dtype=np.bool_)
    for n in np.flatnonzero(longest > DIAGONAL * size):
        if n > 0:
            points = np.argwhere((labels == n) & (drawn > 0))
            straight[n] = np.sqrt(np.linalg.eigvalsh(np.cov(points.T))[0]) < STRAIGHT * size
    kernel = np.ones((gap, gap), np.uint8)
    return np.asarray(cv2.dilate(straight[labels].astype(np.uint8), kernel) > 0)


def _share_of_small(drawn: NDArray[np.uint8], size_px: float) -> float:
    """Share of the drawn pixels that lie in pieces smaller than a size."""
    _, _, found, _ = cv2.connectedComponentsWithStats(drawn, connectivity=8)
    statistics = np.asarray(found[1:], dtype=np.float64)
    sides = [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]
    small = statistics[:, sides].max(axis=1) < size_px
    areas = statistics[:, cv2.CC_STAT_AREA]
    return float(areas[small].sum() / max(1, int(areas.sum())))
