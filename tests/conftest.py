"""What several kinds of test share: the ships of bodyplans/, each run once a worker, and the driver of browsers."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Playwright, sync_playwright

ROOT = Path(__file__).parent.parent


@dataclass(frozen=True)
class FinishedRun:
    """A run by the command line: its exit code, its folder, its results.json."""

    code: int
    folder: Path
    results: dict[str, Any]


@pytest.fixture(scope="session")
def finished_run(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], FinishedRun]:
    """Runs a ship of bodyplans/ once and hands out what it wrote."""
    known: dict[str, FinishedRun] = {}

    def run(ship: str) -> FinishedRun:
        if ship not in known:
            from hullform.cli import main

            folder = tmp_path_factory.mktemp("runs") / ship
            code = main(["run", str(ROOT / "bodyplans" / ship / "ship.toml"), "-o", str(folder)])
            results = json.loads((folder / "results.json").read_text(encoding="utf-8"))
            known[ship] = FinishedRun(code, folder, results)
        return known[ship]

    return run


@pytest.fixture(scope="session")
def driver() -> Iterator[Playwright]:
    """Drives browsers; its event loop allows no second one beside it in a worker."""
    with sync_playwright() as playwright:
        yield playwright
