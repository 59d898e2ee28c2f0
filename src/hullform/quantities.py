"""What every table of a ship.toml is made of: numbers with their limits, and tables that refuse unknown keys."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

# One alias for each kind of number: the one place where a number may later carry an uncertainty.
Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Positive = Annotated[float, Field(strict=True, gt=0, allow_inf_nan=False)]
NotNegative = Annotated[float, Field(strict=True, ge=0, allow_inf_nan=False)]
Share = Annotated[float, Field(strict=True, ge=0, le=1, allow_inf_nan=False)]
# A shell is thin where its mid-line may stand for it; no ship has a mean plate of a decimetre.
PlateThickness = Annotated[float, Field(strict=True, gt=0, le=0.1, allow_inf_nan=False)]


class Table(BaseModel):
    """A table of ship.toml: frozen, and no key of it is unknown."""

    model_config = ConfigDict(extra="forbid", frozen=True)
