"""A made-up ship for tests of her report: no picture is read, and she is run once for a module."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.outcome import Run
from hullform.pipeline import run_ship
from hullform.ship import read_ship

# The particulars of the paper's container ship, so that her report has its appendix; the hull is a plain one with
# parabolic waterlines and sections, of far too little displacement: her checks of floating fail.
SHIP = """
schema = 1
[ship]
name = "SCIM containership"
type = "container"
length_overall_m = 262.0
length_between_perpendiculars_m = 248.0
aft_perpendicular_m = 7.0
breadth_m = 32.2
depth_m = 19.5
draught_m = 13.2
displacement_t = 74660.0
[body_plan]
image = "bodyplan.png"
aft_side = "left"
aft_stations_m = [13.1, 39.3, 65.5, 91.7, 117.9]
fore_stations_m = [144.1, 170.3, 196.5, 222.7, 248.9]
[structure]
midship_second_moment_m4 = 253.0
[weights]
steel_weight_t = 15103.0
semi_concentrated_weight_t = 1772.0
[[conditions]]
name = "loaded"
label = "loaded <fully>"
deadweight_t = 57785.0
[[conditions]]
name = "light-ship"
deadweight_t = 0.0
"""


@dataclass(frozen=True, eq=False)
class Reading:
    """As much of a reading as the report needs."""

    body_plan: BodyPlan


def plain_sections() -> BodyPlan:
    """Ten stations with parabolic waterlines and sections."""
    xs = [13.1, 39.3, 65.5, 91.7, 117.9, 144.1, 170.3, 196.5, 222.7, 248.9]
    z = np.linspace(0.0, 19.5, 60)
    stations = []
    for x in xs:
        y = 16.1 * (1 - (2 * x / 262.0 - 1) ** 2) * (1 - (1 - z / 19.5) ** 2)
        stations.append(Station(x, "aft" if x < 131 else "fore", (TracedCurve(y, z, 0.9),)))
    return BodyPlan(tuple(stations), "picture", notes=("a note",), doubts=("station 13.1: look & see",))


@contextmanager
def made_up_run(folder: Path) -> Iterator[Run]:
    """The run of the ship, while which the picture's modules are stand-ins."""
    path = folder / "ship.toml"
    path.write_text(SHIP, encoding="utf-8")
    picture, overlay = ModuleType("hullform.picture.reading"), ModuleType("hullform.picture.overlay")
    picture.read_picture = lambda ship: Reading(plain_sections())  # type: ignore[attr-defined]
    overlay.draw_overlay = lambda reading: np.full((40, 60, 3), 200, dtype=np.uint8)  # type: ignore[attr-defined]
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, picture.__name__, picture)
        patch.setitem(sys.modules, overlay.__name__, overlay)
        yield run_ship(read_ship(path))
