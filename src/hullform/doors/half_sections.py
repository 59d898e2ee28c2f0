"""From the chains of a cut to the curves of a station: one side, keel to deck, holes bridged, the deck left out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.doors.cutting import Chain

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Sizes:
    """What counts as near, in m.

    Attributes:
        centre: a point nearer to the centre plane lies in it.
        seam: and so does an end of the mesh that is nearer, where it is of one side or in two halves.
        bridge: a hole no wider is closed by a straight line.
        deck: height above which a curve that comes back to the centre plane does so along a deck; a bulb's top lies
            below it.
    """

    centre: float
    seam: float
    bridge: float
    deck: float


# A piece flatter than this lies level: its keel end is that on the centre line.
_LEVEL = 1e-3


@dataclass(frozen=True, eq=False)
class HalfSection:
    """One side of a section.

    Attributes:
        curves: (n, 2) y and z in m, each from keel to deck, the lowest first.
        bridged: (height in m, width in m) of the holes that were closed.
        apart_m2: area of what hangs together with neither the centre plane nor the rest, left out.
        open_at_m: height of a hole too wide to be closed; None where there is none.
    """

    curves: tuple[Array, ...]
    bridged: tuple[tuple[float, float], ...] = ()
    apart_m2: float = 0.0
    open_at_m: float | None = None


def half_section(chains: Sequence[Chain], side: int, sizes: Sizes, up_to_m: float | None = None) -> HalfSection:
    """The curves of one side.

    Args:
        chains: of the whole section, or of one side.
        side: 1 for y >= 0, -1 for the other, which is folded over.
        sizes: what counts as near.
        up_to_m: the section is cut off there.
    """
    pieces: list[Array] = []
    apart = 0.0
    for chain in chains:
        points = chain.points * [side, 1.0]
        if not chain.closed:
            ends = points[[0, -1], 0]
            points[[0, -1], 0] = np.where(np.abs(ends) <= sizes.seam, 0.0, ends)
        runs = _beside_the_centre(points, chain.closed, sizes.centre)
        for run, closed in runs:
            if closed:
                apart += abs(_area_of_loop(run))
            else:
                pieces.append(run)
    if up_to_m is not None:
        pieces = [part for piece in pieces for part in _below(piece, up_to_m)]
    if not pieces:
        return HalfSection((), apart_m2=apart)
    lowest = min(float(piece[:, 1].min()) for piece in pieces)
    pieces = [_from_keel(piece) for piece in pieces if not (piece[:, 1].min() > lowest and _is_deck(piece, sizes))]
    joined, bridged, open_at = _bridged([_without_doubles(piece) for piece in pieces], sizes)
    top = max(range(len(joined)), key=lambda i: (joined[i][-1, 1], float(np.ptp(joined[i][:, 1]))))
    if joined[top][-1, 1] >= sizes.deck:
        joined[top] = _without_deck(joined[top])
    curves = sorted((line for line in joined if len(line) > 1), key=lambda line: float(line[0, 1]))
    return HalfSection(tuple(curves), tuple(bridged), apart, open_at)


def _beside_the_centre(points: Array, closed: bool, near: float) -> list[tuple[Array, bool]]:
    """The parts of a chain with y > 0, with the points where it meets the centre plane; closed where it never does."""
    y = np.where(np.abs(points[:, 0]) <= near, 0.0, points[:, 0])
    points = np.column_stack([y, points[:, 1]])
    outside = y > 0
    if not outside.any():
        return []
    if outside.all():
        return [(points, closed)]
    if closed:
        start = int(np.argmin(outside))
        points = np.roll(points, -start, axis=0)
        points = np.concatenate([points, points[:1]])
        outside = points[:, 0] > 0
    changes = np.flatnonzero(np.diff(outside.astype(int))) + 1
    runs = []
    for first, last in zip(np.append(0, changes), np.append(changes, len(points)), strict=True):
        if not outside[first]:
            continue
        run = [points[first:last]]
        if first > 0:
            run.insert(0, _meeting(points[first - 1], points[first]))
        if last < len(points):
            run.append(_meeting(points[last], points[last - 1]))
        runs.append((np.concatenate(run), False))
    return runs


def _is_deck(piece: Array, sizes: Sizes) -> bool:
    """Whether a piece is a part of the deck that openings part from the rest: level, with an end in the air."""
    out, up = np.abs(np.diff(piece, axis=0)).T
    return bool((up < out).all() and piece[:, 1].min() >= sizes.deck and piece[[0, -1], 0].max() > 0)


def _from_keel(piece: Array) -> Array:
    """The piece with its keel end first: the lower one, or that nearer to the centre plane where it lies level."""
    rise = piece[-1] - piece[0]
    turned = rise[0] < 0 if abs(rise[1]) <= _LEVEL * abs(rise[0]) else rise[1] < 0
    return piece[::-1] if turned else piece


def _meeting(inside: Array, outside: Array) -> Array:
    """(1, 2) where the line between two points, of which one has y > 0, meets the centre plane."""
    share = -inside[0] / (outside[0] - inside[0])
    return np.array([[0.0, inside[1] + share * (outside[1] - inside[1])]])


def _below(line: Array, height_m: float) -> list[Array]:
    """The parts of a polyline below a height."""
    flipped = np.column_stack([height_m - line[:, 1], line[:, 0]])
    runs = _beside_the_centre(flipped, False, 0.0)
    return [np.column_stack([run[:, 1], height_m - run[:, 0]]) for run, _ in runs]


def _bridged(pieces: list[Array], sizes: Sizes) -> tuple[list[Array], list[tuple[float, float]], float | None]:
    """Join pieces whose free ends face each other over a hole, from the lowest upwards."""
    left = sorted(pieces, key=lambda piece: (piece[0, 0] > 0, piece[0, 1]))
    top = max(float(piece[-1, 1]) for piece in left)
    found: list[Array] = []
    bridged: list[tuple[float, float]] = []
    open_at: list[float] = []
    while left:
        line = left.pop(0)
        if line[0, 0] > 0:
            # her bottom is open: the centre line is as far off as the other side's end
            if 2 * line[0, 0] > sizes.bridge:
                open_at.append(float(line[0, 1]))
            bridged.append((float(line[0, 1]), 2 * float(line[0, 0])))
            line = np.concatenate([[[0.0, line[0, 1]]], line])
        while line[-1, 0] > 0:
            beyond = [i for i, other in enumerate(left) if other[0, 0] > 0]
            if not beyond:
                break
            gaps = [float(np.hypot(*(left[i][0] - line[-1]))) for i in beyond]
            nearest = int(np.argmin(gaps))
            if gaps[nearest] > sizes.bridge:
                if line[-1, 1] < top - sizes.bridge:
                    open_at.append(float(line[-1, 1]))
                break
            bridged.append((float(line[-1, 1]), gaps[nearest]))
            line = np.concatenate([line, left.pop(beyond[nearest])])
        found.append(line)
    return found, bridged, min(open_at, default=None)


def _without_deck(line: Array) -> Array:
    """The curve up to the deck at side: without what runs inwards from there, flatter than 45 degrees."""
    out, up = np.diff(line[::-1], axis=0).T
    deck = (out > 0) & (np.abs(up) < out)
    steps = int(np.argmin(deck)) if not deck.all() else 0
    return line[: len(line) - steps]


def _without_doubles(line: Array) -> Array:
    apart = np.append(True, np.abs(np.diff(line, axis=0)).max(axis=1) > 0)
    return np.asarray(line[apart])


def _area_of_loop(points: Array) -> float:
    y, z = points.T
    return float(0.5 * np.sum(y * np.roll(z, -1) - z * np.roll(y, -1)))
