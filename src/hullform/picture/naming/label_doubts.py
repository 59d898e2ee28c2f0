"""What the labels of a drawing say against the names that its curves got."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.picture.naming.alignment import NO_CURVE
from hullform.picture.naming.proposals import LabelledHalf, clear_labels
from hullform.station_names import number_of, same_name

Array = NDArray[np.float64]

FEWEST_AGAINST = 2  # labels at other curves: a single one may be misplaced or misread
FEWEST_CROSSED = 3  # names of the other half: fewer may be pieces of longer numbers
SURELY_READ = 0.9  # confidence of a name that no list has
FEWEST_NUMBERS = 3  # names that are numbers, to tell how a half is numbered


def doubts_of_labels(labels: LabelledHalf, curves: Sequence[Array], assigned: Sequence[int]) -> list[str]:
    """Labels that stand at other curves than those which got their names, and names that the list does not have.

    Args:
        labels: of the half.
        curves: (n, 2) points of each, px of the drawing.
        assigned: curve of each station, from the centre line outwards.
    """
    if not labels.named:
        return []
    half, doubts = labels.names.half, []
    clear = clear_labels(labels.named, curves)
    agreeing = sum(assigned[station] == curve for station, curve in clear)
    against = sorted(
        {
            station
            for station, curve in clear
            if assigned[station] not in (curve, NO_CURVE) and not _half_read(labels, station, curve, assigned)
        },
        key=lambda station: labels.inner_first[station],
    )
    if len(against) >= FEWEST_AGAINST and len(against) > agreeing:
        words = ", ".join(labels.names.of(labels.inner_first[station]) for station in against)
        doubts.append(
            f"{half} half: the labels {words} stand at other curves than those which got these names; "
            f"check {half}_stations_m, {half}_station_names and the overlay, or mark these stations in "
            "[[body_plan.marks]]"
        )
    unlisted = _unlisted(labels)
    if unlisted:
        words = ", ".join(f"'{text}'" for text in unlisted)
        doubts.append(
            f"{half} half: the drawing is labelled {words}, which {half}_station_names does not list; "
            f"check that {half}_stations_m has every station that is drawn"
        )
    return doubts


def doubts_of_sides(halves: Sequence[LabelledHalf]) -> list[str]:
    """Halves that are labelled with each other's names."""
    own_names = [{same_name(name) for name in half.names.names} for half in halves]
    own, crossed = 0, 0
    for half, mine, others in zip(halves, own_names, own_names[::-1], strict=True):
        seen = {same_name(label.text) for label in half.placed}
        own += len(seen & mine - others)
        crossed += len(seen & others - mine)
    if crossed < FEWEST_CROSSED or crossed <= 2 * own:
        return []
    return [
        f"aft_side: {crossed} labels of the drawing are names of stations of the half that was taken for the other "
        f"side, {own} stand where they should; check aft_side, aft_station_names and fore_station_names"
    ]


def _half_read(labels: LabelledHalf, station: int, curve: int, assigned: Sequence[int]) -> bool:
    """Whether a label that stands at a curve may be a piece of the name which the curve got: '5' of '15'."""
    given = [labels.names.of(x) for x, number in zip(labels.inner_first, assigned, strict=True) if number == curve]
    return _is_piece(labels.names.of(labels.inner_first[station]), _unread(labels, given))


def _unread(labels: LabelledHalf, names: Sequence[str]) -> list[str]:
    """Those of some names that no label is."""
    read = {same_name(label.text) for label in labels.placed}
    return [name for name in names if same_name(name) not in read]


def _is_piece(text: str, names: Sequence[str]) -> bool:
    """Whether a text is the first or the last figures of one of some whole numbers; a fraction is read or it is not."""
    return any(name.isdecimal() and name != text and (name.startswith(text) or name.endswith(text)) for name in names)


def _unlisted(labels: LabelledHalf) -> list[str]:
    """Numbers that go on with the half's own numbering but stand in no list."""
    listed = [number_of(name) for name in labels.names.names]
    numbers = sorted(number for number in listed if number is not None)
    if len(numbers) < FEWEST_NUMBERS:
        return []
    step = min(np.diff(numbers))
    found = {}
    for label in labels.placed:
        number = number_of(label.text)
        if number is None or number in numbers or label.confidence < SURELY_READ:
            continue
        # a piece of a longer number lies outside the half's numbers, between its steps, or is one that was not read
        if _is_piece(label.text, _unread(labels, labels.names.names)):
            continue
        if numbers[0] < number < numbers[-1] and abs(number / step - round(number / step)) < 1e-6:
            found[number] = label.text
    return [found[number] for number in sorted(found)]
