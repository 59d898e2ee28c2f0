"""Sections that are polylines with matched points: any curve, of any number of contours.

Point j of one section is the same place of the form as point j of the next (`correspondence`), so that lines along the
ship, and knuckles, lie between them. A section of two contours is one polyline: from the keel round the lower contour
to the centre line, up along it, and round the upper one; the stretch on the centre line encloses nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullform.errors import HullError
from hullform.hull.fair_sections import fair_sections
from hullform.hull.sections import Cut
from hullform.hull.super_ellipse import ShellSection

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Of the greatest half-breadth: a point nearer to the centre plane lies on it.
ON_THE_CENTRE_LINE = 1e-6
# In m: points of a surface are told apart to this.
_FINEST_M = 1e-6


@dataclass(frozen=True, eq=False)
class Contours:
    """Polyline sections side by side.

    Attributes:
        outline: (..., m, 2) points [half-breadth, height] in m of each section, from keel to deck, m >= 2;
            half-breadths >= 0.

    Raises:
        HullError: another shape, a number that is not finite, or a negative half-breadth.
    """

    outline: Array

    def __post_init__(self) -> None:
        outline = np.array(self.outline, dtype=np.float64)
        if outline.ndim < 2 or outline.shape[-2] < 2 or outline.shape[-1] != 2:
            raise HullError(
                f"Contours: outline has shape {outline.shape}; give (sections, points, 2), two or more points"
            )
        if not np.isfinite(outline).all() or outline[..., 0].min() < 0:
            raise HullError("Contours: outline holds a number that is not finite, or a negative half-breadth")
        outline.setflags(write=False)
        object.__setattr__(self, "outline", outline)

    @property
    def half_breadth(self) -> Array:
        """Half-breadth at each section's top, in m."""
        return np.asarray(self.outline[..., -1, 0])

    @property
    def top(self) -> Array:
        """Height of the deck at side, in m above the base line."""
        return np.asarray(self.outline[..., -1, 1])

    @property
    def keel(self) -> Array:
        """Height of each section's lowest point, in m above the base line."""
        return np.asarray(self.outline[..., 1].min(axis=-1))

    def interpolated(self, x: Array, at: ArrayLike) -> Contours:
        """Sections given at x (sections,) at other places: every point follows a cubic without overshoot."""
        between = fair_sections(x, self.outline)(np.asarray(at, dtype=np.float64))
        between[..., 0] = np.maximum(between[..., 0], 0.0)
        return Contours(between)

    def areas_below(self, height: ArrayLike | None = None) -> Array:
        """Area in m2, both sides, below a height in m above the base line (broadcast), or of the whole section."""
        y, z = self.outline[..., 0], self.outline[..., 1]
        if height is None:
            return np.asarray(((y[..., 1:] + y[..., :-1]) * np.diff(z)).sum(-1))
        return self.cut(height).area

    def cut(self, height: ArrayLike) -> Cut:
        """What lies below a height in m above the base line (broadcast), held to the section's top.

        2 Int y dz along the curve and 2 Int y z dz, exact for the polyline; where the curve goes down, as over a
        tunnel or under a bulb, they count off. On the waterline likewise.
        """
        y, z = self.outline[..., 0], self.outline[..., 1]
        level = np.asarray(height, dtype=np.float64)[..., None]
        low, high = z[..., :-1], z[..., 1:]
        rise = high - low
        slope = np.divide(np.diff(y), rise, out=np.zeros_like(rise), where=rise != 0)
        start, end = np.minimum(low, level), np.minimum(high, level)
        y_start, y_end = (y[..., :-1] + slope * (held - low) for held in (start, end))
        step = end - start
        area = (y_start + y_end) * step
        moment = step / 3 * (y_start * start + (y_start + y_end) * (start + end) + y_end * end)
        # a level at the top, or above it, is cut just below the top
        at = np.minimum(level, self.top[..., None])
        crossed = np.where((low < at) & (high >= at), 1.0, 0.0) - np.where((high < at) & (low >= at), 1.0, 0.0)
        there = y[..., :-1] + slope * (at - low)
        return Cut(
            np.asarray(area.sum(-1)),
            np.asarray(moment.sum(-1)),
            np.asarray((crossed * there).sum(-1)),
            np.asarray((crossed * there**3).sum(-1)),
        )

    def points(self, count: int) -> Array:
        """Points (sections, count, 2) even among those of the sections, matched as they are."""
        given = self.outline.shape[-2]
        wanted = np.linspace(0, given - 1, count)
        before = np.minimum(wanted.astype(int), given - 2)
        share = (wanted - before)[:, None]
        return np.asarray((1 - share) * self.outline[..., before, :] + share * self.outline[..., before + 1, :])

    def mesh_points(self, count: int) -> Array:
        """All points of the sections, whatever the count: knuckles stay.

        A place where the form only touches the centre plane, in one section or along one line, is opened by the finest
        step: four sides would meet there.
        """
        del count
        points = np.round(self.outline / _FINEST_M) * _FINEST_M
        y = points[..., 0]
        y[y <= ON_THE_CENTRE_LINE * y.max()] = 0.0
        on = y == 0
        touching = np.zeros_like(on)
        touching[1:-1, 1:-1] = on[1:-1, 1:-1] & ~on[:-2, 1:-1] & ~on[2:, 1:-1]
        touching[:, 1:-1] |= on[:, 1:-1] & ~on[:, :-2] & ~on[:, 2:]
        y[touching] = _FINEST_M
        return points

    def shell(self, thickness_m: float) -> ShellSection:
        """Of a closed shell of one thickness in m, deck included; between two contours there is none."""
        y, z = self.outline[..., 0], self.outline[..., 1]
        snap = ON_THE_CENTRE_LINE * float(y.max())
        ds = 2 * np.hypot(np.diff(y), np.diff(z))
        ds = np.where((y[..., 1:] <= snap) & (y[..., :-1] <= snap), 0.0, ds)
        zeta = self.top[..., None] - z
        start, end = zeta[..., :-1], zeta[..., 1:]
        girth = ds.sum(-1) + 2 * self.half_breadth
        first = (ds * (start + end) / 2).sum(-1)
        second = (ds * (start**2 + start * end + end**2) / 3).sum(-1)
        axis = np.divide(first, girth, out=np.zeros_like(girth), where=girth > 0)
        return ShellSection(girth, thickness_m * girth, axis, thickness_m * (second - first * axis))

    def wetted_surface(self, x: Array, heights: ArrayLike) -> float:
        """Of sections at x (sections,): sides and bottom below heights, in m2, from triangles cut at the waterline."""
        along = np.broadcast_to(x[:, None, None], (*self.outline.shape[:2], 1))
        corner = np.concatenate([along, self.outline], -1)
        a, b, c, d = corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]
        triangles = np.concatenate([np.stack([a, b, c], -2), np.stack([a, c, d], -2)]).reshape(-1, 3, 3)
        triangles = triangles[triangles[..., 1].max(-1) > ON_THE_CENTRE_LINE * float(self.outline[..., 0].max())]
        one, other = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
        area = np.linalg.norm(np.cross(one, other), axis=-1) / 2
        waterline = np.interp(triangles[..., 0], x, np.broadcast_to(heights, x.shape))
        return float(2 * area @ _share_below(np.sort(triangles[..., 2] - waterline, axis=-1), 0.0))


def parted_at_the_centre_line(section: Array) -> tuple[Array, ...]:
    """The contours of one section's polyline (k, 2): parted where it runs along the centre line.

    A section that lies on the centre line altogether is one contour.
    """
    on = section[:, 0] <= ON_THE_CENTRE_LINE * section[:, 0].max()
    webs = on[1:] & on[:-1]
    if webs.all():
        return (section,)
    pieces = np.split(np.arange(len(section)), np.flatnonzero(webs) + 1)
    return tuple(section[piece] for piece in pieces if len(piece) > 1)


def _share_below(z: Array, level: float) -> Array:
    """Share of the area of triangles with heights z (n, 3), sorted, that lies below a level."""
    low, middle, high = z.T
    foot = (level - low) ** 2 / np.where(middle > low, (high - low) * (middle - low), np.inf)
    head = 1 - (high - level) ** 2 / np.where(high > middle, (high - low) * (high - middle), np.inf)
    return np.select([level <= low, level >= high, level < middle], [0.0, 1.0, foot], head)
