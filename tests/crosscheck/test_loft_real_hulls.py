"""Hulls of other authors, lofted from their offsets, against the volumes that came with them.

The hulls carry licences of their own and lie outside the repository: HULLFORM_SHARED points at them. One super-ellipse
a station cannot follow a bulb or a chine, so the limits are wide where a hull has them, and say so.
"""

import json
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.hull import Hull

ROOT = Path(__file__).resolve().parents[2]
HULLS = Path(os.environ.get("HULLFORM_SHARED", ROOT.parent / "shared")) / "hulls"
pytestmark = pytest.mark.skipif(not HULLS.is_dir(), reason=f"no offsets of other hulls at {HULLS}")

# Limits: moulded forms without bulb 0.5 %; bulbs, chines and skegs, which the section cannot follow, 1 and 2.5 %.
LIMITS = {
    "s60_cb60": 0.005, "s60_cb70": 0.005, "s60_cb80": 0.005, "tanker70k": 0.005, "oural": 0.005, "workboat70": 0.005,
    "wigley": 0.01, "container165": 0.01, "dtc": 0.01, "patrol27": 0.025, "dtmb5415": 0.025, "gunnerus": 0.025,
}  # fmt: skip


@dataclass(frozen=True)
class Particulars:
    length_overall_m: float
    length_between_perpendiculars_m: float
    aft_perpendicular_m: float
    breadth_m: float
    depth_m: float
    draught_m: float


@pytest.mark.parametrize("name", LIMITS)
def test_volume_and_mesh_of_a_real_hull(name: str) -> None:
    data = json.loads((HULLS / name / "offsets.json").read_text())
    first = min(s["x"] for s in data["stations"])
    length = max(s["x"] for s in data["stations"]) - first
    stations = []
    for drawn in data["stations"]:
        y, z = np.array(drawn["points"], dtype=float).T
        if len(y) > 1:
            half = "aft" if drawn["x"] - first < length / 2 else "fore"
            stations.append(Station(drawn["x"] - first, half, (TracedCurve(y, z),)))
    hull = Hull.from_body_plan(
        BodyPlan(tuple(stations), "offsets"),
        Particulars(length, data["L"], -first, data["B"], data["D"], data["T"]),
    )
    assert hull.hydrostatics().volume_m3 == pytest.approx(data["volume_to_T"], rel=LIMITS[name])
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(hull.volume_m3, rel=1e-3)
