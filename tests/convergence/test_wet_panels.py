"""Wet frequencies settle as panels are added: on the paper's ships, and on a hull with a transom and a raked stem."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from floating_bodies import SEMICIRCLE, uniform_girder
from numpy.typing import NDArray

from hullform import read_ship, trace
from hullform.afloat import load_ship
from hullform.in_water import put_in_water
from hullform.pipeline import hull_of
from hullform.ship import Water
from hullform.wetted import wetted_panels, wetted_sections
from hullvib import StodolaRitz, wet

ROOT = Path(__file__).parent.parent.parent


@pytest.mark.parametrize("ship", ["scim-containership", "ds-tanker"])
def test_500_panels_against_2000(ship: str) -> None:
    described = read_ship(ROOT / "bodyplans" / ship / "ship.toml")
    afloat = load_ship(described, hull_of(described, trace(described)))
    for condition in afloat.conditions:
        position = condition.at_rest.position
        run = put_in_water(afloat.hull, afloat.structure, condition.girder, position, Water(), modes=3, functions=12)
        found = []
        for count, girthwise in ((33, 8), (67, 16)):
            panels = wetted_panels(wetted_sections(afloat.hull, position.waterline, count), girthwise)
            flow = replace(run.flow, panels=panels)
            solution = wet.solve(condition.girder, flow, StodolaRitz(shear=True), 3)
            assert solution.modes.method["panels"] == pytest.approx(500 if count == 33 else 2000, rel=0.1)
            found.append(solution.modes.angular_frequencies)
        np.testing.assert_allclose(found[0], found[1], rtol=2e-3, err_msg=condition.condition.name)
        # the run's own thousand lie nearer
        np.testing.assert_allclose(run.shear.modes.angular_frequencies, found[1], rtol=1e-3)


def test_below_a_flat_bottom_500_panels_hold_in_water_of_one_tenth_more_than_her_draught() -> None:
    t = np.linspace(0.0, 1.0, 61)
    angle = np.linspace(0.0, np.pi / 2, 61)
    bottom = np.stack([np.sin(angle) ** (1 / 3), -(np.cos(angle) ** (1 / 3))], axis=-1)
    bottom[0, 0] = bottom[-1, 1] = 0.0
    ends = 12.0 * np.minimum(1.0, np.minimum(0.4 + 3 * t, 0.1 + 4 * (1 - t)))
    sections = wet.Sections(150.0 * t, bottom * np.stack([ends, np.full(61, 8.0)], axis=-1)[:, None])
    girder = uniform_girder(150.0, 150e3, 2e13)

    def frequencies(lengthwise: int, girthwise: int) -> NDArray[np.float64]:
        panels = wet.Panels.from_sections(sections, lengthwise, girthwise)
        return wet.solve(girder, wet.PanelFlow(panels, neutral_axis_m=-2.0, depth_m=8.8), modes=3).modes.frequencies_hz

    # the error falls with the count of panels: what 2000 leave is a quarter of it
    coarse, fine = frequencies(46, 11), frequencies(92, 22)
    assert (np.abs(coarse / (fine + (fine - coarse) / 3) - 1) < 3.5e-3).all()


def test_each_refinement_changes_less() -> None:
    t = np.linspace(0.0, 1.0, 121)
    size = np.stack([14.0 * np.sqrt(np.clip(3 * (1 - t), 0, 1)), 9.0 * np.minimum(1.0, 0.3 + 3.0 * t)], axis=-1)
    sections = wet.Sections(200.0 * t, SEMICIRCLE * size[:, None])
    girder = uniform_girder(200.0, 150e3, 3e13)
    found = np.array(
        [
            wet.solve(
                girder, wet.PanelFlow(wet.Panels.from_sections(sections, *mesh), neutral_axis_m=-2.0), modes=4
            ).modes.angular_frequencies
            for mesh in ((24, 6), (34, 8), (48, 11), (68, 16))
        ]
    )
    steps = np.abs(np.diff(found, axis=0) / found[-1])
    assert (steps[-1] < steps[0]).all()
    assert steps[-1].max() < 1e-3
