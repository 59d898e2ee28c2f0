"""Weights and buoyancy of the drawn ships in results.json: they balance, at a waterline that may be."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hullform import read_ship

ROOT = Path(__file__).parent.parent.parent
CONDITIONS = [
    (path.parent.name, condition.name)
    for path in sorted((ROOT / "bodyplans").glob("*/ship.toml"))
    for condition in read_ship(path).conditions
]
Runs = Callable[[str], Any]


@pytest.mark.parametrize(("ship", "condition"), CONDITIONS)
def test_shear_force_and_bending_moment_close_at_the_fore_end(finished_run: Runs, ship: str, condition: str) -> None:
    found = finished_run(ship).results["conditions"][condition]
    still = found["still_water"]
    assert still["equilibrium"]
    # both are integrated exactly, and the equilibrium is found to round-off
    assert still["closing_shear"] < 1e-10
    assert still["closing_moment"] < 1e-10
    assert found["equilibrium"]["displacement_kg"] == pytest.approx(found["mass_kg"], rel=1e-12)
    # the girder's breakpoints lie within millimetres of the weights' own
    assert found["equilibrium"]["lcb_m"] == pytest.approx(found["lcg_m"], abs=2e-3)


@pytest.mark.parametrize(("ship", "condition"), CONDITIONS)
def test_the_curves_are_each_others_integrals(finished_run: Runs, ship: str, condition: str) -> None:
    results = finished_run(ship).results["conditions"][condition]
    still = results["still_water"]
    x, weight, buoyancy, shear, moment = (
        np.array(still[key])
        for key in ("x_m", "weight_n_per_m", "buoyancy_n_per_m", "shear_force_curve_n", "bending_moment_curve_n_m")
    )
    load = weight - buoyancy
    step = np.diff(x)
    # where x stands twice, point masses; a trapezoid of a quadratic misses h^2 / 12 of the change of slope over it,
    # which is no more than that from one of its neighbours to the other, of weight and buoyancy each
    rise = np.where(step > 0, step * (load[1:] + load[:-1]) / 2, np.diff(shear))
    summed = shear[0] + np.concatenate([[0.0], np.cumsum(rise)])
    pieces = step > 0
    slopes = np.array([np.diff(curve)[pieces] / step[pieces] for curve in (weight, buoyancy)])
    turn = np.abs(np.diff(slopes, axis=1, prepend=slopes[:, :1], append=slopes[:, -1:])).sum(axis=0)
    missed = step[pieces] ** 2 / 12 * (turn[1:] + turn[:-1])
    assert np.abs(summed - shear).max() < missed.sum()
    # the shear force is a cubic in each, of whose integral the loads at both ends leave nothing over
    area = step * (shear[1:] + shear[:-1]) / 2 + step**2 / 12 * (load[:-1] - load[1:])
    bent = moment[0] + np.concatenate([[0.0], np.cumsum(area)])
    assert np.abs(bent - moment).max() < 1e-9 * np.abs(moment).max()
    assert still["bending_moment_n_m"]["maximum"] >= moment.max()
    assert still["shear_force_n"]["minimum"] <= shear.min()


def test_a_ship_within_the_limits_of_trim_takes_her_equilibrium(finished_run: Runs) -> None:
    found = finished_run("ds-tanker").results["conditions"]["ballast"]
    assert found["draughts_from"] == "equilibrium"
    assert found["draughts_reason"] == ""
    assert found["draughts"]["aft_m"] == found["equilibrium"]["draught_aft_m"]
    assert found["draughts"]["aft_m"] > found["draughts"]["fore_m"]


@pytest.mark.parametrize(
    ("ship", "condition", "reason"),
    [
        ("scim-containership", "loaded", "limit −0.5 % of LPP"),
        ("ds-tanker", "light-ship", "limit 1.5 % of LPP"),
        ("wigley", "loaded", "deck above the waterline"),
    ],
)
def test_a_ship_beyond_them_is_put_on_even_keel(finished_run: Runs, ship: str, condition: str, reason: str) -> None:
    found = finished_run(ship).results["conditions"][condition]
    assert found["draughts_from"] == "even keel"
    assert reason in found["draughts_reason"]
    assert found["draughts"]["aft_m"] == found["draughts"]["fore_m"] == found["hydrostatics"]["draught_m"]
    assert found["doubts"]


@pytest.mark.parametrize(("ship", "condition"), CONDITIONS)
def test_the_report_draws_it_for_every_condition(finished_run: Runs, ship: str, condition: str) -> None:
    folder = finished_run(ship).folder
    text = (folder / "figures" / f"still-water-{condition}.svg").read_text(encoding="utf-8")
    for label in ("weight, buoyancy, t/m", "V(x), MN", "M(x), MN m", "x from the aft end, m"):
        assert label in text
    assert f'id="figure-still-water-{condition}"' in (folder / "report.html").read_text(encoding="utf-8")
