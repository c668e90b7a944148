"""Models as nested tables with the keys of TOML."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel

from ropewalk.scene.paths import keys

#: Written even when they have their default value: without them a table says too little.
_ALWAYS = {"kind", "name", "schema_version", "method"}
#: Written wherever they were given: a rope of a given diameter keeps half of it from obstacles.
_WHERE_GIVEN = {"diameter"}


def as_table(model: BaseModel) -> dict[str, Any]:
    """A model as nested dicts and lists with TOML keys, defaults left out."""
    table: dict[str, Any] = {}
    derived: frozenset[str] = getattr(model, "derived", frozenset)()
    for (name, field), key in zip(type(model).model_fields.items(), keys(type(model)), strict=True):
        value = getattr(model, name)
        default = field.get_default()
        if value is None or name in derived or value == default == "":
            continue  # a name not given yet is none
        given = key in _WHERE_GIVEN and name in model.model_fields_set
        given = given or "method" in getattr(
            value, "model_fields_set", ()
        )  # said: no default of springs
        if key not in _ALWAYS and not given and value == default and repr(value) == repr(default):
            continue  # repr tells -0.0 from 0.0
        table[key] = plain(value)
    return table


def plain(value: Any) -> Any:
    """A value as TOML holds it: models as tables, tuples as lists."""
    if isinstance(value, BaseModel):
        return as_table(value)
    if isinstance(value, (tuple, list)):
        return [plain(item) for item in value]
    return value
