"""ship.toml: what is read, and how each fault is told."""

from __future__ import annotations

from pathlib import Path

import pytest

from hullform.errors import ShipFileError
from hullform.ship import read_ship

GOOD = """
schema = 1
[ship]
name = "Test ship"
type = "container"
length_overall_m = 110.0
length_between_perpendiculars_m = 100.0
aft_perpendicular_m = 4.0
breadth_m = 16.0
depth_m = 10.0
draught_m = 6.0
[body_plan]
image = "plan.png"
aft_side = "left"
aft_stations_m = [0.0, 20.0, 54.0]
fore_stations_m = [54.0, 90.0]
[structure]
[weights]
[[conditions]]
name = "loaded"
deadweight_t = 1000.0
"""

PICTURE = GOOD[GOOD.index("[body_plan]") : GOOD.index("[structure]")].rstrip()


def written(folder: Path, text: str) -> Path:
    path = folder / "ship.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_good_file_is_read_with_its_defaults(tmp_path: Path) -> None:
    ship = read_ship(written(tmp_path, GOOD))
    structure, weights, conditions = ship.require_sections_of_a_run()
    assert ship.particulars.aft_perpendicular_m == 4.0
    assert ship.body_plan.image_path == tmp_path / "plan.png"
    assert (structure.youngs_modulus_pa, structure.shell_thickness_m) == (2.06e11, 0.016)
    assert weights.machinery_share == 0.7
    assert conditions[0].title == "loaded"
    assert ship.water.density_kg_m3 == 1025.0


def test_items_stand_for_the_deadweight(tmp_path: Path) -> None:
    items = 'items = [{ name = "ore", mass_t = 600.0, from_m = 20.0, to_m = 80.0 }, { name = "fuel", mass_t = 50.0 }]'
    (condition,) = read_ship(written(tmp_path, GOOD.replace("deadweight_t = 1000.0", items))).conditions
    assert (condition.deadweight_t, condition.load_t) == (0.0, 650.0)
    assert condition.items[1].span_m(110.0) == (0.0, 110.0)


def test_the_aft_perpendicular_is_at_the_aft_end_where_the_lengths_agree(tmp_path: Path) -> None:
    text = GOOD.replace("length_overall_m = 110.0", "length_overall_m = 100.0").replace(
        "aft_perpendicular_m = 4.0\n", ""
    )
    assert read_ship(written(tmp_path, text)).particulars.aft_perpendicular_m == 0.0


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("breadth_m = 16.0", "breadht_m = 16.0", "ship.breadht_m: unknown key; did you mean 'breadth_m'?"),
        ("breadth_m = 16.0", "", "ship.breadth_m: is missing"),
        ("breadth_m = 16.0", "breadth_m = -16.0", "ship.breadth_m = -16.0: input should be greater than 0"),
        ("breadth_m = 16.0", "breadth_m = nan", "ship.breadth_m = nan: input should be a finite number"),
        ("aft_perpendicular_m = 4.0", "", "ship.aft_perpendicular_m: is missing; the length between perpendiculars"),
        ("aft_perpendicular_m = 4.0", "aft_perpendicular_m = 14.0", "fore perpendicular at x = 114 m"),
        ("draught_m = 6.0", "draught_m = 12.0", "draught_m = 12 is above depth_m = 10"),
        (
            "breadth_m = 16.0",
            "breadth_m = 16000.0",
            "length_overall_m = 110 is 0.00688 times breadth_m = 16000, as in no ship",
        ),
        ("depth_m = 10.0", "depth_m = 1000.0", "breadth_m = 16 is 0.016 times depth_m = 1000, as in no ship"),
        ("draught_m = 6.0", "draught_m = 0.06", "depth_m = 10 is 167 times draught_m = 0.06, as in no ship"),
        ('type = "container"', 'type = "canoe"', "ship.type = 'canoe'"),
        ("schema = 1", "schema = 2", "schema = 2"),
        ("[0.0, 20.0, 54.0]", "[0.0, 54.0, 20.0]", "20 follows 54; list each half's stations from aft forward"),
        ("[54.0, 90.0]", "[54.0, 190.0]", "fore_stations_m has 190, outside the ship"),
        ("[54.0, 90.0]", "[1.0, 9.0]", "aft_stations_m lie at 24.6667 m on average, fore_stations_m at 5 m; x runs"),
        ("deadweight_t = 1000.0", "deadweight_t = -1.0", "conditions.0.deadweight_t = -1.0"),
        (
            'name = "loaded"',
            'name = "Fully Loaded"',
            "conditions.0.name = 'Fully Loaded': is a part of file names; write it with a to z",
        ),
        ("[weights]", "[weights]\nsteel_weight_t = -5.0", "weights.steel_weight_t = -5.0"),
        (
            "[structure]",
            "[structure]\nyoungs_modulus_pa = 206e3",
            "youngs_modulus_pa = 206000.0: input should be greater",
        ),
        (
            "[weights]",
            "[water]\ndensity_kg_m3 = 1.025\n[weights]",
            "water.density_kg_m3 = 1.025: input should be greater",
        ),
        # 110 x 16 x 10 m of sea water are 18 040 t
        ("[weights]", "[weights]\nsteel_weight_t = 3608e3", "weights.steel_weight_t: 3608000 t is 200 times the water"),
        ("deadweight_t = 1000.0", "deadweight_t = 1e6", "conditions, loaded: 1000000 t is 55.4 times the water"),
        ("[weights]", "[weights]\nitems = [{name = 'house', mass_t = 9.0, form = 'uniform'}]", "unknown key; did you"),
        ("[weights]", "[weights]\nitems = [{name = 'house', mass_t = 0.0}]", "weights.items.0.mass_t = 0.0"),
        (
            "[weights]",
            "[weights]\nitems = [{name = 'house', mass_t = 9.0, from_m = 90.0, to_m = 111.0}]",
            'item "house" reaches from 90 to 111 m, on a ship of 0 .. 110 m',
        ),
        (
            "deadweight_t = 1000.0",
            "items = [{name = 'fuel', mass_t = 9.0, from_m = 9.0, to_m = 21.0, shape = 'trapezoid', centre_m = 12.0}]",
            'item "fuel" has centre_m = 12, outside the middle third of 9 .. 21 m',
        ),
        (
            "deadweight_t = 1000.0",
            "items = [{name = 'fuel', mass_t = 9.0, shape = 'trapezoid'}]",
            '"fuel" of shape = "trapezoid" needs centre_m',
        ),
        (
            "deadweight_t = 1000.0",
            "items = [{name = 'fuel', mass_t = 9.0, centre_m = 12.0}]",
            'centre_m goes with shape = "trapezoid" alone, not "uniform"',
        ),
        (
            "deadweight_t = 1000.0",
            "items = [{name = 'ore', mass_t = 9.0, shape = 'table', x_m = [1.0, 2.0], mass_per_m = [1.0]}]",
            '"ore": 2 x_m and 1 mass_per_m',
        ),
        (
            "deadweight_t = 1000.0",
            "items = [{name = 'ore', mass_t = 9.0, shape = 'table', x_m = [3.0, 2.0], mass_per_m = [1.0, 1.0]}]",
            "in x_m 2 follows 3",
        ),
        (
            "deadweight_t = 1000.0",
            "items = [{name = 'ore', mass_t = 9.0, shape = 'table', x_m = [1.0, 2.0], mass_per_m = [0.0, 0.0]}]",
            "the table has no area",
        ),
        (
            "deadweight_t = 1000.0",
            "items = [{name = 'o', mass_t = 9.0, shape = 'table', x_m = [1, 2], mass_per_m = [1, 1], to_m = 5.0}]",
            "remove from_m and to_m",
        ),
        ("deadweight_t = 1000.0", "", "conditions.0.deadweight_t: is missing"),
        (
            "deadweight_t = 1000.0",
            "deadweight_t = 1000.0\ndraught_aft_m = 5.0",
            "draught_aft_m and draught_fore_m go together",
        ),
        ("[weights]", "[weights]\n[excitation]", "excitation.shaft_speed_rpm: is missing"),
        ("[structure]", "[hull]\nsections = 'ellipse'\n[structure]", "hull.sections = 'ellipse': "),
        (
            "[body_plan]",
            "[body_plan]\nmesh = 'x.stl'",
            "body_plan: has image and mesh; the form comes from one",
        ),
        ('image = "plan.png"', "", "body_plan.image: is missing; give the picture, or in its place a table"),
        (PICTURE, "[body_plan]\nform = 3", "body_plan.form: unknown key; known here: midship_coefficient, "),
        (PICTURE, "[body_plan]\noffset = 'a.csv'", "body_plan.offset: unknown key; did you mean 'offsets'?"),
        (PICTURE, "[body_plan]\nmesh = 'a.stl'\nforwrad = '+y'", "forwrad: unknown key; did you mean 'forward'?"),
        (PICTURE, "[body_plan]\nmesh = 'a.stl'\nforward = 'y'", "body_plan.forward = 'y': input should be '+x'"),
        (PICTURE, "[body_plan]\nmesh = 'a.stl'\nforward = '-z'", 'forward = "-z" and up = "+z" are one axis'),
        (PICTURE, "[body_plan]\nmesh = 'a.stl'\nunit = 'yd'", "body_plan.unit = 'yd'"),
        (PICTURE, "[body_plan]\nmesh = 'a.stl'\nstations_m = [0.0, 9.0]", "stations_m lists 2; a hull needs three"),
        (PICTURE, "[body_plan]\nmesh = 'a.stl'\nstations_m = [0.0, 9.0, 8.0]", "8 follows 9; list the stations"),
        (
            PICTURE,
            "[body_plan]\nmesh = 'a.stl'\nstations_m = [0.0, 9.0, 800.0]",
            "stations_m has 800, outside",
        ),
        (PICTURE, "[body_plan]\nmidship_coefficient = 1.5", "body_plan.midship_coefficient = 1.5"),
        ("[ship]", "ship = 3\n[other]", "ship = 3: "),
        ("schema = 1", "schema = ", "is no TOML"),
        ("[structure]", "[structure]\nscantlings = 'net'", 'structure: scantlings = "net" needs corrosion_margin_m'),
        (
            "[structure]",
            "[structure]\nscantlings = 'net'\ncorrosion_margin_m = 0.01\ndecks = [{height_m = 5, thickness_m = 0.008}]",
            "leaves nothing of the plate of 0.008 m",
        ),
        (
            "[structure]",
            "[structure]\nzones = [{part = 'keel', thickness_m = 0.02}]",
            "structure.zones.0.part = 'keel'",
        ),
        (
            "[structure]",
            "[structure]\nhatches = [{bredth_m = 9.0}]",
            "hatches.0.bredth_m: unknown key; did you mean 'breadth_m'?",
        ),
        ("[structure]", "[structure]\nhatches = [{breadth_m = 16.0}]", "hatches.breadth_m = 16 is not below 16 m"),
        (
            "[structure]",
            "[structure]\nhatches = [{breadth_m = 9.0, from_m = 50.0, to_m = 40.0}]",
            "to_m = 40 is not forward of from_m = 50",
        ),
        ("[structure]", "[structure]\ndecks = [{height_m = 5.0, to_m = 120.0}]", "structure: from_m or to_m has 120"),
        (
            "[structure]",
            "[structure]\ntransverse_bulkheads = [{x_m = [10.0, -3.0]}]",
            "structure: transverse_bulkheads.x_m has -3, outside the ship",
        ),
        (
            "[structure]",
            "[structure]\nlongitudinal_bulkheads = [{y_m = 2.0, foot_m = 3.0, head_m = 1.0}]",
            "head_m = 1 is not above foot_m = 3",
        ),
        (
            "[structure]",
            "[structure]\nzones = [{part = 'side', thickness_m = 0.02, from_height_m = 3.0, to_height_m = 1.0}]",
            "to_height_m = 1 is not above from_height_m = 3",
        ),
    ],
)
def test_each_fault_is_named_with_its_place(tmp_path: Path, old: str, new: str, told: str) -> None:
    assert old in GOOD
    with pytest.raises(ShipFileError) as raised:
        read_ship(written(tmp_path, GOOD.replace(old, new, 1)))
    assert told in str(raised.value)


def test_every_fault_of_a_file_is_listed_at_once(tmp_path: Path) -> None:
    text = GOOD.replace("breadth_m = 16.0", "breadth_m = -1.0").replace("[weights]", "[weights]\nstel_weight_t = 1.0")
    with pytest.raises(ShipFileError) as raised:
        read_ship(written(tmp_path, text))
    lines = str(raised.value).splitlines()
    assert len(lines) == 2
    assert all(line.startswith(str(tmp_path / "ship.toml")) for line in lines)


def test_two_conditions_may_not_share_a_name(tmp_path: Path) -> None:
    with pytest.raises(ShipFileError, match="two conditions are called 'loaded'"):
        read_ship(written(tmp_path, GOOD + '[[conditions]]\nname = "loaded"\ndeadweight_t = 1.0\n'))


def test_a_mark_must_name_a_listed_station(tmp_path: Path) -> None:
    mark = '[[body_plan.marks]]\nstation_m = 33.0\nhalf = "aft"\npx = [1.0, 2.0]\n'
    with pytest.raises(ShipFileError, match="a mark names station 33 m of the aft half"):
        read_ship(written(tmp_path, GOOD.replace("[structure]", mark + "[structure]")))


def test_a_missing_file_a_folder_and_a_binary_file_are_told_apart(tmp_path: Path) -> None:
    with pytest.raises(ShipFileError, match="no such file"):
        read_ship(tmp_path / "none.toml")
    with pytest.raises(ShipFileError, match=r"is a folder|cannot be read"):
        read_ship(tmp_path)
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ShipFileError, match="UTF-8"):
        read_ship(tmp_path / "binary.toml")


def test_a_run_names_the_tables_that_it_misses(tmp_path: Path) -> None:
    ship = read_ship(written(tmp_path, GOOD[: GOOD.index("[structure]")]))
    with pytest.raises(ShipFileError, match=r"\[structure\], \[weights\], \[\[conditions\]\]"):
        ship.require_sections_of_a_run()


def test_an_unknown_condition_is_told_with_the_known_ones(tmp_path: Path) -> None:
    with pytest.raises(ShipFileError, match="no condition 'empty'; its conditions: loaded"):
        read_ship(written(tmp_path, GOOD)).require_condition("empty")
