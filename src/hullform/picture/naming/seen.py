"""What a reader of a picture has seen, in pixels of the stored picture: for a page that shows and mends it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Half
from hullform.picture.edits.placing import stored_of_drawing
from hullform.picture.image.reduction import Reduction
from hullform.picture.tracing.half import HalfReading

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class SeenCurve:
    """A traced curve.

    Attributes:
        half: of the drawing.
        px: (n, 2) pixels of the stored picture, keel to deck.
        stations_m: x of the stations that have it; none where no station does.
        number: 0, or 1 for the second contour of its station.
        confidence: 0 (guessed) to 1 (certain).
        by_hand: whether a person drew it.
    """

    half: Half
    px: Array
    stations_m: tuple[float, ...]
    number: int
    confidence: float
    by_hand: bool


@dataclass(frozen=True, eq=False)
class UnusedLine:
    """A line that no curve took: half and (n, 2) pixels of the stored picture."""

    half: Half
    px: Array


@dataclass(frozen=True)
class StationDoubt:
    """What is not sure about one station."""

    station_m: float
    half: Half
    text: str


def seen_curves(
    reading: HalfReading,
    stations: Mapping[int, Sequence[float]],
    of_loops: Mapping[int, Sequence[float]],
    reduction: Reduction,
) -> tuple[SeenCurve, ...]:
    """The curves of a half, from the centre line outwards, then its second contours, found and drawn.

    Args:
        reading: of the half.
        stations: x of the stations of each curve; of_loops: of each contour that closes on the centre line.
        reduction: of the picture that was read.
    """
    by_hand = {number for number, _ in reading.drawn}
    first = [
        SeenCurve(
            reading.half,
            stored_of_drawing(curve, reading.frame, reduction),
            tuple(sorted(stations.get(number, ()))),
            0,
            confidence,
            number in by_hand,
        )
        for number, (curve, confidence) in enumerate(zip(reading.curves, reading.confidences, strict=True))
    ]
    by_name = {station for station, _ in reading.second_contours}
    loops = [
        SeenCurve(
            reading.half,
            stored_of_drawing(loop.points, reading.frame, reduction),
            tuple(x for x in sorted(of_loops.get(number, ())) if x not in by_name),
            1,
            loop.confidence,
            False,
        )
        for number, loop in enumerate(reading.loops)
    ]
    second = [
        SeenCurve(reading.half, stored_of_drawing(curve, reading.frame, reduction), (station,), 1, 1.0, True)
        for station, curve in reading.second_contours
    ]
    return (*first, *loops, *second)


def unused_lines(reading: HalfReading, reduction: Reduction) -> tuple[UnusedLine, ...]:
    """The lines of a half that no curve took."""
    return tuple(UnusedLine(reading.half, stored_of_drawing(line, reading.frame, reduction)) for line in reading.unused)
