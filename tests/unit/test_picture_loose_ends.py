"""Where a curve may begin: on the centre line or the base line, but not after a long run along the centre line."""

from __future__ import annotations

import numpy as np
import pytest

from hullform.picture.checking.loose_ends import loose_end
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.picture.tracing.half import HalfReading

SIZE = 500.0  # B/2, px
FRAME = DiagonalFrame(np.diag([1.0, -1.0, 1.0]), 1, 0.02, SIZE, 450.0)
READING = HalfReading("fore", FRAME, (), (), None)


def section(begins: float, run: float) -> np.ndarray:
    """[y, z] in px: a run up the centre line from a height, then a straight line to the side."""
    up = np.column_stack([np.zeros(50), np.linspace(begins, begins + run, 50)])
    out = np.column_stack([np.linspace(0.0, 450.0, 100), np.linspace(begins + run, 400.0, 100)])
    return np.vstack([up, out])


@pytest.mark.parametrize("begins", [0.0, 150.0])
def test_a_keel_on_the_centre_line_is_no_loose_end(begins: float) -> None:
    # 0.1 of B/2 is what the bar of a stem or a skeg may hide
    assert loose_end(section(begins, 50.0), READING, in_line=True) == ""


def test_a_long_run_up_the_centre_line_is_told_with_its_heights() -> None:
    # 140 px at 0.02 m: the axis hides where the station begins
    assert "runs up the centre line from z 0.00 to 2.80 m" in loose_end(section(0.0, 140.0), READING, in_line=True)


def test_a_beginning_in_the_air() -> None:
    lifted = section(100.0, 0.0) + np.array([30.0, 0.0])
    assert loose_end(lifted, READING, in_line=True).startswith("begins in the air at y 0.60 z 2.00 m")
