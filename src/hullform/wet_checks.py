"""Checks of the water about a condition: whether the panels hold her volume, and two methods against each other."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from hullform.checks import DISPLACEMENT_LIMIT_PERCENT, Check, deviation
from hullform.rounding import significant

# Flat panels lie within a curved hull: half a per cent, and less where she is full.
PANEL_VOLUME_LIMIT_PERCENT = DISPLACEMENT_LIMIT_PERCENT
# Strips with their correction for the flow along the hull are good to some per cent of a frequency, panels to a tenth.
STRIPS_LIMIT_PERCENT = 3.0


def check_panel_volume(panels_m3: float, displaced_m3: float) -> Check:
    """The volume that the panels enclose against that of her floating position."""
    return deviation(
        "panel-volume",
        "volume within the panels of the wetted hull against that which she displaces",
        100 * (panels_m3 / displaced_m3 - 1),
        PANEL_VOLUME_LIMIT_PERCENT,
        "%",
        "the hull has sections that panels cannot follow, or is wet in two places: check the stations and the draughts",
    )


def check_strips(strips_rad_s: ArrayLike, panels_rad_s: ArrayLike) -> Check:
    """Wet frequencies with the added mass by strips against those by panels: the mode that differs most."""
    difference = 100 * (np.asarray(strips_rad_s, dtype=float) / np.asarray(panels_rad_s, dtype=float) - 1)
    mode = int(np.abs(difference).argmax())
    return deviation(
        "wet-strips",
        f"wet frequency of mode {mode + 1} with the added mass by strips against that by panels",
        float(difference[mode]),
        STRIPS_LIMIT_PERCENT,
        "%",
        f"the panels' figure stands; where her form is so blunt or so flat that strips miss it by "
        f"{significant(abs(float(difference[mode])), 2)} %, take that for its uncertainty, and look at the wetted hull",
    )
