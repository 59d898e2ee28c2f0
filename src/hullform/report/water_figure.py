"""The water about the ship: her wetted panels' added mass along her, mode by mode."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from hullform.outcome import ConditionRun
from hullform.report.drawing import INK, PAGE_WIDTH, QUIET, SERIES, Picture, as_svg, finish

SHOWN_MODES = 3
TONNES = 1e3


def added_mass_figure(condition: ConditionRun) -> Picture:
    """Added mass per length of each mode, with the strips' without correction and the ship's own mass."""
    water, title = condition.in_water, condition.condition.title
    shear, length = water.shear, condition.girder.length
    edges = shear.added_mass.edges_m
    middle = 0.5 * (edges[1:] + edges[:-1])
    figure = Figure(figsize=(PAGE_WIDTH, 2.9))
    axes = figure.subplots()
    figure.subplots_adjust(left=0.08, right=0.975, top=0.97, bottom=0.305)
    x = np.linspace(0.0, length, 400)
    axes.plot(
        x, condition.girder.mass_per_length(x) / TONNES, color=QUIET, linewidth=1.0, label="mass of the ship, m(x)"
    )
    strips = water.strips
    label = "added mass of a section in two dimensions"
    axes.plot(
        strips.sections.x_m, strips.section_kg_per_m / TONNES, color=INK, linestyle=":", linewidth=1.3, label=label
    )
    along = shear.added_mass_per_length()
    for mode in range(SHOWN_MODES):
        colour = SERIES[mode % len(SERIES)]
        axes.plot(middle, along[mode] / TONNES, color=colour, linewidth=1.4, label=f"added mass in mode {mode + 1}")
    # a mode's figure grows without bound towards its nodes: the most of it, not all, has room
    most = float(np.nanpercentile(along[:SHOWN_MODES], 90))
    own = float(condition.girder.mass_per_length(x).max())
    top = max(float(strips.section_kg_per_m.max()), own, most) / TONNES
    axes.set_ylim(0.0, 1.1 * top)
    finish(axes, "x from the aft end, m", "mass per length, t/m", length)
    figure.legend(*axes.get_legend_handles_labels(), loc="lower center", ncols=3)
    return as_svg(
        figure,
        f"added-mass-{condition.condition.name}",
        f"Added mass along the ship, {title}: the water's vertical force over the hull's acceleration there, in each "
        "mode with shear; left out where the mode hardly moves, about its nodes. It falls as the waves of the mode "
        "shorten.",
        f"Added mass per length of modes 1 to 3 along the ship, {title}, below that of her sections in two dimensions.",
    )
