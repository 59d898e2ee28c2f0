"""Water with a bottom, as `[water] depth_m` gives it: lower frequencies, no strips, and never aground."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from hullform.afloat import ShipAfloat, load_ship
from hullform.errors import HullError, ShipFileError
from hullform.in_water import InWater, put_in_water
from hullform.pipeline import hull_of, trace
from hullform.ship import Water, read_ship

DRAUGHT_M = 8.0
TOML = """
schema = 1
[ship]
name = "a ship"
type = "tanker"
length_overall_m = 150.0
length_between_perpendiculars_m = 150.0
breadth_m = 24.0
depth_m = 12.0
draught_m = 8.0
block_coefficient = 0.78
[structure]
shell_thickness_m = 0.02
[weights]
steel_weight_t = 4500.0
semi_concentrated_weight_t = 800.0
[[conditions]]
name = "loaded"
deadweight_t = 17700.0
draught_aft_m = 8.0
draught_fore_m = 8.0
"""


def afloat(folder: Path, more: str = "") -> ShipAfloat:
    file = folder / "ship.toml"
    file.write_text(TOML + more, encoding="utf-8")
    ship = read_ship(file)
    return load_ship(ship, hull_of(ship, trace(ship)))


@pytest.fixture(scope="module")
def ship(tmp_path_factory: pytest.TempPathFactory) -> ShipAfloat:
    return afloat(tmp_path_factory.mktemp("ship"))


def wet_in(ship: ShipAfloat, depth_m: float | None, **water: Any) -> InWater:
    (condition,) = ship.conditions
    return put_in_water(
        ship.hull,
        ship.structure,
        condition.girder,
        condition.at_rest.position,
        Water(depth_m=depth_m, **water),
        modes=3,
        functions=8,
    )


def test_frequencies_fall_as_the_bottom_comes_near(ship: ShipAfloat) -> None:
    deep = wet_in(ship, None)
    found = [wet_in(ship, depth * DRAUGHT_M).shear.modes.angular_frequencies for depth in (40.0, 3.0, 1.5, 1.2)]
    # images fade by the cube of the depth
    assert found[0] == pytest.approx(deep.shear.modes.angular_frequencies, rel=1e-4)
    for shallower, deeper in zip(found[1:], found, strict=False):
        assert (shallower < deeper).all()
    # squeezed through a gap of a fifth of the draught under a flat bottom, the water about doubles the moving mass
    assert (found[-1] < 0.8 * found[0]).all()


def test_strips_have_no_bottom_and_are_left_out(ship: ShipAfloat) -> None:
    deep, shallow = wet_in(ship, None), wet_in(ship, 12.0)
    assert [check.id for check in deep.checks] == ["panel-volume", "wet-strips"]
    assert [check.id for check in shallow.checks] == ["panel-volume", "clearance"]
    assert (deep.depth_m, shallow.depth_m) == (None, 12.0)
    assert deep.strips_shear is not None
    assert shallow.strips_shear is None
    # over the sections in deep water: the bottom adds to it
    assert (shallow.effective_factors > deep.effective_factors).all()


@pytest.mark.parametrize(("depth_m", "ok"), [(8.7, False), (8.9, True)])
def test_a_gap_narrower_than_the_panels_is_told(ship: ShipAfloat, depth_m: float, ok: bool) -> None:
    # she draws 8 m: 1.1 draughts are 8.8 m
    (clearance,) = (check for check in wet_in(ship, depth_m).checks if check.id == "clearance")
    assert clearance.ok is ok


@pytest.mark.parametrize("depth_m", [5.0, 7.99])
def test_she_does_not_sail_aground(ship: ShipAfloat, depth_m: float) -> None:
    with pytest.raises(HullError, match=rf"depth_m = {depth_m:g}: she reaches 8.00 m down.*leave depth_m out"):
        wet_in(ship, depth_m)


def test_a_depth_is_above_nought(tmp_path: Path) -> None:
    with pytest.raises(ShipFileError, match=r"water.depth_m = -3"):
        afloat(tmp_path, "[water]\ndepth_m = -3.0\n")
    assert math.isclose(
        afloat(tmp_path, "[water]\ndepth_m = 20.0\n").conditions[0].at_rest.position.volume_m3, 22464, rel_tol=0.01
    )


def test_draughts_that_no_depth_has_are_told_with_their_condition(tmp_path: Path) -> None:
    file = tmp_path / "ship.toml"
    file.write_text(TOML.replace("draught_aft_m = 8.0", "draught_aft_m = 30.0"), encoding="utf-8")
    ship = read_ship(file)
    with pytest.raises(HullError, match=r"ship.toml: condition 'loaded', mean of draught_aft_m and .* draught 19 m"):
        load_ship(ship, hull_of(ship, trace(ship)))
