"""The command `hullvib solve`, in this process and in one of its own."""

import io
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from hullvib import Girder, PointMass, write_girder
from hullvib.cli import main

HEAVY = ("cv2", "trimesh", "matplotlib", "pydantic", "shapely", "jinja2", "hullform")
CSV = "x_m,mass_kg_per_m,flexural_rigidity_N_m2\n0,5e4,1e13\n100,5e4,1e13\n"
# 22.3732854 / (2 pi) sqrt(1e13 / (5e4 1e8))
FIRST_HZ = 5.03576


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "uniform.csv"
    path.write_text(CSV)
    return str(path)


def test_table(file, capsys):
    assert main(["solve", file, "--modes", "3"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    lines = out.splitlines()
    assert lines[0].startswith("uniform: 100 m, 5000 t; Euler-Bernoulli, dry; stodola ritz (functions 12, steps 2)")
    assert lines[1].split() == ["mode", "Hz", "cycles/min", "rad/s", "nodes", "numerical", "error"]
    assert lines[2].split()[:-1] == ["1", "5.0358", "302.15", "31.6406", "2", "below"]
    # the exact function is among the trial functions: what is charged for round-off is left
    assert 0 < float(lines[2].split()[-1]) <= 1e-6
    assert lines[5] == (
        "The numerical error is that of the beam solution, proven; it says nothing of the girder's data."
    )
    assert len(lines) == 6


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ([], {"method": "stodola_ritz", "functions": 12, "steps": 2}),
        (["--functions", "8", "--steps", "3"], {"method": "stodola_ritz", "functions": 8, "steps": 3}),
        (["--method", "ritz"], {"method": "ritz", "functions": 12, "rigid_body": True}),
        (["--method", "ritz", "--basis", "legendre"], {"method": "ritz", "functions": 12, "basis": "legendre"}),
        (["--method", "fem"], {"method": "finite_element", "elements": 100}),
        (["--method", "fem", "--elements", "40"], {"method": "finite_element", "elements": 40}),
    ],
)
def test_json(file, capsys, options, expected):
    assert main(["solve", file, "--json", "--modes", "4", *options]) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["girder"] == "uniform"
    (solution,) = content["solutions"]
    assert solution.items() >= {**expected, "theory": "Euler-Bernoulli", "medium": "dry"}.items()
    assert solution["node_counts"] == [2, 3, 4, 5]
    assert np.less_equal(solution["lower_rad_s"], solution["upper_rad_s"]).all()
    assert solution["proof"]
    # 40 elements leave 1.5e-7 on mode 1
    assert solution["frequencies_hz"][0] == pytest.approx(FIRST_HZ, rel=1e-6)
    assert solution["frequencies_rad_s"][0] == pytest.approx(31.64061, rel=1e-6)


def test_json_girders_and_the_standard_input(tmp_path, capsys, monkeypatch):
    girder = Girder([0, 100], [5e4, 5e4], [1e13, 1e13], point_masses=[PointMass(0, 1e5)], name="with mass")
    write_girder(girder, tmp_path / "g.json")
    assert main(["solve", str(tmp_path / "g.json"), "--json"]) == 0
    from_file = json.loads(capsys.readouterr().out)
    assert from_file["girder"] == "with mass"
    text = (tmp_path / "g.json").read_bytes()
    # with and without the mark that some programs put before UTF-8
    for content in (text, b"\xef\xbb\xbf" + text):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(content)))
        assert main(["solve", "-", "--json"]) == 0
        assert json.loads(capsys.readouterr().out) == from_file
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"x_m,mass\xff\n")))
    assert main(["solve", "-"]) == 1
    assert "standard input: is not text in UTF-8" in capsys.readouterr().err
    monkeypatch.setattr(sys, "stdin", None)
    assert main(["solve", "-"]) == 1
    assert "standard input: is closed" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (CSV + "90,1,1\n", "line 4: x_m falls from 100 to 90"),
        (CSV.replace("100,5e4", "100,nan"), "line 3: mass_kg_per_m is nan"),
        ("", "is empty"),
    ],
)
def test_wrong_input_is_one_line_and_exit_code_1(tmp_path, capsys, text, message):
    path = tmp_path / "g.csv"
    path.write_text(text)
    assert main(["solve", str(path)]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert message in err
    assert err.count("\n") == 1


def test_too_many_modes_and_a_missing_file_are_exit_code_1(file, capsys):
    assert main(["solve", file, "--modes", "13"]) == 1
    assert "13 modes were asked of 12" in capsys.readouterr().err
    assert main(["solve", "no-such.csv"]) == 1
    assert "cannot be read" in capsys.readouterr().err


@pytest.mark.parametrize(
    "arguments",
    [[], ["solve"], ["solve", "g.csv", "--method", "magic"], ["solve", "g.csv", "--elements", "5"],
     ["solve", "g.csv", "--method", "fem", "--functions", "5"], ["solve", "g.csv", "--method", "ritz", "--shear"]],
)  # fmt: skip
def test_wrong_usage_is_exit_code_2(arguments, capsys):
    with pytest.raises(SystemExit) as stop:
        main(arguments)
    assert stop.value.code == 2
    assert "usage: hullvib" in capsys.readouterr().err


@pytest.mark.parametrize("factor", [1e-3, 1e3])
def test_a_table_in_wrong_units_is_doubted(tmp_path, capsys, factor):
    path = tmp_path / "g.csv"
    path.write_text(CSV.replace("5e4", repr(5e4 * factor)))
    assert main(["solve", str(path)]) == 0
    err = capsys.readouterr().err
    assert "warning: the first frequency is" in err
    assert "0.3 .. 30 Hz" in err
    assert "kg/m" in err


def test_import_and_command_load_none_of_the_heavy_packages(file):
    # the imports of this process are pytest's; a fresh one tells
    script = (
        "import sys, hullvib\n"
        f"heavy = {HEAVY!r}\n"
        "def loaded(): return sorted(m for m in heavy if m in sys.modules)\n"
        "assert not loaded(), loaded()\n"
        "assert 'scipy.sparse.linalg' not in sys.modules\n"
        "from hullvib.cli import main\n"
        f"assert main(['solve', {file!r}]) == 0\n"
        f"assert main(['solve', {file!r}, '--method', 'fem', '--json']) == 0\n"
        "assert not loaded(), loaded()\n"
    )
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr


def test_a_short_test_beam_is_not_doubted(tmp_path, capsys):
    path = tmp_path / "beam.csv"
    path.write_text("x_m,mass_kg_per_m,flexural_rigidity_N_m2\n0,5.7,175\n2.445,5.7,175\n")
    assert main(["solve", str(path)]) == 0
    assert capsys.readouterr().err == ""


COMMAND = [sys.executable, "-c", "import sys; from hullvib.cli import main; sys.exit(main())", "solve"]


def test_output_that_nobody_reads_is_dropped_quietly(file):
    process = subprocess.Popen([*COMMAND, file, "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    process.stdout.close()
    errors = process.stderr.read()
    process.stderr.close()
    assert (process.wait(60), errors) == (0, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full here")
def test_output_that_cannot_be_written_is_one_line_and_exit_code_1(file):
    with open("/dev/full", "w") as full:
        done = subprocess.run([*COMMAND, file], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
    assert done.returncode == 1
    assert done.stderr == "hullvib: the standard output cannot be written (No space left on device).\n"


def test_a_closed_output_is_one_line_and_exit_code_1(file, capsys, monkeypatch):
    monkeypatch.setattr(sys, "stdout", None)
    assert main(["solve", file]) == 1
    assert capsys.readouterr().err == (
        "hullvib: the standard output is closed; there is nowhere to write the frequencies.\n"
    )


def test_an_interrupt_is_exit_code_130(capsys, monkeypatch):
    class Interrupted(io.BytesIO):
        def read(self, size=-1):
            raise KeyboardInterrupt

    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(Interrupted()))
    assert main(["solve", "-"]) == 130
    assert capsys.readouterr().err == "hullvib: interrupted\n"


@pytest.mark.parametrize("values", ["1e-300,1e300", "1e200,1e-200"])
def test_a_girder_whose_figures_overflow_is_refused_and_nothing_called_proven(tmp_path, capsys, values):
    table = tmp_path / "g.csv"
    table.write_text(f"x_m,mass_kg_per_m,flexural_rigidity_N_m2\n0,{values}\n9,{values}\n")
    assert main(["solve", str(table)]) == 1
    out, error = capsys.readouterr()
    assert out == ""
    assert error.count("\n") == 1
    assert "too large or too small" in error
