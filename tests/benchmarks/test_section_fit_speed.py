"""Fitting stays within ten milliseconds a station, so that a ship of forty is fitted in less than half a second."""

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from hullform.hull import SuperEllipse, fit_super_ellipse

pytestmark = pytest.mark.benchmarks


@pytest.mark.parametrize("points", [50, 200, 800])
def test_fit_of_one_station(benchmark: BenchmarkFixture, points: int) -> None:
    section = SuperEllipse(16.1, 19.5, 6.0, 2.5).points(points) * [1.0, -1.0] + [0.0, 19.5]
    fit = benchmark(fit_super_ellipse, section)
    assert fit.rms_m < 0.01
    if benchmark.enabled:
        # Twice the aim: the machine may be busy.
        assert benchmark.stats.stats.median < 0.02
