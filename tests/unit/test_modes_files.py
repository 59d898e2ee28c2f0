"""Modes in CSV and JSON: units in the headers, every digit read back, whole or not at all."""

import json

import numpy as np
import pytest

from hullvib import Girder, Ritz, solve
from hullvib.errors import ModeFileError
from hullvib.mode_files import modes_csv, modes_json, write_modes

MODES = solve(Girder([0, 20, 60], [3e4, 5e4, 2e4], [2e12, 8e12, 1e12], name="toy"), Ritz(12), modes=2)
X = [0.0, 13.0, 60.0]


def test_csv_holds_frequencies_units_and_every_digit(tmp_path):
    write_modes(MODES, tmp_path / "m.csv", X)
    lines = (tmp_path / "m.csv").read_text().splitlines()
    assert lines[0] == "# toy: Euler-Bernoulli, dry; largest |amplitude| 1, positive at the aft end"
    assert lines[1].startswith(f"# mode 1: {float(MODES.frequencies_hz[0])!r} Hz, ")
    assert lines[3].split(",")[:5] == [
        "x_m", "mode_1_deflection_m", "mode_1_rotation_rad", "mode_1_moment_N_m", "mode_1_shear_N"
    ]  # fmt: skip
    assert len(lines) == 4 + 3
    table = np.loadtxt(tmp_path / "m.csv", delimiter=",", skiprows=4)
    assert np.array_equal(table[:, 0], X)
    for n in range(2):
        expected = [MODES.shape(X)[n], MODES.rotation(X)[n], MODES.moment(X)[n], MODES.shear(X)[n]]
        assert np.array_equal(table[:, 1 + 4 * n : 5 + 4 * n], np.stack(expected, axis=1))
    assert [path.name for path in tmp_path.iterdir()] == ["m.csv"]


def test_json_holds_the_record_and_the_shapes(tmp_path):
    write_modes(MODES, tmp_path / "m.json")
    content = json.loads((tmp_path / "m.json").read_text())
    assert content["girder"] == "toy"
    (solution,) = content["solutions"]
    assert solution["frequencies_rad_s"] == MODES.angular_frequencies.tolist()
    assert solution["modal_mass_kg"] == MODES.modal_mass.tolist()
    shapes = solution["shapes"]
    assert set(shapes) == {"normalisation", "x_m", "deflection_m", "rotation_rad", "moment_N_m", "shear_N"}
    assert shapes["x_m"] == np.linspace(0, 60, 101).tolist()
    assert shapes["moment_N_m"] == MODES.moment(shapes["x_m"]).tolist()
    assert modes_json(MODES, X) == modes_json(MODES, np.array(X))


def test_what_cannot_be_written_is_refused(tmp_path):
    with pytest.raises(ModeFileError, match=r"suffix '\.dat' is not known"):
        write_modes(MODES, tmp_path / "m.dat")
    with pytest.raises(ModeFileError, match="cannot be written"):
        write_modes(MODES, tmp_path / "no" / "m.csv")
    assert list(tmp_path.iterdir()) == []
    assert modes_csv(MODES, [5.0]).count("\n") == 5
