"""A ship of which the main particulars are known, with files for the other doors made of her own hull."""

from __future__ import annotations

from pathlib import Path

from hullform.ship import Ship, read_ship

SHIP = """schema = 1
[ship]
name = "Form ship"
type = "bulk-carrier"
length_overall_m = 190.0
length_between_perpendiculars_m = 182.0
aft_perpendicular_m = 5.0
breadth_m = 30.0
depth_m = 17.0
draught_m = 11.0
block_coefficient = 0.78
"""
LOADED = """[structure]
midship_second_moment_m4 = 110.0
[weights]
[[conditions]]
name = "loaded"
deadweight_t = 38000.0
"""


def form_ship(folder: Path, body_plan: str = "", ship: str = SHIP) -> Ship:
    """Write her ship.toml with a [body_plan] into a folder and read it."""
    path = folder / "ship.toml"
    path.write_text(f"{ship}{body_plan}\n{LOADED}", encoding="utf-8")
    return read_ship(path)
