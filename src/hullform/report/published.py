"""What the paper prints of its two case-study ships (Tables 1 and 2), to be set beside a run of the same ships.

A ship of ship.toml is one of them where her name and all her main particulars are the same; a condition is one of the
paper's where its name and deadweight are. Table 2's 'ballast' is the light ship: no ballast water is in it. Frequencies
are in rad/s, as printed; None stands for the dash that the paper prints once a column no longer changes.
"""

from __future__ import annotations

from dataclasses import dataclass

from hullform.ship import Ship
from hullform.ship_weights import ConditionInput

FUNCTIONS = tuple(range(4, 13))


@dataclass(frozen=True)
class PublishedMode:
    """One line of Table 2: the Ritz frequency with N = 4 .. 12 functions, Schlick, Todd and finite elements, rad/s."""

    ritz: tuple[float | None, ...]
    schlick: float
    todd: float
    finite_element: float

    @property
    def converged(self) -> float:
        """The last Ritz figure that is printed."""
        return [figure for figure in self.ritz if figure is not None][-1]


@dataclass(frozen=True)
class PublishedCondition:
    """One block of Table 2 and the condition of ship.toml that it belongs to."""

    letter: str
    title: str
    condition: str
    deadweight_t: float
    modes: tuple[PublishedMode, ...]


@dataclass(frozen=True)
class PublishedShip:
    """The main particulars of Table 1, in m and t, and the ship's blocks of Table 2."""

    name: str
    length_overall_m: float
    length_between_perpendiculars_m: float
    breadth_m: float
    depth_m: float
    draught_m: float
    conditions: tuple[PublishedCondition, ...]

    def is_ship(self, ship: Ship) -> bool:
        """Whether a ship.toml has this name and these particulars."""
        own = ship.particulars
        return (
            own.name == self.name
            and own.length_overall_m == self.length_overall_m
            and own.length_between_perpendiculars_m == self.length_between_perpendiculars_m
            and own.breadth_m == self.breadth_m
            and own.depth_m == self.depth_m
            and own.draught_m == self.draught_m
        )


def published_ship(ship: Ship) -> PublishedShip | None:
    """The paper's ship that a ship.toml describes, if it does."""
    return next((known for known in SHIPS if known.is_ship(ship)), None)


def published_condition(known: PublishedShip, condition: ConditionInput) -> PublishedCondition | None:
    """The block of Table 2 of a loading condition, if it has one."""
    for block in known.conditions:
        if block.condition == condition.name and block.deadweight_t == condition.load_t:
            return block
    return None


def _mode(ritz: tuple[float, ...], dashes: int, schlick: float, todd: float, finite_element: float) -> PublishedMode:
    return PublishedMode((*ritz, *(None,) * dashes), schlick, todd, finite_element)


_SCIM = PublishedShip(
    name="SCIM containership",
    length_overall_m=262.0,
    length_between_perpendiculars_m=248.0,
    breadth_m=32.2,
    depth_m=19.5,
    draught_m=13.2,
    conditions=(
        PublishedCondition(
            "a",
            "SCIM Containership (Loaded)",
            "loaded",
            57785.0,
            (
                _mode((4.75, 4.75, 4.75, 4.74, 4.74), 4, 4.17, 6.14, 5.18),
                _mode((11.59, 11.59, 11.57, 11.57), 5, 9.93, 12.64, 12.85),
                _mode((22.62, 22.58, 22.57, 22.53, 22.53, 22.51, 22.50, 22.50), 1, 16.69, 24.56, 24.52),
            ),
        ),
        PublishedCondition(
            "b",
            "SCIM Containership (Ballast)",
            "light-ship",
            0.0,
            (
                _mode((9.85, 9.84, 9.84), 6, 7.10, 10.72, 10.19),
                _mode((25.87, 25.86, 25.80, 25.80, 25.78, 25.78), 3, 14.12, 19.07, 26.56),
                _mode((47.80, 46.83, 46.76, 46.49, 46.49, 46.45, 46.45, 46.44, 46.44), 0, 28.41, 42.88, 47.86),
            ),
        ),
    ),
)
_DS = PublishedShip(
    name="DS tanker",
    length_overall_m=249.98,
    length_between_perpendiculars_m=239.0,
    breadth_m=44.0,
    depth_m=21.5,
    draught_m=15.1,
    conditions=(
        PublishedCondition(
            "c",
            "DS Tanker (Loaded)",
            "loaded",
            114783.0,
            (
                _mode((5.86, 5.86), 7, 4.19, 6.45, 6.16),
                _mode((15.03, 15.03), 7, 9.96, 13.08, 15.86),
                _mode((29.80, 29.78, 29.78, 29.77, 29.77, 29.75, 29.75), 2, 16.77, 25.82, 30.90),
            ),
        ),
        PublishedCondition(
            "d",
            "DS Tanker (Ballast)",
            "light-ship",
            0.0,
            (
                _mode((14.74, 14.74, 14.74, 14.73, 14.73), 4, 8.29, 13.29, 15.64),
                _mode((39.07, 39.07, 39.03, 39.02, 39.01, 39.00, 39.00), 2, 15.82, 22.68, 41.31),
                _mode((71.79, 71.25, 71.25, 71.05, 71.04, 70.99, 70.97, 70.97, 70.95), 0, 33.16, 53.17, 75.28),
            ),
        ),
    ),
)
SHIPS = (_SCIM, _DS)
