"""Figures of a girder and its modes; the only module that knows matplotlib, and never its pyplot."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from hullvib.bernstein import evaluate
from hullvib.girder import Girder
from hullvib.modes import Modes
from hullvib.sensitivity import mass_sensitivity, rigidity_sensitivity
from hullvib.uniform_beam import uniform_modes

Array = NDArray[np.float64]

_INK, _ACCENT = "#1b3a57", "#b5532a"
_COLOURS = (_INK, _ACCENT, "#4f7f3f", "#7d4f8a", "#8a7a2a")


def plot_mass(girder: Girder, axes: Axes | None = None) -> Axes:
    """Draws m(x) in t/m, filled, and point masses as stems in t; returns the axes, whose `.figure` is the figure."""
    axes = _axes(axes)
    x, mass = _curve(girder, girder.mass_coefficients)
    axes.fill_between(x, mass / 1e3, color=_INK, alpha=0.15, linewidth=0)
    axes.plot(x, mass / 1e3, color=_INK, linewidth=1.5)
    top = 1.12 * float(mass.max()) / 1e3 or 1.0
    for point in girder.point_masses:
        axes.vlines(point.x_m, 0.0, top / 1.12, color=_ACCENT, linewidth=1.2)
        axes.annotate(
            f"{point.mass_kg / 1e3:,.4g} t",
            (point.x_m, top / 1.12),
            ha="center",
            va="bottom",
            color=_ACCENT,
            fontsize=8,
        )
    axes.set_ylim(0.0, top)
    return _finish(axes, girder, "mass per length m(x), t/m")


def plot_rigidity(girder: Girder, axes: Axes | None = None) -> Axes:
    """Draws EI(x) in N m^2, filled; returns the axes."""
    axes = _axes(axes)
    x, rigidity = _curve(girder, girder.flexural_rigidity_coefficients)
    axes.fill_between(x, rigidity, color=_INK, alpha=0.15, linewidth=0)
    axes.plot(x, rigidity, color=_INK, linewidth=1.5)
    axes.set_ylim(0.0, 1.12 * float(rigidity.max()))
    return _finish(axes, girder, "flexural rigidity EI(x), N m²")


def plot_modes(modes: Modes, axes: Axes | None = None, count: int = 3) -> Axes:
    """Draws the first mode shapes, with the uniform beam's dotted in the same normalisation; returns the axes."""
    axes = _axes(axes)
    count = min(count, len(modes.angular_frequencies))
    shown = modes.normalised("largest-amplitude")
    x = np.linspace(0.0, modes.girder.length, 401)
    # the uniform modes have their largest value, 2, at the aft end
    uniform = uniform_modes(x / modes.girder.length, count)[0] / 2.0
    for n, (own, plain, hz) in enumerate(zip(shown.shape(x), uniform, modes.frequencies_hz, strict=False), 1):
        colour = _COLOURS[(n - 1) % len(_COLOURS)]
        axes.plot(x, own, color=colour, linewidth=1.6, label=f"mode {n}, {hz:.3g} Hz")
        axes.plot(x, plain, color=colour, linewidth=1.1, linestyle=":")
    axes.plot([], [], color="0.4", linewidth=1.1, linestyle=":", label="uniform beam")
    axes.axhline(0.0, color="0.7", linewidth=0.8, zorder=0)
    axes.set_ylim(-1.15, 1.15)
    axes.legend(
        fontsize=8, ncols=2, frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.16), title_fontsize=8,
        title=f"{modes.theory}, {modes.medium}; {shown.normalisation_note}",
    )  # fmt: skip
    return _finish(axes, modes.girder, "mode shape Φ(x), -")


def plot_mass_sensitivity(modes: Modes, axes: Axes | None = None, count: int = 3) -> Axes:
    """Draws how much a tonne put at x lowers each of the first frequencies, in mHz; returns the axes."""
    x = _dense(modes.girder)
    values = mass_sensitivity(modes, x) * (1e3 * 1e3 / (2.0 * np.pi))
    return _sensitivity(modes, x, values, "a tonne at x, mHz", _axes(axes), count)


def plot_rigidity_sensitivity(modes: Modes, axes: Axes | None = None, count: int = 3) -> Axes:
    """Draws how much one per cent more EI over a metre at x raises each of the first frequencies, in mHz."""
    x = _dense(modes.girder)
    plated = 0.01 * modes.girder.flexural_rigidity(x)
    values = rigidity_sensitivity(modes, x) * plated * (1e3 / (2.0 * np.pi))
    return _sensitivity(modes, x, values, "1 % of EI over a metre, mHz", _axes(axes), count)


def draw_sensitivity(modes: Modes, count: int = 3, width: float = 7.0, height: float = 5.6) -> Figure:
    """A figure that tells where a tonne and where plating moves which mode: both curves over the same x."""
    figure = Figure(figsize=(width, height), layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True)
    plot_mass_sensitivity(modes, upper, count)
    plot_rigidity_sensitivity(modes, lower, count)
    upper.set_xlabel("")
    lower.set_title("")
    lower.get_legend().remove()
    return figure


def draw(painter: Callable[[Axes], Axes], width: float = 7.0, height: float = 3.6) -> Figure:
    """A figure of the given size in inches that holds what one painter draws, laid out without overlap."""
    figure = Figure(figsize=(width, height), layout="constrained")
    painter(figure.subplots())
    return figure


def _dense(girder: Girder) -> Array:
    """Points close enough for any mode that is drawn, with both sides of every breakpoint and point mass."""
    marks = np.array([*girder.breaks[1:-1], *(p.x_m for p in girder.point_masses)])
    sides = np.concatenate([marks - 1e-7 * girder.length, marks + 1e-7 * girder.length])
    x = np.concatenate([np.linspace(0.0, girder.length, 801), sides])
    return np.unique(np.clip(x, 0.0, girder.length))


def _sensitivity(modes: Modes, x: Array, values: Array, label: str, axes: Axes, count: int) -> Axes:
    shown = list(zip(values, modes.frequencies_hz, strict=True))[:count]
    for n, (curve, hz) in enumerate(shown, 1):
        colour = _COLOURS[(n - 1) % len(_COLOURS)]
        axes.plot(x, curve, color=colour, linewidth=1.6, label=f"mode {n}, {hz:.3g} Hz")
    axes.axhline(0.0, color="0.7", linewidth=0.8, zorder=0)
    axes.legend(fontsize=8, frameon=False, loc="best", title=f"{modes.theory}, {modes.medium}", title_fontsize=8)
    return _finish(axes, modes.girder, f"change of frequency by\n{label}")


def _axes(axes: Axes | None) -> Axes:
    return Figure(figsize=(7.0, 3.6), layout="constrained").subplots() if axes is None else axes


def _curve(girder: Girder, coefficients: Array) -> tuple[Array, Array]:
    """Points of a property with both sides of every jump."""
    t = np.linspace(0.0, 1.0, 2 if coefficients.shape[1] <= 2 else 33)
    left, width = girder.breaks[:-1, None], np.diff(girder.breaks)[:, None]
    return (left + width * t).ravel(), evaluate(coefficients[:, None, :], t[None, :]).ravel()


def _finish(axes: Axes, girder: Girder, label: str) -> Axes:
    axes.set_xlim(0.0, girder.length)
    axes.set_xlabel("x from the aft end, m")
    axes.set_ylabel(label)
    axes.grid(color="0.9", linewidth=0.6)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    if girder.name:
        axes.set_title(girder.name, fontsize=10)
    return axes
