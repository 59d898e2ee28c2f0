"""Curves of few points: as many as a section is fitted to."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_LEAST = 8


def enough_points(line: Array) -> Array:
    """The same polyline (n, 2), its longest pieces halved until it has eight points."""
    while len(line) < _LEAST:
        longest = int(np.argmax(np.hypot(*np.diff(line, axis=0).T)))
        line = np.insert(line, longest + 1, (line[longest] + line[longest + 1]) / 2, axis=0)
    return line
