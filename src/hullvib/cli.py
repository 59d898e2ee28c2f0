"""The command `hullvib`: a girder file in, a table or JSON of natural frequencies out.

Exit codes: 0 done; 1 the input is wrong or the output cannot be written; 2 usage; 130 interrupted.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from hullvib.bounds import bracket
from hullvib.errors import GirderFileError, HullvibError, SolutionError
from hullvib.finite_elements import FiniteElements
from hullvib.girder import Girder
from hullvib.girder_files import parse_girder, read_girder
from hullvib.mode_files import solution_record, write_modes
from hullvib.modes import Modes
from hullvib.plausibility import implausible
from hullvib.ritz import Ritz
from hullvib.solving import Method, solve
from hullvib.stodola import StodolaRitz
from hullvib.timoshenko import TimoshenkoRitz
from hullvib.timoshenko_elements import TimoshenkoElements

# each method with the options that it takes
_METHODS: dict[str, tuple[Callable[..., Method], tuple[str, ...]]] = {
    "stodola": (StodolaRitz, ("functions", "steps", "shear")),
    "ritz": (Ritz, ("functions", "basis")),
    "fem": (FiniteElements, ("elements", "rotary_inertia")),
    "timoshenko": (TimoshenkoRitz, ("functions", "basis")),
    "timoshenko-fem": (TimoshenkoElements, ("elements",)),
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command; returns the exit code. Wrong usage exits with 2."""
    parser = _parser()
    options = parser.parse_args(arguments)
    settings = _settings(parser, options)
    try:
        text = _solve(options, settings)
        if sys.stdout is None:
            return _refuse("the standard output is closed; there is nowhere to write the frequencies.")
        print(text, flush=True)
    except HullvibError as error:
        return _refuse(str(error))
    except KeyboardInterrupt:
        print("hullvib: interrupted", file=sys.stderr)
        return 130
    except BrokenPipeError:
        # whoever read the output has gone; what is left of it goes nowhere, quietly
        _drop_output()
    except OSError as error:
        _drop_output()
        return _refuse(f"the standard output cannot be written ({error.strerror}).")
    return 0


def _refuse(reason: str) -> int:
    print(f"hullvib: {reason}", file=sys.stderr)
    return 1


def _drop_output() -> None:
    """Lets the interpreter flush what is left in the buffer of the standard output into nothing."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _solve(options: argparse.Namespace, settings: Mapping[str, object]) -> str:
    """The text to print; warnings and notes go to the standard error."""
    girder = _girder(options.girder)
    method = None if options.tolerance is not None else _METHODS[options.method or "stodola"][0](**settings)
    # what overflows is refused by its result
    with np.errstate(all="ignore"):
        modes = solve(girder, method, options.modes, tolerance=options.tolerance)
        bounds = proven_bounds(modes)
    if options.shapes is not None:
        write_modes(modes, options.shapes)
    for warning in implausible(modes):
        print(f"hullvib: warning: {warning}", file=sys.stderr)
    if girder.shear_rigidity_coefficients is not None and not modes.shear_flexible:
        print(
            f"hullvib: note: the girder has a shear rigidity, which {modes.theory} leaves out; --method timoshenko "
            "takes it in.",
            file=sys.stderr,
        )
    if options.json:
        content = {"girder": girder.name, "solutions": [{**solution_record(modes), **bounds}]}
        return json.dumps(content, indent=2, allow_nan=False)
    return _table(modes, bounds)


def _settings(parser: argparse.ArgumentParser, options: argparse.Namespace) -> dict[str, object]:
    """The options that were given, as arguments of the method; an option of another method is wrong usage."""
    known = sorted({key for _, keys in _METHODS.values() for key in keys})
    given = {key: getattr(options, key) for key in known if getattr(options, key) is not None}
    if options.tolerance is not None and (given or options.method is not None):
        parser.error("--tolerance chooses the method and its settings itself; leave them out")
    method = options.method or "stodola"
    for key in given:
        if key not in _METHODS[method][1]:
            homes = " and ".join(name for name, (_, keys) in _METHODS.items() if key in keys)
            parser.error(f"--{key.replace('_', '-')} belongs to --method {homes}, not to {method}")
    return given


def proven_bounds(modes: Modes) -> dict[str, object]:
    """What a bracket of the same girder tells: lower_rad_s, upper_rad_s and the proof, or why it is not_proven."""
    if modes.theory != "Euler-Bernoulli":
        return {"not_proven": f"bounds exist for the Euler-Bernoulli beam only, and the theory is {modes.theory}"}
    count = len(modes.angular_frequencies)
    own = modes.method["functions"] if modes.method["method"] == "stodola_ritz" else 0
    try:
        proven = bracket(modes.girder, count, functions=max(12, count + 7, own))
    except SolutionError as reason:
        return {"not_proven": str(reason)}
    if not np.isfinite([proven.lower, proven.upper]).all():
        return {"not_proven": "the bounds overflow; give the girder in kg, m and N"}
    return {"lower_rad_s": proven.lower.tolist(), "upper_rad_s": proven.upper.tolist(), "proof": proven.proof}


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="hullvib", description="Vibration of hull girders.")
    commands = parser.add_subparsers(dest="command", required=True)
    command = commands.add_parser(
        "solve",
        help="natural frequencies of a girder",
        description="Natural frequencies of a free-free girder in vertical bending, dry.",
        epilog="Exit codes: 0 done, 1 the input is wrong or the output cannot be written, 2 usage, 130 interrupted.",
    )
    command.add_argument("girder", metavar="GIRDER", help="girder.csv or girder.json; - reads the standard input")
    command.add_argument(
        "--method",
        choices=tuple(_METHODS),
        help="stodola (default), ritz and fem: the Euler-Bernoulli beam; timoshenko, timoshenko-fem: with shear and "
        "rotary inertia, of a girder that has a shear rigidity",
    )
    command.add_argument("--functions", type=int, metavar="N", help="elastic trial functions (12; timoshenko 20)")
    command.add_argument("--steps", type=int, metavar="N", help="Stodola steps (2)")
    command.add_argument("--basis", choices=("uniform", "legendre"), help="trial functions of ritz and timoshenko")
    command.add_argument("--elements", type=int, metavar="N", help="elements of fem and timoshenko-fem (100)")
    command.add_argument("--shear", action="store_const", const=True, help="stodola: with shear deflection")
    command.add_argument("--rotary-inertia", action="store_const", const=True, help="fem: with rotary inertia")
    command.add_argument("--tolerance", type=float, metavar="T", help="stodola with as many functions as T needs")
    command.add_argument("--modes", type=int, default=5, metavar="K", help="elastic modes (default 5)")
    command.add_argument("--shapes", metavar="FILE", help="also write the mode shapes, to a .csv or .json")
    command.add_argument("--json", action="store_true", help="write JSON with all digits")
    return parser


def _girder(path: str) -> Girder:
    if path == "-":
        if sys.stdin is None:
            raise GirderFileError("standard input: is closed; give a girder.csv or girder.json.")
        try:
            text = sys.stdin.buffer.read().decode("utf-8-sig")
        except UnicodeDecodeError:
            raise GirderFileError("standard input: is not text in UTF-8; give a girder.csv or girder.json.") from None
        return parse_girder(text, source="standard input")
    return read_girder(path)


def _table(modes: Modes, bounds: Mapping[str, object]) -> str:
    record = [
        f"{key.replace('_', ' ')} {f'{value:.2g}' if isinstance(value, float) else value}"
        for key, value in modes.method.items()
        if key != "method"
    ]
    girder, omega = modes.girder, modes.angular_frequencies
    lines = [
        f"{girder.name or 'girder'}: {girder.length:g} m, {girder.total_mass / 1000.0:.6g} t; "
        f"{modes.theory}, {modes.medium}; {modes.method['method'].replace('_', ' ')} ({', '.join(record)})",
        "mode        Hz  cycles/min     rad/s  nodes",
    ]
    rows = zip(modes.frequencies_hz, modes.cycles_per_minute, omega, modes.node_counts, strict=True)
    lines += [
        f"{n:4d}  {hz:8.4f}  {cpm:10.2f}  {rad:8.4f}  {nodes:5d}" for n, (hz, cpm, rad, nodes) in enumerate(rows, 1)
    ]
    if "not_proven" in bounds:
        return "\n".join([*lines, f"numerical error not proven: {bounds['not_proven']}"])
    lower, upper = (np.array(bounds[key], dtype=np.float64) for key in ("lower_rad_s", "upper_rad_s"))
    errors = np.maximum(np.abs(omega - lower), np.abs(upper - omega)) / omega
    lines[1] += "  numerical error"
    lines[2:] = [f"{line}  {f'below {_ceiling(error):.0e}':>15}" for line, error in zip(lines[2:], errors, strict=True)]
    lines.append("The numerical error is that of the beam solution, proven; it says nothing of the girder's data.")
    return "\n".join(lines)


def _ceiling(error: float) -> float:
    """The error rounded up to one digit, not below the spacing of doubles."""
    unit = 10.0 ** np.floor(np.log10(max(error, 1e-16)))
    return float(np.ceil(max(error, 1e-16) / unit) * unit)
