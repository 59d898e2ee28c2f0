"""[excitation] of ship.toml: what shakes the ship in step with her shaft."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import Field, model_validator

from hullform.quantities import NotNegative, Positive, Table

# Wider than what is built, and narrow enough to find a number that stands in the wrong place.
Blades = Annotated[int, Field(strict=True, ge=2, le=9)]
Cylinders = Annotated[int, Field(strict=True, ge=1, le=30)]
Damping = Annotated[float, Field(strict=True, gt=0, le=0.2)]
Uncertainty = Annotated[float, Field(strict=True, ge=0, le=0.5)]


class ExcitationInput(Table):
    """[excitation]: propeller and main engine; the engine turns with the shaft."""

    shaft_speed_rpm: tuple[NotNegative, Positive]
    service_rpm: Positive | None = None
    propeller_blades: Blades | None = None
    propeller_x_m: NotNegative | None = None
    propeller_force_n: Positive | None = None
    engine_orders: tuple[Positive, ...] = ()
    cylinders: Cylinders | None = None
    engine_x_m: NotNegative | None = None
    m1v_nm: NotNegative | None = None
    m2v_nm: NotNegative | None = None
    rated_rpm: Positive | None = None
    rated_power_kw: Positive | None = None
    damping: Damping | None = None
    frequency_uncertainty: Uncertainty | None = None

    @model_validator(mode="after")
    def _speeds_fit(self) -> Self:
        slowest, fastest = self.shaft_speed_rpm
        if slowest >= fastest:
            raise ValueError(
                f"shaft_speed_rpm = [{slowest:g}, {fastest:g}] is no range; give the lowest and the highest speed"
            )
        if self.service_rpm is not None and not slowest <= self.service_rpm <= fastest:
            raise ValueError(
                f"service_rpm = {self.service_rpm:g} lies outside shaft_speed_rpm = [{slowest:g}, {fastest:g}]; "
                "the range holds every speed that the shaft may turn at"
            )
        return self

    @model_validator(mode="after")
    def _something_excites(self) -> Self:
        if self.propeller_blades is None and not self.orders:
            raise ValueError("nothing excites: give propeller_blades, engine_orders or both")
        if self.propeller_force_n is not None and self.propeller_blades is None:
            raise ValueError("propeller_force_n acts at blade rate; give propeller_blades")
        if self.orders and self.engine_x_m is None:
            raise ValueError(
                "engine_x_m is missing: give the x of the middle of the engine, for a moment there shakes a mode by "
                "the mode's slope"
            )
        return self

    @property
    def orders(self) -> tuple[float, ...]:
        """The engine's: those of the list, and those whose moment is given."""
        given = {1.0: self.m1v_nm, 2.0: self.m2v_nm}
        return tuple(sorted({*self.engine_orders, *(order for order, moment in given.items() if moment)}))

    @property
    def reference_rpm(self) -> float:
        """The speed at which forces and moments are given."""
        return self.rated_rpm or self.service_rpm or self.shaft_speed_rpm[1]

    def require_within(self, length_m: float) -> None:
        """Refuse places off a ship of a length overall.

        Raises:
            ValueError: propeller or engine lies beyond her ends.
        """
        for key in ("propeller_x_m", "engine_x_m"):
            x = getattr(self, key)
            if x is not None and x > length_m + 1e-6:
                raise ValueError(
                    f"excitation.{key} = {x:g} lies outside the ship (0 .. {length_m:g} m); "
                    "x runs from the aft end of the length overall"
                )
