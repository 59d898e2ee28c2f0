"""Thin-walled sections: networks of plates with open parts and any number of cells, in bending, shear and torsion.

A network is a set of branches, polylines of straight plates that meet at joints. Under a vertical force V the shear
flow q = V f / I grows along a plate as df/ds = t z, z from the neutral axis, and warps the section by w with
f / t = dw/ds. As w has one value at a joint, the flows of all cells are compatible; that the flows balance at every
joint is one linear equation a joint. Torsion is the same network with f = t (dw/ds + h), h the distance of the plate's
line from the pole. Neither needs to know which cells there are.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Joints = NDArray[np.int64]

# Q^2 is of the fourth degree along a straight plate: three points integrate it exactly.
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(3)
_PLACES, _SHARES = (1 + _NODES) / 2, _WEIGHTS / 2

# Only differences of the warping matter; this share of the stiffest joint ties every joint to the ground, so that the
# equations have one answer. The flows err by as much.
_GROUND = 1e-13
# A joint nearer to the centre plane than this share of the greatest half-breadth lies in it.
_ON_CENTRE = 1e-9


@dataclass(frozen=True, eq=False)
class Network:
    """Plates along branches, in arrays (..., branches, points); leading dimensions are sections side by side.

    Attributes:
        y_m, z_m: (..., branches, points) corners of each branch; a branch with fewer repeats its last one.
        thickness_m: (..., branches, points - 1) of the plates, which shear and torsion flow through.
        bending_thickness_m: the same with what else bends: stiffeners spread over their plate.
        joints: (..., branches, 2) numbers, from 0, of the joints at a branch's start and end.
        mirrored: whether this is the half on one side of the centre plane y = 0, the other being alike. Plates in the
            plane itself then have half their thickness.
    """

    y_m: Array
    z_m: Array
    thickness_m: Array
    bending_thickness_m: Array
    joints: Joints
    mirrored: bool = True


class SectionProperties(NamedTuple):
    """Of whole sections, both sides, arrays (...).

    area_m2, centroid_y_m, neutral_axis_m (height of the centroid), second_moment_m4 (about the horizontal axis through
    it), horizontal_second_moment_m4 (about the vertical one), shear_area_m2 (vertical, energy-equivalent, k A),
    torsion_constant_m4 (Saint-Venant's, open parts included).
    """

    area_m2: Array
    centroid_y_m: Array
    neutral_axis_m: Array
    second_moment_m4: Array
    horizontal_second_moment_m4: Array
    shear_area_m2: Array
    torsion_constant_m4: Array


def closed_shell(half_breadth_m: Array, height_m: Array, thickness_m: float) -> Network:
    """Shells of one thickness and one cell: half of each, from the centre line at the deck round to the keel.

    Args:
        half_breadth_m, height_m: (..., points) one side's contour, straight plates between the points.
        thickness_m: of all plates.
    """
    thickness = np.full((*half_breadth_m.shape[:-1], 1, half_breadth_m.shape[-1] - 1), thickness_m)
    joints = np.broadcast_to(np.array([[0, 1]]), (*half_breadth_m.shape[:-1], 1, 2))
    return Network(half_breadth_m[..., None, :], height_m[..., None, :], thickness, thickness, joints)


def section_properties(network: Network) -> SectionProperties:
    """Area, centroid, second moments, vertical shear area and torsion constant of thin-walled sections.

    With z from the neutral axis (and, where port and starboard differ, less I_yz / I_zz times y) and f the shear flow
    for V = I, the shear area is A_s = I^2 / Sum Int f^2 / t ds, the area that stores as much energy. The torsion
    constant is Sum Int f h ds of the flow for a unit twist, which is Bredt's for any number of cells, plus
    Sum L t^3 / 3. A section that shrinks to nothing has zeros throughout.

    Source: Megson, Introduction to Aircraft Structural Analysis, chapters on shear and torsion of closed sections
    (multi-cell); formula of the shear area: Cowper, J. Appl. Mech. 33 (1966), with Poisson's ratio 0.
    """
    y, z = network.y_m, network.z_m
    plate_y, plate_z = np.diff(y), np.diff(z)
    length = np.hypot(plate_y, plate_z)
    sides = 2.0 if network.mirrored else 1.0
    weight = network.bending_thickness_m * length
    area = weight.sum((-1, -2))
    centre_z = _over(_moment(weight, z), area)
    centre_y = np.zeros_like(area) if network.mirrored else _over(_moment(weight, y), area)
    y, z = y - centre_y[..., None, None], z - centre_z[..., None, None]
    vertical, horizontal = _product(weight, z, z), _product(weight, y, y)
    skew = np.zeros_like(area) if network.mirrored else _over(_product(weight, y, z), horizontal)
    bending = z - skew[..., None, None] * y
    effective = _product(weight, bending, bending)
    energy = _shear_energy(network, length, bending)
    return SectionProperties(
        area_m2=sides * area,
        centroid_y_m=centre_y,
        neutral_axis_m=centre_z,
        second_moment_m4=sides * vertical,
        horizontal_second_moment_m4=sides * horizontal,
        shear_area_m2=sides * _over(effective**2, energy),
        torsion_constant_m4=sides * (_torsion(network, length) + (length * network.thickness_m**3).sum((-1, -2)) / 3),
    )


def _over(numerator: Array, denominator: Array) -> Array:
    """The quotient, 0 where nothing divides."""
    return np.divide(numerator, denominator, out=np.zeros_like(numerator), where=denominator > 0)


def _moment(weight: Array, at: Array) -> Array:
    return np.asarray((weight * (at[..., :-1] + at[..., 1:]) / 2).sum((-1, -2)))


def _product(weight: Array, one: Array, other: Array) -> Array:
    """Int one other t ds over all plates, both linear along each."""
    a, b, c, d = one[..., :-1], one[..., 1:], other[..., :-1], other[..., 1:]
    return np.asarray((weight * (2 * a * c + a * d + b * c + 2 * b * d) / 6).sum((-1, -2)))


def _shear_energy(network: Network, length: Array, ordinate: Array) -> Array:
    """Sum Int f^2 / t ds of the flow with df/ds = t ordinate, balanced at the joints and compatible."""
    thickness, bending = network.thickness_m, network.bending_thickness_m
    start, rise = ordinate[..., :-1], np.diff(ordinate)
    gain = bending * length * (start + rise / 2)
    before = np.concatenate([np.zeros_like(gain[..., :1]), np.cumsum(gain, -1)[..., :-1]], -1)
    growth = (bending * length)[..., None] * (start[..., None] * _PLACES + rise[..., None] * _PLACES**2 / 2)
    flow = before[..., None] + growth
    flexibility = _over(length, thickness)
    warping = (flexibility * (flow @ _SHARES)).sum(-1)
    at_start = _balanced(network, flexibility.sum(-1), -warping, gain.sum(-1), grounded=None)
    return np.asarray((flexibility * ((flow + at_start[..., None, None]) ** 2 @ _SHARES)).sum((-1, -2)))


def _torsion(network: Network, length: Array) -> Array:
    """Sum Int f h ds of the flow f = t (dw/ds + h) for a unit twist."""
    y, z = network.y_m, network.z_m
    swept = (y[..., :-1] * z[..., 1:] - y[..., 1:] * z[..., :-1]).sum(-1)
    flexibility = _over(length, network.thickness_m).sum(-1)
    # Twisted, port warps against starboard: the centre plane of a ship that is alike on both sides does not warp.
    grounded = np.abs(y[..., [0, -1]]) <= _ON_CENTRE * np.abs(y).max((-1, -2), keepdims=True, initial=0.0)
    flow = _balanced(network, flexibility, swept, np.zeros_like(swept), grounded if network.mirrored else None)
    return np.asarray((flow * swept).sum(-1))


def _balanced(
    network: Network, flexibility: Array, source: Array, gain: Array, grounded: NDArray[np.bool_] | None
) -> Array:
    """The flow at each branch's start, (w_end - w_start + source) / flexibility, with w from the balance at the joints.

    Args:
        network: its joints.
        flexibility: (..., branches) Sum L / t.
        source: (..., branches) what drives a flow along the branch.
        gain: (..., branches) by how much the flow at a branch's end is more than that at its start.
        grounded: (..., branches, 2) which ends lie at joints that do not warp.
    """
    leading, branches = flexibility.shape[:-1], flexibility.shape[-1]
    joints = np.broadcast_to(network.joints, (*leading, branches, 2)).reshape(-1, branches, 2)
    start, end = joints[..., 0], joints[..., 1]
    conductance = _over(np.ones_like(flexibility), flexibility).reshape(-1, branches)
    count = int(joints.max(initial=0)) + 1
    section = np.arange(len(joints))[:, None]
    matrix, load = np.zeros((len(joints), count, count)), np.zeros((len(joints), count))
    driven = conductance * source.reshape(-1, branches)
    np.add.at(matrix, (section, start, start), conductance)
    np.add.at(matrix, (section, end, end), conductance)
    np.add.at(matrix, (section, start, end), -conductance)
    np.add.at(matrix, (section, end, start), -conductance)
    np.add.at(load, (section, start), driven)
    np.add.at(load, (section, end), -driven - gain.reshape(-1, branches))
    stiffest = np.max(conductance, axis=-1, initial=0.0)
    ground = np.where(stiffest > 0, _GROUND * stiffest, 1.0)[:, None] * np.ones(count)
    if grounded is not None:
        # A support stiff enough to hold the joint to round-off.
        held = np.zeros((len(joints), count), dtype=bool)
        np.logical_or.at(held, (section[..., None], joints), grounded.reshape(-1, branches, 2))
        ground = np.where(held, np.maximum(stiffest, 1.0)[:, None] / _GROUND, ground)
    matrix[:, np.arange(count), np.arange(count)] += ground
    warping = np.linalg.solve(matrix, load[..., None])[..., 0]
    along = np.take_along_axis(warping, end, -1) - np.take_along_axis(warping, start, -1)
    return np.asarray((conductance * along + driven).reshape(*leading, branches))
