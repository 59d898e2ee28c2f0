"""Measure how well body plans are read: draw pictures with known truth, read them, compare.

    python scripts/accuracy.py [--dev] [--only level=poor width=2000 family=bulb seed=70012 ...] [--overlay FOLDER]

Without --only it writes the table to docs/reading-accuracy.md (not with --dev, whose seeds are those of development).
"""

from __future__ import annotations

import argparse
import multiprocessing
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import cv2
import numpy as np
from generator.families import FAMILIES
from generator.levels import LEVELS
from generator.pictures import Recipe, make
from generator.scoring import StationScore, score_stations
from generator.suite import DEVELOPMENT_SEED, LARGE_PX, TEST_SEED, WIDTHS_PX, sample, suite

from hullform.errors import HullformError

PAGE = Path(__file__).resolve().parent.parent / "docs" / "reading-accuracy.md"
WORKERS = 2
SAMPLE_ROW = "the sample of 24 that the tests read"
GATE_WIDTH_PX, GATE_RATIO = 2000, 300.0


@dataclass(frozen=True)
class Result:
    """A picture read: its recipe, S/lw, station scores, seconds, what the reader refused it for, its doubts."""

    recipe: Recipe
    ratio: float
    scores: tuple[StationScore, ...]
    seconds: float
    refusal: str
    doubts: int
    scale_error_percent: float

    @property
    def halves(self) -> list[bool]:
        """Whether each half has all its stations right."""
        names = {s.half for s in self.scores}
        return [all(s.right for s in self.scores if s.half == half) for half in sorted(names)]


def measure(recipe: Recipe, overlays: Path | None = None) -> Result:
    """Draw, read and compare one picture; overlays of those with a wrong station go to a folder."""
    from hullform.picture.overlay import draw_overlay
    from hullform.picture.reading import read_picture
    from hullform.ship import read_ship

    cv2.setNumThreads(1)
    picture = make(recipe)
    with tempfile.TemporaryDirectory() as folder:
        ship = read_ship(picture.write(Path(folder)))
        start = time.perf_counter()
        try:
            reading = read_picture(ship)
        except HullformError as error:
            scores = tuple(score_stations(picture, ()))
            refusal = str(error).replace(folder, "").lstrip("/")
            return Result(recipe, picture.ratio, scores, time.perf_counter() - start, refusal, 0, np.nan)
        seconds = time.perf_counter() - start
    scores = tuple(score_stations(picture, reading.body_plan.stations))
    if overlays is not None and not all(s.right for s in scores):
        wrong = ",".join(f"{s.half[0]}{s.name}" for s in scores if not s.right)
        cv2.imwrite(str(overlays / f"{recipe.name}.png"), draw_overlay(reading))
        (overlays / f"{recipe.name}.txt").write_text(wrong + "\n" + "\n".join(reading.body_plan.doubts) + "\n")
    scale = reading.calibration.metres_per_px
    error = 100 * abs(scale * _true_px_per_m(picture.pixel_from_metres) - 1)
    return Result(recipe, picture.ratio, scores, seconds, "", len(reading.body_plan.doubts), error)


def _true_px_per_m(matrix: np.ndarray) -> float:
    """Pixels of a small step up from where centre line and base line meet."""
    places = matrix @ np.array([[0.0, 0.0], [0.0, 1e-3], [1.0, 1.0]])
    (a, b) = (places[:2] / places[2]).T
    return float(np.hypot(*(b - a)) / 1e-3)


def row(name: str, results: Sequence[Result]) -> str:
    """One line of the table; errors are over the stations that are right."""
    scores = [s for r in results for s in r.scores]
    if not scores:
        return f"| {name} | 0 | | | | | | | | | |"
    halves = [h for r in results for h in r.halves]
    rms = [s.rms_percent for s in scores if s.rms_percent is not None] or [np.nan]
    areas = [s.area_percent for s in scores if s.area_percent is not None] or [np.nan]
    seconds = [r.seconds for r in results]
    return (
        f"| {name} | {len(results)} | {len(scores)} | {100 * np.mean([s.right for s in scores]):.1f} "
        f"| {100 * np.mean([s.found for s in scores]):.1f} | {100 * np.mean(halves):.0f} "
        f"| {np.median(rms):.3f} | {np.percentile(rms, 90):.2f} | {np.percentile(areas, 95):.2f} "
        f"| {np.median(seconds):.1f} / {np.percentile(seconds, 95):.1f} | {sum(bool(r.refusal) for r in results)} |"
    )


HEAD = (
    "| pictures | n | stations | right, % | found, % | halves complete, % | RMS median, % of B/2 | RMS p90 "
    "| area p95, % of largest | time median / p95, s | refused |\n|-|-|-|-|-|-|-|-|-|-|-|"
)


def groups() -> Iterator[tuple[str, Callable[[Recipe, float], bool]]]:
    """Yield the rows of the table: a name, and which pictures (by recipe and S/lw) it is about."""
    yield "**all**", lambda r, ratio: True
    yield (
        f"**{GATE_WIDTH_PX} px and wider, S/lw {GATE_RATIO:g} and more**",
        lambda r, ratio: r.width_px >= GATE_WIDTH_PX and ratio >= GATE_RATIO,
    )
    yield SAMPLE_ROW, lambda r, ratio: r in (*sample(suite(TEST_SEED)), *sample(suite(DEVELOPMENT_SEED)))
    for low, high in ((0, 200), (200, 300), (300, 450), (450, 10000)):
        name = f"S/lw {low} to {high}" if high < 10000 else f"S/lw over {low}"
        yield name, lambda r, ratio, low=low, high=high: low <= ratio < high
    for level in LEVELS:
        yield f"level {level}", lambda r, ratio, level=level: r.level == level
    for width in (*WIDTHS_PX, LARGE_PX):
        yield f"{width} px", lambda r, ratio, width=width: r.width_px == width
    for family in FAMILIES:
        yield f"family {family}", lambda r, ratio, family=family: r.family == family


def table(results: Sequence[Result]) -> str:
    """The table in Markdown."""
    return "\n".join([HEAD, *(row(n, [r for r in results if keep(r.recipe, r.ratio)]) for n, keep in groups())])


def chosen(recipes: Sequence[Recipe], wanted: Sequence[str]) -> list[Recipe]:
    """Recipes that match every key=value[,value] of --only; keys: level, family, width, seed."""
    keys = {"level": "level", "family": "family", "width": "width_px", "seed": "seed"}
    for words in wanted:
        key, _, values = words.partition("=")
        if key not in keys:
            raise SystemExit(f"--only {words}: no such key; there are {', '.join(keys)}")
        recipes = [r for r in recipes if str(getattr(r, keys[key])) in values.split(",")]
    return list(recipes)


def measured(recipes: Sequence[Recipe], overlays: Path | None, workers: int, say: bool = False) -> list[Result]:
    """Measure recipes in a few processes at a time, in their order."""
    results = []
    with multiprocessing.get_context("spawn").Pool(workers) as pool:
        for result in pool.imap(partial(measure, overlays=overlays), recipes):
            results.append(result)
            if say:
                right, found = (sum(getattr(s, what) for s in result.scores) for what in ("right", "found"))
                print(
                    f"{result.recipe.name:34s} S/lw {result.ratio:4.0f}  right {right:2d}/{len(result.scores):2d}  "
                    f"found {found:2d}  scale {result.scale_error_percent:5.2f} %  "
                    f"doubts {result.doubts:2d}  {result.seconds:4.1f} s  {result.refusal[:90]}",
                    flush=True,
                )
    return results


def page(results: Sequence[Result]) -> str:
    """The page of the documentation."""
    gate = [r for r in results if r.recipe.width_px >= GATE_WIDTH_PX and r.ratio >= GATE_RATIO]
    refused = [f"- {r.recipe.name}: {r.refusal}" for r in results if r.refusal]
    silent = [r for r in results if not r.doubts and not r.refusal and not all(s.right for s in r.scores)]
    return TEXT.format(
        pictures=len(results),
        gate=len(gate),
        table=table(results),
        refused="\n".join(refused) or "None.",
        silent=len(silent),
        complete=sum(all(s.right for s in r.scores) for r in results),
    )


TEXT = """# How well body plans are read

Written by `python scripts/accuracy.py`. Do not edit: run it again.

{pictures} pictures are drawn from hulls by formula whose truth is known, spoilt, and read without calibration and
without marks: ship.toml has breadth, depth, draught and the stations' places only. The seeds are kept for this table;
tuning uses others (`--dev`), of the same families and levels. `scripts/generator/` draws the pictures.

- A station is **right** where the station of its own x and half lies on it: RMS distance at most 1.2 % of B/2, at
  least 90 % of the drawn curve near the traced one, 95 % of the traced one near the drawn one. **Found** is the same
  with any name. A picture that is refused counts all its stations as wrong. Stations that share one drawn curve
  (parallel body) count each; a station of two curves (bulb and flare) needs both.
- RMS and area errors are those of the right stations, so they say nothing of the others. Areas go up to the draught.
- Truth is what the pen drew: under `wobble` that is the unsteady curve. What of it lies within the centre line's own
  ink, less than half a line from its axis, is not asked for; what was traced there is judged.
- Sheets of 1200 px have up to 11 stations a half, of 1600 px up to 15, wider ones up to 21. A line is 1 to 4 px wide,
  S/lw (half-breadth over line width) between 150 and 600 but for those limits.
- Times are for reading alone, two pictures at a time on two cores.

{table}

{complete} pictures have every station right. {silent} have a wrong station and no doubt in the reading: there a
person is not warned.

## Levels

clean: no grid. grid: grey. blackgrid: black as the curves, often dashed, diagonals. colour: coloured curves, JPEG 60.
scan: turned, blurred, uneven light, specks, JPEG 50. poor: 1 % perspective, more blur, JPEG 30, lost ink. wobble: an
unsteady pen. warp: paper that is not flat. photo: 2 to 4 % perspective, a lamp, a table below the sheet. dashed:
stations in long dashes. busy: border, title block, table, hatching, diagonals.

## Pictures refused

{refused}
"""


def main(arguments: list[str] | None = None) -> int:
    """Measure, print, write the page; return the exit code."""
    parser = argparse.ArgumentParser(description="Measure how well body plans are read.")
    parser.add_argument("--dev", action="store_true", help="the pictures of development instead of those of the test")
    parser.add_argument("--only", nargs="*", default=[], metavar="KEY=VALUE", help="level=, family=, width=, seed=")
    parser.add_argument("--overlay", type=Path, metavar="FOLDER", help="overlays of pictures with a wrong station")
    parser.add_argument("--workers", type=int, default=WORKERS)
    options = parser.parse_args(arguments)
    recipes = chosen(suite(DEVELOPMENT_SEED if options.dev else TEST_SEED), options.only)
    if options.overlay:
        options.overlay.mkdir(parents=True, exist_ok=True)
    results = measured(recipes, options.overlay, options.workers, say=True)
    print(table(results))
    if not options.dev and not options.only:
        PAGE.write_text(page(results), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
