"""Curves that end in the air, and bold strokes that no curve took: what was read there is not the whole drawing."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hullform.picture.naming.alignment import NO_CURVE
from hullform.picture.naming.named_half import NamedHalf
from hullform.picture.tracing.half import HalfReading

Array = NDArray[np.float64]

ON_AXIS = 0.012  # of B/2: a lower end so near the centre line or the base line lies on it
ON_DECK = 0.025  # of B/2: an upper end so near a deck edge lies on it
ON_SIDE = 0.012  # of B/2: so near the line of B/2 a curve runs on along it
IN_AXIS = 0.006  # of B/2: so near the centre line a curve is hidden in its ink
LONGEST_HIDDEN = 0.2  # of B/2: of the runs along it that were longer 12 of 15 were no part of their stations
LONGEST_UNREAD = 0.12  # of B/2: longer strokes are pieces of stations, not labels


def doubts_of_loose_ends(halves: Sequence[NamedHalf]) -> list[str]:
    """Doubts about the stations whose curves hang in the air, and about strokes left over."""
    doubts = []
    for half in halves:
        reading = half.reading
        by_hand = {number for number, _ in reading.drawn}
        named = sorted(set(half.assigned) - {NO_CURVE})
        tops = np.array([reading.curves[number][-1] for number in named])
        doubts += _turning_back(half, tops, named, by_hand)
        for x, number in zip(half.inner_first, half.assigned, strict=True):
            if number == NO_CURVE or number in by_hand:
                continue
            fair = off_edge_px(tops, named.index(number)) < ON_DECK * reading.frame.half_breadth_px
            if where := loose_end(reading.curves[number], reading, fair):
                doubts.append(f"{half.names.one(x)}: {where}; look at it in the overlay")
        scale, longest = reading.frame.metres_per_px, LONGEST_UNREAD * reading.frame.half_breadth_px
        middles = [line[len(line) // 2] * scale for line in reading.unused if _length(line) > longest]
        places = [f"y {y:.2f} z {z:.2f} m" for y, z in middles]
        if places:
            doubts.append(
                f"{reading.half} half: {len(places)} strokes as bold as stations belong to no curve, near "
                f"{', '.join(places[:4])}; look at them in the overlay"
            )
    return doubts


def _turning_back(half: NamedHalf, tops: Array, named: Sequence[int], by_hand: set[int]) -> list[str]:
    """Doubts about upper ends where the sheer line falls unseen: in order, they follow one edge.

    Args:
        half: with its stations.
        tops: (curves, 2) [y, z] of the upper ends of the named curves from the centre line outwards, px.
        named: their numbers.
        by_hand: those that a person drew.
    """
    sheer, frame = half.reading.sheer, half.reading.frame
    if sheer is None:
        return []
    doubts = []
    station = dict(zip(reversed(half.assigned), reversed(half.inner_first), strict=True))
    for k in range(1, len(named) - 1):
        before, after = tops[k] - tops[k - 1], tops[k + 1] - tops[k]
        far = min(np.hypot(*before), np.hypot(*after)) > ON_DECK * frame.half_breadth_px
        pair = named[k : k + 2]
        if far and before @ after < 0 and sheer.lost_at(float(tops[k, 0])) and not by_hand & set(pair):
            first, second = (half.names.one(station[number]) for number in pair)
            low, high = (f"{top[1] * frame.metres_per_px:.2f}" for top in tops[k : k + 2])
            doubts.append(
                f"{first} and {second}: upper ends at z {low} and {high} m, out of order along a deck edge that was "
                "not seen there; look at them in the overlay, or draw the deck edge on the review page"
            )
    return doubts


def _length(line: Array) -> float:
    return float(np.hypot(*np.diff(line, axis=0).T).sum())


def off_edge_px(tops: Array, index: int) -> float:
    """How far a curve's upper end lies beside the line through those of its neighbours, which is the deck edge there.

    Args:
        tops: (curves, 2) [y, z] of the upper ends from the centre line outwards, px.
        index: of the curve.
    """
    if len(tops) < 3:
        return float(np.inf)
    first = min(max(index - 1, 0), len(tops) - 3)
    before, after = (tops[k] for k in range(first, first + 3) if k != index)
    along = after - before
    length = float(np.hypot(*along))
    if length < 1.0:
        return float(np.hypot(*(tops[index] - before)))
    across = tops[index] - before
    return abs(float(along[0] * across[1] - along[1] * across[0])) / length


def loose_end(curve: Array, reading: HalfReading, in_line: bool) -> str:
    """What is wrong with the ends of a curve, in words; empty where both lie where a station begins and ends.

    Args:
        curve: (n, 2) [y, z], px, keel to deck.
        reading: of its half.
        in_line: whether its upper end lies in line with those of its neighbours.
    """
    size, scale = reading.frame.half_breadth_px, reading.frame.metres_per_px
    (y, z), (top_y, top_z) = curve[0], curve[-1]
    if min(y, z) > ON_AXIS * size:
        return f"begins in the air at y {y * scale:.2f} z {z * scale:.2f} m, not on the centre line or the base line"
    hidden = int(np.argmax(curve[:, 0] > IN_AXIS * size))
    if hidden > 0 and (risen := float(curve[hidden - 1, 1]) - z) > LONGEST_HIDDEN * size:
        return (
            f"runs up the centre line from z {z * scale:.2f} to {(z + risen) * scale:.2f} m, where its own line cannot "
            "be seen and it may begin at the upper end"
        )
    decks = list(reading.decks_px)
    if reading.sheer is not None and not reading.sheer.lost_at(float(top_y)):
        decks += reading.sheer.range_at(float(top_y))
    at_side = top_y > (1 - ON_SIDE) * size
    between = bool(decks) and min(decks) - ON_DECK * size < top_z < max(decks) + ON_DECK * size
    at_deck = any(abs(top_z - deck) < ON_DECK * size for deck in decks) or (reading.sheer is not None and between)
    if decks and not (at_side or at_deck or in_line):
        return f"ends in the air at y {top_y * scale:.2f} z {top_z * scale:.2f} m, not at a deck edge"
    return ""
