"""A half whose curves touch: its lower parts are given to the upper ones, and it is said where that is not sure."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from hullform.corrections import Crossing, Joined, RunTogether
from hullform.picture.edits.placing import Placed
from hullform.picture.naming.alignment import NO_CURVE
from hullform.picture.naming.branches import Fork, below_fork, find_forks, rejoin
from hullform.picture.naming.marks import PlacedMark
from hullform.picture.tracing.half import HalfReading
from hullform.station_names import StationNames

Naming = Callable[[Sequence[PlacedMark]], Sequence[int]]

UNSURE = 0.6  # confidence in either of two curves whose lower parts may be each other's
NEAR_FORK = 0.08  # of B/2: what a person says of lines holds so far


@dataclass(frozen=True, eq=False)
class Rejoined:
    """The half with its lower parts where they belong, and what to say of it."""

    reading: HalfReading
    notes: tuple[str, ...]
    doubts: tuple[str, ...]


def rejoined(
    reading: HalfReading,
    inner_first: Sequence[float],
    names: StationNames,
    marks: Sequence[PlacedMark],
    placed: Sequence[Placed],
    naming: Naming,
) -> Rejoined:
    """Give the lower parts of curves that touch to the upper ones.

    Args:
        reading: of the half.
        inner_first: its stations from the centre line outwards, m.
        names: what the drawing calls them.
        marks: on its curves.
        placed: the user's corrections; where these join or cross lines, curves stay as they are.
        naming: the curve of each station, by marks. A mark below a touch may lie on another's curve, and names none.
    """
    size = reading.frame.half_breadth_px
    forks = find_forks(reading.curves, reading.line_px, size)
    if not forks:
        return Rejoined(reading, (), ())
    assigned = naming([mark for mark in marks if not below_fork(reading.curves, forks, mark)])
    positions = {
        number: x for x, number in reversed(list(zip(inner_first, assigned, strict=True))) if number != NO_CURVE
    }
    said = [at for item in placed if isinstance(item.correction, Joined | Crossing | RunTogether) for at in item.yz]
    by_hand = {number for number, _ in reading.drawn}

    def settled(fork: Fork) -> bool:
        near = any(np.hypot(*(at - fork.place)) < NEAR_FORK * size for at in said)
        return near or bool(by_hand & {fork.first, fork.second})

    branches = rejoin(
        reading.curves,
        positions,
        reading.line_px,
        size,
        [(assigned[mark.station], mark) for mark in marks if assigned[mark.station] != NO_CURVE],
        settled,
    )
    scale = reading.frame.metres_per_px

    def where(fork: Fork) -> str:
        y, z = (value * scale for value in fork.place)
        first, second = (names.one(positions[number]) for number in (fork.first, fork.second))
        return f"{first} and {second} touch near y {y:.2f} z {z:.2f} m"

    notes = [
        f"{where(fork)}; their lower parts were given to them by marks or fair waterlines"
        for fork in branches.exchanged
    ]
    doubts = [
        f"{where(fork)}, and which lower part is whose cannot be told: the waterlines below are about as fair either "
        "way; look at both in the overlay, and mark a point of each below that place in [[body_plan.marks]]"
        for fork in branches.unsure
    ]
    unsure = {number for fork in branches.unsure for number in (fork.first, fork.second)}
    confidences = [min(c, UNSURE) if number in unsure else c for number, c in enumerate(reading.confidences)]
    return Rejoined(
        replace(reading, curves=branches.curves, confidences=tuple(confidences)), tuple(notes), tuple(doubts)
    )
