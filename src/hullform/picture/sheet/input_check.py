"""Whether a picture is large enough and drawn finely enough to keep neighbouring stations apart.

Two figures decide: S, the pixels of a half-breadth, and S / lw, with lw the thickness of a line. Read without marks,
ten real hulls had 86 % of their stations right at S = 870 and S / lw = 160 to 260, as many at S = 520, 78 % at
S / lw = 115, and 62 % at S = 365. So the first two limits below are where a finer picture begins to pay, the other two
where stations get lost.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from hullform.picture.pieces.half_ink import HalfInk

SMALLEST_HALF_PX = 600.0  # S of a picture about 1450 px wide
FINEST_LINES = 300.0  # S / lw
HOPELESS_HALF_PX = 400.0
HOPELESS_LINES = 150.0
GOOD_HALF_PX = 850.0  # S of a picture 2000 px wide
EDGES_PX = 1.5  # half-maximum width of a line of no thickness: the pixels themselves
THIN_PX = 2.5  # lines as thin as that are coarse by the scan's fault, not the pen's


def line_thickness_px(halves: Iterable[HalfInk]) -> float:
    """Thickness lw of single curves, px, the width of the pixels' own edges taken off; that of the finer half."""
    seen = min(half.single_px for half in halves)
    return float(np.sqrt(max(seen**2 - EDGES_PX**2, 1.0)))


def check_input(name: str, halves: Iterable[HalfInk], width_px: int) -> tuple[list[str], list[str]]:
    """What S and S / lw of a picture mean for the reading, with what to do.

    Args:
        name: of the picture.
        halves: both, prepared.
        width_px: of the picture as stored, px.

    Returns:
        notes, where a finer picture would pay, and doubts, where stations are lost without it.
    """
    halves = list(halves)
    half_breadth_px = halves[0].frame.half_breadth_px
    lines_px = line_thickness_px(halves)
    fineness = half_breadth_px / lines_px
    size = f"S = {half_breadth_px:.0f} px per half-breadth"
    if half_breadth_px < SMALLEST_HALF_PX:
        wanted_px = 100 * int(np.ceil(width_px * GOOD_HALF_PX / half_breadth_px / 100))
        worse = "; as it is, mark a point of each station" if half_breadth_px < HOPELESS_HALF_PX else ""
        return [], [
            f"{name}: the picture is small: {size}; scan or export it {wanted_px} px wide, for {GOOD_HALF_PX:.0f} px "
            f"or more{worse}"
        ]
    if fineness >= FINEST_LINES:
        return [], []
    remedy = "scan it finer" if lines_px < THIN_PX else "a print with thinner lines keeps neighbouring curves apart"
    words = f"{name}: lines of {lines_px:.1f} px at {size}, S / lw = {fineness:.0f}"
    if fineness < HOPELESS_LINES:
        return [], [
            f"{words}: the lines are thick; curves merge where they lie near each other and stations get lost: "
            f"{remedy}; as it is, mark a point of each station"
        ]
    return [f"{words}; {remedy} ({FINEST_LINES:.0f} or more is read best)"], []
