"""The ship in still water: weight and buoyancy along her, shear force and bending moment, hogging positive.

With m g - b = q the load downwards, V = Int q dx and M = Int V dx from the aft end: dM/dx = V, and both come to nought
at the fore end where weight and buoyancy balance. Weights are linear pieces with point masses; the buoyancy is the
quadratic through the three Gauss places of every interval between sections, whose integral and moment are those of the
hull's own quadrature. Both are integrated exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PPoly

from hullform.hull.equilibrium import Waterline
from hullform.hull.loft import Hull
from hullform.hull.sections import quadrature
from hullform.loading.distributions import Distribution
from hullform.loading.gravity import GRAVITY_M_S2

Array = NDArray[np.float64]

# Of the weight (times the length): shear forces and moments below this are round-off, of which nothing is a share.
_NOTHING = 1e-9


@dataclass(frozen=True, slots=True)
class Extremes:
    """The least and the greatest value of a curve, and the x in m where each stands."""

    least: float
    least_x_m: float
    greatest: float
    greatest_x_m: float

    @property
    def size(self) -> float:
        """The larger of the two without its sign."""
        return max(abs(self.least), abs(self.greatest))


@dataclass(frozen=True, eq=False)
class StillWater:
    """Curves along the ship as piecewise polynomials in x (m); where a piece ends there may be a jump.

    Attributes:
        waterline: at which she lies.
        weight, buoyancy: force per length in N/m; point masses are not in the weight but in what follows.
        shear_force: V in N.
        bending_moment: M in N m, hogging positive.
        shear_extremes, moment_extremes: of V in N and M in N m.
        unclosed_shear_n, unclosed_moment_n_m: V and M at the fore end: what is not balanced.
        shear_residual, moment_residual: the same over the largest |V| and |M|.
    """

    waterline: Waterline
    weight: PPoly
    buoyancy: PPoly
    shear_force: PPoly
    bending_moment: PPoly
    shear_extremes: Extremes
    moment_extremes: Extremes
    unclosed_shear_n: float
    unclosed_moment_n_m: float
    shear_residual: float
    moment_residual: float


def still_water(hull: Hull, items: Sequence[Distribution], waterline: Waterline, density_kg_m3: float) -> StillWater:
    """Load a hull, afloat at a waterline in water of a density, with all her weights."""
    points = sorted((x, mass * GRAVITY_M_S2) for item in items for x, mass in item.points)
    places, forces = np.array([x for x, _ in points]), np.array([force for _, force in points])
    breaks = np.unique(np.concatenate([hull.x_m, places, *(item.x_m for item in items)]))
    ends = GRAVITY_M_S2 * np.sum([item.at_piece_ends(breaks) for item in items], axis=0)
    weight = PPoly(np.stack([(ends[1] - ends[0]) / np.diff(breaks), ends[0]]), breaks)
    buoyancy = PPoly(GRAVITY_M_S2 * density_kg_m3 * _areas(hull, waterline, breaks), breaks)
    load = -buoyancy.c
    load[1:] += weight.c
    shear = PPoly(load, breaks).antiderivative()
    jumps = np.concatenate([[0.0], np.cumsum(forces)])
    shear.c[-1] += jumps[np.searchsorted(places, breaks[:-1], side="right")]
    moment = shear.antiderivative()
    shear_extremes = _extremes(shear, PPoly(load, breaks))
    moment_extremes = _extremes(moment, shear)
    at_fore_end = float(jumps[-1] - jumps[np.searchsorted(places, breaks[-1])])
    unclosed_shear = float(shear(breaks[-1])) + at_fore_end
    unclosed_moment = float(moment(breaks[-1]))
    whole = GRAVITY_M_S2 * sum(item.mass_kg for item in items)
    return StillWater(
        waterline=waterline,
        weight=weight,
        buoyancy=buoyancy,
        shear_force=shear,
        bending_moment=moment,
        shear_extremes=shear_extremes,
        moment_extremes=moment_extremes,
        unclosed_shear_n=unclosed_shear,
        unclosed_moment_n_m=unclosed_moment,
        shear_residual=abs(unclosed_shear) / max(shear_extremes.size, _NOTHING * whole),
        moment_residual=abs(unclosed_moment) / max(moment_extremes.size, _NOTHING * whole * hull.length_overall_m),
    )


def sampled(curve: PPoly, points: int = 5) -> tuple[Array, Array]:
    """x and values at some places of every piece, both its ends among them, so that a jump is upright."""
    share = np.linspace(0.0, 1.0, points)
    run = np.diff(curve.x)[:, None] * share
    values = np.zeros_like(run)
    for coefficient in curve.c:
        values = values * run + coefficient[:, None]
    return (curve.x[:-1, None] + run).ravel(), values.ravel()


def _areas(hull: Hull, waterline: Waterline, breaks: Array) -> Array:
    """(3, pieces) coefficients, highest power first, of the immersed area in m2 from the left end of each piece."""
    places = quadrature(hull.x_m)[0].reshape(-1, 3)
    areas = hull.immersed_areas(waterline, places)
    width = np.diff(hull.x_m)
    share = (places[0] - hull.x_m[0]) / width[0]
    through = np.linalg.solve(np.vander(share), areas.T) / width ** np.array([[2], [1], [0]])
    middle = (breaks[:-1] + breaks[1:]) / 2
    interval = np.clip(np.searchsorted(hull.x_m, middle) - 1, 0, width.size - 1)
    second, first, value = through[:, interval]
    along = breaks[:-1] - hull.x_m[interval]
    moved = np.stack([second, first + 2 * along * second, value + along * (first + along * second)])
    return np.where((middle > hull.x_m[0]) & (middle < hull.x_m[-1]), moved, 0.0)


def _extremes(curve: PPoly, slope: PPoly) -> Extremes:
    """Extremes among the ends of all pieces, both sides of a jump, and the places where the slope is nought."""
    level = slope.roots(discontinuity=False, extrapolate=False)
    level = level[np.isfinite(level)]
    x, values = sampled(curve, points=2)
    x, values = np.concatenate([x, level]), np.concatenate([values, curve(level)])
    least, greatest = int(values.argmin()), int(values.argmax())
    return Extremes(float(values[least]), float(x[least]), float(values[greatest]), float(x[greatest]))
