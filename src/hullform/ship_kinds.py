"""Ships of the published frequencies that a type of ship.toml is held against."""

from __future__ import annotations

from collections.abc import Mapping

from hullform.ship import Particulars, ShipType
from hullvib.real_ships import Kind, PublishedFrequencies, ships_like

# The nearest of four kinds by hull form; a type that is like none of them is held against none.
KINDS: Mapping[ShipType, Kind] = {
    "tanker": "tanker",
    "chemical-tanker": "tanker",
    "bulk-carrier": "tanker",
    "container": "cargo",
    "refrigerated-cargo": "cargo",
    "coaster": "cargo",
    "ro-ro-ferry": "passenger",
    "passenger": "passenger",
    "frigate": "destroyer",
}


def published_like(particulars: Particulars) -> tuple[PublishedFrequencies, ...]:
    """The published ships of her kind and of about her length between perpendiculars; often there are none."""
    kind = KINDS.get(particulars.type)
    return () if kind is None else ships_like(kind, particulars.length_between_perpendiculars_m)
