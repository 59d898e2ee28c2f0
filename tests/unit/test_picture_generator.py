"""The picture generator: the same picture every time, and ink where its truth says."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from generator.families import FAMILIES
from generator.pictures import DrawnPicture, Recipe, make
from generator.scoring import score_stations

from hullform.body_plan import Station, TracedCurve


def stations_of(picture: DrawnPicture, scale: float = 1.0) -> list[Station]:
    """The truth as if it had been traced, half-breadths times a factor."""
    return [
        Station(s.x_m, s.half, tuple(TracedCurve(scale * c[:, 0], c[:, 1]) for c in s.curves_m))
        for s in picture.stations
    ]


def test_a_recipe_gives_the_same_picture_every_time() -> None:
    recipe = Recipe("frigate", "poor", 1200, 5)
    first, second = make(recipe), make(recipe)
    assert np.array_equal(first.image, second.image)
    assert not np.array_equal(first.image, make(Recipe("frigate", "poor", 1200, 6)).image)


@pytest.mark.parametrize("family", FAMILIES)
def test_sections_start_at_the_keel_and_stay_inside_the_breadth(family: str) -> None:
    for seed in range(3):
        hull = FAMILIES[family](np.random.default_rng(seed))
        main = hull.dimensions
        for x in np.linspace(0.05, 0.95, 7) * main.length_m:
            curves = hull.section(float(x))
            points = np.vstack(curves)
            assert curves[0][0, 0] == 0.0
            assert points[:, 0].min() >= 0.0
            assert points[:, 0].max() <= 0.5 * main.breadth_m * (1 + 1e-9)
            assert curves[-1][-1, 1] == pytest.approx(hull.sheer(float(x)))


@pytest.mark.parametrize("level", ["clean", "warp", "photo"])
def test_lines_lie_where_the_truth_says(level: str) -> None:
    picture = make(Recipe("container", level, 2000, 11))
    grey = picture.image if picture.image.ndim == 2 else picture.image.min(axis=2)
    curves = [c for s in picture.stations if s.drawn_as == s.name for c in s.curves_px]
    reach = np.arange(-6.0, 6.01, 0.25)
    offsets = []
    for number, curve in enumerate(curves):
        others = np.vstack([c for k, c in enumerate(curves) if k != number])
        along = np.gradient(curve, axis=0)
        across = np.column_stack([-along[:, 1], along[:, 0]]) / np.hypot(*along.T)[:, None]
        for place in range(20, len(curve) - 20, 15):
            if np.hypot(*(others - curve[place]).T).min() < 14:
                continue
            u, v = (curve[place] + reach[:, None] * across[place]).T.astype(np.float32)
            seen = cv2.remap(grey, u[None], v[None], cv2.INTER_LINEAR)[0].astype(float)
            ink = np.clip(np.median(seen[[0, 1, 2, -3, -2, -1]]) - seen, 0.0, None)
            if ink.max() > 60 and max(ink[:4].max(), ink[-4:].max()) < 25:  # a line alone, no crossing
                offsets.append(reach @ ink / ink.sum())
    assert len(offsets) > 100
    # 8-bit greys, noise of 2.5 of them and coordinates of cv2.remap to 1/32 px leave a few hundredths in a single place
    assert abs(np.median(offsets)) < 0.02
    assert np.percentile(np.abs(offsets), 80) < 0.1


def test_the_score_of_the_truth_itself_and_of_wrong_readings() -> None:
    picture = make(Recipe("bulb", "clean", 1200, 3))
    for score in score_stations(picture, stations_of(picture)):
        assert score.right
        assert score.rms_percent == pytest.approx(0.0, abs=0.02)  # points between those of the polyline
        assert score.area_percent == pytest.approx(0.0, abs=0.02)
    assert not any(score.found for score in score_stations(picture, stations_of(picture, 1.2)) if score.half == "fore")
    assert not any(score.right for score in score_stations(picture, []))
