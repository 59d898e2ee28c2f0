"""Neighbouring curves that cross are told; those that touch, merge at the keel or lie inside one another are not."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from hullform.picture.naming.crossings import crossings
from hullform.picture.pieces.frame import DiagonalFrame

Array = NDArray[np.float64]

SIZE = 500.0  # B/2, px
FRAME = DiagonalFrame(np.diag([1.0, -1.0, 1.0]), 1, 1.0, SIZE, 450.0)


def section(fullness: float, breadth: float, lean: float = 0.0) -> Array:
    """A keel-to-deck curve: y = breadth (z / 400)^fullness + lean (z / 400), in px."""
    t = np.linspace(0.0, 1.0, 400)
    return np.column_stack([breadth * t**fullness + lean * t, 400.0 * t])


def test_sections_inside_one_another_do_not_cross() -> None:
    assert crossings([section(0.8, 200.0), section(0.6, 300.0), section(0.4, 400.0)], FRAME) == []


def test_a_crossing_is_found_where_it_is() -> None:
    # 240 t = 300 t^1.4 at t = 0.8^2.5: above, the full curve is the narrower one
    (found,) = crossings([section(1.0, 240.0), section(1.4, 300.0)][::-1], FRAME)
    assert found[:2] == (0, 1)
    # the frame is looked at column by column, a pixel along the diagonal
    assert found[3] == pytest.approx(400.0 * 0.8**2.5, abs=2.0)


@pytest.mark.parametrize("apart", [0.0, 3.0, -3.0])
def test_lines_that_nearly_coincide_do_not_cross(apart: float) -> None:
    # 3 px are 0.6 % of B/2: what two readings of nearly one line may differ by
    inner = section(0.5, 300.0)
    assert crossings([inner, inner + np.array([apart, 0.0])], FRAME) == []


def test_curves_that_merge_at_the_keel_do_not_cross() -> None:
    # they change sides below 3 % of B/2
    inner, outer = section(0.5, 300.0), section(0.7, 380.0)
    merged = outer[:, 1] < 0.02 * SIZE
    outer[merged, 0] -= 20.0
    assert crossings([inner, np.maximum(outer, inner * (1.05, 1.0))], FRAME) == []
