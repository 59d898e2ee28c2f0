"""[structure] of ship.toml: a shell of one thickness, and whatever else an engineer knows of the midship section."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from hullform.quantities import NotNegative, Number, PlateThickness, Positive, Share, Span, Table, YoungsModulus

Part = Literal["bottom", "side", "deck", "inner-bottom", "inner-side"]
Scantlings = Literal["gross", "net"]
# Stiffeners of more section than twice their plate stand on no ship.
StiffenerShare = Annotated[float, Field(strict=True, ge=0, le=2, allow_inf_nan=False)]


class _Plating(Span):
    """Plates over a part of the length."""

    thickness_m: PlateThickness | None = None
    stiffener_share: StiffenerShare | None = None


class Zone(Span):
    """[[structure.zones]]: another thickness for a part of the plating."""

    part: Part
    thickness_m: PlateThickness
    stiffener_share: StiffenerShare | None = None
    from_height_m: Number | None = None
    to_height_m: Number | None = None

    @model_validator(mode="after")
    def _upwards(self) -> Self:
        low, high = self.from_height_m, self.to_height_m
        if low is not None and high is not None and high <= low:
            raise ValueError(f"to_height_m = {high:g} is not above from_height_m = {low:g}")
        return self


class Hatch(Span):
    """[[structure.hatches]]: openings of the upper deck."""

    breadth_m: Positive


class InnerBottom(_Plating):
    """[structure.inner_bottom]: the tank top, from side to side."""

    height_m: Positive


class DoubleSide(_Plating):
    """[structure.double_side]: an inner skin on either side, upright, from the inner bottom to the deck."""

    breadth_m: Positive


class DeckBelow(_Plating):
    """[[structure.decks]]: a deck below the upper one, or a strip of it along the side."""

    height_m: Positive
    outboard_of_m: NotNegative = 0.0


class LongitudinalBulkhead(_Plating):
    """[[structure.longitudinal_bulkheads]]: upright plating at y on either side, or once on the centre line."""

    y_m: NotNegative
    foot_m: Number | None = None
    head_m: Number | None = None

    @model_validator(mode="after")
    def _upright(self) -> Self:
        if self.foot_m is not None and self.head_m is not None and self.head_m <= self.foot_m:
            raise ValueError(f"head_m = {self.head_m:g} is not above foot_m = {self.foot_m:g}")
        return self


class TransverseBulkheads(Table):
    """[[structure.transverse_bulkheads]]: mass at their places, no stiffness."""

    x_m: Annotated[tuple[Number, ...], Field(min_length=1)]
    thickness_m: PlateThickness | None = None
    stiffener_share: StiffenerShare | None = None


class Superstructure(_Plating):
    """[[structure.superstructures]]: a house on the upper deck that bends with the hull by a share."""

    height_m: Positive
    breadth_m: Positive
    effective_share: Share = 0.5


class StructureInput(Table):
    """[structure]: one steel shell of one thickness, and the members that are given besides."""

    youngs_modulus_pa: YoungsModulus = 2.06e11
    poissons_ratio: Annotated[float, Field(ge=0, lt=0.5)] = 0.3
    density_kg_m3: Positive = 7850.0
    shell_thickness_m: PlateThickness = 0.016
    midship_second_moment_m4: Positive | None = None
    midship_shear_area_m2: Positive | None = None
    stiffener_share: StiffenerShare = 0.0
    scantlings: Scantlings = "gross"
    corrosion_margin_m: NotNegative = 0.0
    zones: tuple[Zone, ...] = ()
    hatches: tuple[Hatch, ...] = ()
    inner_bottom: InnerBottom | None = None
    double_side: DoubleSide | None = None
    decks: tuple[DeckBelow, ...] = ()
    longitudinal_bulkheads: tuple[LongitudinalBulkhead, ...] = ()
    transverse_bulkheads: tuple[TransverseBulkheads, ...] = ()
    superstructures: tuple[Superstructure, ...] = ()

    @model_validator(mode="after")
    def _something_is_left_of_every_plate(self) -> Self:
        if self.scantlings == "gross":
            return self
        if not self.corrosion_margin_m:
            raise ValueError(
                'scantlings = "net" needs corrosion_margin_m, by which a net plate is thinner than a gross one'
            )
        thinnest = min([self.shell_thickness_m, *(item.thickness_m for item in self.platings if item.thickness_m)])
        if thinnest <= self.corrosion_margin_m:
            raise ValueError(
                f"corrosion_margin_m = {self.corrosion_margin_m:g} leaves nothing of the plate of {thinnest:g} m; "
                "both are in metres"
            )
        return self

    @property
    def platings(self) -> tuple[Zone | _Plating, ...]:
        """Everything that lies along the ship and has a thickness of its own."""
        single = tuple(item for item in (self.inner_bottom, self.double_side) if item is not None)
        return (*self.zones, *single, *self.decks, *self.longitudinal_bulkheads, *self.superstructures)

    @property
    def is_plain_shell(self) -> bool:
        """Whether nothing but the shell of one thickness stands against bending, shear and torsion."""
        return not (self.platings or self.hatches or self.stiffener_share or self.scantlings == "net")

    def opening_breadth_m(self, x_m: float) -> float:
        """Breadth of the upper deck's opening at x; 0 where it is closed."""
        return max((hatch.breadth_m for hatch in self.hatches if hatch.reaches(x_m)), default=0.0)

    @property
    def bounds_m(self) -> tuple[float, ...]:
        """Every x where a member begins or ends, in order."""
        spans = (*self.platings, *self.hatches)
        return tuple(sorted({x for span in spans for x in span.ends_m}))

    def require_within(self, length_overall_m: float, breadth_m: float) -> None:
        """Hold every place along and across against a ship of that length and breadth, in m.

        Raises:
            ValueError: names the key, the value and the limit.
        """
        along = [("from_m or to_m", x) for x in self.bounds_m]
        along += [("transverse_bulkheads.x_m", x) for item in self.transverse_bulkheads for x in item.x_m]
        for key, x in along:
            if not -1e-6 <= x <= length_overall_m + 1e-6:
                raise ValueError(
                    f"structure: {key} has {x:g}, outside the ship (0 .. {length_overall_m:g} m); "
                    "x runs from the aft end of the length overall"
                )
        half = breadth_m / 2
        across = [("hatches.breadth_m", item.breadth_m, breadth_m) for item in self.hatches]
        across += [("longitudinal_bulkheads.y_m", item.y_m, half) for item in self.longitudinal_bulkheads]
        across += [("decks.outboard_of_m", item.outboard_of_m, half) for item in self.decks]
        across += [("double_side.breadth_m", item.breadth_m, half) for item in (self.double_side,) if item is not None]
        for key, value, limit in across:
            if value >= limit:
                raise ValueError(f"structure: {key} = {value:g} is not below {limit:g} m; breadth_m is {breadth_m:g}")
