"""The drawing: grid, frame lines, stations, their numbers, and what else stands on such a sheet."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from generator.canvas import BLACK, Canvas, Colour, Image, text_width
from generator.furniture import draw_hatching, draw_table, draw_title
from generator.levels import Level
from generator.plan import Half, Plan, PlanStation
from generator.sections import Array, evenly

_SHARE_OF_WIDTH = (0.37, 0.435)  # of a half-breadth
_SPACINGS_M = (0.25, 0.5, 1.0, 2.0, 2.5, 5.0, 10.0)
_LINES_WANTED = (4, 8)  # buttocks on a half-breadth, waterlines on the depth
_MARGIN = 0.055  # of the width, above and below the drawing
_TEXT = (0.0085, 0.012)  # of the width: height of the figures
_COLOURS: tuple[Colour, ...] = (
    (200, 30, 30),
    (20, 110, 30),
    (30, 60, 200),
    (150, 20, 150),
    (190, 90, 0),
    (0, 120, 130),
)
_GREYS = (150, 205)  # of a grey grid


@dataclass(frozen=True)
class Scale:
    """Where the drawing lies on the sheet: centre line and base line in px, px per metre, and the side of aft."""

    centre_px: float
    base_px: float
    px_per_m: float
    aft_side: int  # -1 left, +1 right

    def px(self, half: Half, curve: Array) -> Array:
        """Return the pixels of points [y, z] of a half."""
        side = self.aft_side if half == "aft" else -self.aft_side
        return np.column_stack(
            [self.centre_px + side * curve[:, 0] * self.px_per_m, self.base_px - curve[:, 1] * self.px_per_m]
        )

    def matrix(self) -> Array:
        """Return the 3 x 3 matrix from (y, z, 1), y negative in the left half, to pixels."""
        k = self.px_per_m
        return np.array([[k, 0.0, self.centre_px], [0.0, -k, self.base_px], [0.0, 0.0, 1.0]])


@dataclass(frozen=True, eq=False)
class Drawing:
    """A finished sheet, its scale, the weight of its lines, and what the pen drew of each station, metres."""

    image: Image
    scale: Scale
    line_px: float
    drawn: tuple[tuple[Array, ...], ...]


def pen_weight(width_px: int, random: np.random.Generator) -> float:
    """Return a line's weight: 1 to 4 px, and B/2 150 to 600 times as long."""
    ratio = np.exp(random.uniform(np.log(150.0), np.log(600.0)))
    return float(np.clip(0.40 * width_px / ratio, 1.0, 4.0))


def draw_sheet(plan: Plan, level: Level, width_px: int, line_px: float, random: np.random.Generator) -> Drawing:
    """Draw a body plan."""
    main = plan.dimensions
    share = random.uniform(*_SHARE_OF_WIDTH)
    top_m = max(float(station.curves[-1][:, 1].max()) for station in plan.stations)
    scale_px = share * width_px / (main.breadth_m / 2)
    margin = _MARGIN * width_px
    title = random.random() < level.title_block
    table = random.random() < level.table
    foot = (0.10 if title else 0.0) * width_px + (0.12 if table else 0.0) * width_px
    height = round(2 * margin + top_m * scale_px + 0.02 * width_px + foot)
    scale = Scale(
        width_px / 2 + random.uniform(-0.01, 0.01) * width_px,
        height - foot - margin + random.uniform(-0.5, 0.5),
        scale_px,
        -1 if random.random() < 0.7 else 1,
    )
    canvas = Canvas(width_px, height, level.coloured or level.photograph)
    text_px = max(8.0, random.uniform(*_TEXT) * width_px)
    if random.random() < level.hatching:
        draw_hatching(canvas, scale.centre_px, scale.base_px, main, scale_px, line_px, random)
    if level.grid:
        _draw_grid(canvas, scale, plan, level, top_m, line_px, text_px, random)
    _draw_frame(canvas, scale, plan, level, top_m, line_px, text_px, random)
    drawn = _draw_stations(canvas, scale, plan, level, line_px, random)
    _draw_numbers(canvas, scale, plan, text_px, line_px, random)
    if title:
        draw_title(canvas, margin, text_px, line_px)
    if table:
        draw_table(canvas, plan, height - foot, margin, text_px, line_px)
    return Drawing(canvas.finished(), scale, line_px, drawn)


def _spacing(length_m: float, random: np.random.Generator) -> float:
    low, high = _LINES_WANTED
    good = [s for s in _SPACINGS_M if low <= length_m / s <= high] or [length_m / 5]
    return float(random.choice(good))


def _draw_grid(
    canvas: Canvas,
    scale: Scale,
    plan: Plan,
    level: Level,
    top_m: float,
    line_px: float,
    text_px: float,
    random: np.random.Generator,
) -> None:
    main = plan.dimensions
    half = main.breadth_m / 2
    grey = int(random.integers(*_GREYS))
    colour: Colour = BLACK if level.grid == "black" else (grey, grey, grey)
    weight = line_px * (random.uniform(0.8, 1.0) if level.grid == "black" else random.uniform(0.5, 0.9))
    weight = max(weight, 1.0)
    dash = (random.uniform(6, 10) * line_px + 6, random.uniform(2.5, 4) * line_px + 3)
    dashed = dash if random.random() < level.dashed_grid else None
    across, up = _spacing(half, random), _spacing(main.depth_m, random)
    reach, over = half * random.uniform(1.02, 1.08), random.uniform(0.0, 0.03) * top_m
    for n in range(1, int(half / across + 1e-6) + 1):
        for side in (-1, 1):
            u = scale.centre_px + side * n * across * scale.px_per_m
            bottom = scale.base_px + over * scale.px_per_m
            canvas.line(np.array([[u, bottom], [u, scale.base_px - top_m * scale.px_per_m]]), weight, colour, dashed)
            canvas.text(f"{n * across:g}", u, bottom + 0.9 * text_px, 0.8 * text_px)
    for n in range(1, int(top_m / up + 1e-6) + 1):
        v = scale.base_px - n * up * scale.px_per_m
        left, right = (scale.centre_px + side * reach * scale.px_per_m for side in (-1, 1))
        canvas.line(np.array([[left, v], [right, v]]), weight, colour, dashed)
        words = f"{n * up:g}"
        beside = 0.3 * text_px + 0.5 * text_width(words, 0.8 * text_px)
        canvas.text(words, right + beside, v, 0.8 * text_px)
        canvas.text(words, left - beside, v, 0.8 * text_px)


def _draw_frame(
    canvas: Canvas,
    scale: Scale,
    plan: Plan,
    level: Level,
    top_m: float,
    line_px: float,
    text_px: float,
    random: np.random.Generator,
) -> None:
    """Draw the lines that belong to no station: centre line, base line, design waterline, box, deck edge, diagonals."""
    main, k = plan.dimensions, scale.px_per_m
    half_px, top_px = main.breadth_m / 2 * k, scale.base_px - top_m * k
    weight = line_px * random.uniform(0.8, 1.0)
    reach = half_px * random.uniform(1.02, 1.08)
    u0, v0 = scale.centre_px, scale.base_px
    canvas.line(np.array([[u0, v0 + 0.015 * canvas.width], [u0, top_px - 0.015 * canvas.width]]), weight)
    canvas.line(np.array([[u0 - reach, v0], [u0 + reach, v0]]), weight)
    canvas.text("CL", u0, v0 + 0.015 * canvas.width + text_px, 0.8 * text_px)
    if random.random() < 0.6:
        v = v0 - main.draught_m * k
        dash = (14 * line_px, 5 * line_px) if random.random() < 0.3 else None
        canvas.line(np.array([[u0 - reach, v], [u0 + reach, v]]), weight, BLACK, dash)
        canvas.text("DWL", u0 - reach + text_px, v - 0.8 * text_px, 0.7 * text_px)
    if random.random() < 0.5:
        for side in (-1, 1):
            u = u0 + side * half_px
            canvas.line(np.array([[u, v0 + 0.01 * canvas.width], [u, top_px]]), max(1.0, 0.7 * weight))
    if random.random() < level.deck_line:
        for half, edge in plan.sheer.items():
            canvas.line(scale.px(half, edge), weight)
    if random.random() < level.diagonals:
        for share in random.uniform(0.45, 1.05, int(random.integers(1, 4))):
            rise = share * main.depth_m * k
            run = min(rise, half_px)
            for side in (-1, 1):
                ends = np.array([[u0, v0 - rise], [u0 + side * run, v0 - rise + run]])
                canvas.line(ends, max(1.0, 0.7 * weight), BLACK if level.grid == "black" else (90, 90, 90))


def _draw_stations(
    canvas: Canvas, scale: Scale, plan: Plan, level: Level, line_px: float, random: np.random.Generator
) -> tuple[tuple[Array, ...], ...]:
    wobble_px = random.uniform(*level.wobble_px)
    seen: dict[tuple[Half, str], tuple[Array, ...]] = {}
    drawn = []
    for number, station in enumerate(plan.stations):
        key = (station.half, station.drawn_as)
        if key not in seen:
            colour = _COLOURS[number % len(_COLOURS)] if level.coloured else BLACK
            mark = random.uniform(14, 22) * line_px + 6
            dash = (mark, mark * random.uniform(0.15, 0.3)) if random.random() < level.dashed_stations else None
            curves = []
            for curve in station.curves:
                shaken = _shaken(curve, wobble_px / scale.px_per_m, random) if wobble_px else curve
                points = scale.px(station.half, shaken)
                if wobble_px:
                    _draw_uneven(canvas, points, line_px, random)
                else:
                    canvas.line(points, line_px, colour, dash)
                curves.append(shaken)
            seen[key] = tuple(curves)
        drawn.append(seen[key])
    return tuple(drawn)


def _shaken(curve: Array, rms_m: float, random: np.random.Generator) -> Array:
    """The curve as an unsteady hand draws it: a slow random walk across it, still at its ends."""
    count = len(curve)
    knots = np.linspace(0, count - 1, 24)
    walk = np.interp(np.arange(count), knots, random.normal(0.0, 1.0, knots.size))
    kernel = np.hanning(41)
    walk = np.convolve(np.pad(walk, 20, mode="edge"), kernel / kernel.sum(), mode="valid")
    along = np.gradient(curve, axis=0)
    across = np.column_stack([-along[:, 1], along[:, 0]]) / np.maximum(np.hypot(*along.T), 1e-12)[:, None]
    fade = np.minimum(1.0, np.minimum(np.arange(count), np.arange(count)[::-1]) / 25.0)
    moved = curve + across * (1.4 * rms_m * walk * fade)[:, None]
    moved[:, 0] = np.maximum(moved[:, 0], 0.0)
    return np.asarray(moved)


def _draw_uneven(canvas: Canvas, points: Array, line_px: float, random: np.random.Generator) -> None:
    """Draw a curve in strokes whose weight differs by up to a fifth."""
    fine = evenly(points, 600)
    breaks = np.linspace(0, len(fine) - 1, 13).astype(int)
    for first, last in pairwise(breaks):
        canvas.line(fine[first : last + 1], line_px * random.uniform(0.8, 1.2))


def _draw_numbers(
    canvas: Canvas, scale: Scale, plan: Plan, text_px: float, line_px: float, random: np.random.Generator
) -> None:
    """Write station numbers above the curves' ends in rows, or into the curves on a white patch."""
    in_curve = random.random() < 0.25
    for half in ("aft", "fore"):
        taken: list[tuple[float, float, int]] = []
        groups: dict[str, list[PlanStation]] = {}
        for station in plan.of(half):
            groups.setdefault(station.drawn_as, []).append(station)
        ends = {name: scale.px(half, group[0].curves[-1]) for name, group in groups.items()}
        for group in groups.values():
            words = group[0].name if len(group) == 1 else f"{group[0].name}-{group[-1].name}"
            points = ends[group[0].name]
            wide = text_width(words, text_px)
            place = _clear_place(points, [p for key, p in ends.items() if key != group[0].name], wide, random)
            if in_curve and place is not None:
                u, v = place
                corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
                canvas.area(corners * (0.6 * wide, 0.7 * text_px) + place, (255, 255, 255))
                canvas.text(words, u, v, text_px)
                continue
            u, v = points[-1]
            row = 0
            span = (u - 0.65 * wide, u + 0.65 * wide)
            while any(r == row and span[0] < right and left < span[1] for left, right, r in taken):
                row += 1
            taken.append((*span, row))
            top = v - (0.9 + 1.35 * row) * text_px - line_px
            if top > text_px:
                canvas.text(words, u, top, text_px)


def _clear_place(points: Array, others: list[Array], wide_px: float, random: np.random.Generator) -> Array | None:
    """A point of the curve's upper half where a number hides no other curve, or None."""
    for share in random.uniform(0.5, 0.92, 12):
        place = points[int(share * len(points))]
        if all(float(np.hypot(*(other - place).T).min()) > 0.9 * wide_px for other in others):
            return np.asarray(place)
    return None
