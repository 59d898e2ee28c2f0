"""Section properties along a ship with members: the laws that any structure keeps, on a barge and on a finer hull."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from plated import network

from hullform.errors import LoadingError
from hullform.hull import Hull
from hullform.loading.structure import FLOOR, Structure, structure_of
from hullform.loading.thin_walled import section_properties
from hullform.loading.weights import light_ship
from hullform.ship import Particulars
from hullform.ship_structure import StructureInput
from hullform.ship_weights import WeightsInput

LENGTH, BREADTH, DEPTH = 100.0, 20.0, 12.0
CURVES = ("area_m2", "second_moment_m4", "horizontal_second_moment_m4", "shear_area_m2", "torsion_constant_m4")


def hull(exponent: float, fineness: float = 0.0) -> Hull:
    """A barge, or a hull that narrows to both ends and rises at them."""
    x = np.linspace(0.0, LENGTH, 41)
    shape = 1 - fineness * (2 * x / LENGTH - 1) ** 4
    return Hull.of_super_ellipses(
        x, BREADTH / 2 * shape, DEPTH * shape, np.full(41, DEPTH), np.full(41, exponent), np.full(41, exponent),
        LENGTH, LENGTH, 0.0, BREADTH, DEPTH, 8.0,
    )  # fmt: skip


def structure(ship: Hull | None = None, **keys: Any) -> Structure:
    return structure_of(hull(3.0, 0.999) if ship is None else ship, StructureInput.model_validate(keys))


MEMBERS: dict[str, Any] = {
    "stiffener_share": 0.3,
    "inner_bottom": {"height_m": 1.5, "from_m": 5.0, "to_m": 95.0},
    "double_side": {"breadth_m": 1.5, "from_m": 10.0},
    "hatches": [{"from_m": 20.0, "to_m": 80.0, "breadth_m": 14.0}],
    "decks": [{"height_m": 9.0, "outboard_of_m": 8.5}],
    "longitudinal_bulkheads": [{"y_m": 0.0, "head_m": 1.5}, {"y_m": 4.0, "to_m": 60.0}],
}


def test_the_plated_road_meets_the_plain_one() -> None:
    plain = structure()
    # a zone of the shell's own thickness changes nothing but the road
    plated = structure(zones=[{"part": "deck", "thickness_m": 0.016}])
    for name in (*CURVES, "neutral_axis_m", "steel_area_m2"):
        # 100 chords for the curve: (turn of a chord)^2 / 24, some 1e-4; the ends, of no area, aside
        np.testing.assert_allclose(getattr(plated, name)[1:-1], getattr(plain, name)[1:-1], rtol=3e-4)


def test_a_barge_with_members_has_the_figures_of_her_plates() -> None:
    # exponents of 2000: corners as sharp as a box's, to 1e-3 of the breadth
    t = 0.016
    found = structure(
        hull(2000.0), inner_bottom={"height_m": 1.5}, longitudinal_bulkheads=[{"y_m": 4.0, "thickness_m": 0.01}]
    )
    half, skin = BREADTH / 2, 1.5
    plates = [
        ((0.0, 0.0), (4.0, 0.0), t), ((4.0, 0.0), (half, 0.0), t), ((half, 0.0), (half, skin), t),
        ((half, skin), (half, DEPTH), t), ((half, DEPTH), (4.0, DEPTH), t), ((4.0, DEPTH), (0.0, DEPTH), t),
        ((0.0, skin), (4.0, skin), t), ((4.0, skin), (half, skin), t),
        ((4.0, 0.0), (4.0, skin), 0.01), ((4.0, skin), (4.0, DEPTH), 0.01),
    ]  # fmt: skip
    by_hand = section_properties(network(plates, mirrored=True))
    for name in (*CURVES, "neutral_axis_m"):
        np.testing.assert_allclose(getattr(found, name), float(getattr(by_hand, name)), rtol=2e-3)


def test_nothing_is_not_a_number_and_ends_that_vanish_are_lifted() -> None:
    found = structure(**MEMBERS)
    for name in (*CURVES, "neutral_axis_m", "steel_area_m2", "girth_m"):
        assert np.isfinite(getattr(found, name)).all()
    assert found.second_moment_m4.min() == pytest.approx(FLOOR * found.midship_second_moment_m4)
    assert found.floored > 0


def test_members_begin_and_end_with_a_jump() -> None:
    found = structure(**MEMBERS)
    twice = found.x_m[:-1][np.diff(found.x_m) == 0]
    assert twice.tolist() == [5.0, 10.0, 20.0, 60.0, 80.0, 95.0]
    opening = int(np.searchsorted(found.x_m, 20.0))
    # forward of x = 20 the hatch has opened the deck: less of everything, and of the torsion constant nearly all
    for name in CURVES:
        abaft, forward = getattr(found, name)[[opening, opening + 1]]
        assert forward < abaft
    assert found.torsion_constant_m4[opening + 1] < 0.2 * found.torsion_constant_m4[opening]


def test_no_two_places_are_all_but_one() -> None:
    # stations stand every 2.5 m; a beam solution cannot take bays of millimetres
    keys: dict[str, Any] = {
        "inner_bottom": {"height_m": 1.5, "from_m": 10.0004, "to_m": 99.9995},
        "hatches": [{"breadth_m": 12.0, "from_m": 31.0, "to_m": 59.9998}],
        "zones": [{"part": "deck", "thickness_m": 0.02, "from_m": 60.0003}],
    }
    found = structure(hull(3.0), **keys)
    gaps = np.diff(found.x_m)
    assert found.x_m[:-1][gaps == 0].tolist() == [10.0, 31.0, 60.0]
    assert gaps[gaps > 0].min() == pytest.approx(1.0)
    # the hatch and the thinner deck end at one place: abaft of it neither has, forward of it both have
    at = int(np.searchsorted(found.x_m, 60.0))
    assert found.steel_area_m2[at + 1] - found.steel_area_m2[at] == pytest.approx(0.016 * 12 + 0.004 * 20, rel=2e-2)


def test_stiffeners_bend_and_do_not_shear() -> None:
    bare, stiffened = structure(zones=[{"part": "side", "thickness_m": 0.02}]), structure(
        zones=[{"part": "side", "thickness_m": 0.02}], stiffener_share=0.25
    )  # fmt: skip
    np.testing.assert_allclose(stiffened.area_m2, 1.25 * bare.area_m2)
    np.testing.assert_allclose(stiffened.second_moment_m4, 1.25 * bare.second_moment_m4)
    # I and the flow's growth rise alike, the plates that it flows through do not
    np.testing.assert_allclose(stiffened.shear_area_m2, bare.shear_area_m2, rtol=1e-9)
    np.testing.assert_allclose(stiffened.torsion_constant_m4, bare.torsion_constant_m4)


def test_net_plates_are_thinner_by_the_margin_and_weigh_what_gross_ones_do() -> None:
    gross = structure(**MEMBERS, shell_thickness_m=0.02)
    net = structure(**MEMBERS, shell_thickness_m=0.02, scantlings="net", corrosion_margin_m=0.003)
    for name in ("area_m2", "second_moment_m4", "shear_area_m2"):
        np.testing.assert_allclose(getattr(net, name), 0.85 * getattr(gross, name), rtol=1e-9)
    assert net.steel_volume_m3 == gross.steel_volume_m3
    np.testing.assert_array_equal(structure(**MEMBERS, corrosion_margin_m=0.003).area_m2, structure(**MEMBERS).area_m2)


def test_a_house_helps_by_its_share_and_weighs_all_of_it() -> None:
    house = {"from_m": 10.0, "to_m": 25.0, "height_m": 6.0, "breadth_m": 12.0}
    none, little, whole = (
        structure(superstructures=[{**house, "effective_share": share}]) for share in (0.0, 0.3, 1.0)
    )
    at = int(np.searchsorted(none.x_m, 20.0))
    without = structure(zones=[{"part": "deck", "thickness_m": 0.016, "from_m": 10.0, "to_m": 25.0}])
    for name in CURVES:
        np.testing.assert_allclose(getattr(none, name)[at], getattr(without, name)[at], rtol=1e-9)
        assert getattr(none, name)[at] < getattr(little, name)[at] < getattr(whole, name)[at]
    assert none.steel_volume_m3 == whole.steel_volume_m3 > without.steel_volume_m3


def test_the_given_midship_figures_scale_the_model() -> None:
    found = structure(**MEMBERS, midship_second_moment_m4=60.0, midship_shear_area_m2=0.5)
    bare = structure(**MEMBERS)
    assert found.midship_second_moment_m4 == pytest.approx(60.0)
    assert found.midship_shear_area_m2 == pytest.approx(0.5)
    assert found.thickness_factor == pytest.approx(60.0 / bare.midship_second_moment_m4)
    assert found.steel_volume_m3 == bare.steel_volume_m3


@pytest.mark.parametrize(
    ("keys", "told"),
    [
        ({"decks": [{"height_m": 900.0}]}, "'deck at 900 m' lies nowhere within the hull"),
        ({"inner_bottom": {"height_m": 15.0}}, "'inner bottom' lies nowhere"),
        (
            {"hatches": [{"breadth_m": 14.0}], "superstructures": [{"height_m": 3.0, "breadth_m": 9.0}]},
            "nothing ties 'superstructure'",
        ),
        (
            {"longitudinal_bulkheads": [{"y_m": 3.0, "foot_m": 4.0, "head_m": 6.0}]},
            "at x = 0 m nothing ties 'bulkhead at 3 m'",
        ),
    ],
)
def test_a_member_that_is_nowhere_or_hangs_in_the_air_is_told(keys: dict[str, Any], told: str) -> None:
    with pytest.raises(LoadingError, match=told):
        structure(hull(2000.0), **keys)


def test_the_steel_weight_stays_and_bulkheads_take_their_part_of_it() -> None:
    particulars = Particulars(
        name="barge", type="tanker", length_overall_m=LENGTH, length_between_perpendiculars_m=LENGTH,
        breadth_m=BREADTH, depth_m=DEPTH, draught_m=8.0,
    )  # fmt: skip
    ship = hull(2000.0)

    def steel(**keys: Any) -> tuple[Structure, Any]:
        found = structure(ship, **keys)
        light = light_ship(WeightsInput(steel_weight_t=1000.0), ship, found, particulars, 0.8, 16000.0)
        return found, light.items[0]

    bulkheads = {"x_m": [25.0, 50.0], "thickness_m": 0.012, "stiffener_share": 0.5}
    hatch = {"hatches": [{"from_m": 20.0, "to_m": 80.0, "breadth_m": 14.0}]}
    found, item = steel(transverse_bulkheads=[bulkheads], **hatch)
    assert item.mass_kg == pytest.approx(1e6, rel=1e-12)
    # two plates of 20 m by 12 m, 12 mm and half as much again of stiffeners, as the whole model's steel is to 1000 t
    volume = BREADTH * DEPTH * 0.012 * 1.5
    inner = [mass for x, mass in item.points if 0 < x < LENGTH]
    assert inner == pytest.approx([1e6 * volume / found.steel_volume_m3] * 2, rel=2e-3)
    # between the bulkheads the curve has the open section's steel
    left, _ = item.at_piece_ends(np.array([40.0, 41.0]))
    open_area = 0.016 * (2 * (BREADTH + DEPTH) - 14.0)
    assert left[0] == pytest.approx(1e6 * open_area / found.steel_volume_m3, rel=2e-3)
    # bulkheads do not bend
    without, _ = steel(**hatch)
    np.testing.assert_array_equal(found.second_moment_m4, without.second_moment_m4)
