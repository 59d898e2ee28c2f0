"""The words that are written on a picture, read by a program for printed text where one is installed.

It is the optional extra `ocr`: rapidocr, whose networks come with it, so that nothing is fetched when it runs.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import cv2
import numpy as np

from hullform.picture.ink import Picture

SEARCHED_SIDE_PX = 1400  # of the picture in which words are looked for; they are read in the whole one
LARGEST_SIDE_PX = 4000  # of what is read: a larger picture is reduced
LEAST_CONFIDENCE = 0.6  # of a word: less sure ones are pieces of curves as often as not


@dataclass(frozen=True)
class Label:
    """A word and its box, in px of the picture that was read: u right, v down."""

    text: str
    confidence: float
    left_px: float
    top_px: float
    right_px: float
    bottom_px: float

    @property
    def height_px(self) -> float:
        """Of the letters, about."""
        return self.bottom_px - self.top_px


def can_read_labels() -> bool:
    """Whether the extra `ocr` is installed."""
    return find_spec("rapidocr") is not None and find_spec("onnxruntime") is not None


def read_labels(grey: Picture) -> tuple[Label, ...]:
    """All words on a picture, from the top down; the extra `ocr` must be installed.

    Args:
        grey: (rows, columns) 8-bit.
    """
    scale = min(1.0, LARGEST_SIDE_PX / max(grey.shape))
    if scale < 1:
        grey = np.asarray(cv2.resize(grey, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA), dtype=np.uint8)
    found = _reader()(cv2.cvtColor(grey, cv2.COLOR_GRAY2BGR), use_cls=False)
    if found.boxes is None:
        return ()
    labels = []
    for corners, text, confidence in zip(found.boxes, found.txts, found.scores, strict=True):
        (left, top), (right, bottom) = np.min(corners, axis=0) / scale, np.max(corners, axis=0) / scale
        if confidence >= LEAST_CONFIDENCE and text.strip():
            box = (float(left), float(top), float(right), float(bottom))
            labels.append(Label(text.strip(), float(confidence), *box))
    return tuple(sorted(labels, key=lambda label: (label.top_px, label.left_px)))


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
