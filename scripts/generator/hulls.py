"""Hulls by formula: waterlines that close on a profile, a hard chine, a pontoon; knuckles and bulbs on top."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from generator.sections import Array, Dimensions, curves_of


@dataclass(frozen=True)
class Rise:
    """A value that goes from one figure to another between two heights: low + (high - low) s^2 (3 - 2 s)."""

    low: float
    high: float
    from_m: float
    to_m: float

    def at(self, z: Array) -> Array:
        """Return the value at heights z."""
        s = np.clip((z - self.from_m) / (self.to_m - self.from_m), 0.0, 1.0)
        return np.asarray(self.low + (self.high - self.low) * s * s * (3.0 - 2.0 * s))


@dataclass(frozen=True)
class Sheer:
    """Height of the deck edge: D + aft (1 - 2 x/L)^2 abaft midships, D + fore (2 x/L - 1)^2 before it."""

    depth_m: float
    length_m: float
    aft_m: float = 0.0
    fore_m: float = 0.0

    def at(self, x_m: float) -> float:
        """Return the height at x."""
        t = 2.0 * x_m / self.length_m - 1.0
        return self.depth_m + (self.fore_m if t > 0 else self.aft_m) * t * t


@dataclass(frozen=True)
class Midship:
    """The midship section: a rise of floor, a round bilge, an upright side."""

    half_breadth_m: float
    bilge_radius_m: float
    floor_rad: float = 0.0

    def at(self, z: Array) -> Array:
        """Return half-breadths: the floor y = z / tan a, an arc tangent to it and to the side, then B/2."""
        b, r, a = self.half_breadth_m, self.bilge_radius_m, self.floor_rad
        centre_z = (b - r) * np.tan(a) + r / np.cos(a)
        tangent_z = centre_z - r * np.cos(a)
        arc = b - r + np.sqrt(np.maximum(r * r - np.clip(centre_z - z, 0.0, r) ** 2, 0.0))
        floor = z / np.tan(a) if a > 0 else np.full_like(z, b - r)
        return np.asarray(np.where(z < tangent_z, floor, arc))


@dataclass(frozen=True)
class Run:
    """How the waterlines of one half close: y / y_midship = (1 - s^n)^m, s from the parallel body to the profile.

    `full_m`: x where the parallel body ends; `profile_m`: x where the waterline closes; n, m: fullness and hollow. All
    vary with height; sections stay nested while the profile goes outwards, n grows and m falls with height.
    """

    full_m: Rise
    profile_m: Rise
    fullness: Rise
    hollow: Rise

    def at(self, x_m: float, z: Array) -> Array:
        """Return the share of the midship half-breadth at heights z."""
        s = (x_m - self.full_m.at(z)) / (self.profile_m.at(z) - self.full_m.at(z))
        return np.asarray((1.0 - np.clip(s, 0.0, 1.0) ** self.fullness.at(z)) ** self.hollow.at(z))


@dataclass(frozen=True)
class Bulb:
    """An ellipsoid at the forefoot: half-breadth, half-height and centre height; it ends ahead of the stem, metres."""

    half_breadth_m: float
    half_height_m: float
    centre_m: float
    from_m: float
    to_m: float

    def at(self, x_m: float, z: Array) -> Array:
        """Return its half-breadths at x, nought outside."""
        t = np.clip((x_m - self.from_m) / (self.to_m - self.from_m), 0.0, 1.0)
        swell = np.sqrt(max(1.0 - t**4, 0.0)) * min(1.0, t / 0.3) if t > 0 else 0.0
        inside = 1.0 - ((z - self.centre_m) / (self.half_height_m * max(np.sqrt(max(1.0 - t**4, 0.0)), 1e-9))) ** 2
        return np.asarray(self.half_breadth_m * swell * np.sqrt(np.maximum(inside, 0.0)))


@dataclass(frozen=True)
class Knuckle:
    """Above a height the sections open more slowly (or faster): z counts as knuckle + (z - knuckle) * rate."""

    height_m: float
    rate: float

    def at(self, z: Array) -> Array:
        """Return the height whose half-breadth is taken."""
        return np.asarray(np.where(z > self.height_m, self.height_m + (z - self.height_m) * self.rate, z))


@dataclass(frozen=True)
class WaterlineHull:
    """A ship: her midship section narrowed by a run aft and an entrance forward."""

    dimensions: Dimensions
    sheer_line: Sheer
    midship: Midship
    aft: Run
    fore: Run
    bulb: Bulb | None = None
    knuckle: Knuckle | None = None

    def sheer(self, x_m: float) -> float:
        """Return the height of the deck edge at x, metres."""
        return self.sheer_line.at(x_m)

    def half_breadths(self, x_m: float, z: Array) -> Array:
        """Return half-breadths at heights z, metres."""
        z = z if self.knuckle is None else self.knuckle.at(z)
        y = self.midship.at(z) * self.aft.at(x_m, z) * self.fore.at(x_m, z)
        if self.bulb is None:
            return np.asarray(y)
        # a sum of fourth powers rounds the hollow between the bulb and the hull
        return np.asarray((y**4 + self.bulb.at(x_m, z) ** 4) ** 0.25)

    def section(self, x_m: float) -> list[Array]:
        """Return the curves of the section at x."""
        return curves_of(lambda z: self.half_breadths(x_m, z), self.sheer(x_m), self.dimensions.breadth_m)


@dataclass(frozen=True)
class WigleyHull:
    """y = B/2 (1 - |xi|^n) (1 - (zeta/T)^m) below the waterline, upright above; the keel is one point."""

    dimensions: Dimensions
    sheer_line: Sheer
    waterline_power: float
    section_power: float

    def sheer(self, x_m: float) -> float:
        """Return the height of the deck edge at x, metres."""
        return self.sheer_line.at(x_m)

    def half_breadths(self, x_m: float, z: Array) -> Array:
        """Return half-breadths at heights z, metres."""
        main = self.dimensions
        xi, zeta = abs(2.0 * x_m / main.length_m - 1.0), np.clip(1.0 - z / main.draught_m, 0.0, 1.0)
        return np.asarray(0.5 * main.breadth_m * (1.0 - xi**self.waterline_power) * (1.0 - zeta**self.section_power))

    def section(self, x_m: float) -> list[Array]:
        """Return the curves of the section at x."""
        return curves_of(lambda z: self.half_breadths(x_m, z), self.sheer(x_m), self.dimensions.breadth_m)


@dataclass(frozen=True)
class ChineHull:
    """A hard-chine craft: a V bottom to the chine, a topside with some hollow flare to the deck."""

    dimensions: Dimensions
    sheer_line: Sheer
    chine_half_breadth_m: float
    chine_height_m: float
    chine_rise_fore_m: float
    keel_rise_fore_m: float
    keel_rise_aft_m: float
    bottom_power: float
    flare_power: float

    def sheer(self, x_m: float) -> float:
        """Return the height of the deck edge at x, metres."""
        return self.sheer_line.at(x_m)

    def half_breadths(self, x_m: float, z: Array) -> Array:
        """Return half-breadths at heights z, metres."""
        t = 2.0 * x_m / self.dimensions.length_m - 1.0
        fore, aft = max(t, 0.0), max(-t, 0.0)
        keel = self.keel_rise_fore_m * max((fore - 0.55) / 0.45, 0.0) ** 2 + self.keel_rise_aft_m * aft**2
        chine_z = self.chine_height_m + self.chine_rise_fore_m * fore**2 + 1.3 * self.keel_rise_aft_m * aft**2
        chine_y = self.chine_half_breadth_m * (1.0 - fore**2.4 - 0.14 * aft**2)
        deck_y = 0.5 * self.dimensions.breadth_m * (1.0 - fore**3.6 - 0.10 * aft**2)
        bottom = chine_y * np.clip((z - keel) / (chine_z - keel), 0.0, 1.0) ** (1.0 / self.bottom_power)
        up = np.clip((z - chine_z) / (self.sheer(x_m) - chine_z), 0.0, 1.0)
        side = chine_y + (deck_y - chine_y) * up ** (1.0 + (self.flare_power - 1.0) * fore)
        return np.asarray(np.where(z < keel, 0.0, np.where(z < chine_z, bottom, side)))

    def section(self, x_m: float) -> list[Array]:
        """Return the curves of the section at x."""
        return curves_of(lambda z: self.half_breadths(x_m, z), self.sheer(x_m), self.dimensions.breadth_m)


@dataclass(frozen=True)
class Barge:
    """A pontoon: a flat bottom, a round bilge, raked ends, sides that may draw in towards the ends."""

    dimensions: Dimensions
    bilge_radius_m: float
    rake_aft_m: float
    rake_fore_m: float
    end_height: float
    taper: float

    def sheer(self, x_m: float) -> float:
        """Return the height of the deck edge at x, metres."""
        return self.dimensions.depth_m

    def half_breadths(self, x_m: float, z: Array) -> Array:
        """Return half-breadths at heights z, metres."""
        main = self.dimensions
        inward = max(1.0 - x_m / self.rake_aft_m, (x_m - main.length_m) / self.rake_fore_m + 1.0, 0.0)
        bottom = self.end_height * main.depth_m * inward**1.4
        side = 0.5 * main.breadth_m * (1.0 - self.taper * inward**2)
        r = self.bilge_radius_m
        y = side - r + np.sqrt(np.maximum(r * r - np.clip(r - (z - bottom), 0.0, r) ** 2, 0.0))
        return np.asarray(np.where(z < bottom, 0.0, y))

    def section(self, x_m: float) -> list[Array]:
        """Return the curves of the section at x."""
        return curves_of(lambda z: self.half_breadths(x_m, z), self.sheer(x_m), self.dimensions.breadth_m)
