"""The one verb: a girder and a method give modes."""

from __future__ import annotations

from typing import Protocol

from hullvib.girder import Girder
from hullvib.modes import Modes
from hullvib.ritz import Ritz


class Method(Protocol):
    """What `solve` asks of a method: a small frozen object with its settings."""

    def solve(self, girder: Girder, modes: int) -> Modes:
        """The first `modes` elastic modes of a girder."""
        ...


def solve(girder: Girder, method: Method | None = None, modes: int = 5) -> Modes:
    """Natural frequencies and shapes of the first elastic modes of a free-free girder in vertical bending, dry.

    Arguments: girder; method, `Ritz()` by default, `FiniteElements()` or `Ritz(rigid_body=False)`; modes, how many.
    Raises ArgumentError where the method cannot give so many modes, SolutionError where the girder has not so many.
    """
    return (Ritz() if method is None else method).solve(girder, modes)
