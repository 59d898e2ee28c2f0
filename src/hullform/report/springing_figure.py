"""The waves of springing, over the ship's speed."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter
from numpy.typing import ArrayLike, NDArray

from hullform.loading.gravity import GRAVITY_M_S2
from hullform.outcome import Run
from hullform.report.drawing import INK, PAGE_WIDTH, QUIET, SERIES, Picture, as_svg, finish
from hullform.rounding import short
from hullform.ship_operation import FOLLOWING_SEAS_DEG, HEAD_SEAS_DEG, metres_per_second
from hullvib.springing import ORDERS, met_waves, wave_length

Array = NDArray[np.float64]

PANELS_ABREAST = 3
POINTS = 400
SHORTEST_SHOWN_M = 1.0
PERIODS_S = (1, 2, 3, 5, 8, 12, 18)


def springing_figure(run: Run) -> Picture:
    """Length of the waves that excite the first mode, over the ship's speed at each heading, and over the heading."""
    given = run.ship.operation
    assert given is not None
    count = len(given.headings_deg) + 1
    columns = min(PANELS_ABREAST, count)
    rows = -(-count // columns)
    height = 2.9 * rows + 0.45
    figure = Figure(figsize=(PAGE_WIDTH, height))
    panels = figure.subplots(rows, columns, sharey=True, squeeze=False).ravel()
    figure.subplots_adjust(
        left=0.075, right=0.925, top=1 - 0.27 / height, bottom=0.95 / height, wspace=0.07, hspace=0.42
    )
    fastest = max(given.speeds_knots)
    knots = np.linspace(0.0, 1.15 * max(fastest, 1.0), POINTS)
    for axes, heading in zip(panels, given.headings_deg, strict=False):
        _draw_waves(axes, run, knots, knots, np.full(POINTS, heading))
        axes.axvspan(min(given.speeds_knots), fastest, color=QUIET, alpha=0.13, linewidth=0)
        finish(axes, "ship’s speed, knots", "", None)
        axes.set_xlim(0.0, float(knots[-1]))
        axes.set_title(_heading_words(heading))
    headings = np.linspace(FOLLOWING_SEAS_DEG, HEAD_SEAS_DEG, POINTS)
    sweep = panels[count - 1]
    _draw_waves(sweep, run, headings, np.full(POINTS, fastest), headings)
    finish(sweep, "heading, degrees (180 head seas)", "", None)
    sweep.set_xlim(FOLLOWING_SEAS_DEG, HEAD_SEAS_DEG)
    sweep.set_xticks([0, 45, 90, 135, 180])
    sweep.set_title(f"at {short(fastest)} knots")
    for unused in panels[count:]:
        unused.set_axis_off()
    for row in range(rows):
        panels[row * columns].set_ylabel("wave length, m")
        _add_periods(panels[min((row + 1) * columns, count) - 1], run.ship.water.bottom_m)
    figure.legend(
        *panels[0].get_legend_handles_labels(), loc="lower center", ncols=max(2, len(run.in_service)), columnspacing=1.6
    )
    medium = next(iter(run.in_service.values())).modes.medium
    depth = run.ship.water.depth_m
    water = "deep water" if depth is None else f"water {depth:g} m deep"
    return as_svg(
        figure,
        "springing",
        f"Springing: regular waves in {water} that meet the ship with the frequency of mode 1 ({medium}; linear, "
        "solid) or half of it (second order, dashed). Grey: the given speeds; dotted: her length overall. In following "
        "seas up to three waves do; the shortest are those that she overtakes.",
        "Wave length over the ship's speed, a panel a heading, and over the heading.",
    )


def _draw_waves(axes: Axes, run: Run, x: Array, speeds_knots: Array, headings_deg: Array) -> None:
    """Lines of every condition and order over x, at the speed and heading of each point."""
    speeds = np.array([metres_per_second(float(speed)) for speed in speeds_knots])
    for index, (name, service) in enumerate(run.in_service.items()):
        for order in ORDERS:
            met = float(service.modes.angular_frequencies[0]) / order
            _, lengths = met_waves(met, speeds, np.radians(headings_deg), GRAVITY_M_S2, run.ship.water.bottom_m)
            for branch, length in enumerate(lengths.T):
                label = run.conditions[name].condition.title + (", linear" if order == 1 else ", second order")
                axes.plot(
                    x,
                    length,
                    color=SERIES[index % len(SERIES)],
                    linestyle="-" if order == 1 else "--",
                    linewidth=1.3,
                    label=label if branch == 0 else None,
                )
    overall = run.ship.particulars.length_overall_m
    axes.axhline(overall, color=INK, linewidth=0.8, linestyle=(0, (1, 2)))
    axes.set_yscale("log")
    axes.set_ylim(SHORTEST_SHOWN_M, 2.0 * overall)
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())


def _add_periods(axes: Axes, depth_m: float) -> None:
    """A second scale with the period of a wave of each length."""

    def period_of(length_m: ArrayLike) -> Array:
        number = 2.0 * math.pi / np.maximum(np.asarray(length_m, dtype=np.float64), 1e-9)
        return np.asarray(2.0 * math.pi / np.sqrt(GRAVITY_M_S2 * number * np.tanh(number * depth_m)))

    def length_of(period_s: ArrayLike) -> Array:
        waves = 2.0 * math.pi / np.maximum(np.asarray(period_s, dtype=np.float64), 1e-9)
        return wave_length(waves, GRAVITY_M_S2, depth_m)

    period = axes.secondary_yaxis("right", functions=(period_of, length_of))
    period.set_ylabel("wave period, s")
    period.set_yticks(PERIODS_S)
    period.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    period.yaxis.set_minor_formatter(NullFormatter())
    period.spines["right"].set_visible(False)


def _heading_words(heading_deg: float) -> str:
    known = {180.0: "head seas, 180°", 0.0: "following seas, 0°", 90.0: "beam seas, 90°"}
    return known.get(heading_deg, f"heading {short(heading_deg)}°")
