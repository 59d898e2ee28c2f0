"""Shell second moments of the two ships with p = q, and the hollow rectangle that the sections tend to.

Breadth x depth 32.2 x 19.5 m (containership) and 44 x 21.5 m (tanker), closed shell of 16 mm with a deck plate. The
table was made by adaptive quadrature; the limit is elementary: a thin box has B t D^2 / 2 + t D^3 / 6.
"""

import pytest

from hullform.hull import SuperEllipse

EXPONENTS = (2, 3, 4, 6, 8, 10, 15, 20, 40, 100)
PRINTED = {
    (32.2, 19.5): (80.07, 92.68, 99.33, 105.94, 109.14, 111.00, 113.39, 114.53, 116.18, 117.12),
    (44.0, 21.5): (128.59, 149.45, 160.26, 170.87, 175.95, 178.88, 182.60, 184.37, 186.88, 188.31),
}
CASES = [(ship, p, value) for ship, values in PRINTED.items() for p, value in zip(EXPONENTS, values, strict=True)]


@pytest.mark.parametrize(("ship", "p", "printed"), CASES)
def test_shell_second_moment_to_its_printed_digits(ship: tuple[float, float], p: int, printed: float) -> None:
    breadth, depth = ship
    # The table was rounded to three decimals and then to two (186.8851 stands as 186.88): half a unit of each.
    assert SuperEllipse(breadth / 2, depth, p, p).shell_second_moment(0.016) == pytest.approx(printed, abs=0.0055)


@pytest.mark.parametrize(("breadth", "depth", "printed"), [(32.2, 19.5, 117.725), (44.0, 21.5, 189.214)])
def test_sharp_sections_tend_to_the_thin_box(breadth: float, depth: float, printed: float) -> None:
    thickness = 0.016
    box = breadth * thickness * depth**2 / 2 + thickness * depth**3 / 6
    assert box == pytest.approx(printed, abs=0.0005)
    gap = [1 - SuperEllipse(breadth / 2, depth, p, p).shell_second_moment(thickness) / box for p in (1e3, 1e4)]
    # The corner that is missing shrinks as 1 / p.
    assert 0 < gap[1] < gap[0] < 1e-3
    assert gap[1] == pytest.approx(gap[0] / 10, rel=0.05)


@pytest.mark.parametrize(("breadth", "depth", "hollow"), [(32.2, 19.5, 117.468), (44.0, 21.5, 188.854)])
def test_mid_line_shell_exceeds_the_hollow_rectangle_by_two_per_mille(
    breadth: float, depth: float, hollow: float
) -> None:
    t = 0.016
    assert (breadth * depth**3 - (breadth - 2 * t) * (depth - 2 * t) ** 3) / 12 == pytest.approx(hollow, abs=0.0005)
    # The outer breadth and depth hold the hollow rectangle's wall, the mid-line shell's wall lies half outside them:
    # to first order the depth is t too large, 3 t / D of the sides and 2 t / D of the plates.
    box = SuperEllipse(breadth / 2, depth, 1e4, 1e4).shell_second_moment(t)
    assert 2 * t / depth < box / hollow - 1 < 3 * t / depth


def test_moments_of_a_full_section_against_adaptive_quadrature() -> None:
    # a = 16.1 m, b = 19.5 m, p = 6, q = 4; one quadrant by scipy.integrate.quad: A = 297.80240726, zbar = 9.36123644,
    # Int z^2 dA = 35065.60092, girth 32.02343319735614.
    section = SuperEllipse(16.1, 19.5, 6.0, 4.0)
    assert section.area == pytest.approx(2 * 297.80240726, rel=1e-10)
    assert section.centroid_below_top == pytest.approx(9.36123644, rel=1e-9)
    assert section.second_moment_about_top == pytest.approx(2 * 35065.60092074676, rel=1e-12)
    assert section.girth() == pytest.approx(2 * 32.02343319735614, rel=1e-10)
    # The girth of an ellipse is a complete elliptic integral: a = 16.1, b = 13.2 gives 23.068559128168 a quadrant.
    assert SuperEllipse(16.1, 13.2, 2.0, 2.0).girth() == pytest.approx(2 * 23.068559128168, rel=1e-12)
