"""What a person says of a picture: each correction is one more cost or constraint in the reader's own solve.

Places are pixels of the picture as stored: u right, v down, pixel centres at integers.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from hullform.quantities import Number
from hullform.ship_body_plan import Half, Mark

Point = tuple[Number, Number]
Pair = tuple[Point, Point]
Line = Annotated[tuple[Point, ...], Field(min_length=2)]
Outline = Annotated[tuple[Point, ...], Field(min_length=3)]
Identity = Annotated[str, Field(min_length=1, max_length=40)]


class _Correction(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)

    id: Identity


class MarkedStation(_Correction):
    """This point lies on that station's curve: it names the curve and draws one to the point."""

    kind: Literal["mark"] = "mark"
    station_m: Number
    half: Half
    px: Point
    curve: Annotated[int, Field(ge=0, le=1)] = 0

    @property
    def mark(self) -> Mark:
        """As ship.toml would say it."""
        return Mark(station_m=self.station_m, half=self.half, px=self.px, curve=self.curve)


class Deleted(_Correction):
    """The line at this point is no station's: no curve runs along it."""

    kind: Literal["delete"] = "delete"
    px: Point


class Cut(_Correction):
    """No curve goes through this point: what lies before and behind it are two."""

    kind: Literal["cut"] = "cut"
    px: Point


class Joined(_Correction):
    """The lines that end nearest to these two points are one curve."""

    kind: Literal["join"] = "join"
    px: Pair


class Crossing(_Correction):
    """Two curves cross at this point: each goes straight on."""

    kind: Literal["cross"] = "cross"
    px: Point


class RunTogether(_Correction):
    """From one point to the other several curves share one line."""

    kind: Literal["together"] = "together"
    px: Pair


class Drawn(_Correction):
    """A curve drawn by hand, keel to deck: a smooth one through its points, or straight pieces between them.

    It is the station's curve of that number; the ink along it belongs to no other.
    """

    kind: Literal["drawn"] = "drawn"
    station_m: Number
    half: Half
    curve: Annotated[int, Field(ge=0, le=1)] = 0
    px: Line
    smooth: bool = True


class DeckEdge(_Correction):
    """The deck edge of a half, from the centre line outwards: where every station ends."""

    kind: Literal["deck"] = "deck"
    half: Half
    px: Line


class Knuckle(_Correction):
    """The curve at this point has a corner there, which is not rounded."""

    kind: Literal["knuckle"] = "knuckle"
    px: Point


class Ignored(_Correction):
    """Nothing inside this outline is drawn by a station: a title, labels, a table, a detail."""

    kind: Literal["ignore"] = "ignore"
    px: Outline


Correction = Annotated[
    MarkedStation | Deleted | Cut | Joined | Crossing | RunTogether | Drawn | DeckEdge | Knuckle | Ignored,
    Field(discriminator="kind"),
]
