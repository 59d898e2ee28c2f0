"""The picture as a map of ink: 0 on paper, 1 on a black line, whatever the paper and the light."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.errors import PictureError

Picture = NDArray[np.uint8]
Ink = NDArray[np.float32]

SMALLEST_PX = 200_000  # below it a half-breadth has less than about 200 px, and neighbouring stations merge
LARGEST_PX = 80_000_000  # the float maps of a larger picture would not fit in a common machine's memory
FAINTEST_INK = 0.2  # share of the paper's brightness that a pixel must lack to count as drawn
LEAST_INK_SHARE = 1e-4  # of the pixels: a body plan has 1 % and more
MOST_INK_SHARE = 0.4  # of the pixels: beyond it the picture is a photograph or a negative


def load_grey(path: Path) -> Picture:
    """Read an image file as 8-bit grey, the darkest channel of each pixel, as stored (EXIF turns are ignored).

    The darkest channel keeps coloured lines dark. Transparent pixels are paper.

    Raises:
        PictureError: no such file, no image, or an image too small or too large.
    """
    try:
        data = np.frombuffer(path.read_bytes(), dtype=np.uint8)
    except FileNotFoundError:
        raise PictureError(f"{path}: no such picture; [body_plan] image is taken from ship.toml's folder") from None
    except OSError as error:
        raise PictureError(f"{path}: cannot be read ({error.strerror}); give an image file") from None
    if data.size == 0:
        raise PictureError(f"{path}: the file is empty; give a PNG, JPEG or TIFF picture")
    try:
        image = cv2.imdecode(data, cv2.IMREAD_UNCHANGED)
    except cv2.error:
        image = None
    if image is None:
        raise PictureError(f"{path}: no image that OpenCV can decode ({data.size} bytes); save it as PNG, JPEG or TIFF")
    height, width = image.shape[:2]
    if height * width < SMALLEST_PX:
        raise PictureError(
            f"{path}: {width} x {height} px is too small to tell stations apart; "
            "scan or export it at 1600 px width or more"
        )
    if height * width > LARGEST_PX:
        raise PictureError(
            f"{path}: {width} x {height} px is more than {LARGEST_PX // 1_000_000} Mpx; scale it to about 3000 px width"
        )
    return _to_grey(image)


def _to_grey(image: NDArray[np.generic]) -> Picture:
    if image.dtype == np.uint8:
        levels = image.astype(np.uint8, copy=False)
    elif image.dtype == np.uint16:
        levels = (image >> 8).astype(np.uint8)  # type: ignore[operator]
    else:
        numbers = np.nan_to_num(image.astype(np.float64))
        span = max(float(numbers.max() - numbers.min()), 1e-12)
        levels = (255 * (numbers - numbers.min()) / span).astype(np.uint8)
    if levels.ndim == 2:
        return levels
    if levels.shape[2] == 2 or levels.shape[2] == 4:
        colour, alpha = levels[..., :-1].min(axis=2).astype(np.uint16), levels[..., -1].astype(np.uint16)
        return np.asarray((colour * alpha + 255 * (255 - alpha)) // 255, dtype=np.uint8)
    return np.ascontiguousarray(levels.min(axis=2))


def ink_of(grey: Picture, name: str = "the picture") -> Ink:
    """Ink of each pixel, (paper - grey) / paper, scaled so that a full line is 1; single specks are dropped.

    Args:
        grey: (rows, columns) 8-bit picture.
        name: what to call it in an error.

    Raises:
        PictureError: blank, or more ink than a drawing has.
    """
    height, width = grey.shape
    shrink = 4  # the paper's shade changes slowly; a quarter of the resolution is enough for it
    small = cv2.resize(
        cv2.GaussianBlur(grey, (0, 0), 1.0), (width // shrink, height // shrink), interpolation=cv2.INTER_AREA
    )
    window = max(9, width // (40 * shrink) | 1)
    paper = cv2.morphologyEx(cv2.medianBlur(small, 3), cv2.MORPH_CLOSE, np.ones((window, window), np.uint8))
    paper = cv2.GaussianBlur(paper.astype(np.float32), (0, 0), window / 2)
    paper = np.maximum(cv2.resize(paper, (width, height), interpolation=cv2.INTER_LINEAR), 1.0)
    ink = np.clip((paper - grey) / paper, 0.0, 1.0).astype(np.float32)
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
    speck = statistics[:, cv2.CC_STAT_AREA] < max(6.0, 7.0 * (width / 1000.0) ** 2)
    speck[0] = False
    ink[speck[labels]] = 0.0
    return np.asarray(ink, dtype=np.float32)
