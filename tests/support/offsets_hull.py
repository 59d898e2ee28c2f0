"""Hulls of other authors from their offsets, as body plans; HULLFORM_SHARED names the folder that holds them."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from hullform.body_plan import BodyPlan, Station, TracedCurve

HULLS = Path(os.environ.get("HULLFORM_SHARED", Path(__file__).parents[3] / "shared")) / "hulls"


@dataclass(frozen=True)
class Particulars:
    """As a ship.toml has them, m."""

    length_overall_m: float
    length_between_perpendiculars_m: float
    aft_perpendicular_m: float
    breadth_m: float
    depth_m: float
    draught_m: float


@dataclass(frozen=True, eq=False)
class OffsetsHull:
    """A hull as its file has it: stations, x from the aft end, and the volume below the draught that came with it."""

    name: str
    body_plan: BodyPlan
    particulars: Particulars
    volume_m3: float
    lcb_x_m: float


def hull_names() -> list[str]:
    """Of all hulls that are present."""
    return sorted(path.parent.name for path in HULLS.glob("*/offsets.json"))


def offsets_hull(name: str) -> OffsetsHull:
    """Read one; she reaches from her aftmost to her foremost station, and to her perpendiculars at the least."""
    data = json.loads((HULLS / name / "offsets.json").read_text(encoding="utf-8"))
    places = [station["x"] for station in data["stations"]]
    aft, fore = min(0.0, *places), max(data["L"], *places)
    stations = []
    for drawn in data["stations"]:
        curves = [np.array(c, dtype=float) for c in drawn.get("curves") or [drawn["points"]] if len(c) > 1]
        if curves:
            half = "aft" if drawn["x"] < data["L"] / 2 else "fore"
            stations.append(Station(drawn["x"] - aft, half, tuple(TracedCurve(*c.T) for c in curves)))  # type: ignore[arg-type]
    main = Particulars(fore - aft, data["L"], -aft, data["B"], data["D"], data["T"])
    return OffsetsHull(name, BodyPlan(tuple(stations), "offsets"), main, data["volume_to_T"], data["LCB_from_AP"] - aft)
