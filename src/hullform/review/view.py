"""What the page is told of a reading: one JSON document, places in pixels of the stored picture."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Calibration, Half, Station
from hullform.picture.naming.seen import SeenCurve
from hullform.picture.reading import PictureReading
from hullform.picture.sheet.sheet import HALVES, Sheet
from hullform.review.evidence import Evidence
from hullform.review.form import waterlines
from hullform.ship import Ship
from hullform.station_names import StationNames

Array = NDArray[np.float64]
Document = dict[str, Any]

SURE, FAIR = 0.8, 0.5  # confidence from which a curve is shown as sure, and as fair
WATERLINE_SHARES = (0.25, 0.5, 0.75, 1.0)  # of the draught
SHOWN_STEP = 2  # every so many points of a curve are drawn: they lie a pixel or two apart


def reading_document(sheet: Sheet, reading: PictureReading, ship: Ship) -> Document:
    """The calibration, curves, stations, areas, waterlines and doubts of a reading.

    Args:
        sheet: that was traced.
        reading: what was found in it.
        ship: as the review has her, with the stations that are looked for.
    """
    stations = reading.body_plan.stations
    heights = [share * reading.draught_m for share in WATERLINE_SHARES]
    heights.append((reading.draught_m + reading.depth_m) / 2)
    evidence = {half: Evidence(sheet.halves[half], sheet.reduction) for half in HALVES}
    names = {half: ship.picture.names_of(half) for half in HALVES}
    curves = [_curve(seen, evidence[seen.half], names[seen.half]) for seen in reading.curves]
    return {
        "calibration": calibration_document(reading.calibration, sheet),
        "left_half": reading.left_half,
        "line_width_px": max(half.line_width_px for half in sheet.halves.values()) * sheet.reduction.across,
        "curves": curves,
        "unused": [{"half": line.half, "px": _thinned(line.px)} for line in reading.unused],
        "halves": [_half(half, ship, stations, curves) for half in HALVES],
        "sheer": {half: _pixels(reading, half, points).tolist() for half, points in reading.sheer_m.items()},
        "areas": [
            {
                "half": station.half,
                "x_m": station.x_m,
                "area_m2": station.area_below(reading.draught_m),
                "confidence": station.confidence,
            }
            for station in stations
        ],
        "waterlines": [
            {"height_m": height, "points": points}
            for height, points in zip(heights, waterlines(stations, heights), strict=True)
        ],
        "notes": list(reading.body_plan.notes),
        "doubts": list(reading.body_plan.doubts),
        "station_doubts": [
            {"half": doubt.half, "x_m": doubt.station_m, "text": doubt.text} for doubt in reading.station_doubts
        ],
        "unheeded": {correction.id: correction.text for correction in reading.unheeded},
    }


def calibration_document(calibration: Calibration, sheet: Sheet) -> Document:
    """The figures of a calibration, its map from metres to pixels, and the grid that was found."""
    return {
        "centreline_px": calibration.centreline_px,
        "baseline_px": calibration.baseline_px,
        "metres_per_px": calibration.metres_per_px,
        "rotation_deg": calibration.rotation_deg,
        "residual_px": calibration.residual_px,
        "source": calibration.source,
        "pixel_from_metres": [list(row) for row in calibration.pixel_from_metres],
        "grid_m": None if sheet.calibrated.grid_m is None else list(sheet.calibrated.grid_m),
    }


def standing(confidence: float) -> Literal["sure", "fair", "poor"]:
    """The class that a curve is coloured by."""
    if confidence >= SURE:
        return "sure"
    return "fair" if confidence >= FAIR else "poor"


def _half(half: Half, ship: Ship, stations: tuple[Station, ...], curves: list[Document]) -> Document:
    names = ship.picture.names_of(half)
    found = {station.x_m: station for station in stations if station.half == half}
    residual: dict[float, float] = {}
    for curve in curves:
        if curve["half"] == half and curve["residual_px"] is not None:
            for x in curve["stations_m"]:
                residual[x] = max(residual.get(x, 0.0), curve["residual_px"])
    rows = []
    for x in names.positions_m:
        station = found.get(x)
        rows.append(
            {
                "x_m": x,
                "name": names.of(x),
                "standing": "missing" if station is None else standing(station.confidence),
                "confidence": None if station is None else station.confidence,
                "shared_with_m": [] if station is None else list(station.shared_with_m),
                "curves": 0 if station is None else len(station.curves),
                "residual_px": residual.get(x),
            }
        )
    return {"half": half, "expected": len(rows), "found": sum(x in found for x in names.positions_m), "stations": rows}


def _curve(seen: SeenCurve, evidence: Evidence, names: StationNames) -> Document:
    ends = dict.fromkeys((*seen.stations_m[:1], *seen.stations_m[-1:]))
    label = "–".join(names.of(x) or f"{x:g}" for x in ends) or "?"
    return {
        "half": seen.half,
        "stations_m": list(seen.stations_m),
        "label": label,
        "curve": seen.number,
        "standing": _standing_of(seen),
        "confidence": seen.confidence,
        "residual_px": evidence.residual_px(seen.px),
        "px": _thinned(seen.px),
    }


def _standing_of(seen: SeenCurve) -> str:
    if seen.by_hand:
        return "drawn"
    return standing(seen.confidence) if seen.stations_m else "unnamed"


def _pixels(reading: PictureReading, half: Half, points_m: Array) -> Array:
    """(n, 2) stored pixels of points [half-breadth, height] in metres."""
    return reading.calibration.pixels(points_m * np.array([reading.side_of(half), 1]))


def _thinned(px: Array) -> list[list[float]]:
    keep = np.zeros(len(px), dtype=np.bool_)
    keep[::SHOWN_STEP] = keep[-1] = True
    rounded: list[list[float]] = np.round(px[keep], 2).tolist()
    return rounded
