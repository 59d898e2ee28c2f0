"""The door: a ship's picture in, her body plan out."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import BodyPlan, Calibration, Half, Station, TracedCurve
from hullform.errors import PictureError
from hullform.picture.doubts import (
    NamedHalf,
    doubts_of_counts,
    doubts_of_edges,
    doubts_of_parallel_body,
    doubts_of_scale,
    doubts_of_size,
)
from hullform.picture.half import HalfReading, trace_half
from hullform.picture.ink import Picture
from hullform.picture.loose_ends import doubts_of_loose_ends
from hullform.picture.marks import near_curves, place_marks, unheeded
from hullform.picture.naming import NO_CURVE, assign_stations, half_breadths_at, mark_distances
from hullform.picture.reduction import Reduction
from hullform.picture.sheet import Sheet, prepare_sheet
from hullform.review_file import read_review
from hullform.ship import Ship

Array = NDArray[np.float64]

FEWEST_CURVES = 3  # of a half: fewer are no body plan
LOW_CONFIDENCE = 0.5


@dataclass(frozen=True, eq=False)
class PictureReading:
    """What was read from a picture, and what the overlay shows it with.

    Attributes:
        body_plan: the stations, the calibration, notes and doubts.
        grey: (rows, columns) the picture as it was read; a large one is read at a smaller size.
        reduction: from pixels of the stored picture, which the calibration means, to those of `grey`.
        path: of the picture.
        breadth_m, depth_m, draught_m: of the ship, for the lines that the overlay draws.
        left_half: which half the picture shows left.
        grid_m: spacing of buttocks and waterlines in metres, where a regular grid was found.
        sheer_m: (n, 2) [y, z] of the sheer line of each half where it was found, metres.
    """

    body_plan: BodyPlan
    grey: Picture
    reduction: Reduction
    path: Path
    breadth_m: float
    depth_m: float
    draught_m: float
    left_half: Half
    grid_m: tuple[float, float] | None
    sheer_m: dict[Half, Array]

    @property
    def calibration(self) -> Calibration:
        """Of the picture."""
        calibration = self.body_plan.calibration
        if calibration is None:
            raise PictureError(f"{self.path}: the body plan of a picture has a calibration")
        return calibration

    def side_of(self, half: Half) -> int:
        """-1 where the half is drawn left, +1 where it is drawn right."""
        return -1 if half == self.left_half else 1


def read_picture(ship: Ship) -> PictureReading:
    """Trace the stations of a body plan picture, as corrected by the review that lies beside her ship.toml.

    Args:
        ship: [ship] and [body_plan] of a ship.toml with an image.

    Raises:
        PictureError: no readable picture, no calibration, too few curves.
        ReviewError: the review is damaged, or was made of another picture.
    """
    review = read_review(ship)
    if review is not None:
        ship = review.applied_to(ship)
    return read_sheet(prepare_sheet(ship), ship)


def read_sheet(sheet: Sheet, ship: Ship) -> PictureReading:
    """Trace the stations of a sheet that is prepared; quick, so that it can be done again with other marks.

    Args:
        sheet: of the ship's picture and calibration.
        ship: her stations and marks.

    Raises:
        PictureError: too few curves.
    """
    path, source, main = sheet.path, ship.body_plan, ship.particulars
    halves: list[NamedHalf] = []
    stations: list[Station] = []
    notes, doubts = list(sheet.calibrated.notes), list(sheet.calibrated.doubts)
    named: tuple[tuple[Half, tuple[float, ...]], ...] = (
        ("aft", source.aft_stations_m),
        ("fore", source.fore_stations_m),
    )
    for half, names in named:
        prepared = sheet.halves[half]
        frame = prepared.frame
        # from the centre line outwards: the aft half from aft forward, the fore half from forward aft
        inner_first = names if half == "aft" else names[::-1]
        marks, doubts_of_marks = place_marks(
            [mark for mark in source.marks if mark.half == half], inner_first, frame, sheet.size_px, sheet.reduction
        )
        reading = trace_half(prepared, len(names), [(m.station, m.y_px, m.z_px) for m in marks])
        if len(reading.curves) < min(FEWEST_CURVES, len(names)):
            raise PictureError(
                f"{path}: too few curves: {len(reading.curves)} found in the {half} half, which has {len(names)} "
                f"stations ({half}_stations_m); "
                "check aft_side, breadth_m, depth_m and the calibration, or give a clearer picture"
            )
        marks, doubts_of_places = near_curves(marks, reading.curves, frame.half_breadth_px)
        at = [(mark.station, mark.y_px, mark.z_px) for mark in marks]
        assigned = assign_stations(
            inner_first,
            half_breadths_at(reading.curves, frame.half_breadth_px),
            reading.confidences,
            mark_distances(reading.curves, at, len(names)),
        )
        stations += _stations(reading, inner_first, assigned, notes, doubts)
        doubts += doubts_of_marks + doubts_of_places
        doubts += unheeded(marks, reading.curves, assigned, frame.half_breadth_px)
        halves.append(NamedHalf(reading, inner_first, tuple(assigned)))
    readings = [half.reading for half in halves]
    doubts += doubts_of_scale(str(path), readings, sheet.ink, sheet.bare, main.breadth_m, main.depth_m)
    doubts += doubts_of_counts(halves)
    doubts += doubts_of_parallel_body(halves, main.length_between_perpendiculars_m)
    doubts += doubts_of_size(path.name, readings)
    doubts += doubts_of_edges(readings, sheet.bare)
    doubts += doubts_of_loose_ends(halves)
    calibration = sheet.calibrated.calibration
    body_plan = BodyPlan(tuple(stations), "picture", sheet.reduction.stored(calibration), tuple(notes), tuple(doubts))
    scale = calibration.metres_per_px
    sheer_m = {
        reading.half: np.column_stack([reading.sheer.y_px, reading.sheer.z_px]) * scale
        for reading in readings
        if reading.sheer is not None
    }
    return PictureReading(
        body_plan,
        sheet.grey,
        sheet.reduction,
        path,
        main.breadth_m,
        main.depth_m,
        main.draught_m,
        "aft" if source.aft_side == "left" else "fore",
        sheet.calibrated.grid_m,
        sheer_m,
    )


def _stations(
    reading: HalfReading, inner_first: tuple[float, ...], assigned: list[int], notes: list[str], doubts: list[str]
) -> list[Station]:
    """The stations of a half with their curves in metres; reports what was shared and what was not sure."""
    scale = reading.frame.metres_per_px
    curves = []
    for points, confidence in zip(reading.curves, reading.confidences, strict=True):
        curves.append(TracedCurve(points[:, 0] * scale, points[:, 1] * scale, confidence))
    stations = []
    for x, number in zip(inner_first, assigned, strict=True):
        if number == NO_CURVE:
            doubts.append(
                f"station {x:g} m ({reading.half} half): not found; mark a point of its curve in [[body_plan.marks]]"
            )
            continue
        others = tuple(sorted(o for o, n in zip(inner_first, assigned, strict=True) if n == number and o != x))
        stations.append(Station(x, reading.half, (curves[number],), shared_with_m=others))
        if curves[number].confidence < LOW_CONFIDENCE:
            doubts.append(
                f"station {x:g} m ({reading.half} half): traced with confidence {curves[number].confidence:.2f}; "
                "look at it in the overlay"
            )
    named = set(assigned) - {NO_CURVE}
    for number in sorted(named):
        shared = sorted(x for x, n in zip(inner_first, assigned, strict=True) if n == number)
        if len(shared) > 1:
            words = ", ".join(f"{x:g}" for x in shared)
            notes.append(f"{reading.half} half: stations {words} m share one drawn curve (parallel body)")
            if number != len(curves) - 1:
                doubts.append(
                    f"stations {words} m of the {reading.half} half share a curve that is not the outermost; "
                    "check their marks"
                )
    unnamed = len(curves) - len(named) - reading.unlisted
    if unnamed > 0:
        doubts.append(f"{unnamed} curves of the {reading.half} half have no station; check {reading.half}_stations_m")
    found = f"{len(named)} curves for {len(inner_first)} stations"
    deck = "sheer line found" if reading.sheer is not None else "no sheer line beside the deck line"
    notes.append(f"{reading.half} half: {found}; {deck}")
    return stations
