"""One half with its stations: its curves are traced, and each is given the name of its station."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Half, Station, TracedCurve
from hullform.corrections import Correction, Crossing, Drawn
from hullform.errors import PictureError
from hullform.picture.edits.corrected import correct_ink
from hullform.picture.edits.placing import Placed
from hullform.picture.image.labels import Label
from hullform.picture.naming.alignment import NO_CURVE, assign_stations, certainties, half_breadths_at, mark_distances
from hullform.picture.naming.contours import NO_LOOP, marks_on_loops, pair_loops
from hullform.picture.naming.crossings import crossings
from hullform.picture.naming.label_doubts import doubts_of_labels
from hullform.picture.naming.marks import PlacedMark, near_curves, place_marks, unheeded
from hullform.picture.naming.proposals import LabelledHalf, label_costs, label_half
from hullform.picture.naming.rejoining import rejoined
from hullform.picture.naming.seen import SeenCurve, StationDoubt, UnusedLine, seen_curves, unused_lines
from hullform.picture.sheet.sheet import Sheet
from hullform.picture.tracing.half import HalfReading, trace_half
from hullform.ship import Ship
from hullform.ship_body_plan import Mark
from hullform.station_names import StationNames

Array = NDArray[np.float64]

FEWEST_CURVES = 3  # of a half: fewer are no body plan
LOW_CONFIDENCE = 0.5
CROSSED = 0.6  # confidence in either of two curves that cross: one of them may be the other's
NEAR_CROSSING = 0.08  # of B/2: what a person says of a crossing holds so far


@dataclass(frozen=True, eq=False)
class NamedHalf:
    """One half with its stations.

    Attributes:
        reading: its curves.
        inner_first: its stations from the centre line outwards, m.
        assigned: index of the curve that each of them got, or `NO_CURVE`.
        names: what the drawing calls them.
        labels: of the drawing that stand at its curves.
        stations: with their curves in metres.
        curves, unused, unsure: for a page that shows the reading.
        heeded_by_ink: ids of corrections that changed its ink; `confirmed`: of those that say what was read anyway.
        used_marks: that lie on a curve.
        notes, doubts: in words.
    """

    reading: HalfReading
    inner_first: tuple[float, ...]
    assigned: tuple[int, ...]
    names: StationNames
    labels: LabelledHalf
    stations: tuple[Station, ...]
    curves: tuple[SeenCurve, ...]
    unused: tuple[UnusedLine, ...]
    unsure: tuple[StationDoubt, ...]
    heeded_by_ink: Collection[str]
    confirmed: Collection[str]
    used_marks: Collection[Mark]
    notes: tuple[str, ...]
    doubts: tuple[str, ...]

    @property
    def shared(self) -> tuple[float, ...]:
        """The stations of the parallel body: those that share the outermost curve."""
        outermost = len(self.reading.curves) - 1
        names = [x for x, n in zip(self.inner_first, self.assigned, strict=True) if n == outermost]
        return tuple(sorted(names)) if len(names) > 1 else ()


def read_half(
    sheet: Sheet,
    ship: Ship,
    half: Half,
    corrections: Sequence[Correction],
    placed: Sequence[Placed],
    labels: Sequence[Label],
) -> NamedHalf:
    """Trace one half and name its curves.

    Args:
        sheet: of the ship's picture.
        ship: her stations and marks, those of `corrections` among them.
        half: which.
        corrections: a person's, of the whole picture; `placed`: those of this half in its frame.
        labels: words on the picture.

    Raises:
        PictureError: too few curves.
    """
    source = ship.picture
    names = source.names_of(half)
    prepared, heeded = correct_ink(sheet.halves[half], placed)
    frame, size = prepared.frame, prepared.frame.half_breadth_px
    # from the centre line outwards: the aft half from aft forward, the fore half from forward aft
    inner_first = names.positions_m if half == "aft" else names.positions_m[::-1]
    by_hand = {(c.station_m, c.curve) for c in corrections if isinstance(c, Drawn) and c.half == half}
    marks, doubts_of_marks = place_marks(
        [mark for mark in source.marks if mark.half == half and (mark.station_m, mark.curve) not in by_hand],
        inner_first,
        frame,
        sheet.size_px,
        sheet.reduction,
    )
    reading = trace_half(prepared, len(inner_first), [(m.station, m.y_px, m.z_px) for m in marks], placed)
    if len(reading.curves) < min(FEWEST_CURVES, len(inner_first)):
        raise PictureError(
            f"{sheet.path}: too few curves: {len(reading.curves)} found in the {half} half, which has "
            f"{len(inner_first)} stations ({half}_stations_m); "
            "check aft_side, breadth_m, depth_m and the calibration, or give a clearer picture"
        )
    loops = [loop.points for loop in reading.loops]
    marks, on_loops = marks_on_loops(marks, reading.curves, loops, size)
    marks, doubts_of_places = near_curves(marks, reading.curves, size)
    labelled = label_half(labels, frame, names, inner_first)
    touching = rejoined(
        reading, inner_first, names, marks, placed, lambda used: _assigned(reading, inner_first, used, labelled)
    )
    reading = touching.reading
    assigned = _assigned(reading, inner_first, marks, labelled)
    second = pair_loops(
        loops,
        [None if number == NO_CURVE else reading.curves[number] for number in assigned],
        size,
        [(mark.station, loop) for mark, loop in on_loops],
        [_index(inner_first, x) for x, _ in reading.second_contours],
    )
    doubts_of_crossings, confirmed, crossed = _crossings(reading, inner_first, assigned, names, placed)
    confidences = [min(c, CROSSED) if n in crossed else c for n, c in enumerate(reading.confidences)]
    reading = replace(reading, confidences=tuple(confidences))
    stations, unsure = _stations(reading, inner_first, assigned, second, names)
    notes, doubts_of_sharing = _account(reading, inner_first, assigned, second, names)
    return NamedHalf(
        reading=reading,
        inner_first=inner_first,
        assigned=tuple(assigned),
        names=names,
        labels=labelled,
        stations=tuple(stations),
        curves=tuple(
            seen_curves(reading, _by_curve(inner_first, assigned), _by_curve(inner_first, second), sheet.reduction)
        ),
        unused=tuple(unused_lines(reading, sheet.reduction)),
        unsure=tuple(unsure),
        heeded_by_ink=heeded,
        confirmed=confirmed,
        used_marks={mark.mark for mark in (*marks, *(mark for mark, _ in on_loops))},
        notes=(*notes, *touching.notes),
        doubts=(
            *doubts_of_sharing,
            *(doubt.text for doubt in unsure),
            *doubts_of_marks,
            *doubts_of_places,
            *unheeded(marks, reading.curves, assigned, size),
            *doubts_of_labels(labelled, reading.curves, assigned),
            *touching.doubts,
            *doubts_of_crossings,
        ),
    )


def _assigned(
    reading: HalfReading, inner_first: tuple[float, ...], marks: Sequence[PlacedMark], labelled: LabelledHalf
) -> list[int]:
    """The curve of each station."""
    return assign_stations(
        inner_first,
        half_breadths_at(reading.curves, reading.frame.half_breadth_px),
        certainties(reading.curves, reading.confidences),
        mark_distances(reading.curves, [(mark.station, mark.y_px, mark.z_px) for mark in marks], len(inner_first)),
        [(_index(inner_first, x), number) for number, x in reading.drawn],
        label_costs(labelled.named, reading.curves, len(inner_first)),
    )


def _index(inner_first: tuple[float, ...], station_m: float) -> int:
    return int(np.argmin([abs(x - station_m) for x in inner_first]))


def _by_curve(inner_first: tuple[float, ...], assigned: Sequence[int]) -> dict[int, list[float]]:
    out: dict[int, list[float]] = {}
    for x, number in zip(inner_first, assigned, strict=True):
        out.setdefault(number, []).append(x)
    return out


def _in_metres(points_px: Array, metres_per_px: float, confidence: float) -> TracedCurve:
    return TracedCurve(points_px[:, 0] * metres_per_px, points_px[:, 1] * metres_per_px, confidence)


def _stations(
    reading: HalfReading, inner_first: tuple[float, ...], assigned: list[int], second: list[int], names: StationNames
) -> tuple[list[Station], list[StationDoubt]]:
    """The stations of a half with their curves in metres, and which are not sure."""
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
            text = f"{names.one(x)}: {what}; mark a point of its curve in [[body_plan.marks]]"
            unsure.append(StationDoubt(x, reading.half, text))
            if further:
                stations.append(Station(x, reading.half, further, names.of(x)))
            continue
        others = tuple(sorted(o for o, n in zip(inner_first, assigned, strict=True) if n == number and o != x))
        stations.append(Station(x, reading.half, (curves[number], *further), names.of(x), others))
        if curves[number].confidence < LOW_CONFIDENCE:
            text = f"{names.one(x)}: traced with confidence {curves[number].confidence:.2f}; look at it in the overlay"
            unsure.append(StationDoubt(x, reading.half, text))
    return stations, unsure


def _crossings(
    reading: HalfReading,
    inner_first: tuple[float, ...],
    assigned: list[int],
    names: StationNames,
    placed: Sequence[Placed],
) -> tuple[list[str], set[str], set[int]]:
    """Doubts about neighbours that cross, unless a person drew one; who said that they do; which are in doubt."""
    scale, reach = reading.frame.metres_per_px, NEAR_CROSSING * reading.frame.half_breadth_px
    said = {item.correction.id: item.yz[0] for item in placed if isinstance(item.correction, Crossing)}
    by_hand = {number for number, _ in reading.drawn}
    stations = {number: places[0] for number, places in _by_curve(inner_first, assigned).items()}
    doubts: list[str] = []
    confirmed: set[str] = set()
    crossed: set[int] = set()
    for inner, outer, y, z in crossings(reading.curves, reading.frame):
        known = inner in stations and outer in stations and not {inner, outer} & by_hand
        here = {id for id, at in said.items() if np.hypot(at[0] - y, at[1] - z) < reach}
        confirmed |= here
        if known and not here:
            crossed |= {inner, outer}
            doubts.append(
                f"{names.one(stations[inner])} crosses {names.one(stations[outer])} near y {y * scale:.2f} "
                f"z {z * scale:.2f} m; look at it in the overlay; where it is drawn so, say 'cross' on the review page"
            )
    return doubts, confirmed, crossed


def _account(
    reading: HalfReading, inner_first: tuple[float, ...], assigned: list[int], second: list[int], names: StationNames
) -> tuple[list[str], list[str]]:
    """Notes and doubts on which curves are shared and which have no station."""
    half, notes, doubts = reading.half, [], []
    named = set(assigned) - {NO_CURVE}
    for number in sorted(named):
        shared = sorted(x for x, n in zip(inner_first, assigned, strict=True) if n == number)
        if len(shared) > 1:
            words = names.several(shared)
            notes.append(f"{half} half: stations {words} share one drawn curve (parallel body)")
            if number != len(reading.curves) - 1:
                doubts.append(
                    f"stations {words} of the {half} half share a curve that is not the outermost; check their marks"
                )
    unnamed = len(reading.curves) - len(named) - reading.unlisted
    if unnamed > 0:
        doubts.append(f"{unnamed} curves of the {half} half have no station; check {half}_stations_m")
    lost = len(reading.loops) - len(set(second) - {NO_LOOP})
    if lost > 0:
        doubts.append(
            f"{lost} contours of the {half} half that close on the centre line have no station; mark a point of each "
            "in [[body_plan.marks]]"
        )
    found = f"{len(named)} curves for {len(inner_first)} stations"
    deck = "sheer line found" if reading.sheer is not None else "no sheer line beside the deck line"
    notes.append(f"{half} half: {found}; {deck}")
    return notes, doubts
