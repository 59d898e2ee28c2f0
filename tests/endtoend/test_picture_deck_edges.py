"""Deck edges that fall too steeply near the side to be seen: every station ends where it is drawn to end."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from hullform.picture.reading import PictureReading, read_picture
from hullform.ship import read_ship

Array = NDArray[np.float64]

BREADTH_M, DEPTH_M = 20.0, 16.0
HALF_PX = 700.0  # B/2
CENTRE, BASE = 780, 1240  # px
METRES_PER_PX = BREADTH_M / 2 / HALF_PX
AFT_M, FORE_M = (5.0, 12.0, 20.0, 30.0, 40.0, 50.0), (50.0, 58.0, 66.0, 74.0, 82.0, 90.0, 96.0)
LOWEST_M = 10.6  # of the deck edge, amidships


def edge(half_breadth: float) -> float:
    """Height of the deck edge: it falls like a circle's quarter, upright at the side."""
    share = np.clip(half_breadth / (BREADTH_M / 2), 0.0, 1.0)
    return float(LOWEST_M + (DEPTH_M - LOWEST_M) * (1 - share**3) ** 0.7)


def section(fullness: float) -> Array:
    """A flared section up to the deck edge."""
    z = np.linspace(0.0, DEPTH_M, 400)
    y = BREADTH_M / 2 * fullness * (1 - 0.75 * (1 - z / DEPTH_M) ** 2.5)
    y *= 1 / (1 - 0.75 * (1 - LOWEST_M / DEPTH_M) ** 2.5)
    inside = z <= np.array([edge(value) for value in y])
    return np.vstack([[[0.0, 0.0]], np.column_stack([y, z])[inside]])


def read(folder: Path, fullness: tuple[float, ...]) -> PictureReading:
    """Draw the fore half with such sections, the aft half with a level deck at the lowest height, and read both."""
    image = np.full((1330, 1560), 252, np.uint8)

    def line(points: Array, side: int, grey: int, width: int) -> None:
        at = np.column_stack([CENTRE + side * points[:, 0] / METRES_PER_PX, BASE - points[:, 1] / METRES_PER_PX])
        cv2.polylines(image, [np.round(at * 16).astype(np.int32)], False, grey, width, cv2.LINE_AA, 4)

    for y in (-10.0, -8.0, -6.0, -4.0, -2.0, 2.0, 4.0, 6.0, 8.0, 10.0):
        line(np.array([[y, -0.6], [y, DEPTH_M + 0.4]]), 1, 170, 1)
    for z in (2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 16.0):
        line(np.array([[-10.4, z], [10.4, z]]), 1, 170, 1)
    line(np.array([[-10.4, 0.0], [10.4, 0.0]]), 1, 0, 2)
    line(np.array([[0.0, -0.6], [0.0, DEPTH_M + 0.6]]), 1, 0, 2)
    for value in fullness:
        line(section(value), 1, 10, 3)
    tops = np.array([[y, edge(float(y))] for y in np.linspace(section(fullness[-1])[-1, 0], BREADTH_M / 2, 300)])
    line(tops, 1, 90, 1)
    for value in (0.7, 0.8, 0.88, 0.94, 0.98, 1.0):
        curve = section(value)
        line(curve[curve[:, 1] <= LOWEST_M], -1, 10, 3)
    cv2.imwrite(str(folder / "bodyplan.png"), image)
    (folder / "ship.toml").write_text(
        f"""schema = 1
[ship]
name = "drawn"
type = "container"
length_overall_m = 100.0
length_between_perpendiculars_m = 100.0
breadth_m = {BREADTH_M}
depth_m = {DEPTH_M}
draught_m = 6.0
[body_plan]
image = "bodyplan.png"
aft_side = "left"
aft_stations_m = {list(AFT_M)}
fore_stations_m = {list(FORE_M[: len(fullness)])}
""",
        encoding="utf-8",
    )
    return read_picture(read_ship(folder / "ship.toml"))


def test_stations_end_where_their_ink_ends(tmp_path: Path) -> None:
    fullness = (0.995, 0.97, 0.93, 0.86, 0.74, 0.56, 0.34)
    reading = read(tmp_path, fullness)
    fore = [station for station in reading.body_plan.stations if station.half == "fore"]
    assert len(fore) == len(fullness)
    ends = [float(station.curves[0].height_m[-1]) for station in fore]
    # a line of 3 px ends bluntly: its end is known to a few pixels
    assert ends == pytest.approx([float(section(value)[-1, 1]) for value in fullness], abs=5 * METRES_PER_PX)
