"""What every table of a ship.toml is made of: numbers with their limits, and tables that refuse unknown keys."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

# One alias for each kind of number: the one place where a number may later carry an uncertainty.
Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Positive = Annotated[float, Field(strict=True, gt=0, allow_inf_nan=False)]
NotNegative = Annotated[float, Field(strict=True, ge=0, allow_inf_nan=False)]
Share = Annotated[float, Field(strict=True, ge=0, le=1, allow_inf_nan=False)]
# A shell is thin where its mid-line may stand for it; no ship has a mean plate of a decimetre.
PlateThickness = Annotated[float, Field(strict=True, gt=0, le=0.1, allow_inf_nan=False)]
# From plastics to the stiffest of metals, and from the Baltic's brackish water to the Dead Sea's: a figure beyond is in
# another unit.
YoungsModulus = Annotated[float, Field(strict=True, ge=1e9, le=1e12, allow_inf_nan=False)]
WaterDensity = Annotated[float, Field(strict=True, ge=900, le=1300, allow_inf_nan=False)]

SEA_WATER_KG_M3 = 1025.0


class Table(BaseModel):
    """A table of ship.toml: frozen, and no key of it is unknown."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class Span(Table):
    """What reaches over a part of the length; the whole of it where nothing is said."""

    from_m: Number | None = None
    to_m: Number | None = None

    @model_validator(mode="after")
    def _from_aft_forward(self) -> Self:
        if self.from_m is not None and self.to_m is not None and self.to_m <= self.from_m:
            raise ValueError(
                f"to_m = {self.to_m:g} is not forward of from_m = {self.from_m:g}; x runs from aft forward"
            )
        return self

    def reaches(self, x_m: float) -> bool:
        """Whether x lies in the span."""
        return (self.from_m is None or x_m >= self.from_m) and (self.to_m is None or x_m <= self.to_m)

    @property
    def ends_m(self) -> tuple[float, ...]:
        """Its given ends."""
        return tuple(x for x in (self.from_m, self.to_m) if x is not None)
