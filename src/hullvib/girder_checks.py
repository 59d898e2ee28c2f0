"""What a girder's numbers must satisfy; each refusal names the value, its place and the remedy."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib import bernstein
from hullvib.errors import GirderError

Array = NDArray[np.float64]

_SHORTEST = 1e-9  # of the length; shorter bays are round-off of a jump
_ROUND_OFF = 1e-13  # of the largest coefficient; a fit leaves this much below zero at a sharp end
PROPERTIES = ("mass per length", "flexural rigidity", "shear rigidity", "rotary inertia")


def _column(label: str, values: ArrayLike) -> Array:
    try:
        column = np.array(values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise GirderError(f"{label} is not a sequence of numbers ({error}).") from None
    if column.ndim != 1:
        raise GirderError(f"{label} has {column.ndim} dimensions; give one value a breakpoint, in one dimension.")
    wrong = np.flatnonzero(~np.isfinite(column))
    if len(wrong):
        raise GirderError(f"{label} has {column[wrong[0]]} at index {wrong[0]}; give a finite number there.")
    return column


def checked_rows(label: str, values: ArrayLike) -> Array:
    """Coefficients as an array of any shape; ragged rows and words are refused."""
    try:
        return np.array(values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise GirderError(f"{label} does not hold equally long rows of numbers ({error}).") from None


def checked_table(x: ArrayLike, columns: Mapping[str, ArrayLike | None]) -> tuple[Array, list[Array | None]]:
    """Positions and value columns of a table: finite, of one length, ascending, jumps of two equal x inside."""
    positions = _column("x", x)
    tables = [None if values is None else _column(label, values) for label, values in columns.items()]
    if len(positions) < 2:
        raise GirderError(f"a girder needs at least 2 breakpoints, x has {len(positions)}.")
    for label, table in zip(columns, tables, strict=True):
        if table is not None and len(table) != len(positions):
            raise GirderError(f"{label} has {len(table)} values but x has {len(positions)}; give one value each.")
    steps = np.diff(positions)
    back = np.flatnonzero(steps < 0.0)
    if len(back):
        i = int(back[0]) + 1
        raise GirderError(
            f"x falls from {positions[i - 1]:g} m to {positions[i]:g} m at index {i}; "
            "sort the rows from the aft end forward."
        )
    thrice = np.flatnonzero((steps[:-1] == 0.0) & (steps[1:] == 0.0))
    if len(thrice):
        raise GirderError(
            f"x = {positions[thrice[0]]:g} m stands three times from index {thrice[0]} on; a jump has two rows."
        )
    checked_breaks(positions[np.append(True, steps > 0.0)])
    if steps[0] == 0.0 or steps[-1] == 0.0:
        i = 0 if steps[0] == 0.0 else len(positions) - 2
        raise GirderError(
            f"x = {positions[i]:g} m at index {i}, an end, stands twice; a jump needs girder on both sides."
        )
    return positions, tables


def checked_breaks(breaks: ArrayLike) -> Array:
    """Breakpoints that start at 0 and ascend strictly, (pieces + 1,) in m."""
    edges = _column("x", breaks)
    if len(edges) < 2 or edges[-1] == edges[0]:
        raise GirderError("the girder has zero length; give x from 0 to its length in metres.")
    if edges[0] != 0.0:
        raise GirderError(f"x starts at {edges[0]:g} m; measure it from the aft end, so that it starts at 0.")
    short = np.flatnonzero(np.diff(edges) <= _SHORTEST * abs(edges[-1]))
    if len(short):
        i = int(short[0])
        raise GirderError(
            f"the bay from x = {edges[i]!s} m to {edges[i + 1]!s} m (piece {i}) has no length or a negative one; "
            "let the breakpoints ascend."
        )
    return edges


def checked_pieces(
    breaks: Array, pieces: Sequence[Array | None], point_masses: Sequence[tuple[float, float]]
) -> list[Array | None]:
    """Copies of the properties' Bernstein coefficients, in physical range."""
    clean: list[Array | None] = []
    for label, given in zip(PROPERTIES, pieces, strict=True):
        if given is None:
            clean.append(None)
            continue
        if given.ndim != 2 or len(given) != len(breaks) - 1 or given.shape[1] == 0:
            raise GirderError(
                f"{label} has coefficients of shape {given.shape}; {len(breaks) - 1} pieces need as many rows."
            )
        wrong = np.argwhere(~np.isfinite(given))
        if len(wrong):
            raise GirderError(f"{label} has {given[tuple(wrong[0])]} in piece {wrong[0][0]}; give finite numbers.")
        # a constant is kept as a line, so that equal girders have equal coefficients
        coefficients = np.repeat(given, 2, axis=1) + 0.0 if given.shape[1] == 1 else given + 0.0
        floor = -_ROUND_OFF * float(np.abs(coefficients).max())
        coefficients[(coefficients < 0.0) & (coefficients >= floor)] = 0.0
        _not_negative(label, breaks, coefficients)
        if label.endswith("rigidity"):
            _positive(label, breaks, coefficients)
        clean.append(coefficients)
    length = float(breaks[-1])
    for x, mass in point_masses:
        if not 0.0 <= x <= length:
            raise GirderError(f"a point mass of {mass:g} kg lies at x = {x:g} m, outside 0 .. {length:g} m.")
    mass_coefficients = clean[0]
    spread = 0.0 if mass_coefficients is None else float(np.diff(breaks) @ bernstein.integral(mass_coefficients))
    if spread + sum(mass for _, mass in point_masses) <= 0.0:
        raise GirderError("the girder has no mass at all; give a mass per length or point masses.")
    return clean


def _not_negative(label: str, breaks: Array, coefficients: Array) -> None:
    # non-negative coefficients prove the piece; only the others need a look at the values
    for piece in np.flatnonzero((coefficients < 0.0).any(axis=1)):
        value, t = bernstein.minimum(coefficients[piece])
        if value < 0.0:
            x = breaks[piece] + t * (breaks[piece + 1] - breaks[piece])
            raise GirderError(f"{label} is {value:g} at x = {x:g} m (piece {piece}); it must not be negative.")


def _positive(label: str, breaks: Array, coefficients: Array) -> None:
    left, right = coefficients[:, 0] <= 0.0, coefficients[:, -1] <= 0.0
    left[0] = right[-1] = False
    for flags, x in ((left, breaks[:-1]), (right, breaks[1:])):
        if flags.any():
            piece = int(np.flatnonzero(flags)[0])
            raise GirderError(
                f"{label} is 0 at x = {x[piece]:g} m (piece {piece}); only the two ends of the girder may be sharp: "
                "give a positive value, however small."
            )
    empty = np.flatnonzero((coefficients <= 0.0).all(axis=1))
    inner = [
        p for p in np.flatnonzero((coefficients < 0.0).any(axis=1)) if bernstein.minimum(coefficients[p])[0] <= 0.0
    ]
    for piece in [*empty, *inner]:
        raise GirderError(
            f"{label} is 0 within {breaks[piece]:g} .. {breaks[piece + 1]:g} m (piece {piece}); "
            "give a positive value, however small."
        )
