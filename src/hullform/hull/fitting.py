"""A super-ellipse through the points of a traced section, with what it misses.

The distance of a point from the curve is taken from its horizontal miss h and its vertical miss v as
h v / sqrt(h^2 + v^2), the distance from the chord between the two feet: exact for a straight line, cheap, and even
along flat bottoms and vertical sides, where the implicit equation itself is not.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import least_squares

from hullform.errors import HullError
from hullform.hull.super_ellipse import SuperEllipse

Array = NDArray[np.float64]

# Below 0.3 a section is a cross of two plates, above 40 its bilge is sharper than a drawing can show (the corner lies
# within 2 % of the half-breadth of the square one): neither end is told apart by traced points.
SMALLEST_EXPONENT = 0.3
LARGEST_EXPONENT = 40.0

_SAMPLES = 96  # points, even along the arc, that the fit sees
_SEEDS = np.geomspace(0.35, 35.0, 13)  # exponents tried before the fit, so that it starts in the right valley
# Of the section's size: a point further off pulls no harder. Less of it costs area where no super-ellipse fits.
_OUTLIER = 0.004
# Where p or q is below one the curve runs into its end along an axis, and the distance across it says nothing of how
# far it goes: the ends of the trace do. Each counts as a quarter of a point, which is enough there and does not bend a
# section that no super-ellipse fits; the keel's end counts only where it is drawn.
_END_WEIGHT = 0.5
_CENTRELINE = 0.02  # of the half-breadth: a trace that begins nearer begins at the keel
_CURVE_POINTS = 97  # of the polyline that stands for the fitted curve when its misses are measured
_LENGTH_SLACK = 0.25  # by which half-breadth and depth may leave the extent of the points


@dataclass(frozen=True, slots=True)
class SectionFit:
    """A fitted section and its error.

    Attributes:
        ellipse: the super-ellipse.
        top_height_m, keel_height_m: heights of its top and keel above the base line.
        area_error: area of the ellipse less the traced area, as a share of the traced one.
        largest_deviation_m: largest distance of a traced point from the curve.
        rms_m: root mean square of the distances, even along the arc.
    """

    ellipse: SuperEllipse
    top_height_m: float
    keel_height_m: float
    area_error: float
    largest_deviation_m: float
    rms_m: float

    def points(self, count: int = 61) -> Array:
        """Points (count, 2) of [half-breadth, height] in m along the fitted curve, from keel to deck."""
        y, zeta = self.ellipse.points(count).T
        return np.stack([y, self.top_height_m - zeta], axis=-1)


def _generalised_power(base: Array, exponent: float) -> Array:
    """sign(x) |x|^e: continues the curve beyond its ends, so that a point out there still has a distance."""
    return np.asarray(np.sign(base) * np.abs(base) ** exponent)


def _distances(y: Array, zeta: Array, a: float, b: float, p: float, q: float) -> Array:
    """Signed distance of points from the curve, positive outside."""
    across = y - a * _generalised_power(1 - _generalised_power(zeta / b, q), 1 / p)
    down = zeta - b * _generalised_power(1 - (y / a) ** p, 1 / q)
    reach = np.hypot(across, down)
    return np.asarray(np.abs(across) * down / np.where(reach > 0, reach, 1.0))


def _misses(points: Array, ellipse: SuperEllipse) -> Array:
    """Distance in m of points [half-breadth, zeta] from the curve.

    The lesser of the distance above, which is true for small misses and too large outside a sharp bilge, and that from
    a polyline along the curve, which is true for large misses.
    """
    curve = ellipse.points(_CURVE_POINTS)
    step = np.diff(curve, axis=0)
    offset = points[:, None, :] - curve[:-1]
    along = np.clip((offset * step).sum(-1) / (step**2).sum(-1), 0.0, 1.0)
    from_polyline = np.linalg.norm(offset - along[..., None] * step, axis=-1).min(axis=1)
    y, zeta = points.T
    from_feet = np.abs(_distances(y, zeta, ellipse.half_breadth, ellipse.depth, ellipse.p, ellipse.q))
    return np.asarray(np.minimum(from_polyline, from_feet))


def _resampled(points: Array) -> Array:
    """Points even along the polyline through the given ones."""
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    wanted = np.linspace(0.0, arc[-1], _SAMPLES)
    return np.stack([np.interp(wanted, arc, points[:, 0]), np.interp(wanted, arc, points[:, 1])], axis=-1)


def traced_area(points: ArrayLike) -> float:
    """Return the area in m2, both sides, between a traced curve (n, 2) [half-breadth, height] and the level of its top.

    The curve is closed along the level of its last point and, where it does not begin at the centreline, along that of
    its first one.
    """
    y, z = np.asarray(points, dtype=np.float64).T
    return float(np.sum((y[1:] + y[:-1]) * np.diff(z)))


def _seed(y: Array, zeta: Array, a: float, b: float) -> tuple[float, float]:
    """Exponents with the least mean distance on a coarse logarithmic grid."""
    p, q = (grid[..., None] for grid in np.meshgrid(_SEEDS, _SEEDS, indexing="ij"))
    u, v = np.clip(y / a, 0.0, 1.0), np.clip(zeta / b, 0.0, 1.0)
    across = a * np.abs(u - (1 - v**q) ** (1 / p))
    down = b * np.abs(v - (1 - u**p) ** (1 / q))
    reach = np.hypot(across, down)
    cost = np.mean(across * down / np.where(reach > 0, reach, 1.0), axis=-1)
    i, j = np.unravel_index(np.argmin(cost), cost.shape)
    return float(_SEEDS[i]), float(_SEEDS[j])


def fit_super_ellipse(points: ArrayLike) -> SectionFit:
    """Fit a section (y/a)^p + (zeta/b)^q = 1 to a traced one by robust least squares on distance.

    points: (n, 2) [half-breadth, height] in m from keel to deck, n >= 4, in any spacing and not necessarily beginning
    at the centreline. The top is the height of the last point; a, b, p, q are fitted, a and b drawn to the
    trace's ends, the exponents within
    SMALLEST_EXPONENT..LARGEST_EXPONENT. The loss is soft_l1 at 0.4 % of the section's size, so that a stray label
    or waterline crossing does not bend the curve.

    Raises HullError for too few points, a point that is not finite, or a section without height or breadth.
    """
    traced = np.array(points, dtype=np.float64)
    if traced.ndim != 2 or traced.shape[1] != 2 or len(traced) < 4 or not np.isfinite(traced).all():
        raise HullError(
            f"a section needs four or more finite points [half-breadth, height]; got an array {traced.shape}"
        )
    top = float(traced[-1, 1])
    breadth, height = float(traced[:, 0].max()), top - float(traced[:, 1].min())
    if breadth <= 0 or height <= 0:
        raise HullError(
            f"the section from {traced[0]} to {traced[-1]} m has breadth {breadth:g} m and height {height:g} m below "
            "its last point; give its points from keel to deck, half-breadths positive"
        )
    area = traced_area(traced)
    if area <= 0:
        raise HullError(
            f"the section from {traced[0]} to {traced[-1]} m encloses {area:g} m2; give its points from keel to deck"
        )
    sample = _resampled(traced)
    y, zeta = np.maximum(sample[:, 0], 0.0), top - sample[:, 1]
    a0, b0 = breadth, height
    p0, q0 = _seed(y, zeta, a0, b0)
    at_centreline = float(y[0] <= _CENTRELINE * breadth)

    def residuals(unknown: Array) -> Array:
        p, q = np.exp(unknown[2:])
        a, b = a0 * unknown[0], b0 * unknown[1]
        ends = _END_WEIGHT * np.array([a - y[-1], (b - zeta[0]) * at_centreline])
        return np.concatenate([_distances(y, zeta, a, b, p, q), ends])

    low, high = np.log(SMALLEST_EXPONENT), np.log(LARGEST_EXPONENT)
    found = least_squares(
        residuals,
        [1.0, 1.0, np.log(p0), np.log(q0)],
        bounds=(
            [1 - _LENGTH_SLACK, 1 - _LENGTH_SLACK, low, low],
            [1 + _LENGTH_SLACK, 1 + _LENGTH_SLACK, high, high],
        ),
        loss="soft_l1",
        f_scale=_OUTLIER * np.hypot(a0, b0),
        xtol=1e-9,
        ftol=1e-9,
        gtol=1e-10,
        max_nfev=60,
    )
    p, q = (float(v) for v in np.exp(found.x[2:]))
    ellipse = SuperEllipse(a0 * float(found.x[0]), b0 * float(found.x[1]), p, q)
    at_points = np.stack([np.maximum(traced[:, 0], 0.0), top - traced[:, 1]], axis=-1)
    return SectionFit(
        ellipse=ellipse,
        top_height_m=top,
        keel_height_m=top - ellipse.depth,
        area_error=ellipse.area / area - 1,
        largest_deviation_m=float(_misses(at_points, ellipse).max()),
        rms_m=float(np.sqrt(np.mean(_misses(np.stack([y, zeta], axis=-1), ellipse) ** 2))),
    )
