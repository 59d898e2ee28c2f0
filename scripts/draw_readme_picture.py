"""Draw the README's picture: the bulk carrier's body plan as it was read, and the loaded ship's first modes."""

from __future__ import annotations

from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from hullform import read_ship, run_ship
from hullform.picture.overlay import draw_overlay
from hullvib.plots import plot_modes

ROOT = Path(__file__).parent.parent
SHIP = "handymax-bulk-carrier"
PATH = ROOT / "docs" / "images" / f"{SHIP}.png"

if __name__ == "__main__":
    run = run_ship(read_ship(ROOT / "bodyplans" / SHIP / "ship.toml"))
    drawn = draw_overlay(run.reading)[:, :, ::-1]
    below_the_base_line = int(run.reading.calibration.baseline_px) + 60
    figure = Figure(figsize=(15, 5.2), dpi=110, layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=(1.5, 1))
    left.imshow(drawn[60:below_the_base_line], interpolation="antialiased")
    left.set_axis_off()
    left.set_title("read from the picture")
    plot_modes(run.conditions["loaded"].modes, axes=right)
    right.set_title("loaded: first three modes, in water, with shear deflection")
    PATH.parent.mkdir(parents=True, exist_ok=True)
    FigureCanvasAgg(figure).print_png(PATH)
