"""Quantities of scene files and flags as they were written, with their units, and the numbers they became."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from ropewalk.scene.base import Model, unit_of, units_of
from ropewalk.scene.faults import SceneError, join
from ropewalk.scene.overrides import Places
from ropewalk.scene.paths import toml_name
from ropewalk.scene.scene import Scene
from ropewalk.scene.toml_text import as_value
from ropewalk.scene.units import in_unit

_MOST = 4  # parts of a list that are shown


class AsGiven(NamedTuple):
    """One quantity: where, as it was written, and the number of the scene with its unit."""

    path: str
    given: str
    stored: str

    def __str__(self) -> str:
        return f"{self.path} = {self.given}, {self.stored}"


def as_given(file: str | Path, scene: Scene, flags: Iterable[str] = ()) -> list[AsGiven]:
    """Return the quantities that a scene file, or flags, give with a unit of their own.

    Args:
        file: the scene's; nothing is found in what is none.
        scene: read from it. What has been changed since is left out.
        flags: that changed it, as `apply_overrides` takes them.
    """
    try:
        table = tomllib.loads(Path(file).read_text(encoding="utf-8-sig"))
    except (OSError, ValueError):
        table = {}
    pairs = [flag.partition("=")[::2] for flag in flags]
    found = {
        one.path: one
        for path, text in pairs
        for one in _of_flag(scene, path.strip(), as_value(text.strip()))
    }
    return [one for one in _quantities(scene, table, "") if one.path not in found] + [
        *found.values()
    ]


def _of_flag(scene: Scene, path: str, given: Any) -> Iterator[AsGiven]:
    """Return the quantities that a flag gives a path, which still stand there and have a unit."""
    if isinstance(given, Mapping):
        for key, part in given.items():
            yield from _of_flag(scene, f"{path}.{key}", part)
        return
    if isinstance(given, list) and given and isinstance(given[0], Mapping):
        for i, part in enumerate(given):
            yield from _of_flag(scene, f"{path}[{i}]", part)
        return
    try:
        places = Places(scene, [path])
    except SceneError:  # of what a later flag has taken away
        return
    field, where = places.field(0)
    stored, unit = places.value(0), unit_of(field)
    if unit and _with_unit(given) and _same(in_unit(given, unit), stored):
        yield AsGiven(where, _shown(given), _with(unit, stored))


def _same(given: Any, stored: Any) -> bool:
    """Tell whether two values are the same, be they lists or tuples."""
    if isinstance(given, list | tuple) and isinstance(stored, list | tuple):
        return len(given) == len(stored) and all(map(_same, given, stored))
    return bool(given == stored)


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
            yield AsGiven(here, _shown(given), _with(units[name], value))


def _with_unit(given: Any) -> bool:
    if isinstance(given, list):
        return any(_with_unit(part) for part in given)
    return isinstance(given, str) and given.strip()[:1] in tuple("0123456789+-.")


def _with(unit: str, value: Any) -> str:
    """Return a stored value with its unit; a plain number has none."""
    return _shown(value) if unit == "1" else f"{_shown(value)} {unit}"


def _shown(value: Any) -> str:
    if isinstance(value, list | tuple):
        more = ", ..." if len(value) > _MOST else ""
        return f"({', '.join(_shown(part) for part in value[:_MOST])}{more})"
    return value if isinstance(value, str) else f"{value:.6g}"
