"""Pages of PDF files as pictures; the reader of PDF files is an optional extra."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from hullform.errors import PictureError

Picture = NDArray[np.uint8]

PAGE_WIDTH_PX = 3600  # lines of 0.1 mm on a page of A4 get 1.7 px, and nothing is gained by more
LARGEST_ROWS = 8000  # of a page much taller than wide
HEAD = 1024  # bytes among which a PDF's mark may stand


def is_pdf(content: bytes) -> bool:
    """Whether a file's content is a PDF's."""
    return b"%PDF-" in content[:HEAD]


def render_page(content: bytes, page: int, name: str) -> Picture:
    """Draw one page as 8-bit grey, 3600 px wide, on white paper.

    Args:
        content: of the PDF file.
        page: from 1.
        name: what to call the file in an error.

    Returns:
        (rows, columns) grey.

    Raises:
        PictureError: the extra `pdf` is not installed; a damaged or locked file; no such page.
    """
    try:
        import pypdfium2
    except ImportError:
        raise PictureError(
            f"{name}: PDF files are read with the extra 'pdf', which is not installed: "
            "python -m pip install 'hullform[pdf]'; or save the page as PNG at 3600 px width"
        ) from None
    try:
        document = pypdfium2.PdfDocument(content)
    except pypdfium2.PdfiumError as error:
        raise PictureError(
            f"{name}: the PDF cannot be opened ({error}); it is damaged or locked with a password: save it anew without"
        ) from None
    try:
        if page > len(document):
            pages = f"{len(document)} page{'s' if len(document) > 1 else ''}"
            raise PictureError(f"{name}: has {pages}, but [body_plan] page = {page}; give one of them")
        return _drawn(document[page - 1])
    finally:
        document.close()


def _drawn(sheet: Any) -> Picture:
    width_pt, height_pt = sheet.get_size()
    # the renderer rounds up to whole pixels
    scale = min((PAGE_WIDTH_PX - 0.5) / width_pt, (LARGEST_ROWS - 0.5) / height_pt)
    # three channels: the darkest keeps coloured lines dark, which a grey rendering would not
    bitmap = sheet.render(scale=scale, fill_color=(255, 255, 255, 255))
    levels = np.asarray(bitmap.to_numpy())
    grey = levels[..., :3].min(axis=2) if levels.ndim == 3 else levels.copy()
    bitmap.close()
    return np.asarray(grey, dtype=np.uint8)
