"""The one verb: a girder and a method give modes."""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

import numpy as np

from hullvib.bounds import bracket
from hullvib.errors import ArgumentError, NotProven, SolutionError
from hullvib.girder import Girder
from hullvib.modes import Modes
from hullvib.stodola import StodolaRitz

_FUNCTIONS = (8, 12, 16, 24, 32, 48, 64, 96)
"""Numbers of trial functions tried in turn for an asked tolerance, each with these numbers of steps."""
_STEPS = (2, 3)


class Method(Protocol):
    """What `solve` asks of a method: a small frozen object with its settings."""

    def solve(self, girder: Girder, modes: int) -> Modes:
        """The first `modes` elastic modes of a girder."""
        ...


def solve(girder: Girder, method: Method | None = None, modes: int = 5, *, tolerance: float | None = None) -> Modes:
    """Natural frequencies and shapes of the first elastic modes of a free-free girder in vertical bending, dry.

    Arguments: girder; method, `StodolaRitz()` by default; modes, how many; tolerance, instead of a method: the numbers
    of functions and of steps are then chosen so that the relative width (upper - lower) / upper of the bracket of every
    frequency is below it, and `Modes.method` says what was used and whether that is proven. Where no bracket can be
    proven, the change from the number of functions before takes its place, which is an estimate and no bound.
    Raises ArgumentError where the method cannot give so many modes, SolutionError where the girder has not so many or
    the tolerance is not reached.
    """
    if tolerance is None:
        return (StodolaRitz() if method is None else method).solve(girder, modes)
    if method is not None:
        raise ArgumentError("a method and a tolerance were given; a tolerance chooses the method's settings itself.")
    if not tolerance > 0.0:
        raise ArgumentError(f"tolerance is {tolerance}; give a positive relative width, 1e-6 for instance.")
    return _to_tolerance(girder, modes, tolerance)


def _to_tolerance(girder: Girder, modes: int, tolerance: float) -> Modes:
    most = _FUNCTIONS[-1] - 3
    if modes > most:
        raise ArgumentError(f"{modes} modes were asked to a tolerance; ask for 1 to {most}, or choose a method.")
    coarser, reached = None, float("inf")
    for functions in (n for n in _FUNCTIONS if n >= modes + 3):
        for steps in _STEPS:
            result = StodolaRitz(functions, steps).solve(girder, modes)
            proven = True
            try:
                width = float(bracket(result).relative_width.max())
            except NotProven:
                proven = False
                if coarser is None:
                    continue
                # upper bounds fall towards the answer; that they fell by more than they still will is usual, and no
                # theorem: the result says that it is not proven
                width = float(np.abs(coarser.angular_frequencies / result.angular_frequencies - 1.0).max())
            if width <= tolerance:
                record = {"tolerance": tolerance, "relative_width": width, "proven": proven}
                return replace(result, method={**result.method, **record})
            reached = min(reached, width)
        coarser = result
    best = f"the best is {reached:.1e}" if reached < float("inf") else "no width could be proven or estimated"
    raise SolutionError(
        f"the relative width {tolerance:g} is not reached for {modes} modes with up to {_FUNCTIONS[-1]} functions "
        f"and {_STEPS[-1]} steps ({best}); ask for fewer modes or a wider tolerance."
    )
