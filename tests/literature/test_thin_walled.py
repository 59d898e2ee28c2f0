"""Thin-walled sections, open, of one cell and of two, against closed forms of the textbooks.

Bredt's formulas and the shear flow of two cells by equilibrium and compatibility: Megson, Introduction to Aircraft
Structural Analysis; the slit tube and the channel: Young & Budynas, Roark's Formulas, table of thin sections.
"""

from __future__ import annotations

import numpy as np
import pytest
from plated import Plate, network

from hullform.loading.thin_walled import SectionProperties, closed_shell, section_properties

# The kernel's own error: the share of the stiffest joint that ties the others to the ground is 1e-13.
ROUND_OFF = 1e-10
B, H = 8.0, 5.0
FLANGE, WEB, MIDDLE = 0.02, 0.012, 0.03


def tube(radius: float, thickness: float) -> SectionProperties:
    angle = np.linspace(0.0, np.pi, 2001)
    return section_properties(closed_shell(radius * np.sin(angle), radius * np.cos(angle), thickness))


def test_circle() -> None:
    radius, t = 3.0, 0.01
    found = tube(radius, t)
    # a polygon of 4000 sides: (pi / 2000)^2
    assert found.area_m2 == pytest.approx(2 * np.pi * radius * t, rel=5e-6)
    assert found.neutral_axis_m == pytest.approx(0.0, abs=1e-12)
    assert found.second_moment_m4 == pytest.approx(np.pi * radius**3 * t, rel=5e-6)
    assert found.horizontal_second_moment_m4 == pytest.approx(np.pi * radius**3 * t, rel=5e-6)
    closed_and_open_part = 2 * np.pi * radius**3 * t + 2 * np.pi * radius * t**3 / 3
    assert found.torsion_constant_m4 == pytest.approx(closed_and_open_part, rel=5e-6)


def test_box_of_two_thicknesses() -> None:
    plates = [
        ((0.0, 0.0), (B, 0.0), FLANGE), ((B, 0.0), (B, H), WEB), ((B, H), (0.0, H), FLANGE), ((0.0, H), (0.0, 0.0), WEB)
    ]  # fmt: skip
    found = section_properties(network(plates))
    assert found.area_m2 == pytest.approx(2 * (B * FLANGE + H * WEB), rel=ROUND_OFF)
    assert (found.centroid_y_m, found.neutral_axis_m) == pytest.approx((B / 2, H / 2))
    assert found.second_moment_m4 == pytest.approx(B * FLANGE * H**2 / 2 + WEB * H**3 / 6, rel=ROUND_OFF)
    assert found.horizontal_second_moment_m4 == pytest.approx(H * WEB * B**2 / 2 + FLANGE * B**3 / 6, rel=ROUND_OFF)
    bredt = 4 * (B * H) ** 2 / (2 * (B / FLANGE + H / WEB))
    open_part = 2 * (B * FLANGE**3 + H * WEB**3) / 3
    assert found.torsion_constant_m4 == pytest.approx(bredt + open_part, rel=ROUND_OFF)


def test_slit_tube_has_no_more_than_the_open_part() -> None:
    # cut at its top the tube is one branch that returns to its own start, with two joints there
    radius, t = 2.0, 0.02
    angle = np.linspace(0.0, 2 * np.pi, 2001)
    shell = closed_shell(radius * np.sin(angle), radius * np.cos(angle), t)
    found = section_properties(type(shell)(shell.y_m, shell.z_m, *[shell.thickness_m] * 2, shell.joints, False))
    assert found.torsion_constant_m4 == pytest.approx(2 * np.pi * radius * t**3 / 3, rel=5e-6)


def two_cells() -> list[Plate]:
    """Two square-cornered cells side by side, of different breadth, with a thick web between."""
    corners = [(0.0, 0.0), (0.4 * B, 0.0), (B, 0.0), (B, H), (0.4 * B, H), (0.0, H)]
    t = [FLANGE, FLANGE, WEB, FLANGE, FLANGE, WEB]
    ring = [(corners[i], corners[(i + 1) % 6], t[i]) for i in range(6)]
    return [*ring, (corners[1], corners[4], MIDDLE)]


def test_torsion_of_two_cells_by_hand() -> None:
    # unit twist: for each cell, Sum q / t ds = 2 A; the web between takes the difference of both flows
    left, right = 0.4 * B, 0.6 * B
    own = [2 * left / FLANGE + H / WEB + H / MIDDLE, 2 * right / FLANGE + H / WEB + H / MIDDLE]
    shared = H / MIDDLE
    flows = np.linalg.solve([[own[0], -shared], [-shared, own[1]]], [2 * left * H, 2 * right * H])
    bredt = 2 * (flows @ [left * H, right * H])
    open_part = (2 * B * FLANGE**3 + 2 * H * WEB**3 + H * MIDDLE**3) / 3
    found = section_properties(network(two_cells()))
    assert found.torsion_constant_m4 == pytest.approx(bredt + open_part, rel=ROUND_OFF)


def three_webs() -> list[Plate]:
    """A box with a web on its centre line, so that both cells are alike; the flow in each is not known by symmetry."""
    half = B / 2
    return [
        ((0.0, 0.0), (half, 0.0), FLANGE), ((half, 0.0), (half, H), WEB), ((half, H), (0.0, H), FLANGE),
        ((0.0, H), (-half, H), FLANGE), ((-half, H), (-half, 0.0), WEB), ((-half, 0.0), (0.0, 0.0), FLANGE),
        ((0.0, 0.0), (0.0, H), MIDDLE),
    ]  # fmt: skip


def test_shear_of_two_cells_by_hand() -> None:
    # Cut the flange at distance c from the centre web, where its flow vanishes: then it grows as t z s both ways, to
    # the side and to the centre. Compatibility of the cell gives c. With z = H / 2 in the deck, V = I:
    #   deck:  f = t (H/2) (y - c), y from the centre web; side: f = Q_s + WEB (H/2 s - s^2/2), Q_s = t (H/2)(b - c)
    #   web:   f = Q_w + MIDDLE (H/2 s - s^2/2), Q_w = 2 t (H/2) c
    #   round the cell: 2 Int_deck f/t + Int_side f/t - Int_web f/t = 0, the parabolas of side and web alike
    b, t, h2 = B / 2, FLANGE, H / 2
    # 2 h2 (b^2/2 - c b) + t h2 (b - c) H / WEB - 2 t h2 c H / MIDDLE = 0
    c = (h2 * b**2 + t * h2 * b * H / WEB) / (2 * h2 * b + t * h2 * H / WEB + 2 * t * h2 * H / MIDDLE)

    def web_energy(start: float, thickness: float) -> float:
        return (start**2 * H + 2 * start * thickness * H**3 / 12 + thickness**2 * H**5 / 120) / thickness

    deck = t * h2**2 * ((b - c) ** 3 + c**3) / 3
    energy = 4 * deck + 2 * web_energy(t * h2 * (b - c), WEB) + web_energy(2 * t * h2 * c, MIDDLE)
    second_moment = 2 * B * FLANGE * h2**2 + (2 * WEB + MIDDLE) * H**3 / 12
    found = section_properties(network(three_webs()))
    assert found.second_moment_m4 == pytest.approx(second_moment, rel=ROUND_OFF)
    assert found.shear_area_m2 == pytest.approx(second_moment**2 / energy, rel=ROUND_OFF)


def test_the_half_of_a_section_has_what_the_whole_has() -> None:
    half = [plate for plate in three_webs() if min(plate[0][0], plate[1][0]) >= 0]
    halved = [(start, end, t / 2 if start[0] == end[0] == 0 else t) for start, end, t in half]
    whole, found = (
        section_properties(network(plates, mirrored=mirrored))
        for plates, mirrored in ((three_webs(), False), (halved, True))
    )
    for name in ("area_m2", "neutral_axis_m", "second_moment_m4", "horizontal_second_moment_m4", "shear_area_m2"):
        assert getattr(found, name) == pytest.approx(getattr(whole, name), rel=ROUND_OFF)
    # the web on the centre line is taken for two of half its thickness: of its own H t^3 / 3 a quarter is left
    missing = 0.75 * H * MIDDLE**3 / 3
    assert found.torsion_constant_m4 + missing == pytest.approx(float(whole.torsion_constant_m4), rel=ROUND_OFF)


def test_an_unsymmetric_section_in_shear() -> None:
    # an angle of equal legs a under a force along one leg. With s from the free end of the upright leg and principal
    # axes at 45 degrees, Q of each axis is a polynomial; the energy is that of both axes, each with half the force
    a, t = 2.0, 0.02
    angle = section_properties(network([((0.0, 0.0), (a, 0.0), t), ((0.0, 0.0), (0.0, a), t)]))
    assert (angle.centroid_y_m, angle.neutral_axis_m) == pytest.approx((a / 4, a / 4))
    upright, skew = 5 * t * a**3 / 24, -t * a**3 / 8
    assert angle.second_moment_m4 == pytest.approx(upright, rel=ROUND_OFF)
    # ordinate of the bending stress along both legs, from their free ends, for a force V = I - I_yz^2 / I
    effective = upright - skew**2 / upright
    s, w = np.polynomial.legendre.leggauss(8)
    s, w = a * (1 + s) / 2, a * w / 2
    ratio = skew / upright

    def flow(start: float, slope: float) -> np.ndarray:
        return t * (start * s + slope * s**2 / 2)

    standing = flow((3 * a / 4) - ratio * (-a / 4), -1.0)
    lying = flow(-a / 4 - ratio * (3 * a / 4), ratio)
    energy = ((standing**2 + lying**2) / t) @ w
    assert angle.shear_area_m2 == pytest.approx(effective**2 / energy, rel=ROUND_OFF)


def test_sections_without_extent_have_zeros_and_no_nan() -> None:
    nothing = section_properties(network([((0.0, 3.0), (0.0, 3.0), 0.02)], mirrored=True))
    assert np.all(np.array(nothing[:2] + nothing[3:]) == 0.0)
    assert nothing.neutral_axis_m == 0.0
