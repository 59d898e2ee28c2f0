"""A box barge with a list of weights, from the keys of ship.toml to her floating position."""

from __future__ import annotations

from typing import Any

import pytest
from box_barge import BREADTH_M, DEPTH_M, LENGTH_M, box_barge

from hullform.afloat import ConditionAfloat, load_ship
from hullform.ship import Ship

DENSITY = 1025.0
LIGHT_T = 400.0 + 100.0 + 60.0


def ship(**condition: Any) -> Ship:
    house = {"name": "deckhouse", "mass_t": 60.0, "from_m": 4.0, "to_m": 16.0}
    return Ship.model_validate(
        {
            "schema": 1,
            "ship": {
                "name": "barge",
                "type": "tanker",
                "length_overall_m": LENGTH_M,
                "length_between_perpendiculars_m": LENGTH_M,
                "breadth_m": BREADTH_M,
                "depth_m": DEPTH_M,
                "draught_m": 4.0,
            },
            "body_plan": {"image": "none.png", "aft_side": "left", "aft_stations_m": [0.0], "fore_stations_m": [80.0]},
            "structure": {},
            "weights": {"steel_weight_t": 400.0, "semi_concentrated_weight_t": 100.0, "items": [house]},
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
