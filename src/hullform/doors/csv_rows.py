"""Rows of a csv as people write them: comma, semicolon or tab, decimal point or comma, remarks after a '#'."""

from __future__ import annotations

import csv
import math
from dataclasses import dataclass
from pathlib import Path

from hullform.errors import BodyPlanError

SEPARATORS = (";", "\t", ",")


@dataclass(frozen=True)
class CsvTable:
    """A csv file, its cells stripped.

    Attributes:
        path: where it lies.
        rows: its rows that are not empty, each with the number of its line.
    """

    path: Path
    rows: tuple[tuple[int, tuple[str, ...]], ...]
    decimal_comma: bool

    def number(self, line: int, column: str, cell: str) -> float:
        """A cell as a number.

        Raises:
            BodyPlanError: it is none; names line and column.
        """
        text = cell.replace(",", ".") if self.decimal_comma else cell
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise BodyPlanError(f"{self.path}, line {line}, column {column}: '{cell}' is no number; correct it")
        return value


def read_csv(path: Path, key: str = "body_plan.offsets") -> CsvTable:
    """Read a csv file that a key of ship.toml names.

    Where columns are parted by semicolons or tabs, a comma is taken for the decimal sign.

    Raises:
        BodyPlanError: the file is missing, is no text, or holds fewer than two rows.
    """
    try:
        text = path.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise BodyPlanError(f"{path}: no such file; {key} names it") from None
    except UnicodeDecodeError:
        raise BodyPlanError(f"{path}: is no text in UTF-8; save the table as csv") from None
    except OSError as error:
        raise BodyPlanError(f"{path}: cannot be read ({error.strerror}); {key} names it") from None
    lines = [(number, line.split("#")[0]) for number, line in enumerate(text.splitlines(), start=1)]
    filled = [(number, line) for number, line in lines if line.strip(" \t;,")]
    if len(filled) < 2:
        raise BodyPlanError(f"{path}: has {len(filled)} rows; a table has a header and a row a point")
    separator = next((mark for mark in SEPARATORS if mark in filled[0][1]), ",")
    cells = []
    for number, line in filled:
        # line by line: a quotation mark that is not closed, as of inches, must not swallow the lines below it
        (row,) = csv.reader([line], delimiter=separator)
        cells.append((number, tuple(cell.strip() for cell in row)))
    return CsvTable(path, tuple(cells), decimal_comma=separator != ",")
