"""A person at the reader's page: looks at what was read, points, draws, and looks again, until every station is right.

Clicks lie on the true curves but for the unsteadiness of a hand. The list that comes out may be given to the reader
as it is, or be repeated on the page.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from reading_accuracy import to_polyline
from real_hull import RealHull, TrueStation

from hullform.body_plan import Half
from hullform.corrections import Correction, DeckEdge, Drawn, MarkedStation
from hullform.picture.reading import PictureReading, read_sheet
from hullform.picture.sheet.sheet import Sheet
from hullform.review_file import new_review
from hullform.ship import Ship

Array = NDArray[np.float64]
Point = tuple[float, float]

GOOD = 0.3  # RMS in % of B/2 with which the person is content
CLICK_NOISE_PX = 1.5  # of a click that marks a curve
DRAWN_NOISE_PX = 1.0  # of the points of a drawn curve, set with the loupe
POINTS_OF_CURVE = 15
PATIENCE = 3  # times that the person goes through the wrong stations
POINTS_OF_DECK = 6
ALONG = 0.5  # of a curve: where it is marked
BEND = 2.0  # radians of bend that call for as many points as the whole length does


def corrected(ship: Ship, sheet: Sheet, corrections: Sequence[Correction]) -> PictureReading:
    """What is read with these corrections."""
    review = new_review(ship).model_copy(update={"corrections": tuple(corrections)})
    return read_sheet(sheet, review.applied_to(ship), corrections)


def corrections_of(hull: RealHull, ship: Ship, sheet: Sheet, seed: int = 1) -> list[Correction]:
    """What a person would correct: deck edges, then a click for each wrong station, then curves by hand.

    A correction that does not help is taken back.
    """
    rng = np.random.default_rng(seed)
    kept: list[Correction] = []
    wrong = _wrong(hull, ship, sheet, kept)
    halves: tuple[Half, Half] = ("aft", "fore")
    for half in halves:
        if any(station.half == half for station in wrong):
            kept, wrong = _tried([_deck_edge(hull, half, rng)], hull, ship, sheet, kept, wrong)
    marks = [_marked(station, number, rng) for number, station in enumerate(wrong)]
    with_marks = _wrong(hull, ship, sheet, [*kept, *marks])
    if len(with_marks) < len(wrong):
        still = {(station.half, station.x_m) for station in with_marks}
        kept += [mark for mark in marks if (mark.half, mark.station_m) not in still]
        wrong = _wrong(hull, ship, sheet, kept)
    for _ in range(PATIENCE):
        for station in [station for half in halves for station in _inner_first(wrong, half)]:
            for smooth in (True, False):
                if station in wrong and not _is_drawn(station, kept):
                    kept, wrong = _tried(_by_hand(station, smooth, rng), hull, ship, sheet, kept, wrong, station)
    return kept


def _inner_first(stations: Sequence[TrueStation], half: Half) -> list[TrueStation]:
    """Those of a half from the centre line outwards: bulbs and their like first, which the others lie outside of."""
    return [station for station in stations[:: 1 if half == "aft" else -1] if station.half == half]


def _is_drawn(station: TrueStation, corrections: Sequence[Correction]) -> bool:
    drawn = [correction for correction in corrections if isinstance(correction, Drawn)]
    return any((curve.half, curve.station_m) == (station.half, station.x_m) for curve in drawn)


def _wrong(hull: RealHull, ship: Ship, sheet: Sheet, corrections: Sequence[Correction]) -> list[TrueStation]:
    misfits = hull.misfits(corrected(ship, sheet, corrections).body_plan)
    return [station for station, misfit in zip(hull.stations, misfits, strict=True) if misfit > GOOD]


def _tried(
    more: Sequence[Correction],
    hull: RealHull,
    ship: Ship,
    sheet: Sheet,
    kept: list[Correction],
    wrong: list[TrueStation],
    meant: TrueStation | None = None,
) -> tuple[list[Correction], list[TrueStation]]:
    """The corrections and the stations that are still wrong: with the new corrections where these help.

    One that mends the station that it is meant for may cost another, which is then seen to.
    """
    still = _wrong(hull, ship, sheet, [*kept, *more])
    helps = len(still) < len(wrong) or (meant is not None and meant not in still and len(still) == len(wrong))
    return ([*kept, *more], still) if helps else (kept, wrong)


def _clicks(line: Array, noise_px: float, rng: np.random.Generator) -> tuple[Point, ...]:
    clicked = line + rng.normal(0.0, noise_px, line.shape)
    return tuple((round(float(u), 1), round(float(v), 1)) for u, v in clicked)


def _marked(station: TrueStation, number: int, rng: np.random.Generator) -> MarkedStation:
    line = max(station.curves_px, key=len)
    at = line[[round(ALONG * (len(line) - 1))]]
    (px,) = _clicks(at, CLICK_NOISE_PX, rng)
    return MarkedStation(id=f"mark-{number}", station_m=station.x_m, half=station.half, px=px)


def _deck_edge(hull: RealHull, half: Half, rng: np.random.Generator) -> DeckEdge:
    """Clicks on the upper ends of stations of a half, as the deck edge shows them."""
    tops = np.array([s.curves_px[-1][np.argmin(s.curves_px[-1][:, 1])] for s in hull.stations if s.half == half])
    tops = tops[np.argsort(np.abs(tops[:, 0] - np.median([p[0] for s in hull.stations for p in s.curves_px[0][:1]])))]
    chosen = tops[np.unique(np.linspace(0, len(tops) - 1, POINTS_OF_DECK).round().astype(int))]
    return DeckEdge(id=f"deck-{half}", half=half, px=_clicks(chosen, CLICK_NOISE_PX, rng))


def _by_hand(station: TrueStation, smooth: bool, rng: np.random.Generator) -> list[Correction]:
    """The curves of a station, drawn: the one that reaches the deck is its first."""
    curves = sorted(station.curves_px, key=lambda curve: float(curve[:, 1].min()))
    return [
        Drawn(
            id=f"drawn-{station.half}-{station.x_m:g}-{number}",
            station_m=station.x_m,
            half=station.half,
            curve=number,
            px=_clicks(_where_it_bends(curve) if smooth else _corners(curve), DRAWN_NOISE_PX, rng),
            smooth=smooth,
        )
        for number, curve in enumerate(curves[:2])
    ]


def _where_it_bends(curve: Array) -> Array:
    """Points along a curve, closer where it bends."""
    curve = curve[np.concatenate([[True], np.hypot(*np.diff(curve, axis=0).T) > 1e-6])]
    step = np.diff(curve, axis=0)
    length = np.hypot(*step.T)
    turn = np.abs(np.angle(np.exp(1j * np.diff(np.arctan2(step[:, 1], step[:, 0])))))
    weight = length / length.sum()
    weight[:-1] += turn / BEND / 2
    weight[1:] += turn / BEND / 2
    at = np.concatenate([[0.0], np.cumsum(weight)])
    wanted = np.linspace(0.0, at[-1], POINTS_OF_CURVE)
    return np.column_stack([np.interp(wanted, at, curve[:, k]) for k in (0, 1)])


def _corners(curve: Array) -> Array:
    """The points of a curve between which straight pieces follow it best, by the rule of Douglas and Peucker."""
    chosen = [0, len(curve) - 1]
    while len(chosen) < min(POINTS_OF_CURVE, len(curve)):
        chosen = sorted({*chosen, int(np.argmax(to_polyline(curve, curve[chosen])))})
    return curve[chosen]
