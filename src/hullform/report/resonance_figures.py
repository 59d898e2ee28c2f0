"""Figures of propeller and engine against the modes: resonance diagram and forced response."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from hullform.in_service import Resonances, Response
from hullform.report.drawing import ACCENT, INK, PAGE_WIDTH, QUIET, SERIES, WARM, Picture, as_svg, finish
from hullform.report.wording import load_words
from hullform.rounding import short, significant
from hullvib.modes import Modes
from hullvib.resonance import HIGHEST_MODE, KEEP_CLEAR, SURE_MODES, Source

RPM_TO_HZ = 1.0 / 60.0
# Where along a ray its name may stand, the best place first, and half of what it takes, over its length.
NAME_PLACES = (0.7, 0.62, 0.8, 0.54, 0.46, 0.38, 0.9, 0.3)
HALF_NAME = 0.07


def resonance_figure(name: str, title: str, modes: Modes, found: Resonances) -> Picture:
    """Natural frequencies with their bands, and what propeller and engine excite at each shaft speed."""
    figure = Figure(figsize=(PAGE_WIDTH, 5.0))
    axes = figure.subplots()
    figure.subplots_adjust(left=0.07, right=0.8, top=0.94, bottom=0.17)
    slowest, fastest = found.given.shaft_speed_rpm
    last_rpm, top_hz = 1.06 * fastest, 1.25 * found.beam_limit_hz
    _draw_bands(axes, modes, found, last_rpm)
    axes.axhspan(
        found.beam_limit_hz, top_hz, facecolor="#f1f1ee", edgecolor=QUIET, hatch="///", linewidth=0, alpha=0.55
    )
    axes.text(
        0.01 * last_rpm,
        0.5 * (found.beam_limit_hz + top_hz),
        "outside beam theory: decks, double bottom and deckhouse vibrate on their own",
        va="center",
        fontsize=8.0,
        zorder=6,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.5, "alpha": 0.85},
    )
    for source in found.sources:
        _draw_ray(axes, source, last_rpm, top_hz, found)
    for hit in found.hits:
        ends = np.array(hit.avoid_rpm)
        axes.plot(
            ends,
            hit.source.order * ends * RPM_TO_HZ,
            color=WARM,
            linewidth=3.4,
            alpha=0.45 if hit.flagged else 0.95,
            solid_capstyle="butt",
            zorder=4,
        )
    for edge in (slowest, fastest):
        axes.axvline(edge, color=INK, linewidth=0.9, linestyle=(0, (1, 2)))
    if found.given.service_rpm is not None:
        axes.axvline(found.given.service_rpm, color=INK, linewidth=1.3)
        axes.annotate(
            f"service {short(found.given.service_rpm)} rpm",
            (found.given.service_rpm, top_hz),
            (-3, -3),
            textcoords="offset points",
            ha="right",
            va="top",
            fontsize=8.0,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0, "alpha": 0.85},
        )
    finish(axes, "", "frequency, Hz", None)
    axes.set_xlabel("shaft speed, rpm", labelpad=20)
    axes.set_xlim(0.0, last_rpm)
    axes.set_ylim(0.0, top_hz)
    _draw_strip(axes, found)
    axes.set_title(title)
    shown = min(HIGHEST_MODE, len(modes.frequencies_hz))
    per_cent = short(100 * KEEP_CLEAR)
    return as_svg(
        figure,
        f"resonance-{name}",
        f"Resonance diagram, {title}, {modes.theory}, {modes.medium}. Solid rays: blade rate and its harmonics; "
        f"dashed: engine orders. Dark bands: ±{per_cent} % of each frequency; pale: widened by the model’s own "
        "uncertainty. Orange: hits within the shaft’s speeds (dotted lines), pale those of modes "
        f"{SURE_MODES + 1} to {shown}; the strip below has the speeds to avoid.",
        f"Frequency over shaft speed, {title}: {len(found.hits)} hits of excitation and natural frequencies.",
    )


def _draw_bands(axes: Axes, modes: Modes, found: Resonances, last_rpm: float) -> None:
    above = 0.0
    for index, hz in enumerate(modes.frequencies_hz[:HIGHEST_MODE]):
        sure = index < SURE_MODES
        colour = ACCENT if sure else QUIET
        low, high = (float(edges[index]) for edges in found.bands_hz)
        axes.axhspan(low, high, facecolor=colour, alpha=0.10, linewidth=0)
        axes.axhspan(hz * (1 - KEEP_CLEAR), hz * (1 + KEEP_CLEAR), facecolor=colour, alpha=0.17, linewidth=0)
        axes.axhline(hz, color=colour, linewidth=1.3, linestyle="-" if sure else "--")
        axes.annotate(
            f"mode {index + 1}, {significant(hz)} Hz ± {significant(100 * float(found.uncertainty[index]), 2)} %",
            (last_rpm, max(hz, above)),
            (4, 0),
            textcoords="offset points",
            va="center",
            fontsize=8.0,
            color=INK if sure else "#5f6b77",
            annotation_clip=False,
        )
        above = max(hz, above) + 0.04 * found.beam_limit_hz


def _draw_ray(axes: Axes, source: Source, last_rpm: float, top_hz: float, found: Resonances) -> None:
    """A line from the origin, with its name where it covers no hit and no other text, if there is such a place."""
    style = "-" if source.acts == "force" else (0, (5, 3))
    steep = source.frequency_hz(last_rpm) > top_hz
    end = 60.0 * top_hz / source.order if steep else last_rpm
    axes.plot([0.0, end], [0.0, source.frequency_hz(end)], color=INK, linewidth=1.0, linestyle=style, zorder=3)
    half = HALF_NAME * end
    hits = [hit.avoid_rpm for hit in found.hits if hit.source == source]
    free = [
        place
        for place in NAME_PLACES
        if all(place * end + half < low or place * end - half > high for low, high in hits)
        and source.frequency_hz(place * end + half) < found.beam_limit_hz
    ]
    share = free[0] if free else NAME_PLACES[0]
    # the name runs along the ray, on a patch of paper
    box = axes.get_window_extent()
    angle = math.degrees(math.atan2(source.frequency_hz(end) / top_hz * box.height, end / last_rpm * box.width))
    axes.text(
        share * end,
        share * source.frequency_hz(end),
        source.name,
        rotation=angle,
        rotation_mode="anchor",
        ha="center",
        va="center",
        fontsize=7.6,
        zorder=5,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.8, "alpha": 0.9},
    )


def _draw_strip(axes: Axes, found: Resonances) -> None:
    """The speeds to avoid along the foot of the frame: above for modes 1 to 3, below for the flagged."""
    across = axes.get_xaxis_transform()
    for spans, level, alpha in ((found.avoid_rpm, -0.075, 0.95), (found.flagged_rpm, -0.1, 0.4)):
        for low, high in spans:
            axes.plot([low, high], [level, level], transform=across, color=WARM, linewidth=4.5, alpha=alpha,
                      solid_capstyle="butt", clip_on=False)  # fmt: skip
    axes.text(-0.012, -0.088, "avoid", transform=axes.transAxes, ha="right", va="center", fontsize=8.0, color=WARM)


def response_figure(name: str, title: str, modes: Modes, found: Resonances) -> Picture:
    """Peak velocity along the ship at every hit: loads that ship.toml gives, and unit loads."""
    groups: dict[str, list[Response]] = {}
    for response in sorted(found.responses, key=lambda response: not response.load_is_given):
        unit = "of 1 kN at the propeller" if response.load.force_n else "of 1 MN m at the engine"
        groups.setdefault("loads as given" if response.load_is_given else unit, []).append(response)
    rows = max(len(group) for group in groups.values())
    height = 2.9 + 0.19 * rows
    figure = Figure(figsize=(PAGE_WIDTH, height))
    panels = figure.subplots(1, len(groups), squeeze=False)[0]
    figure.subplots_adjust(
        left=0.075, right=0.985, top=1 - 0.28 / height, bottom=(0.62 + 0.19 * rows) / height, wspace=0.2
    )
    for axes, (load, group) in zip(panels, groups.items(), strict=True):
        for index, response in enumerate(group):
            axes.plot(
                response.motion.x_m,
                1e3 * response.motion.peak_velocity_m_s,
                color=SERIES[index % len(SERIES)],
                linestyle=("-", "--", ":")[index // len(SERIES) % 3],
                linewidth=1.4,
                label=f"mode {response.hit.mode}, {response.hit.source.name}, {short(response.speed_rpm)} rpm"
                + (f": {load_words(response)}" if response.load_is_given else ""),
            )
        finish(axes, "x from the aft end, m", "", modes.girder.length)
        axes.set_ylim(bottom=0.0)
        axes.set_title(load)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.52 / (height - 0.9 - 0.19 * rows)), fontsize=7.6)
    panels[0].set_ylabel("peak velocity, mm/s")
    return as_svg(
        figure,
        f"response-{name}",
        f"Hull girder alone, {title}: peak velocity (zero to peak) of the mode at each hit, with "
        f"{short(100 * (found.given.damping or 0.0))} % of critical damping; at the critical speed, or the nearest in "
        "the shaft’s range. It is no verdict on habitability: decks and deckhouses have responses of their own.",
        f"Peak velocity along the ship at each hit, {title}.",
    )
