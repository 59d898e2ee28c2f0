"""Whole numbers among the arguments of methods."""

from __future__ import annotations

import operator
from typing import SupportsIndex, cast


def is_whole(value: object, least: int, most: float) -> bool:
    """Whether a value is a whole number, Python's or numpy's, from least to most; a truth value is none."""
    try:
        return not isinstance(value, bool) and least <= operator.index(cast(SupportsIndex, value)) <= most
    except TypeError:
        return False
