"""Section kernels, hydrostatics and mesh, against the floor of two exponentials a node of the quadrature."""

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from hullform.hull import Hull, shell_section

pytestmark = pytest.mark.benchmarks


def hull(stations: int) -> Hull:
    s = np.linspace(-1.0, 1.0, stations)
    one = np.ones(stations)
    return Hull.of_super_ellipses(
        50 * (1 + s), 8 * (1 - s**4), 9 * one, 9 * one, 1 + 8 * (1 - s**2), 1 + 6 * (1 - s**2),
        100.0, 100.0, 0.0, 16.0, 9.0, 6.0,
    )  # fmt: skip


@pytest.mark.parametrize("sections", [100, 3_000, 30_000])
def test_shell_of_many_sections(benchmark: BenchmarkFixture, sections: int) -> None:
    rng = np.random.default_rng(0)
    a, b = rng.uniform(1.0, 20.0, (2, sections))
    p, q = np.exp(rng.uniform(np.log(0.3), np.log(40.0), (2, sections)))
    shell = benchmark(shell_section, a, b, p, q, 0.016)
    assert np.isfinite(shell.second_moment).all()


@pytest.mark.parametrize("sections", [100, 3_000, 30_000])
def test_floor_two_exponentials_a_node(benchmark: BenchmarkFixture, sections: int) -> None:
    node = np.linspace(0.7, 36.0, 112)
    p = np.linspace(0.3, 40.0, sections)[:, None]

    def floor() -> float:
        return float(sum(np.exp(node / -p).sum() for _ in range(4)))

    assert benchmark(floor) > 0


@pytest.mark.parametrize("stations", [25, 100, 400])
def test_hydrostatics_at_one_draught(benchmark: BenchmarkFixture, stations: int) -> None:
    assert benchmark(hull(stations).hydrostatics, 6.0).volume_m3 > 0


@pytest.mark.parametrize("stations", [25, 100, 400])
def test_mesh(benchmark: BenchmarkFixture, stations: int) -> None:
    assert benchmark(hull(stations).mesh).is_watertight
