"""A box barge with a list of weights, from the keys of ship.toml to her floating position."""

from __future__ import annotations

from typing import Any

import pytest
from box_barge import BREADTH_M, DEPTH_M, LENGTH_M, box_barge

from hullform.afloat import ConditionAfloat, ShipAfloat, load_ship
from hullform.loading.watson import machinery_and_outfit
from hullform.ship import Ship

DENSITY = 1025.0
LIGHT_T = 400.0 + 100.0 + 60.0


def ship(weights: dict[str, Any] | None = None, type: str = "tanker", **condition: Any) -> Ship:
    house = {"name": "deckhouse", "mass_t": 60.0, "from_m": 4.0, "to_m": 16.0}
    return Ship.model_validate(
        {
            "schema": 1,
            "ship": {
                "name": "barge",
                "type": type,
                "length_overall_m": LENGTH_M,
                "length_between_perpendiculars_m": LENGTH_M,
                "breadth_m": BREADTH_M,
                "depth_m": DEPTH_M,
                "draught_m": 4.0,
            },
            "body_plan": {"image": "none.png", "aft_side": "left", "aft_stations_m": [0.0], "fore_stations_m": [80.0]},
            "structure": {},
            "weights": {"steel_weight_t": 400.0, "semi_concentrated_weight_t": 100.0, "items": [house]}
            if weights is None
            else weights,
            "conditions": [{"name": "loaded"} | condition],
        }
    )


def afloat(**condition: Any) -> ConditionAfloat:
    (found,) = load_ship(ship(**condition), box_barge()).conditions
    return found


CARGO = {"name": "cargo", "mass_t": 2000.0, "from_m": 20.0, "to_m": 60.0}
WATER = {"name": "fore peak", "mass_t": 50.0, "from_m": 70.0, "to_m": 80.0, "shape": "trapezoid", "centre_m": 74.0}


def test_items_are_carried_by_girder_and_water_alike() -> None:
    found = afloat(items=[CARGO, WATER])
    names = ["steel", "machinery", "deck machinery", "deckhouse", "cargo", "fore peak"]
    assert [item.name for item in found.items] == names
    mass = 1e3 * (LIGHT_T + 2050.0)
    # steel by girth is even along a box; machinery has 70 t over 0..16 m, deck machinery 30 t over 72..80 m
    moment = 1e3 * (400 * 40 + 70 * 8 + 30 * 76 + 60 * 10 + 2000 * 40 + 50 * 74)
    assert found.girder.total_mass == pytest.approx(mass, rel=1e-12)
    # the end plates of a box without a rounded stem are alike
    assert found.girder.centre_of_gravity == pytest.approx(moment / mass, rel=1e-6)
    equilibrium = found.at_rest.equilibrium
    assert equilibrium is not None
    assert equilibrium.volume_m3 * DENSITY == pytest.approx(mass, rel=1e-12)
    assert equilibrium.lcb_x_m == pytest.approx(moment / mass, rel=1e-6)


def test_deadweight_and_items_add_up() -> None:
    found = afloat(deadweight_t=300.0, items=[CARGO])
    assert found.girder.total_mass == pytest.approx(1e3 * (LIGHT_T + 2300.0), rel=1e-12)


def test_given_draughts_are_those_of_the_hydrostatics() -> None:
    found = afloat(items=[CARGO, WATER], draught_aft_m=2.9, draught_fore_m=2.5)
    assert found.at_rest.adopted == "given draughts"
    assert found.floating.draught_m == pytest.approx(2.7)
    assert {check.id for check in found.checks} >= {"given-draughts", "given-trim", "closing", "freeboard"}


def test_the_light_ship_check_counts_her_items() -> None:
    (check,) = (check for check in load_ship(ship(items=[CARGO]), box_barge()).checks if check.id == "light-ship")
    assert check.value == pytest.approx(160.0)


def light(weights: dict[str, Any], type: str = "tanker") -> ShipAfloat:
    return load_ship(ship(weights, type, items=[CARGO]), box_barge())


def test_machinery_and_outfit_are_estimated_where_nothing_is_said_of_them() -> None:
    found = light({"steel_weight_t": 400.0})
    expected = machinery_and_outfit(ship(items=[CARGO]).particulars, found.at_draught.displacement_kg / 1e3)
    assert expected is not None
    steel, machinery, outfit = found.light.items
    assert (steel.name, machinery.name, outfit.name) == ("steel", "machinery", "outfit")
    # by hand: the outfit of a tanker is 0.21 t for a square metre of L B
    assert outfit.mass_kg == pytest.approx(210.0 * LENGTH_M * BREADTH_M)
    assert machinery.mass_kg == pytest.approx(1e3 * expected.machinery_t)
    # the one over the aftermost fifth, the other from end to end
    assert (machinery.centre_m, outfit.centre_m) == pytest.approx((LENGTH_M / 10, LENGTH_M / 2))
    assert found.light.beyond_steel_t == pytest.approx(expected.together.weight_t)
    assert not found.light.beyond_steel_given
    # an estimate is not held against itself
    assert "light-ship" not in {check.id for check in found.checks}


@pytest.mark.parametrize("weights", [{"semi_concentrated_weight_t": 0.0}, {"items": [{"name": "all", "mass_t": 10.0}]}])
def test_whoever_says_anything_of_them_is_believed_and_held_against_the_estimate(weights: dict[str, Any]) -> None:
    found = light({"steel_weight_t": 400.0} | weights)
    assert found.light.beyond_steel_given
    assert sum(item.mass_kg for item in found.light.items[1:]) == pytest.approx(1e3 * found.light.beyond_steel_t)
    (check,) = (check for check in found.checks if check.id == "light-ship")
    assert not check.ok


def test_a_light_ship_of_steel_alone_is_pointed_out_where_there_is_no_estimate() -> None:
    found = light({"steel_weight_t": 400.0}, "tug")
    (check,) = (check for check in found.checks if check.id == "bare-light-ship")
    # a tenth of the steel at least
    assert (check.ok, check.value, check.limit) == (False, 0.0, 40.0)
    assert "give semi_concentrated_weight_t or [[weights.items]]" in check.doubt
    enough = light({"steel_weight_t": 400.0, "semi_concentrated_weight_t": 50.0}, "tug")
    assert [check.ok for check in enough.checks if check.id == "bare-light-ship"] == [True]
