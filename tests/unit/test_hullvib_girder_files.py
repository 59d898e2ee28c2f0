"""Girder files: what is written is read back, what is wrong is named with its line or key."""

import json

import numpy as np
import pytest

from hullvib import Girder, GirderFileError, PointMass, parse_girder, read_girder, write_girder

HEADER = "x_m,mass_kg_per_m,flexural_rigidity_N_m2\n"


def test_a_table_round_trips_through_csv_to_the_last_bit(tmp_path):
    girder = Girder([0, 1 / 3, 1 / 3, 2], [1, 0.1, 7, 7], [1e13, 2e13, 2e13, 3e12], [1e9] * 4, [3.3] * 4, name="t")
    write_girder(girder, tmp_path / "t.csv")
    again = read_girder(tmp_path / "t.csv")
    assert again == girder
    assert again.name == "t"
    lines = (tmp_path / "t.csv").read_text().splitlines()
    assert lines[0] == "x_m,mass_kg_per_m,flexural_rigidity_N_m2,shear_rigidity_N,rotary_inertia_kg_m"
    assert len(lines) == 1 + 4  # one row a breakpoint, two at the jump
    assert [path.name for path in tmp_path.iterdir()] == ["t.csv"]


def test_curves_and_point_masses_round_trip_through_json(tmp_path):
    girder = Girder.from_polynomials(
        [0, 1, 3], [[1, 2, 3], [4]], [[1], [1, 1]], None, [[1], [2]], [PointMass(1.5, 9.0, 0.5)], "curved"
    )
    write_girder(girder, tmp_path / "g.json")
    again = read_girder(tmp_path / "g.json")
    assert again == girder
    assert again.name == "curved"


def test_power_form_is_read():
    text = json.dumps(
        {
            "form": "power",
            "breaks_m": [0, 2],
            "mass_kg_per_m": [[1, 1]],
            "flexural_rigidity_N_m2": [[4]],
            "point_masses": [{"x_m": 1, "mass_kg": 3}],
        }
    )
    girder = parse_girder(text, name="inline")
    assert girder == Girder([0, 2], [1, 3], [4, 4], point_masses=[PointMass(1, 3)])
    assert girder.name == "inline"


def test_comments_blank_lines_and_a_byte_order_mark_do_no_harm(tmp_path):
    file = tmp_path / "g.csv"
    file.write_text("\ufeff" + HEADER + "# aft\n0, 1, 2\n\n 5,1,2\n", encoding="utf-8")
    assert np.array_equal(read_girder(file).breaks, [0.0, 5.0])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is empty"),
        ("x_m,mass_kg_per_m\n0,1\n", "line 1: the header lacks flexural_rigidity_N_m2"),
        (HEADER.strip() + ",oops\n", "line 1: the header has 'oops'"),
        (HEADER + "0,1,1\n", "has 1 rows"),
        (HEADER + "0,1,1\n1,1\n", "line 3: 2 values"),
        (HEADER + "0,1,1\n1,abc,1\n", "line 3: mass_kg_per_m is 'abc'"),
        (HEADER + "0,1,1\n1,nan,1\n", "line 3: mass_kg_per_m is nan"),
        (HEADER + "0,1,1\n1,1,-4\n", "line 3: flexural_rigidity_N_m2 is -4"),
        (HEADER + "# note\n0,1,1\n2,1,1\n1,1,1\n", "line 5: x_m falls from 2 to 1"),
        (HEADER + "1,1,1\n2,1,1\n", "line 2: x_m starts at 1"),
        (HEADER + "0,1,1\n0,1,1\n", "line 3: x_m ends at 0"),
        (HEADER + "0,1,1\n1,1,1\n1,2,1\n\n1,3,1\n2,1,1\n", "line 6: x_m is 1 for the third time"),
        (HEADER + "0,1,1\n0,2,1\n2,1,1\n", "line 3: x_m is 0, an end, for the second time"),
        (HEADER + "0,1,1\n2,2,1\n2,1,1\n", "line 4: x_m is 2, an end, for the second time"),
        (HEADER + "0,1,0\n1,1,0\n2,1,1\n", "line 3: flexural_rigidity_N_m2 is 0 at x_m = 1; only the two ends"),
        (HEADER.strip() + ",shear_rigidity_N\n0,1,1,1\n1,1,1,0\n2,1,1,1\n", "line 3: shear_rigidity_N is 0"),
        (HEADER + "0,0,1\n1,0,1\n", "has no mass at all"),
        ('{\n"breaks_m": [0, 1],\n"what": 1}', "line 3: key 'what' is not known"),
        (
            '{"breaks_m": [0, 1],\n"mass_kg_per_m": [[1]],\n"flexural_rigidity_N_m2": [[1, -4, 1]]}',
            "line 3: flexural rigidity is -1.5 at x = 0.5",
        ),
        ("{", "line 1: is not JSON"),
        ('{"breaks_m": [0, 1]}', "'mass_kg_per_m' is missing"),
        ('{"what": 1}', "'what' is not known"),
        ('{"breaks_m": [0, 1], "mass_kg_per_m": [[1]], "flexural_rigidity_N_m2": [[1]], "form": "x"}', "form is 'x'"),
        (
            '{"breaks_m": [0, 1], "mass_kg_per_m": [[1]], "flexural_rigidity_N_m2": "x"}',
            "flexural rigidity does not hold equally long rows",
        ),
        ('{"breaks_m": [0, 1], "mass_kg_per_m": 5, "flexural_rigidity_N_m2": [[1]], "form": "power"}', "must be"),
        ('{"breaks_m": [0, 1], "mass_kg_per_m": [[NaN]], "flexural_rigidity_N_m2": [[1]]}', "nan in piece 0"),
        (
            '{"breaks_m": [0, 1], "mass_kg_per_m": [[1]], "flexural_rigidity_N_m2": [[1]], "point_masses": [{"x": 1}]}',
            r"point_masses\[0\]",
        ),
    ],
)
def test_a_wrong_file_is_refused_with_its_line_or_key(text, message):
    with pytest.raises(GirderFileError, match=message):
        parse_girder(text)


def test_files_that_cannot_be_read_or_written(tmp_path):
    with pytest.raises(GirderFileError, match="cannot be read"):
        read_girder(tmp_path / "none.csv")
    (tmp_path / "binary.csv").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(GirderFileError, match="UTF-8"):
        read_girder(tmp_path / "binary.csv")
    girder = Girder([0, 1], [1, 1], [1, 1], point_masses=[PointMass(0, 1)])
    with pytest.raises(GirderFileError, match=r"write girder\.json"):
        write_girder(girder, tmp_path / "g.csv")
    with pytest.raises(GirderFileError, match=r"write \.csv or \.json"):
        write_girder(girder, tmp_path / "g.txt")
    with pytest.raises(GirderFileError, match="cannot be written"):
        write_girder(girder, tmp_path / "no" / "g.json")
    with pytest.raises(GirderFileError, match="curved"):
        write_girder(Girder.from_polynomials([0, 1], [[1, 0, 1]], [[1]]), tmp_path / "g.csv")
    assert [path.name for path in tmp_path.iterdir()] == ["binary.csv"]


@pytest.mark.parametrize(("sign", "name"), [(";", "semicolons"), ("\t", "tabs")])
def test_other_separators_are_named(sign, name):
    with pytest.raises(GirderFileError, match=f"line 1: the columns are separated by {name}; separate them by commas"):
        parse_girder(HEADER.replace(",", sign) + sign.join("012") + "\n")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('{"breaks_m": ' + "[" * 100_000, "nested too deeply"),
        ('{"breaks_m": [0, 1' + "0" * 5000 + "]}", "thousands of digits"),
        (f'{{"breaks_m": [0, 1{"0" * 400}], "mass_kg_per_m": [[1]], "flexural_rigidity_N_m2": [[1]]}}', "x is not"),
        (f'{{"breaks_m": [0, 1], "mass_kg_per_m": [[1{"0" * 400}]], "flexural_rigidity_N_m2": [[1]]}}', "mass per len"),
        (
            '{"breaks_m": [0, 1], "mass_kg_per_m": [[1]], "flexural_rigidity_N_m2": [[1]], "point_masses": '
            f'[{{"x_m": 0, "mass_kg": 1{"0" * 400}}}]}}',
            "mass_kg is 1000",
        ),
    ],
    ids=["deep", "thousands", "x", "mass", "point"],
)
def test_json_beyond_what_numbers_hold_is_refused(text, message):
    with pytest.raises(GirderFileError, match=message):
        parse_girder(text)
