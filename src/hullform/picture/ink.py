"""The picture as a map of ink: 0 on paper, 1 on a black line, whatever the paper and the light."""

from __future__ import annotations

import struct
import zlib
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
BAND = 4_000_000  # values that are worked on at a time, to spare memory
PNG = b"\x89PNG\r\n\x1a\n"
FEWEST_GREYS = 0.002  # of the pixels: a smaller share between black and white makes a picture of hard edges
BLUR_OF_HARD_EDGES_PX = 0.7
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
    if not _is_whole(data):
        raise PictureError(
            f"{path}: the file is damaged or cut short ({data.size} bytes); copy it again from where it came from"
        )
    level = cv2.utils.logging.setLogLevel(cv2.utils.logging.LOG_LEVEL_SILENT)
    try:
        image = cv2.imdecode(data, cv2.IMREAD_UNCHANGED)
    except cv2.error:
        image = None
    finally:
        cv2.utils.logging.setLogLevel(level)
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


def _is_whole(data: NDArray[np.uint8]) -> bool:
    """Whether every chunk of a PNG file is there with its checksum; other files are left to their decoder.

    The PNG decoder writes its complaints to the standard error stream past every log level.
    """
    content = data.tobytes()
    if not content.startswith(PNG):
        return True
    at = len(PNG)
    while at + 12 <= len(content):
        size, kind = struct.unpack_from(">I4s", content, at)
        end = at + 8 + size
        if end + 4 > len(content) or struct.unpack_from(">I", content, end)[0] != zlib.crc32(content[at + 4 : end]):
            return False
        if kind == b"IEND":
            return True
        at = end + 4
    return False


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
        grey = np.empty(levels.shape[:2], dtype=np.uint8)
        for rows in np.array_split(np.arange(len(levels)), max(1, levels.size // BAND)):
            part = levels[rows[0] : rows[-1] + 1]
            colour, alpha = part[..., :-1].min(axis=2).astype(np.uint16), part[..., -1].astype(np.uint16)
            grey[rows] = (colour * alpha + 255 * (255 - alpha)) // 255
        return grey
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
