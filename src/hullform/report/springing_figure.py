"""The waves of springing, over the ship's speed."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter
from numpy.typing import NDArray

from hullform.loading.gravity import GRAVITY_M_S2
from hullform.outcome import Run
from hullform.report.drawing import INK, PAGE_WIDTH, QUIET, SERIES, Picture, as_svg, finish
from hullform.rounding import short
from hullform.ship_operation import metres_per_second
from hullvib.springing import ORDERS, wave_frequencies, wave_length

Array = NDArray[np.float64]

PANELS_ABREAST = 3


def springing_figure(run: Run) -> Picture:
    """Length of the waves that excite the first mode over the ship's speed, a panel a heading."""
    given = run.ship.operation
    assert given is not None
    columns = min(PANELS_ABREAST, len(given.headings_deg))
    rows = -(-len(given.headings_deg) // columns)
    height = 2.9 * rows + 0.45
    figure = Figure(figsize=(PAGE_WIDTH, height))
    panels = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False).ravel()
    figure.subplots_adjust(
        left=0.075, right=0.925, top=1 - 0.27 / height, bottom=0.95 / height, wspace=0.07, hspace=0.25
    )
    fastest = 1.15 * max(*given.speeds_knots, 1.0)
    knots = np.linspace(0.0, fastest, 400)
    for axes, heading in zip(panels, given.headings_deg, strict=False):
        for index, (name, service) in enumerate(run.in_service.items()):
            for order in ORDERS:
                _draw_waves(
                    axes,
                    float(service.modes.angular_frequencies[0]) / order,
                    knots,
                    heading,
                    colour=SERIES[index % len(SERIES)],
                    style="-" if order == 1 else "--",
                    label=run.conditions[name].condition.title + (", linear" if order == 1 else ", second order"),
                )
        axes.axvspan(min(given.speeds_knots), max(given.speeds_knots), color=QUIET, alpha=0.13, linewidth=0)
        axes.axhline(run.ship.particulars.length_overall_m, color=INK, linewidth=0.8, linestyle=(0, (1, 2)))
        axes.set_yscale("log")
        finish(axes, "ship’s speed, knots", "", None)
        axes.set_xlim(0.0, fastest)
        axes.set_ylim(1.0, 2.0 * run.ship.particulars.length_overall_m)
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.yaxis.set_minor_formatter(NullFormatter())
        axes.set_title(_heading_words(heading))
    for unused in panels[len(given.headings_deg) :]:
        unused.set_axis_off()
    for row in range(rows):
        panels[row * columns].set_ylabel("wave length, m")
        last = panels[min((row + 1) * columns, len(given.headings_deg)) - 1]
        period = last.secondary_yaxis("right", functions=(_period_of_length, _length_of_period))
        period.set_ylabel("wave period, s")
        period.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        period.yaxis.set_minor_formatter(NullFormatter())
        period.set_yticks([1, 2, 3, 5, 8, 12, 18])
        period.spines["right"].set_visible(False)
    figure.legend(
        *panels[0].get_legend_handles_labels(), loc="lower center", ncols=max(2, len(run.in_service)), columnspacing=1.6
    )
    medium = next(iter(run.in_service.values())).modes.medium
    return as_svg(
        figure,
        "springing",
        f"Springing: regular waves in deep water that meet the ship with the frequency of mode 1 ({medium}; linear, "
        "solid) or half of it (second order, dashed). Grey: the given speeds; dotted: her length overall. In following "
        "seas up to three waves do; the shortest are those that she overtakes.",
        "Wave length over the ship's speed, a panel a heading.",
    )


def _draw_waves(
    axes: Axes, met_rad_s: float, knots: Array, heading_deg: float, *, colour: str, style: str, label: str
) -> None:
    speeds = np.array([metres_per_second(float(speed)) for speed in knots])
    roots = wave_frequencies(met_rad_s, speeds, math.radians(heading_deg), GRAVITY_M_S2)
    for branch, root in enumerate(roots.T):
        if np.isfinite(root).any() or branch == 0:
            axes.plot(
                knots,
                wave_length(root, GRAVITY_M_S2),
                color=colour,
                linestyle=style,
                linewidth=1.3,
                label=label if branch == 0 else None,
            )


def _heading_words(heading_deg: float) -> str:
    known = {180.0: "head seas, 180°", 0.0: "following seas, 0°", 90.0: "beam seas, 90°"}
    return known.get(heading_deg, f"heading {short(heading_deg)}°")


def _period_of_length(length_m: Array) -> Array:
    return np.asarray(np.sqrt(2.0 * math.pi * np.maximum(length_m, 1e-9) / GRAVITY_M_S2))


def _length_of_period(period_s: Array) -> Array:
    return np.asarray(GRAVITY_M_S2 * np.asarray(period_s) ** 2 / (2.0 * math.pi))
