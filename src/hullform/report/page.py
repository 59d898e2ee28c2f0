"""report.html and its figures, out of a finished run: one file that opens anywhere, with or without a network."""

from __future__ import annotations

import json
import math
import platform
from collections.abc import Iterable, Mapping
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import jinja2
import numpy as np

from hullform.afloat import RADIUS_OF_GYRATION
from hullform.checks import Check
from hullform.files import whole_file
from hullform.loading.gravity import GRAVITY_M_S2
from hullform.outcome import Run
from hullform.report import girder_figures, hull_figures, hull_view, midship_figure
from hullform.report.appendix import table_2_blocks
from hullform.report.drawing import JPEG_QUALITY, Picture, house_style
from hullform.report.published import FUNCTIONS
from hullform.report.resonance_figures import resonance_figure, response_figure
from hullform.report.springing_figure import springing_figure
from hullform.report.still_water_figure import still_water_figure
from hullform.report.water_figure import added_mass_figure
from hullform.report.wording import (
    ceiling,
    load_words,
    participation_words,
    proven_error,
    reading_of_mode,
    springing_rows,
    words_of_form,
)
from hullform.rounding import as_given, per_cent, short, signed, significant
from hullform.ship_kinds import published_like
from hullvib.model_spread import FLEXURAL_SPREAD, MASS_SPREAD, SHEAR_SPREAD, ratio_uncertainty
from hullvib.real_ships import RATIO_LIMITS, ratios, widened
from hullvib.resonance import KEEP_CLEAR

if TYPE_CHECKING:
    from hullform.picture.reading import PictureReading

REPORT_NAME = "report.html"
FIGURES_NAME = "figures"
TEMPLATE = "report.html.j2"
HEADLINE_MODES = girder_figures.SHOWN_MODES
# What the cards of the first screen call the checks; their titles in full stand with the remedies.
CHECK_LABELS = {
    "given-displacement": "Displacement at the design draught, read against given",
    "given-block-coefficient": "Block coefficient, read against given",
    "given-lcb": "Centre of buoyancy, read against given",
    "displacement": "Buoyancy at the design draught against her mass",
    "floats": "Mass against the displacement at the depth",
    "trim": "Trim in equilibrium, by the stern positive",
    "freeboard": "Least height of the deck above her waterline in equilibrium",
    "given-draughts": "Displacement at the given draughts against her mass",
    "given-trim": "Trim of the given draughts less that of the equilibrium",
    "closing": "Bending moment in still water left at the fore end",
    "light-ship": "Light ship less steel, within a factor of two of Watson’s estimate",
    "bare-light-ship": "Machinery and outfit in the light ship",
    "equivalent-thickness": "Midship second moment, given over modelled",
    "hatch-openings": "Hatch openings of a container ship over her breadth",
    "steel-estimate": "Numeral within those behind the estimated steel weight",
    "panel-volume": "Volume within the panels of the wetted hull",
    "clearance": "Depth of water over her deepest draught",
    "wet-strips": "Wet frequencies by strips against panels, with shear or without, the mode that differs most",
    "mesh-volume": "Volume of the mesh against the sections",
    "first-frequency": "First frequency, as of hulls of her length",
    "three-node-ratio": "3-node over 2-node frequency, as of ships",
    "four-node-ratio": "4-node over 2-node frequency, as of ships",
}
LIBRARIES = ("numpy", "scipy", "opencv-python-headless", "trimesh", "matplotlib")


def write_report(run: Run, folder: Path) -> None:
    """Write report.html and the folder `figures` into an existing folder.

    Args:
        run: everything the report shows; no number in it is computed here but differences and ratios.
        folder: where results.json and the mesh are written too.

    Raises:
        OutputError: a file cannot be written.
    """
    pictures = draw_pictures(run)
    (folder / FIGURES_NAME).mkdir(exist_ok=True)
    for picture in pictures.values():
        with whole_file(folder / FIGURES_NAME / picture.file_name) as aside:
            aside.write_bytes(picture.content)
    page = render(run, pictures, hull_view.viewer_page(run.hull, run.at_draught.draught_m))
    with whole_file(folder / REPORT_NAME) as aside:
        aside.write_text(page, encoding="utf-8")


def draw_pictures(run: Run) -> dict[str, Picture]:
    """Every figure of the report, by name."""
    with house_style():
        pictures = [
            *(_overlay(run, reading) for reading in (run.reading,) if reading is not None),
            hull_figures.body_plan_figure(run),
            hull_figures.area_figure(run),
            hull_view.still_picture(run.hull, run.at_draught.draught_m),
            girder_figures.mass_figure(run),
            *(still_water_figure(condition) for condition in run.conditions.values()),
            girder_figures.structure_figure(run),
            midship_figure.midship_figure(run),
            *(girder_figures.modes_figure(condition) for condition in run.conditions.values()),
            *(added_mass_figure(condition) for condition in run.conditions.values()),
            girder_figures.headline_modes_figure(run),
            girder_figures.convergence_figure(run),
            *_of_service(run),
        ]
    return {picture.name: picture for picture in pictures}


def _of_service(run: Run) -> list[Picture]:
    """What there is to draw of propeller, engine and waves."""
    pictures = []
    for name, service in run.in_service.items():
        if service.resonances is not None:
            title = run.conditions[name].condition.title
            pictures.append(resonance_figure(name, title, service.modes, service.resonances))
            if service.resonances.responses:
                pictures.append(response_figure(name, title, service.modes, service.resonances))
    return pictures if run.ship.operation is None else [*pictures, springing_figure(run)]


def render(run: Run, pictures: Mapping[str, Picture], viewer: str) -> str:
    """The page as text.

    Args:
        run: what it shows.
        pictures: of `draw_pictures`.
        viewer: the page of the inner frame, of `hull_view.viewer_page`.
    """
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("hullform.report"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(sig=significant, short=short, signed=signed, given=as_given, hz=hertz, ceiling=ceiling)
    given, weights, _ = run.ship.require_sections_of_a_run()
    context: dict[str, Any] = {
        "run": run,
        "ship": run.ship.particulars,
        "structure_given": given,
        "weights_given": weights,
        "conditions": list(run.conditions.values()),
        "modes": range(HEADLINE_MODES),
        "pictures": pictures,
        "viewer": _script_text(viewer),
        "stations": _stations(run),
        "form": words_of_form(run),
        "not_drawn": run.body_plan.source == "particulars",
        "failed": {name: failed_checks(condition.checks) for name, condition in run.conditions.items()},
        "failed_of_ship": failed_checks(run.checks),
        "check_labels": CHECK_LABELS,
        "blocks": table_2_blocks(run),
        "functions": FUNCTIONS,
        "per_cent": per_cent,
        "reading_of_mode": reading_of_mode,
        "services": [(held.condition.title, name, run.in_service[name]) for name, held in run.conditions.items()],
        "ratios": ratios,
        "ratio_limits": RATIO_LIMITS,
        "ratio_uncertainty": ratio_uncertainty,
        "widened": widened,
        "published_like": published_like(run.ship.particulars),
        "keep_clear": KEEP_CLEAR,
        "spreads": (MASS_SPREAD, FLEXURAL_SPREAD, SHEAR_SPREAD),
        "load_words": load_words,
        "participation_words": participation_words,
        "springing_rows": springing_rows,
        "errors": {name: proven_error(condition, HEADLINE_MODES) for name, condition in run.conditions.items()},
        "radius_of_gyration_m": RADIUS_OF_GYRATION * run.ship.particulars.depth_m,
        "gyration_over_depth": RADIUS_OF_GYRATION,
        "gravity": GRAVITY_M_S2,
        "at_midships": lambda values: float(np.interp(run.hull.midships_m, run.structure.x_m, values)),
        "versions": {"hullform": version("hullform"), "Python": platform.python_version()}
        | {library: version(library) for library in LIBRARIES},
    }
    return environment.get_template(TEMPLATE).render(context)


def failed_checks(checks: Iterable[Check]) -> list[Check]:
    """The checks that do not hold."""
    return [check for check in checks if not check.ok]


def hertz(angular_frequency: float) -> float:
    """rad/s to Hz."""
    return angular_frequency / (2 * math.pi)


def _overlay(run: Run, reading: PictureReading) -> Picture:
    import cv2

    from hullform.picture.overlay import draw_overlay

    _, encoded = cv2.imencode(".jpg", draw_overlay(reading), [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
    return Picture(
        "overlay",
        f"{run.ship.picture.image} as read: traced stations in colour over the faded picture.",
        f"The body plan of {run.ship.particulars.name} with the traced station curves drawn over it.",
        "jpg",
        encoded.tobytes(),
    )


def _stations(run: Run) -> list[dict[str, Any]]:
    """Each drawn station with its fit."""
    return [
        {"drawn": drawn, "fitted": fitted} for drawn, fitted in zip(run.body_plan.stations, run.hull.fits, strict=True)
    ]


def _script_text(text: str) -> str:
    """Text as a JSON string that can stand in a script element: no '<' is left in it."""
    return json.dumps(text).replace("<", "\\u003c")
