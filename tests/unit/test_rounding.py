"""How the report writes numbers."""

from __future__ import annotations

import pytest

from hullform.rounding import MINUS, THIN_SPACE, as_given, per_cent, short, signed, significant


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (0.94640206, "0.946"),
        (0.9999, "1.00"),
        (9.996, "10.0"),
        (99.96, "100"),
        (1234.5, "1230"),
        (74660.0, f"74{THIN_SPACE}700"),
        (-1.482, f"{MINUS}1.48"),
        (0.00123456, "0.00123"),
        (0.000123456, "1.23 × 10⁻⁴"),
        (5.2118e13, "5.21 × 10¹³"),
        (float("nan"), "–"),
        (float("inf"), "–"),
    ],
)
def test_three_significant_figures(value: float, text: str) -> None:
    assert significant(value) == text


def test_figures_can_be_fewer() -> None:
    assert significant(81.7, 2) == "82"
    assert significant(0.0866, 2) == "0.087"


def test_signed_marks_both_signs_and_leaves_nought_alone() -> None:
    assert signed(2.5) == "+2.50"
    assert signed(-2.5) == f"{MINUS}2.50"
    assert signed(0.0) == "0"


@pytest.mark.parametrize(
    ("value", "text"), [(0.5, "0.5"), (101.0, "101"), (1.0, "1"), (1500.0, "1500"), (1.25, "1.25")]
)
def test_limits_lose_closing_zeros_behind_the_point_only(value: float, text: str) -> None:
    assert short(value) == text


@pytest.mark.parametrize(
    ("value", "text"),
    [(249.98, "249.98"), (262.0, "262"), (57785.0, f"57{THIN_SPACE}785"), (1025.0, "1025"), (2.06e11, "2.06 × 10¹¹")],
)
def test_given_numbers_stand_as_given(value: float, text: str) -> None:
    assert as_given(value) == text


def test_per_cent_is_of_the_reference() -> None:
    assert per_cent(1.1, 1.0) == "+10.0"
    assert per_cent(0.9, 1.0) == f"{MINUS}10.0"
    # the last bits of a double are no difference
    assert per_cent(1.0 + 2e-16, 1.0) == "0"
    assert per_cent(1.0, 0.0) == "–"
