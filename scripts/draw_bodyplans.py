"""Draw the body plans in bodyplans/ from our own station tables.

    python scripts/draw_bodyplans.py [--check] [SHIP ...]

`--check` writes nothing. It verifies the figures of the hull forms, that the pictures and profiles on disk are what
this script draws, and that the stations in ship.toml are the stations drawn. The exit code is 1 where anything differs.
"""

from __future__ import annotations

import argparse
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from drawing.form import faults
from drawing.picture import Drawing, draw
from drawing.profiles import text
from drawing.ships import outline
from drawing.tables import PARTICULARS
from drawing.waterlines import WaterlineForm

__all__ = ["Drawing", "draw", "further_pictures", "main", "outline"]

FOLDER = Path(__file__).resolve().parent.parent / "bodyplans"
PROFILE = "profile.csv"

# Another release of matplotlib may set a letter a pixel off; a curve that has moved changes far more than this.
_GREY_LEVELS_APART = 40
_SHARE_OF_PIXELS_APART = 2e-3


def further_pictures() -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield ten (ship, options of draw): other widths, line weights and label places, all with S / line >= 250."""
    container, tanker, wigley = "scim-containership", "ds-tanker", "wigley"
    for ship, width, curve, grid, seed in (
        (container, 1600, 2.0, 0.9, 1),
        (container, 2200, 3.0, 1.2, 2),
        (container, 2600, 2.4, 1.6, 3),
        (container, 3000, 4.0, 2.0, 4),
        (tanker, 1600, 2.2, 1.0, 5),
        (tanker, 1800, 1.8, 0.8, 6),
        (tanker, 2400, 3.4, 1.0, 7),
        (tanker, 3000, 2.5, 1.5, 8),
        (wigley, 1700, 2.4, 1.2, 9),
        (wigley, 2800, 3.2, 1.0, 10),
    ):
        yield ship, {"width_px": width, "curve_px": curve, "grid_px": grid, "label_seed": seed}


def differences(ship: str) -> list[str]:
    """Return what is wrong with a ship's form, picture or station list, one sentence each."""
    hull = outline(ship)
    report = faults(hull)
    on_disk = cv2.imread(str(FOLDER / ship / "bodyplan.png"), cv2.IMREAD_COLOR)
    drawn = draw(hull).image[:, :, ::-1]
    if on_disk is None:
        report.append("bodyplan.png is missing or no picture")
    elif on_disk.shape != drawn.shape:
        report.append(f"bodyplan.png is {on_disk.shape[1]} x {on_disk.shape[0]} px, not {drawn.shape[1::-1]}")
    else:
        apart = np.abs(on_disk.astype(int) - drawn).max(axis=2) > _GREY_LEVELS_APART
        if apart.mean() > _SHARE_OF_PIXELS_APART:
            report.append(f"bodyplan.png differs from the drawing in {100 * apart.mean():.2f} % of its pixels")
    return report + _station_differences(ship) + _profile_differences(ship)


def _station_differences(ship: str) -> list[str]:
    path = FOLDER / ship / "ship.toml"
    if not path.is_file():
        return ["ship.toml is missing"]
    body_plan = tomllib.loads(path.read_text(encoding="utf-8"))["body_plan"]
    main = PARTICULARS[ship]
    return [
        f"ship.toml: {key} are not the stations drawn"
        for key, stations in (("aft_stations_m", main.aft_stations), ("fore_stations_m", main.fore_stations))
        if body_plan[key] != [x for _, x in stations]
    ]


def _profile_differences(ship: str) -> list[str]:
    form, path = outline(ship), FOLDER / ship / PROFILE
    if not isinstance(form, WaterlineForm):
        return []
    if not path.is_file():
        return [f"{PROFILE} is missing"]
    return [] if path.read_text(encoding="utf-8") == text(form) else [f"{PROFILE} is not the profile drawn"]


def _write(ship: str) -> None:
    folder = FOLDER / ship
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "bodyplan.png"
    written = cv2.imwrite(str(path), draw(outline(ship)).image[:, :, ::-1], [cv2.IMWRITE_PNG_COMPRESSION, 9])
    if not written:
        raise OSError(f"cannot write {path}")
    form = outline(ship)
    if isinstance(form, WaterlineForm):
        (folder / PROFILE).write_text(text(form), encoding="utf-8")


def main(arguments: list[str] | None = None) -> int:
    """Draw the ships named (all of them by default), or check them; return the exit code."""
    parser = argparse.ArgumentParser(description="Draw the body plans in bodyplans/ from our own station tables.")
    parser.add_argument("--check", action="store_true", help="write nothing; compare figures, pictures and stations")
    parser.add_argument("ships", nargs="*", metavar="SHIP", help=f"any of {', '.join(PARTICULARS)}")
    options = parser.parse_args(arguments)
    unknown = [ship for ship in options.ships if ship not in PARTICULARS]
    if unknown:
        parser.error(f"there is no drawn ship {unknown[0]!r}; there are {', '.join(PARTICULARS)}")
    code = 0
    for ship in options.ships or list(PARTICULARS):
        if options.check:
            report = differences(ship)
        else:
            report = faults(outline(ship))
            _write(ship)
        code = max(code, int(bool(report)))
        figures = "  ".join(f"{name} {value:.4g}" for name, value in outline(ship).coefficients().items())
        print(f"{ship}: {'; '.join(report) or 'in order'}\n    {figures}")
    return code


if __name__ == "__main__":
    sys.exit(main())
