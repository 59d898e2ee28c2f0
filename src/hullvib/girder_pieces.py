"""Tables and power series turned into the Bernstein coefficients of a girder's pieces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib import bernstein
from hullvib.errors import GirderError
from hullvib.girder_checks import PROPERTIES, checked_breaks, checked_rows, checked_table

Array = NDArray[np.float64]
Table = tuple[ArrayLike, ArrayLike]
Pieces = list[Array | None]
Value = TypeVar("Value")

NEAR = 1e-9
"""Of the length: breakpoints that are closer than this are one."""


def pieces_of_table(x: ArrayLike, columns: Mapping[str, ArrayLike | None]) -> tuple[Array, Pieces]:
    """Breakpoints in m and end values (pieces, 2) of the columns of one table. Raises GirderError."""
    positions, tables = checked_table(x, columns)
    bays = np.flatnonzero(np.diff(positions) > 0.0)
    breaks = np.append(positions[bays], positions[-1])
    return breaks, [None if table is None else np.stack([table[bays], table[bays + 1]], axis=1) for table in tables]


def pieces_of_tables(given: Mapping[str, Table | None]) -> tuple[Array, Pieces]:
    """Breakpoints in m and end values (pieces, 2) of tables with breakpoints of their own. Raises GirderError."""
    tables: list[tuple[Array, Array] | None] = []
    for label, table in given.items():
        if table is None:
            tables.append(None)
            continue
        positions, (values,) = checked_table(table[0], {label: table[1]})
        tables.append((positions, present(values)))
    lengths = {label: t[0][-1] for label, t in zip(given, tables, strict=True) if t is not None}
    first, length = next(iter(lengths.items()))
    for label, end in lengths.items():
        if abs(end - length) > NEAR * length:
            raise GirderError(
                f"{label} ends at x = {end:g} m but {first} at x = {length:g} m; "
                "let every table run over the whole length."
            )
    merged = np.unique(np.concatenate([t[0] for t in tables if t is not None]))
    merged = merged[np.append(True, np.diff(merged) > NEAR * length)]
    merged[-1] = length
    return merged, [None if table is None else _on_breaks(*table, merged) for table in tables]


def pieces_of_polynomials(breaks: ArrayLike, given: Mapping[str, Sequence[ArrayLike] | None]) -> tuple[Array, Pieces]:
    """Breakpoints in m and Bernstein coefficients of power series in x - x_left, one a piece. Raises GirderError."""
    edges = checked_breaks(breaks)
    return edges, [None if p is None else _power_to_bernstein(label, edges, p) for label, p in given.items()]


def labelled(*properties: Value) -> dict[str, Value]:
    """The four properties under the names that messages call them by."""
    return dict(zip(PROPERTIES, properties, strict=True))


def cut(coefficients: Array, piece: int, t: float) -> Array:
    """Coefficients (pieces + 1, n + 1) of the same property with one piece cut in two at t, 0..1."""
    parts = np.stack(bernstein.split(coefficients[piece], t))
    return np.concatenate([coefficients[:piece], parts, coefficients[piece + 1 :]])


def present(values: Array | None) -> Array:
    """The values themselves. Raises GirderError for None."""
    if values is None:
        raise GirderError("mass per length and flexural rigidity are both needed; one of them is missing.")
    return values


def _on_breaks(x: Array, values: Array, breaks: Array) -> Array:
    """End values of a table's lines on the pieces of a finer partition, (pieces, 2)."""
    middle = 0.5 * (breaks[:-1] + breaks[1:])
    bay = np.clip(np.searchsorted(x, middle, side="right") - 1, 0, len(x) - 2)
    width = x[bay + 1] - x[bay]
    ends = []
    for edge in (breaks[:-1], breaks[1:]):
        t = np.clip((edge - x[bay]) / width, 0.0, 1.0)
        ends.append(values[bay] * (1.0 - t) + values[bay + 1] * t)
    return np.stack(ends, axis=1)


def _power_to_bernstein(label: str, breaks: Array, polynomials: Sequence[ArrayLike]) -> Array:
    rows = [np.atleast_1d(checked_rows(label, p)) for p in polynomials]
    if len(rows) != len(breaks) - 1:
        raise GirderError(
            f"{label} holds {len(rows)} polynomials but {len(breaks)} breaks make {len(breaks) - 1} pieces; "
            "give one polynomial a piece."
        )
    size = max(len(row) for row in rows)
    if size == 0 or any(row.ndim != 1 or len(row) == 0 for row in rows):
        raise GirderError(f"{label} has an empty polynomial; give at least its constant coefficient.")
    power = np.zeros((len(rows), size))
    for row, coefficients in zip(power, rows, strict=True):
        row[: len(coefficients)] = coefficients
    return bernstein.from_power(power, np.diff(breaks))
