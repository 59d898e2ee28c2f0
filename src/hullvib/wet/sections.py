"""Wetted half sections of a hull: curves from the keel up to the waterline at places along her."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError

Array = NDArray[np.float64]

# Of the largest half-breadth or draught: what a curve may miss the centre line or the waterline by.
_TOLERANCE = 1e-6
_SPREAD = 0.125  # of the girth: where the turning at a vertex counts
_LOOKS = 257  # places along a girth at which its turning is summed up


@dataclass(frozen=True, eq=False)
class Sections:
    """Half sections below the waterline, to port, at places along the hull.

    x_m (n,) places from the girder's aft end, increasing, n >= 2; points_m (n, k, 2) points [y, z] of each section in
    m, y >= 0 from the centre line, z <= 0 from the waterline, from the keel on the centre line up to the waterline (or,
    for a section that is wholly under water, back to the centre line). A section that has shrunk to nothing repeats one
    point. Raises ArgumentError.
    """

    x_m: Array
    points_m: Array

    def __init__(self, x_m: ArrayLike, points_m: ArrayLike) -> None:
        x, points = np.array(x_m, dtype=np.float64), np.array(points_m, dtype=np.float64)
        if x.ndim != 1 or len(x) < 2 or points.ndim != 3 or points.shape[0] != len(x) or points.shape[2] != 2:
            raise ArgumentError(
                f"x_m has shape {x.shape} and points_m {points.shape}; give (n,) places and (n, k, 2) points [y, z], "
                "n 2 or more."
            )
        if points.shape[1] < 2:
            raise ArgumentError("points_m has fewer than two points a section.")
        if not (np.isfinite(x).all() and np.isfinite(points).all()):
            raise ArgumentError("the sections hold a number that is not finite.")
        if (np.diff(x) <= 0).any():
            where = int(np.argmax(np.diff(x) <= 0))
            raise ArgumentError(f"x_m must increase, but {x[where + 1]:g} follows {x[where]:g}.")
        y, z = points[..., 0], points[..., 1]
        tolerance = _TOLERANCE * max(float(y.max()), float(-z.min()))
        faults = (
            (y.min(axis=1) < -tolerance, "lies across the centre line: give the half with y >= 0"),
            (z.max(axis=1) > tolerance, "rises above the waterline: cut it at z = 0"),
            (y[:, 0] > tolerance, "does not begin at the centre line: add the point of the keel, y = 0"),
            (
                (z[:, -1] < -tolerance) & (y[:, -1] > tolerance),
                "ends neither at the waterline nor at the centre line: cut it at z = 0",
            ),
        )
        for wrong, complaint in faults:
            if wrong.any():
                raise ArgumentError(f"the section at x = {x[int(wrong.argmax())]:g} m {complaint}.")
        if tolerance <= 0.0 or float(np.abs(_areas(points)).max()) == 0.0:
            raise ArgumentError("no section has an area under water.")
        for name, values in (("x_m", x), ("points_m", points)):
            values.flags.writeable = False
            object.__setattr__(self, name, values)

    @property
    def half_breadth_m(self) -> Array:
        """(n,) half-breadths in the waterline; 0 where a section ends at the centre line."""
        return np.asarray(np.maximum(self.points_m[:, -1, 0], 0.0), dtype=np.float64)

    @property
    def draught_m(self) -> Array:
        """(n,) depths of the lowest points below the waterline."""
        return np.asarray(-self.points_m[..., 1].min(axis=1), dtype=np.float64)

    @property
    def area_m2(self) -> Array:
        """(n,) areas of the whole sections, both sides, below the waterline."""
        return _areas(self.points_m)

    @property
    def length_m(self) -> float:
        """Length over which the hull is wet."""
        return float(self.x_m[-1] - self.x_m[0])

    @property
    def volume_m3(self) -> float:
        """Volume between the first and the last section, the area linear between them."""
        return float(np.trapezoid(self.area_m2, self.x_m))

    def cut(self, pieces: int) -> Array:
        """Points that part each section into `pieces`, keel to waterline, (n, pieces + 1, 2).

        Pieces are spread by length and, with the same weight for a quarter turn, by the turning of the curve, so that
        a sharp bilge has short ones. The turning at a vertex is spread over an eighth of the girth about it, as far as
        there is any.
        """
        steps = np.diff(self.points_m, axis=1)
        lengths = np.hypot(steps[..., 0], steps[..., 1])
        girth = np.maximum(lengths.sum(axis=1, keepdims=True), 1e-300)
        along = np.concatenate([np.zeros_like(girth), np.cumsum(lengths, axis=1)], axis=1) / girth
        turns = _turns(steps, lengths > _TOLERANCE * girth)
        at = np.linspace(0.0, 1.0, _LOOKS)
        first = np.maximum(along[:, 1:-1] - 0.5 * _SPREAD, 0.0)
        last = np.minimum(along[:, 1:-1] + 0.5 * _SPREAD, 1.0)
        passed = np.clip((at[:, None] - first[:, None]) / (last - first)[:, None], 0.0, 1.0)
        measure = at + np.einsum("slv,sv->sl", passed, turns) / (0.5 * np.pi)
        levels = np.linspace(0.0, 1.0, pieces + 1)
        out = np.empty((len(self.x_m), pieces + 1, 2))
        for section, curve in enumerate(self.points_m):
            places = np.interp(levels * measure[section, -1], measure[section], at)
            for axis in (0, 1):
                out[section, :, axis] = np.interp(places, along[section], curve[:, axis])
        out[:, 0], out[:, -1] = self.points_m[:, 0], self.points_m[:, -1]
        return out


def _turns(steps: Array, real: NDArray[np.bool_]) -> Array:
    """Angles in rad by which curves turn at their inner vertices, without sign, (n, k - 2)."""
    heading = np.arctan2(steps[..., 1], steps[..., 0])
    # a step of no length goes on as the one before it
    last = np.maximum.accumulate(np.where(real, np.arange(real.shape[1]), -1), axis=1)
    first = real.argmax(axis=1)[:, None]
    heading = np.take_along_axis(heading, np.where(last < 0, first, last), axis=1)
    turn = np.diff(heading, axis=1)
    return np.asarray(np.abs((turn + np.pi) % (2.0 * np.pi) - np.pi), dtype=np.float64)


def _areas(points: Array) -> Array:
    y, z = points[..., 0], points[..., 1]
    return np.asarray(((y[:, 1:] + y[:, :-1]) * np.diff(z, axis=1)).sum(axis=1), dtype=np.float64)
