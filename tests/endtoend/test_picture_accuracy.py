"""Draw, read, get it back: traced stations against the outlines that the drawing script drew.

The reader sees the picture and ship.toml only. Distances are taken by arc length both ways, in per cent of B/2.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import cv2
import numpy as np
import pytest
from draw_bodyplans import draw, further_pictures, outline
from reading_accuracy import area_below, station_errors

from hullform.picture.overlay import draw_overlay, write_overlay
from hullform.picture.reading import PictureReading, read_picture
from hullform.ship import read_ship

BODYPLANS = Path(__file__).parents[2] / "bodyplans"
SHIPS = ("scim-containership", "ds-tanker", "wigley", "handymax-bulk-carrier", "fast-ropax")
FURTHER = list(further_pictures())


def check_accuracy(ship_name: str, reading: PictureReading, names: tuple[tuple[float, ...], tuple[float, ...]]) -> None:
    """The bounds that the reading of a clean print has to keep."""
    plan = reading.body_plan
    found = tuple(tuple(s.x_m for s in plan.stations if s.half == half) for half in ("aft", "fore"))
    assert found == names
    errors = station_errors(outline(ship_name), reading)
    # 0.3 % of B/2 is 2 px at 1600 px width, twice what a line's axis is uncertain by where two lines merge
    assert np.mean(errors.rms_percent <= 0.3) >= 0.95, np.sort(errors.rms_percent)[-5:]
    assert errors.rms_percent.max() <= 0.6
    assert np.abs(errors.area_percent).max() <= 0.5
    assert plan.doubts == ()
    assert min(station.confidence for station in plan.stations) >= 0.5


@pytest.mark.parametrize("name", SHIPS)
def test_stations_of_the_shipped_pictures(name: str) -> None:
    ship = read_ship(BODYPLANS / name / "ship.toml")
    reading = read_picture(ship)
    check_accuracy(name, reading, (ship.body_plan.aft_stations_m, ship.body_plan.fore_stations_m))


@pytest.mark.parametrize(("name", "options"), FURTHER, ids=[f"{n}-{o['width_px']}" for n, o in FURTHER])
def test_stations_of_other_widths_line_weights_and_labels(name: str, options: dict[str, float], tmp_path: Path) -> None:
    shutil.copy(BODYPLANS / name / "ship.toml", tmp_path)
    drawing = draw(outline(name), **options)
    cv2.imwrite(str(tmp_path / "bodyplan.png"), drawing.image[:, :, ::-1])
    ship = read_ship(tmp_path / "ship.toml")
    reading = read_picture(ship)
    check_accuracy(name, reading, (ship.body_plan.aft_stations_m, ship.body_plan.fore_stations_m))
    calibration = reading.calibration
    # 0.04 % is 0.3 px on B/2 at 1600 px width: a tenth of what a curve's RMS may be, as curves near a line pull it
    assert calibration.metres_per_px == pytest.approx(drawing.metres_per_px, rel=4e-4)
    assert calibration.centreline_px == pytest.approx(drawing.centreline_px, abs=0.3)
    assert calibration.baseline_px == pytest.approx(drawing.baseline_px, abs=0.5)


@pytest.mark.parametrize("turn_deg", [1.3, -1.9])
def test_a_picture_laid_askew_on_the_scanner(turn_deg: float, tmp_path: Path) -> None:
    name = "scim-containership"
    shutil.copy(BODYPLANS / name / "ship.toml", tmp_path)
    image = cv2.imread(str(BODYPLANS / name / "bodyplan.png"))
    height, width = image.shape[:2]
    matrix = cv2.getRotationMatrix2D((width / 2, height / 2), turn_deg, 1.0)
    turned = cv2.warpAffine(image, matrix, (width, height), flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)
    cv2.imwrite(str(tmp_path / "bodyplan.png"), turned)
    ship = read_ship(tmp_path / "ship.toml")
    reading = read_picture(ship)
    assert reading.calibration.rotation_deg == pytest.approx(turn_deg, abs=0.02)
    check_accuracy(name, reading, (ship.body_plan.aft_stations_m, ship.body_plan.fore_stations_m))


def test_wigley_volume_from_her_picture() -> None:
    reading = read_picture(read_ship(BODYPLANS / "wigley" / "ship.toml"))
    x = np.array([station.x_m for station in reading.body_plan.stations])
    areas = np.array([2 * area_below(s.curves[0].points, reading.draught_m) for s in reading.body_plan.stations])
    # areas are a parabola of x, so Simpson's rule over the whole length, ends of no area added, is exact
    x, areas = np.concatenate([[0.0], x, [100.0]]), np.concatenate([[0.0], areas, [0.0]])
    parabola = np.polynomial.polynomial.polyfit(x, areas, 2)
    volume = sum(c * 100.0 ** (k + 1) / (k + 1) for k, c in enumerate(parabola))
    # the outcome demanded of the whole road is 0.5 %; the reading may use no more than that
    assert volume == pytest.approx(4 / 9 * 100 * 10 * 6.25, rel=0.005)


def test_overlay_shows_the_curves_on_the_picture(tmp_path: Path) -> None:
    reading = read_picture(read_ship(BODYPLANS / "ds-tanker" / "ship.toml"))
    image = draw_overlay(reading)
    assert image.shape == (*reading.grey.shape, 3)
    assert image.dtype == np.uint8
    # colours lie on the ink of the picture: what is strongly coloured is dark in the original, within the stroke
    spread = image.max(axis=2).astype(int) - image.min(axis=2)
    near_ink = cv2.erode(reading.grey, np.ones((9, 9), np.uint8)) < 200
    assert near_ink[spread > 120].mean() > 0.9
    write_overlay(reading, tmp_path / "overlay.png")
    assert np.array_equal(cv2.imread(str(tmp_path / "overlay.png")), image)
