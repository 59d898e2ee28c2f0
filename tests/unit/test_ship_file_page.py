"""docs/ship-file.md against the model that reads ship.toml: every key stands there, and its examples are accepted."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any, get_args

import pytest
from form_ship import SHIP, form_ship
from pydantic import BaseModel
from pydantic.fields import FieldInfo

from hullform import Hull, trace
from hullform.ship import Ship, ShipType, read_ship
from hullform.ship_body_plan import MeshSource, ParticularsSource

PAGE = (Path(__file__).parents[2] / "docs" / "ship-file.md").read_text(encoding="utf-8")
EXAMPLE = re.compile(r"<!-- example: (\w+) -->\n```toml\n(.*?)```", re.DOTALL)
BLOCKS = [(kind, tomllib.loads(text)) for kind, text in EXAMPLE.findall(PAGE)]
WHOLE_FILES = [document for kind, document in BLOCKS if kind == "ship"]
STRUCTURES = [document for kind, document in BLOCKS if kind == "structure"]
LOADED = [document for kind, document in BLOCKS if kind == "condition"]
MESHES = [document for kind, document in BLOCKS if kind == "mesh"]
TABLES_OF_OFFSETS = re.findall(r"<!-- file: \S+\.csv -->\n```csv\n(.*?)```", PAGE, re.DOTALL)
IN_SERVICE = [document for kind, document in BLOCKS if kind == "service"]
CALIBRATIONS = [document for kind, document in BLOCKS if kind == "calibration"]


def models_in(annotation: Any) -> list[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for part in get_args(annotation) for model in models_in(part)]


def keys_by_table(model: type[BaseModel], table: str = "") -> dict[str, dict[str, FieldInfo]]:
    """The keys of every table, by its path in the file."""
    found: dict[str, dict[str, FieldInfo]] = {table: {}}
    for name, field in model.model_fields.items():
        key = field.alias or name
        found[table][key] = field
        for inner in models_in(field.annotation):
            # a table may be of several kinds
            for inner_table, keys in keys_by_table(inner, f"{table}.{key}".lstrip(".")).items():
                found[inner_table] = found.get(inner_table, {}) | keys
    return found


TABLES = keys_by_table(Ship)


def section(table: str) -> str:
    """The page's text on one table: from its heading to the next of the same rank."""
    heading = (
        "At the top" if not table else next(h for h in (f"`[{table}]`", f"`[[{table}]]`") if f"\n## {h}\n" in PAGE)
    )
    return PAGE.split(f"\n## {heading}\n")[1].split("\n## ")[0]


def rows(text: str) -> dict[str, str]:
    """Rows of the tables of a text, by the key in their first cell."""
    return dict(re.findall(r"^\| `([\w-]+)` \| (.*)$", text, re.MULTILINE))


# the points' keys stand in the section of the calibration
IN_SECTION_OF = {"body_plan.calibration.points": "body_plan.calibration"}
KEYS = [
    pytest.param(IN_SECTION_OF.get(table, table), key, field, id=f"{table}.{key}")
    for table, keys in TABLES.items()
    for key, field in keys.items()
    if table or key not in TABLES
]


@pytest.mark.parametrize(("table", "key", "field"), KEYS)
def test_every_key_of_the_model_has_a_row_with_its_default(table: str, key: str, field: FieldInfo) -> None:
    default = rows(section(table))[key].split(" | ")[1]
    # the one key whose need hangs on two others is required in the model and says so in its row
    assert ("required" in default) == field.is_required()
    if isinstance(field.default, int | float):
        assert float(default) == field.default


def test_no_row_names_a_key_that_is_refused() -> None:
    known = [parameters.values[:2] for parameters in KEYS]
    for table in {table for table, _ in known}:
        text = section(str(table)).split("### Types")[0]
        assert set(rows(text)) <= {key for where, key in known if where == table}


@pytest.mark.parametrize("table", TABLES)
def test_every_table_has_a_section(table: str) -> None:
    assert len(section(IN_SECTION_OF.get(table, table)).split()) > 3


def test_the_page_lists_every_type_and_no_other() -> None:
    assert list(rows(PAGE.split("### Types")[1].split("\n## ")[0])) == list(get_args(ShipType))


def test_the_whole_example_is_accepted() -> None:
    (document,) = WHOLE_FILES
    ship = Ship.model_validate(document)
    # LOA differs from LPP, so this one key must be given
    assert ship.particulars.aft_perpendicular_m > 0
    ship.require_sections_of_a_run()
    del document["ship"]["aft_perpendicular_m"]
    with pytest.raises(ValueError, match="aft_perpendicular_m"):
        Ship.model_validate(document)


@pytest.mark.parametrize("given", CALIBRATIONS)
def test_the_calibrations_are_accepted_with_the_whole_example(given: dict[str, Any]) -> None:
    document = tomllib.loads(EXAMPLE.findall(PAGE)[-1][1])
    document["body_plan"] |= given["body_plan"]
    assert Ship.model_validate(document).picture.calibration is not None


def test_the_mesh_is_accepted_in_place_of_the_picture() -> None:
    document = tomllib.loads(EXAMPLE.findall(PAGE)[-1][1])
    (given,) = MESHES
    assert isinstance(Ship.model_validate(document | given).body_plan, MeshSource)


def test_without_a_source_the_form_is_of_the_particulars() -> None:
    document = tomllib.loads(EXAMPLE.findall(PAGE)[-1][1])
    del document["body_plan"]
    assert isinstance(Ship.model_validate(document).body_plan, ParticularsSource)


@pytest.mark.parametrize("table", TABLES_OF_OFFSETS, ids=["points", "waterlines"])
def test_the_tables_of_offsets_are_read(tmp_path: Path, table: str) -> None:
    # the first shows two stations of a ship that has more
    more = "118.0,0.0,0.5\n118.0,4.4,9.0\n" if table.startswith("station_x_m") else ""
    (tmp_path / "table.csv").write_text(table + more, encoding="utf-8")
    ship = SHIP.replace("length_overall_m = 190.0", "length_overall_m = 120.0")
    ship = ship.replace("length_between_perpendiculars_m = 182.0", "length_between_perpendiculars_m = 114.0")
    ship = ship.replace("breadth_m = 30.0", "breadth_m = 22.0").replace("depth_m = 17.0", "depth_m = 9.0")
    ship = ship.replace("draught_m = 11.0", "draught_m = 6.5")
    body_plan = trace(form_ship(tmp_path, '[body_plan]\noffsets = "table.csv"\n', ship))
    assert body_plan.doubts == ()
    assert Hull.from_body_plan(body_plan, read_ship(tmp_path / "ship.toml").particulars).volume_m3 > 0


def test_the_structure_is_accepted_for_a_ship_of_its_size() -> None:
    document = tomllib.loads(EXAMPLE.findall(PAGE)[-1][1])
    document["ship"] |= {"length_overall_m": 262.0, "breadth_m": 32.2}
    (given,) = STRUCTURES
    structure = Ship.model_validate(document | given).structure
    assert structure is not None
    assert not structure.is_plain_shell


def test_the_list_of_weights_is_accepted_with_the_whole_example() -> None:
    document = tomllib.loads(EXAMPLE.findall(PAGE)[-1][1])
    (given,) = LOADED
    (condition,) = Ship.model_validate(document | given).conditions
    assert {item.shape for item in condition.items} == {"sectional-area", "trapezoid", "table"}


def test_propeller_engine_and_waves_are_accepted_with_the_whole_example() -> None:
    document = tomllib.loads(EXAMPLE.findall(PAGE)[-1][1])
    (given,) = IN_SERVICE
    ship = Ship.model_validate(document | given)
    assert ship.excitation is not None
    assert ship.excitation.orders == (1.0, 2.0)
    assert ship.operation is not None


def test_both_ways_of_calibrating_are_shown() -> None:
    assert [set(given["body_plan"]["calibration"]) for given in CALIBRATIONS] == [
        {"points"},
        {"centreline_px", "baseline_px", "metres_per_px", "rotation_deg"},
    ]
