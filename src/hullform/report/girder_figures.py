"""Figures of the girder: mass and stiffness along the ship, mode shapes, convergence."""

from __future__ import annotations

import itertools

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

from hullform.outcome import ConditionRun, Run
from hullform.report.drawing import (
    ACCENT,
    INK,
    ITEM_COLOURS,
    PAGE_WIDTH,
    QUIET,
    SERIES,
    WARM,
    WEIGHT_COLOURS,
    Picture,
    as_svg,
    finish,
)
from hullform.rounding import significant
from hullvib.plots import plot_modes

SHOWN_MODES = 3
PANELS_ABREAST = 3
# Of the figure of mass, in inches: one panel, what its title and the figures of its axis need, a row of its legend.
PANEL_HEIGHT, PANEL_GAP, TITLE_HEIGHT, LEGEND_ROW = 1.75, 0.8, 0.28, 0.19
LEGEND_COLUMNS = 3
# A difference below this, in per cent, is round-off and has no place on a logarithmic axis.
SMALLEST_SHOWN_PERCENT = 1e-8


def mass_figure(run: Run) -> Picture:
    """m(x) of every condition, its weights stacked (the paper's figures 1 and 3, a)."""
    conditions = list(run.conditions.values())
    weights = [[item for item in condition.items if item.mass_kg > 0.0] for condition in conditions]
    # each panel with its legend below it, as high as the weights need
    legends = [LEGEND_ROW * -(-(len(items) + 1) // LEGEND_COLUMNS) for items in weights]
    height = sum(legends) + len(conditions) * (PANEL_HEIGHT + PANEL_GAP)
    figure = Figure(figsize=(PAGE_WIDTH, height))
    foot = height
    for condition, items, legend in zip(conditions, weights, legends, strict=True):
        foot -= PANEL_HEIGHT + PANEL_GAP + legend
        axes = figure.add_axes((0.075, (foot + PANEL_GAP - TITLE_HEIGHT + legend) / height, 0.9, PANEL_HEIGHT / height))
        breaks = condition.girder.breaks
        x = np.repeat(breaks, 2)[1:-1]
        below = np.zeros(x.size)
        others = itertools.cycle(ITEM_COLOURS)
        for item in items:
            left, right = item.at_piece_ends(breaks)
            above = below + np.column_stack([left, right]).ravel() / 1e3
            label = f"{item.name}, {significant(item.mass_kg / 1e3)} t"
            colour = WEIGHT_COLOURS.get(item.name) or next(others)
            axes.fill_between(x, below, above, color=colour, linewidth=0, label=label)
            below = above
        axes.plot(x, below, color=INK, linewidth=1.1, label="m(x)")
        finish(axes, "x from the aft end, m", "m(x), t/m", condition.girder.length)
        axes.set_ylim(0.0, 1.06 * float(below.max()))
        axes.set_title(f"{condition.condition.title}, {significant(condition.mass_kg / 1e3)} t")
        handles, labels = axes.get_legend_handles_labels()
        axes.legend(
            handles,
            labels,
            loc="upper left",
            bbox_to_anchor=(0.0, -0.45 / PANEL_HEIGHT),
            ncols=LEGEND_COLUMNS,
            handlelength=1.2,
            borderaxespad=0.0,
            fontsize="small",
        )
    return as_svg(
        figure,
        "mass",
        "Mass per length m(x) of each condition, by class of weight (as the paper's Figs. 1a and 3a).",
        "Mass per length along the ship, stacked by class: steel, machinery aft, deck machinery forward, deadweight.",
    )


def structure_figure(run: Run) -> Picture:
    """I(x), A(x), the shear area and the neutral axis (the paper's figures 1 and 3, b, and what shear needs)."""
    structure, length = run.structure, run.hull.length_overall_m
    figure = Figure(figsize=(PAGE_WIDTH, 6.7))
    second_moment, area, shear, axis = figure.subplots(4, 1, sharex=True, height_ratios=[1.6, 1, 1, 1])
    figure.subplots_adjust(left=0.075, right=0.925, top=0.99, bottom=0.07, hspace=0.16)
    for axes, values, label in (
        (second_moment, structure.second_moment_m4, "I(x), m⁴"),
        (area, structure.area_m2, "A(x), m²"),
        (shear, structure.shear_area_m2, "Aₛ(x), m²"),
    ):
        axes.fill_between(structure.x_m, values, color=ACCENT, alpha=0.14, linewidth=0)
        axes.plot(structure.x_m, values, color=ACCENT, linewidth=1.5)
        finish(axes, "", label, length)
        axes.set_ylim(0.0, 1.1 * float(values.max()))
    giganewtons_per_m2 = structure.shear_modulus_pa / 1e9
    rigidity = shear.secondary_yaxis(
        "right", functions=(lambda area_m2: giganewtons_per_m2 * area_m2, lambda force: force / giganewtons_per_m2)
    )
    rigidity.set_ylabel("kGA(x), GN")
    rigidity.spines["right"].set_visible(False)
    hull = run.hull
    axis.fill_between(hull.x_m, hull.keel_height_m, hull.top_height_m, color=QUIET, alpha=0.14, linewidth=0)
    axis.plot(hull.x_m, hull.top_height_m, color=QUIET, linewidth=0.9)
    axis.plot(hull.x_m, hull.keel_height_m, color=QUIET, linewidth=0.9)
    axis.plot(structure.x_m, structure.neutral_axis_m, color=WARM, linewidth=1.5, label="neutral axis")
    finish(axis, "x from the aft end, m", "z, m", length)
    axis.set_ylim(bottom=min(0.0, float(hull.keel_height_m.min())))
    axis.legend(loc="lower center")
    return as_svg(
        figure,
        "structure",
        "Second moment I(x) and area A(x) of the section with the equivalent-thickness factor (as the paper's Figs. 1b "
        "and 3b), its shear area Aₛ(x) with the shear factor and the shear rigidity kGA(x) = G Aₛ(x), and the "
        "height of its neutral axis within the hull's profile.",
        f"Second moment of area along the ship, largest {significant(structure.second_moment_m4.max())} m⁴, with the "
        "section's area, shear area and neutral axis below.",
    )


def modes_figure(condition: ConditionRun) -> Picture:
    """The first three Euler-Bernoulli shapes, nodes marked, the uniform beam's dotted (the paper's figures 2 and 4)."""
    modes = condition.euler_modes
    figure = Figure(figsize=(PAGE_WIDTH, 3.7))
    axes = figure.subplots()
    figure.subplots_adjust(left=0.075, right=0.975, top=0.98, bottom=0.325)
    plot_modes(modes, axes, SHOWN_MODES)
    axes.set_title("")
    for positions in modes.nodes()[:SHOWN_MODES]:
        axes.plot(positions, np.zeros(len(positions)), "o", color="white", markeredgecolor=INK, markersize=4.2)
    title = condition.condition.title
    return as_svg(
        figure,
        f"modes-{condition.condition.name}",
        f"First three modes, {title}, Euler-Bernoulli; the uniform beam's dotted, nodes circled (as the "
        f"paper's Figs. 2 and 4). Each shape is scaled to {modes.normalisation_note}.",
        f"Shapes of modes 1 to 3 along the ship, {title}, over those of the uniform beam.",
    )


def headline_modes_figure(run: Run) -> Picture:
    """The shapes of the headline, in water with shear deflection, over the same girder's dry ones."""
    conditions = list(run.conditions.values())
    figure, panels = _panels(len(conditions))
    x = np.linspace(0.0, run.hull.length_overall_m, 301)
    for axes, condition in zip(panels, conditions, strict=True):
        for mode in range(SHOWN_MODES):
            colour = SERIES[mode % len(SERIES)]
            axes.plot(x, condition.modes.shape(x)[mode], color=colour, linewidth=1.4, label=f"mode {mode + 1}")
            axes.plot(x, condition.dry_modes.shape(x)[mode], color=colour, linewidth=1.0, linestyle=":")
        axes.axhline(0.0, color=QUIET, linewidth=0.8, zorder=0)
        finish(axes, "x from the aft end, m", "", run.hull.length_overall_m)
        axes.set_ylim(-1.15, 1.15)
        axes.set_title(condition.condition.title)
    for axes in panels[::PANELS_ABREAST]:
        axes.set_ylabel("mode shape Φ(x), –")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=SHOWN_MODES)
    return as_svg(
        figure,
        "modes-with-shear",
        "Shapes of the headline, in water with shear deflection; dotted the same girder's, dry. "
        f"Each shape is scaled to {conditions[0].modes.normalisation_note}.",
        "Shapes of modes 1 to 3 along the ship in each condition, in water and dry.",
    )


def convergence_figure(run: Run) -> Picture:
    """How far above the Stodola-Ritz frequency plain Ritz lies with each number of trial functions."""
    conditions = list(run.conditions.values())
    figure, panels = _panels(len(conditions))
    for axes, condition in zip(panels, conditions, strict=True):
        numbers = sorted(condition.convergence_rad_s)
        frequencies = np.array([condition.convergence_rad_s[n] for n in numbers])
        sharper = condition.solutions["stodola_ritz"].angular_frequencies[: frequencies.shape[1]]
        above = 100 * (frequencies / sharper - 1)
        shown = np.where(above > SMALLEST_SHOWN_PERCENT, above, np.nan)
        for mode in range(frequencies.shape[1]):
            colour = SERIES[mode % len(SERIES)]
            axes.plot(
                numbers,
                shown[:, mode],
                "o-",
                color=colour,
                linewidth=1.2,
                markersize=3.5,
                label=f"mode {mode + 1}",
            )
        axes.set_yscale("log")
        axes.yaxis.set_minor_locator(NullLocator())
        finish(axes, "elastic trial functions N", "", None)
        axes.set_title(condition.condition.title)
    for axes in panels[::PANELS_ABREAST]:
        axes.set_ylabel("above Stodola-Ritz, %")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=SHOWN_MODES)
    return as_svg(
        figure,
        "convergence",
        "Euler-Bernoulli girder: plain Ritz with N elastic trial functions and the two rigid-body ones, above "
        "Stodola-Ritz.",
        "Differences fall as trial functions are added, mode 1 fastest.",
    )


def _panels(count: int) -> tuple[Figure, list[Axes]]:
    """A figure with one panel a condition, `PANELS_ABREAST` in a row, and room for a legend below them."""
    columns = min(PANELS_ABREAST, count)
    rows = -(-count // columns)
    height = 2.7 * rows + 0.25
    figure = Figure(figsize=(PAGE_WIDTH, height))
    panels = figure.subplots(rows, columns, sharey=True, squeeze=False).ravel()
    figure.subplots_adjust(
        left=0.085, right=0.975, top=1 - 0.27 / height, bottom=0.71 / height, wspace=0.08, hspace=0.4
    )
    for unused in panels[count:]:
        unused.set_axis_off()
    return figure, list(panels[:count])
