"""Files and folders that appear whole or not at all: written aside, then renamed."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from hullform.errors import OutputError

RESULTS_NAME = "results.json"
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


def check_replaceable(folder: Path, inputs: tuple[Path, ...], force: bool) -> None:
    """Refuse to write results over a folder that is not ours, before any work is done.

    Args:
        folder: where results will go.
        inputs: files that the run reads; a folder that holds one is never replaced.
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
    if not force and any(folder.iterdir()) and not _is_ours(folder):
        raise OutputError(
            f"{folder}: holds files that are not results of ours; choose another folder with -o, "
            "or replace it whole with --force"
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
        if old.exists() and not folder.exists():
            old.replace(folder)
        raise OutputError(f"{folder}: cannot be written ({error.strerror}); choose another place with -o") from None
    finally:
        shutil.rmtree(aside, ignore_errors=True)
        shutil.rmtree(old, ignore_errors=True)


def _is_ours(folder: Path) -> bool:
    try:
        document = json.loads((folder / RESULTS_NAME).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return False
    provenance = document.get("provenance") if isinstance(document, dict) else None
    return isinstance(provenance, dict) and provenance.get("program") == PROGRAM
