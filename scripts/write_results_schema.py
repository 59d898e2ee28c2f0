"""Write src/hullform/results.schema.json anew from the types of hullform.records. Run after changing them."""

from __future__ import annotations

import json
from pathlib import Path

from hullform.records import json_schema

PATH = Path(__file__).parent.parent / "src" / "hullform" / "results.schema.json"

if __name__ == "__main__":
    PATH.write_text(json.dumps(json_schema(), indent=1) + "\n", encoding="utf-8")
