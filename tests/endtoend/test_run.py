"""The main job on the ships of bodyplans/: from the picture to results.json, report and hull."""

from __future__ import annotations

import json
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from jsonschema import Draft202012Validator

from hullform import Hull, read_ship, trace
from hullvib import FiniteElements, Ritz, solve
from hullvib.girder_files import read_girder

ROOT = Path(__file__).parent.parent.parent
SHIPS = ("scim-containership", "ds-tanker", "wigley")
PAPER_SHIPS = SHIPS[:2]
CONDITIONS = [
    (ship, condition.name)
    for ship in SHIPS
    for condition in read_ship(ROOT / "bodyplans" / ship / "ship.toml").conditions
]
SLOWEST = ("ds-tanker", "light-ship")
Runs = Callable[[str], Any]


@pytest.mark.parametrize("ship", SHIPS)
def test_a_run_leaves_every_file(finished_run: Runs, ship: str) -> None:
    run = finished_run(ship)
    assert run.code in (0, 3)
    names = {path.name for path in run.folder.iterdir()}
    girders = {f"girder-{name}.json" for name in run.results["conditions"]}
    assert names == {"results.json", "report.html", "hull.stl", "offsets.csv", "figures"} | girders
    assert run.code == (3 if run.results["doubts"] else 0)


@pytest.mark.parametrize("ship", SHIPS)
def test_results_keep_to_the_schema(finished_run: Runs, ship: str) -> None:
    schema = json.loads(files("hullform").joinpath("results.schema.json").read_text(encoding="utf-8"))
    Draft202012Validator(schema).validate(finished_run(ship).results)


@pytest.mark.parametrize(
    ("ship", "condition"),
    [
        pytest.param(
            *which,
            marks=pytest.mark.xfail(
                condition=which == SLOWEST,
                raises=AssertionError,
                strict=True,
                reason="mode 3 is 0.618 % high with 12 functions: the light tanker carries her deck machinery, 54 t/m, "
                "out to a stem tip whose EI is below a hundredth of midships, where smooth functions cannot follow",
            ),
        )
        for which in CONDITIONS
    ],
)
def test_ritz_and_finite_elements_agree(finished_run: Runs, ship: str, condition: str) -> None:
    dry = finished_run(ship).results["conditions"][condition]["dry_rad_s"]
    # EI is linear between a hundred stations and mass jumps: a few tenths of a per cent for twelve smooth functions
    np.testing.assert_allclose(dry["ritz"][:3], dry["finite_element"][:3], rtol=0.005)


@pytest.mark.parametrize(("ship", "condition"), CONDITIONS)
def test_ritz_lies_above_finite_elements(finished_run: Runs, ship: str, condition: str) -> None:
    dry = finished_run(ship).results["conditions"][condition]["dry_rad_s"]
    # both are upper bounds, and the elements' is the sharper by far: they err by 1e-5 at most
    assert (np.array(dry["ritz"][:3]) >= np.array(dry["finite_element"][:3]) * (1 - 1e-6)).all()


def test_the_light_tanker_takes_sixteen_functions(finished_run: Runs) -> None:
    ship, condition = SLOWEST
    run = finished_run(ship)
    girder = read_girder(run.folder / f"girder-{condition}.json")
    ritz = solve(girder, Ritz(functions=16), modes=3).angular_frequencies
    elements = run.results["conditions"][condition]["dry_rad_s"]["finite_element"][:3]
    # mode 3 is 0.468 % high with 16 functions, 0.618 % with 12
    np.testing.assert_allclose(ritz, elements, rtol=0.005)


@pytest.mark.parametrize("ship", SHIPS)
def test_the_papers_basis_comes_out_low(finished_run: Runs, ship: str) -> None:
    for condition in finished_run(ship).results["conditions"].values():
        dry = condition["dry_rad_s"]
        assert dry["ritz_elastic_only"][0] < dry["finite_element"][0]


@pytest.mark.parametrize("ship", SHIPS)
def test_the_girder_files_give_the_same_frequencies(finished_run: Runs, ship: str) -> None:
    run = finished_run(ship)
    for name, condition in run.results["conditions"].items():
        girder = read_girder(run.folder / f"girder-{name}.json")
        assert girder.total_mass == pytest.approx(condition["mass_kg"], rel=1e-12)
        again = solve(girder, Ritz(functions=12), modes=5).angular_frequencies
        # the same arithmetic on the same bits
        np.testing.assert_allclose(again, condition["dry_rad_s"]["ritz"], rtol=1e-12)
        fine = solve(girder, FiniteElements(elements=400), modes=3).angular_frequencies
        # 100 elements err below 1e-5 here (fourth order in omega^2), 400 by round-off
        np.testing.assert_allclose(condition["dry_rad_s"]["finite_element"][:3], fine, rtol=1e-5)


@pytest.mark.parametrize("ship", SHIPS)
def test_each_weight_keeps_its_mass_and_first_moment(finished_run: Runs, ship: str) -> None:
    run = finished_run(ship)
    for name, condition in run.results["conditions"].items():
        weights = condition["weights"]
        mass = sum(weight["mass_kg"] for weight in weights)
        moment = sum(weight["mass_kg"] * (weight["centre_m"] or 0.0) for weight in weights)
        girder = read_girder(run.folder / f"girder-{name}.json")
        assert girder.total_mass == pytest.approx(mass, rel=1e-9)
        assert girder.centre_of_gravity == pytest.approx(moment / mass, rel=1e-9)


@pytest.mark.parametrize("ship", PAPER_SHIPS)
def test_the_weights_are_those_of_the_ship_file(finished_run: Runs, ship: str) -> None:
    # Table 1 of the paper: light weight and displacement
    light, loaded = {"scim-containership": (16875, 74660), "ds-tanker": (21228, 136011)}[ship]
    conditions = finished_run(ship).results["conditions"]
    assert conditions["light-ship"]["mass_kg"] == pytest.approx(light * 1e3, rel=1e-9)
    assert conditions["loaded"]["mass_kg"] == pytest.approx(loaded * 1e3, rel=1e-9)


@pytest.mark.parametrize("ship", PAPER_SHIPS)
def test_displacement_from_the_picture(finished_run: Runs, ship: str) -> None:
    # the drawing holds Table 1 within 0.3 %; reading and lofting add a few tenths
    displacement = finished_run(ship).results["hull"]["hydrostatics"]["displacement_kg"]
    table_1 = {"scim-containership": 74660, "ds-tanker": 136011}[ship]
    assert displacement / 1e3 == pytest.approx(table_1, rel=0.006)


def test_wigley_volume_from_its_picture(finished_run: Runs) -> None:
    results = finished_run("wigley").results
    of_ship = results["ship"]
    box = of_ship["length_between_perpendiculars_m"] * of_ship["breadth_m"] * of_ship["draught_m"]
    assert results["hull"]["hydrostatics"]["volume_m3"] == pytest.approx(4 / 9 * box, rel=0.005)


@pytest.mark.parametrize("ship", SHIPS)
def test_the_mesh_is_watertight_and_holds_the_sections_volume(finished_run: Runs, ship: str) -> None:

    described = read_ship(ROOT / "bodyplans" / ship / "ship.toml")
    hull = Hull.from_body_plan(trace(described), described.particulars)
    mesh = trimesh.load_mesh(finished_run(ship).folder / "hull.stl")
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(hull.volume_m3, rel=1e-3)


@pytest.mark.parametrize("ship", PAPER_SHIPS)
def test_the_midship_second_moment_is_the_given_one(finished_run: Runs, ship: str) -> None:
    structure = finished_run(ship).results["structure"]
    given = {"scim-containership": 253.0, "ds-tanker": 610.0}[ship]
    scaled = structure["thickness_factor"] * structure["midship_shell_second_moment_m4"]
    assert scaled == pytest.approx(given, rel=1e-12)
    assert structure["equivalent_thickness_m"] == pytest.approx(0.016 * structure["thickness_factor"], rel=1e-12)
    # the bare shell lies below the sharp-cornered hollow box and above the one with p = q = 6 of the same B and D
    box, rounded = {"scim-containership": (117.47, 105.94), "ds-tanker": (188.85, 170.87)}[ship]
    assert rounded < structure["midship_shell_second_moment_m4"] < box


@pytest.mark.parametrize(("ship", "condition"), CONDITIONS)
def test_the_bracket_holds_the_finite_element_frequencies(finished_run: Runs, ship: str, condition: str) -> None:
    run = finished_run(ship)
    found = run.results["conditions"][condition]
    lower, upper = (np.array(found["bracket_rad_s"][side]) for side in ("lower", "upper"))
    assert ((upper - lower) / upper)[:3].max() <= 1e-6
    # upper bounds too, of one Stodola step fewer than the bracket's
    assert (lower <= np.array(found["dry_rad_s"]["stodola_ritz"])).all()
    fine = solve(read_girder(run.folder / f"girder-{condition}.json"), FiniteElements(elements=800), modes=3)
    # finite elements bound from above too; 800 are good to 1e-8, and their own round-off is below that
    assert (fine.angular_frequencies >= lower[:3]).all()
    assert fine.angular_frequencies == pytest.approx(upper[:3], rel=1e-6)


@pytest.mark.parametrize(("ship", "condition"), CONDITIONS)
def test_shear_and_rotary_inertia_lower_every_mode(finished_run: Runs, ship: str, condition: str) -> None:
    dry = finished_run(ship).results["conditions"][condition]["dry_rad_s"]
    assert (np.array(dry["shear"]) < np.array(dry["stodola_ritz"])).all()
    assert (np.array(dry["timoshenko"]) < np.array(dry["shear"])).all()


@pytest.mark.parametrize("ship", SHIPS)
def test_the_headline_is_the_shear_flexible_girder_in_water(finished_run: Runs, ship: str) -> None:
    for condition in finished_run(ship).results["conditions"].values():
        headline = condition["headline"]
        assert (headline["medium"], headline["theory"]) == ("wet", "shear-flexible")
        np.testing.assert_allclose(
            2 * np.pi * np.array(headline["frequencies_hz"]), condition["wet_rad_s"]["shear"], rtol=1e-14
        )
