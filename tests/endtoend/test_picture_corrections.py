"""Damaged pictures of the shipped hulls, mended by a person's corrections; and what a page is told of a reading."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import cv2
import numpy as np
import pytest
from draw_bodyplans import outline
from numpy.typing import NDArray
from reading_accuracy import station_errors, to_polyline

from hullform.body_plan import Half
from hullform.corrections import Correction, DeckEdge, Deleted, Drawn, Ignored, Joined, MarkedStation
from hullform.errors import ReviewError
from hullform.picture.reading import PictureReading, read_picture, read_sheet
from hullform.picture.sheet.sheet import Sheet, prepare_sheet
from hullform.review_file import new_review, write_review
from hullform.ship import Ship, read_ship

Array = NDArray[np.float64]
Image = NDArray[np.uint8]
Point = tuple[float, float]

BODYPLANS = Path(__file__).parents[2] / "bodyplans"
WIGLEY, TANKER = "wigley", "ds-tanker"
X_M = 20.0  # of the station of the Wigley hull that is damaged
LITTLE = 0.05  # % of B/2, 0.4 px: what a station may change that nobody touched, or that was drawn through its points


def untouched(name: str) -> tuple[Ship, Sheet]:
    ship = read_ship(BODYPLANS / name / "ship.toml")
    return ship, prepare_sheet(ship)


@cache
def wigley() -> tuple[Ship, Sheet, PictureReading]:
    ship, sheet = untouched(WIGLEY)
    return ship, sheet, read_sheet(sheet, ship)


def damaged(name: str, folder: Path, damage: Callable[[Image], None]) -> tuple[Ship, Sheet]:
    shutil.copy(BODYPLANS / name / "ship.toml", folder)
    image = cv2.imread(str(BODYPLANS / name / "bodyplan.png"))
    damage(image)
    cv2.imwrite(str(folder / "bodyplan.png"), image)
    ship = read_ship(folder / "ship.toml")
    return ship, prepare_sheet(ship)


def pixel(reading: PictureReading, half: Half, y_m: float, z_m: float) -> Point:
    u, v, depth = np.array(reading.calibration.pixel_from_metres) @ np.array([reading.side_of(half) * y_m, z_m, 1.0])
    return float(u / depth), float(v / depth)


def on_station(reading: PictureReading, name: str, half: Half, x_m: float, share: float) -> Point:
    section = outline(name).section(x_m, 400)
    return pixel(reading, half, *section[round(share * 399)])


def rms_of(reading: PictureReading, name: str) -> dict[float, float]:
    errors = station_errors(outline(name), reading).rms_percent
    return {station.x_m: float(rms) for station, rms in zip(reading.body_plan.stations, errors, strict=True)}


def corrected(ship: Ship, sheet: Sheet, *corrections: Correction) -> PictureReading:
    review = new_review(ship).model_copy(update={"corrections": corrections})
    return read_sheet(sheet, review.applied_to(ship), corrections)


def test_an_erased_piece_is_mended_by_a_join(tmp_path: Path) -> None:
    _, _, whole = wigley()

    def erase(image: Image) -> None:
        for share in np.linspace(0.40, 0.62, 80):
            u, v = on_station(whole, WIGLEY, "aft", X_M, share)
            cv2.circle(image, (round(u), round(v)), 9, (255, 255, 255), -1)

    ship, sheet = damaged(WIGLEY, tmp_path, erase)
    assert rms_of(read_sheet(sheet, ship), WIGLEY)[X_M] > 3.0
    ends = (on_station(whole, WIGLEY, "aft", X_M, 0.38), on_station(whole, WIGLEY, "aft", X_M, 0.66))
    mended = corrected(ship, sheet, Joined(id="a", px=ends))
    # a fifth of the curve is led by its ends: over 180 px a smooth section departs from that by some pixels of 830
    assert rms_of(mended, WIGLEY)[X_M] < 0.6
    before, after = rms_of(whole, WIGLEY), rms_of(mended, WIGLEY)
    assert all(after[x] < before[x] + LITTLE for x in before if x != X_M)
    assert mended.body_plan.doubts == ()


@pytest.fixture(scope="module")
def scratched() -> tuple[Ship, Sheet, Array]:
    """The tanker with a scratch across her fore body, and the scratch."""
    ship = read_ship(BODYPLANS / TANKER / "ship.toml")
    scratch: list[Point] = []

    def scratching(image: Image) -> None:
        reading = read_picture(ship)
        t = np.linspace(0.0, 1.0, 200)
        y, z = ship.particulars.breadth_m / 2 * (0.15 + 0.5 * np.sqrt(t)), ship.particulars.depth_m * t
        scratch.extend(pixel(reading, "fore", *at) for at in zip(y.tolist(), z.tolist(), strict=True))
        cv2.polylines(
            image, [np.round(np.array(scratch) * 16).astype(np.int32)], False, (20, 20, 20), 2, cv2.LINE_AA, 4
        )

    return *damaged(TANKER, Path(mkdtemp()), scratching), np.array(scratch)


def test_a_scratch_is_a_curve_until_it_is_ignored(scratched: tuple[Ship, Sheet, Array]) -> None:
    ship, sheet, scratch = scratched
    alone = read_sheet(sheet, ship)
    (nameless,) = [curve for curve in alone.curves if not curve.stations_m]
    assert np.median(to_polyline(nameless.px, scratch)) < 1.0
    aside = np.array([6.0, 0.0])
    outlined = np.vstack([scratch[::20] - aside, scratch[::-20] + aside])
    mended = corrected(ship, sheet, Ignored(id="a", px=tuple((float(u), float(v)) for u, v in outlined)))
    assert mended.body_plan.doubts == ()
    assert all(curve.stations_m for curve in mended.curves)
    # the strip took a piece of each line that the scratch crosses: these are led over it
    assert max(rms_of(mended, TANKER).values()) < 0.4


def test_a_scratch_is_a_curve_until_its_pieces_are_deleted(scratched: tuple[Ship, Sheet, Array]) -> None:
    ship, sheet, scratch = scratched
    deleted: list[Correction] = []
    reading = read_sheet(sheet, ship)
    while reading.body_plan.doubts and len(deleted) < 6:
        pieces = [curve.px[to_polyline(curve.px, scratch) < 1.5] for curve in reading.curves]
        longest = max(pieces, key=len)
        u, v = longest[len(longest) // 2]
        deleted.append(Deleted(id=f"d{len(deleted)}", px=(float(u), float(v))))
        reading = corrected(ship, sheet, *deleted)
    # it crosses three stations, which part it into four pieces
    assert len(deleted) <= 4
    assert reading.body_plan.doubts == ()
    assert max(rms_of(reading, TANKER).values()) < 0.4


def test_a_drawn_curve_is_the_station_and_its_ink_no_other() -> None:
    ship, sheet, whole = wigley()
    points = tuple(on_station(whole, WIGLEY, "aft", X_M, share) for share in np.linspace(0, 1, 9))
    drawn = Drawn(id="a", station_m=X_M, half="aft", px=points)
    # a mark of the same station has nothing more to say
    elsewhere = MarkedStation(id="b", station_m=X_M, half="aft", px=on_station(whole, WIGLEY, "aft", 30.0, 0.5))
    reading = corrected(ship, sheet, drawn, elsewhere)
    (curve,) = [curve for curve in reading.curves if X_M in curve.stations_m]
    assert (curve.by_hand, curve.confidence, curve.number) == (True, 1.0, 0)
    assert to_polyline(np.array(points), curve.px).max() < 0.1
    assert reading.body_plan.doubts == ()
    before, after = rms_of(whole, WIGLEY), rms_of(reading, WIGLEY)
    assert all(after[x] < before[x] + LITTLE for x in before)
    assert len(reading.curves) == len(whole.curves)


def test_a_drawn_second_contour_joins_its_station() -> None:
    ship, sheet, _ = wigley()
    reading = read_sheet(sheet, ship)
    loop = tuple(pixel(reading, "fore", y, z) for y, z in ((0.0, 0.2), (0.4, 0.6), (0.0, 1.0)))
    with_loop = corrected(ship, sheet, Drawn(id="a", station_m=97.5, half="fore", curve=1, px=loop))
    (station,) = [station for station in with_loop.body_plan.stations if station.x_m == 97.5]
    assert len(station.curves) == 2
    assert station.curves[1].half_breadth_m[[0, -1]] == pytest.approx([0.0, 0.0], abs=1e-9)


def test_of_two_curves_drawn_for_a_station_the_later_counts() -> None:
    ship, sheet, whole = wigley()
    points = tuple(on_station(whole, WIGLEY, "aft", X_M, share) for share in np.linspace(0, 1, 9))
    off = tuple((u + 9.0, v) for u, v in points)
    reading = corrected(
        ship,
        sheet,
        Drawn(id="first", station_m=X_M, half="aft", px=off),
        Drawn(id="second", station_m=X_M, half="aft", px=points),
    )
    assert [item.id for item in reading.unheeded] == ["first"]
    assert rms_of(reading, WIGLEY)[X_M] < LITTLE


def test_a_deck_edge_ends_the_stations_of_its_half() -> None:
    ship, sheet, whole = wigley()
    height, half_breadth = 0.8 * ship.particulars.depth_m, ship.particulars.breadth_m / 2
    edge = DeckEdge(
        id="a", half="fore", px=(pixel(whole, "fore", 0.0, height), pixel(whole, "fore", half_breadth, height))
    )
    reading = corrected(ship, sheet, edge)
    tops = {s.half: [] for s in reading.body_plan.stations}
    for station in reading.body_plan.stations:
        tops[station.half].append(float(station.curves[0].height_m[-1]))
    pixel_m = reading.calibration.metres_per_px
    assert tops["fore"] == pytest.approx([height] * len(tops["fore"]), abs=pixel_m)
    assert tops["aft"] == pytest.approx([ship.particulars.depth_m] * len(tops["aft"]), abs=2 * pixel_m)


EMPTY: Point = (1100.0, 120.0)  # paper, high up in the bow


@pytest.mark.parametrize(
    "correction",
    [
        Deleted(id="fault", px=EMPTY),
        Joined(id="fault", px=(EMPTY, (1200.0, 130.0))),
        Ignored(id="fault", px=((5.0, 5.0), (20.0, 5.0), (5.0, 20.0))),
        MarkedStation(id="fault", station_m=X_M, half="aft", px=(200.0, 1200.0)),
    ],
    ids=lambda correction: correction.kind,
)
def test_a_correction_without_effect_is_a_doubt_of_its_own(correction: Correction) -> None:
    ship, sheet, _ = wigley()
    reading = corrected(ship, sheet, correction)
    (item,) = reading.unheeded
    assert item.id == "fault"
    assert "correction fault" in item.text
    assert item.text in reading.body_plan.doubts


def test_a_drawn_curve_of_a_station_that_is_not_listed_is_refused() -> None:
    ship, _, _ = wigley()
    drawn = Drawn(id="a", station_m=-7.0, half="aft", px=((1.0, 1.0), (2.0, 2.0)))
    with pytest.raises(ReviewError, match="-7 m of the aft half"):
        new_review(ship).model_copy(update={"corrections": (drawn,)}).applied_to(ship)


def test_the_review_beside_a_ship_is_heeded(tmp_path: Path) -> None:
    ship, _ = damaged(WIGLEY, tmp_path, lambda image: None)
    _, _, whole = wigley()
    points = tuple(on_station(whole, WIGLEY, "aft", X_M, share) for share in np.linspace(0, 1, 9))
    drawn = Drawn(id="a", station_m=X_M, half="aft", px=points)
    write_review(new_review(ship).model_copy(update={"corrections": (drawn,)}), ship)
    reading = read_picture(ship)
    assert [curve.stations_m for curve in reading.curves if curve.by_hand] == [(X_M,)]
    assert reading.body_plan.notes[0] == "ship.review.json goes before ship.toml; it gives 1 correction"


def test_what_a_page_is_told_fits_the_body_plan() -> None:
    _, sheet, reading = wigley()
    named = {(curve.half, x) for curve in reading.curves for x in curve.stations_m}
    assert named == {(station.half, station.x_m) for station in reading.body_plan.stations}
    ink = sheet.grey < 128
    for curve in reading.curves:
        # the middle of a traced curve lies on ink of the stored picture
        u, v = np.round(curve.px[len(curve.px) // 3]).astype(int)
        assert ink[v - 2 : v + 3, u - 2 : u + 3].any()
