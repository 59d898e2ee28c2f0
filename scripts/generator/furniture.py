"""What stands on a sheet beside the body plan: a title block, a table of offsets, hatched structure."""

from __future__ import annotations

import numpy as np

from generator.canvas import Canvas
from generator.plan import Plan
from generator.sections import Dimensions

_THIN_PX = 1.0


def draw_title(canvas: Canvas, margin: float, text_px: float, line_px: float) -> None:
    """Draw a title block at the lower right and a border round the sheet."""
    edge = 0.25 * margin
    right, bottom = canvas.width - edge, canvas.height - edge
    border = np.array([[edge, edge], [right, edge], [right, bottom], [edge, bottom], [edge, edge]])
    canvas.line(border, max(_THIN_PX, line_px))
    high, wide = 0.075 * canvas.width, 0.30 * canvas.width
    top = bottom - high
    canvas.line(np.array([[right - wide, bottom], [right - wide, top], [right, top]]), max(_THIN_PX, line_px))
    for n, words in enumerate(("BODY PLAN", "SCALE 1:100  MOULDED", "DRAWN  CHECKED  DATE")):
        v = top + (n + 0.5) * high / 3
        canvas.text(words, right - wide / 2, v, 1.2 * text_px if n == 0 else 0.9 * text_px)
        if n:
            canvas.line(np.array([[right - wide, v - high / 6], [right, v - high / 6]]), _THIN_PX)


def draw_table(canvas: Canvas, plan: Plan, top: float, margin: float, text_px: float, line_px: float) -> None:
    """Draw a small table of half-breadths below the drawing, at the left."""
    main = plan.dimensions
    stations = plan.stations[:7]
    left, wide, high = margin, 0.055 * canvas.width, 1.7 * text_px
    heights = np.linspace(0.25, 1.0, 4) * main.depth_m
    rows, columns = len(heights) + 1, len(stations) + 1
    first = top + 0.03 * canvas.width
    for n in range(rows + 1):
        v = first + n * high
        canvas.line(np.array([[left, v], [left + columns * wide, v]]), max(_THIN_PX, 0.6 * line_px))
    for n in range(columns + 1):
        u = left + n * wide
        canvas.line(np.array([[u, first], [u, first + rows * high]]), max(_THIN_PX, 0.6 * line_px))
    for n, station in enumerate(stations, 1):
        canvas.text(station.name, left + (n + 0.5) * wide, first + 0.5 * high, 0.8 * text_px)
        for m, height in enumerate(heights, 1):
            y = float(np.interp(height, station.curves[-1][:, 1], station.curves[-1][:, 0]))
            canvas.text(f"{y:.3f}", left + (n + 0.5) * wide, first + (m + 0.5) * high, 0.7 * text_px)
    for m, height in enumerate(heights, 1):
        canvas.text(f"WL {height:.1f}", left + 0.5 * wide, first + (m + 0.5) * high, 0.7 * text_px)


def draw_hatching(
    canvas: Canvas,
    centre_px: float,
    base_px: float,
    main: Dimensions,
    px_per_m: float,
    line_px: float,
    random: np.random.Generator,
) -> None:
    """Hatch a band under the base line, as the keel and its blocks are drawn."""
    reach = random.uniform(0.15, 0.5) * main.breadth_m / 2 * px_per_m
    deep, step = 0.012 * canvas.width, 0.008 * canvas.width
    top = base_px + max(4.0, 2 * line_px)
    for u in np.arange(centre_px - reach, centre_px + reach, step):
        canvas.line(np.array([[u, top + deep], [u + deep, top]]), _THIN_PX)
