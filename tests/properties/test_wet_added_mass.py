"""Laws that added mass keeps on hulls of any form: symmetric, positive, more of it as the bottom comes near."""

from itertools import pairwise

import numpy as np
import pytest
from floating_bodies import UniformMotions
from hypothesis import given, settings
from hypothesis import strategies as st

from hullvib import wet

LENGTH = 100.0


@st.composite
def hulls(draw):
    """Fine to full sections that swell and shrink from end to end; transoms and stems among them."""
    count = 15
    t = np.linspace(0.0, 1.0, count)
    aft, fore = draw(st.floats(0.0, 0.8)), draw(st.floats(0.0, 0.8))
    swell = np.minimum(1.0, np.minimum(aft + (1 - aft) * 3 * t, fore + (1 - fore) * 4 * (1 - t)))
    breadth, draught = draw(st.floats(6.0, 25.0)), draw(st.floats(2.0, 10.0))
    power = draw(st.floats(0.7, 8.0))
    angle = np.linspace(0.0, np.pi / 2, 31)
    curve = np.stack([np.sin(angle) ** (2 / power), -(np.cos(angle) ** (2 / power))], axis=-1)
    curve[0, 0], curve[-1, 1] = 0.0, 0.0
    size = np.stack([0.5 * breadth * swell, draught * (0.5 + 0.5 * swell)], axis=-1)
    return wet.Sections(LENGTH * t, size[:, None] * curve)


@given(sections=hulls(), axis=st.floats(-5.0, 10.0))
@settings(max_examples=15, deadline=None)
def test_symmetric_and_positive(sections, axis):
    panels = wet.Panels.from_sections(sections, 20, 6)
    motions = UniformMotions(LENGTH, 6)
    flows = (
        wet.PanelFlow(panels, neutral_axis_m=axis),
        wet.StripFlow(sections),
        wet.StripFlow(sections, "lewis", "townsin"),
    )
    for flow in flows:
        found = flow.added_mass(motions)
        assert (found.matrix == found.matrix.T).all()
        assert np.linalg.eigvalsh(found.matrix).min() > 0.0
        springs = flow.hydrostatic_stiffness(motions)
        assert np.linalg.eigvalsh(springs).min() > -1e-9 * springs.max()
    assert flows[0].added_mass(motions).asymmetry < 0.03


@given(sections=hulls())
@settings(max_examples=8, deadline=None)
def test_a_rigid_bottom_only_adds(sections):
    panels = wet.Panels.from_sections(sections, 16, 5)
    motions = UniformMotions(LENGTH, 3)
    deepest = float(sections.draught_m.max())
    matrices = [
        wet.PanelFlow(panels, neutral_axis_m=0.0, depth_m=share * deepest).added_mass(motions).matrix
        for share in (np.inf, 10.0, 4.0, 2.0, 1.5)
    ]
    for deeper, shallower in pairwise(matrices):
        # the difference is positive too: no motion at all loses
        assert np.linalg.eigvalsh(shallower - deeper).min() > -1e-3 * deeper.max()
        assert (shallower.diagonal() > deeper.diagonal()).all()


def test_added_mass_goes_with_the_density_and_the_cube_of_the_size():
    angle = np.linspace(0.0, np.pi / 2, 21)
    half = np.stack([5 * np.sin(angle), -5 * np.cos(angle)], axis=-1)
    half[-1, 1] = 0.0
    one = wet.Sections([0.0, 50.0, 100.0], np.stack([0.5 * half, half, 0.5 * half]))
    two = wet.Sections(2 * one.x_m, 2 * one.points_m)
    small = wet.PanelFlow(wet.Panels.from_sections(one, 20, 6), neutral_axis_m=-1.0)
    large = wet.PanelFlow(wet.Panels.from_sections(two, 20, 6), neutral_axis_m=-2.0, density_kg_m3=500.0)
    ratio = large.added_mass(UniformMotions(200.0, 3)).matrix / small.added_mass(UniformMotions(100.0, 3)).matrix
    assert ratio.diagonal() == pytest.approx(8 * 500 / 1025, rel=1e-6)


def test_a_bottom_under_a_broad_box_matches_the_narrow_gap():
    """h / T near 1: the water under a flat bottom must flow out sideways, m = rho B^3 / (12 (h - T)) a length."""
    length, breadth, draught = 400.0, 40.0, 10.0
    gap = 2.0
    half = np.array([[0.0, -draught], [breadth / 2, -draught], [breadth / 2, 0.0]])
    panels = wet.Panels.from_sections(wet.Sections([0.0, length], [half, half]), 80, 14)
    heave = [
        wet.PanelFlow(panels, neutral_axis_m=0.0, depth_m=draught + g)
        .added_mass(UniformMotions(length, 1))
        .matrix[0, 0]
        for g in (gap, 1.5 * gap)
    ]
    gaps = [1025.0 * breadth**3 / (12.0 * g) * length for g in (gap, 1.5 * gap)]
    # what is common to both (the water beside and beyond the gap) drops out of the difference
    assert heave[0] - heave[1] == pytest.approx(gaps[0] - gaps[1], rel=0.15)
