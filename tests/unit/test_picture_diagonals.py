"""Straight lines from the centre line outboard and down are diagonals; curves that lean back are not."""

from __future__ import annotations

import numpy as np

from hullform.picture.pieces.diagonals import on_diagonals

SIZE = 800.0  # px per B/2


def test_a_diagonal_is_told_from_the_top_of_a_bulb() -> None:
    # walked inboard and up: the diagonal ends at the centre line, with gaps where stations cross it
    along = np.arange(0.0, 500.0)
    along = along[(along % 50) > 8]
    line = 300.0 + 0.05 * along
    # a quarter of a circle of 200 px, which touches the line for less than a station's gap
    turn = np.linspace(0.2, 1.3, 200)
    round_along, round_across = 100 + 200 * np.sin(turn), 120 + 200 * np.cos(turn)
    found = on_diagonals(
        np.concatenate([along, round_along]),
        np.concatenate([line, round_across]),
        np.concatenate([np.full(len(along), 0.05), -np.tan(turn)]),
        np.concatenate([(500.0 - along) / np.sqrt(2), np.full(len(turn), 100.0)]),
        SIZE,
    )
    assert found[: len(along)].all()
    assert found[len(along) :].mean() < 0.1  # near where they cross


def test_a_straight_line_that_stays_off_the_centre_line_is_no_diagonal() -> None:
    along = np.arange(0.0, 500.0)
    lean = np.full(500, 0.05)
    assert not on_diagonals(along, 300.0 + 0.05 * along, lean, np.full(500, 0.2 * SIZE), SIZE).any()
