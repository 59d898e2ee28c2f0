"""Figures: units on the axes, uniform modes dotted, given axes used."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from hullvib import Girder, PointMass, Ritz, plots, solve

GIRDER = Girder([0, 5, 5, 10], [1e3, 2e3, 3e3, 1e3], [1e9, 2e9, 2e9, 1e9], point_masses=[PointMass(2, 4e3)], name="toy")


def test_mass_and_rigidity_show_both_sides_of_a_jump():
    axes = plots.plot_mass(GIRDER)
    assert axes.get_ylabel() == "mass per length m(x), t/m"
    assert axes.get_xlabel() == "x from the aft end, m"
    x, mass = axes.lines[0].get_data()
    assert mass[np.isclose(x, 5.0)].tolist() == [2.0, 3.0]
    assert axes.texts[0].get_text() == "4 t"
    assert isinstance(axes.figure, Figure)
    rigidity = plots.plot_rigidity(GIRDER)
    assert rigidity.get_ylabel() == "flexural rigidity EI(x), N m²"
    assert rigidity.get_title() == "toy"


def test_modes_are_drawn_with_the_uniform_ones_dotted_in_given_axes():
    figure = Figure()
    axes = figure.subplots()
    modes = solve(GIRDER, Ritz(12), modes=4).normalised("paper")
    assert plots.plot_modes(modes, axes) is axes
    solid = [line for line in axes.lines if line.get_linestyle() == "-" and len(line.get_xdata()) > 2]
    dotted = [line for line in axes.lines if line.get_linestyle() == ":" and len(line.get_xdata()) > 2]
    assert len(solid) == len(dotted) == 3
    for line in [*solid, *dotted]:
        # both in the same normalisation: largest 1, which the grid misses by (h g)^2 / 8
        assert np.abs(line.get_ydata()).max() == pytest.approx(1.0, abs=1e-3)
        assert line.get_ydata()[0] > 0
    assert "largest |amplitude| 1" in axes.get_legend().get_title().get_text()


def test_draw_makes_a_figure_that_can_be_saved(tmp_path):
    figure = plots.draw(lambda axes: plots.plot_modes(solve(GIRDER), axes))
    figure.savefig(tmp_path / "modes.png")
    assert (tmp_path / "modes.png").read_bytes()[:4] == b"\x89PNG"
