"""The table of a profile: what it may hold, and what is said of one that cannot be."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from form_ship import SHIP, form_ship

from hullform import Hull, trace
from hullform.errors import BodyPlanError
from hullform.profile import Profile
from hullform.ship import read_ship

PAGE = (Path(__file__).parents[2] / "docs" / "ship-file.md").read_text(encoding="utf-8")
GOOD = "x_m,z_m\n0,17\n0,9\n12,0\n175,0\n190,17\n"


def profile_of(folder: Path, text: str) -> Profile:
    (folder / "profile.csv").write_text(text, encoding="utf-8")
    body_plan = trace(form_ship(folder, '[hull]\nprofile = "profile.csv"\n', SHIP))
    assert body_plan.profile is not None
    return body_plan.profile


def test_points_are_read_in_order_and_turned_round(tmp_path: Path) -> None:
    aft_to_fore = profile_of(tmp_path, GOOD)
    assert aft_to_fore.x_m.tolist() == [0, 0, 12, 175, 190]
    assert aft_to_fore.height_m.tolist() == [17, 9, 0, 0, 17]
    rows = GOOD.splitlines()
    reversed_rows = profile_of(tmp_path, "\n".join([rows[0], *rows[:0:-1]]))
    assert reversed_rows.x_m.tolist() == aft_to_fore.x_m.tolist()
    swapped = "Z_M;X_M;remark\n" + "".join(f"{z},0;{x};a\n" for x, z in (row.split(",") for row in rows[1:]))
    assert profile_of(tmp_path, swapped).height_m.tolist() == aft_to_fore.height_m.tolist()


def test_the_ship_reads_her_profile_beside_her_file(tmp_path: Path) -> None:
    profile_of(tmp_path, GOOD)
    assert tmp_path / "profile.csv" in read_ship(tmp_path / "ship.toml").files


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (None, r"profile\.csv: no such file; hull\.profile names it"),
        ("x_m,height\n0,17\n190,17\n", r"line 1: has no column z_m; it has x_m, height\. A profile has x_m and z_m"),
        ("x_m,z_m\n0,17\n# keel\n0,nine\n190,17\n", r"line 4, column z_m: 'nine' is no number"),
        ("x_m,z_m\n0,17\n0\n190,17\n", r"line 3, column z_m: '' is no number"),
        (GOOD.replace("190,17", "195,17"), r"line 6: x_m = 195 lies outside the ship, 0 to 190 m"),
        (GOOD.replace("0,17", "-5,17", 1), r"line 2: x_m = -5 lies outside the ship, 0 to 190 m"),
        (GOOD.replace("0,9", "0,9000"), r"line 3: z_m = 9000 is no height of a hull of 17 m depth, -8\.5 to 34 m"),
        (GOOD + "0,17\n", r"begins and ends at x_m = 0; .*the deck itself left out"),
        ("x_m,z_m\n0,17\n60,0\n30,0\n50,10\n190,17\n", r"crosses itself at x_m = 4\d.*give its points in order"),
    ],
)
def test_a_profile_that_cannot_be_is_told(tmp_path: Path, text: str | None, told: str) -> None:
    ship = form_ship(tmp_path, '[hull]\nprofile = "profile.csv"\n', SHIP)
    if text is not None:
        (tmp_path / "profile.csv").write_text(text, encoding="utf-8")
    with pytest.raises(BodyPlanError, match=told) as raised:
        trace(ship)
    assert str(raised.value).startswith(str(tmp_path / "profile.csv"))


def test_stations_off_the_profile_are_doubted(tmp_path: Path) -> None:
    described = form_ship(tmp_path, '[hull]\nprofile = "profile.csv"\n', SHIP)
    (tmp_path / "profile.csv").write_text(GOOD.replace("12,0\n175,0", "12,1.5\n175,1.5"), encoding="utf-8")
    doubts = Hull.from_body_plan(trace(described), described.particulars).doubts
    told = [doubt for doubt in doubts if "and the profile there is at 1.50 m, limit 0.30 m apart" in doubt]
    assert told
    assert "check the profile, or the station's x" in told[0]


def test_the_example_of_the_page_is_read(tmp_path: Path) -> None:
    (table,) = (part.split("```")[0] for part in PAGE.split("<!-- profile -->\n```csv\n")[1:])
    found = profile_of(tmp_path, table)
    # at 186 m: the bulb from its foot to its head, and the foot of the bow above it
    foot, head, stem = (float(height[0]) for height in found.at(np.array([186.0])))
    assert foot == pytest.approx(2.1 + 1.9 / 2.5)
    assert head == pytest.approx(7.2 - 1.6 / 2.5)
    assert stem == pytest.approx(8.5 + 6.8 * 5.7 / 8.2)
