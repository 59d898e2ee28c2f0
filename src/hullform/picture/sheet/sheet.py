"""The sheet: a picture made ready to be traced, with its scale found and its halves told apart.

All that takes time and needs no station is done here, once; `reading.read_sheet` may then be called again and again.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from hullform.body_plan import Half
from hullform.errors import PictureError
from hullform.picture.calibrating.calibration import CalibratedSheet, calibrate
from hullform.picture.calibrating.line_mask import subtract_lines
from hullform.picture.calibrating.lines import find_lines_and_border
from hullform.picture.image.image_files import Picture, load_grey
from hullform.picture.image.ink import Ink, ink_of
from hullform.picture.image.labels import Label, can_read_labels, read_labels
from hullform.picture.image.reduction import Reduction, reduced
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.pieces.half_ink import HalfInk, prepare_half
from hullform.picture.sheet.likeness import explained, require_upright
from hullform.ship import Ship

HIGHEST = 1.6  # of the depth: how high the drawing is searched above the base line
LEVEL_WITH_DEPTH = 0.006  # of the depth: a level line so near to it is the deck line
HALVES: tuple[Half, Half] = ("aft", "fore")


@dataclass(frozen=True, eq=False)
class Sheet:
    """A picture with its calibration and the ink of its halves.

    Attributes:
        path: of the picture.
        size_px: (width, height) of the stored picture, which calibration and marks mean.
        grey: (rows, columns) the picture as it is read; a large one is read at a smaller size.
        reduction: from pixels of the stored picture to those of `grey`.
        ink, bare: (rows, columns) all ink, and what is left without the long straight lines.
        calibrated: the calibration of `grey`, its grid, its frame lines.
        halves: the ink of each half.
    """

    path: Path
    size_px: tuple[int, int]
    grey: Picture
    reduction: Reduction
    ink: Ink
    bare: Ink
    calibrated: CalibratedSheet
    halves: dict[Half, HalfInk]

    @cached_property
    def labels(self) -> tuple[Label, ...] | None:
        """The words on the picture, read when first asked for; None where nothing is installed to read them."""
        return read_labels(self.grey) if can_read_labels() else None


def prepare_sheet(ship: Ship, quarter_turns: int = 0) -> Sheet:
    """Load a ship's picture, calibrate it and find the pieces of curve in each half.

    Args:
        ship: [ship] and [body_plan] of a ship.toml with an image; stations and marks are not looked at.
        quarter_turns: by which the picture is turned counterclockwise first; a given calibration means it turned.

    Raises:
        PictureError: no readable picture, no calibration, or one that cannot be.
    """
    path, source, main = ship.picture.image_path, ship.picture, ship.particulars
    whole = np.ascontiguousarray(np.rot90(load_grey(path, source.page), quarter_turns))
    size_px = (whole.shape[1], whole.shape[0])
    grey, reduction = reduced(whole)
    del whole
    ink = ink_of(grey, str(path))
    given = reduction.given(source.calibration)
    with explained(str(path), ink, main.breadth_m, main.depth_m):
        horizontal, vertical, border = find_lines_and_border(ink)
        calibrated = calibrate(
            ink, horizontal, vertical, main.breadth_m, main.depth_m, given, str(path), main.draught_m
        )
    calibration = calibrated.calibration
    bare, mask = subtract_lines(ink, [*calibrated.frame_lines, *border])
    depth_px = main.depth_m / calibration.metres_per_px
    deck_line = any(
        not line.vertical
        and abs(calibration.baseline_px - float(line.at(calibration.centreline_px)) - depth_px)
        < LEVEL_WITH_DEPTH * depth_px
        for line in calibrated.frame_lines
    )
    top_m = min(HIGHEST * main.depth_m, (calibration.baseline_px - 2) * calibration.metres_per_px)
    if top_m < 0.5 * main.depth_m:
        raise PictureError(
            f"{path}: at {calibration.metres_per_px:.4g} m per px the picture ends {top_m:.2f} m above the base line, "
            f"but the depth is {main.depth_m:g} m; check breadth_m, depth_m and [body_plan.calibration]"
        )
    left: Half = "aft" if source.aft_side == "left" else "fore"
    halves = {}
    for half in HALVES:
        frame = DiagonalFrame.of(calibration, -1 if half == left else 1, main.breadth_m, top_m)
        halves[half] = prepare_half(half, frame, ink, bare, mask, depth_px, deck_line)
    with explained(str(path), ink, main.breadth_m, main.depth_m):
        require_upright(str(path), bare, list(halves.values()))
    return Sheet(path, size_px, grey, reduction, ink, bare, calibrated, halves)
