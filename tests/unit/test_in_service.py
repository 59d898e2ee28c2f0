"""A condition in service: ship.toml's tables, what becomes of them, and what is said of ships as they are."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hullvib
from hullform.errors import ShipFileError
from hullform.in_service import UNIT_FORCE_N, UNIT_MOMENT_N_M, InService, Resonances, in_service
from hullform.service_results import ratios_record, resonance_record, springing_record
from hullform.ship import Ship, read_ship
from hullform.ship_kinds import published_like
from hullform.wet_checks import checks_of_ratios
from hullvib.model_spread import (
    FLEXURAL_SPREAD,
    MASS_SPREAD,
    SHEAR_SPREAD,
    model_uncertainty,
    ratio_uncertainty,
    shear_energy_shares,
)
from hullvib.modes import Modes
from hullvib.real_ships import RATIO_LIMITS, SHIPS, ratios

LENGTH = 120.0
TOML = """
schema = 1
[ship]
name = "a ship"
type = "tanker"
length_overall_m = 120.0
length_between_perpendiculars_m = 110.0
aft_perpendicular_m = 5.0
breadth_m = 20.0
depth_m = 10.0
draught_m = 7.0
[body_plan]
image = "bodyplan.png"
aft_side = "left"
aft_stations_m = [10.0, 30.0]
fore_stations_m = [60.0, 90.0]
"""
EXCITATION = """
[excitation]
propeller_blades = 4
propeller_x_m = 8.0
shaft_speed_rpm = [40.0, 120.0]
service_rpm = 100.0
engine_orders = [1]
engine_x_m = 20.0
m2v_nm = 2.0e6
rated_power_kw = 10000.0
damping = 0.01
"""


@pytest.fixture(scope="module")
def modes() -> Modes:
    # 2.0 Hz in the 2-node mode: beta L = 4.73, f = 22.3733 / (2 pi L^2) sqrt(EI / m)
    girder = hullvib.Girder(
        [0.0, LENGTH], [8e4, 8e4], [8e4 * (2.0 * 2 * math.pi * LENGTH**2 / 22.3733) ** 2] * 2, [6e10, 6e10]
    )
    return hullvib.solve(girder, hullvib.StodolaRitz(functions=12, shear=True), modes=5)


def read(folder: Path, text: str) -> Ship:
    path = folder / "ship.toml"
    path.write_text(TOML + text, encoding="utf-8")
    return read_ship(path)


def resonances(service: InService) -> Resonances:
    assert service.resonances is not None
    return service.resonances


def test_without_the_tables_nothing_is_said(tmp_path: Path, modes: Modes) -> None:
    found = in_service(read(tmp_path, ""), modes)
    assert found.resonances is None
    assert found.springing is None
    assert resonance_record(found) is None
    assert springing_record(found) is None


def test_orders_are_those_listed_and_those_with_a_moment(tmp_path: Path, modes: Modes) -> None:
    found = resonances(in_service(read(tmp_path, EXCITATION), modes))
    assert [source.order for source in found.sources] == [4, 8, 12, 1.0, 2.0]
    assert [(one.order, one.pru_nm_per_kw, one.need) for one in found.unbalances] == [(2, 200.0, "likely")]


def test_every_hit_is_where_the_ray_crosses_the_band(tmp_path: Path, modes: Modes) -> None:
    found = resonances(in_service(read(tmp_path, EXCITATION), modes))
    lower, upper = found.bands_hz
    assert found.hits
    for hit in found.hits:
        for rpm in hit.avoid_rpm:
            exciting = hit.source.order * rpm / 60
            assert lower[hit.mode - 1] * (1 - 1e-12) <= exciting <= upper[hit.mode - 1] * (1 + 1e-12)
            assert 40.0 <= rpm <= 120.0
        margin = found.margin_of(hit)
        assert margin == pytest.approx(hit.source.order * 100 / 60 / modes.frequencies_hz[hit.mode - 1] - 1)
    # and a fine sweep of the shaft's speed finds no other
    for rpm in np.linspace(40.0, 120.0, 4001):
        for source in found.sources:
            for mode in range(5):
                inside = lower[mode] < source.order * rpm / 60 < upper[mode]
                told = any(hit.mode == mode + 1 and hit.source == source and hit.holds(rpm) for hit in found.hits)
                assert (
                    inside == told or np.isclose(source.order * rpm / 60, [lower[mode], upper[mode]], rtol=1e-9).any()
                )


def test_loads_are_as_given_at_their_speed_or_one_unit(tmp_path: Path, modes: Modes) -> None:
    found = resonances(in_service(read(tmp_path, EXCITATION), modes))
    for response in found.responses:
        source, load = response.hit.source, response.load
        if source.order == 2.0:
            # given at the service speed of 100 rpm, as nothing else is said
            assert response.load_is_given
            assert load.moment_n_m == pytest.approx(2.0e6 * (response.speed_rpm / 100.0) ** 2, rel=1e-12)
            assert load.x_m == 20.0
        elif source.acts == "moment":
            assert (load.moment_n_m, load.force_n, response.load_is_given) == (UNIT_MOMENT_N_M, 0.0, False)
        else:
            assert (load.moment_n_m, load.force_n, response.load_is_given) == (0.0, UNIT_FORCE_N, False)
            assert load.x_m == 8.0
    assert {response.hit.source.order for response in found.responses} >= {2.0, 4}


def test_the_response_at_a_critical_speed_is_the_resonance_of_one_mode(tmp_path: Path, modes: Modes) -> None:
    found = resonances(in_service(read(tmp_path, EXCITATION), modes))
    within = [r for r in found.responses if r.hit.source.order == 2.0 and 40 <= r.hit.critical_rpm <= 120]
    assert within
    for response in within:
        n = response.hit.mode - 1
        work = response.load.moment_n_m * abs(modes.rotation([20.0])[n, 0])
        aft = (
            work * abs(modes.shape([0.0])[n, 0]) / (2 * 0.01 * modes.angular_frequencies[n] ** 2 * modes.modal_mass[n])
        )
        assert response.motion.amplitude_m[0] == pytest.approx(aft, rel=1e-9)


def test_without_damping_there_is_no_response_and_with_an_own_uncertainty_it_holds(
    tmp_path: Path, modes: Modes
) -> None:
    text = EXCITATION.replace("damping = 0.01", "frequency_uncertainty = 0.02")
    found = resonances(in_service(read(tmp_path, text), modes))
    assert found.responses == ()
    np.testing.assert_allclose(found.bands_hz[1], modes.frequencies_hz * 1.02 * 1.05, rtol=1e-14)


def test_springing_has_every_speed_and_heading(tmp_path: Path, modes: Modes) -> None:
    found = in_service(read(tmp_path, "[operation]\nspeeds_knots = [0.0, 15.0]\n"), modes).springing
    assert found is not None
    assert {(met.speed_knots, met.heading_deg) for met in found.waves} == {
        (0.0, 180.0), (15.0, 180.0), (0.0, 0.0), (15.0, 0.0)
    }  # fmt: skip
    still = [met.wave for met in found.waves if met.speed_knots == 0.0]
    # she lies still: the waves' frequency is hers, or half of it
    assert [wave.angular_frequency * wave.order for wave in still] == pytest.approx([found.natural_rad_s] * 4)


def test_the_records_keep_what_was_found(tmp_path: Path, modes: Modes) -> None:
    ship = read(tmp_path, EXCITATION + "[operation]\nspeeds_knots = [15.0]\nheadings_deg = [120.0]\n")
    service = in_service(ship, modes)
    resonance, springing = resonance_record(service), springing_record(service)
    assert resonance is not None
    assert springing is not None
    found = resonances(service)
    assert [(hit.mode, hit.source) for hit in resonance.hits] == [(hit.mode, hit.source.name) for hit in found.hits]
    assert all(hit.response is not None for hit in resonance.hits)
    assert len(resonance.sources) == len(found.sources)
    assert [wave.heading_deg for wave in springing.waves] == [120.0, 120.0]
    ratio = ratios_record(modes, ship.particulars)
    assert ratio.three_to_two_node == modes.frequencies_hz[1] / modes.frequencies_hz[0]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[excitation]\npropeller_blades = 4", "excitation.shaft_speed_rpm: is missing"),
        ("[excitation]\nshaft_speed_rpm = [40.0, 100.0]", "nothing excites"),
        ("[excitation]\nshaft_speed_rpm = [100.0, 40.0]\npropeller_blades = 4", "is no range"),
        (
            "[excitation]\nshaft_speed_rpm = [40.0, 100.0]\npropeller_blades = 4\nservice_rpm = 110.0",
            "service_rpm = 110 lies outside",
        ),
        ("[excitation]\nshaft_speed_rpm = [40.0, 100.0]\nm2v_nm = 1e6", "engine_x_m is missing"),
        (
            "[excitation]\nshaft_speed_rpm = [40.0, 100.0]\nengine_orders = [2]\nengine_x_m = 130.0",
            "excitation.engine_x_m = 130 lies outside the ship",
        ),
        ("[excitation]\nshaft_speed_rpm = [40.0, 100.0]\npropeller_blades = 1", "propeller_blades = 1"),
        (
            "[excitation]\nshaft_speed_rpm = [40.0, 100.0]\nengine_orders = [1]\nengine_x_m = 20.0\n"
            "propeller_force_n = 9e3",
            "give propeller_blades",
        ),
        ("[excitation]\nshaft_speed_rpm = [40.0, 100.0]\npropeller_blade = 4", "did you mean 'propeller_blades'"),
        ("[operation]\nspeeds_knots = []", "operation.speeds_knots has 0 values; give one or more"),
        ("[operation]\nspeeds_knots = [14.0]\nheadings_deg = [270.0]", "operation.headings_deg.0 = 270.0"),
        ("[operation]\nspeeds_knots = [75.0]", "operation.speeds_knots.0 = 75.0"),
    ],
)
def test_a_fault_is_told_with_its_path(tmp_path: Path, text: str, words: str) -> None:
    with pytest.raises(ShipFileError, match=re.escape(words)):
        read(tmp_path, text)


def test_the_share_of_shear_is_that_of_two_solutions(modes: Modes) -> None:
    """Rayleigh's quotient is stationary: a per mille more kGA raises omega^2 by s_n per mille, more EI by 1 - s_n."""
    share = shear_energy_shares(modes)
    assert ((share > 0.02) & (share < 0.98)).all()
    girder, step = modes.girder, 1e-3

    def squared(flexural: float, shear: float) -> Any:
        ei = float(girder.flexural_rigidity([0.0])[0]) * flexural
        changed = hullvib.Girder([0.0, LENGTH], [8e4, 8e4], [ei, ei], [6e10 * shear] * 2)
        found = hullvib.solve(changed, hullvib.StodolaRitz(functions=12, shear=True), modes=5)
        return found.angular_frequencies**2

    base = modes.angular_frequencies**2
    np.testing.assert_allclose((squared(1, 1 + step) / base - 1) / step, share, atol=1e-3)
    np.testing.assert_allclose((squared(1 + step, 1) / base - 1) / step, 1 - share, atol=1e-3)
    by_hand = 0.5 * np.sqrt(((1 - share) * FLEXURAL_SPREAD) ** 2 + (share * SHEAR_SPREAD) ** 2 + MASS_SPREAD**2)
    np.testing.assert_allclose(model_uncertainty(modes), by_hand, rtol=1e-14)
    euler = hullvib.solve(girder, hullvib.StodolaRitz(functions=12), modes=3)
    assert (shear_energy_shares(euler) == 0.0).all()


def test_every_published_ship_keeps_to_the_limits_which_are_its_own() -> None:
    higher = np.array([[*ship.ratios, np.nan][:2] for ship in SHIPS])
    for column, (low, high) in enumerate(RATIO_LIMITS):
        values = higher[:, column][np.isfinite(higher[:, column])]
        assert (values >= low).all()
        assert (values <= high).all()
        # tight: rounded outwards to 0.05 and 0.1 (1.70 is 177 / 104)
        assert values.min() - low < 0.1
        assert high - values.max() < 0.1


def test_ratios_are_checked_in_water_alone() -> None:
    assert checks_of_ratios((2.5, 4.9), (0.0, 0.0), "dry") == ()
    three_node, four_node = checks_of_ratios((2.0, 3.5), (0.0, 0.0), "wet")
    assert three_node.ok
    assert not four_node.ok
    assert four_node.limit == 3.2
    assert "shear area" in four_node.doubt
    low, _ = checks_of_ratios((1.6, 3.0), (0.0, 0.0), "wet")
    assert (low.ok, low.limit) == (False, 1.7)


def test_the_band_of_ships_is_widened_by_what_the_model_does_not_know() -> None:
    three_node, four_node = checks_of_ratios((1.6, 3.3), (0.04, 0.05), "wet")
    assert (three_node.ok, three_node.limit) == (False, pytest.approx(1.632))
    assert (four_node.ok, four_node.limit) == (True, pytest.approx(3.36))
    assert "2.8 to 3.2, widened by the 5.0 %" in four_node.title


def test_ratio_uncertainty_against_girders_of_other_rigidities() -> None:
    def logarithms(flexural: float = 0.0, shear: float = 0.0, mass: float = 0.0) -> Any:
        x, m, ei, kga = np.array([0.0, LENGTH]), np.array([8e4, 6e4]), np.array([3e13, 2e13]), np.array([5e10, 4e10])
        girder = hullvib.Girder(x, m * (1 + mass), ei * (1 + flexural), kga * (1 + shear))
        modes = hullvib.solve(girder, hullvib.StodolaRitz(functions=12, shear=True), modes=4)
        return np.log(modes.angular_frequencies / modes.angular_frequencies[0]), modes

    step = 1e-4
    base, modes = logarithms()
    by_flexural, by_shear, by_mass = (
        (logarithms(**{name: step})[0] - base) / step for name in ("flexural", "shear", "mass")
    )
    np.testing.assert_allclose(by_mass, 0.0, atol=1e-9)
    # first order: what is left is the second, step / 2 and less
    np.testing.assert_allclose(by_shear, -by_flexural, atol=step)
    wanted = np.hypot(FLEXURAL_SPREAD * by_flexural, SHEAR_SPREAD * by_shear)
    np.testing.assert_allclose(ratio_uncertainty(modes), wanted, atol=step)
    assert wanted[2] > 0.01


def test_ships_of_her_kind_and_length(tmp_path: Path) -> None:
    ship = read(tmp_path, "").particulars

    def like(**changes: Any) -> list[float]:
        return [other.length_m for other in published_like(ship.model_copy(update=changes))]

    assert like() == []
    assert like(length_between_perpendiculars_m=239.0) == [227.0, 227.0]
    assert like(type="container", length_between_perpendiculars_m=120.0) == [130.0, 130.0]
    assert like(type="tug", length_between_perpendiculars_m=120.0) == []
    assert ratios([2.0, 4.0, 7.0, 9.0]) == (2.0, 3.5)
