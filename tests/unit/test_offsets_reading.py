"""Tables of offsets: what is read of both forms, and how each fault is told."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from form_ship import form_ship

from hullform import Hull, trace
from hullform.body_plan import BodyPlan
from hullform.errors import BodyPlanError
from hullform.offsets import write_offsets

HEADER = "station_x_m,half_breadth_m,height_m\n"
POINTS = HEADER + "".join(f"{x},{y},{z}\n" for x in (10, 95, 180) for y, z in ((0, 0), (15, 0), (15, 17)))
# half-breadths of a box with a wedge at its ends, by height and station
WIDE = "height_m,10,95,180\n0,0,15,0\n8.5,7.5,15,7.5\n17,15,15,15\n"


def read(folder: Path, table: str, keys: str = "") -> BodyPlan:
    (folder / "table.csv").write_text(table, encoding="utf-8")
    return trace(form_ship(folder, f'[body_plan]\noffsets = "table.csv"\n{keys}'))


def test_points_are_taken_as_they_stand_and_halves_by_place(tmp_path: Path) -> None:
    body_plan = read(tmp_path, POINTS)
    assert (body_plan.source, body_plan.doubts) == ("offsets", ())
    # midships is 5 + 182 / 2
    assert [(station.x_m, station.half) for station in body_plan.stations] == [
        (10, "aft"),
        (95, "aft"),
        (180, "fore"),
    ]
    (curve,) = body_plan.stations[0].curves
    # three points are too few for a fit: more stand on the lines between them, and the area is the box's
    assert len(curve.points) >= 4
    for point in ((0, 0), (15, 0), (15, 17)):
        assert np.abs(curve.points - point).max(axis=1).min() == 0
    assert body_plan.stations[0].area_below(11.0) == pytest.approx(330.0)


def test_a_table_that_trace_wrote_is_read_back(tmp_path: Path) -> None:
    written = trace(form_ship(tmp_path))
    write_offsets(written, tmp_path / "table.csv")
    read_back = trace(form_ship(tmp_path, '[body_plan]\noffsets = "table.csv"\n'))
    assert [(s.x_m, s.half, s.confidence) for s in read_back.stations] == [
        (s.x_m, s.half, s.confidence) for s in written.stations
    ]
    for one, other in zip(read_back.stations, written.stations, strict=True):
        for curve, same in zip(one.curves, other.curves, strict=True):
            # the file has tenths of a millimetre
            np.testing.assert_allclose(curve.points[: len(same.points)], same.points, atol=0.51e-4)


def test_two_curves_of_a_station_and_their_order_are_kept(tmp_path: Path) -> None:
    bulb = "180,fore,0,1,2,2\n180,fore,0,0,0,0\n180,fore,0,2,0,4\n180,fore,1,0,0,9\n180,fore,1,1,5,17\n"
    rows = "".join(f"{x},,0,{i},{y},{z}\n" for x in (10, 95) for i, (y, z) in enumerate(((0, 0), (15, 0), (15, 17))))
    body_plan = read(tmp_path, "station_x_m,half,curve,point,half_breadth_m,height_m\n" + bulb + rows)
    low, high = body_plan.stations[-1].curves
    assert low.points[0].tolist() == [0.0, 0.0]
    assert low.points[-1].tolist() == [0.0, 4.0]
    assert high.points[-1].tolist() == [5.0, 17.0]


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_both_ways_round_a_wide_table_is_the_same(tmp_path: Path, separator: str) -> None:
    rows = [line.split(",") for line in WIDE.split()]
    turned = [list(column) for column in zip(*rows, strict=True)]
    turned[0][0] = "station_x_m"
    (tmp_path / "one").mkdir()
    one = read(tmp_path / "one", "\n".join(separator.join(row) for row in rows))
    other = read(tmp_path, "# by station\n" + "\n".join(separator.join(row) for row in turned))
    assert [s.x_m for s in one.stations] == [s.x_m for s in other.stations] == [10, 95, 180]
    for station, same in zip(one.stations, other.stations, strict=True):
        np.testing.assert_array_equal(station.curves[0].points, same.curves[0].points)
    # a V of 15 m on 17 m, and a box with its flat of bottom closed on the centre line
    assert one.stations[0].area_below(17.0) == pytest.approx(15 * 17)
    assert one.stations[1].area_below(11.0) == pytest.approx(2 * 15 * 11)


def test_decimal_commas_go_with_semicolons(tmp_path: Path) -> None:
    body_plan = read(tmp_path, "height_m;10,5;95;180\n0;0;15;0\n8,5;7,5;15;7,5\n17;15;15;15\n")
    assert body_plan.stations[0].x_m == 10.5
    assert body_plan.stations[0].area_below(17.0) == pytest.approx(15 * 17)


def test_waterlines_are_joined_by_a_fair_curve(tmp_path: Path) -> None:
    # parabolic sections, y = 15 (1 - (1 - z / 17)^2): chords of five waterlines miss 3 % of the area, a cubic far less
    heights = np.linspace(0.0, 17.0, 6)
    breadths = 15 * (1 - (1 - heights / 17) ** 2)
    table = "height_m,10,95,180\n" + "".join(f"{z},{y},{y},{y}\n" for z, y in zip(heights, breadths, strict=True))
    station = read(tmp_path, table).stations[0]
    assert station.area_below(17.0) == pytest.approx(2 * 15 * 17 * 2 / 3, rel=0.004)


def test_keel_and_deck_rows_end_the_curves(tmp_path: Path) -> None:
    table = (
        "height_m,10,95,180\n2,,15,3\n8.5,6,15,7.5\n17,,15,15\n"
        "keel_height_m,4.5,0,1\ndeck_height_m,16,17,18.5\ndeck_half_breadth_m,10,15,16\n"
    )
    body_plan = read(tmp_path, table)
    ends = [station.curves[0].points[[0, -1]] for station in body_plan.stations]
    np.testing.assert_allclose(ends, [[[0, 4.5], [10, 16]], [[0, 0], [15, 17]], [[0, 1], [16, 18.5]]], atol=1e-12)
    assert len(body_plan.notes) == 1


def test_a_waterline_at_the_keels_height_is_the_flat_of_bottom(tmp_path: Path) -> None:
    rows = "height_m,10,95,180\n0,2,13,1\n2,5,15,3\n8.5,6,15,7.5\n17,12,15,15\n"
    with_keel, without = read(tmp_path, rows + "keel_height_m,0,0,0\n"), read(tmp_path, rows)
    for told, found in zip(with_keel.stations, without.stations, strict=True):
        np.testing.assert_allclose(told.curves[0].points, found.curves[0].points, atol=1e-12)
        assert told.curves[0].points[1, 1] == 0.0


def test_a_millimetre_between_keel_and_waterline_is_rounding(tmp_path: Path) -> None:
    rows = "height_m,10,95,180\n0,2,13,1\n2,5,15,3\n8.5,6,15,7.5\n17,12,15,15\n"
    level, rounded = (read(tmp_path, f"{rows}keel_height_m,{keel},{keel},{keel}\n") for keel in ("0", "0.001"))
    for one, other in zip(level.stations, rounded.stations, strict=True):
        assert other.area_below(8.5) == pytest.approx(one.area_below(8.5), rel=1e-3)


def test_what_no_waterline_shows_is_told(tmp_path: Path) -> None:
    body_plan = read(tmp_path, "height_m,10,95,180\n1,,14.5,2\n8.5,6,15,7.5\n17,12,15,15\n")
    (_, note) = body_plan.notes
    assert "lowest waterlines of stations 10, 95, 180 lie above the keel" in note
    lowest = [station.curves[0].points[0].tolist() for station in body_plan.stations]
    # straight on: to the waterline that she does not reach, to the base line, and there along it
    assert lowest == [[0.0, 1.0], [0.0, 0.0], [0.0, 0.0]]


def test_a_table_from_deck_to_keel_is_turned_round(tmp_path: Path) -> None:
    rows = POINTS.splitlines(keepends=True)
    upward, downward = read(tmp_path, POINTS), read(tmp_path, rows[0] + "".join(reversed(rows[1:])))
    for one, other in zip(upward.stations, downward.stations, strict=True):
        np.testing.assert_array_equal(one.curves[0].points, other.curves[0].points)


def test_a_curve_that_sags_is_not_turned_round(tmp_path: Path) -> None:
    # a transom whose flat sags below its ends
    rows = HEADER + "10,0,9\n10,4,8\n10,9,8.9\n95,0,0\n95,15,0\n95,15,17\n180,0,0\n180,3,17\n"
    line = read(tmp_path, rows).stations[0].curves[0].points
    assert (line[0].tolist(), line[-1].tolist()) == ([0.0, 9.0], [9.0, 8.9])


@pytest.mark.parametrize("swapped", [0, 2, 4])
def test_two_points_that_changed_places_are_told(tmp_path: Path, swapped: int) -> None:
    # on a hollow side no curve crosses itself for it
    points = [(10.0 + 0.016 * z**2, z) for z in (1.0, 3.0, 6.0, 9.0, 12.0, 17.0)]
    points[swapped : swapped + 2] = points[swapped + 1], points[swapped]
    rows = "".join(f"10,{y},{z}\n" for y, z in points) + "95,0,0\n95,15,17\n180,0,0\n180,3,17\n"
    with pytest.raises(BodyPlanError, match=r"at x = 10 m turns back at y = 1[0-4]\.\d* m, z = \d+ m; give its points"):
        read(tmp_path, HEADER + rows)


def test_points_out_of_order_are_told_unless_they_are_numbered(tmp_path: Path) -> None:
    parabola = [(x, 0.15 * z * (20 - z) * x / 180, z) for x in (10, 95, 180) for z in (0, 1, 3, 6, 9, 10)]
    shuffled = np.random.default_rng(2).permutation(len(parabola))
    rows = [f"{parabola[i][0]},{parabola[i][1]},{parabola[i][2]}" for i in shuffled]
    with pytest.raises(
        BodyPlanError, match=r"at x = \d+ m (turns back|crosses itself).*; give its points in order .* named point"
    ):
        read(tmp_path, HEADER + "\n".join(rows))
    numbered = [f"{row},{i}" for row, i in zip(rows, shuffled, strict=True)]
    body_plan = read(tmp_path, HEADER.rstrip() + ",point\n" + "\n".join(numbered))
    for station in body_plan.stations:
        assert (np.diff(station.curves[0].height_m) > 0).all()


def test_units_and_the_place_of_the_zero_are_obeyed(tmp_path: Path) -> None:
    rows = [[float(v) for v in line.split(",")] for line in POINTS.splitlines()[1:]]
    feet = "".join(f"{(x - 5) / 0.3048!r},{y / 0.3048!r},{(z - 1) / 0.3048!r}\n" for x, y, z in rows)
    body_plan = read(tmp_path, HEADER + feet, 'unit = "ft"\norigin_x_m = 5.0\norigin_z_m = 1.0\n')
    assert [station.x_m for station in body_plan.stations] == [10, 95, 180]
    assert body_plan.stations[0].area_below(11.0) == pytest.approx(330.0)


@pytest.mark.parametrize(
    ("table", "told"),
    [
        ("", "has 0 rows"),
        ("station_x_m,half_breadth_m\n1,2\n", "line 1: has no column height_m; it has station_x_m, half_breadth_m"),
        ("z,10,95,180\n0,0,15,0\n", "or is wide: its first cell is height_m and stations' x stand beside it"),
        ("station_x_m,curve,half_breadth_m,height_m\n10,1.5,0,0\n", "line 2: curve = 1.5; curves are numbered 0, 1, 2"),
        (POINTS.replace("10,15,17", "10,abc,17"), "line 4, column half_breadth_m: 'abc' is no number"),
        (POINTS.replace("10,15,17", "10,nan,17"), "line 4, column half_breadth_m: 'nan' is no number"),
        (POINTS.replace("10,15,17", "10,,17"), "line 4: half_breadth_m is empty"),
        (POINTS.replace("10,15,17", "10,15"), "line 4: has 2 cells, the header 3"),
        (POINTS.replace("10,15,17", "10,-15,17"), "line 4: half_breadth_m = -15 is negative"),
        (POINTS + "120,3,4\n", "the station at x = 120 m has a curve of one point"),
        (HEADER + "10,0,0\n10,15,17\n20,0,0\n20,15,17\n", "three or more different x; the body plan has 2"),
        (POINTS.replace("180,", "195,"), "from x = 10 to 195 m, the ship from 0 to 190 m; x runs from the aft end"),
        (POINTS.replace("10,", "-2,"), "write the x of the table's zero there as origin_x_m"),
        (POINTS.replace("95,", "400,"), "places in metres, not numbers of stations"),
        (POINTS.replace("180,", "180000,"), 'write unit = "mm"'),
        (POINTS.replace(",15,", ",15000,"), "greatest half-breadth is 15000 m, and half the breadth of the ship 15 m"),
        ("station_x_m,half,half_breadth_m,height_m\n10,left,0,0\n", "line 2: half = 'left'; it is aft or fore"),
        (
            "station_x_m,half_breadth_m,height_m,confidence\n10,0,0,1\n10,15,17,7\n",
            "confidence = 7 at x = 10 m; it is from 0 to 1",
        ),
        (WIDE.replace("8.5,7.5", "8.5,x"), "line 3, column 2: 'x' is no number"),
        (WIDE.replace("8.5,7.5", "8.5,-7.5"), "line 3: has a half-breadth below 0"),
        (WIDE.replace("8.5,7.5,15", "8.5,,-15"), "line 3: has a half-breadth below 0"),
        (POINTS.replace("10,15,17", '10,"15,17'), "line 4: has 2 cells, the header 3"),
        (WIDE.replace("8.5,7.5", "WL 2,7.5"), "line 3: 'wl 2' is no number, nor one of keel_height_m"),
        (WIDE.replace("8.5,7.5", ",7.5"), "line 3: a row or column has no height or station"),
        (WIDE.replace("17,15", "8.5,15"), "a height stands twice"),
        (WIDE.replace(",95", ",10"), "a station stands twice"),
        (WIDE.replace("0,0,15,0\n8.5,7.5", "0,,15,0\n8.5,"), "the station at 10 has 1 half-breadths; give two or more"),
        (WIDE.replace("180\n", "180\n3,1,2,3,4\n"), "line 2: has 5 cells, the header 4"),
        (WIDE + "deck_height_m,17,17,17\n", "deck_height_m and deck_half_breadth_m go together"),
    ],
)
def test_each_fault_is_told_with_its_place_and_remedy(tmp_path: Path, table: str, told: str) -> None:
    with pytest.raises(BodyPlanError) as raised:
        read(tmp_path, table)
    assert str(tmp_path / "table.csv") in str(raised.value)
    assert told in str(raised.value)


def test_a_missing_and_a_binary_table_are_told_apart(tmp_path: Path) -> None:
    with pytest.raises(BodyPlanError, match=r"no such file; body_plan\.offsets names it"):
        trace(form_ship(tmp_path, '[body_plan]\noffsets = "none.csv"\n'))
    (tmp_path / "binary.csv").write_bytes(b"\xff\xfe\x00\x81")
    with pytest.raises(BodyPlanError, match="is no text in UTF-8; save the table as csv"):
        trace(form_ship(tmp_path, '[body_plan]\noffsets = "binary.csv"\n'))


def test_a_table_somewhat_broader_than_the_ship_is_doubted(tmp_path: Path) -> None:
    (doubt,) = read(tmp_path, POINTS.replace(",15,", ",15.6,")).doubts
    assert "15.6 m, +4.0 % off half of breadth_m, limit 2 %" in doubt


def test_a_hull_comes_of_it(tmp_path: Path) -> None:
    ship = form_ship(tmp_path)
    hull = Hull.from_body_plan(read(tmp_path, POINTS.replace("10,", "0,").replace("180,", "190,")), ship.particulars)
    # a box with corners as sharp as a super-ellipse has them
    assert hull.volume_m3 == pytest.approx(190 * 30 * 17, rel=0.005)
