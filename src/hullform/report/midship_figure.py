"""The midship section with its plates: thickness by thickness, part by part."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from hullform.loading.framing import Plating
from hullform.outcome import Run
from hullform.report.drawing import ACCENT, INK, PAGE_WIDTH, QUIET, WARM, Picture, as_svg, finish
from hullform.rounding import as_given, significant

# By the part's first words; decks and bulkheads have their heights and places after them.
PART_COLOURS = {
    "bottom": ACCENT,
    "side": "#3f7cae",
    "deck": WARM,
    "inner bottom": "#4f7f3f",
    "inner side": "#8a7a2a",
    "deck at": "#d08a4a",
    "bulkhead": "#7d4f8a",
    "superstructure": QUIET,
}
# The widest line of the drawing, in points, for the thickest plate; the thinnest still has to be seen.
WIDEST_LINE = 5.0
THINNEST_LINE = 1.0
# Inches of the page that the drawing leaves to its list of parts.
LIST_WIDTH = 2.6
LEFT_MARGIN = 0.62
FOOT = 0.55
HEAD = 0.12
# Plates shorter than this share of the breadth have no room for their thickness; the list has it.
SHORTEST_LABELLED = 0.05


def midship_figure(run: Run) -> Picture:
    """Both sides of the midship section, plates as broad as they are thick, thicknesses in mm on one side."""
    platings = run.structure.midship_platings
    points = np.concatenate([plating.points for plating in platings])
    half, low, high = float(points[:, 0].max()), float(points[:, 1].min()), float(points[:, 1].max())
    drawn_width = PAGE_WIDTH - LEFT_MARGIN - LIST_WIDTH
    margin = 0.07 * half
    scale = drawn_width / (2 * (half + margin))
    height = scale * (high - low + 2 * margin) + FOOT + HEAD
    figure = Figure(figsize=(PAGE_WIDTH, height))
    axes = figure.add_axes(
        (LEFT_MARGIN / PAGE_WIDTH, FOOT / height, drawn_width / PAGE_WIDTH, 1 - (FOOT + HEAD) / height)
    )
    thickest = max(plating.scantling.thickness_m for plating in platings)
    listed: set[str] = set()
    for plating in platings:
        _draw(axes, plating, thickest, listed)
        if plating.length_m > SHORTEST_LABELLED * half:
            _write_thickness(axes, plating)
    structure, hull = run.structure, run.hull
    neutral = float(np.interp(hull.midships_m, structure.x_m, structure.neutral_axis_m))
    axes.axhline(
        neutral, color=INK, linewidth=0.8, linestyle=(0, (8, 3, 2, 3)),
        label=f"neutral axis, z = {significant(neutral)} m",
    )  # fmt: skip
    given, _, _ = run.ship.require_sections_of_a_run()
    opening = min(given.opening_breadth_m(hull.midships_m), 2 * half)
    if opening:
        deck = float(np.interp(hull.midships_m, hull.x_m, hull.top_height_m))
        axes.plot(
            [-opening / 2, opening / 2], [deck, deck], color=PART_COLOURS["deck"], linewidth=1.0, linestyle=":",
            label=f"hatch opening, {as_given(opening)} m",
        )  # fmt: skip
    axes.axvline(0.0, color=QUIET, linewidth=0.7, linestyle=(0, (8, 3, 2, 3)))
    finish(axes, "y from the centre line, m", "z above the base line, m")
    axes.set_xlim(-half - margin, half + margin)
    axes.set_ylim(low - margin, high + margin)
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), borderaxespad=0.0, handlelength=1.6)
    return as_svg(
        figure,
        "midship-section",
        f"Midship section, x = {significant(hull.midships_m)} m, as modelled: gross plate thicknesses in mm, lines as "
        "broad as the plates are thick (not to scale).",
        f"Midship section with {len(listed)} kinds of plates and their thicknesses.",
    )


def _draw(axes: Axes, plating: Plating, thickest: float, listed: set[str]) -> None:
    scantling = plating.scantling
    width = max(THINNEST_LINE, WIDEST_LINE * scantling.thickness_m / thickest)
    label = f"{plating.name}, {as_given(1000 * scantling.thickness_m)} mm"
    y, z = plating.points.T
    for side in (1, -1):
        axes.plot(
            side * y, z, color=_colour(plating.name), linewidth=width, solid_capstyle="butt",
            label=None if label in listed else label,
        )  # fmt: skip
        listed.add(label)


def _colour(name: str) -> str:
    """Of the longest of the known beginnings of a name."""
    return PART_COLOURS[max((start for start in PART_COLOURS if name.startswith(start)), key=len)]


def _write_thickness(axes: Axes, plating: Plating) -> None:
    """The thickness in the middle of a plate, along it, on its inner side."""
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(plating.points, axis=0).T))])
    y, z = (float(np.interp(along[-1] / 2, along, values)) for values in plating.points.T)
    piece = min(int(np.searchsorted(along, along[-1] / 2)), len(along) - 1)
    run, rise = plating.points[piece] - plating.points[piece - 1]
    upright = abs(rise) > abs(run)
    axes.annotate(
        as_given(1000 * plating.scantling.thickness_m),
        (y, z),
        (-5, 0) if upright else (0, 4),
        textcoords="offset points",
        ha="right" if upright else "center",
        va="center" if upright else "bottom",
        fontsize=7.5,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6},
    )
