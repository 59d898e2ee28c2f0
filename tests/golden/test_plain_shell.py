"""A plain shell has the figures that it had when one closed cell was all that the program knew.

tests/data/plain_shell.json holds A, neutral axis, I and kA of the paper's two ships, at the stations of their drawing
tables, from that earlier single-cell formula. It is not to be mended: a change of it is a change of the paper's ships.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from drawing import tables
from drawing.ships import outline

from hullform.hull import Hull
from hullform.loading.structure import structure_of
from hullform.ship_structure import StructureInput

GOLDEN = json.loads((Path(__file__).parents[1] / "data" / "plain_shell.json").read_text(encoding="utf-8"))
TABLES = {"scim-containership": tables.SCIM_CONTAINERSHIP, "ds-tanker": tables.DS_TANKER}


@pytest.mark.parametrize("ship", GOLDEN)
def test_the_papers_ships_have_their_figures(ship: str) -> None:
    x, half_breadth, top, depth, p, q = np.array(TABLES[ship]).T
    main, known = outline(ship).particulars, GOLDEN[ship]
    hull = Hull(
        x, half_breadth, depth, top, p, q, main.length_overall_m, main.length_between_perpendiculars_m,
        main.aft_perpendicular_m, main.breadth_m, main.depth_m, main.draught_m,
    )  # fmt: skip
    found = structure_of(hull, StructureInput(midship_second_moment_m4=known["midship_second_moment_m4"]))
    for name in ("x_m", "area_m2", "neutral_axis_m", "second_moment_m4"):
        # the same formulas: round-off of another machine's libraries
        np.testing.assert_allclose(getattr(found, name), known[name], rtol=1e-12)
    # the joints are tied to the ground by 1e-13 of the stiffest
    np.testing.assert_allclose(found.shear_area_m2, known["shear_area_m2"], rtol=1e-11)
