"""The paper's figures that the appendix prints, against the printed table."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from hullform.report.published import FUNCTIONS, SHIPS, published_condition, published_ship
from hullform.ship import Ship, read_ship

REPOSITORY = Path(__file__).parents[2]
REFERENCE = Path(__file__).parents[1] / "data" / "paper_table2.json"
BLOCKS = [block for ship in SHIPS for block in ship.conditions]


@pytest.fixture(scope="module")
def table() -> dict[str, Any]:
    return json.loads(REFERENCE.read_text(encoding="utf-8"))


@pytest.mark.parametrize("block", BLOCKS, ids=lambda block: block.letter)
def test_table_2_is_copied_digit_by_digit(block: Any, table: dict[str, Any]) -> None:
    printed = table[block.letter]
    assert [mode.converged for mode in block.modes] == printed["RR"]
    assert [mode.ritz[0] for mode in block.modes] == printed["RR_N4"]
    assert [mode.schlick for mode in block.modes] == printed["schlick"]
    assert [mode.todd for mode in block.modes] == printed["todd"]
    assert [mode.finite_element for mode in block.modes] == printed["FEA"]


@pytest.mark.parametrize("block", BLOCKS, ids=lambda block: block.letter)
def test_columns_are_complete_and_never_rise(block: Any) -> None:
    for mode in block.modes:
        assert len(mode.ritz) == len(FUNCTIONS)
        printed = [figure for figure in mode.ritz if figure is not None]
        # a larger basis of the same kind cannot raise a Ritz frequency
        assert printed == sorted(printed, reverse=True)
        # a dash stands only behind the last figure
        assert mode.ritz == (*printed, *(None,) * (len(FUNCTIONS) - len(printed)))


@pytest.fixture(scope="module")
def scim() -> Ship:
    return read_ship(REPOSITORY / "bodyplans" / "scim-containership" / "ship.toml")


@pytest.mark.parametrize(("folder", "letters"), [("scim-containership", "ab"), ("ds-tanker", "cd"), ("wigley", "")])
def test_only_the_papers_ships_are_recognised(folder: str, letters: str) -> None:
    ship = read_ship(REPOSITORY / "bodyplans" / folder / "ship.toml")
    known = published_ship(ship)
    blocks = [] if known is None else [published_condition(known, condition) for condition in ship.conditions]
    assert "".join(block.letter for block in blocks if block) == letters


@pytest.mark.parametrize(("key", "value"), [("name", "SCIM containership II"), ("depth_m", 19.6), ("draught_m", 13.0)])
def test_another_name_or_particular_makes_another_ship(scim: Ship, key: str, value: object) -> None:
    changed = scim.model_copy(update={"particulars": scim.particulars.model_copy(update={key: value})})
    assert published_ship(scim) is not None
    assert published_ship(changed) is None


def test_another_deadweight_makes_another_condition(scim: Ship) -> None:
    known = published_ship(scim)
    assert known is not None
    loaded = scim.conditions[0]
    assert published_condition(known, loaded) is not None
    assert published_condition(known, loaded.model_copy(update={"deadweight_t": 50000.0})) is None
