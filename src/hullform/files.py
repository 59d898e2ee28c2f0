"""Files and folders that appear whole or not at all: written aside, then renamed."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from fnmatch import fnmatch
from pathlib import Path

from hullform.errors import OutputError

RESULTS_NAME = "results.json"
# Everything that a run writes into its folder.
RESULT_NAMES = (RESULTS_NAME, "report.html", "hull.stl", "offsets.csv", "girder-*.json", "figures")
PROGRAM = "hullform"


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """Give a path to write to; it becomes `path` when the block ends well and vanishes when it does not.

    The path to write to has the same suffix as `path`.

    Raises:
        OutputError: the file cannot be written there.
    """
    aside = path.with_name(f".{path.stem}-{os.getpid()}{path.suffix}")
    try:
        aside.touch()
    except OSError as error:
        raise OutputError(f"{path}: cannot be written ({error.strerror}); choose another place with -o") from None
    try:
        yield aside
        aside.replace(path)
    except OSError as error:
        raise OutputError(f"{path}: cannot be written ({error.strerror}); choose another place with -o") from None
    finally:
        aside.unlink(missing_ok=True)


def refuse_inputs(output: Path, inputs: tuple[Path, ...]) -> None:
    """Refuse to write a file over one that the command reads.

    Raises:
        OutputError: names the file.
    """
    for path in inputs:
        if output.resolve() == path.resolve():
            raise OutputError(f"{output}: is what this command reads; choose another file with -o")


def check_replaceable(folder: Path, inputs: tuple[Path, ...], force: bool) -> None:
    """Refuse to write results over a folder that holds anything but results, before any work is done.

    Args:
        folder: where results will go.
        inputs: files that the run reads; a folder that holds one is never replaced, nor is one under version control.
        force: replace a folder of others too.

    Raises:
        OutputError: says why and what to do.
    """
    here = folder.resolve()
    for path in inputs:
        if here in path.resolve().parents:
            raise OutputError(f"{folder}: holds {path.name}, which this run reads; choose another folder with -o")
    if not folder.exists():
        return
    if not folder.is_dir():
        raise OutputError(f"{folder}: is a file; choose a folder with -o")
    if (folder / ".git").exists():
        raise OutputError(f"{folder}: is under version control and is not replaced; choose another folder with -o")
    foreign = _foreign_names(folder)
    if foreign and not force:
        raise OutputError(
            f"{folder}: holds {', '.join(foreign[:3])}{' and more' if len(foreign) > 3 else ''}, which no run wrote; "
            "move that away, choose another folder with -o, or replace the folder and all it holds with --force"
        )


@contextmanager
def whole_folder(folder: Path) -> Iterator[Path]:
    """Give an empty folder to fill; it replaces `folder` when the block ends well and vanishes when it does not.

    Raises:
        OutputError: the folder cannot be written there.
    """
    folder = folder.resolve()
    aside = folder.with_name(f".{folder.name}-{os.getpid()}")
    try:
        aside.mkdir(parents=True)
    except OSError as error:
        raise OutputError(f"{folder}: cannot be written ({error.strerror}); choose another place with -o") from None
    old = aside.with_name(aside.name + "-old")
    try:
        yield aside
        if folder.exists():
            folder.replace(old)
        aside.replace(folder)
    except OSError as error:
        raise OutputError(f"{folder}: cannot be written ({error.strerror}); choose another place with -o") from None
    finally:
        # interrupted between the two renames, the old results go back to their place
        if old.exists() and not folder.exists():
            old.replace(folder)
        shutil.rmtree(aside, ignore_errors=True)
        shutil.rmtree(old, ignore_errors=True)


def _foreign_names(folder: Path) -> list[str]:
    """What a folder holds that no run wrote; everything, where it holds no results.json of ours."""
    names = sorted(path.name for path in folder.iterdir())
    if names and not _holds_our_results(folder):
        return names
    return [name for name in names if not any(fnmatch(name, pattern) for pattern in RESULT_NAMES)]


def _holds_our_results(folder: Path) -> bool:
    try:
        document = json.loads((folder / RESULTS_NAME).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return False
    provenance = document.get("provenance") if isinstance(document, dict) else None
    return isinstance(provenance, dict) and provenance.get("program") == PROGRAM
