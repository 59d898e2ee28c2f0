"""Integrals of 1/r and of its normal derivative over flat panels, with the panels' mirror images.

At the free surface, the high-frequency limit asks for phi = 0: the image in z = 0 counts negative. The centre plane's
image counts positive. A bottom at the depth h, on which d phi/dn = 0, and the surface repeat the whole at 2 k h with
the signs (-1)^k; the last pair of the alternating series counts half. Near panels are integrated exactly (J. L. Hess
and A. M. O. Smith, Progress in Aeronautical Sciences 8 (1967) 1-138; J. N. Newman, J. Eng. Math. 20 (1986) 113-126),
those at a middle distance by four Gauss points, far ones as points.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hullvib.wet.panels import Geometry, Panels

Array = NDArray[np.float64]
Index = NDArray[np.intp]

NEAR = 2.0  # diameters of a panel within which its integrals are exact
MIDDLE = 6.0  # and beyond which it is a point
BOTTOM_IMAGES = 12  # pairs of images in bottom and surface
_BLOCK = 400_000  # pairs of panels that are looked at together


class _Image(NamedTuple):
    """Where a mirror image of the panels lies: signs of y and z, a shift upwards, and the weight of its flow."""

    signs: Array
    shift: float
    weight: float

    @property
    def is_hull(self) -> bool:
        return bool((self.signs > 0.0).all()) and self.shift == 0.0


def influence(panels: Panels, depth_m: float = np.inf) -> tuple[Array, Array]:
    """Integrals over panel q as seen from the centre of panel p, summed over all images, each (m, m) [p, q].

    The first of 1/r, the second of d(1/r)/dn_q; the panel's own part of the second is 0.
    """
    g = panels.geometry
    points, weights = _gauss_points(g)
    count = len(panels)
    source, dipole = np.zeros((count, count)), np.zeros((count, count))
    rows = max(1, _BLOCK // count)
    for image in _images(depth_m):
        moved = _Mirrored(g, points, weights, image)
        for first in range(0, count, rows):
            block = slice(first, min(first + rows, count))
            _add(source[block], dipole[block], g.centres[block], moved, first)
    return source, dipole


class _Mirrored:
    """The panels' geometry in one image."""

    def __init__(self, g: Geometry, points: Array, weights: Array, image: _Image) -> None:
        shift = np.array([0.0, 0.0, image.shift])
        self.image = image
        self.corners = g.corners * image.signs + shift
        if float(np.prod(image.signs)) < 0.0:
            self.corners = self.corners[:, ::-1]
        self.centres = g.centres * image.signs + shift
        self.normals = g.normals * image.signs
        self.areas, self.diameters = g.areas, g.diameters
        self.points, self.weights = points * image.signs + shift, weights


def _images(depth_m: float) -> list[_Image]:
    shifts = [(0.0, 1.0)]
    if np.isfinite(depth_m):
        for k in range(1, BOTTOM_IMAGES + 1):
            weight = (-1.0) ** k * (0.5 if k == BOTTOM_IMAGES else 1.0)
            shifts += [(2.0 * k * depth_m, weight), (-2.0 * k * depth_m, weight)]
    mirrors = [((1.0, y, z), z) for z in (1.0, -1.0) for y in (1.0, -1.0)]
    return [_Image(np.array(signs), shift, weight * sign) for shift, weight in shifts for signs, sign in mirrors]


def _add(source: Array, dipole: Array, at: Array, moved: _Mirrored, first: int) -> None:
    """Adds one image's part to rows of both matrices."""
    middle = moved.centres.mean(axis=0)
    own, other = at - middle, moved.centres - middle
    squares = (own**2).sum(axis=1)[:, None] + (other**2).sum(axis=1) - 2.0 * own @ other.T
    across = own @ moved.normals.T - (other * moved.normals).sum(axis=1)
    limit = moved.diameters**2
    near = squares < NEAR**2 * limit
    if moved.image.is_hull:
        near[np.arange(len(at)), first + np.arange(len(at))] = True
    close = squares < MIDDLE**2 * limit
    close ^= near
    squares[near] = 1.0
    inverse = 1.0 / squares
    single = np.sqrt(inverse)
    single *= moved.areas
    double = across
    double *= single
    double *= inverse
    p, q = np.nonzero(close)
    single[p, q], double[p, q] = _by_points(at[p], moved, q)
    p, q = np.nonzero(near)
    single[p, q], double[p, q] = panel_integrals(moved.corners[q], moved.normals[q], moved.centres[q], at[p])
    if moved.image.is_hull:
        double[np.arange(len(at)), first + np.arange(len(at))] = 0.0
    single *= moved.image.weight
    double *= moved.image.weight
    source += single
    dipole += double


def _by_points(at: Array, moved: _Mirrored, q: Index) -> tuple[Array, Array]:
    normals = moved.normals[q]
    single, double = np.zeros(len(q)), np.zeros(len(q))
    for points, weights in zip(moved.points, moved.weights, strict=True):
        r = at - points[q]
        inverse = 1.0 / np.einsum("ij,ij->i", r, r)
        part = weights[q] * np.sqrt(inverse)
        single += part
        part *= inverse
        part *= np.einsum("ij,ij->i", r, normals)
        double += part
    return single, double


def _gauss_points(g: Geometry) -> tuple[Array, Array]:
    """Four points of every panel, (4, m, 3), and their weights, (4, m), which add up to its area."""
    at = 1.0 / np.sqrt(3.0)
    points, weights = [], []
    for a in (-at, at):
        for b in (-at, at):
            shape = np.array([(1 - a) * (1 - b), (1 + a) * (1 - b), (1 + a) * (1 + b), (1 - a) * (1 + b)]) / 4
            by_a = np.array([b - 1, 1 - b, 1 + b, -1 - b]) / 4
            by_b = np.array([a - 1, -1 - a, 1 + a, 1 - a]) / 4
            points.append(np.einsum("k,ikj->ij", shape, g.corners))
            tangents = np.einsum("k,ikj->ij", by_a, g.corners), np.einsum("k,ikj->ij", by_b, g.corners)
            weights.append(np.linalg.norm(np.cross(*tangents), axis=1))
    total = np.array(weights)
    return np.array(points), total * (g.areas / total.sum(axis=0))


def panel_integrals(corners: Array, normals: Array, centres: Array, at: Array) -> tuple[Array, Array]:
    """Exact integrals of 1/r and d(1/r)/dn over flat panels, one point each: (k, 4, 3), (k, 3) .. -> (k,), (k,).

    A panel that is not flat is projected on the plane through its centre. The second is 0 in a panel's own plane.
    """
    first = corners[:, 2] - corners[:, 0]
    first = first - np.einsum("ij,ij->i", first, normals)[:, None] * normals
    first /= np.linalg.norm(first, axis=1)[:, None]
    second = np.cross(normals, first)
    edges = corners - centres[:, None]
    u, v = np.einsum("ikj,ij->ik", edges, first), np.einsum("ikj,ij->ik", edges, second)
    r = at - centres
    x, y, z = (np.einsum("ij,ij->i", r, axis) for axis in (first, second, normals))
    height = np.abs(z)
    dx, dy = np.roll(u, -1, axis=1) - u, np.roll(v, -1, axis=1) - v
    length = np.hypot(dx, dy)
    real = length > 1e-12 * length.max(axis=1, keepdims=True)
    length = np.where(real, length, 1.0)
    from_x, from_y = u - x[:, None], v - y[:, None]
    # distances from the corners, and the foot of the point on the edge's line: along and beside it
    distance = np.sqrt(from_x**2 + from_y**2 + (z**2)[:, None])
    following = np.roll(distance, -1, axis=1)
    beside = (from_x * dy - from_y * dx) / length
    along = (from_x * dx + from_y * dy) / length
    beyond = along + length
    sums = distance + following
    logarithm = np.log((sums + length) / np.maximum(sums - length, 1e-300))
    span = beside**2 + (z**2)[:, None]
    angle = np.arctan2(beside * beyond, span + height[:, None] * following)
    angle -= np.arctan2(beside * along, span + height[:, None] * distance)
    solid = np.where(real, angle, 0.0).sum(axis=1)
    single = np.where(real, beside * logarithm, 0.0).sum(axis=1) - height * solid
    return single, np.sign(z) * solid
