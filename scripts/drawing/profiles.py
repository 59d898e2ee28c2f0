"""The contour of a drawn ship in her centre plane, as the table that lies beside her ship.toml."""

from __future__ import annotations

import numpy as np

from drawing.moulded import Array
from drawing.waterlines import WaterlineForm

HEAD = "# Contour in the centre plane, from the deck at the stern round the keel to the deck at the stem.\nx_m,z_m\n"
# Of the length: beyond this from either end the keel is on the base line, or a straight line.
_ENDS = 0.2
_STEP_M = 0.02
_HEIGHTS = 1801
# Of the breadth: no deadwood is thinner, as in the sections that are drawn.
_THINNEST = 0.00125
_STRAIGHT_M = 0.02  # a point nearer to the line through those beside it is left out


def profile(form: WaterlineForm) -> Array:
    """Return points (n, 2) [x, z] in m, told to the centimetre, of the deck at the stern, the keel and the stem."""
    main = form.particulars
    length, top = main.length_overall_m, main.depth_m
    steps = round(_ENDS * length / _STEP_M)
    ends = np.linspace(0.0, _ENDS * length, steps + 1)
    z = np.linspace(0.0, top, _HEIGHTS)
    feet, heads, stems = [], [], []
    for x in np.concatenate([ends, length - ends[::-1]]):
        wet = form.hull.half_breadths(float(x), z) > _THINNEST * main.breadth_m
        rises = np.flatnonzero(np.diff(np.concatenate([[False], wet, [False]]).astype(int)))
        if not len(rises):
            continue
        feet.append([x, z[rises[0]]])
        if len(rises) > 2:
            heads.append([x, z[rises[1] - 1]])
            stems.append([x, z[rises[2]]])
    lower = np.array(feet)
    # beyond the tip of the bulb the section begins at the stem
    tip = heads[-1][0] if heads else np.inf
    bulb, stem = lower[lower[:, 0] <= tip], lower[lower[:, 0] > tip]
    round_the_bulb = np.concatenate([np.reshape(heads[::-1], (-1, 2)), np.reshape(stems, (-1, 2))])
    whole = np.concatenate([[[0.0, top]], bulb, round_the_bulb, stem, [[length, top]]])
    return _without_straight_parts(np.round(whole, 2))


def text(form: WaterlineForm) -> str:
    """Return the table."""
    return HEAD + "".join(f"{x:.2f},{z:.2f}\n" for x, z in profile(form))


def _without_straight_parts(points: Array) -> Array:
    """Return the points between which all others are near a straight line."""
    if len(points) < 3:
        return points
    run = points[-1] - points[0]
    off = np.abs((points - points[0]) @ [run[1], -run[0]]) / np.hypot(*run)
    farthest = int(off.argmax())
    if off[farthest] <= _STRAIGHT_M:
        return points[[0, -1]]
    before, after = points[: farthest + 1], points[farthest:]
    return np.concatenate([_without_straight_parts(before)[:-1], _without_straight_parts(after)])
