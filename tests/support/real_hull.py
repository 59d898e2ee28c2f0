"""A hull of others with known truth, where it is present: her ship.toml, her true curves in metres and in pixels."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from reading_accuracy import evenly, to_polyline

from hullform.body_plan import BodyPlan, Half, Station

Array = NDArray[np.float64]

HULLS = Path(os.environ.get("HULLFORM_SHARED", Path(__file__).parents[3] / "shared")) / "hulls"
NEAR = 0.03  # of B/2: true points so near a traced curve are covered
COVERED = 0.9  # of the true curve; and of the traced one
BACK = 0.95


@dataclass(frozen=True, eq=False)
class TrueStation:
    """A station: x from the aft end, the half that shows it, its curves in metres and in pixels of the picture."""

    x_m: float
    half: Half
    curves_m: tuple[Array, ...]
    curves_px: tuple[Array, ...]


@dataclass(frozen=True, eq=False)
class RealHull:
    """A hull, her ship.toml, her stations."""

    toml: Path
    breadth_m: float
    stations: tuple[TrueStation, ...]

    def misfits(self, body_plan: BodyPlan) -> list[float]:
        """Of each true station the RMS distance of her curves from the traced ones, % of B/2; 99 where it is wrong."""
        traced = {(station.half, round(station.x_m, 3)): station for station in body_plan.stations}
        return [self._misfit(true, traced.get((true.half, round(true.x_m, 3)))) for true in self.stations]

    def _misfit(self, true: TrueStation, traced: Station | None) -> float:
        if traced is None:
            return 99.0
        lines = [curve.points for curve in traced.curves]
        points = np.vstack(true.curves_m)
        there = np.min([to_polyline(points, line) for line in lines], axis=0) / (self.breadth_m / 2)
        ends = [np.min([to_polyline(evenly(line, 200), c) for c in true.curves_m], axis=0) for line in lines]
        back = np.concatenate(ends) / (self.breadth_m / 2)
        near = there < NEAR
        if near.mean() < COVERED or (back < NEAR).mean() < BACK:
            return 99.0
        return float(100 * np.sqrt(np.mean(there[near] ** 2)))


def real_hull(name: str, folder: Path) -> RealHull:
    """Write the ship.toml of one of those hulls into a folder, for her picture where it lies; skip without her."""
    source = HULLS / name
    if not (source / "calibration.json").is_file():
        pytest.skip(f"{source}: not present; HULLFORM_SHARED names the folder that holds hulls/")
    offsets = json.loads((source / "offsets.json").read_text(encoding="utf-8"))
    drawn = json.loads((source / "calibration.json").read_text(encoding="utf-8"))
    shift = -min(0.0, min(station["x"] for station in drawn["stations"]))
    sections = {round(station["x"], 4): station for station in offsets["stations"]}
    stations = []
    for station in drawn["stations"]:
        section = sections.get(round(station["x"], 4)) or min(
            offsets["stations"], key=lambda other: abs(other["x"] - station["x"])
        )
        curves = section.get("curves") or [section["points"]]
        stations.append(
            TrueStation(
                round(station["x"] + shift, 4),
                "aft" if station["side"] == drawn["aft_side"] else "fore",
                tuple(np.array(curve, dtype=np.float64) for curve in curves),
                tuple(np.array(curve, dtype=np.float64) for curve in station["curves_px"]),
            )
        )
    listed = {half: sorted({s.x_m for s in stations if s.half == half}) for half in ("aft", "fore")}
    length = max(max(s.x_m for s in stations), offsets["L"])
    toml = folder / "ship.toml"
    toml.write_text(
        f"""schema = 1
[ship]
name = "{name}"
type = "container"
length_overall_m = {length:.4f}
length_between_perpendiculars_m = {offsets["L"]:.4f}
aft_perpendicular_m = {shift:.4f}
breadth_m = {offsets["B"]:.4f}
depth_m = {offsets["D"]:.4f}
draught_m = {offsets["T"]:.4f}
[body_plan]
image = "{source / "bodyplan.png"}"
aft_side = "{drawn["aft_side"]}"
aft_stations_m = {listed["aft"]}
fore_stations_m = {listed["fore"]}
""",
        encoding="utf-8",
    )
    return RealHull(toml, offsets["B"], tuple(stations))
