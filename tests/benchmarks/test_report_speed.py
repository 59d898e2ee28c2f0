"""How long the report takes: figures, the view of the hull, the page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from hullform.pipeline import run_ship
from hullform.report.page import write_report
from hullform.ship import read_ship

pytestmark = pytest.mark.benchmarks

BODY_PLANS = Path(__file__).parents[2] / "bodyplans"


@pytest.mark.parametrize("folder", ["wigley", "ds-tanker", "scim-containership"])
def test_report_is_written(benchmark: Any, tmp_path: Path, folder: str) -> None:
    run = run_ship(read_ship(BODY_PLANS / folder / "ship.toml"))
    benchmark.pedantic(write_report, args=(run, tmp_path), rounds=3, warmup_rounds=1)
    assert (tmp_path / "report.html").exists()
