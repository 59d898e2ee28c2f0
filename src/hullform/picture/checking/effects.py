"""Which corrections changed nothing, so that a person sees it instead of wondering."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from hullform.corrections import Correction, DeckEdge, Drawn, Ignored, MarkedStation
from hullform.ship_body_plan import Mark

NO_LINE = "no line lies there"
REASONS = {
    "mark": "no traced curve of its half lies there",
    "join": "it does not name two different lines",
    "cross": "no two lines cross there",
    "knuckle": "no traced curve turns there",
    "deck": "it lies in the other half",
    "drawn": "a later one takes its place",
    "ignore": "no line lies inside",
}


@dataclass(frozen=True)
class Unheeded:
    """A correction that changed nothing, by its id, and what to say of it."""

    id: str
    text: str


def unheeded_corrections(
    corrections: Sequence[Correction], of_lines: Collection[str], of_ink: Collection[str], marks: Collection[Mark]
) -> tuple[Unheeded, ...]:
    """The corrections that changed nothing.

    Args:
        corrections: all.
        of_lines: ids of those of lines that found none.
        of_ink: ids of those that changed the ink or the deck edge.
        marks: those that lie on a traced curve.
    """
    last = {(c.half, c.station_m, c.curve): c.id for c in corrections if isinstance(c, Drawn)}
    out = []
    for correction in corrections:
        match correction:
            case MarkedStation():
                heeded = correction.mark in marks or (correction.half, correction.station_m, correction.curve) in last
            case Ignored() | DeckEdge():
                heeded = correction.id in of_ink
            case Drawn():
                heeded = last[correction.half, correction.station_m, correction.curve] == correction.id
            case _:
                heeded = correction.id not in of_lines
        if not heeded:
            u, v = np.array(correction.px, dtype=np.float64).reshape(-1, 2)[0]
            reason = REASONS.get(correction.kind, NO_LINE)
            text = (
                f"correction {correction.id} ({correction.kind}) at px [{u:g}, {v:g}] changed nothing: {reason}; "
                "move it or delete it"
            )
            out.append(Unheeded(correction.id, text))
    return tuple(out)
