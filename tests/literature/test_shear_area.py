"""Shear areas of closed shells against Cowper's box, the thin tube and the closed form for a rectangle."""

from __future__ import annotations

import numpy as np
import pytest

from hullform.loading.thin_walled import closed_shell, section_properties


def shear_area(half_breadth: np.ndarray, height: np.ndarray, thickness: float) -> np.ndarray:
    return section_properties(closed_shell(half_breadth, height, thickness)).shear_area_m2


def box(breadth: float, depth: float) -> tuple[np.ndarray, np.ndarray]:
    """One side of a rectangle: deck centre, deck corner, bilge corner, keel."""
    return np.array([0.0, breadth / 2, breadth / 2, 0.0]), np.array([depth, depth, 0.0, 0.0])


def cowper_coefficient(breadth: float, depth: float) -> float:
    """Cowper (1966), thin-walled box, Poisson's ratio 0, all walls of one thickness."""
    m, n = breadth / depth, breadth / depth
    return 10 * (1 + 3 * m) ** 2 / (12 + 72 * m + 150 * m**2 + 90 * m**3 + 30 * n**2 * (m + m**2))


@pytest.mark.parametrize(("breadth", "depth"), [(32.2, 19.5), (44.0, 21.5), (1.0, 1.0), (5.0, 20.0)])
def test_box_against_cowper(breadth: float, depth: float) -> None:
    area = 2 * (breadth + depth) * 0.016
    # both are exact for a thin wall; with Poisson's ratio 0 Cowper's coefficient is the energy's. The kernel's own
    # error is the share that ties the joints to the ground, 1e-13 of the stiffest.
    assert shear_area(*box(breadth, depth), 0.016) == pytest.approx(
        cowper_coefficient(breadth, depth) * area, rel=1e-11
    )


@pytest.mark.parametrize(("breadth", "depth"), [(32.2, 19.5), (44.0, 21.5)])
def test_box_by_hand(breadth: float, depth: float) -> None:
    # Q grows along the deck as t y D/2, to Q0 = t B D/4 at the corner, and down the side by t (D z'/2 - z'^2/2)
    t = 0.016
    q0 = t * breadth * depth / 4
    deck = (t * depth / 2) ** 2 * (breadth / 2) ** 3 / 3
    side = q0**2 * depth + q0 * t * depth**3 / 6 + t**2 * depth**5 / 120
    second_moment = t * breadth * depth**2 / 2 + t * depth**3 / 6
    by_hand = second_moment**2 / (2 * (2 * deck + side) / t)
    assert shear_area(*box(breadth, depth), t) == pytest.approx(by_hand, rel=1e-11)


def test_thin_tube_has_half_its_area() -> None:
    angle = np.linspace(0.0, np.pi, 1001)
    # a polygon of 2000 sides: relative error of the order of (pi / 1000)^2
    assert shear_area(3 * np.sin(angle), 3 * np.cos(angle), 0.01) == pytest.approx(np.pi * 3 * 0.01, rel=1e-5)


def test_points_along_a_straight_plate_change_nothing() -> None:
    y, z = box(10.0, 6.0)
    s = np.linspace(0.0, 3.0, 31)
    fine = shear_area(np.interp(s, range(4), y), np.interp(s, range(4), z), 0.02)
    assert fine == pytest.approx(shear_area(y, z, 0.02), rel=1e-11)


def test_sections_in_a_stack_and_a_vanished_one() -> None:
    stack = [np.stack(part) for part in zip(box(10.0, 6.0), box(4.0, 3.0), box(0.0, 0.0), strict=True)]
    areas = shear_area(*stack, 0.02)
    alone = [float(shear_area(*box(*size), 0.02)) for size in ((10.0, 6.0), (4.0, 3.0))]
    assert areas == pytest.approx([*alone, 0.0], rel=1e-14)
