"""`hullvib solve` by its further methods: Timoshenko's beam, shapes in files, hints, and the line that is wrong."""

import json

import numpy as np
import pytest

from hullvib.cli import main

PLAIN = "x_m,mass_kg_per_m,flexural_rigidity_N_m2\n0,1,1\n1,1,1\n"
# r^2 = 0.0009, s^2 = 0.0045 of test_timoshenko_beams.py
THICK = (
    "x_m,mass_kg_per_m,flexural_rigidity_N_m2,shear_rigidity_N,rotary_inertia_kg_m\n"
    "0,1,1,222.22222222222222,0.0009\n1,1,1,222.22222222222222,0.0009\n"
)
OMEGA = [21.3540475685849563, 54.2151245952879069, 96.2774724102625469]


@pytest.fixture
def thick(tmp_path):
    path = tmp_path / "thick.csv"
    path.write_text(THICK)
    return str(path)


@pytest.fixture
def plain(tmp_path):
    path = tmp_path / "plain.csv"
    path.write_text(PLAIN)
    return str(path)


@pytest.mark.parametrize(
    ("options", "method", "tolerance"),
    [
        (["timoshenko"], "timoshenko_ritz", 1e-10),
        # Legendre series of 12: 6e-8 on mode 3; uniform modes: 5e-6
        (["timoshenko", "--functions", "12"], "timoshenko_ritz", 1e-7),
        (["timoshenko", "--basis", "uniform"], "timoshenko_ritz", 1e-5),
        # (g h)^4 / 1440 in omega
        (["timoshenko-fem"], "timoshenko_element", 1e-6),
        (["timoshenko-fem", "--elements", "50"], "timoshenko_element", 1e-5),
    ],
)
def test_timoshenkos_beam(thick, capsys, options, method, tolerance):
    assert main(["solve", thick, "--modes", "3", "--json", "--method", *options]) == 0
    out, err = capsys.readouterr()
    assert "note" not in err
    (solution,) = json.loads(out)["solutions"]
    assert (solution["method"], solution["theory"]) == (method, "Timoshenko")
    assert solution["frequencies_rad_s"] == pytest.approx(OMEGA, rel=tolerance)
    assert "the theory is Timoshenko" in solution["not_proven"]
    assert "lower_rad_s" not in solution


def test_stodola_with_shear_and_fem_with_rotary_inertia(thick, plain, capsys):
    assert main(["solve", thick, "--shear", "--modes", "2"]) == 0
    out, _ = capsys.readouterr()
    assert "; shear-flexible, dry; stodola ritz" in out
    assert "numerical error not proven: bounds exist for the Euler-Bernoulli beam only" in out
    assert main(["solve", thick, "--method", "fem", "--rotary-inertia", "--modes", "2"]) == 0
    assert "; Euler-Bernoulli with rotary inertia, dry; finite element" in capsys.readouterr().out
    assert main(["solve", plain, "--method", "fem", "--rotary-inertia"]) == 0
    assert "rotary inertia none given, taken as zero" in capsys.readouterr().out


def test_a_shear_rigidity_that_is_left_out_is_mentioned_and_one_that_lacks_is_asked_for(thick, plain, capsys):
    assert main(["solve", thick]) == 0
    assert "note: the girder has a shear rigidity, which Euler-Bernoulli leaves out" in capsys.readouterr().err
    assert main(["solve", plain, "--method", "timoshenko"]) == 1
    assert "shear_rigidity_N" in capsys.readouterr().err


def test_a_tolerance_chooses_the_functions(tmp_path, capsys):
    path = tmp_path / "steps.csv"
    path.write_text(PLAIN.splitlines()[0] + "\n0,1,1\n0.3,2,2\n0.3,1,0.7\n1,1,1\n")
    used = []
    for tolerance in ("1e-3", "1e-7"):
        assert main(["solve", str(path), "--tolerance", tolerance, "--json"]) == 0
        (solution,) = json.loads(capsys.readouterr().out)["solutions"]
        lower, upper = np.array(solution["lower_rad_s"]), np.array(solution["upper_rad_s"])
        assert ((upper - lower) / upper < float(tolerance)).all()
        used.append((solution["functions"], solution["steps"]))
    assert used[0] < used[1]
    assert main(["solve", str(path), "--tolerance", "1e-6"]) == 0
    assert "tolerance 1e-06" in capsys.readouterr().out
    assert main(["solve", str(path), "--tolerance", "0"]) == 1
    assert "tolerance is 0" in capsys.readouterr().err
    for further in (["--method", "ritz"], ["--functions", "8"]):
        with pytest.raises(SystemExit) as stop:
            main(["solve", str(path), "--tolerance", "1e-6", *further])
        assert stop.value.code == 2
        assert "--tolerance chooses the method" in capsys.readouterr().err


def test_a_sharp_end_is_solved_and_the_missing_proof_explained(tmp_path, capsys):
    path = tmp_path / "wedge.json"
    path.write_text(
        '{"form": "power", "breaks_m": [0, 1], "mass_kg_per_m": [[1, -1]], "flexural_rigidity_N_m2": [[1, -3, 3, -1]]}'
    )
    assert main(["solve", str(path), "--method", "ritz", "--basis", "legendre", "--modes", "3"]) == 0
    out, _ = capsys.readouterr()
    # tests/data/exact_beams.json, wedge_sharp
    assert [line.split()[3] for line in out.splitlines()[2:5]] == ["12.7575", "27.7554", "47.5759"]
    assert "numerical error not proven: the flexural rigidity vanishes at x = 1 m" in out


@pytest.mark.parametrize("suffix", ["csv", "json"])
def test_shapes_are_written(thick, tmp_path, capsys, suffix):
    target = tmp_path / f"shapes.{suffix}"
    assert main(["solve", thick, "--method", "timoshenko", "--modes", "2", "--shapes", str(target)]) == 0
    text = target.read_text()
    if suffix == "csv":
        header = next(line for line in text.splitlines() if not line.startswith("#"))
        assert header.startswith("x_m,mode_1_deflection_m,mode_1_rotation_rad,mode_1_moment_N_m,mode_1_shear_N,mode_2")
        assert np.loadtxt(target, delimiter=",", skiprows=4).shape == (101, 9)
    else:
        assert len(json.loads(text)["solutions"][0]["shapes"]["deflection_m"]) == 2
    capsys.readouterr()
    assert main(["solve", thick, "--shapes", str(tmp_path / "shapes.txt")]) == 1
    assert "write .csv or .json" in capsys.readouterr().err
    assert not (tmp_path / "shapes.txt").exists()


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("0,1,1\n2,1,1\n1,1,1\n", "line 4: x_m falls from 2 to 1"),
        ("0,1,1\n1,nan,1\n", "line 3: mass_kg_per_m is nan"),
        ("0,1,1\n1,-1,1\n", "line 3: mass_kg_per_m is -1; it must not be negative"),
        ("0,1,1\n1,1,0\n2,1,1\n", "line 3: flexural_rigidity_N_m2 is 0 at x_m = 1"),
        ("0,1,1\n", "has 1 rows of numbers; a girder needs at least 2"),
        ("0,1,1\n0,1,1\n", "line 3: x_m ends at 0"),
        ("0,0,1\n1,0,1\n", "no mass at all"),
    ],
)
def test_a_bad_table_is_refused_in_one_line_that_names_its_line(tmp_path, capsys, rows, message):
    path = tmp_path / "bad.csv"
    path.write_text(PLAIN.splitlines()[0] + "\n" + rows)
    assert main(["solve", str(path)]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"hullvib: {path}")
    assert message in err
    assert err.count("\n") == 1


def test_a_mass_outside_the_girder_is_refused(tmp_path, capsys):
    path = tmp_path / "outside.json"
    path.write_text(
        '{"breaks_m": [0, 1], "mass_kg_per_m": [[1]], "flexural_rigidity_N_m2": [[1]],\n'
        ' "point_masses": [{"x_m": 1.5, "mass_kg": 3}]}'
    )
    assert main(["solve", str(path)]) == 1
    assert "a point mass of 3 kg lies at x = 1.5 m, outside 0 .. 1 m" in capsys.readouterr().err


def test_a_table_that_yields_an_absurd_frequency_is_doubted(tmp_path, capsys):
    # a rigidity in t m^2 (1e4 N m^2 apart) of a ship of 200 m: 0.03 rad/s
    path = tmp_path / "tonnes.csv"
    path.write_text(PLAIN.splitlines()[0] + "\n0,3e5,9e8\n200,3e5,9e8\n")
    assert main(["solve", str(path)]) == 0
    out, err = capsys.readouterr()
    assert "  0.0306 " in out
    assert "warning: the first frequency is 0.00488 Hz, outside 0.15 .. 15 Hz" in err
    assert "mass in kg/m (not t/m), flexural rigidity in N m^2 (not kN m^2)" in err
