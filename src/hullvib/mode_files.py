"""Modes in files: frequencies and shapes as CSV or JSON, with units in the headers.

A shape is written as a deflection in metres in the normalisation in force; rotation, bending moment and shear force are
those that go with it.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ModeFileError
from hullvib.girder_files import write_whole
from hullvib.modes import Modes

Array = NDArray[np.float64]

_POINTS = 101
_UNITS = {"deflection": "m", "rotation": "rad", "moment": "N_m", "shear": "N"}


def write_modes(modes: Modes, path: str | os.PathLike[str], x: ArrayLike | None = None) -> None:
    """Writes frequencies and shapes at x (points,) in m, whole or not at all, as .csv or .json by the suffix.

    Without x at 101 points from end to end. Raises ModeFileError, ArgumentError.
    """
    file = Path(path)
    writers = {".csv": modes_csv, ".json": modes_json}
    if file.suffix.lower() not in writers:
        raise ModeFileError(f"{file}: the suffix {file.suffix!r} is not known; write .csv or .json.")
    text = writers[file.suffix.lower()](modes, x)
    try:
        write_whole(file, text)
    except OSError as error:
        raise ModeFileError(f"{file}: cannot be written ({error.strerror}).") from None


def modes_csv(modes: Modes, x: ArrayLike | None = None) -> str:
    """Comment lines with the frequencies, a header `x_m,mode_1_deflection_m,mode_1_rotation_rad,..`, a row a point."""
    positions, tables = _tables(modes, x)
    lines = [f"# {modes.girder.name or 'girder'}: {modes.theory}, {modes.medium}; {modes.normalisation_note}"]
    lines += [
        f"# mode {n}: {hz!r} Hz, {omega!r} rad/s, modal mass {mass!r} kg"
        for n, (hz, omega, mass) in enumerate(
            zip(
                modes.frequencies_hz.tolist(),
                modes.angular_frequencies.tolist(),
                modes.modal_mass.tolist(),
                strict=True,
            ),
            1,
        )
    ]
    names, columns = ["x_m"], [positions]
    for n in range(len(modes.angular_frequencies)):
        for key, values in tables.items():
            names.append(f"mode_{n + 1}_{key}_{_UNITS[key]}")
            columns.append(values[n])
    lines.append(",".join(names))
    lines += [",".join(map(repr, row)) for row in np.stack(columns, axis=1).tolist()]
    return "\n".join(lines) + "\n"


def modes_json(modes: Modes, x: ArrayLike | None = None) -> str:
    """The solution's record as `hullvib solve --json` writes it, with the shapes under `shapes`."""
    positions, tables = _tables(modes, x)
    shapes: dict[str, Any] = {"normalisation": modes.normalisation_note, "x_m": positions.tolist()}
    shapes |= {f"{key}_{_UNITS[key]}": values.tolist() for key, values in tables.items()}
    content = {"girder": modes.girder.name, "solutions": [{**solution_record(modes), "shapes": shapes}]}
    return json.dumps(content, indent=1, allow_nan=False) + "\n"


def solution_record(modes: Modes) -> dict[str, Any]:
    """One entry of a list of `solutions`: the method's record, theory, frequencies, nodes, modal masses."""
    return {
        **modes.method,
        "theory": modes.theory,
        "medium": modes.medium,
        "frequencies_rad_s": modes.angular_frequencies.tolist(),
        "frequencies_hz": modes.frequencies_hz.tolist(),
        "node_counts": modes.node_counts.tolist(),
        "nodes_m": [positions.tolist() for positions in modes.nodes()],
        "modal_mass_kg": modes.modal_mass.tolist(),
        "normalisation": modes.normalisation_note,
    }


def _tables(modes: Modes, x: ArrayLike | None) -> tuple[Array, dict[str, Array]]:
    given = np.linspace(0.0, modes.girder.length, _POINTS) if x is None else x
    positions = np.atleast_1d(np.asarray(given, dtype=np.float64))
    return positions, {
        "deflection": modes.shape(positions),
        "rotation": modes.rotation(positions),
        "moment": modes.moment(positions),
        "shear": modes.shear(positions),
    }
