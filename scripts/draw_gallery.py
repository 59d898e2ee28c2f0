"""Write docs/gallery.md: pictures of every kind with what was read in them, wrong stations included.

python scripts/draw_gallery.py
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import cv2
import numpy as np
from generator.pictures import Recipe, make
from generator.scoring import score_stations

from hullform.picture.overlay import draw_overlay
from hullform.picture.reading import read_picture
from hullform.ship import read_ship

DOCS = Path(__file__).resolve().parent.parent / "docs"
WIDTH_PX = 1100  # of the pictures in the page
JPEG_QUALITY = 80

# seeds of development: the page shows kinds of drawing, docs/reading-accuracy.md measures
SHOWN = (
    (Recipe("container", "grid", 2000, 1001), "A print with a grid: what the reader likes best"),
    (Recipe("tanker", "blackgrid", 2000, 1002), "A grid as black as the stations, with diagonals"),
    (Recipe("bulb", "clean", 2000, 1003), "Bulbs: a station has two contours where the bulb lies below the flare"),
    (Recipe("frigate", "scan", 2000, 1004), "A scan: turned, blurred, unevenly lit, specks and gaps"),
    (Recipe("chine", "busy", 2000, 1005), "Chines, a title block, a table and hatching on the sheet"),
    (Recipe("container", "photo", 3000, 1006), "A photograph of a sheet on a table"),
    (Recipe("wigley", "wobble", 1600, 1007), "An unsteady pen"),
    (Recipe("tanker", "poor", 1600, 1008), "A poor scan: give a better one, or go over it on the review page"),
)


def main() -> None:
    """Draw the pictures and the page."""
    folder = DOCS / "images" / "gallery"
    folder.mkdir(parents=True, exist_ok=True)
    page = [
        "# Gallery\n",
        "Pictures of every kind, drawn by `scripts/generator` with known truth, and what `hullform trace` read in",
        "them without any click; written by `scripts/draw_gallery.py`.",
        "Blue lines are the predicted frame and grid with their values; curves carry the x of their station. "
        "[reading-accuracy.md](reading-accuracy.md) has the figures over many more.\n",
    ]
    for recipe, words in SHOWN:
        picture = make(recipe)
        with tempfile.TemporaryDirectory() as place:
            reading = read_picture(read_ship(picture.write(Path(place))))
        scores = score_stations(picture, reading.body_plan.stations)
        right = [score for score in scores if score.right]
        drawn = draw_overlay(reading)
        height = round(drawn.shape[0] * WIDTH_PX / drawn.shape[1])
        small = cv2.resize(drawn, (WIDTH_PX, height), interpolation=cv2.INTER_AREA)
        name = f"{recipe.family}-{recipe.level}.jpg"
        cv2.imwrite(str(folder / name), small, [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
        doubts = len(reading.body_plan.doubts)
        rms = f"; RMS median {np.median([score.rms_percent or 0.0 for score in right]):.2f} % of B/2" if right else ""
        page += [
            f"## {words}",
            f"{recipe.width_px} px wide: {len(right)} of {len(scores)} stations right{rms}; {doubts} doubts raised.\n",
            f"![{words}](images/gallery/{name})\n",
        ]
        print(page[-2].strip())
    (DOCS / "gallery.md").write_text("\n".join(page), encoding="utf-8")


if __name__ == "__main__":
    main()
