"""What is wrong with a ship.toml, in one line a fault: where, which value, what to do."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel

# Keys that the format keeps for later: refused by name, so that nobody believes that they count.
RESERVED = {
    "body_plan": {"mesh", "offsets"},
    "water": {"depth_m"},
}

# Keys that somebody may well try: what to write in their place.
INSTEAD = {
    "station_names": "each half has names of its own: give aft_station_names and fore_station_names, as long as "
    "aft_stations_m and fore_stations_m",
}

HOW_TO_FIND = {
    "aft_perpendicular_m": "the length between perpendiculars differs from the length overall, so give the x of "
    "the aft perpendicular from the aft end",
    "schema": "begin the file with schema = 1",
}


def fault_line(fault: Mapping[str, Any], root: type[BaseModel]) -> str:
    """One line for one fault that pydantic found in a file of type `root`: where, which value, what to do."""
    places = list(fault["loc"])
    where = ".".join(str(place) for place in places) or "the file"
    kind = fault["type"]
    if kind == "extra_forbidden":
        return f"{where}: {_unknown_key(places, root)}"
    if kind == "missing":
        return f"{where}: is missing; {HOW_TO_FIND.get(str(places[-1]), 'add it')}"
    message = fault["msg"].removeprefix("Value error, ")
    if kind == "value_error":
        return f"{where}: {message}"
    return f"{where} = {fault['input']!r}: {message[0].lower()}{message[1:]}"


def _unknown_key(places: list[Any], root: type[BaseModel]) -> str:
    keys = [str(place) for place in places if isinstance(place, str)]
    key, table = keys[-1], keys[0] if len(keys) > 1 else ""
    if key in RESERVED.get(table, set()):
        return "is reserved for a later version and has no effect yet; remove it"
    if table == "body_plan" and key in INSTEAD:
        return INSTEAD[key]
    model = root
    for name in keys[:-1]:
        model = _tables_of(model)[name]
    known = [field.alias or name for name, field in model.model_fields.items()]
    near = difflib.get_close_matches(key, known, n=1)
    return f"unknown key; did you mean '{near[0]}'?" if near else f"unknown key; known here: {', '.join(known)}"


def _tables_of(model: type[BaseModel]) -> dict[str, type[BaseModel]]:
    """The tables within a table, by their names in the file."""
    found: dict[str, type[BaseModel]] = {}
    for name, field in model.model_fields.items():
        stack: list[Any] = [field.annotation]
        while stack:
            annotation = stack.pop()
            if isinstance(annotation, type) and issubclass(annotation, BaseModel):
                found[field.alias or name] = annotation
            stack += getattr(annotation, "__args__", ())
    return found
