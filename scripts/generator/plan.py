"""The stations that a body plan shows: numbers, places, curves, and which of them share one drawn curve."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from generator.sections import Array, Dimensions, Hull

Half = str  # 'aft' or 'fore'

FEWEST = 8  # stations of a half, before those are left out that would not show
# Numbers of the aft half in the order in which a draughtsman would want them; the fore half is their mirror image.
_WANTED = (0, 1, 2, 3, 4, 5, 6, 8, 10, 7, 9, 0.5, 1.5, 2.5, 0.25, 0.75, 3.5, 1.25, 4.5, 1.75, 5.5)
_FORE_END_SHARE = 0.975  # of the length: the forward perpendicular
_AFT_END_SHARE = 0.025
_FULLER = 1.001  # by area, of a section that is fuller than another
_SHOWS = 0.02  # of B/2: a half or quarter station that lies nowhere so far from its neighbours is left out
_LEAST_REACH = 0.03  # of B/2: a section that reaches no further is not drawn
_LEAST_HEIGHT = 0.05  # of the depth


@dataclass(frozen=True, eq=False)
class PlanStation:
    """A station: its number, x, half, curves [y, z] in metres, and the first station with the same curves."""

    name: str
    x_m: float
    half: Half
    curves: tuple[Array, ...]
    drawn_as: str


@dataclass(frozen=True, eq=False)
class Plan:
    """What is drawn: the ship's dimensions, her stations from aft forward, and the deck edge of both halves."""

    dimensions: Dimensions
    stations: tuple[PlanStation, ...]
    sheer: dict[Half, Array]

    def of(self, half: Half) -> list[PlanStation]:
        """Return the stations of one half, from aft forward."""
        return [station for station in self.stations if station.half == half]


def plan_of(hull: Hull, random: np.random.Generator, most: int, apart_m: float) -> Plan:
    """Choose stations and cut the hull there.

    Args:
        hull: to be cut.
        random: decides how many stations a half has, and whether midships is in both.
        most: stations of a half.
        apart_m: curves nowhere further apart than this are drawn once.
    """
    main = hull.dimensions
    stations: list[PlanStation] = []
    both = random.random() < 0.4
    home = _half_of_midships(hull)
    for half in ("aft", "fore"):
        count = int(random.integers(FEWEST, most + 1))
        numbers = sorted(float(n) for n in _WANTED[:count])
        if half == "fore":
            numbers = [20.0 - n for n in reversed(numbers)]
            if home == "aft" or (home == "" and not both):
                numbers = [n for n in numbers if n != 10.0]
            if random.random() < 0.4:
                numbers.append(20.25)
        elif random.random() < 0.4:
            numbers.insert(0, -0.25)
        if half == "aft" and home == "fore":
            numbers = [n for n in numbers if n != 10.0]
        drawn: list[PlanStation] = []
        for number in sorted(numbers, key=lambda n: (n % 1.0 != 0.0, n)):
            x = round(_place_of(number) * main.length_m, 2)
            curves = hull.section(x)
            if not _worth_drawing(curves, main):
                continue
            if number % 1.0 and any(same(s.curves, curves, _SHOWS * main.breadth_m / 2) for s in drawn):
                continue
            twin = next((s for s in drawn if same(s.curves, curves, apart_m)), None)
            name = f"{number:g}"
            drawn.append(PlanStation(name, x, half, tuple(curves), twin.drawn_as if twin else name))
        stations += sorted(drawn, key=lambda s: s.x_m)
    sheer = {half: _sheer(hull, half) for half in ("aft", "fore")}
    return Plan(main, tuple(stations), sheer)


def _place_of(number: float) -> float:
    """Where a station lies, as a share of the length."""
    return _AFT_END_SHARE + (_FORE_END_SHARE - _AFT_END_SHARE) * number / 20.0


def _half_of_midships(hull: Hull) -> Half:
    """The half that shows midships: that on its side of the fullest section, or either one ('')."""
    sections = [hull.section(_place_of(number) * hull.dimensions.length_m) for number in (9.0, 10.0, 11.0)]
    abaft, here, ahead = (sum(np.trapezoid(c[:, 0], c[:, 1]) for c in curves) for curves in sections)
    if max(abaft, ahead) < _FULLER * here:
        return ""
    return "fore" if abaft > ahead else "aft"


def same(left: tuple[Array, ...], right: list[Array], apart_m: float) -> bool:
    """Tell whether curves lie nowhere further apart than a distance, point by point at equal shares of arc."""
    return len(left) == len(right) and all(
        float(np.hypot(*(a - b).T).max()) < apart_m for a, b in zip(left, right, strict=True)
    )


def _worth_drawing(curves: list[Array], main: Dimensions) -> bool:
    if not curves:
        return False
    points = np.vstack(curves)
    reach, height = points[:, 0].max(), np.ptp(points[:, 1])
    return bool(reach > _LEAST_REACH * main.breadth_m and height > _LEAST_HEIGHT * main.depth_m)


def _sheer(hull: Hull, half: Half) -> Array:
    """The deck edge of a half as seen from ahead or astern, midships first."""
    length = hull.dimensions.length_m
    ends = [
        curves[-1][-1]
        for x in np.linspace(length / 2, 0.0 if half == "aft" else length, 61)
        if (curves := hull.section(float(x)))
    ]
    return np.array(ends)
