"""A straight line as it was drawn, and its place to a few hundredths of a pixel."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.picture.image.ink import Ink

Array = NDArray[np.float64]

LEAST_LENGTH = 0.3  # of the picture's side: a shorter run is no candidate
LEAST_DRAWN = 30.0  # percentile


@dataclass(frozen=True, eq=False)
class StraightLine:
    """A line n = offset + slope * t; t runs along the family (u for horizontal lines, v for vertical ones).

    Attributes:
        start, end: range of t, px.
        width: px between the points where the ink falls to 40 %.
        profile: median ink across the line at `profile_at` px from its axis.
    """

    vertical: bool
    offset: float
    slope: float
    start: float
    end: float
    width: float
    profile_at: Array
    profile: Array

    def at(self, t: float | Array) -> Array:
        """The position across, px."""
        return np.asarray(self.offset + self.slope * np.asarray(t, dtype=np.float64))

    @property
    def length(self) -> float:
        """px."""
        return self.end - self.start

    @property
    def weight(self) -> float:
        """Ink across the line, px: how boldly it was drawn."""
        return float(np.trapezoid(self.profile, self.profile_at))


def crossing(vertical: StraightLine, horizontal: StraightLine) -> tuple[float, float]:
    """The pixel (u, v) where a vertical and a horizontal line meet."""
    u = (vertical.offset + vertical.slope * horizontal.offset) / (1 - vertical.slope * horizontal.slope)
    return u, horizontal.offset + horizontal.slope * u


def _across(ink: Ink, centre: Array, t: Array, reach: Array, vertical: bool) -> Array:
    """Ink on cross-sections (len(t), len(reach)) of a line."""
    n = (centre[:, None] + reach).astype(np.float32)
    tt = np.repeat(t[:, None], len(reach), 1).astype(np.float32)
    u, v = (n, tt) if vertical else (tt, n)
    return np.asarray(cv2.remap(ink, u, v, cv2.INTER_LINEAR), dtype=np.float64)


def refine_line(
    ink: Ink, offset: float, slope: float, vertical: bool, window: float, turns: bool = True
) -> StraightLine | None:
    """Fit a line through the ink centroids of its cross-sections (robust, Tukey weights) and find its run.

    Args:
        ink: (rows, columns) map of ink.
        offset, slope: about where it lies.
        vertical: its family.
        window: how far to either side, px.
        turns: whether the slope is fitted too.

    Returns:
        the line; None where no long one is drawn there.
    """
    side = ink.shape[0 if vertical else 1]
    t = np.linspace(0, side - 1, 600)
    for reach_px in (window, max(2.5, window / 2)):
        reach = np.arange(-np.ceil(reach_px), np.ceil(reach_px) + 0.01, 0.5)
        section = _across(ink, offset + slope * t, t, reach, vertical)
        seen = section.max(axis=1) > 0.12
        if seen.sum() < LEAST_LENGTH * 0.8 * t.size:
            return None
        power = section**2
        centre = offset + slope * t + (power @ reach) / np.maximum(power.sum(axis=1), 1e-9)
        weights = seen.astype(np.float64)
        design = np.column_stack([np.ones_like(t), t])[:, : 2 if turns else 1]
        fixed = 0.0 if turns else slope * t
        for _ in range(12):
            root = np.sqrt(weights)
            fit = np.linalg.lstsq(design * root[:, None], (centre - fixed) * root, rcond=None)[0]
            residual = centre - fixed - design @ fit
            scale = 1.4826 * float(np.median(np.abs(residual[seen]))) + 0.05
            weights = seen * np.clip(1 - (residual / (4 * scale)) ** 2, 0, 1) ** 2
        offset, slope = float(fit[0]), float(fit[1]) if turns else slope
    reach = np.arange(-9, 9.01, 0.5)
    section = _across(ink, offset + slope * t, t, reach, vertical)
    middle = len(reach) // 2
    present = section[:, middle - 1 : middle + 2].max(axis=1) > 0.10
    run = _longest_run(present, largest_gap=round(0.03 * t.size))
    if run is None or present[run[0] : run[1]].mean() < 0.5:
        return None
    on_line = np.zeros_like(present)
    on_line[run[0] : run[1]] = True
    # stations run along a ship's side for a part of its height: its own ink is where least is drawn
    usual = LEAST_DRAWN if vertical else 50.0
    profile = _unimodal(np.percentile(section[present & on_line], usual, axis=0), middle)
    width = 0.5 * float(np.sum(profile > 0.4 * profile.max()))
    return StraightLine(vertical, offset, slope, float(t[run[0]]), float(t[run[1] - 1]), width, reach, profile)


def _longest_run(present: NDArray[np.bool_], largest_gap: int) -> tuple[int, int] | None:
    """[first, last + 1) of the longest run, its ends trimmed where less than half is drawn (labels)."""
    where = np.flatnonzero(present)
    if where.size < LEAST_LENGTH * 0.8 * present.size:
        return None
    runs = np.split(where, np.flatnonzero(np.diff(where) > largest_gap) + 1)
    run = max(runs, key=lambda r: int(r[-1] - r[0]))
    first, last = int(run[0]), int(run[-1]) + 1
    probe, step = 16, 4
    while last - first > 60 and present[first : first + probe].mean() < 0.6:
        first += step
    while last - first > 60 and present[last - probe : last].mean() < 0.6:
        last -= step
    return first, last


def _unimodal(profile: Array, middle: int) -> Array:
    """Cut what lies beyond the first blank on either side of the line: it belongs to a neighbour."""
    out = np.where(profile < 0.06, 0.0, profile)
    blank = np.flatnonzero(out == 0)
    left, right = blank[blank < middle], blank[blank > middle]
    if left.size:
        out[: left[-1]] = 0
    if right.size:
        out[right[0] :] = 0
    return out
