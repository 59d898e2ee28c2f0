"""Drawings and pictures that are no body plan, as a user may give them by mistake."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
Array = NDArray[np.float64]
INK, GREY = 0, 120


def _paper(rows: int, columns: int) -> Picture:
    return np.full((rows, columns), 255, np.uint8)


def _curve(image: Picture, u: Array, v: Array) -> None:
    points = np.round(np.column_stack([u, v]) * 16).astype(np.int32)
    cv2.polylines(image, [points], False, INK, 2, cv2.LINE_AA, 4)


def text_page() -> Picture:
    """Forty-five lines of words."""
    rng, image = np.random.default_rng(5), _paper(2000, 1500)
    for line in range(45):
        words = "".join(rng.choice(list("abcdefgh ijklmno pqrstuv"), 70))
        cv2.putText(image, words, (100, 120 + 41 * line), cv2.FONT_HERSHEY_COMPLEX, 0.75, INK, 2, cv2.LINE_AA)
    return image


def table() -> Picture:
    """Twenty rows of ten figures between ruled lines."""
    rng, image = np.random.default_rng(6), _paper(1500, 2000)
    for row in range(21):
        cv2.line(image, (100, 100 + 65 * row), (1900, 100 + 65 * row), INK, 2)
    for column in range(11):
        cv2.line(image, (100 + 180 * column, 100), (100 + 180 * column, 1400), INK, 2)
    for row in range(20):
        for column in range(10):
            at = (115 + 180 * column, 148 + 65 * row)
            cv2.putText(image, f"{rng.uniform(0, 30):.3f}", at, cv2.FONT_HERSHEY_SIMPLEX, 1, INK, 2, cv2.LINE_AA)
    return image


def _long_grid(image: Picture, base: int, spacing: int, lines: int) -> None:
    for column in range(11):
        cv2.line(image, (150 + 210 * column, base + 20), (150 + 210 * column, 250), GREY, 1)
    for row in range(1, lines):
        cv2.line(image, (100, base - spacing * row), (2300, base - spacing * row), GREY, 1)
    cv2.line(image, (100, base), (2300, base), INK, 3)


def profile() -> Picture:
    """A side elevation: stem, stern, sheer and buttocks over a base line and stations."""
    image, base = _paper(900, 2400), 700
    _long_grid(image, base, 60, 6)
    t = np.linspace(0, 1, 300)
    _curve(image, 120 + 2180 * t, base - 350 - 60 * (2 * t - 1) ** 2)
    _curve(image, 2210 + 90 * t, base - 410 * t**2)
    _curve(image, 230 - 110 * t, base - 200 - 210 * t)
    for share in (0.2, 0.4, 0.6, 0.8):
        _curve(
            image, 230 + 200 * share + t * (1700 - 400 * share), base - 10 - 330 * np.abs(2 * t - 1) ** (6 - 4 * share)
        )
    return image


def waterlines_plan() -> Picture:
    """A half-breadth plan: waterlines over the centre line and stations."""
    image, base = _paper(900, 2400), 700
    _long_grid(image, base, 90, 5)
    t = np.linspace(0, 1, 400)
    for number in range(1, 9):
        _curve(image, 150 + 2100 * t, base - 390 * (1 - np.abs(2 * t - 1) ** (1.5 + 0.45 * number)) ** 0.6)
    return image


def photograph() -> Picture:
    """A ship on the sea: hull, house, portholes, waves, grain."""
    rng = np.random.default_rng(7)
    sky = np.repeat(200 - 60 * np.linspace(0, 1, 1200)[:, None], 1800, axis=1)
    sky[800:] = 90 + 30 * np.sin(np.arange(1800) / 9)[None] * np.sin(np.arange(400) / 5)[:, None]
    cv2.fillPoly(sky, [np.array([[200, 600], [1650, 560], [1550, 830], [320, 830]])], 50)
    cv2.rectangle(sky, (300, 350), (600, 600), 210, -1)
    for porthole in range(10):
        cv2.circle(sky, (330 + 27 * porthole, 450), 6, 40, -1)
    sky += rng.normal(0, 8, sky.shape)
    return np.asarray(cv2.GaussianBlur(np.clip(sky, 0, 255), (0, 0), 1.2), dtype=np.uint8)


def pale_photograph() -> Picture:
    """The same, over-exposed."""
    return (photograph() // 3 + 165).astype(np.uint8)
