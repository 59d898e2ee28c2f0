"""The body plan as a drawing office would print it, with its true calibration."""

from __future__ import annotations

from io import BytesIO
from typing import TYPE_CHECKING, NamedTuple

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from drawing.labels import Label, place_labels
from drawing.moulded import Moulded

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

PAPER = "#fcfbf7"
CURVE = "#101010"
GRID = "#9a9a9a"
FRAME = "#606060"
TEXT = "#202020"
FONT = "DejaVu Sans"


class Drawing(NamedTuple):
    """A drawn body plan (uint8, height x width x 3) and its calibration; pixel centres lie at integers."""

    image: NDArray[np.uint8]
    centreline_px: float
    baseline_px: float
    metres_per_px: float


class Sheet(NamedTuple):
    """Where the drawing lies on its sheet: u = centreline + y / scale, v = baseline - z / scale."""

    width: int
    height: int
    centreline: float
    baseline: float
    metres_per_px: float

    def u(self, y: Array | float) -> Array:
        """Return pixels to the right for y in m, positive in the right half."""
        return np.asarray(self.centreline + np.asarray(y) / self.metres_per_px)

    def v(self, z: Array | float) -> Array:
        """Return pixels down for z in m."""
        return np.asarray(self.baseline - np.asarray(z) / self.metres_per_px)


def draw(
    outline: Moulded,
    width_px: int = 2000,
    curve_px: float = 2.2,
    grid_px: float = 1.0,
    label_seed: int = 0,
) -> Drawing:
    """Draw a body plan, aft half left and fore half right.

    Arguments: the sheet's width, the line thickness of stations and of the grid (px), and a seed that moves the
    station numbers to other places (0: at the upper ends wherever there is room).
    """
    sheet = _sheet(outline, width_px)
    curves = _curves(outline, sheet)
    with mpl.rc_context({"path.simplify": False, "font.family": FONT, "path.snap": False}):
        figure = Figure(figsize=(sheet.width / 72.0, sheet.height / 72.0), dpi=72, facecolor=PAPER)
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        axes.set_axis_off()
        axes.set_xlim(-0.5, sheet.width - 0.5)
        axes.set_ylim(sheet.height - 0.5, -0.5)
        _draw_grid(axes, outline, sheet, grid_px)
        _draw_sheer(axes, outline, sheet, grid_px)
        size = 0.0082 * width_px
        margin = _margin(outline, sheet)
        # the number of a station of two curves stands at the upper one, which ends at the deck
        numbered = [(label, station[-1]) for label, station in curves]
        others = [curve for _, station in curves for curve in station[:-1]]
        for label in place_labels(numbered, _sheer_line(outline, sheet) + others, margin, size, label_seed):
            _draw_label(axes, label, size, curve_px)
        for points in (curve for _, station in curves for curve in station):
            axes.plot(*points.T, color=CURVE, lw=curve_px, zorder=5, solid_joinstyle="round", snap=False)
        _draw_title(axes, outline, sheet)
        pixels = BytesIO()
        figure.savefig(pixels, format="rgba", dpi=72)
    image = np.frombuffer(pixels.getvalue(), dtype=np.uint8).reshape(sheet.height, sheet.width, 4)[:, :, :3]
    return Drawing(image, sheet.centreline, sheet.baseline, sheet.metres_per_px)


def _sheet(outline: Moulded, width_px: int) -> Sheet:
    main = outline.particulars
    scale = main.breadth_m / (0.83 * width_px)
    highest = max(outline.deck_edge(x)[1] for _, x in main.aft_stations + main.fore_stations)
    above, below = 0.055 * width_px, 0.105 * width_px
    height = round(above + highest / scale + below)
    return Sheet(width_px, height, 0.5 * (width_px - 1), above + highest / scale, scale)


def _curves(outline: Moulded, sheet: Sheet) -> list[tuple[str, list[Array]]]:
    """Return labels and curves in pixels, keel to deck; stations of one shape (a parallel body) are drawn once."""
    curves: list[tuple[str, list[Array]]] = []
    for sign, stations in ((-1.0, outline.particulars.aft_stations), (1.0, outline.particulars.fore_stations)):
        shapes: list[tuple[list[Array], list[str]]] = []
        for name, x in stations:
            section = outline.curves(x, 900)
            twin = next((names for known, names in shapes if _same(known, section)), None)
            if twin is None:
                shapes.append((section, [name]))
            else:
                twin.append(name)
        for section, names in shapes:
            label = names[0] if len(names) == 1 else f"{names[0]}-{names[-1]}"
            curves.append(
                (label, [np.column_stack([sheet.u(sign * y), sheet.v(z)]) for y, z in (c.T for c in section)])
            )
    return curves


def _same(left: list[Array], right: list[Array]) -> bool:
    return len(left) == len(right) and all(np.allclose(a, b, atol=1e-6) for a, b in zip(left, right, strict=True))


def _sheer_line(outline: Moulded, sheet: Sheet) -> list[Array]:
    """Return the deck edge at side in both halves, from the ends to midships, in pixels."""
    main = outline.particulars
    midships = main.aft_perpendicular_m + 0.5 * main.length_between_perpendiculars_m
    lines = []
    for sign, end in ((-1.0, 0.0), (1.0, main.length_overall_m)):
        edge = np.array([outline.deck_edge(x) for x in end + (midships - end) * np.linspace(0.0, 1.0, 400) ** 2])
        lines.append(np.column_stack([sheet.u(sign * edge[:, 0]), sheet.v(edge[:, 1])]))
    return lines


def _margin(outline: Moulded, sheet: Sheet) -> NDArray[np.bool_]:
    """Return the part of the sheet beside and below the box of B and D, where figures of the grid stand."""
    half, depth = 0.5 * outline.particulars.breadth_m, outline.particulars.depth_m
    left, right = int(sheet.u(-half)), int(sheet.u(half)) + 1
    margin = np.zeros((sheet.height, sheet.width), dtype=bool)
    margin[int(sheet.v(depth)) - 1 :, :left] = True
    margin[int(sheet.v(depth)) - 1 :, right:] = True
    margin[int(sheet.baseline) :, :] = True
    return margin


def _draw_grid(axes: Axes, outline: Moulded, sheet: Sheet, grid_px: float) -> None:
    main = outline.particulars
    half, step = 0.5 * main.breadth_m, main.line_spacing_m
    highest = max(outline.deck_edge(x)[1] for _, x in main.aft_stations + main.fore_stations)
    reach = half + 0.012 * main.breadth_m
    size = 0.0075 * sheet.width

    def horizontal(z: float, name: str, colour: str, width: float) -> None:
        axes.plot(sheet.u(np.array([-reach, reach])), sheet.v(np.array([z, z])), color=colour, lw=width, snap=False)
        for side in (-1.0, 1.0):
            axes.text(
                float(sheet.u(side * (reach + 0.004 * main.breadth_m))),
                float(sheet.v(z)),
                name,
                size=size,
                color=TEXT,
                ha="right" if side < 0 else "left",
                va="center_baseline",
            )

    def vertical(y: float, name: str, colour: str, width: float) -> None:
        foot = -0.008 * main.breadth_m
        top = main.depth_m if abs(y) == half else highest
        axes.plot(sheet.u(np.array([y, y])), sheet.v(np.array([foot, top])), color=colour, lw=width, snap=False)
        place = float(sheet.v(foot)) + 0.3 * size
        axes.text(float(sheet.u(y)), place, name, size=size, color=TEXT, ha="center", va="top")

    for z in np.arange(step, main.depth_m - 0.3 * step, step):
        crowded = abs(z - main.draught_m) / sheet.metres_per_px < 1.3 * size
        horizontal(float(z), "" if crowded else f"{z:g}", GRID, grid_px)
    for y in np.arange(step, half - 0.3 * step, step):
        crowded = (half - y) / sheet.metres_per_px < 4.0 * size
        for side in (-1.0, 1.0):
            vertical(float(side * y), "" if crowded else f"{y:g}", GRID, grid_px)
    horizontal(main.draught_m, f"DWL {main.draught_m:g}", FRAME, 1.5 * grid_px)
    if main.depth_m > main.draught_m:
        horizontal(main.depth_m, f"D {main.depth_m:g}", FRAME, 1.2 * grid_px)
    horizontal(0.0, "BL", CURVE, 1.5 * grid_px)
    vertical(0.0, "CL", CURVE, 1.5 * grid_px)
    for side in (-1.0, 1.0):
        vertical(side * half, f"B/2 {half:g}", FRAME, 1.2 * grid_px)


def _draw_sheer(axes: Axes, outline: Moulded, sheet: Sheet, grid_px: float) -> None:
    for line in _sheer_line(outline, sheet):
        axes.plot(*line.T, color=FRAME, lw=grid_px, zorder=4, snap=False)


def _draw_label(axes: Axes, label: Label, size: float, curve_px: float) -> None:
    halo = {"boxstyle": "square,pad=0.12", "facecolor": PAPER, "edgecolor": "none"}
    axes.text(label.u, label.v, label.text, size=size, color=TEXT, ha="center", va="center", zorder=4.5, bbox=halo)
    if label.leader is not None:
        axes.plot(*label.leader.T, color=FRAME, lw=0.4 * curve_px, zorder=3, snap=False)


def _draw_title(axes: Axes, outline: Moulded, sheet: Sheet) -> None:
    main = outline.particulars
    w = sheet.width
    middle = sheet.baseline + 0.062 * w
    left = float(sheet.u(-0.5 * main.breadth_m))
    axes.text(
        left, middle, f"{main.title.upper()}   BODY PLAN", size=0.0125 * w, color=TEXT, weight="bold", va="center"
    )
    figures = (
        f"LOA {main.length_overall_m:g} m    LPP {main.length_between_perpendiculars_m:g} m    "
        f"B {main.breadth_m:g} m    D {main.depth_m:g} m    T {main.draught_m:g} m"
    )
    axes.text(left, middle + 0.0185 * w, figures, size=0.0085 * w, color=TEXT, va="center")
    _draw_scale_bar(axes, sheet, 5.0 * main.line_spacing_m, float(sheet.u(0.5 * main.breadth_m)), middle)


def _draw_scale_bar(axes: Axes, sheet: Sheet, length_m: float, right: float, v: float) -> None:
    part = length_m / 5.0 / sheet.metres_per_px
    left = right - 5.0 * part
    tall = 0.004 * sheet.width
    for n in range(5):
        colour = CURVE if n % 2 == 0 else PAPER
        corners = left + part * np.array([n, n + 1, n + 1, n])
        axes.fill(corners, v + tall * np.array([0, 0, 1, 1]), facecolor=colour, edgecolor=CURVE, lw=1.0)
    for n in range(6):
        text = f"{n * length_m / 5.0:g}" + (" m" if n == 5 else "")
        axes.text(
            left + n * part, v + 3.6 * tall, text, size=0.0075 * sheet.width, color=TEXT, ha="center", va="center"
        )
    note = "moulded, metres; aft half left, fore half right"
    axes.text(right, v - 1.8 * tall, note, size=0.007 * sheet.width, color=TEXT, ha="right", va="center")
