"""Figures of the body plan and the hull's areas."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from hullform.body_plan import Half
from hullform.outcome import Run
from hullform.report.drawing import ACCENT, PAGE_WIDTH, QUIET, SERIES, WARM, Picture, as_svg, finish
from hullform.report.wording import words_of_form
from hullform.rounding import significant
from hullform.ship_body_plan import PictureSource

FIT_POINTS = 80
FIT_WIDTH = 4.0
FIT_ALPHA = 0.38
# Inches: the drawing keeps its proportions, so the figure's height follows from the ship.
LEFT_MARGIN = 0.62
RIGHT_MARGIN = 0.1
BODY_PLAN_FOOT = 0.75
# Of the area curves: columns of the legend, and the height of its rows in inches.
LEGEND_COLUMNS, LEGEND_ROW = 4, 0.24
HALF_COLOURS: dict[Half, str] = {"aft": WARM, "fore": ACCENT}


def body_plan_figure(run: Run) -> Picture:
    """Every station as traced, in thin black, over the curves that stand for it, in colour."""
    particulars = run.ship.particulars
    source = run.ship.body_plan
    aft_sign = 1.0 if isinstance(source, PictureSource) and source.aft_side == "right" else -1.0
    side: dict[Half, float] = {"aft": aft_sign, "fore": -aft_sign}
    across = 1.17 * particulars.breadth_m
    lowest, highest = -0.04 * particulars.depth_m, 1.04 * float(run.hull.top_height_m.max())
    drawn_width = PAGE_WIDTH - LEFT_MARGIN - RIGHT_MARGIN
    drawn_height = drawn_width * (highest - lowest) / across
    height = drawn_height + BODY_PLAN_FOOT + RIGHT_MARGIN
    figure = Figure(figsize=(PAGE_WIDTH, height))
    axes = figure.add_axes(
        (LEFT_MARGIN / PAGE_WIDTH, BODY_PLAN_FOOT / height, drawn_width / PAGE_WIDTH, drawn_height / height)
    )
    for station in run.hull.fits:
        contours = () if station.model is None else station.model.contours
        if station.fit is not None:
            contours = (station.fit.points(FIT_POINTS),)
        colour = HALF_COLOURS[station.half]
        for y, z in (points.T for points in contours):
            across_half = side[station.half] * y
            axes.plot(across_half, z, color=colour, linewidth=FIT_WIDTH, alpha=FIT_ALPHA, solid_capstyle="round")
    for drawn in run.body_plan.stations:
        for curve in drawn.curves:
            y = side[drawn.half] * curve.half_breadth_m
            axes.plot(y, curve.height_m, color="black", linewidth=0.7)
    axes.axvline(0.0, color=QUIET, linewidth=0.8, linestyle=(0, (8, 3, 2, 3)))
    axes.axhline(particulars.draught_m, color=QUIET, linewidth=0.8, linestyle=(0, (5, 3)))
    axes.annotate(
        f"T {particulars.draught_m:g} m", (across / 2, particulars.draught_m), (-2, 3),
        textcoords="offset points", ha="right", fontsize=8,
    )  # fmt: skip
    axes.plot([], [], color="black", linewidth=0.7, label=f"stations, {words_of_form(run).stations}")
    axes.plot([], [], color=HALF_COLOURS["aft"], linewidth=FIT_WIDTH, alpha=FIT_ALPHA, label="model, aft half")
    axes.plot([], [], color=HALF_COLOURS["fore"], linewidth=FIT_WIDTH, alpha=FIT_ALPHA, label="model, fore half")
    axes.set_xlim(-across / 2, across / 2)
    axes.set_ylim(lowest, highest)
    finish(axes, "y from the centre line, m", "z above the base line, m")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.42 / drawn_height), ncols=3)
    return as_svg(
        figure,
        "body-plan-fit",
        f"Stations, {words_of_form(run).stations} (thin, black), over the curves that stand for them (broad, "
        "coloured).",
        f"Body plan with {len(run.hull.fits)} stations: their curves lie over their models.",
    )


def area_figure(run: Run) -> Picture:
    """Sectional areas below the draught of each condition, and at the design draught those of the stations."""
    hull = run.hull
    rows = -(-(len(run.conditions) + 2) // LEGEND_COLUMNS)
    height = 2.6 + LEGEND_ROW * rows
    figure = Figure(figsize=(PAGE_WIDTH, height))
    axes = figure.subplots()
    figure.subplots_adjust(left=0.075, right=0.975, top=1 - LEGEND_ROW * rows / height, bottom=0.48 / height)
    x = hull.x_m
    for number, condition in enumerate(run.conditions.values()):
        draught = condition.floating.draught_m
        label = f"{condition.condition.name}, {significant(draught)} m"
        axes.plot(x, hull.sectional_areas(draught), color=SERIES[number % len(SERIES)], linewidth=1.5, label=label)
    design = hull.sectional_areas(run.at_draught.draught_m)
    axes.fill_between(x, design, color=QUIET, alpha=0.14, linewidth=0)
    axes.plot(
        x, design, color=QUIET, linewidth=1.0, linestyle=":", label=f"design draught, {run.at_draught.draught_m:g} m"
    )
    traced = [(station.x_m, station.area_below(run.at_draught.draught_m)) for station in run.body_plan.stations]
    axes.plot(
        *np.transpose(traced), "o", color="black", markersize=3, fillstyle="none", label="stations, design draught"
    )
    finish(axes, "x from the aft end, m", "sectional area, m²", hull.length_overall_m)
    axes.set_ylim(0.0, None)
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=LEGEND_COLUMNS, borderaxespad=0.2, columnspacing=1.4)
    return as_svg(
        figure,
        "sectional-areas",
        "Sectional area below the even-keel waterline of each condition; circles: the stations themselves.",
        f"Sectional area curves; the largest section at the design draught has {significant(design.max())} m².",
    )
