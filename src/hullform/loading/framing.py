"""From [structure] to the plates of one section: the shell round the contour, and the members clipped to it."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hullform.ship_structure import LongitudinalBulkhead, Part, StructureInput

Array = NDArray[np.float64]

# A member of which less than this is left in the section is no member.
LEAST_BREADTH_M = 0.02

# Half the ship's depth of plating may be bottom; more of it is side, however flat it lies.
_BOTTOM_UP_TO = 0.5


@dataclass(frozen=True)
class Scantling:
    """A plate as given: gross thickness in m, the section of its stiffeners over its own, and its effective share."""

    thickness_m: float
    stiffener_share: float
    effective_share: float = 1.0


@dataclass(frozen=True, eq=False)
class Plating:
    """Plates of one name and scantling in the half section.

    Attributes:
        name: what an engineer calls it; members of one table entry have one name along the whole ship.
        points: (k, 2) y and z in m.
        scantling: its plates.
        shell: whether it is part of the contour, to which all else is tied.
    """

    name: str
    points: Array
    scantling: Scantling
    shell: bool = False

    @property
    def length_m(self) -> float:
        """Of its section, on one side of the ship."""
        return float(np.hypot(*np.diff(self.points, axis=0).T).sum())

    @property
    def on_centre_line(self) -> bool:
        """Whether it is a member in the centre plane, one plate of the whole section and not two."""
        return not self.shell and bool((self.points[:, 0] == 0).all())


@dataclass(frozen=True, eq=False)
class Frame:
    """One section to be plated: its contour and place.

    Attributes:
        x_m: its place.
        contour: (k, 2) y and z in m of one side, from the keel on the centre line to the deck at side.
        half_breadth_m: of the ship, moulded.
    """

    x_m: float
    contour: Array
    half_breadth_m: float

    @property
    def top_m(self) -> float:
        """Height of the deck."""
        return float(self.contour[-1, 1])

    @property
    def deck_half_breadth_m(self) -> float:
        """Of the upper deck."""
        return float(self.contour[-1, 0])

    def level(self, height_m: float, from_y_m: float = 0.0) -> Array | None:
        """The horizontal (2, 2) at a height, from y to the shell; None where the section has no room for it."""
        z = self.contour[:, 1]
        if not z[0] < height_m < self.top_m - LEAST_BREADTH_M:
            return None
        outer = float(_crossings(self.contour[:, ::-1], height_m).min(initial=np.inf))
        if not from_y_m + LEAST_BREADTH_M < outer < np.inf:
            return None
        return np.array([[from_y_m, height_m], [outer, height_m]])

    def upright(self, y_m: float, foot_m: float | None = None, head_m: float | None = None) -> Array | None:
        """The vertical (2, 2) at y, from the shell to the deck or between given heights; None where there is no room.

        Where the shell comes back inwards, that is the uppermost stretch within the section.
        """
        heights = np.sort(_crossings(self.contour, y_m)) if y_m > 0 else self.contour[:1, 1]
        if y_m < self.deck_half_breadth_m:
            heights = np.append(heights, self.top_m)
        if heights.size < 2:
            return None
        low = heights[-2] if foot_m is None else max(heights[-2], foot_m)
        high = heights[-1] if head_m is None else min(heights[-1], head_m)
        return np.array([[y_m, low], [y_m, high]]) if high > low + LEAST_BREADTH_M else None


def platings_of(given: StructureInput, frame: Frame) -> list[Plating]:
    """Every plate of the half section at a frame, as [structure] has it.

    The bottom is the plating below half the section's depth that lies flatter than 45 degrees, the side the rest of
    the contour; the inner bottom runs from side to side, the inner skin stands on it.
    """
    found = [*_shell(given, frame), *_upper_deck(given, frame)]
    x = frame.x_m

    def add(name: str, points: Array | None, scantling: Scantling) -> None:
        if points is not None:
            found.append(Plating(name, points, scantling))

    inner_height = None
    if given.inner_bottom is not None and given.inner_bottom.reaches(x):
        inner_height = given.inner_bottom.height_m
        own = _own(given, given.inner_bottom.thickness_m, given.inner_bottom.stiffener_share)
        add("inner bottom", frame.level(inner_height), _zoned(given, "inner-bottom", x, inner_height, own))
    if given.double_side is not None and given.double_side.reaches(x):
        own = _own(given, given.double_side.thickness_m, given.double_side.stiffener_share)
        skin = frame.upright(frame.half_breadth_m - given.double_side.breadth_m, foot_m=inner_height)
        found += _by_height(given, "inner-side", "inner side", skin, x, own)
    for deck in given.decks:
        if deck.reaches(x):
            line = frame.level(deck.height_m, deck.outboard_of_m)
            add(f"deck at {deck.height_m:g} m", line, _own(given, deck.thickness_m, deck.stiffener_share))
    for bulkhead in given.longitudinal_bulkheads:
        if bulkhead.reaches(x):
            line = frame.upright(bulkhead.y_m, bulkhead.foot_m, bulkhead.head_m)
            add(_bulkhead_name(bulkhead), line, _own(given, bulkhead.thickness_m, bulkhead.stiffener_share))
    for house in given.superstructures:
        half = min(house.breadth_m / 2, frame.deck_half_breadth_m)
        if house.reaches(x) and half > LEAST_BREADTH_M:
            own = replace(_own(given, house.thickness_m, house.stiffener_share), effective_share=house.effective_share)
            roof = frame.top_m + house.height_m
            add("superstructure", np.array([[half, frame.top_m], [half, roof]]), own)
            add("superstructure", np.array([[0.0, roof], [half, roof]]), own)
    return found


def member_names(given: StructureInput) -> set[str]:
    """The names of all members beside the shell and the upper deck, as `platings_of` has them."""
    names = {f"deck at {deck.height_m:g} m" for deck in given.decks}
    names |= {_bulkhead_name(bulkhead) for bulkhead in given.longitudinal_bulkheads}
    names |= {"superstructure"} if given.superstructures else set()
    names |= {"inner bottom"} if given.inner_bottom is not None else set()
    return names | ({"inner side"} if given.double_side is not None else set())


def _bulkhead_name(bulkhead: LongitudinalBulkhead) -> str:
    return f"bulkhead at {bulkhead.y_m:g} m" if bulkhead.y_m else "bulkhead on the centre line"


def _own(given: StructureInput, thickness_m: float | None, share: float | None) -> Scantling:
    return Scantling(
        given.shell_thickness_m if thickness_m is None else thickness_m,
        given.stiffener_share if share is None else share,
    )


def _zoned(given: StructureInput, part: Part, x_m: float, height_m: float, own: Scantling) -> Scantling:
    """The scantling of a part at a place: that of the last zone which holds it, or its own."""
    for zone in reversed(given.zones):
        above = zone.from_height_m is None or height_m >= zone.from_height_m
        below = zone.to_height_m is None or height_m <= zone.to_height_m
        if zone.part == part and zone.reaches(x_m) and above and below:
            return _own(given, zone.thickness_m, zone.stiffener_share)
    return own


def _by_height(
    given: StructureInput, part: Part, name: str, line: Array | None, x_m: float, own: Scantling, shell: bool = False
) -> list[Plating]:
    """A polyline of one part, with zones that change with the height: pieces of one scantling each."""
    if line is None:
        return []
    bounds = {z for zone in given.zones if zone.part == part for z in (zone.from_height_m, zone.to_height_m)}
    for height in sorted(z for z in bounds if z is not None):
        line = _with_level(line, height)
    middle = 0.5 * (line[:-1, 1] + line[1:, 1])
    kinds = [_zoned(given, part, x_m, float(height), own) for height in middle]
    changes = [i for i in range(1, len(kinds)) if kinds[i] != kinds[i - 1]]
    bounds_at = [0, *changes, len(kinds)]
    return [Plating(name, line[start : end + 1], kinds[start], shell) for start, end in itertools.pairwise(bounds_at)]


def _shell(given: StructureInput, frame: Frame) -> list[Plating]:
    contour = frame.contour
    run, rise = np.abs(np.diff(contour, axis=0)).T
    half_depth = contour[0, 1] + _BOTTOM_UP_TO * (frame.top_m - contour[0, 1])
    flat = (run > rise) & (contour[1:, 1] <= half_depth)
    turn = int(np.argmin(flat)) if not flat.all() else len(flat)
    own = _own(given, None, None)
    found = []
    if turn > 0:
        found += _by_height(given, "bottom", "bottom", contour[: turn + 1], frame.x_m, own, shell=True)
    if turn < len(flat):
        found += _by_height(given, "side", "side", contour[turn:], frame.x_m, own, shell=True)
    return found


def _upper_deck(given: StructureInput, frame: Frame) -> list[Plating]:
    inner, outer = given.opening_breadth_m(frame.x_m) / 2, frame.deck_half_breadth_m
    if outer <= inner + LEAST_BREADTH_M:
        return []
    scantling = _zoned(given, "deck", frame.x_m, frame.top_m, _own(given, None, None))
    return [Plating("deck", np.array([[inner, frame.top_m], [outer, frame.top_m]]), scantling, shell=True)]


def _crossings(line: Array, at: float) -> Array:
    """Second coordinates of a polyline (k, 2) where its first one passes a value."""
    u, v = line.T
    (index,) = np.nonzero((u[:-1] < at) != (u[1:] < at))
    share = (at - u[index]) / (u[index + 1] - u[index])
    return np.asarray(v[index] + share * (v[index + 1] - v[index]))


def _with_level(line: Array, height_m: float) -> Array:
    """The polyline with corners where it passes a height."""
    y, z = line.T
    (index,) = np.nonzero((z[:-1] < height_m) != (z[1:] < height_m))
    share = (height_m - z[index]) / (z[index + 1] - z[index])
    corners = np.stack([y[index] + share * (y[index + 1] - y[index]), np.full(index.size, height_m)], -1)
    return np.insert(line, index + 1, corners, axis=0)
