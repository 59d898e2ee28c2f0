"""The levels of difficulty: what is drawn beside the stations, and how the sheet is spoilt afterwards."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Level:
    """What a level may bring; probabilities 0..1, other figures are upper limits or (from, to).

    Attributes:
        grid: none, 'grey' or 'black'; dashed_grid: probability that its lines are dashed.
        diagonals, deck_line, title_block, table, hatching: probabilities.
        coloured: curves in cycled colours, on a colour picture.
        dashed_stations: probability that a station is drawn in long dashes.
        wobble_px: unsteadiness of the pen, RMS; its weight varies with it.
        warp_px: smooth distortion of the paper, largest at 1000 px width.
        rotation_deg, perspective: limits; perspective is the change of scale across the sheet.
        photograph: whether the sheet lies on a table, under a lamp.
        blur_px, jpeg, shade, salt, gaps: (from, to) of each; gaps are batches of places where the ink is lost.
    """

    grid: str = ""
    dashed_grid: float = 0.0
    diagonals: float = 0.0
    deck_line: float = 0.4
    title_block: float = 0.0
    table: float = 0.0
    hatching: float = 0.0
    coloured: bool = False
    dashed_stations: float = 0.0
    wobble_px: tuple[float, float] = (0.0, 0.0)
    warp_px: tuple[float, float] = (0.0, 0.0)
    rotation_deg: float = 0.0
    perspective: tuple[float, float] = (0.0, 0.0)
    photograph: bool = False
    blur_px: tuple[float, float] = (0.0, 0.0)
    jpeg: int = 0
    shade: tuple[float, float] = (0.0, 0.0)
    salt: float = 0.0
    gaps: tuple[int, int] = (0, 0)


LEVELS = {
    "clean": Level(),
    "grid": Level(grid="grey", deck_line=0.5),
    "blackgrid": Level(grid="black", dashed_grid=0.4, diagonals=0.6, deck_line=0.4),
    "colour": Level(grid="grey", coloured=True, jpeg=60),
    "scan": Level(
        grid="grey", rotation_deg=1.2, blur_px=(0.8, 0.8), jpeg=50, shade=(0.15, 0.3), salt=1e-4, gaps=(0, 3)
    ),
    "poor": Level(
        grid="grey",
        dashed_grid=0.5,
        rotation_deg=2.0,
        perspective=(0.005, 0.01),
        blur_px=(1.0, 1.5),
        jpeg=30,
        shade=(0.3, 0.45),
        salt=3e-3,
        gaps=(2, 7),
    ),
    "wobble": Level(grid="grey", deck_line=0.5, wobble_px=(0.3, 0.8), rotation_deg=0.4, blur_px=(0.5, 0.8), jpeg=75),
    "warp": Level(grid="grey", warp_px=(1.0, 3.0), rotation_deg=0.5, blur_px=(0.6, 0.9), jpeg=60, shade=(0.1, 0.25)),
    "photo": Level(
        grid="grey",
        title_block=0.4,
        rotation_deg=1.5,
        perspective=(0.02, 0.04),
        photograph=True,
        blur_px=(0.7, 1.1),
        jpeg=70,
        shade=(0.3, 0.5),
    ),
    "dashed": Level(grid="grey", dashed_stations=0.4, deck_line=0.3),
    "busy": Level(
        grid="grey", diagonals=1.0, deck_line=0.6, title_block=1.0, table=0.7, hatching=0.7, rotation_deg=0.3, jpeg=80
    ),
}
