"""The super-ellipse of a hull section, (y/a)^p + (zeta/b)^q = 1, in closed forms and, for its shell, by quadrature.

a is the half-breadth at the section's top, b its depth, zeta is measured down from the top. q > 1 makes the side
vertical at the top, q = 1 a straight flare, q < 1 a hollow one; p > 1 makes the bottom flat at the keel, p = 1 a V,
p < 1 a hollow run. The functions are kernels for arrays of sections; `SuperEllipse` is one section.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import betaincc, betaln, gammaln

from hullform.errors import HullError
from hullform.hull.arcs import arc_integrals, curve_points

Array = NDArray[np.float64]

_WALL_SIDED = 1e-30  # of w = (zeta/b)^q: the side above leaves the vertical by less than round-off


def quadrant_moment(half_breadth: ArrayLike, depth: ArrayLike, p: ArrayLike, q: ArrayLike, m: int, n: int) -> Array:
    """Integrate y^m zeta^n over one quadrant of each section, in m^(m+n+2).

    a^(m+1) b^(n+1) / (p q) G((m+1)/p) G((n+1)/q) / G((m+1)/p + (n+1)/q + 1), with G the Gamma function (Dirichlet's
    integral: Whittaker & Watson, Modern Analysis, 12.5). Arguments broadcast; half_breadth a, depth b in m.
    """
    a, b, p_, q_ = (np.asarray(v, dtype=np.float64) for v in (half_breadth, depth, p, q))
    s, t = (m + 1) / p_, (n + 1) / q_
    log_ratio = gammaln(s) + gammaln(t) - gammaln(s + t + 1)
    return np.asarray(a ** (m + 1) * b ** (n + 1) / (p_ * q_) * np.exp(log_ratio))


def _ratio_to_depth(depth: ArrayLike, level: ArrayLike) -> Array:
    b, zeta = np.broadcast_arrays(np.asarray(depth, dtype=np.float64), np.asarray(level, dtype=np.float64))
    # A section without depth lies below no level but its own top.
    return np.asarray(np.clip(np.divide(zeta, b, out=np.ones(b.shape), where=b > 0), 0.0, 1.0))


def half_breadth_at(half_breadth: ArrayLike, depth: ArrayLike, p: ArrayLike, q: ArrayLike, level: ArrayLike) -> Array:
    """Return y = a (1 - (zeta/b)^q)^(1/p) in m at `level` zeta (m below the top, clipped to 0..depth)."""
    v = _ratio_to_depth(depth, level)
    return np.asarray(np.asarray(half_breadth) * (1 - v ** np.asarray(q)) ** (1 / np.asarray(p, dtype=np.float64)))


def moment_below(
    half_breadth: ArrayLike, depth: ArrayLike, p: ArrayLike, q: ArrayLike, level: ArrayLike, n: int = 0
) -> Array:
    """Integrate zeta^n over the part of each section below a level, both sides together, in m^(n+2).

    2 a b^(n+1) / q B((n+1)/q, 1/p + 1) (1 - I_w((n+1)/q, 1/p + 1)), w = (zeta0/b)^q, with B the Beta function and I
    the regularised incomplete one. level zeta0 in m below the top, clipped to 0..depth; n = 0 is the area.
    """
    a, b, p_, q_ = (np.asarray(v, dtype=np.float64) for v in (half_breadth, depth, p, q))
    v = _ratio_to_depth(b, level)
    w = v**q_
    s, t = (n + 1) / q_, 1 / p_ + 1
    whole = 2 * a * b ** (n + 1) / q_ * np.exp(betaln(s, t))
    # Where w underflows, for a level just below the top of a wall-sided section, the part above it is a rectangle.
    rectangle = 2 * a * (v * b) ** (n + 1) / (n + 1)
    return np.asarray(np.where(w < _WALL_SIDED, whole - rectangle, whole * betaincc(s, t, w)))


class ShellSection(NamedTuple):
    """A thin closed or open shell: girth (m), area (m2), neutral axis below the top (m), second moment (m4)."""

    girth: Array
    area: Array
    neutral_axis_below_top: Array
    second_moment: Array


def shell_section(
    half_breadth: ArrayLike,
    depth: ArrayLike,
    p: ArrayLike,
    q: ArrayLike,
    thickness: ArrayLike,
    *,
    deck: bool = True,
) -> ShellSection:
    """Return girth, area, neutral axis and second moment about it of a shell of even thickness t along the curve.

    L = 2 S + 2 a, S1 = 2 Int zeta ds, S2 = 2 Int zeta^2 ds, I = t (S2 - S1^2 / L): the wall counts along its mid-line,
    a deck plate of breadth 2 a at zeta = 0 is included with `deck`. Arguments broadcast; lengths in m.
    """
    t = np.asarray(thickness, dtype=np.float64)
    quadrant = arc_integrals(half_breadth, depth, p, q)
    girth = 2 * quadrant.girth + (2 * np.asarray(half_breadth, dtype=np.float64) if deck else 0.0)
    first = 2 * quadrant.first_moment
    axis = np.divide(first, girth, out=np.zeros_like(girth), where=girth > 0)
    return ShellSection(girth, t * girth, axis, np.asarray(t * (2 * quadrant.second_moment - first * axis)))


@dataclass(frozen=True, slots=True)
class SuperEllipse:
    """One hull section of both sides: half_breadth a and depth b in m, exponents p (breadth) and q (depth).

    Areas and moments are of the full section, port and starboard; a quadrant has half of each. Moments about the top
    use zeta, down from the top. Raises HullError where a length is negative or an exponent not positive.
    """

    half_breadth: float
    depth: float
    p: float
    q: float

    def __post_init__(self) -> None:
        for name in ("half_breadth", "depth", "p", "q"):
            value = getattr(self, name)
            if not np.isfinite(value) or value < 0 or (name in "pq" and value == 0):
                bound = "positive" if name in "pq" else "zero or more"
                raise HullError(f"SuperEllipse: {name} = {value} is not possible; give a finite number, {bound}.")

    def _all(self) -> tuple[float, float, float, float]:
        return self.half_breadth, self.depth, self.p, self.q

    @property
    def area(self) -> float:
        """Area in m2."""
        return float(2 * quadrant_moment(*self._all(), 0, 0))

    @property
    def centroid_below_top(self) -> float:
        """Depth of the area's centroid below the top, in m."""
        return float(quadrant_moment(*self._all(), 0, 1) / quadrant_moment(*self._all(), 0, 0))

    @property
    def centroid_from_centreline(self) -> float:
        """Distance of one side's centroid from the centreline, in m."""
        return float(quadrant_moment(*self._all(), 1, 0) / quadrant_moment(*self._all(), 0, 0))

    @property
    def second_moment_about_top(self) -> float:
        """Int zeta^2 dA in m4."""
        return float(2 * quadrant_moment(*self._all(), 0, 2))

    @property
    def second_moment_horizontal(self) -> float:
        """Second moment of area about the horizontal axis through the centroid, in m4."""
        return self.second_moment_about_top - self.area * self.centroid_below_top**2

    @property
    def second_moment_vertical(self) -> float:
        """Second moment of area about the centreline, in m4."""
        return float(2 * quadrant_moment(*self._all(), 2, 0))

    def half_breadth_at(self, level: ArrayLike) -> Array:
        """Half-breadth in m at levels in m below the top."""
        return half_breadth_at(*self._all(), level)

    def area_below(self, level: float) -> float:
        """Area in m2 of the part below a level given in m below the top."""
        return float(moment_below(*self._all(), level))

    def first_moment_below(self, level: float) -> float:
        """Int zeta dA in m3 over the part below a level given in m below the top."""
        return float(moment_below(*self._all(), level, 1))

    def girth(self, *, deck: bool = False) -> float:
        """Length of the curve of both sides in m, with the deck's breadth on request."""
        return float(2 * arc_integrals(*self._all()).girth + (2 * self.half_breadth if deck else 0.0))

    def shell(self, thickness: float, *, deck: bool = True) -> ShellSection:
        """Girth, area, neutral axis and second moment of a shell of this thickness in m along the curve."""
        return shell_section(*self._all(), thickness, deck=deck)

    def shell_second_moment(self, thickness: float, *, deck: bool = True) -> float:
        """Second moment in m4 of a shell of this thickness in m about its neutral axis."""
        return float(self.shell(thickness, deck=deck).second_moment)

    def points(self, count: int = 61) -> Array:
        """Points (count, 2) of [half-breadth, zeta] from the keel to the top, spread by arc and turning."""
        y, zeta = curve_points(*self._all(), count)
        return np.stack([y[0], zeta[0]], axis=-1)
