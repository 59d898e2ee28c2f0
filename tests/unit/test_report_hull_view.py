"""The surface that the report shows of a hull: closed, outward, with its edge at the waterline, and small."""

from __future__ import annotations

import numpy as np
import pytest

from hullform.hull.contours import Contours
from hullform.hull.loft import Hull
from hullform.report.hull_view import ANTIFOULING, DECK, surface

DRAUGHT_M = 6.0
ORIGIN = (-60.0, 30.0, -40.0)


@pytest.fixture(scope="module")
def hull() -> Hull:
    """A ship with a transom, a keel that rises aft, and a blunt stem."""
    x = np.linspace(0.0, 100.0, 100)
    along = x / 100.0
    keel = 7.0 * np.clip(1 - along / 0.15, 0.0, 1.0) ** 2
    return Hull.of_super_ellipses(
        x_m=x,
        half_breadth_m=8.0 * np.minimum(1.0, 0.2 + 2.0 * (1 - along)) * np.minimum(1.0, 0.7 + 2.0 * along),
        depth_m=10.0 - keel,
        top_height_m=np.full(100, 10.0),
        p=np.full(100, 3.0),
        q=np.full(100, 2.5),
        length_overall_m=100.0,
        length_between_perpendiculars_m=96.0,
        aft_perpendicular_m=2.0,
        breadth_m=16.0,
        depth_moulded_m=10.0,
        draught_m=DRAUGHT_M,
    )


def _volume(hull: Hull, draught_m: float) -> float:
    """By the divergence theorem, a third of the sum of r . n dA: right only for a closed surface turned outward.

    From an origin apart from the ship, so that every patch counts, the transom in the plane x = 0 too.
    """
    total = 0.0
    for patch in surface(hull, draught_m):
        a, b, c = np.moveaxis((patch.grid.reshape(-1, 3) - ORIGIN)[patch.faces], 1, 0)
        total += float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6.0
    return total


@pytest.mark.parametrize("draught_m", [DRAUGHT_M, 9.999, 0.01])
def test_surface_holds_the_hulls_volume(hull: Hull, draught_m: float) -> None:
    # flat facets between 17 + 9 points a side lose some tenths of a per cent; a patch turned inward, or a gap, loses
    # its whole share, which is several per cent for the smallest ones, the ends
    assert _volume(hull, draught_m) == pytest.approx(hull.volume_m3, rel=0.01)


def test_bottom_ends_at_the_waterline(hull: Hull) -> None:
    bottom = next(patch for patch in surface(hull, DRAUGHT_M) if patch.colour == ANTIFOULING)
    afloat = hull.keel_height_m < DRAUGHT_M
    # sections are polygons of 97 points here: their corners miss the curve by less than a centimetre
    assert bottom.grid[afloat][:, [0, -1], 2] == pytest.approx(DRAUGHT_M, abs=0.01)
    assert bottom.grid[..., 2].max() <= max(DRAUGHT_M + 0.01, hull.keel_height_m.max())


def test_deck_faces_up_and_the_whole_stays_small(hull: Hull) -> None:
    patches = surface(hull, DRAUGHT_M)
    deck = next(patch for patch in patches if patch.colour == DECK)
    a, b, c = np.moveaxis(deck.grid.reshape(-1, 3)[deck.faces], 1, 0)
    assert (np.cross(b - a, c - a)[:, 2] > 0).all()
    assert sum(len(patch.faces) for patch in patches) <= 15_000


def test_there_is_no_plate_between_a_bulb_and_the_stem() -> None:
    bulb = np.array([[0.0, 1.0], [1.5, 1.5], [2.0, 3.0], [0.0, 5.0], [0.0, 8.0], [1.0, 9.0], [3.0, 12.0]])
    bow = Hull(np.array([90.0, 95.0, 100.0]), Contours(np.stack([bulb] * 3)), 100.0, 100.0, 0.0, 16.0, 12.0, DRAUGHT_M)
    for patch in surface(bow, DRAUGHT_M):
        corner = patch.grid.reshape(-1, 3)[patch.faces]
        assert (np.abs(corner[..., 1]).max(axis=1) > 0).all()
    sides = [patch for patch in surface(bow, DRAUGHT_M) if patch.colour == ANTIFOULING]
    assert sum(len(patch.faces) for patch in sides) > 0
    # both parts have their whole surface, the bulb's and the flare's, and nothing spans the gap from 5 to 8 m
    heights = np.concatenate([(p.grid.reshape(-1, 3)[p.faces])[..., 2] for p in sides])
    assert not ((heights.min(axis=1) < 4.9) & (heights.max(axis=1) > 5.1)).any()
