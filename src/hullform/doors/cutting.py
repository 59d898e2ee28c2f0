"""A surface of triangles cut by a plane across the ship: polylines that hang together by edges, not by distances.

A triangle that the plane passes has exactly two edges with one end abaft of the plane and one not; a vertex in the
plane counts as not abaft, so that no triangle is cut at a corner. Every such edge is cut once, and the two triangles
that share it share the point: chains are followed by the numbers of edges, and no tolerance decides what hangs
together. A closed surface gives closed chains, whatever the winding of its triangles.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.doors.surface import Surface

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Chain:
    """A polyline in a plane across the ship.

    Attributes:
        points: (n, 2) y and z in m; of a closed one the first is not repeated.
        closed: whether its last point is joined to its first.
    """

    points: Array
    closed: bool


def cut(surface: Surface, x_m: float) -> list[Chain]:
    """The chains in the plane at x, those with free ends first."""
    vertices = surface.vertices
    least, greatest = surface.spans_m
    passed = surface.faces[(least < x_m) & (greatest >= x_m)]
    if not len(passed):
        return []
    ends = np.stack([passed, np.roll(passed, -1, axis=1)], axis=-1)
    abaft = vertices[ends, 0] < x_m
    crossing = abaft[..., 0] != abaft[..., 1]
    edges, number = np.unique(np.sort(ends[crossing], axis=-1), axis=0, return_inverse=True)
    segments = np.unique(np.sort(number.reshape(-1, 2), axis=1), axis=0)
    start, end = vertices[edges[:, 0]], vertices[edges[:, 1]]
    share = (x_m - start[:, 0]) / (end[:, 0] - start[:, 0])
    points = (start + share[:, None] * (end - start))[:, 1:]
    return [Chain(points[list(nodes)], closed) for nodes, closed in _followed(segments, len(edges))]


def _followed(segments: NDArray[np.int64], count: int) -> list[tuple[list[int], bool]]:
    """Walk along segments (m, 2) of points 0..count; where more than two meet each walk takes one that is left."""
    beside: list[list[int]] = [[] for _ in range(count)]
    for index, (one, other) in enumerate(segments.tolist()):
        beside[one].append(index)
        beside[other].append(index)
    left = np.ones(len(segments), dtype=bool)

    def walk(start: int) -> list[int]:
        nodes = [start]
        while True:
            ways = [index for index in beside[nodes[-1]] if left[index]]
            if not ways:
                return nodes
            left[ways[0]] = False
            one, other = segments[ways[0]]
            nodes.append(int(other if one == nodes[-1] else one))

    free = [node for node in range(count) if len(beside[node]) % 2]
    found = [(walk(node), False) for node in free if any(left[index] for index in beside[node])]
    for index in range(len(segments)):
        if left[index]:
            found.append((walk(int(segments[index, 0]))[:-1], True))
    return found
