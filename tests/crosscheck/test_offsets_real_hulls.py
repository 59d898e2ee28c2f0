"""Tables of offsets of real hulls, of both forms, against the areas of their sources; their hulls through a mesh."""

from __future__ import annotations

import csv
import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hullform import Hull, trace
from hullform.body_plan import BodyPlan
from hullform.hull.mesh_files import export_mesh
from hullform.ship import read_ship

HULLS = Path(os.environ.get("HULLFORM_SHARED", Path(__file__).parents[3] / "shared")) / "hulls"
NAMES = ["container165", "dtc", "dtmb5415", "gunnerus", "oural", "patrol27"]
NAMES += ["s60_cb60", "s60_cb70", "s60_cb80", "tanker70k", "wigley", "workboat70"]


def offsets_of(name: str) -> dict[str, Any]:
    path = HULLS / name / "offsets.json"
    if not path.is_file():
        pytest.skip(f"{path}: not present; HULLFORM_SHARED names the folder that holds hulls/")
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    found["stations"].sort(key=lambda station: station["x"])
    return found


def read(folder: Path, hull: dict[str, Any], rows: list[list[Any]]) -> BodyPlan:
    """Read a table whose x counts from the aft perpendicular."""
    with (folder / "table.csv").open("w", newline="", encoding="utf-8") as stream:
        csv.writer(stream).writerows(rows)
    x = [station["x"] for station in hull["stations"]]
    aft = max(0.0, -min(x))
    (folder / "ship.toml").write_text(
        f"""schema = 1
[ship]
name = "hull"
type = "container"
length_overall_m = {aft + max(hull["L"], *x)!r}
length_between_perpendiculars_m = {hull["L"]!r}
aft_perpendicular_m = {aft!r}
breadth_m = {hull["B"]!r}
depth_m = {hull["D"]!r}
draught_m = {hull["T"]!r}
[body_plan]
offsets = "table.csv"
origin_x_m = {aft!r}
""",
        encoding="utf-8",
    )
    return trace(read_ship(folder / "ship.toml"))


def points_of(hull: dict[str, Any]) -> list[list[Any]]:
    rows: list[list[Any]] = [["station_x_m", "curve", "half_breadth_m", "height_m"]]
    for station in hull["stations"]:
        for number, curve in enumerate(station["curves"] or [station["points"]]):
            rows += [[station["x"], number, max(y, 0.0), z] for y, z in curve]
    return rows


@pytest.mark.parametrize("name", NAMES)
def test_every_station_has_the_area_of_its_source(tmp_path: Path, name: str) -> None:
    hull = offsets_of(name)
    body_plan = read(tmp_path, hull, points_of(hull))
    assert len(body_plan.stations) == len(hull["stations"])
    largest = max(station["area_to_T"] for station in hull["stations"])
    for station, true in zip(body_plan.stations, hull["stations"], strict=True):
        # the points are the truth's own; what is left is rounding and how a source closes a thin end
        assert station.area_below(hull["T"]) == pytest.approx(true["area_to_T"], rel=0.003, abs=0.003 * largest)
        if station.area_below(hull["T"]) > 0.3 * largest:
            assert station.area_below(hull["T"]) == pytest.approx(true["area_to_T"], rel=0.003)


@pytest.mark.parametrize("name", ["s60_cb60", "s60_cb70", "s60_cb80", "wigley"])
def test_a_wide_table_of_eight_waterlines_has_the_areas_within_a_per_cent(tmp_path: Path, name: str) -> None:
    hull = offsets_of(name)
    heights = hull["T"] * np.array([0.0, 0.075, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5])
    shown = [station for station in hull["stations"] if station["area_to_T"] > 0]
    rows: list[list[Any]] = [["height_m", *(station["x"] for station in shown)]]
    for height in heights:
        row: list[Any] = [height]
        for station in shown:
            y, z = np.array(station["points"]).T
            reaches = z[0] - 1e-6 <= height <= z[-1] + 1e-6
            row.append(f"{max(np.interp(height, z, y), 0.0):.4f}" if reaches else "")
        rows.append(row)
    body_plan = read(tmp_path, hull, rows)
    areas = np.array([station.area_below(hull["T"]) for station in body_plan.stations])
    true = np.array([station["area_to_T"] for station in shown])
    # Series 60 has its bilge between the base line and the first waterline; per cents of the largest section
    assert np.abs(areas - true).max() < 0.01 * true.max()
    assert areas.sum() == pytest.approx(true.sum(), rel=0.005)


@pytest.mark.parametrize("name", ["oural", "patrol27", "workboat70"])
def test_a_real_hull_comes_back_through_her_mesh(tmp_path: Path, name: str) -> None:
    offsets = offsets_of(name)
    body_plan = read(tmp_path, offsets, points_of(offsets))
    toml = tmp_path / "ship.toml"
    particulars = read_ship(toml).particulars
    hull = Hull.from_body_plan(body_plan, particulars)
    export_mesh(hull, tmp_path / "hull.stl")
    text = toml.read_text(encoding="utf-8")
    toml.write_text(text[: text.index("[body_plan]")] + '[body_plan]\nmesh = "hull.stl"\n', encoding="utf-8")
    again = Hull.from_body_plan(trace(read_ship(toml)), particulars)
    assert again.volume_m3 == pytest.approx(hull.volume_m3, rel=1e-3)
    for draught in (None, offsets["T"]):
        areas, back = (h.sectional_areas(draught, hull.x_m[1:-1]) for h in (hull, again))
        assert np.abs(back - areas).max() < 0.003 * areas.max()
