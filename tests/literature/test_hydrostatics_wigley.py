"""Wigley's hull, y = (B/2) (1 - (2x/L - 1)^2) (1 - (zeta/T)^2), whose hydrostatics are elementary integrals.

Each section is the super-ellipse p = 1, q = 2. Volume 4/9 L B T, KB = 5/8 T, waterplane 2/3 L B, second moments
4 L B^3 / 105 transverse (2/3 (B/2)^3 L 16/35) and L^3 B / 30 longitudinal.
"""

import numpy as np
import pytest

from hullform.hull import Hull
from hullform.hull.drawn import station_places

L, B, T = 100.0, 10.0, 6.25
VOLUME = 4 / 9 * L * B * T


def wigley(stations: int = 100) -> Hull:
    x = station_places(L, stations)
    half_breadth = np.maximum(B / 2 * (1 - (2 * x / L - 1) ** 2), 0.0)
    one = np.ones(stations)
    return Hull.of_super_ellipses(x, half_breadth, T * one, T * one, one, 2 * one, L, L, 0.0, B, T, T)


def test_hydrostatics_at_the_design_draught() -> None:
    found = wigley().hydrostatics(T)
    # Sections are exact; along the ship the monotone cubic through a hundred stations follows the parabola but for the
    # interval at its crest, (L/100)^3 of the whole.
    close = {"rel": 1e-5}
    assert found.volume_m3 == pytest.approx(VOLUME, **close)
    assert found.displacement_kg == pytest.approx(1025.0 * VOLUME, **close)
    assert found.kb_m == pytest.approx(5 / 8 * T, **close)
    assert found.lcb_x_m == pytest.approx(L / 2, **close)
    assert found.lcb_from_midships_m == pytest.approx(0.0, abs=1e-9)
    assert found.lcf_x_m == pytest.approx(L / 2, **close)
    assert found.waterplane_area_m2 == pytest.approx(2 / 3 * L * B, **close)
    assert found.bm_transverse_m == pytest.approx(4 * L * B**3 / 105 / VOLUME, **close)
    assert found.bm_longitudinal_m == pytest.approx(L**3 * B / 30 / VOLUME, **close)
    assert found.block_coefficient == pytest.approx(4 / 9, **close)
    assert found.waterplane_coefficient == pytest.approx(2 / 3, **close)
    # Amidships is a crest of the breadth, between two stations 1.4 m apart: low by (0.7/50)^2.
    assert found.midship_coefficient == pytest.approx(2 / 3, rel=3e-4)
    assert found.prismatic_coefficient == pytest.approx(2 / 3, rel=3e-4)


def test_half_draught_from_the_same_integral() -> None:
    # Below zeta = T/2: Int_{1/2}^{1} (1 - v^2) dv = 5/24 of the 2/3 of the whole.
    found = wigley().hydrostatics(T / 2)
    assert found.volume_m3 == pytest.approx(VOLUME * (5 / 24) / (2 / 3), rel=1e-5)
    assert found.waterplane_area_m2 == pytest.approx(2 / 3 * L * B * 3 / 4, rel=1e-5)


def test_wetted_surface_against_quadrature_of_the_formula() -> None:
    node, weight = np.polynomial.legendre.leggauss(60)
    s, v = (node + 1) / 2, (node + 1) / 2
    x_slope = -2 * B / L * s[:, None] * (1 - v**2)
    z_slope = -B / T * (1 - s[:, None] ** 2) * v
    # A quarter of the surface; s = |2x/L - 1|, v = zeta/T.
    quarter = weight / 2 @ np.sqrt(1 + x_slope**2 + z_slope**2) @ (weight / 2) * (L / 2) * T
    # Facets on 100 x 41 points lie within the surface: short by the square of their size.
    assert wigley().hydrostatics(T).wetted_surface_m2 == pytest.approx(4 * quarter, rel=5e-4)


def test_draught_is_found_from_the_mass() -> None:
    hull = wigley()
    for draught in (1.0, 3.125, 6.2):
        mass = hull.hydrostatics(draught).displacement_kg
        assert hull.draught_for(mass) == pytest.approx(draught, rel=1e-9)
    assert hull.draught_for(1000.0 * VOLUME / 2, density=1000.0) == pytest.approx(
        hull.draught_for(1025.0 * VOLUME / 2), rel=1e-9
    )
