"""What the review page is told: areas, waterlines, residuals, and which of two readings wins."""

from __future__ import annotations

import json
import shutil
import threading
from pathlib import Path

import cv2
import numpy as np
import pytest

from hullform.body_plan import Station, TracedCurve
from hullform.errors import ReviewError
from hullform.review import desk as desks
from hullform.review.desk import Desk, SupersededError
from hullform.review.evidence import Evidence
from hullform.review.form import half_breadth_at, waterlines
from hullform.review.shown_picture import shown_picture
from hullform.ship import read_ship

WIGLEY = Path(__file__).parents[2] / "bodyplans" / "wigley"


@pytest.fixture(scope="module")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Desk:
    folder = tmp_path_factory.mktemp("desk") / "wigley"
    shutil.copytree(WIGLEY, folder, ignore=shutil.ignore_patterns("results"))
    return Desk(read_ship(folder / "ship.toml"))


def test_half_breadth_is_the_largest_of_the_crossings() -> None:
    curve = (TracedCurve(np.array([0.0, 3.0, 1.0, 4.0]), np.array([0.0, 2.0, 2.0, 4.0])),)
    assert half_breadth_at(curve, 1.0) == pytest.approx(1.5)
    assert half_breadth_at(curve, 2.0) == pytest.approx(3.0)
    assert half_breadth_at(curve, 5.0) is None


def test_waterline_leaves_out_stations_that_do_not_reach_it() -> None:
    low = Station(0.0, "aft", (TracedCurve(np.array([0.0, 1.0]), np.array([0.0, 1.0])),))
    high = Station(5.0, "aft", (TracedCurve(np.array([0.0, 2.0]), np.array([0.0, 4.0])),))
    assert waterlines([low, high], [2.0]) == [[(5.0, pytest.approx(1.0))]]


def test_view_of_wigley_has_areas_of_the_formula_and_small_residuals(desk: Desk) -> None:
    opening = desk.opening()
    assert opening["failure"] is None
    # the document goes to a browser, whose JSON knows no NaN
    json.dumps(opening, allow_nan=False)
    reading = opening["reading"]
    assert [half["found"] for half in reading["halves"]] == [10, 10]
    for point in reading["areas"]:
        # y = (B/2) (1 - (2x/L - 1)^2) (1 - (z'/T)^2): area 2/3 T B (1 - (2x/L - 1)^2); read to a few pixels of 830
        exact = 2 / 3 * 6.25 * 10 * (1 - (2 * point["x_m"] / 100 - 1) ** 2)
        assert point["area_m2"] == pytest.approx(exact, abs=0.004 * 41.7)
    # a ridge lies within a fraction of a pixel of its line's axis; a curve beside its line would be a line's width off
    assert max(curve["residual_px"] for curve in reading["curves"]) < 2.5


def test_residual_of_a_curve_beside_its_line_is_its_distance(desk: Desk) -> None:
    review = desk.opening()["review"]
    ship = desk.ship
    sheet = desks.prepare_sheet(ship)
    (curve,) = (c for c in desk.solve(review)["curves"] if c["half"] == "aft" and c["stations_m"] == [20])
    evidence = Evidence(sheet.halves["aft"], sheet.reduction)
    # the middle of the curve is alone; its ends run into other lines
    px = np.array(curve["px"])[40:80]
    tangent = np.gradient(px, axis=0)
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]]) / np.hypot(*tangent.T)[:, None]
    on = evidence.residual_px(px)
    beside = evidence.residual_px(px + 2.0 * normal)
    assert on is not None
    assert beside is not None
    assert on < 0.5
    assert beside == pytest.approx(2.0, abs=0.5)
    assert evidence.residual_px(px + 400.0) is None or evidence.residual_px(px + 400.0) != on


def test_calibration_is_prepared_once_and_its_sheet_kept(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    review = desk.opening()["review"]
    prepared: list[str] = []
    real = desks.prepare_sheet
    monkeypatch.setattr(desks, "prepare_sheet", lambda ship: (prepared.append("one"), real(ship))[1])
    shifted = review | {"calibration": {"centreline_px": 1000.0}}
    for document in (review, shifted, review, shifted):
        desk.solve(document)
    assert prepared == ["one"]


def test_reading_that_a_later_one_overtook_is_not_made(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    review = desk.opening()["review"]
    begun, go_on = threading.Event(), threading.Event()
    real = desks.read_sheet

    def slow(*arguments: object) -> object:
        begun.set()
        assert go_on.wait(60)
        return real(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(desks, "read_sheet", slow)
    outcomes: dict[str, str] = {}

    def ask(name: str) -> None:
        try:
            desk.solve(review)
            outcomes[name] = "read"
        except SupersededError:
            outcomes[name] = "overtaken"

    first = threading.Thread(target=ask, args=("first",))
    first.start()
    assert begun.wait(60)
    waiting = []
    for name in ("second", "third"):
        waiting.append(threading.Thread(target=ask, args=(name,)))
        asked = desk._asked
        waiting[-1].start()
        while desk._asked == asked:
            pass
    go_on.set()
    for thread in (first, *waiting):
        thread.join()
    assert outcomes == {"first": "read", "second": "overtaken", "third": "read"}


def test_review_that_does_not_fit_is_not_saved(desk: Desk) -> None:
    review = desk.opening()["review"]
    stray = {"id": "c1", "kind": "mark", "station_m": 33.0, "half": "aft", "px": [800.0, 700.0]}
    with pytest.raises(ReviewError, match=r"station 33 m of the aft half"):
        desk.save(review | {"corrections": [stray]}, "none")
    assert not desk.ship.path.with_name("ship.review.json").exists()


@pytest.mark.parametrize("suffix", [".tif", ".bmp", ".webp"])
def test_picture_that_browsers_may_not_show_is_sent_as_png(tmp_path: Path, suffix: str) -> None:
    image = cv2.imread(str(WIGLEY / "bodyplan.png"), cv2.IMREAD_GRAYSCALE)
    assert image is not None
    path = tmp_path / f"bodyplan{suffix}"
    assert cv2.imwrite(str(path), image)
    content, media_type = shown_picture(path)
    assert media_type == "image/png"
    shown = cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_GRAYSCALE)
    assert shown is not None
    assert shown.shape == image.shape
