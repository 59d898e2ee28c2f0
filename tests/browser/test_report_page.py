"""report.html in a Chromium with software graphics: whole, silent, offline, with the hull to turn."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread
from playwright.sync_api import Browser, Page, Playwright
from review_page import QUIET, find_chromium

from hullform.pipeline import run_ship
from hullform.report.page import write_report
from hullform.ship import read_ship

pytestmark = pytest.mark.browser

Launch = Callable[[tuple[str, ...]], Browser]

SHIP = Path(__file__).parents[2] / "bodyplans" / "scim-containership" / "ship.toml"
SOFTWARE_GL = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
NO_GL = ("--disable-gpu", "--disable-3d-apis", "--disable-webgl", "--disable-webgl2")
OFFLINE = ("file:", "data:", "blob:", "about:")
# A software renderer on a busy machine: long enough that only a viewer that never comes up fails.
PATIENCE_MS = 60_000


@dataclass
class Visit:
    """An open report and everything that the browser said of it."""

    page: Page
    said: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)

    def outside(self) -> list[str]:
        """Requests that leave the machine."""
        return [address for address in self.asked if not address.startswith(OFFLINE)]


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("report")
    write_report(run_ship(read_ship(SHIP)), folder)
    return folder / "report.html"


@pytest.fixture(scope="module")
def launch(driver: Playwright) -> Launch:
    chromium = find_chromium()
    return lambda arguments: driver.chromium.launch(executable_path=chromium, args=[*QUIET, *arguments])


def _visit(browser: Browser, report: Path) -> Iterator[Visit]:
    page = browser.new_page(viewport={"width": 1366, "height": 768})
    visit = Visit(page)
    page.on("console", lambda message: visit.said.append(f"{message.type}: {message.text}"))
    page.on("pageerror", lambda error: visit.said.append(f"page error: {error}"))
    page.on("request", lambda request: visit.asked.append(request.url))
    page.goto(report.as_uri())
    yield visit
    browser.close()


@pytest.fixture(scope="module")
def visit(launch: Launch, report: Path) -> Iterator[Visit]:
    yield from _visit(launch(SOFTWARE_GL), report)


@pytest.fixture(scope="module")
def visit_without_webgl(launch: Launch, report: Path) -> Iterator[Visit]:
    yield from _visit(launch(NO_GL), report)


def _errors(visit: Visit) -> list[str]:
    return [said for said in visit.said if said.startswith(("error", "page error"))]


def _picture(visit: Visit, selector: str) -> np.ndarray:
    shot = visit.page.locator(selector).screenshot()
    return np.asarray(imread(io.BytesIO(shot))[..., :3], dtype=np.float64)


def test_first_screen_has_ship_conditions_frequencies_and_scope(visit: Visit) -> None:
    visit.page.evaluate("window.scrollTo(0, 0)")
    for text in (
        "SCIM containership",
        "hull girder with shear deflection, in water",
        "cycles/min",
        "2 nodes",
        "wet over dry",
    ):
        box = visit.page.get_by_text(text).first.bounding_box()
        assert box is not None
        assert box["y"] + box["height"] <= 768
    # nothing runs out of the window sideways
    assert visit.page.evaluate("document.documentElement.scrollWidth") <= 1366


def test_hull_is_drawn_and_turns_with_the_mouse(visit: Visit) -> None:
    assert visit.page.locator("#hull-view iframe").count() == 0, "the view loads only when it is near the window"
    visit.page.locator("#hull").scroll_into_view_if_needed()
    visit.page.wait_for_selector("#hull-view iframe", timeout=PATIENCE_MS)
    frame = visit.page.frame_locator("#hull-view iframe")
    frame.locator("html[data-ready=yes] canvas").wait_for(timeout=PATIENCE_MS)
    assert not visit.page.locator("#hull-view img").is_visible()
    before = _picture(visit, "#hull-view")
    # red bottom, blue sides and grey deck on a light ground: a blank canvas has one colour, a black one no ground
    assert np.ptp(before, axis=(0, 1)).min() > 0.4
    red, blue = before[..., 0] - before[..., 2], before[..., 2] - before[..., 0]
    assert (red > 0.2).mean() > 0.01
    assert (blue > 0.1).mean() > 0.01
    box = visit.page.locator("#hull-view").bounding_box()
    assert box is not None
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    visit.page.mouse.move(*middle)
    visit.page.mouse.down()
    visit.page.mouse.move(middle[0] + 120, middle[1], steps=6)
    visit.page.mouse.up()
    visit.page.wait_for_timeout(500)
    after = _picture(visit, "#hull-view")
    assert (np.abs(after - before).max(axis=2) > 0.1).mean() > 0.01


def test_page_is_silent_and_offline(visit: Visit) -> None:
    height = visit.page.evaluate("document.documentElement.scrollHeight")
    for position in range(0, height, 2000):
        visit.page.evaluate(f"window.scrollTo({{top: {position}, behavior: 'instant'}})")
    visit.page.wait_for_timeout(500)
    assert _errors(visit) == []
    assert visit.outside() == []


def test_every_picture_has_a_size(visit: Visit) -> None:
    sizes = visit.page.eval_on_selector_all(
        "figure > svg, figure > img",
        "all => all.map(one => { const r = one.getBoundingClientRect(); return r.height })",
    )
    # seventeen of the ship, a resonance diagram and a forced response for each of three conditions, springing
    assert len(sizes) == 17 + 2 * 3 + 1
    # a picture that failed to load or lost its proportions has no height, or next to none
    assert min(sizes) > 150


def test_still_picture_stays_where_webgl_is_missing(visit_without_webgl: Visit) -> None:
    page = visit_without_webgl.page
    page.locator("#hull").scroll_into_view_if_needed()
    page.get_by_text("this browser has no WebGL").wait_for(timeout=PATIENCE_MS)
    still = page.locator("#hull-view img")
    assert still.is_visible()
    assert still.evaluate("image => image.naturalWidth") > 1000
    assert page.locator("#hull-view iframe").count() == 0
    assert np.ptp(_picture(visit_without_webgl, "#hull-view"), axis=(0, 1)).min() > 0.4
    assert _errors(visit_without_webgl) == []
    assert visit_without_webgl.outside() == []
