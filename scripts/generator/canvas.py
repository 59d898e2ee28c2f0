"""A sheet drawn several times too large and then averaged, so that a line lies where its coordinates say."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Image = NDArray[np.uint8]
Colour = tuple[int, int, int]

BLACK: Colour = (0, 0, 0)
_SHIFT = 6  # bits of a fraction in cv2's coordinates
_FONT = cv2.FONT_HERSHEY_SIMPLEX
_CAPITAL = 21.0  # height of a capital of that font at scale 1, px


class Canvas:
    """A white sheet; coordinates are pixels of the finished picture, centres at integers, u right, v down."""

    def __init__(self, width: int, height: int, coloured: bool) -> None:
        """Make a sheet of this size, px; grey sheets take a third of the memory."""
        self.width, self.height = width, height
        self._times = 4 if width <= 2000 else 3 if width <= 3200 else 2
        shape = (height * self._times, width * self._times)
        self._image: Image = np.full((*shape, 3) if coloured else shape, 255, np.uint8)
        self._coloured = coloured

    def line(
        self, points: Array, width_px: float, colour: Colour = BLACK, dash_px: tuple[float, float] | None = None
    ) -> None:
        """Draw a polyline (n, 2), its axis through the points; dashes are (mark, gap) along it."""
        pieces = [points] if dash_px is None else dashes(points, *dash_px)
        fixed = [np.round(self._fine(p) * 2**_SHIFT).astype(np.int32) for p in pieces if len(p) > 1]
        cv2.polylines(
            self._image, fixed, False, self._value(colour), max(1, round(width_px * self._times)), cv2.LINE_AA, _SHIFT
        )

    def area(self, points: Array, colour: Colour) -> None:
        """Fill a polygon."""
        fixed = np.round(self._fine(points) * 2**_SHIFT).astype(np.int32)
        cv2.fillPoly(self._image, [fixed], self._value(colour), cv2.LINE_AA, _SHIFT)

    def text(
        self, words: str, u: float, v: float, height_px: float, colour: Colour = BLACK, weight: float = 0.13
    ) -> None:
        """Write words centred on a place; `weight` is the stroke's share of the height."""
        scale = height_px * self._times / _CAPITAL
        thick = max(1, round(weight * height_px * self._times))
        (wide, high), _ = cv2.getTextSize(words, _FONT, scale, thick)
        place = self._fine(np.array([[u, v]]))[0] + (-wide / 2, high / 2)
        corner = (round(float(place[0])), round(float(place[1])))
        cv2.putText(self._image, words, corner, _FONT, scale, self._value(colour), thick, cv2.LINE_AA)

    def finished(self) -> Image:
        """Return the picture at its size."""
        return np.asarray(cv2.resize(self._image, (self.width, self.height), interpolation=cv2.INTER_AREA), np.uint8)

    def _fine(self, points: Array) -> Array:
        return (np.asarray(points, dtype=np.float64) + 0.5) * self._times - 0.5

    def _value(self, colour: Colour) -> tuple[int, ...]:
        return colour if self._coloured else (round(sum(colour) / 3),)


def text_width(words: str, height_px: float) -> float:
    """Return how wide words are that are so high, px."""
    (wide, _), _ = cv2.getTextSize(words, _FONT, 4.0, 1)
    return float(wide) / 4.0 * height_px / _CAPITAL


def dashes(points: Array, mark_px: float, gap_px: float) -> list[Array]:
    """Cut a polyline into marks with gaps between."""
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    pieces = []
    for start in np.arange(0.0, arc[-1], mark_px + gap_px):
        end = min(start + mark_px, arc[-1])
        inner = arc[(arc > start) & (arc < end)]
        at = np.concatenate([[start], inner, [end]])
        pieces.append(np.column_stack([np.interp(at, arc, points[:, k]) for k in (0, 1)]))
    return pieces
