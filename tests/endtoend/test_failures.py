"""What a user does wrong gives one clear message, exit code 1, and nothing half-written."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest

from hullform.cli import main

ROOT = Path(__file__).parent.parent.parent
WIGLEY = ROOT / "bodyplans" / "wigley"


@pytest.fixture
def ship(tmp_path: Path) -> Path:
    """A copy of a good ship, to be spoiled."""
    for name in ("ship.toml", "bodyplan.png"):
        shutil.copy(WIGLEY / name, tmp_path / name)
    return tmp_path / "ship.toml"


def refused(ship: Path, capsys: pytest.CaptureFixture[str], command: str = "run") -> str:
    before = {path.name for path in ship.parent.iterdir()} if ship.parent.exists() else set()
    assert main([command, str(ship)]) == 1
    after = {path.name for path in ship.parent.iterdir()} if ship.parent.exists() else set()
    assert after == before
    said = capsys.readouterr()
    assert said.out == ""
    return said.err


def spoil(ship: Path, old: str, new: str) -> None:
    text = ship.read_text(encoding="utf-8")
    assert old in text
    ship.write_text(text.replace(old, new), encoding="utf-8")


def test_no_ship_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "no such file" in refused(tmp_path / "ship.toml", capsys)


def test_a_broken_ship_file(ship: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spoil(ship, "schema = 1", "schema = = 1")
    assert "is no TOML" in refused(ship, capsys)


def test_a_draught_above_the_depth(ship: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spoil(ship, "draught_m = 6.25", "draught_m = 7.25")
    said = refused(ship, capsys)
    assert "draught_m = 7.25 is above depth_m = 6.25" in said


def test_a_negative_weight(ship: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spoil(ship, "steel_weight_t = 850.0", "steel_weight_t = -850.0")
    assert "weights.steel_weight_t = -850.0: input should be greater than 0" in refused(ship, capsys)


def test_a_missing_picture(ship: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (ship.parent / "bodyplan.png").unlink()
    assert "bodyplan.png" in refused(ship, capsys)


def test_a_file_that_is_no_picture(ship: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (ship.parent / "bodyplan.png").write_bytes(b"not a picture at all")
    assert "bodyplan.png" in refused(ship, capsys, "trace")


def test_a_blank_picture(ship: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cv2.imwrite(str(ship.parent / "bodyplan.png"), np.full((1200, 1800), 255, np.uint8))
    assert "bodyplan.png" in refused(ship, capsys)


def test_too_few_curves(ship: Path, capsys: pytest.CaptureFixture[str]) -> None:
    # the frame of a body plan, and nothing in it
    empty = np.full((1200, 1800), 255, np.uint8)
    cv2.line(empty, (900, 100), (900, 1000), 0, 2)
    cv2.line(empty, (100, 1000), (1700, 1000), 0, 2)
    cv2.imwrite(str(ship.parent / "bodyplan.png"), empty)
    said = refused(ship, capsys, "mesh")
    assert "bodyplan.png" in said


def test_an_output_folder_of_others_is_kept(ship: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    other = tmp_path / "letters"
    other.mkdir()
    (other / "letter.txt").write_text("dear")
    assert main(["run", str(ship), "-o", str(other)]) == 1
    assert "--force" in capsys.readouterr().err
    assert (other / "letter.txt").read_text() == "dear"


def test_an_unknown_condition(ship: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["girder", str(ship), "--condition", "submerged"]) == 1
    assert "its conditions:" in capsys.readouterr().err


def test_usage_errors_end_with_two() -> None:
    with pytest.raises(SystemExit) as ended:
        main(["run"])
    assert ended.value.code == 2


def test_an_unknown_mesh_format(ship: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mesh", str(ship), "-o", str(ship.parent / "hull.xyz")]) == 1
    assert ".stl" in capsys.readouterr().err


@pytest.mark.parametrize("output", ["ship.toml", "bodyplan.png"])
@pytest.mark.parametrize("command", [["trace"], ["mesh"], ["girder", "--condition", "loaded"]])
def test_no_command_writes_over_what_it_reads(
    ship: Path, capsys: pytest.CaptureFixture[str], output: str, command: list[str]
) -> None:
    before = (ship.parent / output).read_bytes()
    assert main([command[0], str(ship), *command[1:], "-o", str(ship.parent / output)]) == 1
    assert "is what this command reads" in capsys.readouterr().err
    assert (ship.parent / output).read_bytes() == before


def test_a_second_moment_in_cm4_is_a_doubt(ship: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    text = ship.read_text(encoding="utf-8").replace("[structure]", "[structure]\nmidship_second_moment_m4 = 3e8\n#")
    ship.write_text(text, encoding="utf-8")
    assert main(["run", str(ship), "-o", str(tmp_path / "out")]) == 3
    said = capsys.readouterr()
    assert "first frequency against hulls of 100 m" in said.err
    assert "loaded *" in said.out


def test_girder_tells_the_doubts_of_its_condition(ship: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spoil(ship, "deadweight_t = 1597.2", "deadweight_t = 9000.0")
    assert main(["girder", str(ship), "--condition", "loaded"]) == 3
    assert "she would sink" in capsys.readouterr().err
    assert main(["girder", str(ship), "--condition", "light-ship"]) == 0


def test_a_reader_that_goes_away_is_no_error(ship: Path) -> None:
    command = Path(sys.executable).parent / "hullform"
    ran = subprocess.run(
        f"'{command}' trace '{ship}' -o '{ship.parent}/o.csv' | true; exit ${{PIPESTATUS[0]}}",
        shell=True,
        executable="/bin/bash",
        capture_output=True,
        text=True,
    )
    assert ran.stderr == ""
    assert ran.returncode == 0
