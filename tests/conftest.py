"""What several kinds of test share: the ships of bodyplans/, each run once, and browsers."""

from __future__ import annotations

import fcntl
import json
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Playwright, sync_playwright
from review_page import QUIET, find_chromium

ROOT = Path(__file__).parent.parent


@dataclass(frozen=True)
class FinishedRun:
    """A run by the command line: its exit code, its folder, its results.json."""

    code: int
    folder: Path
    results: dict[str, Any]


@pytest.fixture(scope="session")
def finished_run(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], FinishedRun]:
    """Runs a ship of bodyplans/ once, for all workers together, and hands out what it wrote."""
    base = tmp_path_factory.getbasetemp()
    shared = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "finished-runs"
    shared.mkdir(exist_ok=True)
    known: dict[str, FinishedRun] = {}

    def run(ship: str) -> FinishedRun:
        if ship not in known:
            folder, ended = shared / ship, shared / f"{ship}.exit-code"
            with (shared / f"{ship}.lock").open("w") as lock:
                fcntl.flock(lock, fcntl.LOCK_EX)
                if not ended.exists():
                    from hullform.cli import main

                    code = main(["run", str(ROOT / "bodyplans" / ship / "ship.toml"), "-o", str(folder), "--force"])
                    ended.write_text(str(code))
            results = json.loads((folder / "results.json").read_text(encoding="utf-8"))
            known[ship] = FinishedRun(int(ended.read_text()), folder, results)
        return known[ship]

    return run


@pytest.fixture(scope="session")
def driver() -> Iterator[Playwright]:
    """Drives browsers; its event loop allows no second one beside it in a worker."""
    with sync_playwright() as playwright:
        yield playwright


@pytest.fixture(scope="module")
def browser(driver: Playwright) -> Iterator[Browser]:
    """A Chromium that asks for nothing by itself."""
    browser = driver.chromium.launch(executable_path=find_chromium(), args=list(QUIET))
    yield browser
    browser.close()
