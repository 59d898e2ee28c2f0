"""Reference data that lie outside the repository."""

import json
import os
from pathlib import Path

import pytest

FOLDER = Path(os.environ.get("HULLFORM_SHARED", Path(__file__).parents[3] / "shared"))


def reference(name):
    """One file of reference/ as Python objects; skips where it is not at hand."""
    source = FOLDER / "reference" / name
    if not source.is_file():
        pytest.skip(f"{source}: not present; HULLFORM_SHARED names the folder that holds reference/")
    return json.loads(source.read_text(encoding="utf-8"))
