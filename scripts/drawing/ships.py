"""The drawn ships by their names."""

from __future__ import annotations

from drawing.moulded import Moulded
from drawing.outline import Outline
from drawing.tables import PARTICULARS
from drawing.waterlines import fast_ropax, handymax_bulk_carrier


def outline(ship: str) -> Moulded:
    """Return the form of one of the drawn ships; raise ValueError for a name that is not among them."""
    if ship not in PARTICULARS:
        raise ValueError(f"there is no drawn ship {ship!r}; there are {', '.join(PARTICULARS)}")
    by_formula = {"handymax-bulk-carrier": handymax_bulk_carrier, "fast-ropax": fast_ropax}
    return by_formula[ship]() if ship in by_formula else Outline(ship, PARTICULARS[ship])
