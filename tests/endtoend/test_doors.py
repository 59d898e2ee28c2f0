"""One ship through every door: her picture, the table and the mesh that came of it, and her particulars alone."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
from form_ship import form_ship

from hullform.cli import main

ROOT = Path(__file__).parent.parent.parent
SHIP = ROOT / "bodyplans" / "ds-tanker" / "ship.toml"
SCHEMA = json.loads((ROOT / "src" / "hullform" / "results.schema.json").read_text(encoding="utf-8"))
DOORS = {
    "offsets": '[body_plan]\noffsets = "offsets.csv"\n',
    "mesh": '[body_plan]\nmesh = "hull.stl"\n',
    "particulars": "",
}
# Of a figure of the picture's: table and mesh are of her own hull; a form of the particulars has her fullness, not her
# lines.
AGREEMENT = {"offsets": 1e-4, "mesh": 1e-3, "particulars": 0.02}
Runs = Callable[[str], Any]


@pytest.fixture(scope="module")
def through(finished_run: Runs, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], tuple[int, Path, Any]]:
    """Runs the tanker through one door, with what her picture's run wrote: exit code, folder, results."""
    known: dict[str, tuple[int, Path, Any]] = {}
    text = SHIP.read_text(encoding="utf-8")
    before, after = text[: text.index("[body_plan]")], text[text.index("[structure]") :]

    def run(door: str) -> tuple[int, Path, Any]:
        if door not in known:
            folder = tmp_path_factory.mktemp(door)
            for name in ("offsets.csv", "hull.stl"):
                shutil.copy(finished_run("ds-tanker").folder / name, folder)
            (folder / "ship.toml").write_text(before + DOORS[door] + after, encoding="utf-8")
            code = main(["run", str(folder / "ship.toml")])
            results = json.loads((folder / "results" / "results.json").read_text(encoding="utf-8"))
            known[door] = code, folder / "results", results
        return known[door]

    return run


@pytest.mark.parametrize("door", DOORS)
def test_the_same_ship_vibrates_alike_through_every_door(finished_run: Runs, through: Any, door: str) -> None:
    _, _, results = through(door)
    drawn = finished_run("ds-tanker").results
    assert results["hull"]["source"] == door
    for name, condition in drawn["conditions"].items():
        found = results["conditions"][name]
        assert found["mass_kg"] == pytest.approx(condition["mass_kg"], rel=1e-9)
        for theory in ("stodola_ritz", "shear", "timoshenko"):
            np.testing.assert_allclose(
                found["dry_rad_s"][theory][:3], condition["dry_rad_s"][theory][:3], rtol=AGREEMENT[door]
            )
    volume, lcb = (drawn["hull"]["hydrostatics"][key] for key in ("volume_m3", "lcb_x_m"))
    assert results["hull"]["hydrostatics"]["volume_m3"] == pytest.approx(volume, rel=min(AGREEMENT[door], 5e-3))
    assert results["hull"]["hydrostatics"]["lcb_x_m"] == pytest.approx(lcb, rel=0.01)


@pytest.mark.parametrize("door", DOORS)
def test_every_door_leads_to_the_same_kind_of_report(finished_run: Runs, through: Any, door: str) -> None:
    _, folder, results = through(door)
    jsonschema.validate(results, SCHEMA)
    names = {path.name for path in folder.iterdir()}
    assert names == {path.name for path in finished_run("ds-tanker").folder.iterdir()}
    figures = {path.name for path in (folder / "figures").iterdir()}
    drawn = {path.name for path in (finished_run("ds-tanker").folder / "figures").iterdir()}
    # the one that shows the picture
    assert drawn - figures == {"overlay.jpg"}
    page = (folder / "report.html").read_text(encoding="utf-8")
    headings = re.findall(r'<h2 id="([\w-]+)">', page)
    assert headings == re.findall(
        r'<h2 id="([\w-]+)">', (finished_run("ds-tanker").folder / "report.html").read_text(encoding="utf-8")
    )
    assert "traced from the picture" not in page


def test_provenance_names_the_file_of_the_form(finished_run: Runs, through: Any) -> None:
    of = {door: through(door)[2]["provenance"] for door in DOORS} | {
        "picture": finished_run("ds-tanker").results["provenance"]
    }
    files = {door: provenance["body_plan_file"] for door, provenance in of.items()}
    assert files == {"picture": "bodyplan.png", "offsets": "offsets.csv", "mesh": "hull.stl", "particulars": None}
    assert (of["particulars"]["body_plan_file_sha256"], len(of["mesh"]["body_plan_file_sha256"])) == (None, 64)


def test_a_form_of_the_particulars_is_marked_everywhere(through: Any, capsys: pytest.CaptureFixture[str]) -> None:
    code, folder, results = through("particulars")
    assert code == 3
    assert results["doubts"][0].startswith("there is no drawing: the hull is a form made of the main particulars")
    assert any("estimated (Kerlen)" in note for note in results["hull"]["notes"])
    page = (folder / "report.html").read_text(encoding="utf-8")
    assert "No drawing: her hull is a form made of the main particulars." in page
    assert main(["mesh", str(folder.parent / "ship.toml"), "-o", str(folder.parent / "form.stl")]) == 3
    assert "there is no drawing" in capsys.readouterr().err
    for door in ("offsets", "mesh"):
        assert "No drawing" not in (through(door)[1] / "report.html").read_text(encoding="utf-8")


def test_the_terminal_says_that_there_is_no_drawing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    form_ship(tmp_path)
    assert main(["run", str(tmp_path / "ship.toml")]) == 3
    said = capsys.readouterr()
    assert "No drawing: her hull is a form made of these main particulars." in said.out.splitlines()
    assert "doubt: there is no drawing" in said.err


def test_trace_cuts_a_mesh_into_a_table_that_is_read_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    form_ship(tmp_path)
    assert main(["mesh", str(tmp_path / "ship.toml"), "-o", str(tmp_path / "hull.ply")]) == 3
    form_ship(tmp_path, '[body_plan]\nmesh = "hull.ply"\n')
    assert main(["trace", str(tmp_path / "ship.toml"), "-o", str(tmp_path / "cut.csv")]) == 0
    assert "note: hull.ply: " in capsys.readouterr().out
    form_ship(tmp_path, '[body_plan]\noffsets = "cut.csv"\n')
    assert main(["girder", str(tmp_path / "ship.toml"), "--condition", "loaded"]) in (0, 3)
    assert (tmp_path / "girder-loaded.json").exists()


@pytest.mark.parametrize(
    ("body_plan", "arguments", "told"),
    [
        (DOORS["offsets"], ["trace"], "offsets.csv: is what this command reads; choose another file with -o"),
        (DOORS["mesh"], ["mesh"], "hull.stl: is what this command reads; choose another file with -o"),
        (DOORS["mesh"], ["review", "--no-browser"], "her form comes from hull.stl, and this needs a picture"),
        ("", ["review", "--no-browser"], "her form comes from her particulars, and this needs a picture"),
        ("", ["trace", "--overlay", "o.png"], "her form comes from her particulars, and this needs a picture"),
        (DOORS["offsets"], ["run"], "offsets.csv: no such file; body_plan.offsets names it"),
        (DOORS["mesh"], ["run"], "hull.stl: no such file; body_plan.mesh names it"),
    ],
)
def test_commands_refuse_what_a_door_does_not_have(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], body_plan: str, arguments: list[str], told: str
) -> None:
    form_ship(tmp_path, body_plan)
    command, *options = arguments
    assert main([command, str(tmp_path / "ship.toml"), *options]) == 1
    assert told in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["ship.toml"]
