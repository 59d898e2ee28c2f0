"""Image files of every common kind as one: 8-bit grey, upright, transparent where white."""

from __future__ import annotations

import io
import struct
import warnings
import zlib
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError

from hullform.errors import PictureError
from hullform.picture.image.pdf_pages import is_pdf, render_page

Picture = NDArray[np.uint8]

SMALLEST_PX = 300_000  # below it a half-breadth has less than about 250 px, and neighbouring stations merge
LARGEST_PX = 60_000_000  # the decoded colours of a larger picture would not fit in a common machine's memory
BAND_ROWS = 256  # that are worked on at a time, to spare memory
SAMPLE = 16  # one pixel of so many each way tells the ground
DARK_GROUND = 90  # level of 0..255 below which the ground is dark, as on the screen of a drawing program
PNG = b"\x89PNG\r\n\x1a\n"
KINDS = "PNG, JPEG, TIFF, WebP or BMP picture or a PDF"
ORIENTATION = 0x0112  # EXIF tag
# what a viewer does to the stored rows and columns, by the tag's value: transpose, flip up-down, flip left-right
TURNS = {
    2: (False, False, True),
    3: (False, True, True),
    4: (False, True, False),
    5: (True, False, False),
    6: (True, False, True),
    7: (True, True, True),
    8: (True, True, False),
}


def load_grey(path: Path, page: int = 1) -> Picture:
    """Read an image file or a page of a PDF as 8-bit grey, upright as viewers show it.

    The darkest channel of each pixel keeps coloured lines dark. Transparent pixels are paper. Light lines on a
    dark ground are turned into dark ones on a light ground. EXIF turns are obeyed.

    Args:
        path: of a PNG, JPEG, TIFF, WebP, BMP or PDF file.
        page: of a PDF or a TIFF file of several, from 1.

    Returns:
        (rows, columns) grey.

    Raises:
        PictureError: no such file, no image, damaged, no such page, or too small or too large.
    """
    try:
        content = path.read_bytes()
    except FileNotFoundError:
        raise PictureError(f"{path}: no such picture; [body_plan] image is taken from ship.toml's folder") from None
    except OSError as error:
        raise PictureError(f"{path}: cannot be read ({error.strerror}); give an image file") from None
    if not content:
        raise PictureError(f"{path}: the file is empty; give a {KINDS}")
    if is_pdf(content):
        return render_page(content, page, str(path))
    if not _is_whole(content):
        raise PictureError(
            f"{path}: the file is damaged or cut short ({len(content)} bytes); copy it again from where it came from"
        )
    orientation = _check_header(content, page, str(path))
    image = _decoded(content, page)
    if image is None:
        raise PictureError(
            f"{path}: the image cannot be decoded ({len(content)} bytes): damaged, cut short or of a rare kind; copy "
            "it again from where it came from, or save it as PNG"
        )
    del content
    return _upright(_to_grey(image), orientation)


def _check_header(content: bytes, page: int, name: str) -> int:
    """Refuse what is no image, what has no such page and what has a wrong size, before it is decoded.

    Returns:
        the EXIF orientation that is left to us; 1 for none.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            image = Image.open(io.BytesIO(content))
            kind = image.format
            pages = int(getattr(image, "n_frames", 1))
            if 1 <= page <= pages and page > 1:
                image.seek(page - 1)
            width, height = image.size
            # OpenCV turns TIFF files by itself
            orientation = 1 if kind == "TIFF" else int(image.getexif().get(ORIENTATION, 1))
    except (Image.DecompressionBombWarning, Image.DecompressionBombError):
        raise PictureError(_too_large(name, "the picture")) from None
    except UnidentifiedImageError:
        raise PictureError(
            f"{name}: no image that can be decoded ({len(content)} bytes), or its beginning is damaged; give a {KINDS}"
        ) from None
    except (OSError, SyntaxError, ValueError, struct.error):
        raise PictureError(
            f"{name}: the file is damaged or cut short ({len(content)} bytes); copy it again from where it came from"
        ) from None
    if page > pages:
        raise PictureError(
            f"{name}: has {pages} page{'s' if pages > 1 else ''}, but [body_plan] page = {page}; give one of them"
        )
    if height * width < SMALLEST_PX:
        raise PictureError(
            f"{name}: {width} x {height} px is too small to tell stations apart ({SMALLEST_PX / 1e6:g} Mpx is the "
            "least); scan or export it at 2000 px width or more"
        )
    if height * width > LARGEST_PX:
        raise PictureError(_too_large(name, f"{width} x {height} px"))
    return orientation


def _too_large(name: str, size: str) -> str:
    return (
        f"{name}: {size} is more than {LARGEST_PX // 1_000_000} Mpx; cut the body plan out or scale it to about "
        "3600 px width"
    )


def _is_whole(content: bytes) -> bool:
    """Whether a PNG file has every chunk with its checksum and a JPEG file its end; others are left to their decoder.

    Decoders write complaints of these two to the standard error stream past every log level, or fill in grey.
    """
    if content.startswith(b"\xff\xd8"):
        return content.rfind(b"\xff\xd9") > content.rfind(b"\xff\xda")
    if not content.startswith(PNG):
        return True
    at, view = len(PNG), memoryview(content)
    while at + 12 <= len(content):
        size, kind = struct.unpack_from(">I4s", content, at)
        end = at + 8 + size
        if end + 4 > len(content) or struct.unpack_from(">I", content, end)[0] != zlib.crc32(view[at + 4 : end]):
            return False
        if kind == b"IEND":
            return True
        at = end + 4
    return False


def _decoded(content: bytes, page: int) -> NDArray[Any] | None:
    """The image in its own depth and channels; None where it cannot be decoded."""
    data = np.frombuffer(content, dtype=np.uint8)
    level = cv2.utils.logging.setLogLevel(cv2.utils.logging.LOG_LEVEL_SILENT)
    try:
        if page == 1:
            return cv2.imdecode(data, cv2.IMREAD_UNCHANGED)
        done, pages = cv2.imdecodemulti(data, cv2.IMREAD_UNCHANGED, range=(page - 1, page))
        return pages[0] if done and pages else None
    except cv2.error:
        return None
    finally:
        cv2.utils.logging.setLogLevel(level)


def _to_grey(image: NDArray[Any]) -> Picture:
    """The darkest channel over white paper, some rows at a time; of light lines on dark ground the negative."""
    if image.dtype not in (np.uint8, np.uint16):
        numbers = np.nan_to_num(image.astype(np.float32))
        lowest, highest = float(numbers.min()), float(numbers.max())
        image = (255 * (numbers - lowest) / max(highest - lowest, 1e-12)).astype(np.uint8)
    # 16 bits may hold 10, 12 or 14 that count
    shift = max(0, int(image.max()).bit_length() - 8)
    channels = 1 if image.ndim == 2 else image.shape[2]
    sample = image[::SAMPLE, ::SAMPLE]
    opaque = channels in (1, 3) or bool((sample[..., -1] >> shift == 255).all())
    lightest = sample if channels == 1 else sample[..., : min(3, channels)].max(axis=2)
    negative = opaque and float(np.median(lightest >> shift)) < DARK_GROUND
    grey = np.empty(image.shape[:2], dtype=np.uint8)
    for first in range(0, len(image), BAND_ROWS):
        rows = slice(first, first + BAND_ROWS)
        part = image[rows]
        if shift:
            part = (part >> shift).astype(np.uint8)
        if negative:
            grey[rows] = 255 - (part if part.ndim == 2 else part[..., :3].max(axis=2))
        elif channels in (2, 4):
            colour, alpha = part[..., :-1].min(axis=2).astype(np.uint16), part[..., -1].astype(np.uint16)
            grey[rows] = (colour * alpha + 255 * (255 - alpha)) // 255
        else:
            grey[rows] = part if part.ndim == 2 else part.min(axis=2)
    return grey


def _upright(grey: Picture, orientation: int) -> Picture:
    transpose, up_down, left_right = TURNS.get(orientation, (False, False, False))
    turned = grey.T if transpose else grey
    return np.ascontiguousarray(turned[:: -1 if up_down else 1, :: -1 if left_right else 1])
