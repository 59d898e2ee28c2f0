"""Measure the loft on hulls of other authors and write docs/lofting.md.

    HULLFORM_SHARED=FOLDER python scripts/lofting_accuracy.py

FOLDER holds hulls/NAME/offsets.json; without the hulls nothing is written. `tests/support/offsets_hull.py` reads them.
"""

from __future__ import annotations

import itertools
import sys
import time
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from drawing.profiles import profile
from drawing.ships import outline
from drawing.waterlines import WaterlineForm
from fairness import Waves, distances, drawn_plan, waves_of, waves_of_form

from hullform.hull import Hull
from hullform.hull.crossings import crossing_triangles
from hullform.hull.outlines import area_below, contours_of, largest_distance
from hullform.profile import Profile

if TYPE_CHECKING:
    from offsets_hull import OffsetsHull

    from hullform.hull.ladder import Choice

ROOT = Path(__file__).parents[1]
OWN = ("handymax-bulk-carrier", "fast-ropax")
# Of the largest section: a station's area below the waterline counts as no less, or a counter that touches the water
# would be asked for square centimetres.
LEAST_AREA = 1e-3

HEAD = """# Lofted hulls

Twelve hulls of other authors, from tables and sliced meshes of 18 to 27 stations, lofted by `Hull.from_body_plan` with
`sections = "auto"`. Written by `scripts/lofting_accuracy.py`; the hulls carry licences of their own and are not part of
the project.

- **models**: how many stations stand as what: e super-ellipse, f flared rectellipse, t two super-ellipses, s spline,
  p traced polyline.
- **deviation**: the largest Hausdorff distance of any station of the lofted hull from the drawn one, of the breadth.
- **area**: the largest error of any station's area below the waterline, of its own area, which counts as no less than
  0.1 % of the largest section's.
- **volume**, **LCB**: below the draught, against the figures that came with the hull (301 slices of a mesh, the table's
  stations, or a formula); LCB of the length.
- **crossing**: pairs of triangles of the mesh that go through one another without a vertex in common.
- **mesh**: volume of the mesh against the integral of the sections.
- **waves**: bends of 14 waterlines between stations beyond those that the stations ask for, and the largest: its
  sagitta over the distance of the stations, of the breadth (`scripts/fairness.py`). A feature that begins between two
  stations, as a tunnel or a transom does, counts among them.
- **time**: of models and loft, processor seconds, without the mesh.

"""
BETWEEN = """
## Between the stations

Two ships of `bodyplans/`, whose form is known everywhere, lofted from their sections at the stations drawn: how far the
hull lies from the form at five places between each two stations, in per cent of the breadth, and the waves of both.
The largest distances are where something begins between two stations: the skeg, the bulb, the stem. With the profile
of the ship (`[hull] profile`) they follow it.

| ship | profile | median, % | 90 % within, % | largest, % | at x, m | waves | largest, % | of the form | largest, % |
|---|---|---|---|---|---|---|---|---|---|
"""
COLUMNS = (
    "hull", "stations", "models", "deviation, %", "area, %", "volume, %", "LCB, %", "watertight", "crossing", "mesh, %",
    "triangles", "waves", "largest, %", "time, s",
)  # fmt: skip
LETTERS = {
    "super-ellipse": "e",
    "flared rectellipse": "f",
    "two super-ellipses": "t",
    "spline": "s",
    "traced polyline": "p",
}


class Lofted(NamedTuple):
    """What a lofted hull has of the drawn one, and whether she is a body."""

    stations: int
    models: str
    deviation_percent: float
    area_error_percent: float
    volume_error_percent: float
    lcb_error_percent: float
    watertight: bool
    crossings: int
    mesh_error_percent: float
    triangles: int
    waves: Waves
    seconds: float


def measured(drawn: OffsetsHull, sections: Choice = "auto") -> Lofted:
    """Loft a hull from her offsets and measure her."""
    main = drawn.particulars
    start = time.process_time()
    hull = Hull.from_body_plan(drawn.body_plan, main, sections=sections)
    seconds = time.process_time() - start
    found = hull.hydrostatics()
    deviations, errors = [], []
    largest = float(hull.sectional_areas(main.draught_m).max())
    for station in drawn.body_plan.stations:
        true, curves = contours_of(station), hull.section_curves(station.x_m)
        if len(true) != len(curves):
            true, curves = (np.concatenate(true),), (np.concatenate(curves),)
        deviations.append(max(largest_distance(a, b) for a, b in zip(true, curves, strict=True)))
        area = sum(area_below(points, main.draught_m) for points in true)
        lofted = float(hull.sectional_areas(main.draught_m, station.x_m))
        errors.append(abs(lofted - area) / max(area, LEAST_AREA * largest))
    mesh = hull.mesh()
    counts = Counter(LETTERS[fit.model.kind] for fit in hull.fits if fit.model is not None)
    return Lofted(
        stations=len(drawn.body_plan.stations),
        models=" ".join(f"{counts[letter]}{letter}" for letter in LETTERS.values() if counts[letter]),
        deviation_percent=100 * max(deviations) / main.breadth_m,
        area_error_percent=100 * max(errors),
        volume_error_percent=100 * (found.volume_m3 / drawn.volume_m3 - 1),
        lcb_error_percent=100 * (found.lcb_x_m - drawn.lcb_x_m) / main.length_between_perpendiculars_m,
        watertight=bool(mesh.is_watertight and mesh.is_winding_consistent),
        crossings=len(crossing_triangles(np.asarray(mesh.vertices), np.asarray(mesh.faces))),
        mesh_error_percent=100 * (float(mesh.volume) / hull.volume_m3 - 1),
        triangles=len(mesh.faces),
        waves=waves_of(hull, np.unique([station.x_m for station in drawn.body_plan.stations])),
        seconds=seconds,
    )


def between_stations(ship: str, with_profile: bool) -> str:
    """The line of a ship of which the form is known everywhere."""
    form = outline(ship)
    plan = drawn_plan(form)
    if with_profile:
        assert isinstance(form, WaterlineForm)
        plan = replace(plan, profile=Profile(*profile(form).T))
    hull = Hull.from_body_plan(plan, form.particulars)
    x = np.unique([station.x_m for station in plan.stations])
    places = np.concatenate([np.linspace(a, b, 7)[1:-1] for a, b in itertools.pairwise(x)])
    apart = distances(hull, form, places)
    lofted, own = waves_of(hull, x), waves_of_form(form, x)
    return (
        f"| {ship} | {'given' if with_profile else 'none'} | {np.median(apart):.2f} | "
        f"{np.quantile(apart, 0.9):.2f} | {apart.max():.2f} | "
        f"{places[apart.argmax()]:.1f} | {lofted.count} | {lofted.largest_percent:.2f} | {own.count} | "
        f"{own.largest_percent:.2f} |\n"
    )


def main() -> None:
    """Write the page."""
    sys.path.insert(0, str(ROOT / "tests" / "support"))
    from offsets_hull import HULLS, hull_names, offsets_hull

    if not hull_names():
        sys.exit(f"no hulls at {HULLS}; HULLFORM_SHARED names the folder that holds hulls/")
    rows = ["| " + " | ".join(COLUMNS) + " |", "|---" * len(COLUMNS) + "|"]
    for name in hull_names():
        r = measured(offsets_hull(name))
        rows.append(
            f"| {name} | {r.stations} | {r.models} | {r.deviation_percent:.2f} | {r.area_error_percent:.2f} | "
            f"{r.volume_error_percent:+.2f} | {r.lcb_error_percent:+.2f} | {'yes' if r.watertight else 'no'} | "
            f"{r.crossings} | {r.mesh_error_percent:+.3f} | {r.triangles} | {r.waves.count} | "
            f"{r.waves.largest_percent:.2f} | {r.seconds:.1f} |"
        )
        print(rows[-1])
    between = "".join(between_stations(ship, given) for ship in OWN for given in (False, True))
    (ROOT / "docs" / "lofting.md").write_text(HEAD + "\n".join(rows) + "\n" + BETWEEN + between, encoding="utf-8")


if __name__ == "__main__":
    main()
