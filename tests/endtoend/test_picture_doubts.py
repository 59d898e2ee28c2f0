"""Pictures and ship.toml that do not fit together: what the reader says of each, instead of a wrong reading."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import cv2
import numpy as np
import pytest
from draw_bodyplans import draw, outline
from generator.pictures import make
from generator.suite import DEVELOPMENT_SEED, suite
from reading_accuracy import station_errors
from real_hull import real_hull

from hullform.errors import OutputError, PictureError
from hullform.picture import overlay
from hullform.picture.reading import PictureReading, read_picture
from hullform.ship import read_ship

BODYPLANS = Path(__file__).parents[2] / "bodyplans"
CONTAINER, TANKER, WIGLEY = "scim-containership", "ds-tanker", "wigley"
Edits = tuple[tuple[str, str], ...]


def read(folder: Path, name: str, edits: Edits = (), picture: np.ndarray | None = None) -> PictureReading:
    """Read a shipped ship with text of her ship.toml replaced, or with another picture."""
    text = (BODYPLANS / name / "ship.toml").read_text(encoding="utf-8")
    for pattern, new in edits:
        text, count = re.subn(pattern, new, text, count=1, flags=re.MULTILINE)
        assert count == 1, pattern
    (folder / "ship.toml").write_text(text, encoding="utf-8")
    if picture is None:
        shutil.copy(BODYPLANS / name / "bodyplan.png", folder)
    else:
        cv2.imwrite(str(folder / "bodyplan.png"), picture)
    return read_picture(read_ship(folder / "ship.toml"))


def shipped(name: str) -> np.ndarray:
    return cv2.imread(str(BODYPLANS / name / "bodyplan.png"), cv2.IMREAD_GRAYSCALE)


def doubts(reading: PictureReading) -> str:
    return "\n".join(reading.body_plan.doubts)


@pytest.mark.parametrize(
    ("name", "edit", "words"),
    [
        (
            WIGLEY,
            (" 10.0, 15.0,", " 15.0,"),
            "aft half: 10 curves seen but 9 stations listed; one station is missing .* between 5, 15 m",
        ),
        (WIGLEY, (r"95.0, 97.5", "95.0"), "fore half: 10 curves seen but 9 stations listed"),
        (WIGLEY, (" 75.0,", ""), "fore half: 10 curves seen but 9 stations listed; .* between 70, 80 m"),
        (CONTAINER, (" 16.3, 19.4,", ""), "aft half: 13 curves seen but 11 stations listed; 2 stations are missing"),
        (WIGLEY, ("45.0,", "45.0, 47.5,"), r"10 curves for 11 stations, but the outermost, .* only 99.0 % of B/2"),
        (
            CONTAINER,
            ("118.6,", f"118.6, {', '.join(str(119 + k / 2) for k in range(15))},"),
            "13 curves for 28 stations",
        ),
        # a parallel body from 60 to 185 m is 52 % of the LPP
        (
            TANKER,
            (r"41.85, 53.8, 65.75, 77.7, 101.6, 113.55", "34, 36, 38, 40, 60, 113.55"),
            r"parallel body: .* 52 % of LPP",
        ),
        (CONTAINER, ('"left"', '"right"'), "aft_side: .* 15 curves for 13 stations, the other 13 for 16"),
    ],
)
def test_curves_that_do_not_fit_the_stations(name: str, edit: tuple[str, str], words: str, tmp_path: Path) -> None:
    assert re.search(words, doubts(read(tmp_path, name, (edit,))))


def test_a_mirrored_picture(tmp_path: Path) -> None:
    assert "aft_side" in doubts(read(tmp_path, CONTAINER, picture=shipped(CONTAINER)[:, ::-1]))


@pytest.mark.parametrize("quarter_turns", [1, -1])
def test_a_picture_that_lies_on_its_side(quarter_turns: int, tmp_path: Path) -> None:
    # turned counterclockwise, it stands again when it is turned clockwise
    back = "clockwise" if quarter_turns == 1 else "counterclockwise"
    with pytest.raises(PictureError, match=f"lies on its side: turned by 90 degrees {back} it reads"):
        read(tmp_path, WIGLEY, picture=np.rot90(shipped(WIGLEY), quarter_turns))


@pytest.mark.parametrize(
    ("station", "px", "words"),
    [
        ("10.0", "[3000, 20]", "outside the picture of 2000 x 1358 px"),
        ("15.0", "[1500, 300]", "in the other half"),
        ("25.0", "[780, 300]", "8 % of B/2 from the nearest traced curve"),
        ("20.0", "[570, 700]", "lies on curve 6 from the centre line, but the station got curve 5"),
        ("30.0", "[303, 150]", "^$"),
    ],
)
def test_marks(station: str, px: str, words: str, tmp_path: Path) -> None:
    mark = f'[[body_plan.marks]]\nstation_m = {station}\nhalf = "aft"\npx = {px}\n[structure]'
    assert re.search(words, doubts(read(tmp_path, WIGLEY, ((r"^\[structure\]", mark),))))


@pytest.mark.parametrize(
    ("name", "key", "value"),
    [
        (CONTAINER, "depth_m", 22),
        (CONTAINER, "depth_m", 20.5),
        (CONTAINER, "depth_m", 18),
        (TANKER, "depth_m", 24),
        (CONTAINER, "breadth_m", 28),
        (CONTAINER, "breadth_m", 36),
    ],
)
def test_breadth_and_depth_that_do_not_fit_the_picture(name: str, key: str, value: float, tmp_path: Path) -> None:
    found = doubts(read(tmp_path, name, ((rf"^{key} = \S+", f"{key} = {value}"),)))
    assert re.search(r"m from the centre line and \d+\.\d+ m above the base line", found)
    assert f"{key} = {value}" in found
    assert "depth_m" in found
    assert "breadth_m" in found


@pytest.mark.parametrize(
    ("name", "key", "value"),
    [(CONTAINER, "depth_m", 24), (CONTAINER, "depth_m", 15), (CONTAINER, "breadth_m", 25), (WIGLEY, "depth_m", 8)],
)
def test_particulars_far_from_the_picture_are_refused(name: str, key: str, value: float, tmp_path: Path) -> None:
    edits = ((rf"^{key} = \S+", f"{key} = {value}"), (r"^draught_m = \S+", "draught_m = 5.0"))
    with pytest.raises(PictureError, match="check breadth_m, depth_m") as caught:
        read(tmp_path, name, edits)
    assert f"{key} = {value}" in str(caught.value)


@pytest.mark.parametrize("name", [CONTAINER, TANKER, WIGLEY])
def test_a_stretched_picture_gives_both_scales(name: str, tmp_path: Path) -> None:
    stretched = cv2.resize(shipped(name), None, fx=1.0, fy=1.09, interpolation=cv2.INTER_AREA)
    found = re.search(
        r"that is (\S+) m per px by the breadth and (\S+) m per px by the depth",
        doubts(read(tmp_path, name, picture=stretched)),
    )
    assert found
    # the height of the side is read to a few pixels of a thousand
    assert float(found[1]) / float(found[2]) == pytest.approx(1.09, rel=0.006)


def scaled(image: np.ndarray, factor: float) -> np.ndarray:
    return cv2.resize(image, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)


def test_a_small_picture(tmp_path: Path) -> None:
    found = doubts(read(tmp_path, CONTAINER, picture=scaled(shipped(CONTAINER), 0.6)))
    assert "the picture is small: S = 498 px per half-breadth; scan or export it 2100 px wide" in found
    assert "mark" not in found


def test_a_very_small_picture_needs_marks(tmp_path: Path) -> None:
    found = doubts(read(tmp_path, WIGLEY, picture=scaled(shipped(WIGLEY), 0.4)))
    assert re.search(r"S = 3\d\d px per half-breadth.*; as it is, mark a point of each station", found)


@pytest.mark.parametrize(("brush_px", "kind"), [(3, "note"), (7, "doubt")])
def test_thick_lines(brush_px: int, kind: str, tmp_path: Path) -> None:
    # lines of 2.2 px become about 4 and 8: S / lw = 210 and 105
    brush = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (brush_px, brush_px))
    plan = read(tmp_path, TANKER, picture=cv2.erode(shipped(TANKER), brush)).body_plan
    said = "\n".join(plan.notes if kind == "note" else plan.doubts)
    found = re.search(r"lines of (\S+) px at S = 83\d px per half-breadth, S / lw = (\d+)", said)
    assert found
    assert float(found[1]) == pytest.approx(2.2 + brush_px - 1, abs=0.8)
    assert ("mark a point of each station" in said) == (kind == "doubt")


def test_curves_that_run_out_of_the_picture(tmp_path: Path) -> None:
    found = doubts(read(tmp_path, WIGLEY, picture=shipped(WIGLEY)[220:]))
    assert "aft half: 10 curves reach the edge of the picture" in found


def test_foremost_stations_cut_off_above_the_deck(tmp_path: Path) -> None:
    found = doubts(read(tmp_path, CONTAINER, picture=shipped(CONTAINER)[220:]))
    assert re.search(r"\d+ lines run out of the picture at its top or sides", found)


def test_a_large_picture_is_read_small_and_told_in_its_own_pixels(tmp_path: Path) -> None:
    drawing = draw(outline(WIGLEY), width_px=5000, curve_px=5.0, grid_px=2.2)
    reading = read(tmp_path, WIGLEY, picture=np.ascontiguousarray(drawing.image[:, :, ::-1]))
    assert doubts(reading) == ""
    assert reading.grey.shape[1] < 4000
    assert reading.calibration.metres_per_px == pytest.approx(drawing.metres_per_px, rel=4e-4)
    assert reading.calibration.centreline_px == pytest.approx(drawing.centreline_px, abs=0.5)
    assert reading.calibration.baseline_px == pytest.approx(drawing.baseline_px, abs=1.0)
    assert station_errors(outline(WIGLEY), reading).rms_percent.max() <= 0.3
    # the overlay lies on the picture that was read
    image = overlay.draw_overlay(reading)
    spread = image.max(axis=2).astype(int) - image.min(axis=2)
    near_ink = cv2.erode(reading.grey, np.ones((15, 15), np.uint8)) < 200
    assert near_ink[spread > 120].mean() > 0.85


def test_a_picture_of_hard_edges(tmp_path: Path) -> None:
    # 160: the grey lines of the sheer and the grid stay; at 128 many of them are gone, and with them what they say
    reading = read(tmp_path, CONTAINER, picture=np.where(shipped(CONTAINER) < 160, 0, 255).astype(np.uint8))
    errors = station_errors(outline(CONTAINER), reading)
    assert doubts(reading) == ""
    assert np.mean(errors.rms_percent <= 0.3) >= 0.95
    assert errors.rms_percent.max() <= 0.6
    assert np.abs(errors.area_percent).max() <= 0.5


def test_no_side_line_is_no_false_alarm(tmp_path: Path) -> None:
    # at 150 the lines of the box at B/2 are gone, and the hull has no flat of side
    reading = read(tmp_path, WIGLEY, picture=np.where(shipped(WIGLEY) < 150, 0, 255).astype(np.uint8))
    assert "scale" not in doubts(reading)


@pytest.mark.parametrize("damage", ["cut", "changed"])
def test_a_damaged_png_says_so_in_our_words_only(
    damage: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    data = bytearray((BODYPLANS / WIGLEY / "bodyplan.png").read_bytes())
    if damage == "cut":
        data = data[: len(data) // 2]
    else:
        data[len(data) // 2] ^= 0xFF
    shutil.copy(BODYPLANS / WIGLEY / "ship.toml", tmp_path)
    (tmp_path / "bodyplan.png").write_bytes(data)
    with pytest.raises(PictureError, match="damaged or cut short"):
        read_picture(read_ship(tmp_path / "ship.toml"))
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("name", [CONTAINER, TANKER, WIGLEY])
def test_names_in_the_overlay_do_not_cover_each_other(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    boxes: list[tuple[float, float, float, float]] = []
    words: list[str] = []
    write = cv2.putText

    def note(image: np.ndarray, text: str, at: tuple[int, int], *options: object) -> np.ndarray:
        (width, height), _ = cv2.getTextSize(text, options[0], options[1], 1)
        if options[2] != (255, 255, 255):  # not the halo
            boxes.append((at[0], at[1] - height, at[0] + width, at[1]))
            words.append(text)
        return write(image, text, at, *options)

    monkeypatch.setattr(cv2, "putText", note)
    reading = read(tmp_path, name)
    overlay.draw_overlay(reading)
    for i, a in enumerate(boxes):
        for j, b in enumerate(boxes[:i]):
            apart = a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
            assert apart, (words[i], words[j])
    if name == TANKER:
        assert {"101.6-113.55", "125.5-185.25"} <= set(words)


def test_overlay_is_of_an_image_type_and_written_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    reading = read(tmp_path, WIGLEY)
    with pytest.raises(OutputError, match="is no image type"):
        overlay.write_overlay(reading, tmp_path / "overlay.txt")
    path = tmp_path / "overlay.png"
    path.write_text("what was there before")

    def fail(_: PictureReading) -> np.ndarray:
        raise KeyboardInterrupt

    monkeypatch.setattr(overlay, "draw_overlay", fail)
    with pytest.raises(KeyboardInterrupt):
        overlay.write_overlay(reading, path)
    assert path.read_text() == "what was there before"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["bodyplan.png", "overlay.png", "ship.toml"]


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (('"left"', '"right"'), "with the halves swapped: check aft_side"),
        ((" 233.05,", ""), r"if one more station lay between 227\.1 and 239 m \(fore half\)"),
    ],
)
def test_names_that_are_wrong_in_silence_make_unfair_waterlines(
    edit: tuple[str, str], words: str, tmp_path: Path
) -> None:
    assert re.search(f"waterlines: as named, .* {words}", doubts(read(tmp_path, TANKER, (edit,))))


@pytest.mark.parametrize(
    ("waterlines", "words"), [(1, "curves go on below the base line|scale: "), (-1, "the fullest sections end|scale: ")]
)
def test_a_base_line_that_is_one_waterline_off(waterlines: int, words: str, tmp_path: Path) -> None:
    # the tanker's lies at 957.4 px; her grid is 2 m, and 0.026506 m are a pixel
    baseline_px = 957.4 - waterlines * 2 / 0.026506
    given = f"[body_plan.calibration]\nbaseline_px = {baseline_px:.1f}\n[structure]"
    assert re.search(words, doubts(read(tmp_path, TANKER, ((r"^\[structure\]", given),))))


@pytest.mark.parametrize("name", [CONTAINER, TANKER, WIGLEY])
def test_a_scan_of_one_bit(name: str, tmp_path: Path) -> None:
    # at 128 the grey grid is gone: the scale rests on the breadth alone
    reading = read(tmp_path, name, picture=np.where(shipped(name) < 128, 0, 255).astype(np.uint8))
    errors = station_errors(outline(name), reading)
    # jagged edges cost a fraction of a pixel, 0.12 % of B/2 each
    assert np.median(errors.rms_percent) <= 0.2
    # of the tanker's sheer line only specks are left, and with it goes where the foremost stations end
    assert np.mean(errors.rms_percent <= 1.2) >= 0.9 or "fore_stations_m would miss" in doubts(reading)


@pytest.mark.parametrize("number", [40, 74])
def test_sheer_does_not_speak_against_the_depth(number: int, tmp_path: Path) -> None:
    # of the frigate and the tanker, the curves at the side end up to 5 % of D above the depth
    picture = make(suite(DEVELOPMENT_SEED)[number])
    assert "scale" not in "\n".join(read_picture(read_ship(picture.write(tmp_path))).body_plan.doubts)


def test_one_station_too_many_in_a_list_is_told(tmp_path: Path) -> None:
    # the two stations that then share a curve differ in their bottoms only
    hull = real_hull("gunnerus", tmp_path)
    text = hull.toml.read_text(encoding="utf-8")
    hull.toml.write_text(text.replace("8.7, 10.44", "8.7, 9.5, 10.44"), encoding="utf-8")
    reading = read_picture(read_ship(hull.toml))
    assert "15.66, 17.4 m share the outermost curve, but the sections still change" in doubts(reading)


def test_curves_that_cross_cost_confidence(tmp_path: Path) -> None:
    hull = real_hull("gunnerus", tmp_path)
    reading = read_picture(read_ship(hull.toml))
    crossed = {float(x) for x in re.findall(r"station ([\d.]+) m \(\w+ half\)", doubts(reading))}
    assert crossed
    for station in reading.body_plan.stations:
        assert (station.confidence <= 0.6) == (round(station.x_m, 3) in crossed)
