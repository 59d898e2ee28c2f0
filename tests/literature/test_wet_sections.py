"""Two-dimensional added mass and long cylinders against closed forms.

Rectangles: the conformal map of the rectangle's double body (K. Wendel 1950; DNV-RP-C205 prints 1.51, 1.36, 1.21, 1.14
for B/T = 2, 4, 10, 20). Lewis sections: L. Landweber and M. C. de Macagno (1957). A long cylinder that waves as cos kx:
the potential is K_1(k r) sin(theta) cos(k x).
"""

import numpy as np
import pytest
from floating_bodies import SEMICIRCLE, Waves, prism_sections, rectangle
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import kv

from hullvib import wet
from hullvib.wet import two_dimensional


def exact_rectangle(ratio):
    """C = m / (pi/8 rho B^2) of a rectangle of B/T = ratio, from the map of the circle on its double body.

    |dz/dtheta| = 2 sqrt|sin(theta - a) sin(theta + a)| on the circle of radius 1; the map's far field z + (1/z) cos 2a
    gives the double body's added mass 2 pi (1 + cos 2a) less the mass of the water that it displaces.
    """

    def sides(corner):
        def step(theta):
            return 2.0 * np.sqrt(abs(np.sin(theta - corner) * np.sin(theta + corner)))

        return quad(step, corner, np.pi / 2, limit=200)[0], quad(step, 0.0, corner, limit=200)[0]

    corner = brentq(lambda a: np.divide(*sides(a)) - ratio / 2.0, 0.02, 1.5, xtol=1e-13)
    half_breadth, draught = sides(corner)
    double = 2.0 * np.pi * (1.0 + np.cos(2.0 * corner)) - 4.0 * half_breadth * draught
    return double / (np.pi * half_breadth**2)


def coefficient(half_section, panels=two_dimensional.SECTION_PANELS):
    breadth = 2.0 * half_section[-1, 0]
    found = wet.section_added_mass(prism_sections(half_section, 1.0), 1.0, panels)[0]
    return found / (np.pi / 8.0 * breadth**2)


def test_the_map_has_the_printed_values():
    printed = {2: 1.51, 4: 1.36, 10: 1.21, 20: 1.14}
    for ratio, value in printed.items():
        # 1.21 is printed for 1.217
        assert exact_rectangle(ratio) == pytest.approx(value, abs=0.0075)
    # to more digits, B/T = 2 and 4 and those of two ships
    assert exact_rectangle(2) == pytest.approx(1.513168, abs=1e-6)
    assert exact_rectangle(4) == pytest.approx(1.363681, abs=1e-6)
    assert exact_rectangle(32.2 / 13.2) == pytest.approx(1.466887, abs=1e-6)
    assert exact_rectangle(44 / 15.1) == pytest.approx(1.427808, abs=1e-6)


@pytest.mark.parametrize("ratio", [1, 2, 32.2 / 13.2, 44 / 15.1, 4, 10, 20])
def test_rectangles(ratio):
    assert coefficient(rectangle(ratio, 1.0)) == pytest.approx(exact_rectangle(ratio), rel=0.005)


@pytest.mark.parametrize("ratio", [0.5, 1.0, 2.0, 5.0])
def test_every_half_ellipse_has_one(ratio):
    ellipse = SEMICIRCLE * [ratio, 1.0]
    assert coefficient(ellipse) == pytest.approx(1.0, rel=0.005)
    # lewis_coefficient knows it as well: it is a1 alone
    assert wet.lewis_coefficient(2 * ratio, 1.0, np.pi / 2 * ratio) == pytest.approx(1.0, rel=1e-12)


def test_semicircle_is_sharp_at_80_panels():
    assert coefficient(SEMICIRCLE, 80) == pytest.approx(1.0, rel=1e-3)


@pytest.mark.parametrize(
    ("ratio", "fullness", "a1", "a3", "value"),
    [
        (2.4394, 0.985, 0.086245, -0.128629, 1.340812),
        (2.9139, 0.995, None, None, 1.321757),
        (1.0, 0.5, -0.388267, 0.164801, 0.75571),
        (1.0, 1.0, -0.292027, -0.123919, 1.60441),
    ],
)
def test_lewis_worked_numbers(ratio, fullness, a1, a3, value):
    # the B/T are rounded to five figures
    assert wet.lewis_coefficient(ratio, 1.0, fullness * ratio) == pytest.approx(value, abs=2e-5)
    if a1 is not None:
        found = two_dimensional.lewis_parameters(ratio / 2, fullness)
        assert found == pytest.approx((a1, a3), abs=2e-5)


@pytest.mark.parametrize(("half_breadth", "fullness"), [(1.2, 0.80), (1.2, 0.9), (2.0, 0.85)])
def test_a_drawn_lewis_section_has_its_coefficient(half_breadth, fullness):
    """Two roads to one number: the family's formula, and the panels on the family's own curve."""
    a1, a3 = two_dimensional.lewis_parameters(half_breadth, fullness)
    scale = half_breadth / (1 + a1 + a3)
    angle = np.linspace(np.pi / 2, 0, 400)
    y = scale * ((1 + a1) * np.cos(angle) + a3 * np.cos(3 * angle))
    z = -scale * ((1 - a1) * np.sin(angle) - a3 * np.sin(3 * angle))
    section = np.stack([y, z], axis=-1)
    section[0, 0], section[-1, 1] = 0.0, 0.0
    exact = wet.lewis_coefficient(2 * half_breadth, 1.0, fullness * 2 * half_breadth)
    assert -section[0, 1] == pytest.approx(1.0, rel=1e-9)
    assert coefficient(section) == pytest.approx(exact, rel=0.005)


def test_waves_on_a_long_cylinder():
    wave_numbers = np.array([0.5, 1.0, 2.0])
    exact = 1.0 / (1.0 + wave_numbers * kv(0, wave_numbers) / kv(1, wave_numbers))
    matrices = []
    for periods in (1, 2):
        length = 4.0 * np.pi * periods
        sections = prism_sections(SEMICIRCLE, length, 50 * periods + 1)
        flow = wet.PanelFlow(wet.Panels.from_sections(sections, girthwise=8), neutral_axis_m=0.0)
        matrices.append(flow.added_mass(Waves(tuple(wave_numbers), 0.0)).matrix.diagonal())
    # what the longer one has more lies amid, the ends being the same
    amid = (matrices[1] - matrices[0]) / (0.5 * np.pi * 1025.0 * 2.0 * np.pi)
    np.testing.assert_allclose(amid, exact, rtol=0.005)


def test_a_longer_cylinder_is_nearer_to_two_dimensions():
    shares = []
    for length in (4.0, 8.0, 16.0, 32.0):
        panels = wet.Panels.from_sections(prism_sections(SEMICIRCLE, length), 40, 8)
        matrix = wet.PanelFlow(panels, neutral_axis_m=0.0).added_mass(Waves((0.0,), 0.0)).matrix
        shares.append(matrix[0, 0] / (0.5 * np.pi * 1025.0 * length))
    # .736 .851 .921 .960 were found by another panel code
    np.testing.assert_allclose(shares, [0.736, 0.851, 0.921, 0.960], rtol=0.01)
