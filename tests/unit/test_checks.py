"""The checks of floating: what passes, what fails, and what is said."""

from __future__ import annotations

import dataclasses
import math

import pytest

from hullform import checks
from hullform.hull.hydrostatics import Hydrostatics
from hullform.loading.watson import Estimate
from hullform.ship import Particulars
from hullform.ship_structure import Hatch, StructureInput

# A box barge 100 x 20 m at 5 m: BM_L = L^2 / (12 T), midships at 50 m.
BARGE = Hydrostatics(
    draught_m=5.0,
    water_density_kg_m3=1025.0,
    volume_m3=10000.0,
    displacement_kg=10.25e6,
    lcb_x_m=50.0,
    lcb_from_midships_m=0.0,
    kb_m=2.5,
    bm_transverse_m=20.0**2 / (12 * 5.0),
    bm_longitudinal_m=100.0**2 / (12 * 5.0),
    waterplane_area_m2=2000.0,
    lcf_x_m=50.0,
    midship_area_m2=100.0,
    wetted_surface_m2=3000.0,
    block_coefficient=1.0,
    midship_coefficient=1.0,
    prismatic_coefficient=1.0,
    waterplane_coefficient=1.0,
)


@pytest.mark.parametrize(("mass", "percent", "ok"), [(10.25e6, 0.0, True), (10.0e6, 2.5, False), (10.6e6, -3.3, False)])
def test_buoyancy_against_mass(mass: float, percent: float, ok: bool) -> None:
    check = checks.check_displacement(mass, BARGE)
    assert check.value == pytest.approx(percent, abs=0.01)
    assert check.ok is ok


def test_a_ship_heavier_than_her_hull_sinks() -> None:
    assert checks.check_floating(10.3e6, 10.25e6, 5.0).ok  # half a per cent: within what a drawing can be read to
    assert not checks.check_floating(11e6, 10.25e6, 5.0).ok


@pytest.mark.parametrize(("weight", "ok"), [(900.0, False), (1100.0, True), (3900.0, True), (4100.0, False)])
def test_light_ship_within_a_factor_of_two(weight: float, ok: bool) -> None:
    assert checks.check_light_ship(weight, Estimate(2000.0, 1000.0, 4000.0)).ok is ok


def test_what_the_file_says_is_held_against_what_was_read() -> None:
    given = Particulars(
        name="barge",
        type="coaster",
        length_overall_m=100.0,
        length_between_perpendiculars_m=100.0,
        breadth_m=20.0,
        depth_m=8.0,
        draught_m=5.0,
        displacement_t=10000.0,
        block_coefficient=0.995,
        lcb_from_midships_m=1.0,
    )
    displacement, block, lcb = checks.checks_of_the_hull(given, BARGE)
    assert (displacement.value, displacement.ok) == (pytest.approx(2.5), False)
    assert (block.value, block.ok) == (pytest.approx(0.5025, abs=1e-4), True)
    assert (lcb.value, lcb.ok) == (pytest.approx(-1.0), False)
    bare = given.model_copy(update={"displacement_t": None, "block_coefficient": None, "lcb_from_midships_m": None})
    assert checks.checks_of_the_hull(bare, BARGE) == ()


@pytest.mark.parametrize(
    ("value", "limits", "told"),
    [
        (1.2, (-0.5, 1.5), "1.20 m, limits −0.5 and 1.5 m"),
        (1.6, (-0.5, 1.5), "1.60 m, limit 1.5 m"),
        (-0.6, (-0.5, 1.5), "−0.600 m, limit −0.5 m"),
        (0.2, (-1.0, 1.0), "0.200 m, limit ±1 m"),
        (0.2, (-math.inf, 1.0), "0.200 m, limit 1 m"),
        (0.2, (0.5, math.inf), "0.200 m, limit 0.5 m"),
    ],
)
def test_figures_show_the_limit_that_is_passed_or_all_that_are_kept(
    value: float, limits: tuple[float, float], told: str
) -> None:
    assert checks.Check("id", "title", value, limits, "m", "remedy").figures == told


def test_a_doubt_names_number_limit_and_remedy() -> None:
    doubt = checks.check_displacement(10.0e6, dataclasses.replace(BARGE, draught_m=5.2)).doubt
    assert "2.50 %" in doubt
    assert "limit 1 %" in doubt
    assert "check the draught" in doubt


@pytest.mark.parametrize(
    ("factor", "limit", "ok"), [(2.25, 0.5, True), (3.31, 6.0, True), (7.0, 6.0, False), (0.4, 0.5, False)]
)
def test_equivalent_thickness(factor: float, limit: float, ok: bool) -> None:
    check = checks.check_thickness(factor, StructureInput())
    assert (check.limit, check.ok) == (limit, ok)
    assert "the bare 16 mm shell" in check.title


@pytest.mark.parametrize(("factor", "limit", "ok"), [(1.2, 1.5, True), (2.25, 1.5, False), (0.6, 0.7, False)])
def test_a_section_with_members_should_come_nearer(factor: float, limit: float, ok: bool) -> None:
    check = checks.check_thickness(factor, StructureInput(stiffener_share=0.3))
    assert (check.limit, check.ok) == (limit, ok)
    assert "the section as modelled" in check.title


def test_a_container_ship_is_open_amidships() -> None:
    main = Particulars(
        name="box ship",
        type="container",
        length_overall_m=100.0,
        length_between_perpendiculars_m=100.0,
        breadth_m=20.0,
        depth_m=12.0,
        draught_m=8.0,
    )
    closed = checks.check_hatches(main, StructureInput(), 50.0)
    assert closed is not None
    assert (closed.value, closed.limit, closed.ok) == (0.0, 50.0, False)
    assert "0 %, limit 50 %" in closed.doubt
    assert "[[structure.hatches]]" in closed.doubt

    # openings of 80 % of the breadth, which end at 40 m
    hatch = Hatch(breadth_m=0.8 * main.breadth_m, to_m=40.0)
    assert checks.check_hatches(main, StructureInput(hatches=(hatch,)), 50.0) == closed
    opened = checks.check_hatches(main, StructureInput(hatches=(hatch,)), 30.0)
    assert opened is not None
    assert (opened.value, opened.ok) == (pytest.approx(80.0), True)
    assert checks.check_hatches(main.model_copy(update={"type": "tanker"}), StructureInput(), 50.0) is None


@pytest.mark.parametrize(("hertz", "ok"), [(0.95, True), (0.1, False), (30.0, False)])
def test_first_frequency_of_a_262_m_hull(hertz: float, ok: bool) -> None:
    # limits 30/L and 3000/L: 0.115 and 11.5 Hz
    assert checks.check_frequency(hertz, 262.0).ok is ok


def test_an_estimate_outside_the_ships_behind_it_is_told() -> None:
    from hullform.ship import Particulars

    tug = Particulars(
        name="tug",
        type="tug",
        length_overall_m=60.0,
        length_between_perpendiculars_m=60.0,
        breadth_m=12.0,
        depth_m=6.0,
        draught_m=5.0,
    )
    check = checks.check_steel_numeral(tug)
    assert check is not None
    # 60 (12 + 5) + 0.85 * 60 * 1 = 1071, above the table's 450
    assert (check.value, check.limit, check.ok) == (pytest.approx(1071.0), 450.0, False)
    assert checks.check_steel_numeral(tug.model_copy(update={"type": "frigate"})) is None
