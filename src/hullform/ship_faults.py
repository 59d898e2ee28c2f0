"""What is wrong with a ship.toml, in one line a fault: where, which value, what to do."""

from __future__ import annotations

import difflib
import itertools
from collections.abc import Mapping, Sequence
from typing import Any

from pydantic import BaseModel, Tag

# Keys that somebody may well try: what to write in their place.
INSTEAD = {
    "station_names": "each half has names of its own: give aft_station_names and fore_station_names, as long as "
    "aft_stations_m and fore_stations_m",
}

# Of a table that is of one kind alone.
ONLY_KIND = ""

HOW_TO_FIND = {
    "aft_perpendicular_m": "the length between perpendiculars differs from the length overall, so give the x of "
    "the aft perpendicular from the aft end",
    "schema": "begin the file with schema = 1",
    "image": "give the picture, or in its place a table (offsets) or a mesh; with none of the three, and no other key "
    "of a picture, the form is made of the main particulars",
}


def fault_lines(faults: Sequence[Mapping[str, Any]], root: type[BaseModel]) -> list[str]:
    """A line for each fault that pydantic found in a file of type `root`.

    A list of which every value is at fault is called too short on top of it: that goes without saying.
    """
    within = {tuple(fault["loc"][:-1]) for fault in faults}
    return [
        fault_line(fault, root)
        for fault in faults
        if not (fault["type"] == "too_short" and tuple(fault["loc"]) in within)
    ]


def fault_line(fault: Mapping[str, Any], root: type[BaseModel]) -> str:
    """One line for one fault that pydantic found in a file of type `root`: where, which value, what to do."""
    places = list(fault["loc"])
    where = ".".join(str(place) for place in _as_written(places, root))
    kind = fault["type"]
    if kind == "extra_forbidden":
        return f"{where}: {_unknown_key(places, root)}"
    if kind == "missing":
        return f"{where}: is missing; {HOW_TO_FIND.get(str(places[-1]), 'add it')}"
    message = fault["msg"].removeprefix("Value error, ")
    if kind == "value_error":
        return f"{where}: {message}" if where else message
    if kind == "too_short":
        least = fault["ctx"]["min_length"]
        return f"{where} has {fault['ctx']['actual_length']} values; give {'one' if least == 1 else least} or more"
    if kind == "string_pattern_mismatch" and places[0] == "conditions":
        return f"{where} = {fault['input']!r}: is a part of file names; write it with a to z, 0 to 9 and '-' alone"
    return f"{where} = {fault['input']!r}: {message[0].lower()}{message[1:]}"


def _unknown_key(places: list[Any], root: type[BaseModel]) -> str:
    keys = [str(place) for place in places if isinstance(place, str)]
    key, table = keys[-1], keys[0] if len(keys) > 1 else ""
    if table == "body_plan" and key in INSTEAD:
        return INSTEAD[key]
    model, models, names = root, [root], iter(keys[:-1])
    for name in names:
        kinds = _tables_of(model)[name]
        model = kinds[ONLY_KIND] if ONLY_KIND in kinds else kinds[next(names)]
        models = [model, *(other for other in kinds.values() if other is not model)]
    known = [[field.alias or name for name, field in kind.model_fields.items()] for kind in models]
    # the kind that was meant goes before the others of its table
    for some in known:
        if near := difflib.get_close_matches(key, some, n=1):
            return f"unknown key; did you mean '{near[0]}'?"
    return f"unknown key; known here: {', '.join(dict.fromkeys(itertools.chain(*known)))}"


def _as_written(places: list[Any], root: type[BaseModel]) -> list[Any]:
    """Where a fault is in the file: without the tag by which the kinds of a table are told apart."""
    kinds = _tables_of(root).get(str(places[0]), {}) if places else {}
    return [place for i, place in enumerate(places) if not (i == 1 and place in kinds)]


def _tables_of(model: type[BaseModel]) -> dict[str, dict[str, type[BaseModel]]]:
    """The tables within a table, by their names in the file and the tags of their kinds."""
    found: dict[str, dict[str, type[BaseModel]]] = {}
    for name, field in model.model_fields.items():
        stack: list[tuple[Any, str]] = [(field.annotation, ONLY_KIND)]
        while stack:
            annotation, tag = stack.pop()
            if isinstance(annotation, type) and issubclass(annotation, BaseModel):
                found.setdefault(field.alias or name, {})[tag] = annotation
            tags = [item.tag for item in getattr(annotation, "__metadata__", ()) if isinstance(item, Tag)]
            inner = [annotation.__origin__] if tags else getattr(annotation, "__args__", ())
            stack += [(part, tags[0] if tags else tag) for part in inner]
    return found
