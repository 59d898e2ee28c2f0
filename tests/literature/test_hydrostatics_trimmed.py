"""A hull below a waterline that is not level, and Bonjean curves, against closed forms and against quadrature.

A box barge L x B at mean draught T and trim t, nowhere above her deck or below her keel, has the volume L B T, its
centre L t / (12 T) abaft midships and T/2 + t^2 / (24 T) above the base line: the moments of a trapezium (Archimedes;
Biran & Lopez-Pulido, Ship Hydrostatics and Stability, 2014, ch. 2). Wigley's hull is integrated by its formula.
"""

from __future__ import annotations

import numpy as np
import pytest

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.hull import Hull
from hullform.hull.drawn import station_places

L, B, T, DEPTH = 100.0, 16.0, 4.0, 9.0


class Main:
    length_overall_m = length_between_perpendiculars_m = L
    aft_perpendicular_m = 0.0
    breadth_m, depth_m, draught_m = B, DEPTH, T


def barge() -> Hull:
    box = TracedCurve(np.array([0.0, B / 2, B / 2]), np.array([0.0, 0.0, DEPTH]))
    return Hull.from_body_plan(BodyPlan(tuple(Station(x, "aft", (box,)) for x in (0.0, 40.0, L)), "offsets"), Main())


@pytest.mark.parametrize("trim", [0.0, 1.5, -3.0, 7.0])
def test_a_trimmed_barge(trim: float) -> None:
    found, close = barge().hydrostatics(T, trim_m=trim), {"rel": 1e-10}
    assert found.trim_m == trim
    assert found.volume_m3 == pytest.approx(L * B * T, **close)
    assert found.lcb_from_midships_m == pytest.approx(-L * trim / (12 * T), **close, abs=1e-9)
    assert found.kb_m == pytest.approx(T / 2 + trim**2 / (24 * T), **close)
    assert found.waterplane_area_m2 == pytest.approx(L * B, **close)
    assert found.lcf_x_m == pytest.approx(L / 2, **close)
    assert found.bm_longitudinal_m == pytest.approx(L**2 / (12 * T), **close)
    sides = 2 * L * T
    assert found.wetted_surface_m2 == pytest.approx(L * B + sides, **close)


def wigley() -> Hull:
    x = station_places(L, 100)
    one = np.ones(100)
    a = np.maximum(5 * (1 - (2 * x / L - 1) ** 2), 0.0)
    return Hull.of_super_ellipses(x, a, 6.25 * one, 6.25 * one, one, 2 * one, L, L, 0.0, 10.0, 6.25, 5.0)


def test_a_trimmed_wigley_hull_by_quadrature_of_the_formula() -> None:
    draught, trim = 4.5, 1.2
    node, weight = np.polynomial.legendre.leggauss(40)
    x = L * (node + 1) / 2
    height = draught - trim * (x / L - 0.5)
    # below a height h: 2 a Int (1 - v^2) d zeta from zeta0 = D - h to D, with v = zeta / D
    v = (6.25 - height) / 6.25
    area = 2 * 5 * (1 - (2 * x / L - 1) ** 2) * 6.25 * (2 / 3 - v + v**3 / 3)
    volume = float(weight @ area) * L / 2
    found = wigley().hydrostatics(draught, trim_m=trim)
    assert found.volume_m3 == pytest.approx(volume, rel=1e-5)
    assert found.lcb_x_m == pytest.approx(float(weight @ (area * x)) * L / 2 / volume, rel=1e-5)


def test_the_centre_of_buoyancy_agrees_with_the_floating_position() -> None:
    hull = wigley()
    position = hull.floating_at(hull.waterline(5.0, 4.0))
    found = hull.hydrostatics(4.5, trim_m=1.0)
    assert found.volume_m3 == pytest.approx(position.volume_m3, rel=1e-12)
    assert found.lcb_x_m == pytest.approx(position.lcb_x_m, rel=1e-12)


@pytest.mark.parametrize("heights", [[1.0, 3.0, 6.25]])
def test_bonjean_curves_of_wigley(heights: list[float]) -> None:
    found = wigley().bonjean_curves(heights, [20.0, 50.0])
    z = np.array(heights)
    v = 1 - z / 6.25
    shape = 6.25 * (2 / 3 - v + v**3 / 3)
    # about the base line: zeta = D - z, and Int zeta (1 - v^2) d zeta = D^2 (1/4 - v^2/2 + v^4/4)
    lever = 6.25 * shape - 6.25**2 * (1 / 4 - v**2 / 2 + v**4 / 4)
    for row, x in enumerate([20.0, 50.0]):
        breadth = 10 * (1 - (2 * x / L - 1) ** 2)
        # between stations 1.4 m apart the monotone cubic is low at the crest of the breadth
        np.testing.assert_allclose(found.area_m2[row], breadth * shape, rtol=3e-4)
        np.testing.assert_allclose(found.moment_m3[row], breadth * lever, rtol=3e-4)


def test_bonjean_curves_of_a_barge_are_lines_and_parabolas() -> None:
    found = barge().bonjean_curves([0.0, 2.0, 9.0, 12.0])
    held = np.minimum(found.height_m, DEPTH)
    np.testing.assert_allclose(found.area_m2, np.broadcast_to(B * held, found.area_m2.shape), rtol=1e-12)
    np.testing.assert_allclose(found.moment_m3, np.broadcast_to(B * held**2 / 2, found.area_m2.shape), rtol=1e-12)
