"""Wet modes in a run of the ships of bodyplans/: what results.json says of the water, and how sure it is."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hullform import read_ship

ROOT = Path(__file__).parent.parent.parent
SHIPS = ("scim-containership", "ds-tanker", "wigley", "handymax-bulk-carrier", "fast-ropax")
CONDITIONS = [
    (ship, condition.name)
    for ship in SHIPS
    for condition in read_ship(ROOT / "bodyplans" / ship / "ship.toml").conditions
]
Runs = Callable[[str], Any]


def of(finished_run: Runs, ship: str, condition: str) -> dict[str, Any]:
    found: dict[str, Any] = finished_run(ship).results["conditions"][condition]
    return found


@pytest.mark.parametrize(("ship", "condition"), CONDITIONS)
def test_water_lowers_every_frequency_and_keeps_the_nodes(finished_run: Runs, ship: str, condition: str) -> None:
    found = of(finished_run, ship, condition)
    for wet, dry in (("euler", "stodola_ritz"), ("shear", "shear")):
        ratio = np.array(found["wet_rad_s"][wet]) / np.array(found["dry_rad_s"][dry])
        # deep and light ships between them: the water weighs a third of the ship to three times as much
        assert (ratio > 0.45).all()
        assert (ratio < 0.95).all()
        np.testing.assert_allclose(found["in_water"]["frequency_ratios"][wet], ratio, rtol=1e-6)
    assert (np.array(found["wet_rad_s"]["shear"]) < np.array(found["wet_rad_s"]["euler"])).all()
    solution = next(
        one for one in found["solutions"] if one.get("flow") == "panels" and one["theory"] != "Euler-Bernoulli"
    )
    assert solution["medium"] == "wet"
    assert solution["node_counts"] == [2, 3, 4, 5, 6]


@pytest.mark.parametrize(("ship", "condition"), CONDITIONS)
def test_panels_hold_the_displaced_volume(finished_run: Runs, ship: str, condition: str) -> None:
    found = of(finished_run, ship, condition)
    water = found["in_water"]
    assert 900 < water["panels"] < 1200
    assert water["asymmetry"] < 1e-3
    check = next(check for check in found["checks"] if check["id"] == "panel-volume")
    assert check["ok"]
    assert abs(check["value"]) < 0.5


@pytest.mark.parametrize(("ship", "condition"), CONDITIONS)
def test_strips_and_panels_agree_to_three_per_cent_or_the_run_says_so(
    finished_run: Runs, ship: str, condition: str
) -> None:
    found = of(finished_run, ship, condition)
    differences = {
        girder: np.array(found["in_water"]["strips_rad_s"][girder][:3]) / np.array(found["wet_rad_s"][girder][:3]) - 1
        for girder in ("euler", "shear")
    }
    # the headline holds on every ship; the full tanker's blunt ends cost the stiffer girder 4.2 per cent
    assert np.abs(differences["shear"]).max() < 0.03
    largest = max(np.concatenate(list(differences.values())), key=abs)
    check = next(check for check in found["checks"] if check["id"] == "wet-strips")
    assert check["value"] == pytest.approx(100 * largest)
    assert check["ok"] == (abs(largest) <= 0.03) == ((ship, condition) != ("ds-tanker", "loaded"))
    if not check["ok"]:
        assert abs(largest) < 0.045
        assert any("by strips against that by panels: " in doubt for doubt in found["doubts"])


@pytest.mark.parametrize(("ship", "condition"), CONDITIONS)
def test_what_the_water_adds(finished_run: Runs, ship: str, condition: str) -> None:
    water = of(finished_run, ship, condition)["in_water"]
    added, own = np.array(water["generalised_added_mass_kg"]), np.array(water["generalised_mass_kg"])
    assert (added > 0.2 * own).all()
    factors = np.array(water["effective_factors"])
    # the shorter the waves of a mode, the more the water escapes along the hull
    assert (np.diff(factors) < 0).all()
    assert 0.5 < factors[0] < 1.0
    shares = np.array(water["hydrostatic_stiffness_shares"])
    assert (np.diff(shares) < 0).all()
    assert 0.0 < shares[0] < 0.1
    assert water["heave"]["rigid_share"] > 0.99
    assert water["pitch"]["rigid_share"] > 0.99
    assert np.array(water["mac_dry"]).shape == (5, 5)
    edges, force = np.array(water["edges_m"]), np.array(water["force_kg_per_m"])
    assert force.shape == (5, len(edges) - 1)
    assert edges[0] == pytest.approx(water["wet_from_m"])
    assert edges[-1] == pytest.approx(water["wet_to_m"])


def test_light_ships_shapes_change_more_in_water(finished_run: Runs) -> None:
    for ship in SHIPS[:3]:
        light, loaded = (
            np.array(of(finished_run, ship, condition)["in_water"]["mac_dry"])[0, 0]
            for condition in ("light-ship", "loaded")
        )
        assert light < loaded


def test_times_stand_in_provenance(finished_run: Runs) -> None:
    assert finished_run("wigley").results["provenance"]["seconds"]["water"] > 0.0
