"""Many sections side by side: what every kind of them can tell, and those that are super-ellipses."""

from __future__ import annotations

from typing import NamedTuple, Protocol, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import PchipInterpolator

from hullform.errors import HullError
from hullform.hull.arcs import curve_points
from hullform.hull.super_ellipse import ShellSection, half_breadth_at, moment_below, shell_section

Array = NDArray[np.float64]

_POINTS_PER_INTERVAL = 3
_SNAP = 1e-7  # of the largest half-breadth: nearer to the centre plane a point lies on it
_THINNEST = 1e-5  # of the greatest depth: a section with breadth but no depth keeps this much, so that it has an inside
_GIRTH_POINTS = 41  # a section's polygon is then shorter than the curve by less than 1e-3


class Cut(NamedTuple):
    """What a level cuts off sections, both sides together, each with the leading dimensions of the sections.

    area below the level (m2) and its first moment about the base line (m3); of the waterline there the half-breadth
    (m), what lies outside the section within it taken off, and the third power of it (m3), likewise.
    """

    area: Array
    moment_z: Array
    half_breadth: Array
    half_breadth_cubed: Array


class SectionSet(Protocol):
    """Sections side by side, of any one kind; lengths in m, heights above the base line, both sides together."""

    @property
    def half_breadth(self) -> Array:
        """Half-breadth at each section's top."""

    @property
    def top(self) -> Array:
        """Height of each section's top: the deck at side."""

    @property
    def keel(self) -> Array:
        """Height of its lowest point."""

    def interpolated(self, x: Array, at: ArrayLike) -> Self:
        """Sections given at x (stations,) at other places, without overshoot."""

    def areas_below(self, height: ArrayLike | None = None) -> Array:
        """Area below a height (broadcast), or of the whole section."""

    def cut(self, height: ArrayLike) -> Cut:
        """What lies below a height (broadcast), held to the section's top."""

    def points(self, count: int) -> Array:
        """Points (sections, count, 2) [half-breadth, height] from keel to deck."""

    def mesh_points(self, count: int) -> Array:
        """Points (sections, k, 2) for a surface: those near the centre plane lie on it."""

    def shell(self, thickness_m: float) -> ShellSection:
        """Of a closed shell of one thickness, deck included; its axis is below the top."""

    def wetted_surface(self, x: Array, heights: ArrayLike) -> float:
        """Of sections at x (stations,): sides and bottom below heights (broadcast), in m2, end faces left out."""


class Sections(NamedTuple):
    """Super-ellipse sections, arrays (..., stations): lengths in m, top and keel above the base line."""

    half_breadth: Array
    depth: Array
    top: Array
    p: Array
    q: Array

    @property
    def keel(self) -> Array:
        """Height of the sections' lowest points above the base line, in m."""
        return self.top - self.depth

    @property
    def shape(self) -> tuple[Array, Array, Array, Array]:
        """half_breadth, depth, p, q: the arguments of the section kernels."""
        return self.half_breadth, self.depth, self.p, self.q

    def below_top(self, height: ArrayLike) -> Array:
        """Depth in m, below each section's top, of a height above the base line, held to 0..depth."""
        return np.clip(self.top - np.asarray(height, dtype=np.float64), 0.0, self.depth)

    def interpolated(self, x: Array, at: ArrayLike) -> Sections:
        """Interpolate sections given at x (stations,) to the places `at`, without overshoot.

        Half-breadth, top and keel height and the logarithms of the exponents follow monotone cubics (PCHIP; Fritsch &
        Butland 1984), so that a straight keel stays straight under any sheer.
        """
        logs = np.log(self.p), np.log(self.q)
        stack = np.stack(np.broadcast_arrays(self.half_breadth, self.top, self.keel, *logs))
        a, top, keel, log_p, log_q = PchipInterpolator(x, stack, axis=-1)(np.asarray(at, dtype=np.float64))
        return Sections(np.maximum(a, 0.0), np.maximum(top - keel, 0.0), top, np.exp(log_p), np.exp(log_q))

    def areas_below(self, height: ArrayLike | None = None) -> Array:
        """Area in m2 of each section below a height in m above the base line (broadcast), or of the whole section."""
        return moment_below(*self.shape, 0.0 if height is None else self.below_top(height))

    def cut(self, height: ArrayLike) -> Cut:
        """What lies below a height in m above the base line (broadcast), held to the section's top."""
        level = self.below_top(height)
        area = moment_below(*self.shape, level)
        y = half_breadth_at(*self.shape, level)
        return Cut(area, self.top * area - moment_below(*self.shape, level, 1), y, y**3)

    def points(self, count: int) -> Array:
        """Points (sections, count, 2) [half-breadth, height] in m, keel to deck, spread by arc and turning."""
        y, zeta = curve_points(*self.shape, count)
        return np.stack([y, self.top[:, None] - zeta], axis=-1)

    def mesh_points(self, count: int) -> Array:
        """The same for a surface: sections that are thin to the last keep an inside or have none."""
        snap = _SNAP * float(self.half_breadth.max())
        a = np.where(self.half_breadth > snap, self.half_breadth, 0.0)
        b = np.where(a > 0, np.maximum(self.depth, _THINNEST * float(self.depth.max())), self.depth)
        points = Sections(a, b, self.top, self.p, self.q).points(count)
        points[..., 0][points[..., 0] <= snap] = 0.0
        return points

    def shell(self, thickness_m: float) -> ShellSection:
        """Of a closed shell of one thickness in m, deck included; its axis is below the top."""
        return shell_section(*self.shape, thickness_m)

    def wetted_surface(self, x: Array, heights: ArrayLike) -> float:
        """Of sections at x (stations,): sides and bottom below heights, in m2, from facets between the sections."""
        y, zeta = curve_points(*self.shape, _GIRTH_POINTS, self.below_top(heights))
        z = self.top[:, None] - zeta
        corner = np.stack([np.broadcast_to(x[:, None], y.shape), y, z], axis=-1)
        first_diagonal = corner[1:, 1:] - corner[:-1, :-1]
        second_diagonal = corner[1:, :-1] - corner[:-1, 1:]
        facets = np.linalg.norm(np.cross(first_diagonal, second_diagonal), axis=-1) / 2
        # A section wholly above the water has its points gathered at the keel: facets up to it are not wet.
        wet = self.keel < np.asarray(heights, dtype=np.float64)
        return float(2 * facets[wet[1:] & wet[:-1]].sum())


def quadrature(x: Array) -> tuple[Array, Array]:
    """Return Gauss-Legendre places and weights along the ship, three in each interval between stations x."""
    node, weight = np.polynomial.legendre.leggauss(_POINTS_PER_INTERVAL)
    half_length = np.diff(x)[:, None] / 2
    middle = (x[1:] + x[:-1])[:, None] / 2
    return (middle + half_length * node).ravel(), (half_length * weight).ravel()


def checked_parameter(name: str, given: ArrayLike, x: Array) -> Array:
    """One parameter of super-ellipse sections at x, read-only. Raises HullError."""
    values = np.array(given, dtype=np.float64)
    if values.shape != x.shape or x.ndim != 1 or len(x) < 3:
        raise HullError(
            f"Hull: {name} has shape {values.shape} and x_m {x.shape}; give one value a section, three or more"
        )
    if not np.isfinite(values).all():
        raise HullError(f"Hull: {name} holds a number that is not finite")
    if name in ("half_breadth_m", "depth_m") and values.min() < 0:
        raise HullError(f"Hull: {name} is {values.min():g} m at x = {x[values.argmin()]:g} m; it cannot be negative")
    if name in "pq" and values.min() <= 0:
        raise HullError(
            f"Hull: exponent {name} is {values.min():g} at x = {x[values.argmin()]:g} m; it must be positive"
        )
    values.setflags(write=False)
    return values
