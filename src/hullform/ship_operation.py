"""[operation] of ship.toml: how fast she goes, and how the waves meet her."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from hullform.quantities import Table

METRES_PER_NAUTICAL_MILE = 1852.0
HEAD_SEAS_DEG, FOLLOWING_SEAS_DEG = 180.0, 0.0

# No ship that a beam in deep water stands for goes faster.
Speed = Annotated[float, Field(strict=True, ge=0, le=60)]
Heading = Annotated[float, Field(strict=True, ge=0, le=180)]


class OperationInput(Table):
    """[operation]: speeds, and headings between her way and the waves'."""

    speeds_knots: Annotated[tuple[Speed, ...], Field(min_length=1)]
    headings_deg: Annotated[tuple[Heading, ...], Field(min_length=1)] = (HEAD_SEAS_DEG, FOLLOWING_SEAS_DEG)


def metres_per_second(speed_knots: float) -> float:
    """A speed in m/s."""
    return speed_knots * METRES_PER_NAUTICAL_MILE / 3600.0
