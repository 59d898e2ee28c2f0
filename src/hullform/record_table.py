"""What the types of results.json are made of."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

Finite = Annotated[float, Field(allow_inf_nan=False)]
Frequencies = list[Finite]


class RecordTable(BaseModel):
    """A table of results.json: it has its keys and no others."""

    model_config = ConfigDict(extra="forbid")
