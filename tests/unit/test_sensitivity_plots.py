"""Figures of sensitivities: units, signs, jumps."""

import numpy as np
import pytest

from hullvib import Girder, plots, solve
from hullvib.sensitivity import mass_sensitivity

GIRDER = Girder([0, 50, 50, 200], [1e5, 2e5, 3e5, 1e5], [1e13, 2e13, 5e13, 1e13], name="toy")


def test_a_tonne_and_a_plate_are_drawn_in_millihertz():
    modes = solve(GIRDER, modes=4)
    figure = plots.draw_sensitivity(modes)
    upper, lower = figure.axes
    assert upper.get_ylabel() == "change of frequency by\na tonne at x, mHz"
    assert lower.get_ylabel() == "change of frequency by\n1 % of EI over a metre, mHz"
    curves = [[line for line in axes.lines if len(line.get_xdata()) > 2] for axes in (upper, lower)]
    assert [len(lines) for lines in curves] == [3, 3]
    x, values = curves[0][1].get_data()
    assert values == pytest.approx(mass_sensitivity(modes, x)[1] * 1e6 / (2 * np.pi), rel=1e-12)
    assert values.max() <= 0
    for line in curves[1]:
        assert line.get_ydata().min() >= 0
    # both sides of the jump of EI: 1 % of EI times (M / EI)^2 falls with 1 / EI
    x, values = curves[1][0].get_data()
    aft, fore = np.abs(x - 50.0 + 2e-5).argmin(), np.abs(x - 50.0 - 2e-5).argmin()
    assert values[aft] / values[fore] == pytest.approx(2.5, rel=1e-4)
    assert "mode 2" in upper.get_legend().get_texts()[1].get_text()
