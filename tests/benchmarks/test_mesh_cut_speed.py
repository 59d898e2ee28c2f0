"""A hundred cuts of a hull's mesh into chains, against trimesh's, which gives loose segments."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh
from pytest_benchmark.fixture import BenchmarkFixture

from hullform.doors.cutting import cut
from hullform.doors.surface import Surface
from hullform.hull import Hull

pytestmark = pytest.mark.benchmarks
PLACES = np.linspace(1.0, 99.0, 100)
POINTS = [13, 49, 193]  # a side of each of a hundred sections: 5 to 77 thousand triangles


def mesh(points: int) -> trimesh.Trimesh:
    s = np.linspace(-1.0, 1.0, 100)
    one = np.ones(100)
    hull = Hull.of_super_ellipses(
        50 * (1 + s), 8 * (1 - s**4), 9 * one, 9 * one, 1 + 8 * (1 - s**2), 1 + 6 * (1 - s**2),
        100.0, 100.0, 0.0, 16.0, 9.0, 6.0,
    )  # fmt: skip
    return hull.mesh(points)


@pytest.mark.parametrize("points", POINTS)
def test_chains_of_a_hundred_cuts(benchmark: BenchmarkFixture, points: int) -> None:
    of = mesh(points)
    surface = Surface(np.asarray(of.vertices), np.asarray(of.faces))
    chains = benchmark(lambda: [cut(surface, float(x)) for x in PLACES])
    assert all(len(found) == 1 for found in chains)


@pytest.mark.parametrize("points", POINTS)
def test_peer_loose_segments_of_a_hundred_cuts(benchmark: BenchmarkFixture, points: int) -> None:
    of = mesh(points)
    lines, _, _ = benchmark(trimesh.intersections.mesh_multiplane, of, [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], PLACES)
    assert len(lines) == len(PLACES)
