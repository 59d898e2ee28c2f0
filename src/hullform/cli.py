"""The command `hullform`: one thin function a command.

Exit codes: 0 done; 1 the input is wrong; 2 usage; 3 done, with doubts; 130 interrupted.
"""

from __future__ import annotations

import argparse
import os
import signal
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from hullform.errors import HullformError

DONE, WRONG_INPUT, DOUBTS, INTERRUPTED = 0, 1, 3, 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command; returns its exit code."""
    # a run that is told to end goes the same way out as one that is interrupted, and tidies up
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    options = _parser().parse_args(arguments)
    command: Callable[[argparse.Namespace], int] = options.command
    try:
        code = command(options)
        sys.stdout.flush()
        return code
    except HullformError as error:
        return _refuse(error)
    except KeyboardInterrupt:
        _clear_progress()
        print("interrupted; nothing was left half-written", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # whoever read the output has gone; what is left of it goes nowhere, quietly
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE
    except OSError as error:
        return _refuse(error)
    except Exception as error:
        from hullvib.errors import HullvibError

        if isinstance(error, HullvibError):
            return _refuse(error)
        raise


def _refuse(error: Exception) -> int:
    _clear_progress()
    print(error, file=sys.stderr)
    return WRONG_INPUT


def _run(options: argparse.Namespace) -> int:
    from hullform.files import check_replaceable
    from hullform.pipeline import run_ship
    from hullform.ship import read_ship
    from hullform.terminal import summary
    from hullform.writing import write_run

    ship = read_ship(options.ship)
    folder = options.output or ship.path.parent / "results"
    check_replaceable(folder, ship.files, options.force)
    run = run_ship(ship, _progress)
    write_run(run, folder, _progress)
    _clear_progress()
    print(summary(run))
    print(f"\nreport: {folder / 'report.html'}")
    return _doubts(run.doubts)


def _trace(options: argparse.Namespace) -> int:
    from hullform.files import refuse_inputs
    from hullform.offsets import write_offsets
    from hullform.pipeline import read_form, reading_step
    from hullform.ship import read_ship

    ship = read_ship(options.ship)
    if options.overlay:
        # there is something to draw over
        _ = ship.picture
    output = options.output or ship.path.parent / "offsets.csv"
    for file in (output, options.overlay or output):
        refuse_inputs(file, ship.files)
    _progress(reading_step(ship))
    body_plan, reading = read_form(ship)
    if options.overlay and reading is not None:
        from hullform.picture.overlay import write_overlay

        write_overlay(reading, options.overlay)
    write_offsets(body_plan, output)
    _clear_progress()
    print(f"{len(body_plan.stations)} stations: {output}")
    for note in body_plan.notes:
        print(f"note: {note}")
    return _doubts(body_plan.doubts)


def _review(options: argparse.Namespace) -> int:
    from hullform.review.serving import serve_review
    from hullform.ship import read_ship

    def say(address: str) -> None:
        _clear_progress()
        print(f"review of {ship.path}: {address}\nPress Ctrl-C here to end it.", flush=True)

    ship = read_ship(options.ship)
    _progress("opening the picture")
    try:
        serve_review(ship, options.port, not options.no_browser, say)
    except KeyboardInterrupt:
        # this is how a review ends; what was not saved, the page has warned of
        _clear_progress()
    print("review ended", file=sys.stderr)
    return DONE


def _mesh(options: argparse.Namespace) -> int:
    from hullform.files import refuse_inputs
    from hullform.hull.crossings import doubts_of_crossing
    from hullform.hull.mesh_files import export_mesh
    from hullform.pipeline import hull_of, reading_step, trace
    from hullform.ship import read_ship

    ship = read_ship(options.ship)
    output = options.output or ship.path.parent / "hull.stl"
    refuse_inputs(output, ship.files)
    _progress(reading_step(ship))
    body_plan = trace(ship)
    _progress("fitting sections and lofting the hull")
    hull = hull_of(ship, body_plan)
    export_mesh(hull, output)
    mesh = hull.mesh()
    _clear_progress()
    print(f"hull of {hull.volume_m3:.6g} m3 to the deck: {output}")
    return _doubts((*body_plan.doubts, *hull.doubts, *doubts_of_crossing(mesh.vertices, mesh.faces)))


def _girder(options: argparse.Namespace) -> int:
    from hullform.afloat import load_ship
    from hullform.files import refuse_inputs
    from hullform.pipeline import hull_of, reading_step, trace
    from hullform.ship import read_ship
    from hullvib.girder_files import write_girder

    ship = read_ship(options.ship)
    wanted = ship.require_condition(options.condition)
    ship.require_sections_of_a_run()
    output = options.output or ship.path.parent / f"girder-{options.condition}.json"
    refuse_inputs(output, ship.files)
    _progress(reading_step(ship))
    body_plan = trace(ship)
    hull = hull_of(ship, body_plan)
    afloat = load_ship(ship, hull)
    (condition,) = (found for found in afloat.conditions if found.condition is wanted)
    girder = condition.girder
    write_girder(girder, output)
    _clear_progress()
    print(f"girder of {girder.total_mass / 1e3:.6g} t over {girder.length:g} m: {output}")
    failed = [check.doubt for check in (*afloat.checks, *condition.checks) if not check.ok]
    return _doubts((*body_plan.doubts, *hull.doubts, *failed))


def _doubts(doubts: Sequence[str]) -> int:
    sys.stdout.flush()
    for doubt in doubts:
        print(f"doubt: {doubt}", file=sys.stderr)
    return DOUBTS if doubts else DONE


def _progress(step: str) -> None:
    """Say on a terminal what is being done; silent in a pipe."""
    if sys.stderr.isatty():
        print(f"\r\033[K{step} ...", end="", file=sys.stderr, flush=True)


def _clear_progress() -> None:
    if sys.stderr.isatty():
        print("\r\033[K", end="", file=sys.stderr, flush=True)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="hullform",
        description="From a picture of a ship's body plan to her hull-girder vibration.",
        epilog="Exit codes: 0 done, 1 the input is wrong, 2 usage, 3 done with doubts, 130 interrupted.",
    )
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)

    def add(name: str, command: Callable[[argparse.Namespace], int], help: str) -> argparse.ArgumentParser:
        added = commands.add_parser(name, help=help, description=help)
        added.add_argument(
            "ship",
            type=Path,
            metavar="SHIP.toml",
            help="the ship's particulars and her form",
        )
        added.set_defaults(command=command)
        return added

    run = add("run", _run, "from the picture, or what stands for it, to frequencies, with a report")
    run.add_argument("-o", "--output", type=Path, metavar="DIR", help="default: results beside SHIP.toml")
    run.add_argument("--force", action="store_true", help="replace DIR and all it holds, even what no run wrote")
    trace = add("trace", _trace, "write the stations' curves, as read from the picture or mesh, as an offsets table")
    trace.add_argument("-o", "--output", type=Path, metavar="FILE", help="default: offsets.csv beside SHIP.toml")
    trace.add_argument("--overlay", type=Path, metavar="FILE", help="also draw what was read over the picture")
    review = add("review", _review, "see and mend what is read from the picture, on a page of this machine")
    review.add_argument("--port", type=int, default=0, metavar="N", help="of 127.0.0.1; default: a free one")
    review.add_argument("--no-browser", action="store_true", help="print the page's address only")
    mesh = add("mesh", _mesh, "loft the hull and write it as a mesh")
    mesh.add_argument(
        "-o", "--output", type=Path, metavar="FILE", help="hull.stl beside SHIP.toml by default; .obj .ply .glb too"
    )
    girder = add("girder", _girder, "write m(x) and EI(x) of one loading condition")
    girder.add_argument("--condition", required=True, metavar="NAME", help="a condition of SHIP.toml")
    girder.add_argument("-o", "--output", type=Path, metavar="FILE", help="default: girder-NAME.json beside SHIP.toml")
    return parser


if __name__ == "__main__":
    sys.exit(main())
