"""The review page in a Chromium: every tool, by mouse and by keys, and undo."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect
from review_page import KEYS, ReviewPage, copied, served

from hullform.corrections import Drawn

pytestmark = pytest.mark.browser

# A screen pixel is less than a picture pixel after zooming in, and a click falls on a whole screen pixel.
HAND_PX = 1.0


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with served(copied("wigley", tmp_path_factory.mktemp("review"))) as address:
        yield address


@pytest.fixture
def review(browser: Browser, address: str) -> Iterator[ReviewPage]:
    """A page that nobody has saved from yet."""
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    review = ReviewPage(page, address)
    yield review
    page.close()
    assert review.said == []


def test_page_shows_picture_curves_and_counts_and_asks_nobody_else(browser: Browser, address: str) -> None:
    page = browser.new_page(viewport={"width": 1024, "height": 700})
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    review = ReviewPage(page, address)
    assert review.count("aft") == "10 of 10"
    assert review.count("fore") == "10 of 10"
    assert page.locator("#picture").evaluate("image => image.naturalWidth") == 2000
    assert page.locator(".curves .curve").count() == 20
    assert page.locator(".dot").count() == 20
    assert page.locator(".waterline").count() == 5
    assert page.evaluate("document.documentElement.scrollWidth") <= 1024
    # the longest hint of all leaves the picture and the panel where they are
    review.press("b")
    page.get_by_role("button", name="Known points").click()
    stage, panel = (page.locator(name).bounding_box() for name in ("#stage", "aside"))
    assert stage is not None
    assert panel is not None
    assert stage["x"] + stage["width"] <= panel["x"] + 0.5
    assert panel["x"] + panel["width"] <= 1024
    own = address.partition("?")[0]
    assert [url for url in asked if not url.startswith((own, "data:"))] == []
    assert page.url == own
    assert review.said == []
    page.close()


def test_every_control_has_a_name(review: ReviewPage) -> None:
    unnamed = review.page.evaluate(
        "[...document.querySelectorAll('button, input, textarea, [role=application]')].filter(e =>"
        " !(e.textContent.trim() || e.getAttribute('aria-label') || e.closest('label'))).map(e => e.outerHTML)"
    )
    assert unnamed == []


@pytest.mark.parametrize("kind", ["delete", "cut", "cross", "knuckle"])
def test_tool_of_one_click(review: ReviewPage, kind: str) -> None:
    place = review.reading["curves"][5]["px"][60]
    review.press(KEYS[kind])
    review.near(place)
    review.click(place)
    (made,) = review.corrections
    assert made["kind"] == kind
    assert made["px"] == pytest.approx(place, abs=HAND_PX)
    review.press("Control+z")
    assert review.corrections == []


@pytest.mark.parametrize("kind", ["join", "together"])
def test_tool_of_two_clicks(review: ReviewPage, kind: str) -> None:
    first, second = (review.reading["curves"][5]["px"][n] for n in (60, 90))
    review.press(KEYS[kind])
    review.near(first)
    review.click(first)
    assert review.corrections == []
    review.into_sight(second)
    review.click(second)
    (made,) = review.corrections
    assert made["kind"] == kind
    assert made["px"][0] == pytest.approx(first, abs=HAND_PX)
    assert made["px"][1] == pytest.approx(second, abs=HAND_PX)


def test_cutting_takes_a_curve_apart_and_undo_puts_it_together(review: ReviewPage) -> None:
    before = review.reading["curves"]
    curve = before[4]
    # Wigley's sections meet at the keel, so one that is cut half-way up loses its lower or its upper part
    place = curve["px"][len(curve["px"]) // 2]
    review.press("c")
    review.near(place)
    review.click(place)
    assert review.reading["curves"] != before
    review.press("Control+z")
    assert review.reading["curves"] == before


def test_marks_name_stations_one_after_the_other(review: ReviewPage) -> None:
    review.choose_station("aft", 20.0)
    review.press("m")
    for station in (20.0, 25.0):
        (curve,) = (c for c in review.reading["curves"] if c["half"] == "aft" and c["stations_m"] == [station])
        place = curve["px"][len(curve["px"]) // 2]
        review.near(place)
        review.click(place)
    assert [(one["station_m"], one["half"]) for one in review.corrections] == [(20, "aft"), (25, "aft")]
    assert review.station("aft", 30.0).get_attribute("aria-pressed") == "true"
    assert review.count("aft") == "10 of 10"
    # marking a station again moves its mark
    review.choose_station("aft", 20.0)
    review.click(place)
    assert len(review.corrections) == 2


def test_mark_in_the_other_half_is_refused(review: ReviewPage) -> None:
    (curve,) = (c for c in review.reading["curves"] if c["half"] == "fore" and c["stations_m"] == [60])
    review.choose_station("aft", 20.0)
    review.press("m")
    review.click(curve["px"][len(curve["px"]) // 2])
    assert review.corrections == []
    assert "you clicked in the fore half" in review.page.locator("#hint").inner_text()


def test_drawn_curve_is_read_as_drawn_and_its_points_can_be_dragged(review: ReviewPage) -> None:
    (curve,) = (c for c in review.reading["curves"] if c["half"] == "fore" and c["stations_m"] == [70])
    places = tuple(tuple(curve["px"][round(share * (len(curve["px"]) - 1))]) for share in (0, 0.2, 0.4, 0.6, 0.8, 1))
    review.snap(False)
    review.correct([Drawn(id="by hand", station_m=70.0, half="fore", px=places)])
    (made,) = review.corrections
    assert made["kind"] == "drawn"
    assert [tuple(px) for px in made["px"]] == [pytest.approx(place, abs=HAND_PX) for place in places]
    assert review.row("fore", 70.0)["confidence"] == 1
    (drawn,) = (c for c in review.reading["curves"] if c["standing"] == "drawn")
    assert drawn["stations_m"] == [70]
    target = (places[2][0] + 30, places[2][1])
    review.press("v")
    review.near(places[2])
    review.drag(places[2], target)
    (moved,) = review.corrections
    assert moved["px"][2] == pytest.approx(target, abs=HAND_PX)
    (drawn,) = (c for c in review.reading["curves"] if c["standing"] == "drawn")
    nearest = min(((u - target[0]) ** 2 + (v - target[1]) ** 2) ** 0.5 for u, v in drawn["px"])
    # the points of a curve that the page is sent lie some four pixels apart
    assert nearest < 3
    review.page.locator("#corrections-panel").get_by_role("button", name="smooth").click()
    review.settle()
    assert review.corrections[0]["smooth"] is False


def test_escape_and_backspace_take_back_what_is_being_drawn(review: ReviewPage) -> None:
    review.choose_station("fore", 70.0)
    review.press("d", "0")
    for place in ((1200, 700), (1300, 600), (1400, 500)):
        review.click(place)
    review.press("Backspace")
    assert review.page.evaluate("hullformReview.tool.points.length") == 2
    review.press("Escape")
    assert review.page.evaluate("hullformReview.tool.points.length") == 0
    assert review.corrections == []


def test_deck_line_and_ignored_box(review: ReviewPage) -> None:
    height, width = review.page.evaluate("[hullformReview.picture.height_px, hullformReview.picture.width_px]")
    review.press("e", "0")
    deck = [review.page.evaluate("m => hullformReview.pixelAt(m)", [y, 6.25]) for y in (0.4, 2.5, 4.9)]
    for place in deck:
        review.click(place)
    review.press("Enter")
    (made,) = review.corrections
    assert (made["kind"], made["half"], len(made["px"])) == ("deck", "fore", 3)
    review.press("i")
    review.drag((0.02 * width, 0.94 * height), (0.5 * width, 0.98 * height))
    assert [one["kind"] for one in review.corrections] == ["deck", "ignore"]
    assert len(review.corrections[1]["px"]) == 4


def test_calibration_is_confirmed_as_it_was_found(review: ReviewPage) -> None:
    before = review.reading["calibration"]
    assert "not confirmed" in review.page.locator("#calibration-status").inner_text()
    review.page.locator("#confirm").click()
    review.settle()
    assert "confirmed" in review.page.locator("#calibration-status").inner_text()
    after = review.reading["calibration"]
    for name in ("centreline_px", "baseline_px", "metres_per_px"):
        assert after[name] == pytest.approx(before[name], rel=1e-5)


def test_calibration_by_dragging_the_centre_line(review: ReviewPage) -> None:
    before = review.reading["calibration"]
    review.press("b")
    start = review.page.evaluate("hullformReview.tool.handles(hullformReview)[0].px")
    review.near(start, scale=1.0)
    review.drag(start, (start[0] + 6, start[1]))
    assert review.review["calibration"]["centreline_px"] == pytest.approx(before["centreline_px"] + 6, abs=HAND_PX)
    assert review.review["calibration"]["metres_per_px"] == pytest.approx(before["metres_per_px"], rel=1e-6)
    assert review.reading["calibration"]["centreline_px"] == review.review["calibration"]["centreline_px"]
    review.press("Control+z")
    assert "calibration" not in review.review
    assert review.reading["calibration"]["centreline_px"] == pytest.approx(before["centreline_px"])


def test_station_list_can_be_edited_and_a_wrong_one_keeps_the_former_view(review: ReviewPage) -> None:
    review.page.get_by_text("Edit the list").click()
    field = review.page.locator("[data-list=aft]")
    field.fill("2.5, 5, 10, 15, 20, 25, 30, 35, 40")
    review.page.locator("#apply-stations").click()
    review.settle()
    assert review.count("aft").endswith("of 9")
    field.fill("20, 10, 5")
    review.page.locator("#apply-stations").click()
    review.settle()
    notice = review.page.locator("#notice.bad")
    assert "list each half's stations from aft forward" in notice.inner_text()
    assert review.count("aft").endswith("of 9")
    review.press("Control+z", "Control+z")
    assert notice.is_hidden()
    assert review.count("aft") == "10 of 10"
    # the browser itself notes the refused call
    review.said.clear()


def test_stations_get_the_names_that_the_drawing_shows(review: ReviewPage) -> None:
    review.page.get_by_text("Edit the list").click()
    names = "½, 1, 2, 3, 4, 5, 6, 7, 8, 9"
    review.page.locator("[data-names=aft]").fill(names)
    review.page.locator("#apply-stations").click()
    review.settle()
    assert review.review["stations"]["aft_station_names"] == names.split(", ")
    assert review.station("aft", 2.5).locator(".name").inner_text().startswith("½")
    assert "½" in [curve["label"] for curve in review.reading["curves"]]
    # a station that is taken away takes its name along
    review.page.locator("[data-list=aft]").fill("2.5, 10, 15, 20, 25, 30, 35, 40, 45")
    review.page.locator("#apply-stations").click()
    review.settle()
    assert review.review["stations"]["aft_station_names"] == [name for name in names.split(", ") if name != "1"]
    assert review.count("aft").endswith("of 9")


def test_undo_and_redo_go_through_every_change(review: ReviewPage) -> None:
    places = [review.reading["curves"][n]["px"][50] for n in (3, 6, 12)]
    review.press("k", "0")
    for place in places:
        review.click(place)
    assert len(review.corrections) == 3
    review.press("Control+z", "Control+z")
    assert len(review.corrections) == 1
    review.press("Control+Shift+z")
    assert len(review.corrections) == 2
    expect(review.page.locator("#redo")).to_be_enabled()
    review.page.locator("#corrections-panel [data-correction]").first.click()
    review.press("Delete")
    assert len(review.corrections) == 1
    expect(review.page.locator("#redo")).to_be_disabled()


def test_keys_choose_tools_zoom_move_and_fit(review: ReviewPage) -> None:
    for button in review.page.locator("[data-tool]").all():
        key = button.get_attribute("aria-keyshortcuts")
        assert key is not None
        review.press(key.lower())
        assert review.page.locator("[data-tool][aria-pressed=true]").get_attribute("data-tool") == button.get_attribute(
            "data-tool"
        )
    fitted = review.at((1000, 700))
    review.press("+", "+", "ArrowLeft")
    assert review.at((1000, 700)) != pytest.approx(fitted, abs=5)
    review.press("0")
    assert review.at((1000, 700)) == pytest.approx(fitted, abs=0.01)
    review.choose_station("fore", 60.0)
    review.page.keyboard.press("ArrowDown")
    review.settle()
    assert review.station("fore", 65.0).get_attribute("aria-pressed") == "true"
    assert review.at((1000, 700)) == pytest.approx(fitted, abs=0.01)
    # what is typed into a field is no key of the picture's
    review.page.get_by_text("Edit the list").click()
    review.page.locator("[data-list=aft]").press("x")
    assert review.page.locator("[data-tool=calibrate]").get_attribute("aria-pressed") == "true"
