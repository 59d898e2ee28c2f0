"""The ship in still water: weight and buoyancy, shear force and bending moment along her."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from hullform.loading.gravity import GRAVITY_M_S2
from hullform.loading.still_water import Extremes, StillWater, sampled
from hullform.outcome import ConditionRun
from hullform.report.drawing import ACCENT, INK, PAGE_WIDTH, QUIET, WARM, Picture, as_svg, finish
from hullform.rounding import significant

NEWTONS_PER_TONNE = 1000.0 * GRAVITY_M_S2
MEGA = 1e6
# Point masses stand as pins of this share of the panel's height.
PIN = 0.06


def still_water_figure(condition: ConditionRun) -> Picture:
    """Weight and buoyancy per length, V(x) and M(x) of a condition."""
    still, length = condition.at_rest.still_water, condition.girder.length
    figure = Figure(figsize=(PAGE_WIDTH, 5.6))
    load, shear, moment = figure.subplots(3, 1, sharex=True, height_ratios=[1.3, 1, 1])
    figure.subplots_adjust(left=0.088, right=0.985, top=0.945, bottom=0.085, hspace=0.14)
    _draw_load(load, still, condition, length)
    for axes, curve, extremes, label in (
        (shear, still.shear_force, still.shear_extremes, "V(x), MN"),
        (moment, still.bending_moment, still.moment_extremes, "M(x), MN m"),
    ):
        x, values = sampled(curve)
        axes.fill_between(x, values / MEGA, color=ACCENT, alpha=0.14, linewidth=0)
        axes.plot(x, values / MEGA, color=ACCENT, linewidth=1.4)
        axes.axhline(0.0, color=QUIET, linewidth=0.8)
        finish(axes, "", label, length)
        _mark(axes, extremes)
    figure.align_ylabels()
    moment.set_xlabel("x from the aft end, m")
    title, waterline = condition.condition.title, still.waterline
    drawn_at = "in equilibrium" if condition.at_rest.equilibrium is not None else "which do not carry her"
    bent = still.moment_extremes
    largest = bent.greatest if bent.greatest >= -bent.least else bent.least
    return as_svg(
        figure,
        f"still-water-{condition.condition.name}",
        f"Still water, {title}, draughts {significant(waterline.draught_aft_m)} m aft and "
        f"{significant(waterline.draught_fore_m)} m fore, {drawn_at}: weight and buoyancy, shear force V and bending "
        "moment M, hogging positive, dM/dx = V.",
        f"Weight and buoyancy, shear force and bending moment along the ship, {title}; the largest bending moment is "
        f"{significant(largest / MEGA)} MN m.",
    )


def _draw_load(axes: Axes, still: StillWater, condition: ConditionRun, length_m: float) -> None:
    x, weight = sampled(still.weight)
    buoyancy = sampled(still.buoyancy)[1]
    weight, buoyancy = weight / NEWTONS_PER_TONNE, buoyancy / NEWTONS_PER_TONNE
    more = weight >= buoyancy
    axes.fill_between(x, weight, buoyancy, where=more, color=WARM, alpha=0.22, linewidth=0, label="more weight")
    axes.fill_between(x, weight, buoyancy, where=~more, color=ACCENT, alpha=0.16, linewidth=0, label="more buoyancy")
    axes.plot(x, weight, color=INK, linewidth=1.2, label="weight")
    axes.plot(x, buoyancy, color=ACCENT, linewidth=1.4, linestyle="--", label="buoyancy")
    top = 1.08 * float(max(weight.max(), buoyancy.max()))
    points = [point for item in condition.items for point in item.points]
    if points:
        places = np.array([place for place, _ in points])
        whole = sum(mass for _, mass in points) / 1e3
        label = f"point masses, {significant(whole)} t in all"
        axes.vlines(places, 0.0, PIN * top, color=INK, linewidth=2.0, label=label, clip_on=False)
    finish(axes, "", "weight, buoyancy, t/m", length_m)
    axes.set_ylim(0.0, top)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=5, columnspacing=1.4, borderaxespad=0.2)


def _mark(axes: Axes, extremes: Extremes) -> None:
    """Write the extremes that are no round-off beside their places."""
    low, high = axes.get_ylim()
    margin = 0.16 * (high - low)
    axes.set_ylim(low - margin if extremes.least < 0 else low, high + margin if extremes.greatest > 0 else high)
    for value, place, above in (
        (extremes.greatest, extremes.greatest_x_m, True),
        (extremes.least, extremes.least_x_m, False),
    ):
        if abs(value) < 0.01 * extremes.size or (value > 0) != above:
            continue
        axes.plot([place], [value / MEGA], "o", color=ACCENT, markersize=3.5)
        share = place / axes.get_xlim()[1]
        axes.annotate(
            f"{significant(value / MEGA)} at {significant(place)} m",
            (place, value / MEGA),
            (0, 5 if above else -5),
            textcoords="offset points",
            ha="left" if share < 0.12 else "right" if share > 0.88 else "center",
            va="bottom" if above else "top",
            fontsize=8.0,
        )
