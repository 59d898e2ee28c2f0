"""Girders in files: girder.csv (tables) and girder.json (polynomial pieces and point masses).

girder.csv has a header `x_m,mass_kg_per_m,flexural_rigidity_N_m2[,shear_rigidity_N][,rotary_inertia_kg_m]`, one row a
breakpoint, linear between; two equal x in a row are a jump. girder.json holds `breaks_m`, one list of coefficients a
piece for each property under the same names, `form` ("bernstein", or "power": in s = x - x_left, lowest first),
`point_masses` and `name`.
"""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hullvib.errors import GirderError, GirderFileError
from hullvib.girder import Girder
from hullvib.point_masses import PointMass

Array = NDArray[np.float64]

_REQUIRED = ("x_m", "mass_kg_per_m", "flexural_rigidity_N_m2")
_OPTIONAL = ("shear_rigidity_N", "rotary_inertia_kg_m")
_PROPERTIES = (*_REQUIRED[1:], *_OPTIONAL)
# what the girder's own messages call a property
_LABELS = dict(
    zip(_PROPERTIES, ("mass per length", "flexural rigidity", "shear rigidity", "rotary inertia"), strict=True)
)
_KEYS = ("name", "form", "breaks_m", *_PROPERTIES, "point_masses")
_POINT_KEYS = ("x_m", "mass_kg", "rotary_inertia_kg_m2")


def read_girder(path: str | os.PathLike[str]) -> Girder:
    """Reads girder.csv or girder.json; a file whose text starts with '{' is JSON. Raises GirderFileError."""
    file = Path(path)
    try:
        text = file.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise GirderFileError(f"{file}: cannot be read ({error.strerror}); give a girder.csv or girder.json.") from None
    except UnicodeDecodeError:
        raise GirderFileError(f"{file}: is not text in UTF-8; give a girder.csv or girder.json.") from None
    return parse_girder(text, source=str(file), name=file.stem)


def parse_girder(text: str, source: str = "girder", name: str = "") -> Girder:
    """Girder from the text of a CSV or JSON file; source stands in messages, name where the text has none.

    Raises GirderFileError, with the line or the key.
    """
    try:
        return _from_json(text, source, name) if text.lstrip().startswith("{") else _from_csv(text, source, name)
    except GirderFileError:
        raise
    except GirderError as error:
        raise GirderFileError(f"{source}: {error}") from error


def write_girder(girder: Girder, path: str | os.PathLike[str]) -> None:
    """Writes .csv or .json by the suffix, whole or not at all; every number is read back to the same bits.

    CSV holds straight lines and no point masses. Raises GirderFileError.
    """
    file = Path(path)
    if file.suffix.lower() == ".json":
        text = girder_json(girder)
    elif file.suffix.lower() == ".csv":
        text = girder_csv(girder)
    else:
        raise GirderFileError(f"{file}: the suffix {file.suffix!r} is not known; write .csv or .json.")
    try:
        write_whole(file, text)
    except OSError as error:
        raise GirderFileError(f"{file}: cannot be written ({error.strerror}).") from None


def write_whole(file: Path, text: str) -> None:
    """Writes a text file whole or not at all: aside, then renamed. Raises OSError."""
    aside = file.with_name(file.name + ".part")
    try:
        aside.write_text(text, encoding="utf-8")
        aside.replace(file)
    except OSError:
        aside.unlink(missing_ok=True)
        raise


def girder_json(girder: Girder) -> str:
    """The text of girder.json."""
    pieces = {key: None if c is None else c.tolist() for key, c in zip(_PROPERTIES, _coefficients(girder), strict=True)}
    points = [{key: getattr(point, key) for key in _POINT_KEYS} for point in girder.point_masses]
    content = {
        "name": girder.name,
        "form": "bernstein",
        "breaks_m": girder.breaks.tolist(),
        **{key: value for key, value in pieces.items() if value is not None},
        "point_masses": points,
    }
    return json.dumps(content, indent=1, allow_nan=False) + "\n"


def girder_csv(girder: Girder) -> str:
    """The text of girder.csv. Raises GirderFileError for point masses and for curves."""
    if girder.point_masses:
        raise GirderFileError(f"girder.csv cannot hold {len(girder.point_masses)} point masses; write girder.json.")
    columns: dict[str, list[float]] = {}
    present = {k: c for k, c in zip(_PROPERTIES, _coefficients(girder), strict=True) if c is not None}
    curved = [key for key, c in present.items() if c.shape[1] > 2]
    if curved:
        raise GirderFileError(f"girder.csv cannot hold {curved[0]}, which is curved within a piece; write girder.json.")
    rows: list[list[float]] = []
    columns = {key: [] for key in present}
    for piece, (left, right) in enumerate(zip(girder.breaks[:-1], girder.breaks[1:], strict=True)):
        for x, end in ((left, 0), (right, -1)):
            row = [float(x), *(float(c[piece, end]) for c in present.values())]
            if not rows or rows[-1] != row:
                rows.append(row)
    lines = [",".join(("x_m", *columns)), *(",".join(map(repr, row)) for row in rows)]
    return "\n".join(lines) + "\n"


def _coefficients(girder: Girder) -> tuple[Array | None, ...]:
    return (
        girder.mass_coefficients,
        girder.flexural_rigidity_coefficients,
        girder.shear_rigidity_coefficients,
        girder.rotary_inertia_coefficients,
    )


def _from_csv(text: str, source: str, name: str) -> Girder:
    reader = csv.reader(io.StringIO(text))
    header: list[str] = []
    rows: list[list[float]] = []
    lines: list[int] = []
    for cells in reader:
        cells = [cell.strip() for cell in cells]
        if not any(cells) or cells[0].startswith("#"):
            continue
        where = f"{source}, line {reader.line_num}"
        if not header:
            header = _checked_header(cells, where)
            continue
        if len(cells) != len(header):
            raise GirderFileError(f"{where}: {len(cells)} values, but the header names {len(header)}.")
        rows.append([_number(cell, key, where) for cell, key in zip(cells, header, strict=True)])
        lines.append(reader.line_num)
    if not header:
        raise GirderFileError(f"{source}: is empty; its first line must be {','.join(_REQUIRED)}.")
    if len(rows) < 2:
        raise GirderFileError(f"{source}: has {len(rows)} rows of numbers; a girder needs at least 2.")
    columns = dict(zip(header, np.array(rows).T, strict=True))
    _check_positions(columns["x_m"], lines, source)
    _check_rigidities(columns, lines, source)
    return Girder(
        columns["x_m"],
        columns["mass_kg_per_m"],
        columns["flexural_rigidity_N_m2"],
        columns.get("shear_rigidity_N"),
        columns.get("rotary_inertia_kg_m"),
        name=name,
    )


def _checked_header(cells: list[str], where: str) -> list[str]:
    separator = next((name for sign, name in ((";", "semicolons"), ("\t", "tabs")) if sign in "".join(cells)), None)
    if separator:
        raise GirderFileError(
            f"{where}: the columns are separated by {separator}; separate them by commas, with points in the decimals."
        )
    missing = [key for key in _REQUIRED if key not in cells]
    unknown = [key for key in cells if key not in (*_REQUIRED, *_OPTIONAL)]
    if missing or unknown or len(set(cells)) != len(cells):
        fault = f"lacks {missing[0]}" if missing else f"has {unknown[0]!r}" if unknown else "names a column twice"
        raise GirderFileError(
            f"{where}: the header {fault}; it must be {','.join(_REQUIRED)}, then if wanted {', '.join(_OPTIONAL)}."
        )
    return cells


def _number(cell: str, key: str, where: str) -> float:
    try:
        value = float(cell)
    except ValueError:
        raise GirderFileError(f"{where}: {key} is {cell!r}; give a number.") from None
    if not np.isfinite(value):
        raise GirderFileError(f"{where}: {key} is {cell}; give a finite number.")
    if value < 0.0 and key != "x_m":
        raise GirderFileError(f"{where}: {key} is {cell}; it must not be negative.")
    return value


def _check_positions(x: Array, lines: list[int], source: str) -> None:
    """Refuses what `Girder` would refuse too, where the line can be named."""
    if x[0] != 0.0:
        raise GirderFileError(
            f"{source}, line {lines[0]}: x_m starts at {x[0]:g}; measure it from the aft end, so that it starts at 0."
        )
    steps = np.diff(x)
    back = np.flatnonzero(steps < 0.0)
    if len(back):
        i = int(back[0]) + 1
        raise GirderFileError(
            f"{source}, line {lines[i]}: x_m falls from {x[i - 1]:g} to {x[i]:g}; sort the rows from aft forward."
        )
    if x[-1] == 0.0:
        raise GirderFileError(f"{source}, line {lines[-1]}: x_m ends at 0; give x from 0 to the length in metres.")
    thrice = np.flatnonzero((steps[:-1] == 0.0) & (steps[1:] == 0.0))
    if len(thrice):
        i = int(thrice[0]) + 2
        raise GirderFileError(f"{source}, line {lines[i]}: x_m is {x[i]:g} for the third time; a jump has two rows.")
    for i, step in ((1, steps[0]), (len(x) - 1, steps[-1])):
        if step == 0.0:
            raise GirderFileError(
                f"{source}, line {lines[i]}: x_m is {x[i]:g}, an end, for the second time; a jump needs girder on both "
                "sides."
            )


def _check_rigidities(columns: Mapping[str, Array], lines: list[int], source: str) -> None:
    for key in ("flexural_rigidity_N_m2", "shear_rigidity_N"):
        empty = np.flatnonzero(columns[key][1:-1] <= 0.0) if key in columns else np.empty(0, dtype=np.intp)
        if len(empty):
            i = int(empty[0]) + 1
            raise GirderFileError(
                f"{source}, line {lines[i]}: {key} is 0 at x_m = {columns['x_m'][i]:g}; only the two ends of the "
                "girder may be sharp: give a positive value, however small."
            )


def _from_json(text: str, source: str, name: str) -> Girder:
    try:
        content = json.loads(text)
    except json.JSONDecodeError as error:
        raise GirderFileError(f"{source}, line {error.lineno}: is not JSON ({error.msg}).") from None
    except ValueError:
        raise GirderFileError(f"{source}: holds a whole number of thousands of digits; give SI values.") from None
    except RecursionError:
        raise GirderFileError(f"{source}: is nested too deeply; properties are lists of lists of numbers.") from None
    for key in content:
        if key not in _KEYS:
            where = _place(text, key, source)
            raise GirderFileError(f"{where}: key {key!r} is not known; the keys are {', '.join(_KEYS)}.")
    for key in ("breaks_m", *_PROPERTIES[:2]):
        if key not in content:
            raise GirderFileError(f"{source}: key {key!r} is missing; a girder.json needs it.")
    label = content.get("name") or name
    if not isinstance(label, str):
        raise GirderFileError(f"{_place(text, 'name', source)}: name is {label!r}; give a text.")
    form = content.get("form", "bernstein")
    if form not in ("bernstein", "power"):
        raise GirderFileError(f"{_place(text, 'form', source)}: form is {form!r}; give 'bernstein' or 'power'.")
    build = Girder.from_bernstein if form == "bernstein" else Girder.from_polynomials
    masses = content.get("point_masses", [])
    if not isinstance(masses, list):
        raise GirderFileError(f"{source}: point_masses is {masses!r}; give a list.")
    points = [_point_mass(entry, f"{source}, point_masses[{i}]") for i, entry in enumerate(masses)]
    try:
        mass, rigidity, shear, rotary = (content.get(key) for key in _PROPERTIES)
        return build(content["breaks_m"], mass, rigidity, shear, rotary, points, label)
    except GirderError as error:
        keys = [key for key, label in _LABELS.items() if str(error).startswith(label)]
        raise GirderFileError(f"{_place(text, keys[0], source) if keys else source}: {error}") from error
    except (TypeError, ValueError, OverflowError) as error:
        raise GirderFileError(
            f"{source}: breaks_m must be a list of numbers, each property one list of coefficients a piece ({error})."
        ) from None


def _place(text: str, key: str, source: str) -> str:
    """Source and line at which a key of a JSON text stands."""
    position = text.find(f'"{key}"')
    return source if position < 0 else f"{source}, line {text.count(chr(10), 0, position) + 1}"


def _point_mass(entry: Any, where: str) -> PointMass:
    if not isinstance(entry, Mapping) or not {"x_m", "mass_kg"} <= set(entry) <= set(_POINT_KEYS):
        raise GirderFileError(f"{where}: is {entry!r}; give x_m, mass_kg and, if wanted, rotary_inertia_kg_m2.")
    if not all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in entry.values()):
        raise GirderFileError(f"{where}: is {entry!r}; give numbers.")
    return PointMass(**entry)
