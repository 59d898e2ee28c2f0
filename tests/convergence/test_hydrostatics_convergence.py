"""The hull's integrals converge with the number of lofted stations, on Wigley's hull whose volume is 4/9 L B T."""

import numpy as np

from hullform.hull import Hull
from hullform.hull.drawn import station_places


def wigley(stations: int) -> Hull:
    x = station_places(100.0, stations)
    one = np.ones(stations)
    half_breadth = np.maximum(5.0 * (1 - (x / 50.0 - 1) ** 2), 0.0)
    return Hull.of_super_ellipses(
        x, half_breadth, 6.25 * one, 6.25 * one, one, 2 * one, 100.0, 100.0, 0.0, 10.0, 6.25, 6.25
    )


def test_volume_converges_at_third_order_or_better() -> None:
    exact = 4 / 9 * 100 * 10 * 6.25
    error = np.array([abs(wigley(n).volume_m3 / exact - 1) for n in (12, 24, 48, 96)])
    # A monotone cubic is of third order where it flattens the crest of the breadth.
    assert (np.log2(error[:-1] / error[1:]) > 2.8).all()
    assert error[-1] < 1e-6


def test_mesh_volume_converges_at_second_order() -> None:
    exact = 4 / 9 * 100 * 10 * 6.25
    counts = (12, 24, 48, 96)
    error = np.array([abs(float(wigley(n).mesh(n).volume) / exact - 1) for n in counts])
    # Flat facets in a curved surface: second order in both directions at once.
    assert (np.log2(error[:-1] / error[1:]) > 1.8).all()
    assert error[-1] < 1e-3
