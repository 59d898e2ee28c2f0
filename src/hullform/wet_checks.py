"""Checks in water: whether the panels hold her volume, two methods against each other, and her against other ships."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from hullform.checks import DISPLACEMENT_LIMIT_PERCENT, Check, deviation
from hullform.rounding import significant
from hullvib.real_ships import RATIO_LIMITS, widened

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


def checks_of_ratios(ratios: tuple[float, float], uncertainties: tuple[float, float], medium: str) -> tuple[Check, ...]:
    """The 3-node and the 4-node frequency over the 2-node one against ships as they are.

    The band of ships is widened by the model's own uncertainty of the ratio. None of a dry girder: the water lies
    amidships more than at the ends, and of a light ship it outweighs her, so that dry ratios are others.

    Args:
        ratios: 3-node and 4-node over 2-node frequency.
        uncertainties: of each, relative.
        medium: "wet" or "dry".
    """
    if medium == "dry":
        return ()
    three_node, four_node = zip(ratios, uncertainties, RATIO_LIMITS, strict=True)
    return (
        _against_ships("three-node-ratio", "3-node", *three_node),
        _against_ships("four-node-ratio", "4-node", *four_node),
    )


def _against_ships(id: str, mode: str, ratio: float, uncertainty: float, band: tuple[float, float]) -> Check:
    low, high = band
    return Check(
        id,
        f"{mode} over 2-node frequency against ships as they are ({low:g} to {high:g}, widened by the "
        f"{significant(100 * uncertainty, 2)} % to which this model knows it)",
        ratio,
        widened(band, uncertainty),
        "",
        "usual causes: the shear area (midship_shear_area_m2, or the members behind it), I(x) towards the ends, the "
        "mass at the ends",
    )
