"""The picture as a map of ink: 0 on paper, 1 on a black line, whatever the paper and the light."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.errors import PictureError
from hullform.picture.image.image_files import Picture
from hullform.picture.image.paper import beyond_paper

Ink = NDArray[np.float32]

FAINTEST_INK = 0.2  # share of the paper's brightness that a pixel must lack to count as drawn
FEWEST_GREYS = 0.002  # of the pixels: a smaller share between black and white makes a picture of hard edges
BLUR_OF_HARD_EDGES_PX = 0.7
LEAST_INK_SHARE = 1e-4  # of the pixels: a body plan has 1 % and more
LEAST_DRAWING = 0.4  # of the picture's width
SMALLEST_PIECE_PX, SMALLEST_PIECE = 6.0, 7e-6  # px, and of the picture's width squared: less is a speck
LEAST_OF_DASH = 3.0  # longer than thick
BOX_OF_PIECE = (cv2.CC_STAT_LEFT, cv2.CC_STAT_TOP, cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT)
EMPTY_OF_BORDER = (0.3, 0.7)  # of its breadth and height: a title block in its corner does not reach there
STRIP_OF_BORDER = 0.1  # of its breadth and height: in it lies a side of a border, turned by a scanner or not
MOST_OF_SIDE = 0.6  # that a border runs along
MOST_INK_SHARE = 0.4  # of the pixels: beyond it the picture is a photograph or a negative


def ink_of(grey: Picture, name: str = "the picture") -> Ink:
    """Ink of each pixel, (paper - grey) / paper, scaled so that a full line is 1.

    Single specks are dropped, and a border round the sheet; dashes stay.

    Args:
        grey: (rows, columns) 8-bit picture.
        name: what to call it in an error.

    Raises:
        PictureError: blank, or more ink than a drawing has.
    """
    height, width = grey.shape
    between = cv2.inRange(grey, int(grey.min()) + 16, int(grey.max()) - 16)
    if np.count_nonzero(between) < FEWEST_GREYS * grey.size:
        # where a line lies to less than a pixel shows in the greys of its edges only
        grey = np.asarray(cv2.GaussianBlur(grey, (0, 0), BLUR_OF_HARD_EDGES_PX), dtype=np.uint8)
    shrink = 4  # the paper's shade changes slowly; a quarter of the resolution is enough for it
    small = cv2.resize(
        cv2.GaussianBlur(grey, (0, 0), 1.0), (width // shrink, height // shrink), interpolation=cv2.INTER_AREA
    )
    window = max(9, width // (40 * shrink) | 1)
    paper = cv2.morphologyEx(cv2.medianBlur(small, 3), cv2.MORPH_CLOSE, np.ones((window, window), np.uint8))
    paper = cv2.GaussianBlur(paper.astype(np.float32), (0, 0), window / 2)
    paper = np.maximum(cv2.resize(paper, (width, height), interpolation=cv2.INTER_LINEAR), 1.0)
    ink = np.clip((paper - grey) / paper, 0.0, 1.0).astype(np.float32)
    table = beyond_paper(grey)
    if table is not None:
        ink[table] = 0.0
    dark = ink[ink > FAINTEST_INK]
    share = dark.size / ink.size
    if share < LEAST_INK_SHARE:
        raise PictureError(
            f"{name}: blank: {100 * share:.3f} % of its pixels are drawn; give the picture of a body plan, "
            "dark lines on light paper"
        )
    if share > MOST_INK_SHARE:
        raise PictureError(
            f"{name}: {100 * share:.0f} % of its pixels are dark, which is no line drawing; give a body plan drawn "
            "in dark lines on light paper"
        )
    ink = np.clip(ink / np.percentile(dark, 90), 0.0, 1.0).astype(np.float32)
    _, labels, statistics, _ = cv2.connectedComponentsWithStats((ink > 0.25).astype(np.uint8), connectivity=8)
    _, _, wide, high = (statistics[:, k] for k in BOX_OF_PIECE)
    area = statistics[:, cv2.CC_STAT_AREA]
    # the dashes of a chain-dotted centre line are as small, but long for their thickness
    dash = np.maximum(wide, high) > LEAST_OF_DASH * np.minimum(wide, high)
    speck = (area < SMALLEST_PIECE_PX) | ((area < SMALLEST_PIECE * width**2) & ~dash)
    dropped = speck | _borders(labels, statistics, width)
    dropped[0] = False
    ink[dropped[labels]] = 0.0
    return np.asarray(ink, dtype=np.float32)


def _borders(labels: NDArray[np.int32], statistics: NDArray[np.int32], width: int) -> NDArray[np.bool_]:
    """Which connected pieces (one a row) go round a drawing without touching it: the border of the sheet.

    It runs along all four sides of what it goes round, and nothing of it lies in the middle; of a drawing that a scan
    has torn apart much does, or no line closes it above.
    """
    left, top, wide, high = (statistics[:, k] for k in BOX_OF_PIECE)
    right, bottom = left + wide, top + high
    border = np.zeros(len(statistics), dtype=np.bool_)
    large = np.flatnonzero(wide > LEAST_DRAWING * width)
    large = large[large > 0]
    for n in large:
        inside = (left[large] > left[n]) & (right[large] < right[n]) & (top[large] > top[n])
        rows, columns = (
            slice(round(start + EMPTY_OF_BORDER[0] * size), round(start + EMPTY_OF_BORDER[1] * size))
            for start, size in ((top[n], high[n]), (left[n], wide[n]))
        )
        goes_round = bool((inside & (bottom[large] < bottom[n])).any()) and not (labels[rows, columns] == n).any()
        border[n] = goes_round and _runs_round(labels[top[n] : bottom[n], left[n] : right[n]] == n)
    return border


def _runs_round(piece: NDArray[np.bool_]) -> bool:
    """Whether a piece runs along most of each side of its box."""
    rows, columns = (max(1, round(STRIP_OF_BORDER * size)) for size in piece.shape)
    strips = (piece[:rows], piece[-rows:], piece[:, :columns].T, piece[:, -columns:].T)
    return all(bool(strip.any(axis=0).mean() > MOST_OF_SIDE) for strip in strips)
