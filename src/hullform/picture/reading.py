"""The door: a ship's picture in, her body plan out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import BodyPlan, Calibration, Half, Station, TracedCurve
from hullform.corrections import Correction, Drawn
from hullform.errors import PictureError
from hullform.picture.contours import NO_LOOP, marks_on_loops, pair_loops
from hullform.picture.corrected import correct_ink
from hullform.picture.crosschecks import crosscheck
from hullform.picture.doubts import (
    NamedHalf,
    doubts_below_base,
    doubts_of_counts,
    doubts_of_edges,
    doubts_of_keel,
    doubts_of_parallel_body,
    doubts_of_scale,
)
from hullform.picture.effects import Unheeded, unheeded_corrections
from hullform.picture.half import HalfReading, trace_half
from hullform.picture.image_files import Picture
from hullform.picture.input_check import check_input
from hullform.picture.likeness import explained
from hullform.picture.marks import near_curves, place_marks, unheeded
from hullform.picture.naming import NO_CURVE, assign_stations, half_breadths_at, mark_distances
from hullform.picture.placing import place_corrections
from hullform.picture.reduction import Reduction
from hullform.picture.seen import SeenCurve, StationDoubt, UnusedLine, seen_curves, unused_lines
from hullform.picture.sheet import Sheet, prepare_sheet
from hullform.review_file import read_review
from hullform.ship import Mark, Ship

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
        curves: what was traced, with and without a station, in pixels of the stored picture.
        unused: lines that no curve took.
        station_doubts: the doubts of the body plan that are about one station.
        unheeded: corrections that changed nothing.
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
    curves: tuple[SeenCurve, ...]
    unused: tuple[UnusedLine, ...]
    station_doubts: tuple[StationDoubt, ...]
    unheeded: tuple[Unheeded, ...]

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
    corrections: Sequence[Correction] = ()
    if review is not None:
        ship, corrections = review.applied_to(ship), review.corrections
    sheet = prepare_sheet(ship)
    with explained(str(sheet.path), sheet.ink, ship.particulars.breadth_m, ship.particulars.depth_m):
        return read_sheet(sheet, ship, corrections)


def read_sheet(sheet: Sheet, ship: Ship, corrections: Sequence[Correction] = ()) -> PictureReading:
    """Trace the stations of a sheet that is prepared; quick, so that it can be done again with other corrections.

    Args:
        sheet: of the ship's picture and calibration.
        ship: her stations and marks, those of `corrections` among them.
        corrections: a person's, of the picture.

    Raises:
        PictureError: too few curves.
    """
    path, source, main = sheet.path, ship.body_plan, ship.particulars
    halves: list[NamedHalf] = []
    stations: list[Station] = []
    notes, doubts = list(sheet.calibrated.notes), list(sheet.calibrated.doubts)
    station_doubts: list[StationDoubt] = []
    curves: list[SeenCurve] = []
    unused: list[UnusedLine] = []
    placed = place_corrections(corrections, {half: ink.frame for half, ink in sheet.halves.items()}, sheet.reduction)
    of_lines: set[str] = set()
    of_ink: set[str] = set()
    used_marks: set[Mark] = set()
    named: tuple[tuple[Half, tuple[float, ...]], ...] = (
        ("aft", source.aft_stations_m),
        ("fore", source.fore_stations_m),
    )
    for half, names in named:
        prepared, heeded = correct_ink(sheet.halves[half], placed[half])
        of_ink |= heeded
        frame = prepared.frame
        # from the centre line outwards: the aft half from aft forward, the fore half from forward aft
        inner_first = names if half == "aft" else names[::-1]
        by_hand = {(c.station_m, c.curve) for c in corrections if isinstance(c, Drawn) and c.half == half}
        marks, doubts_of_marks = place_marks(
            [mark for mark in source.marks if mark.half == half and (mark.station_m, mark.curve) not in by_hand],
            inner_first,
            frame,
            sheet.size_px,
            sheet.reduction,
        )
        reading = trace_half(prepared, len(names), tuple((m.y_px, m.z_px) for m in marks), placed[half])
        if len(reading.curves) < min(FEWEST_CURVES, len(names)):
            raise PictureError(
                f"{path}: too few curves: {len(reading.curves)} found in the {half} half, which has {len(names)} "
                f"stations ({half}_stations_m); "
                "check aft_side, breadth_m, depth_m and the calibration, or give a clearer picture"
            )
        loops = [loop.points for loop in reading.loops]
        marks, on_loops = marks_on_loops(marks, reading.curves, loops, frame.half_breadth_px)
        used_marks |= {mark.mark for mark, _ in on_loops}
        marks, doubts_of_places = near_curves(marks, reading.curves, frame.half_breadth_px)
        at = [(mark.station, mark.y_px, mark.z_px) for mark in marks]
        assigned = assign_stations(
            inner_first,
            half_breadths_at(reading.curves, frame.half_breadth_px),
            reading.confidences,
            mark_distances(reading.curves, at, len(names)),
            [(_index(inner_first, x), number) for number, x in reading.drawn],
        )
        second = pair_loops(
            loops,
            [None if number == NO_CURVE else reading.curves[number] for number in assigned],
            frame.half_breadth_px,
            [(mark.station, loop) for mark, loop in on_loops],
            [_index(inner_first, x) for x, _ in reading.second_contours],
        )
        used_marks |= {mark.mark for mark in marks}
        of_lines |= set(reading.unheeded)
        named_here, doubts_here = _stations(reading, inner_first, assigned, second, notes, doubts)
        stations += named_here
        station_doubts += doubts_here
        curves += seen_curves(
            reading, _by_curve(inner_first, assigned), _by_curve(inner_first, second), sheet.reduction
        )
        unused += unused_lines(reading, sheet.reduction)
        doubts += [doubt.text for doubt in doubts_here] + doubts_of_marks + doubts_of_places
        doubts += unheeded(marks, reading.curves, assigned, frame.half_breadth_px)
        halves.append(NamedHalf(reading, inner_first, tuple(assigned)))
    without_effect = unheeded_corrections(corrections, of_lines, of_ink, used_marks)
    doubts += [item.text for item in without_effect]
    readings = [half.reading for half in halves]
    doubts += doubts_of_scale(str(path), readings, sheet.ink, sheet.bare, main.breadth_m, main.depth_m)
    doubts += doubts_below_base(readings, sheet.bare) + doubts_of_keel(readings, main.depth_m)
    doubts += doubts_of_counts(halves)
    doubts += doubts_of_parallel_body(halves, main.length_between_perpendiculars_m)
    doubts += crosscheck(stations, main, ship.water)
    fine_notes, fine_doubts = check_input(path.name, sheet.halves.values(), sheet.size_px[0])
    notes += fine_notes
    doubts += fine_doubts
    doubts += doubts_of_edges(readings, sheet.bare)
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
        tuple(curves),
        tuple(unused),
        tuple(station_doubts),
        without_effect,
    )


def _index(inner_first: tuple[float, ...], station_m: float) -> int:
    return int(np.argmin([abs(x - station_m) for x in inner_first]))


def _by_curve(inner_first: tuple[float, ...], assigned: list[int]) -> dict[int, list[float]]:
    out: dict[int, list[float]] = {}
    for x, number in zip(inner_first, assigned, strict=True):
        out.setdefault(number, []).append(x)
    return out


def _in_metres(points_px: Array, metres_per_px: float, confidence: float) -> TracedCurve:
    return TracedCurve(points_px[:, 0] * metres_per_px, points_px[:, 1] * metres_per_px, confidence)


def _stations(
    reading: HalfReading,
    inner_first: tuple[float, ...],
    assigned: list[int],
    second: list[int],
    notes: list[str],
    doubts: list[str],
) -> tuple[list[Station], list[StationDoubt]]:
    """The stations of a half with their curves in metres, and which are not sure; reports what was shared."""
    scale = reading.frame.metres_per_px
    curves = [
        _in_metres(points, scale, confidence)
        for points, confidence in zip(reading.curves, reading.confidences, strict=True)
    ]
    contours = {
        place: _in_metres(reading.loops[loop].points, scale, reading.loops[loop].confidence)
        for place, loop in enumerate(second)
        if loop != NO_LOOP
    }
    contours |= {_index(inner_first, x): _in_metres(points, scale, 1.0) for x, points in reading.second_contours}
    stations: list[Station] = []
    unsure: list[StationDoubt] = []
    for place, (x, number) in enumerate(zip(inner_first, assigned, strict=True)):
        further = (contours[place],) if place in contours else ()
        if number == NO_CURVE:
            what = "only a contour that closes on the centre line was found" if further else "not found"
            text = f"station {x:g} m ({reading.half} half): {what}; mark a point of its curve in [[body_plan.marks]]"
            unsure.append(StationDoubt(x, reading.half, text))
            if further:
                stations.append(Station(x, reading.half, further))
            continue
        others = tuple(sorted(o for o, n in zip(inner_first, assigned, strict=True) if n == number and o != x))
        stations.append(Station(x, reading.half, (curves[number], *further), shared_with_m=others))
        if curves[number].confidence < LOW_CONFIDENCE:
            text = (
                f"station {x:g} m ({reading.half} half): traced with confidence {curves[number].confidence:.2f}; "
                "look at it in the overlay"
            )
            unsure.append(StationDoubt(x, reading.half, text))
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
    return stations, unsure
