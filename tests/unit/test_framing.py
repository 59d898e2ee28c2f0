"""The plates that [structure] puts into one section: what is clipped, cut and thickened."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from hullform.loading.framing import Frame, Plating, member_names, platings_of
from hullform.ship_structure import StructureInput

# a box of half-breadth 10 and depth 8, and a flared section whose side leans out from 4 at the keel's end to 10
BOX = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 8.0]])
FLARED = np.array([[0.0, 0.0], [4.0, 0.0], [10.0, 8.0]])


def plated(contour: np.ndarray = BOX, x_m: float = 50.0, **keys: Any) -> list[Plating]:
    return platings_of(StructureInput.model_validate(keys), Frame(x_m, contour, 10.0))


def ends(platings: list[Plating], name: str) -> list[list[list[float]]]:
    return [plating.points[[0, -1]].tolist() for plating in platings if plating.name == name]


def test_without_keys_there_is_bottom_side_and_deck() -> None:
    found = plated()
    assert [plating.name for plating in found] == ["bottom", "side", "deck"]
    assert sum(plating.length_m for plating in found) == pytest.approx(10 + 8 + 10)
    assert {plating.scantling.thickness_m for plating in found} == {0.016}


def test_a_steep_bottom_is_side() -> None:
    sharp = np.array([[0.0, 0.0], [1.0, 5.0], [3.0, 8.0]])
    assert [plating.name for plating in plated(sharp)] == ["side", "deck"]


def test_a_hatch_takes_the_deck_from_the_centre_line_out() -> None:
    keys: dict[str, Any] = {"hatches": [{"from_m": 40.0, "to_m": 60.0, "breadth_m": 15.0}]}
    assert ends(plated(**keys), "deck") == [[[7.5, 8.0], [10.0, 8.0]]]
    assert ends(plated(x_m=61.0, **keys), "deck") == [[[0.0, 8.0], [10.0, 8.0]]]
    narrow = FLARED * [0.7, 1.0]
    assert ends(plated(narrow, **keys), "deck") == []


def test_members_end_at_the_shell() -> None:
    keys: dict[str, Any] = {
        "inner_bottom": {"height_m": 2.0},
        "double_side": {"breadth_m": 1.0},
        "decks": [{"height_m": 6.0}],
        "longitudinal_bulkheads": [{"y_m": 7.0}],
    }
    found = plated(FLARED, **keys)
    # the side is at y = 4 + 6 z / 8
    assert ends(found, "inner bottom") == [[[0.0, 2.0], [5.5, 2.0]]]
    assert ends(found, "deck at 6 m") == [[[0.0, 6.0], [8.5, 6.0]]]
    assert np.array(ends(found, "bulkhead at 7 m")[0]) == pytest.approx(np.array([[7.0, 4.0], [7.0, 8.0]]))
    assert np.array(ends(found, "inner side")[0]) == pytest.approx(np.array([[9.0, 20 / 3], [9.0, 8.0]]))
    assert member_names(StructureInput.model_validate(keys)) == {plating.name for plating in found} - {
        "bottom",
        "side",
        "deck",
    }


def test_the_inner_skin_stands_on_the_inner_bottom() -> None:
    found = plated(inner_bottom={"height_m": 2.0}, double_side={"breadth_m": 1.5})
    assert ends(found, "inner side") == [[[8.5, 2.0], [8.5, 8.0]]]


def test_members_without_room_are_left_out() -> None:
    found = plated(
        FLARED * [0.3, 1.0], inner_bottom={"height_m": 9.0}, double_side={"breadth_m": 1.0}, decks=[{"height_m": 8.0}]
    )
    assert [plating.name for plating in found] == ["bottom", "side", "deck"]


def test_a_bulkhead_where_the_side_comes_back_in_keeps_to_the_upper_stretch() -> None:
    # narrow waist at z = 4: at y = 5 the section is inside below z = 2.67 and above z = 5.33
    waist = np.array([[0.0, 0.0], [7.0, 0.0], [7.0, 2.0], [1.0, 4.0], [7.0, 6.0], [7.0, 8.0]])
    found = plated(waist, longitudinal_bulkheads=[{"y_m": 5.0}])
    assert np.array(ends(found, "bulkhead at 5 m")[0]) == pytest.approx(np.array([[5.0, 16 / 3], [5.0, 8.0]]))


def test_zones_part_the_side_by_height_and_the_last_one_holds() -> None:
    found = plated(
        zones=[
            {"part": "side", "thickness_m": 0.02},
            {"part": "side", "thickness_m": 0.03, "from_height_m": 6.5, "stiffener_share": 0.2},
            {"part": "side", "thickness_m": 0.05, "from_m": 70.0},
        ]
    )
    side = [(plating.scantling.thickness_m, plating.length_m) for plating in found if plating.name == "side"]
    assert side == [(0.02, pytest.approx(6.5)), (0.03, pytest.approx(1.5))]
    assert found[2].scantling.stiffener_share == 0.2


def test_a_house_stands_on_the_deck_and_is_no_wider() -> None:
    found = plated(FLARED, superstructures=[{"height_m": 3.0, "breadth_m": 30.0, "effective_share": 0.4}])
    assert ends(found, "superstructure") == [[[10.0, 8.0], [10.0, 11.0]], [[0.0, 11.0], [10.0, 11.0]]]
    assert found[-1].scantling.effective_share == 0.4


def test_only_a_member_in_the_centre_plane_is_one_plate() -> None:
    found = plated(longitudinal_bulkheads=[{"y_m": 0.0}, {"y_m": 3.0}])
    assert [plating.name for plating in found if plating.on_centre_line] == ["bulkhead on the centre line"]
    assert not any(plating.on_centre_line for plating in plated(BOX * [0.0, 1.0]) if plating.shell)
