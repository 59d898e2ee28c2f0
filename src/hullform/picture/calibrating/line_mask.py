"""The ink without the straight lines, and where they lie."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hullform.picture.calibrating.straight_line import StraightLine
from hullform.picture.image.ink import Ink

Mask = NDArray[np.uint8]

VERTICAL, HORIZONTAL, BOLD = 1, 2, 4  # bits of the mask
FAINT_LINE = 0.6  # ink of a line's axis: through a fainter one the curves that cross it can be seen


def subtract_lines(ink: Ink, lines: list[StraightLine]) -> tuple[Ink, Mask]:
    """The ink without the lines, and a mask of where they lie (bit 1 vertical, bit 2 horizontal, bit 4 a bold one).

    Each line's own profile, a little enlarged, is taken off, so that a curve that crosses a grey line stays.
    """
    out = ink.copy()
    mask = np.zeros(ink.shape, np.uint8)
    for line in lines:
        t = np.arange(max(0, int(line.start) - 4), min(ink.shape[0 if line.vertical else 1], int(line.end) + 5))
        centre = line.at(t)
        reach = np.arange(-9, 10)
        n = np.round(centre)[:, None].astype(np.int64) + reach
        offset = n - centre[:, None]
        inside = (n >= 0) & (n < ink.shape[1 if line.vertical else 0])
        tt = np.broadcast_to(t[:, None], n.shape)
        rows, columns = (tt[inside], n[inside]) if line.vertical else (n[inside], tt[inside])
        out[rows, columns] -= (1.12 * np.interp(offset[inside], line.profile_at, line.profile)).astype(np.float32)
        covered = np.abs(offset[inside]) <= line.width / 2 + 1.2
        bold = BOLD if float(line.profile.max()) > FAINT_LINE else 0
        mask[rows[covered], columns[covered]] |= (VERTICAL if line.vertical else HORIZONTAL) | bold
    return np.clip(out, 0, 1), mask
