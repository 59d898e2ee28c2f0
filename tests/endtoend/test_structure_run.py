"""A ship with the plates of her midship section, from ship.toml to results.json and the girder file."""

from __future__ import annotations

import json
import shutil
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from jsonschema import Draft202012Validator

from hullform.cli import main
from hullvib.girder_files import read_girder

ROOT = Path(__file__).parents[2]
# Our own: a double-hull tanker's section in the hull of the paper's tanker, cargo from 50 to 235 m.
PLATES = """
stiffener_share = 0.4
inner_bottom = { height_m = 2.4, thickness_m = 0.018, from_m = 50.0, to_m = 235.0 }
double_side = { breadth_m = 2.4, thickness_m = 0.017, from_m = 50.0, to_m = 235.0 }
longitudinal_bulkheads = [{ y_m = 0.0, thickness_m = 0.017, from_m = 50.0, to_m = 235.0 }]
transverse_bulkheads = [{ x_m = [50.0, 81.0, 112.0, 143.0, 174.0, 205.0, 235.0], thickness_m = 0.014 }]
zones = [
    { part = "bottom", thickness_m = 0.02 },
    { part = "side", thickness_m = 0.018 },
    { part = "deck", thickness_m = 0.021 },
]
"""
CARGO = (50.0, 235.0)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The results of the run."""
    ship = tmp_path_factory.mktemp("plated") / "ds-tanker"
    shutil.copytree(ROOT / "bodyplans" / "ds-tanker", ship, ignore=shutil.ignore_patterns("results"))
    path = ship / "ship.toml"
    path.write_text(path.read_text(encoding="utf-8").replace("[structure]", "[structure]" + PLATES), encoding="utf-8")
    assert main(["run", str(path)]) in (0, 3)
    return ship / "results"


@pytest.fixture(scope="module")
def results(folder: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((folder / "results.json").read_text(encoding="utf-8"))
    return found


def test_results_follow_the_schema(results: dict[str, Any]) -> None:
    schema = json.loads(files("hullform").joinpath("results.schema.json").read_text(encoding="utf-8"))
    Draft202012Validator(schema).validate(results)
    structure = results["structure"]
    assert not structure["plain_shell"]
    names = {plates["name"] for plates in structure["midship_plates"]}
    assert names == {"bottom", "side", "deck", "inner bottom", "inner side", "bulkhead on the centre line"}


def test_the_model_comes_near_the_given_second_moment(results: dict[str, Any]) -> None:
    structure = results["structure"]
    scaled = structure["thickness_factor"] * structure["midship_shell_second_moment_m4"]
    assert scaled == pytest.approx(610.0, rel=1e-12)
    (check,) = (check for check in results["checks"] if check["id"] == "equivalent-thickness")
    assert check["ok"]
    assert check["limit"] == 1.5


def test_the_curves_jump_where_the_double_hull_begins_and_ends(results: dict[str, Any], folder: Path) -> None:
    structure = results["structure"]
    x, moment = (np.array(structure[name]) for name in ("x_m", "second_moment_m4"))
    (jumps,) = np.nonzero(np.diff(x) == 0)
    assert tuple(x[jumps]) == CARGO
    assert moment[jumps[0] + 1] > 1.1 * moment[jumps[0]]
    assert moment[jumps[1] + 1] < 0.95 * moment[jumps[1]]
    girder = read_girder(folder / "girder-loaded.json")
    assert set(CARGO) <= set(girder.breaks.tolist())
    # the end plates and seven bulkheads
    places = [point.x_m for point in girder.point_masses]
    assert places[1:8] == [50.0, 81.0, 112.0, 143.0, 174.0, 205.0, 235.0]


def test_the_mass_is_what_it_was(results: dict[str, Any], folder: Path) -> None:
    given = {"loaded": 16747.0 + 4481.0 + 114783.0, "light-ship": 16747.0 + 4481.0}
    for name, mass_t in given.items():
        assert results["conditions"][name]["mass_kg"] == pytest.approx(1e3 * mass_t, rel=1e-9)
    assert (folder / "figures" / "midship-section.svg").exists()
