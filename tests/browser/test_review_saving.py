"""The review page in a Chromium: what is saved, two pages at once, and pictures that cannot be read."""

from __future__ import annotations

import json
import re
from pathlib import Path

import cv2
import pytest
from playwright.sync_api import Browser, Dialog, expect
from review_page import ReviewPage, copied, served

from hullform.cli import main

pytestmark = pytest.mark.browser

# where the script that drew Wigley's picture has these places
KEEL_PX, PORT_DECK_PX, STARBOARD_DECK_PX = (999.5, 1147.5), (169.5, 110.0), (1829.5, 110.0)


def test_saved_review_is_there_after_a_reload_and_in_the_trace(browser: Browser, tmp_path: Path) -> None:
    ship = copied("wigley", tmp_path)
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    with served(ship) as address:
        review = ReviewPage(page, address)
        (curve,) = (c for c in review.reading["curves"] if c["half"] == "aft" and c["stations_m"] == [20])
        place = curve["px"][len(curve["px"]) // 2]
        review.choose_station("aft", 20.0)
        review.press("m")
        review.near(place)
        review.click(place)
        document = review.save()
        assert document["corrections"] == review.corrections
        assert "hullform run" in page.locator("#notice").inner_text()
        page.reload()
        review.settle()
        assert document["corrections"] == review.corrections
        warned: list[Dialog] = []
        page.on("dialog", lambda dialog: (warned.append(dialog), dialog.accept()))
        review.press("k", "0")
        review.click(place)
        page.reload()
        assert [dialog.type for dialog in warned] == ["beforeunload"]
        review.settle()
        assert len(review.corrections) == 1
        image = ship.with_name("bodyplan.png")
        other = cv2.imread(str(image))
        assert other is not None
        other[:5] = 0
        cv2.imwrite(str(image), other)
        review.press("k")
        review.click(place)
        assert "was made of another picture" in page.locator("#notice.bad").inner_text()
        assert review.count("aft") == "10 of 10"
    page.close(run_before_unload=False)
    assert main(["trace", str(ship)]) == 1
    assert main(["review", str(ship), "--no-browser"]) == 1


def test_two_pages_do_not_overwrite_each_other(browser: Browser, tmp_path: Path) -> None:
    ship = copied("wigley", tmp_path)
    file = ship.with_name("ship.review.json")
    place = (700.0, 500.0)
    with served(ship) as address:
        context = browser.new_context(viewport={"width": 1280, "height": 800})
        pages = [context.new_page() for _ in range(2)]
        first, second = (ReviewPage(page, address) for page in pages)
        first.press("k", "0")
        first.click(place)
        saved = first.save()
        assert len(saved["corrections"]) == 1
        second.press("s")
        notice = pages[1].locator("#notice.bad")
        expect(notice).to_contain_text("Not saved. ship.review.json was changed since this page read it")
        assert len(json.loads(file.read_text(encoding="utf-8"))["corrections"]) == 1
        pages[1].locator("#save-over").click()
        expect(pages[1].locator("#notice.good")).to_contain_text("Saved")
        assert json.loads(file.read_text(encoding="utf-8")).get("corrections", []) == []
        # the first page, reloaded, goes on from what lies there
        pages[0].reload()
        first.settle()
        assert first.corrections == []
        context.close()


def test_doubts_and_shared_curves_are_counted_in_sight(browser: Browser, tmp_path: Path) -> None:
    ship = copied("ds-tanker", tmp_path)
    words = ship.read_text(encoding="utf-8")
    ship.write_text(words.replace('aft_side = "left"', 'aft_side = "right"'), encoding="utf-8")
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    with served(ship) as address:
        review = ReviewPage(page, address)
        doubts = review.reading["doubts"]
        assert doubts
        assert page.locator("#doubts").inner_text() == ("1 doubt" if len(doubts) == 1 else f"{len(doubts)} doubts")
        first = page.locator("#doubts-panel li").first.bounding_box()
        assert first is not None
        assert first["y"] + first["height"] <= 900
        for half in review.reading["halves"]:
            shared = sum(bool(row["shared_with_m"]) for row in half["stations"])
            if shared:
                assert page.locator(f".sharing:has-text('{shared} stations share one curve')").count() >= 1
        assert page.locator(".sharing").count() >= 1
    page.close()


def test_a_save_does_not_hide_that_nothing_can_be_read(browser: Browser, tmp_path: Path) -> None:
    ship = copied("wigley", tmp_path)
    words = ship.read_text(encoding="utf-8")
    given = "[body_plan.calibration]\npoints = [{px = [10.0, 10.0], m = [0.0, 0.0]}]\n[structure]"
    ship.write_text(words.replace("[structure]", given, 1), encoding="utf-8")
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    with served(ship) as address:
        review = ReviewPage(page, address)
        review.press("s")
        notice = page.locator("#notice.bad")
        expect(notice).to_contain_text("Saved")
        expect(notice).to_contain_text("fix no scale")
        # closed by hand, it stays closed until it has something else to say
        page.get_by_label("Close this notice").click()
        review.press("v")
        expect(page.locator("#notice")).to_be_hidden()
    page.close()


def test_page_opens_where_nothing_can_be_read_and_known_points_mend_it(browser: Browser, tmp_path: Path) -> None:
    ship = copied("wigley", tmp_path)
    words = ship.read_text(encoding="utf-8")
    # one point fixes no scale
    given = "[body_plan.calibration]\npoints = [{px = [10.0, 10.0], m = [0.0, 0.0]}]\n[structure]"
    ship.write_text(words.replace("[structure]", given, 1), encoding="utf-8")
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    with served(ship) as address:
        review = ReviewPage(page, address)
        assert "fix no scale" in page.locator("#notice.bad").inner_text()
        review.press("b")
        page.get_by_role("button", name="Known points").click()
        known = {(0.0, 0.0): KEEL_PX, (-5.0, 6.25): PORT_DECK_PX, (5.0, 6.25): STARBOARD_DECK_PX}
        for number, ((y, z), px) in enumerate(known.items()):
            review.near(px)
            review.click(px)
            page.get_by_label(f"half-breadth of point {number + 1} in metres").fill(str(y))
            page.get_by_label(f"half-breadth of point {number + 1} in metres").press("Enter")
            review.settle()
            page.get_by_label(f"height of point {number + 1} in metres").fill(str(z))
            page.get_by_label(f"height of point {number + 1} in metres").press("Enter")
            review.settle()
        assert re.fullmatch(r"(9|10) of 10", review.count("aft"))
        assert page.locator("#notice.bad").is_hidden()
    page.close(run_before_unload=False)
