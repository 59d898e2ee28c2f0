"""A recipe, and the picture with its truth that it stands for: the same every time."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from generator.canvas import Image
from generator.families import FAMILIES
from generator.levels import LEVELS
from generator.plan import Half, Plan, plan_of
from generator.sections import Array
from generator.sheet import Scale, draw_sheet, pen_weight
from generator.spoiling import Distortion, encoded, spoilt

_MOST = {1200: 11, 1600: 15}  # stations of a half that such a width can show; wider sheets take all
_ONE_STROKE_PX = 0.3  # stations nowhere further apart are drawn once


@dataclass(frozen=True, order=True)
class Recipe:
    """Which picture: family, level, width in px, seed."""

    family: str
    level: str
    width_px: int
    seed: int

    @property
    def name(self) -> str:
        """A file name without suffix."""
        return f"{self.seed}-{self.family}-{self.level}-{self.width_px}"


@dataclass(frozen=True, eq=False)
class DrawnStation:
    """Truth of a station: number, x, half, curves [y, z] in metres as drawn and in px of the picture, and its twin.

    `drawn_as` is the number of the first station that has the same pen stroke, its own where it was drawn itself.
    """

    name: str
    x_m: float
    half: Half
    curves_m: tuple[Array, ...]
    curves_px: tuple[Array, ...]
    drawn_as: str


@dataclass(frozen=True, eq=False)
class DrawnPicture:
    """A picture and its truth.

    Attributes:
        image: (rows, columns) grey or (rows, columns, 3) RGB, before the file format's losses.
        stations: from aft forward, the aft half first.
        pixel_from_metres: 3 x 3, (y, z, 1) to pixels, y negative in the left half; without the paper's warp.
        line_px: weight of a station's line; ratio: half-breadth over it, both in px.
    """

    recipe: Recipe
    image: Image
    plan: Plan
    stations: tuple[DrawnStation, ...]
    scale: Scale
    pixel_from_metres: Array
    distortion: Distortion
    line_px: float

    @property
    def ratio(self) -> float:
        """Pixels of a half-breadth over pixels of a line."""
        return self.plan.dimensions.breadth_m / 2 * self.scale.px_per_m / self.line_px

    def write(self, folder: Path) -> Path:
        """Write picture and ship.toml (no calibration, no marks) into a folder; return the path of the latter."""
        data, suffix = encoded(self.image, LEVELS[self.recipe.level])
        (folder / f"bodyplan{suffix}").write_bytes(data)
        main = self.plan.dimensions
        lists = {half: [s.x_m for s in self.stations if s.half == half] for half in ("aft", "fore")}
        path = folder / "ship.toml"
        path.write_text(
            f'schema = 1\n\n[ship]\nname = "{self.recipe.name}"\ntype = "container"\n'
            f"length_overall_m = {main.length_m:.4f}\nlength_between_perpendiculars_m = {0.95 * main.length_m:.4f}\n"
            f"aft_perpendicular_m = {0.025 * main.length_m:.4f}\nbreadth_m = {main.breadth_m:.4f}\n"
            f"depth_m = {main.depth_m:.4f}\ndraught_m = {main.draught_m:.4f}\n\n[body_plan]\n"
            f'image = "bodyplan{suffix}"\naft_side = "{"left" if self.scale.aft_side < 0 else "right"}"\n'
            f"aft_stations_m = {lists['aft']}\nfore_stations_m = {lists['fore']}\n",
            encoding="utf-8",
        )
        return path


def make(recipe: Recipe) -> DrawnPicture:
    """Draw a recipe's picture."""
    kind = (list(FAMILIES).index(recipe.family), list(LEVELS).index(recipe.level), recipe.width_px)
    random = np.random.default_rng((recipe.seed, *kind))
    hull, level = FAMILIES[recipe.family](random), LEVELS[recipe.level]
    most = _MOST.get(recipe.width_px, 21)
    plan = plan_of(hull, random, most, _ONE_STROKE_PX * hull.dimensions.breadth_m / (0.8 * recipe.width_px))
    line_px = pen_weight(recipe.width_px, random)
    drawing = draw_sheet(plan, level, recipe.width_px, line_px, random)
    picture, distortion = spoilt(drawing.image, level, random)
    stations = tuple(
        DrawnStation(
            station.name,
            station.x_m,
            station.half,
            curves,
            tuple(distortion.of(drawing.scale.px(station.half, curve)) for curve in curves),
            station.drawn_as,
        )
        for station, curves in zip(plan.stations, drawing.drawn, strict=True)
    )
    matrix = distortion.matrix @ drawing.scale.matrix()
    return DrawnPicture(recipe, picture, plan, stations, drawing.scale, matrix, distortion, line_px)
