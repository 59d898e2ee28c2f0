"""[weights] and [[conditions]] of ship.toml: the light ship, and what a condition adds to her."""

from __future__ import annotations

import itertools
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from hullform.quantities import NotNegative, Number, Positive, Share, Span, Table

Shape = Literal["uniform", "trapezoid", "girth", "sectional-area", "table"]
# The keys that one shape needs, and no other takes.
OWN_KEYS: dict[Shape, tuple[str, ...]] = {"trapezoid": ("centre_m",), "table": ("x_m", "mass_per_m")}


class WeightItem(Span):
    """[[weights.items]] and [[conditions.items]]: a mass, and how it lies between two places."""

    name: Annotated[str, Field(min_length=1)]
    mass_t: Positive
    shape: Shape = "uniform"
    centre_m: Number | None = None
    x_m: tuple[Number, ...] = ()
    mass_per_m: tuple[NotNegative, ...] = ()

    @model_validator(mode="after")
    def _keys_go_with_the_shape(self) -> Self:
        for shape, keys in OWN_KEYS.items():
            for key in keys:
                given = getattr(self, key) not in (None, ())
                if shape == self.shape and not given:
                    raise ValueError(f'"{self.name}" of shape = "{shape}" needs {key}; add it')
                if shape != self.shape and given:
                    raise ValueError(
                        f'"{self.name}": {key} goes with shape = "{shape}" alone, not "{self.shape}"; remove it'
                    )
        return self

    @model_validator(mode="after")
    def _table_is_a_curve(self) -> Self:
        if self.shape != "table":
            return self
        if self.ends_m:
            raise ValueError(f'"{self.name}": x_m says where a table begins and ends; remove from_m and to_m')
        if len(self.x_m) != len(self.mass_per_m) or len(self.x_m) < 2:
            raise ValueError(
                f'"{self.name}": {len(self.x_m)} x_m and {len(self.mass_per_m)} mass_per_m; give one of each a place, '
                "two places or more"
            )
        for before, after in itertools.pairwise(self.x_m):
            if after < before:
                raise ValueError(f'"{self.name}": in x_m {after:g} follows {before:g}; list places from aft forward')
        if not self.x_m[-1] > self.x_m[0] or not max(self.mass_per_m) > 0:
            raise ValueError(f'"{self.name}": the table has no area; give places apart and masses above 0')
        return self

    def span_m(self, length_m: float) -> tuple[float, float]:
        """Where it begins and ends on a ship of a length overall."""
        if self.x_m:
            return self.x_m[0], self.x_m[-1]
        return 0.0 if self.from_m is None else self.from_m, length_m if self.to_m is None else self.to_m

    def require_within(self, length_m: float) -> None:
        """Refuse what a ship of a length overall has no room for.

        Raises:
            ValueError: it reaches beyond her ends, or its centre lies where no trapezoid has it.
        """
        first, last = self.span_m(length_m)
        if first < -1e-6 or last > length_m + 1e-6 or first >= last:
            raise ValueError(
                f'item "{self.name}" reaches from {first:g} to {last:g} m, on a ship of 0 .. {length_m:g} m; '
                "x runs from the aft end of the length overall"
            )
        if self.centre_m is not None and not abs(self.centre_m - (first + last) / 2) <= (last - first) / 6:
            raise ValueError(
                f'item "{self.name}" has centre_m = {self.centre_m:g}, outside the middle third of {first:g} .. '
                f"{last:g} m, where a trapezoid has its centre; part it into two items"
            )


class WeightsInput(Table):
    """[weights]: the light ship."""

    steel_weight_t: Positive | None = None
    semi_concentrated_weight_t: NotNegative | None = None
    machinery_share: Share = 0.7
    items: tuple[WeightItem, ...] = ()

    @property
    def beyond_steel_t(self) -> float | None:
        """Machinery and outfit: the light ship less her steel; None where nothing is said of them."""
        if self.semi_concentrated_weight_t is None and not self.items:
            return None
        return (self.semi_concentrated_weight_t or 0.0) + sum(item.mass_t for item in self.items)


class ConditionInput(Table):
    """[[conditions]]: one loading condition."""

    name: Annotated[str, Field(pattern=r"^[a-z0-9-]+$")]
    label: str = ""
    deadweight_t: NotNegative
    items: tuple[WeightItem, ...] = ()
    draught_aft_m: Number | None = None
    draught_fore_m: Number | None = None

    @model_validator(mode="before")
    @classmethod
    def _items_stand_for_the_deadweight(cls, values: Any) -> Any:
        return {"deadweight_t": 0.0, **values} if isinstance(values, dict) and values.get("items") else values

    @model_validator(mode="after")
    def _both_draughts_or_none(self) -> Self:
        if (self.draught_aft_m is None) != (self.draught_fore_m is None):
            raise ValueError("draught_aft_m and draught_fore_m go together; give both or none")
        return self

    @property
    def title(self) -> str:
        """The label, or the name where there is none."""
        return self.label or self.name

    @property
    def load_t(self) -> float:
        """All that she carries: the deadweight and the items."""
        return self.deadweight_t + sum(item.mass_t for item in self.items)
