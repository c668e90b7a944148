"""Quantities of a scene file as they were written, with their units, beside the numbers that they became."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from ropewalk.scene.base import Model, units_of
from ropewalk.scene.faults import join
from ropewalk.scene.paths import toml_name
from ropewalk.scene.scene import Scene
from ropewalk.scene.units import in_unit

_MOST = 4  # parts of a list that are shown


class AsGiven(NamedTuple):
    """One quantity: where, as it was written, and the number of the scene with its unit."""

    path: str
    given: str
    stored: str

    def __str__(self) -> str:
        return f"{self.path} = {self.given}, {self.stored}"


def as_given(file: str | Path, scene: Scene) -> list[AsGiven]:
    """Return the quantities that a scene file gives with a unit of their own.

    Args:
        file: the scene's; nothing is found in what is none.
        scene: read from it. What has been changed since is left out.
    """
    try:
        table = tomllib.loads(Path(file).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return []
    return list(_quantities(scene, table, ""))


def _quantities(model: Model, table: Mapping[str, Any], path: str) -> Iterator[AsGiven]:
    units = units_of(type(model))
    names = {toml_name(name, field): name for name, field in type(model).model_fields.items()}
    for key, given in table.items():
        name = names.get(key, key)
        value, here = getattr(model, name, None), join(path, key)
        if isinstance(value, Model) and isinstance(given, Mapping):
            yield from _quantities(value, given, here)
        elif isinstance(value, tuple) and isinstance(given, list) and name not in units:
            for i, (one, part) in enumerate(zip(value, given, strict=False)):
                if isinstance(one, Model) and isinstance(part, Mapping):
                    yield from _quantities(one, part, f"{here}[{i}]")
        elif name in units and _with_unit(given) and in_unit(given, units[name]) == value:
            yield AsGiven(here, _shown(given), f"{_shown(value)} {units[name]}")


def _with_unit(given: Any) -> bool:
    if isinstance(given, list):
        return any(_with_unit(part) for part in given)
    return isinstance(given, str) and given.strip()[:1] in tuple("0123456789+-.")


def _shown(value: Any) -> str:
    if isinstance(value, list | tuple):
        more = ", ..." if len(value) > _MOST else ""
        return f"({', '.join(_shown(part) for part in value[:_MOST])}{more})"
    return value if isinstance(value, str) else f"{value:.6g}"
