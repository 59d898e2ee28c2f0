"""The schema that is shipped is the one that the types make. Mend with: python scripts/write_results_schema.py"""

from __future__ import annotations

import json
from importlib.resources import files

from jsonschema import Draft202012Validator

from hullform.records import json_schema


def test_the_shipped_schema_is_current() -> None:
    shipped = json.loads(files("hullform").joinpath("results.schema.json").read_text(encoding="utf-8"))
    Draft202012Validator.check_schema(shipped)
    assert shipped == json_schema()
