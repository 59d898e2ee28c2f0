"""The words that are written on a picture, read by a program for printed text where one is installed.

It is the optional extra `ocr`: rapidocr, whose networks come with it, so that nothing is fetched when it runs.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.image.image_files import Picture
from hullform.station_names import number_of

Array = NDArray[np.float64]

SEARCHED_SIDE_PX = 1400  # of the picture in which words are looked for; they are read in the whole one
LARGEST_SIDE_PX = 4000  # of what is read: a larger picture is reduced
BETWEEN = re.compile(r"[^\s/|=\\]+")  # strokes and spaces part words
TWICE = re.compile(r"(½(?=2)|[¼¾](?=4))\d")  # a fraction that is read as one sign and its denominator again
LEAST_CONFIDENCE = 0.8  # of a word: less sure ones are pieces of curves as often as not


@dataclass(frozen=True)
class Label:
    """A word, the centre of its box, and its width and height, px of the picture that was read: u right, v down."""

    text: str
    confidence: float
    centre_px: tuple[float, float]
    width_px: float
    height_px: float


def can_read_labels() -> bool:
    """Whether the extra `ocr` is installed."""
    return find_spec("rapidocr") is not None and find_spec("onnxruntime") is not None


def read_labels(grey: Picture) -> tuple[Label, ...]:
    """All words on a picture; the extra `ocr` must be installed.

    Args:
        grey: (rows, columns) 8-bit.
    """
    scale = min(1.0, LARGEST_SIDE_PX / max(grey.shape))
    if scale < 1:
        grey = np.asarray(cv2.resize(grey, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA), dtype=np.uint8)
    found = _reader()(cv2.cvtColor(grey, cv2.COLOR_GRAY2BGR), use_cls=False)
    if found.boxes is None:
        return ()
    labels: list[Label] = []
    for corners, text, confidence in zip(found.boxes, found.txts, found.scores, strict=True):
        if confidence >= LEAST_CONFIDENCE:
            text = TWICE.sub(r"\1", text)
            labels += _words(np.asarray(corners, dtype=np.float64) / scale, text, float(confidence))
    return tuple(labels)


def _words(corners: Array, text: str, confidence: float) -> list[Label]:
    """The words of one line of print, parted where strokes of curves or spaces stand between them.

    Args:
        corners: (4, 2) of the line's box, the upper left first, clockwise.
        text: of the line.
        confidence: of the line.
    """
    start, along = (corners[0] + corners[3]) / 2, (corners[1] + corners[2] - corners[0] - corners[3]) / 2
    high = float(np.hypot(*(corners[3] + corners[2] - corners[0] - corners[1])) / 2)
    parts = [(0, len(text))] if number_of(text) is not None else [m.span() for m in BETWEEN.finditer(text)]
    labels = []
    for first, end in parts:
        centre = start + along * (first + end) / 2 / len(text)
        wide = float(np.hypot(*along)) * (end - first) / len(text)
        labels.append(Label(text[first:end], confidence, (float(centre[0]), float(centre[1])), wide, high))
    return labels


@cache
def _reader() -> Callable[..., Any]:
    reader: Callable[..., Any] = import_module("rapidocr").RapidOCR(
        params={
            "Global.log_level": "error",
            "Global.max_side_len": LARGEST_SIDE_PX,
            "Det.limit_side_len": SEARCHED_SIDE_PX,
            "Det.limit_type": "max",
        }
    )
    return reader
