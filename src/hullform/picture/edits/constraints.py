"""Corrections as constraints of the flow: which links are forbidden, made or free, which lines may be shared.

Lines are edited first; what the flow must heed is then said by the places where tracklets begin and end.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

from hullform.corrections import Crossing, Cut, Deleted, Joined, RunTogether
from hullform.picture.edits.line_edits import (
    Place,
    Straight,
    crossed,
    cut,
    end_of,
    joined,
    start_of,
    under,
    without_run,
)
from hullform.picture.edits.placing import REACH, Placed
from hullform.picture.pieces.ridges import Tracklet

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

ORDER = (Deleted, Cut, Crossing, Joined, RunTogether)  # the later ones refer to what the earlier ones leave
CLEARANCE_PX = 2.5  # no link passes nearer to a cut
COST_AT_CUT = 25.0  # of a curve that begins or ends where a person cut a line, px of ink
LONGEST_GAP = 0.09  # of B/2: over which a curve may be led that a person cuts


@dataclass(frozen=True, eq=False)
class Links:
    """Which tracklet may follow which, at what cost, and how many curves at least must go that way."""

    source: Indices
    target: Indices
    cost: Array
    least: Indices

    def with_others(self, source: Indices, target: Indices, cost: Array) -> Links:
        """These links, then others that no curve must go."""
        return Links(
            np.append(self.source, source),
            np.append(self.target, target),
            np.append(self.cost, cost),
            np.append(self.least, np.zeros(len(source), dtype=np.int64)),
        )


@dataclass(frozen=True)
class Constraints:
    """What the flow heeds besides its costs.

    Attributes:
        cuts: where no link may pass.
        loose: places at cuts where a curve may well begin or end.
        joins: end of one tracklet and start of another, between which a curve must go.
        crossings: where arms go straight on.
        together: between which places lines may be shared freely.
    """

    cuts: tuple[Place, ...] = ()
    loose: tuple[Place, ...] = ()
    joins: tuple[tuple[Place, Place], ...] = ()
    crossings: tuple[Straight, ...] = ()
    together: tuple[tuple[Place, Place], ...] = ()

    @property
    def made(self) -> frozenset[tuple[Place, Place]]:
        """The links that a person made, each from the end of one tracklet to the start of the next."""
        return frozenset((*self.joins, *(pair for crossing in self.crossings for pair in crossing.pairs)))

    def of_links(self, tracklets: Sequence[Tracklet], source: Indices, target: Indices, cost: Array) -> Links:
        """The links that are left, with those that were made."""
        ends, starts = [end_of(t) for t in tracklets], [start_of(t) for t in tracklets]
        good = self.passable(np.array(ends)[source], np.array(starts)[target])
        ending, starting = ({place: number for number, place in enumerate(places)} for places in (ends, starts))
        made: dict[tuple[int, int], int] = {}
        for crossing in self.crossings:
            inward = [ending[place] for place in crossing.inward if place in ending]
            outward = [starting[place] for place in crossing.outward if place in starting]
            good &= ~(np.isin(source, inward) & np.isin(target, outward))
            made |= {(ending[a], starting[b]): 0 for a, b in crossing.pairs if a in ending and b in starting}
        made |= {(ending[a], starting[b]): 1 for a, b in self.joins if a in ending and b in starting}
        for a, b in made:
            good &= ~((source == a) & (target == b))
        pairs = np.array(list(made), dtype=np.int64).reshape(-1, 2)
        return Links(
            np.append(source[good], pairs[:, 0]),
            np.append(target[good], pairs[:, 1]),
            np.append(cost[good], np.zeros(len(pairs))),
            np.append(np.zeros(int(good.sum()), dtype=np.int64), np.array(list(made.values()), dtype=np.int64)),
        )

    def passable(self, start: Array, end: Array) -> NDArray[np.bool_]:
        """Which straight links from (n, 2) places to others pass no cut."""
        good = np.ones(len(start), dtype=np.bool_)
        for place in self.cuts:
            good &= _distance_to_segments(np.array(place), start, end) > CLEARANCE_PX
        return good

    def at_ends(self, cost: Array, places: Sequence[Place], scale: float) -> Array:
        """Costs of beginning or ending at places, little where a person cut a line."""
        loose = np.array([place in self.loose for place in places], dtype=np.bool_)
        return np.asarray(np.where(loose, np.minimum(cost, COST_AT_CUT * scale), cost), dtype=np.float64)

    def shared(self, tracklets: Sequence[Tracklet], links: Links) -> list[int]:
        """Tracklets that curves may share freely: the cheapest way from one of two places to the other."""
        out: list[int] = []
        for places in self.together:
            a, b = (under(tracklets, place).tracklet for place in sorted(places))
            out += _way(a, b, links, len(tracklets)) or [a, b]
        return out


UNCONSTRAINED = Constraints()


def constrain(
    tracklets: list[Tracklet], placed: Sequence[Placed], half_breadth_px: float
) -> tuple[list[Tracklet], Constraints, list[str]]:
    """The tracklets as corrected, what the flow must heed, and the ids of corrections with nothing under them."""
    cuts: list[Place] = []
    loose: list[Place] = []
    joins: list[tuple[Place, Place]] = []
    crossings: list[Straight] = []
    together: list[tuple[Place, Place]] = []
    unheeded: list[str] = []
    lines = [item for item in placed if isinstance(item.correction, ORDER)]
    for item in sorted(lines, key=lambda item: ORDER.index(type(item.correction))):
        places = [(float(c), float(r)) for c, r in item.at]
        found = [under(tracklets, place) for place in places]
        heeded = all(at.distance_px <= REACH * half_breadth_px for at in found)
        match item.correction:
            case Cut():
                if heeded:
                    line = tracklets[found[0].tracklet]
                    cuts.append((float(line.column[found[0].peak]), float(line.row[found[0].peak])))
                    tracklets, ends = cut(tracklets, found[0])
                    loose += ends
                else:
                    cuts.append(places[0])
                    heeded = _in_gap(tracklets, places[0], half_breadth_px)
            case Deleted() if heeded:
                tracklets = without_run(tracklets, found[0].tracklet, half_breadth_px)
            case Crossing() if heeded:
                arms, straight = crossed(tracklets, places[0], half_breadth_px)
                heeded = len(straight.pairs) > 0 and len(straight.inward) + len(straight.outward) > 2
                if heeded:
                    tracklets = arms
                    crossings.append(straight)
            case Joined() if heeded and found[0].tracklet != found[1].tracklet:
                tracklets, pair = joined(tracklets, found[0], found[1], half_breadth_px)
                joins.append(pair)
            case RunTogether() if heeded:
                together.append((places[0], places[1]))
            case _:
                heeded = False
        if not heeded:
            unheeded.append(item.correction.id)
    made = Constraints(tuple(cuts), tuple(loose), tuple(joins), tuple(crossings), tuple(together))
    return tracklets, made, unheeded


def _in_gap(tracklets: Sequence[Tracklet], at: Place, half_breadth_px: float) -> bool:
    """Whether a place lies in a gap over which a curve may have been led."""
    from_at = np.array([end_of(t) for t in tracklets if t.column[-1] < at[0]]).reshape(-1, 2)
    to_at = np.array([start_of(t) for t in tracklets if t.column[0] > at[0]]).reshape(-1, 2)
    source, target = np.nonzero(to_at[None, :, 0] - from_at[:, None, 0] < LONGEST_GAP * half_breadth_px)
    near = _distance_to_segments(np.array(at), from_at[source], to_at[target]) < CLEARANCE_PX
    return bool(near.any())


def _distance_to_segments(at: Array, start: Array, end: Array) -> Array:
    step = end - start
    length = np.maximum((step**2).sum(axis=1), 1e-9)
    share = np.clip(((at - start) * step).sum(axis=1) / length, 0.0, 1.0)
    return np.asarray(np.hypot(*(start + share[:, None] * step - at).T))


def _way(start: int, end: int, links: Links, count: int) -> list[int]:
    """Tracklets on the cheapest way from one to another, both included; none where no way leads there."""
    graph = coo_matrix((links.cost + 1.0, (links.source, links.target)), shape=(count, count)).tocsr()
    reached, came = dijkstra(graph, indices=np.array([start]), return_predecessors=True)
    if not np.isfinite(reached[0, end]):
        return []
    way = [end]
    while way[-1] != start:
        way.append(int(came[0, way[-1]]))
    return way
