"""The door: a ship's picture in, her body plan out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import BodyPlan, Calibration, Half
from hullform.corrections import Correction
from hullform.errors import PictureError
from hullform.picture.checking.crosschecks import crosscheck
from hullform.picture.checking.doubts import (
    doubts_below_base,
    doubts_of_counts,
    doubts_of_decks,
    doubts_of_edges,
    doubts_of_keel,
    doubts_of_scale,
    doubts_of_the_whole,
)
from hullform.picture.checking.effects import Unheeded, unheeded_corrections
from hullform.picture.checking.loose_ends import doubts_of_loose_ends
from hullform.picture.checking.parallel_body import doubts_of_parallel_body
from hullform.picture.edits.placing import place_corrections
from hullform.picture.image.image_files import Picture
from hullform.picture.image.reduction import Reduction
from hullform.picture.naming.label_doubts import doubts_of_sides
from hullform.picture.naming.named_half import read_half
from hullform.picture.naming.seen import SeenCurve, StationDoubt, UnusedLine
from hullform.picture.sheet.input_check import check_input
from hullform.picture.sheet.likeness import explained
from hullform.picture.sheet.sheet import HALVES, Sheet, prepare_sheet
from hullform.review_file import read_review
from hullform.ship import Ship

Array = NDArray[np.float64]

LABELS_NOT_READ = (
    "the labels of the drawing were not read, so that nothing speaks for or against the names: install the extra 'ocr' "
    "(pip install 'hullform[ocr]')"
)


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

    The notes then name the review first.

    Args:
        ship: [ship] and [body_plan] of a ship.toml with an image.

    Raises:
        PictureError: no readable picture, no calibration, too few curves.
        ReviewError: the review is damaged, or was made of another picture.
    """
    review = read_review(ship)
    corrections: Sequence[Correction] = ()
    notes: tuple[str, ...] = ()
    if review is not None:
        notes = (f"{ship.review_path.name} goes before {ship.path.name}; it gives {review.account}",)
        ship, corrections = review.applied_to(ship), review.corrections
    try:
        reading = read_sheet(prepare_sheet(ship), ship, corrections)
    except PictureError:
        _require_no_quarter_turn(ship, corrections)
        raise
    if doubts_of_the_whole(len(reading.body_plan.doubts) - 1, _listed(ship)):
        _require_no_quarter_turn(ship, corrections)
    return replace(reading, body_plan=replace(reading.body_plan, notes=(*notes, *reading.body_plan.notes)))


def _listed(ship: Ship) -> int:
    return sum(len(ship.picture.names_of(half).positions_m) for half in HALVES)


def _require_no_quarter_turn(ship: Ship, corrections: Sequence[Correction]) -> None:
    """Refuse a picture that cannot be read as it is, but turned by 90 degrees can.

    Args:
        ship: of the picture; with marks or a calibration a person has seen it upright.
        corrections: likewise.

    Raises:
        PictureError: it lies on its side.
    """
    if ship.picture.marks or ship.picture.calibration or corrections:
        return
    path = ship.picture.image_path
    for quarter_turns, direction in ((1, "counterclockwise"), (-1, "clockwise")):
        try:
            turned = read_sheet(prepare_sheet(ship, quarter_turns), ship).body_plan
        except PictureError:
            continue
        if not doubts_of_the_whole(len(turned.doubts), _listed(ship)):
            raise PictureError(
                f"{path}: the picture lies on its side: turned by 90 degrees {direction} it reads as this ship's body "
                f"plan, with {len(turned.doubts)} doubts; turn the picture so"
            ) from None


def read_sheet(sheet: Sheet, ship: Ship, corrections: Sequence[Correction] = ()) -> PictureReading:
    """Trace the stations of a sheet that is prepared; quick, so that it can be done again with other corrections.

    Args:
        sheet: of the ship's picture and calibration.
        ship: her stations and marks, those of `corrections` among them.
        corrections: a person's, of the picture.

    Raises:
        PictureError: too few curves; the message says what the picture looks like, where that is known.
    """
    main = ship.particulars
    with explained(str(sheet.path), sheet.ink, main.breadth_m, main.depth_m):
        return _read(sheet, ship, corrections)


def _read(sheet: Sheet, ship: Ship, corrections: Sequence[Correction]) -> PictureReading:
    path, source, main = sheet.path, ship.picture, ship.particulars
    named_at_all = bool(source.aft_station_names or source.fore_station_names)
    labels = sheet.labels if named_at_all else ()
    placed = place_corrections(corrections, {half: ink.frame for half, ink in sheet.halves.items()}, sheet.reduction)
    halves = [read_half(sheet, ship, half, corrections, placed[half], labels or ()) for half in HALVES]
    readings = [half.reading for half in halves]
    stations = [station for half in halves for station in half.stations]
    without_effect = unheeded_corrections(
        corrections,
        {id for half in halves for id in half.reading.unheeded if id not in half.confirmed},
        {id for half in halves for id in half.heeded_by_ink},
        {mark for half in halves for mark in half.used_marks},
    )
    doubts_of_stations = [
        *(doubt for half in halves for doubt in half.doubts),
        *(item.text for item in without_effect),
        *doubts_of_scale(
            str(path),
            readings,
            sheet.ink,
            sheet.bare,
            main.breadth_m,
            main.depth_m,
            by_grid=sheet.calibrated.grid_m is not None,
        ),
        *doubts_below_base(readings, sheet.bare),
        *doubts_of_keel(readings, main.depth_m),
        *doubts_of_counts(halves, main.draught_m),
        *doubts_of_parallel_body(halves, main.length_between_perpendiculars_m),
        *doubts_of_sides([half.labels for half in halves]),
        *crosscheck(stations, main, ship.water),
    ]
    notes_of_input, doubts_of_input = check_input(path.name, sheet.halves.values(), sheet.size_px[0])
    notes = [*sheet.calibrated.notes, *(note for half in halves for note in half.notes), *notes_of_input]
    if labels is None:
        notes.append(LABELS_NOT_READ)
    doubts = [*sheet.calibrated.doubts, *doubts_of_stations, *doubts_of_input, *doubts_of_edges(readings, sheet.bare)]
    doubts += [*doubts_of_decks(halves, sheet.bare), *doubts_of_loose_ends(halves)]
    doubts = [*doubts_of_the_whole(len(doubts), sum(len(half.inner_first) for half in halves)), *doubts]
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
        tuple(curve for half in halves for curve in half.curves),
        tuple(line for half in halves for line in half.unused),
        tuple(doubt for half in halves for doubt in half.unsure),
        without_effect,
    )
