"""The review page on a picture of 20 megapixels: a new reading after a change, a frame while panning and zooming."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import cv2
import pytest
from playwright.sync_api import Playwright
from pytest_benchmark.fixture import BenchmarkFixture
from review_page import QUIET, ReviewPage, find_chromium, served

from hullform.review.desk import Desk
from hullform.ship import read_ship

pytestmark = [pytest.mark.benchmarks, pytest.mark.browser]

CONTAINERSHIP = Path(__file__).parents[2] / "bodyplans" / "scim-containership"
WIDTH_PX = 5216  # of 20 Mpx at this picture's shape
FRAMES = 40
# Moves or zooms a frame at a time and returns the times between frames, ms.
MOVING = """
([frames, zooming]) => new Promise(done => {
  const view = hullformReview.viewport;
  const times = [];
  const step = now => {
    times.push(now);
    if (times.length > frames) {
      done(times.slice(1).map((time, n) => time - times[n]));
      return;
    }
    const turn = 2 * Math.PI * times.length / frames;
    if (zooming) view.zoomAt(Math.exp(0.06 * Math.cos(turn)));
    else view.panBy(12 * Math.cos(turn), 12 * Math.sin(turn));
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
})
"""


@pytest.fixture(scope="module")
def large(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("large") / "ship"
    shutil.copytree(CONTAINERSHIP, folder, ignore=shutil.ignore_patterns("results"))
    image = cv2.imread(str(folder / "bodyplan.png"))
    assert image is not None
    height = round(WIDTH_PX * image.shape[0] / image.shape[1])
    cv2.imwrite(str(folder / "bodyplan.png"), cv2.resize(image, (WIDTH_PX, height), interpolation=cv2.INTER_CUBIC))
    return folder / "ship.toml"


@pytest.fixture(scope="module")
def review(large: Path, driver: Playwright) -> Iterator[ReviewPage]:
    browser = driver.chromium.launch(executable_path=find_chromium(), args=list(QUIET))
    with served(large) as address:
        yield ReviewPage(browser.new_page(viewport={"width": 1440, "height": 900}), address)
    browser.close()


@pytest.mark.parametrize("picture", ["2.9 Mpx", "20 Mpx"])
def test_new_reading(benchmark: BenchmarkFixture, picture: str, request: pytest.FixtureRequest) -> None:
    path = CONTAINERSHIP / "ship.toml" if picture == "2.9 Mpx" else request.getfixturevalue("large")
    desk = Desk(read_ship(path))
    document = desk.opening()["review"]
    assert benchmark(desk.solve, document)["curves"]


@pytest.mark.parametrize("zooming", [False, True], ids=["panning", "zooming"])
def test_forty_frames(benchmark: BenchmarkFixture, review: ReviewPage, zooming: bool) -> None:
    times = benchmark.pedantic(review.page.evaluate, (MOVING, [FRAMES, zooming]), rounds=3)
    times.sort()
    benchmark.extra_info["median_frame_ms"] = times[len(times) // 2]
    benchmark.extra_info["slow_frame_ms"] = times[int(0.95 * len(times))]
    print(f"median {times[len(times) // 2]:.1f} ms a frame, 95 % within {times[int(0.95 * len(times))]:.1f} ms")
    assert len(times) == FRAMES
