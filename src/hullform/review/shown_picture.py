"""The picture as a browser can show it: its own file where browsers know the type, else encoded as PNG."""

from __future__ import annotations

from pathlib import Path

import cv2

from hullform.errors import PictureError
from hullform.picture.image.image_files import load_grey

# first bytes of the types that every browser shows
KNOWN = ((b"\x89PNG\r\n\x1a\n", "image/png"), (b"\xff\xd8\xff", "image/jpeg"))


def shown_picture(path: Path, page: int = 1) -> tuple[bytes, str]:
    """The bytes of a picture and their media type.

    Args:
        path: of the picture.
        page: of a file that holds several.

    Raises:
        PictureError: the picture cannot be read.
    """
    try:
        content = path.read_bytes()
    except OSError as error:
        raise PictureError(f"{path}: cannot be read ({error.strerror}); check [body_plan] image") from None
    for start, media_type in KNOWN:
        if content.startswith(start):
            return content, media_type
    done, data = cv2.imencode(".png", load_grey(path, page))
    if not done:
        raise PictureError(f"{path}: cannot be shown; save it as PNG and name that in [body_plan] image")
    return data.tobytes(), "image/png"
