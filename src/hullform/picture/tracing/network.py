"""The network of one half's pieces of curve, and its cheapest flow.

A plain network has a whole optimum of its linear relaxation. That of each pair of walks one at most is used is no
condition of a network: where it leaves fractions, the programme is solved again in whole units.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog
from scipy.sparse import coo_matrix, csr_matrix

from hullform.picture.edits.constraints import Links

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

FRACTION = 1e-6  # of a unit: more is no round-off


@dataclass(frozen=True, eq=False)
class Flow:
    """Units on links, into and out of tracklets, and their whole cost (px of ink, negative where it pays)."""

    links: Indices
    entries: Indices
    exits: Indices
    cost: float

    @property
    def units(self) -> int:
        """Number of curves."""
        return int(self.entries.sum())


@dataclass(frozen=True, eq=False)
class Network:
    """Costs of the flow, px of ink.

    Attributes:
        reward: of the first curve on each piece; `share`: of each further one.
        links: pieces that may follow each other.
        entry, leave: of a curve that begins or ends with each piece.
        marked: number of stations that a user marked on each piece.
        reward_of_mark: for each further curve up to that number.
        twins: the last 2 * twins pieces are so many walked one way, then the same walked the other way: each is used
            once.
        least: number of curves: a marked station has one of its own.
    """

    reward: Array
    share: Array
    links: Links
    entry: Array
    leave: Array
    marked: Indices
    reward_of_mark: float
    twins: int
    least: int


def cheapest_flow(network: Network, most: int) -> Flow | None:
    """The cheapest flow of at most `most` units; None where the links that must be passed need more."""
    source, target, twins = network.links.source, network.links.target, network.twins
    n, m = len(network.reward), len(network.links.cost)
    wanted = np.flatnonzero(network.marked > 1)  # by more curves than one
    cost = np.concatenate(
        [
            network.reward,
            network.share,
            network.links.cost,
            network.entry,
            network.leave,
            network.share[wanted] - network.reward_of_mark,
        ]
    )
    lower = np.concatenate([np.zeros(2 * n), network.links.least, np.zeros(2 * n + wanted.size)])
    upper = np.concatenate(
        [np.ones(n), np.full(n, most - 1.0), np.full(m + 2 * n, float(most)), network.marked[wanted] - 1.0]
    )
    node, arc = np.arange(n), np.arange(m)
    # what comes in (links, entries) passes the tracklet (first use, shared use) and goes out (links, exits)
    rows = np.concatenate([target, node, node, node, wanted, n + source, n + node, n + node, n + node, n + wanted])
    first, second, links, entries, exits = 0, n, 2 * n, 2 * n + m, 3 * n + m
    further = 4 * n + m + np.arange(wanted.size)
    columns = np.concatenate(
        [
            links + arc,
            entries + node,
            first + node,
            second + node,
            further,
            links + arc,
            exits + node,
            first + node,
            second + node,
            further,
        ]
    )
    inside = -np.ones(2 * n + wanted.size)
    signs = np.concatenate([np.ones(m + n), inside, np.ones(m + n), inside])
    balance = coo_matrix((signs, (rows, columns)), shape=(2 * n, len(cost))).tocsr()
    pair = np.arange(twins)
    none = np.zeros(n, dtype=np.int64)
    bounded_rows = np.concatenate([none, none + 1, 2 + pair, 2 + pair])
    bounded_columns = np.concatenate([entries + node, entries + node, n - 2 * twins + pair, n - twins + pair])
    weights = np.concatenate([np.ones(n), -np.ones(n), np.ones(2 * twins)])
    bounded = coo_matrix((weights, (bounded_rows, bounded_columns)), shape=(2 + twins, len(cost))).tocsr()
    found = _least(cost, bounded, most, network, balance, lower, upper, whole=False)
    if found is not None and np.abs(found[0] - np.round(found[0])).max() > FRACTION:
        found = _least(cost, bounded, most, network, balance, lower, upper, whole=True)
    if found is None:
        return None
    solution, least_cost = found
    x = np.round(solution).astype(np.int64)
    return Flow(x[links:entries], x[entries:exits], x[exits : exits + n], least_cost)


def _least(
    cost: Array,
    bounded: csr_matrix,
    most: int,
    network: Network,
    balance: csr_matrix,
    lower: Array,
    upper: Array,
    *,
    whole: bool,
) -> tuple[Array, float] | None:
    """The solution of least cost, in whole units where asked, and that cost; None where there is none."""
    result = linprog(  # type: ignore[call-overload]  # the stubs know no sparse matrices
        cost,
        A_ub=bounded,
        b_ub=np.concatenate([[float(most), -float(min(network.least, most))], np.ones(network.twins)]),
        A_eq=balance,
        b_eq=np.zeros(balance.shape[0]),
        bounds=np.column_stack([lower, upper]),
        method="highs",
        integrality=np.ones(len(cost)) if whole else None,
    )
    return None if result.x is None else (np.asarray(result.x, dtype=np.float64), float(result.fun))
