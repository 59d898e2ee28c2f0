"""Checks of the water about a condition: whether the panels hold her volume, and two methods against each other."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from hullform.checks import DISPLACEMENT_LIMIT_PERCENT, Check, deviation

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


def check_strips(by_strips_rad_s: Mapping[str, ArrayLike], by_panels_rad_s: Mapping[str, ArrayLike]) -> Check:
    """Wet frequencies with the added mass by strips against those by panels: the mode that differs most.

    Args:
        by_strips_rad_s: first modes of each girder, by a name for it.
        by_panels_rad_s: the same girders' and modes'.
    """
    worst, girder, mode = 0.0, "", 0
    for name, strips in by_strips_rad_s.items():
        difference = 100 * (np.asarray(strips, dtype=float) / np.asarray(by_panels_rad_s[name], dtype=float) - 1)
        place = int(np.abs(difference).argmax())
        if abs(float(difference[place])) > abs(worst):
            worst, girder, mode = float(difference[place]), name, place + 1
    return deviation(
        "wet-strips",
        f"wet frequency of mode {mode}, {girder}, with the added mass by strips against that by panels",
        worst,
        STRIPS_LIMIT_PERCENT,
        "%",
        "the panels' figures stand; strips miss blunt ends and flat sections: look at the wetted hull, and take the "
        "difference for the uncertainty of the added mass",
    )
