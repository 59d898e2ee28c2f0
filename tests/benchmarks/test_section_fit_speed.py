"""Fitting stays within ten milliseconds a station, so that a ship of forty is fitted in less than half a second."""

import time
from dataclasses import dataclass

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.hull import Hull, SuperEllipse, fit_super_ellipse

pytestmark = pytest.mark.benchmarks


@pytest.mark.parametrize("points", [50, 200, 800])
def test_fit_of_one_station(benchmark: BenchmarkFixture, points: int) -> None:
    section = SuperEllipse(16.1, 19.5, 6.0, 2.5).points(points) * [1.0, -1.0] + [0.0, 19.5]
    fit = benchmark(fit_super_ellipse, section)
    assert fit.rms_m < 0.01
    if benchmark.enabled:
        # Twice the aim: the machine may be busy.
        assert benchmark.stats.stats.median < 0.02


@dataclass(frozen=True)
class Particulars:
    length_overall_m: float = 100.0
    length_between_perpendiculars_m: float = 100.0
    aft_perpendicular_m: float = 0.0
    breadth_m: float = 16.0
    depth_m: float = 9.0
    draught_m: float = 6.0


def test_the_whole_ladder_against_its_first_rung(benchmark: BenchmarkFixture) -> None:
    # 25 stations that no model but the spline follows: every rung is tried at every one
    z = np.linspace(0.0, 9.0, 200)
    stations = []
    for number, x in enumerate(np.linspace(0.0, 100.0, 25)):
        y = 2.2 * np.sin(np.pi * z / 9.3) ** 2 + (3 + 0.1 * number) * (z / 9) ** 5
        stations.append(Station(float(x), "aft", (TracedCurve(y, z),)))
    plan = BodyPlan(tuple(stations), "offsets")
    start = time.process_time()
    Hull.from_body_plan(plan, Particulars(), sections="super-ellipse")
    one_each = time.process_time() - start
    hull = benchmark(Hull.from_body_plan, plan, Particulars())
    assert {fit.model.kind for fit in hull.fits if fit.model is not None} == {"spline"}
    if benchmark.enabled:
        # measured 3 to 4: five fits and their distances for one, and the loft
        assert benchmark.stats.stats.median < 8 * one_each
