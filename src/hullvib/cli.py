"""The command `hullvib`: a girder file in, a table or JSON of natural frequencies out."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence

from hullvib.errors import HullvibError
from hullvib.finite_elements import FiniteElements
from hullvib.girder import Girder
from hullvib.girder_files import parse_girder, read_girder
from hullvib.modes import Modes
from hullvib.plausibility import implausible
from hullvib.ritz import Ritz
from hullvib.solving import solve


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command; returns the exit code: 0 done, 1 the input is wrong. Wrong usage exits with 2."""
    parser = _parser()
    options = parser.parse_args(arguments)
    if options.method == "fem" and options.functions is not None:
        parser.error("--functions belongs to --method ritz; use --elements with fem")
    if options.method == "ritz" and options.elements is not None:
        parser.error("--elements belongs to --method fem; use --functions with ritz")
    try:
        girder = _girder(options.girder)
        functions = 12 if options.functions is None else options.functions
        elements = 100 if options.elements is None else options.elements
        method = Ritz(functions) if options.method == "ritz" else FiniteElements(elements)
        modes = solve(girder, method, options.modes)
    except HullvibError as error:
        print(f"hullvib: {error}", file=sys.stderr)
        return 1
    for warning in implausible(modes):
        print(f"hullvib: warning: {warning}", file=sys.stderr)
    print(json.dumps(solution_record(modes), indent=2, allow_nan=False) if options.json else _table(modes))
    return 0


def solution_record(modes: Modes) -> dict[str, object]:
    """What `--json` writes: the girder's name and one entry under `solutions`."""
    solution = {
        **modes.method,
        "theory": modes.theory,
        "medium": modes.medium,
        "frequencies_rad_s": modes.angular_frequencies.tolist(),
        "frequencies_hz": modes.frequencies_hz.tolist(),
        "node_counts": modes.node_counts.tolist(),
        "nodes_m": [positions.tolist() for positions in modes.nodes()],
    }
    return {"girder": modes.girder.name, "solutions": [solution]}


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="hullvib", description="Vibration of hull girders.")
    commands = parser.add_subparsers(dest="command", required=True)
    command = commands.add_parser(
        "solve",
        help="natural frequencies of a girder",
        description="Natural frequencies of a free-free girder in vertical bending (Euler-Bernoulli, dry).",
    )
    command.add_argument("girder", metavar="GIRDER", help="girder.csv or girder.json; - reads the standard input")
    command.add_argument("--method", choices=("ritz", "fem"), default="ritz", help="default: ritz")
    command.add_argument("--functions", type=int, metavar="N", help="elastic trial functions of ritz (default 12)")
    command.add_argument("--elements", type=int, metavar="N", help="elements of fem (default 100)")
    command.add_argument("--modes", type=int, default=5, metavar="K", help="elastic modes (default 5)")
    command.add_argument("--json", action="store_true", help="write JSON with all digits")
    return parser


def _girder(path: str) -> Girder:
    if path == "-":
        return parse_girder(sys.stdin.read(), source="standard input")
    return read_girder(path)


def _table(modes: Modes) -> str:
    method = ", ".join(f"{key.replace('_', ' ')} {value}" for key, value in modes.method.items() if key != "method")
    lines = [
        f"{modes.girder.name or 'girder'}: {modes.girder.length:g} m, {modes.girder.total_mass / 1000.0:.6g} t; "
        f"{modes.theory}, {modes.medium}; {modes.method['method'].replace('_', ' ')} ({method})",
        "mode        Hz  cycles/min     rad/s  nodes",
    ]
    rows = zip(modes.frequencies_hz, modes.cycles_per_minute, modes.angular_frequencies, modes.node_counts, strict=True)
    lines += [
        f"{n:4d}  {hz:8.4f}  {cpm:10.2f}  {rad:8.4f}  {nodes:5d}" for n, (hz, cpm, rad, nodes) in enumerate(rows, 1)
    ]
    return "\n".join(lines)
