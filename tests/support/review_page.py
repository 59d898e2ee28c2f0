"""The review page as a person uses it: a served ship, a browser, and hands that click at pixels of the picture."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, Page

from hullform.corrections import Correction, DeckEdge, Drawn, Ignored, Joined, MarkedStation, RunTogether

# A busy machine, a software renderer: long enough that only a page that never answers fails.
PATIENCE_MS = 60_000
KEYS = {
    "mark": "m",
    "delete": "x",
    "cut": "c",
    "join": "j",
    "cross": "o",
    "together": "t",
    "drawn": "d",
    "deck": "e",
    "knuckle": "k",
    "ignore": "i",
}
QUIET = (
    "--headless=new",
    "--no-sandbox",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
)

Place = tuple[float, float]
BODYPLANS = Path(__file__).parents[2] / "bodyplans"


def copied(ship: str, folder: Path) -> Path:
    """The ship.toml of a copy of a drawn ship."""
    shutil.copytree(BODYPLANS / ship, folder / ship, ignore=shutil.ignore_patterns("results"))
    return folder / ship / "ship.toml"


def find_chromium() -> str:
    """The path of a Chromium; without one the test is skipped, or fails where a browser is required."""
    for name in ("chromium", "chromium-browser", "google-chrome"):
        found = shutil.which(name)
        if found:
            return found
    if os.environ.get("HULLFORM_REQUIRE_BROWSER"):
        pytest.fail("HULLFORM_REQUIRE_BROWSER is set, but no chromium, chromium-browser or google-chrome is on PATH")
    pytest.skip("no chromium, chromium-browser or google-chrome on PATH")


@contextmanager
def served(ship: Path) -> Iterator[str]:
    """The address of a review that the command line prints, its token with it; it is ended as a person ends it."""
    command = [sys.executable, "-m", "hullform.cli", "review", str(ship), "--no-browser"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stderr is not None
    try:
        found = re.search(r"http://127\.0\.0\.1:\d+/\S+", process.stdout.readline())
        assert found is not None, process.stderr.read()
        yield found.group()
    finally:
        process.send_signal(signal.SIGINT)
        process.wait(timeout=20)
        process.stdout.close()
        process.stderr.close()


class ReviewPage:
    """Hands on an open review page. Places are pixels of the stored picture."""

    def __init__(self, page: Page, address: str) -> None:
        self.page = page
        self.said: list[str] = []
        page.set_default_timeout(PATIENCE_MS)
        page.on("console", lambda message: self.said.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: self.said.append(f"page error: {error}"))
        page.goto(address)
        self.settle()

    def settle(self) -> None:
        """Wait until the page shows what follows from the last change."""
        self.page.wait_for_selector("body[data-state=ready]")
        # what is drawn once a frame is drawn
        self.page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")

    @property
    def review(self) -> dict[str, Any]:
        """The review document as the page has it."""
        document: dict[str, Any] = self.page.evaluate("hullformReview.document")
        return document

    @property
    def corrections(self) -> list[dict[str, Any]]:
        """The list of corrections as the page has it."""
        return list(self.review.get("corrections", []))

    @property
    def reading(self) -> dict[str, Any]:
        """What the server last read."""
        reading: dict[str, Any] = self.page.evaluate("hullformReview.reading")
        return reading

    def row(self, half: str, station_m: float) -> dict[str, Any]:
        """What was read of a station."""
        (found,) = (one for one in self.reading["halves"] if one["half"] == half)
        return next(row for row in found["stations"] if abs(row["x_m"] - station_m) < 1e-3)

    def count(self, half: str) -> str:
        """'found of expected', as the page shows it."""
        return self.page.locator(f"[data-count={half}]").inner_text()

    def station(self, half: str, station_m: float) -> Locator:
        """The button of a station in the list."""
        return self.page.locator(f"[data-station='{half}:{station_m:.10g}']")

    def choose_station(self, half: str, station_m: float) -> None:
        """Select a station in the list, as a click on it does."""
        self.station(half, station_m).click()
        self.settle()

    def press(self, *keys: str) -> None:
        """Press keys, the picture having the focus."""
        self.page.locator("#stage").focus()
        for key in keys:
            self.page.keyboard.press(key)
        self.settle()

    def near(self, place: Place, scale: float = 1.5) -> None:
        """Zoom in by the wheel over a place until a pixel of the picture is at least one of the screen."""
        self.press("0")
        for _ in range(200):
            if self._scale() >= scale:
                break
            self.page.mouse.move(*self.at(place))
            self.page.mouse.wheel(0, -400)
            self.settle()
        self.into_sight(place)

    def into_sight(self, place: Place) -> None:
        """Drag the picture until a place is well inside the window."""
        box = self.page.locator("#stage").bounding_box()
        assert box is not None
        for _ in range(40):
            x, y = self.at(place)
            dx = min(max(x, box["x"] + 90), box["x"] + box["width"] - 90) - x
            dy = min(max(y, box["y"] + 90), box["y"] + box["height"] - 90) - y
            if abs(dx) < 1 and abs(dy) < 1:
                return
            middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
            step = [max(-0.4 * size, min(0.4 * size, way)) for size, way in ((box["width"], dx), (box["height"], dy))]
            self.page.mouse.move(*middle)
            self.page.mouse.down(button="middle")
            self.page.mouse.move(middle[0] + step[0], middle[1] + step[1], steps=3)
            self.page.mouse.up(button="middle")
            self.settle()

    def at(self, place: Place) -> Place:
        """Where a pixel of the picture lies in the browser's window."""
        x, y = self.page.evaluate(
            "p => { const b = document.getElementById('stage').getBoundingClientRect();"
            " const [x, y] = hullformReview.viewport.toScreen(p); return [b.left + x, b.top + y]; }",
            list(place),
        )
        return x, y

    def click(self, place: Place) -> None:
        """Click at a pixel of the picture that is in sight."""
        self.page.mouse.click(*self.at(place))
        self.settle()

    def drag(self, start: Place, end: Place) -> None:
        """Drag with the left button from one pixel of the picture to another."""
        self.page.mouse.move(*self.at(start))
        self.page.mouse.down()
        self.page.mouse.move(*self.at(((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)), steps=3)
        self.page.mouse.move(*self.at(end), steps=3)
        self.page.mouse.up()
        self.settle()

    def snap(self, wanted: bool) -> None:
        """Let clicks go to the nearest line, or stay where they are."""
        toggle = self.page.locator("[data-toggle=snap]")
        if (toggle.get_attribute("aria-pressed") == "true") != wanted:
            toggle.click()
            self.settle()

    def correct(self, corrections: Sequence[Correction]) -> None:
        """Make corrections by the page's own tools, zoomed in so far that the mouse can hit a pixel."""
        for correction in corrections:
            self._correct(correction)

    def _correct(self, correction: Correction) -> None:
        before = len(self.corrections)
        if isinstance(correction, MarkedStation | Drawn):
            self.press("v")
            self.choose_station(correction.half, correction.station_m)
        self.press(KEYS[correction.kind])
        if isinstance(correction, Drawn):
            second = self.page.evaluate("hullformReview.secondContour")
            if second != (correction.curve == 1):
                self.press("2")
            if self.page.evaluate("hullformReview.tool.smooth") != correction.smooth:
                self.press("l")
        lined = isinstance(correction, Drawn | DeckEdge | Ignored)
        places = correction.px if lined or isinstance(correction, Joined | RunTogether) else (correction.px,)
        self.near(places[0])
        for place in places:
            self.into_sight(place)
            self.page.mouse.click(*self.at(place))
        self.settle()
        if lined:
            self.press("Enter")
        assert len(self.corrections) >= before, self.page.locator("#hint").inner_text()

    def save(self) -> dict[str, Any]:
        """Save, and what the file then holds."""
        self.press("s")
        self.page.wait_for_selector("#notice.good:not([hidden])")
        path = Path(self.page.locator("#notice code").first.inner_text())
        document: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        return document

    def _scale(self) -> float:
        scale: float = self.page.evaluate("hullformReview.viewport.scale")
        return scale
