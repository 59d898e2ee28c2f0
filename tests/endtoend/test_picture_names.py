"""Names in a whole reading: what is no station shifts none, and labels that are read speak against a wrong list."""

from __future__ import annotations

import re
from pathlib import Path

import cv2
import numpy as np
import pytest
from draw_bodyplans import outline
from reading_accuracy import station_errors

from hullform.picture.image.labels import can_read_labels
from hullform.picture.reading import PictureReading, read_sheet
from hullform.picture.sheet.sheet import Sheet, prepare_sheet
from hullform.ship import Ship, read_ship

BODYPLAN = Path(__file__).parents[2] / "bodyplans" / "ds-tanker"
AFT = ["Tr", "0", "1/4", "1/2", "3/4", "1", "1 1/2", "2", "3", "4", "5", "6", "8", "9"]
FORE = ["10", "12", "14", "15", "17", "18", "18 1/2", "19", "19 1/2", "19 3/4", "19 7/8", "20", "20 1/4", "20 1/2"]
needs_ocr = pytest.mark.skipif(not can_read_labels(), reason="the extra 'ocr' is not installed")


def named(folder: Path, aft: list[str], fore: list[str], aft_side: str = "left", drop: str = "") -> Ship:
    """The tanker with these names; `drop` takes one station of the aft half off both lists."""
    text = (BODYPLAN / "ship.toml").read_text(encoding="utf-8").replace('"left"', f'"{aft_side}"')
    if drop:
        stations = [f"{x:g}" for x in read_ship(BODYPLAN / "ship.toml").body_plan.aft_stations_m]
        del stations[aft.index(drop)]
        aft = [name for name in aft if name != drop]
        text = re.sub(r"aft_stations_m = \[[^]]*\]", f"aft_stations_m = [{', '.join(stations)}]", text)
    keys = f"aft_station_names = {aft}\nfore_station_names = {fore}\n".replace("'", '"')
    path = folder / "ship.toml"
    path.write_text(text.replace("aft_stations_m", f"{keys}aft_stations_m", 1), encoding="utf-8")
    (folder / "bodyplan.png").write_bytes((BODYPLAN / "bodyplan.png").read_bytes())
    return read_ship(path)


@pytest.fixture(scope="module")
def sheet(tmp_path_factory: pytest.TempPathFactory) -> Sheet:
    """The tanker's, with its labels read once where they can be."""
    return prepare_sheet(named(tmp_path_factory.mktemp("tanker"), AFT, FORE))


def doubts(reading: PictureReading) -> str:
    return "\n".join(reading.body_plan.doubts)


def test_names_reach_stations_and_notes(sheet: Sheet, tmp_path: Path) -> None:
    plan = read_sheet(sheet, named(tmp_path, AFT, FORE)).body_plan
    assert [station.name for station in plan.stations] == AFT + FORE
    assert not plan.doubts
    assert any("stations 10, 12, 14, 15 (125.5, 149.4, 173.3, 185.25 m) share one drawn curve" in n for n in plan.notes)


@needs_ocr
def test_labels_name_a_station_that_the_list_lacks(sheet: Sheet, tmp_path: Path) -> None:
    told = doubts(read_sheet(sheet, named(tmp_path, AFT, FORE, drop="4")))
    assert "aft half: the drawing is labelled '4', which aft_station_names does not list" in told


@needs_ocr
def test_labels_tell_that_the_halves_are_swapped(tmp_path: Path) -> None:
    ship = named(tmp_path, AFT, FORE, aft_side="right")
    assert "labels of the drawing are names of stations of the half that was taken for the other side" in doubts(
        read_sheet(prepare_sheet(ship), ship)
    )


@needs_ocr
def test_names_that_are_all_one_station_off(sheet: Sheet, tmp_path: Path) -> None:
    # the x are right, so that spacing alone finds nothing wrong; the labels pull the names to their curves
    assert "fore half" in doubts(read_sheet(sheet, named(tmp_path, AFT, [*FORE[1:], "21"])))


def test_without_a_reader_a_note_says_that_nothing_confirms_the_names(sheet: Sheet, tmp_path: Path) -> None:
    before = sheet.__dict__.get("labels")
    sheet.__dict__["labels"] = None
    try:
        sure = read_sheet(sheet, named(tmp_path, AFT, FORE)).body_plan
        unsure = read_sheet(sheet, named(tmp_path, AFT, FORE, drop="4")).body_plan
    finally:
        sheet.__dict__["labels"] = before
    assert sure.doubts == ()
    assert unsure.doubts
    for plan in (sure, unsure):
        assert any("labels of the drawing were not read" in note for note in plan.notes)


@pytest.mark.parametrize("junk", ["design waterline", "second deck line", "label strokes"])
def test_lines_that_are_no_stations_shift_no_name(junk: str, tmp_path: Path) -> None:
    picture = cv2.imread(str(BODYPLAN / "bodyplan.png"), cv2.IMREAD_GRAYSCALE)
    # base line v = 957.4, 0.0265 m a px, B/2 at u = 169.5 and 1829.5, as docs/ship-file.md has it
    if junk == "design waterline":
        cv2.line(picture, (150, 388), (1850, 388), 20, 2, cv2.LINE_AA)
    elif junk == "second deck line":
        for side in (-1, 1):
            y = np.arange(0.0, 831.0)
            deck = np.column_stack([999.5 + side * y, 170.0 - 8.0 * (1 - (y / 830) ** 2)])
            cv2.polylines(picture, [np.round(deck * 16).astype(np.int32)], False, 20, 2, cv2.LINE_AA, 4)
    else:
        for n in range(6):
            cv2.line(picture, (500 + 90 * n, 300 + 20 * n), (515 + 90 * n, 260 + 20 * n), 20, 2, cv2.LINE_AA)
    path = tmp_path / "ship.toml"
    path.write_text((BODYPLAN / "ship.toml").read_text(encoding="utf-8"), encoding="utf-8")
    cv2.imwrite(str(tmp_path / "bodyplan.png"), picture)
    changed = read_ship(path)
    reading = read_sheet(prepare_sheet(changed), changed)
    assert len(reading.body_plan.stations) == len(AFT + FORE)
    # neighbouring stations lie 2 % of B/2 and more apart: none within half of that can have its neighbour's curve; one
    # curve may run into the line that was added, but a shifted name would put many wrong
    assert np.sort(station_errors(outline("ds-tanker"), reading).rms_percent)[-2] < 1.0
