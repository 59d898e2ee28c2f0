"""A sample of the generated pictures is read as well as docs/reading-accuracy.md says."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from accuracy import SAMPLE_ROW, Result, measure
from generator.levels import LEVELS
from generator.suite import TEST_SEED, WIDTHS_PX, sample, suite

PAGE = Path(__file__).parents[2] / "docs" / "reading-accuracy.md"


@pytest.fixture(scope="module")
def results() -> list[Result]:
    return [measure(recipe) for recipe in sample(suite(TEST_SEED))]


@pytest.fixture(scope="module")
def committed() -> list[str]:
    """The cells of the sample's row in the committed table."""
    (row,) = [line for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith(f"| {SAMPLE_ROW} ")]
    return [cell.strip() for cell in row.strip("|").split("|")]


def test_the_sample_has_every_level_and_width() -> None:
    recipes = sample(suite(TEST_SEED))
    assert len(set(recipes)) == 24
    assert {recipe.level for recipe in recipes} == set(LEVELS)
    assert {recipe.width_px for recipe in recipes} == set(WIDTHS_PX)


def test_stations_are_right_as_often_as_the_table_says(results: list[Result], committed: list[str]) -> None:
    right = [score.right for result in results for score in result.scores]
    assert len(right) == int(committed[2])
    # The pictures are those of the table. Another build of OpenCV or HiGHS may decide a station that hangs by a hair
    # otherwise: three standard deviations of so many independent stations.
    share = float(committed[3]) / 100
    assert np.mean(right) >= share - 3 * np.sqrt(share * (1 - share) / len(right))


def test_right_stations_lie_as_near_as_the_table_says(results: list[Result], committed: list[str]) -> None:
    rms = [s.rms_percent for r in results for s in r.scores if s.rms_percent is not None]
    # The median of 500 values, spread by a factor of four, is known to a tenth; the 90th percentile to a quarter.
    assert np.median(rms) <= 1.1 * float(committed[6]) + 0.001
    assert np.percentile(rms, 90) <= 1.25 * float(committed[7])


def test_pictures_are_refused_no_oftener_than_the_table_says(results: list[Result], committed: list[str]) -> None:
    assert sum(bool(result.refusal) for result in results) <= int(committed[10])
