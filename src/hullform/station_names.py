"""Names of stations: what a drawing calls them, how they are compared, and how a message speaks of them."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

NUMBER = re.compile(r"([+-]?)(\d*[.]?\d+)(?:[ -](\d+)/(\d+))?|([+-]?)(\d+)/(\d+)")


@dataclass(frozen=True)
class StationNames:
    """The stations of one half as the messages call them: by their names where there are any, else by their x.

    Attributes:
        half: 'aft' or 'fore'.
        positions_m: x of each station, m.
        names: of each station; empty where the drawing's names are not known.
    """

    half: str
    positions_m: tuple[float, ...]
    names: tuple[str, ...] = ()

    def of(self, x_m: float) -> str:
        """The name of the station at x; empty where none is known."""
        return self.names[self.positions_m.index(x_m)] if self.names else ""

    def kept_by(self, positions_m: Sequence[float]) -> tuple[str, ...]:
        """The names for a changed list of stations, new ones called by their x in metres; none where none are known."""
        if not self.names:
            return ()
        return tuple(self.of(x) if x in self.positions_m else f"{x:g} m" for x in positions_m)

    def one(self, x_m: float) -> str:
        """One station: 'station 12.2 m (aft half)', or 'station 5 (12.2 m, aft half)'."""
        name = self.of(x_m)
        return f"station {name} ({x_m:g} m, {self.half} half)" if name else f"station {x_m:g} m ({self.half} half)"

    def several(self, all_x_m: Sequence[float]) -> str:
        """Several stations of the half: '1, 2 m', or '5, 6 (1, 2 m)'."""
        positions = f"{', '.join(f'{x:g}' for x in all_x_m)} m"
        return f"{', '.join(self.of(x) for x in all_x_m)} ({positions})" if self.names else positions


def same_name(name: str) -> str:
    """What the spellings of one name have in common: '1/2', '½', ',5' and '0.50' are '0.5'; 'A.P.' is 'AP'."""
    number = number_of(name)
    return re.sub(r"[\s.]", "", _plain(name)) if number is None else f"{number:g}"


def number_of(name: str) -> float | None:
    """The station number that a name is, or None where it is none."""
    found = NUMBER.fullmatch(_plain(name))
    if found is None:
        return None
    sign, whole, above, below, sign_alone, above_alone, below_alone = found.groups()
    if whole is None:
        sign, whole, above, below = sign_alone, "0", above_alone, below_alone
    if below is not None and int(above) >= int(below):  # '11/2' is 1 1/2 set close, '19/18' two names in a row
        return None
    value = Fraction(whole) + (Fraction(int(above), int(below)) if above is not None else 0)
    return float(-value if sign == "-" else value)


def _plain(name: str) -> str:
    """Upper case, one space between words, a point before decimals, and fractions spelt out."""
    apart = re.sub(r"(?<=\d)(?=[¼-¾⅐-⅞])", " ", name)
    return " ".join(unicodedata.normalize("NFKC", apart).replace("\u2044", "/").replace(",", ".").upper().split())


def fault_of_names(half: str, names: Sequence[str], stations: int) -> str | None:
    """What is wrong with the names of a half that has so many stations; None where nothing is."""
    key = f"{half}_station_names"
    if not names:
        return None
    if len(names) != stations:
        return (
            f"{key} has {len(names)} names, but {half}_stations_m has {stations} stations; "
            "give one name for each station, in the same order"
        )
    known: dict[str, str] = {}
    for name in names:
        before = known.setdefault(same_name(name), name)
        if before is not name:
            return f"{key} has '{before}' and '{name}', which are one name; give each station of a half its own"
    return None
