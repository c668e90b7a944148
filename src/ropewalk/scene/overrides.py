"""Changing single values of a scene from text: ``rope.segments=80``."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import Any, TypeVar

from ropewalk.scene.base import Model
from ropewalk.scene.checks import nearest
from ropewalk.scene.errors import NO_VALUE, Fault, SceneError, join
from ropewalk.scene.files import as_table, plain, scene_table
from ropewalk.scene.paths import ModelType, by_tag, keys, kind_of, siblings, tag, toml_name
from ropewalk.scene.run_settings import RunSettings
from ropewalk.scene.scene import Scene

M = TypeVar("M", bound=Model)
#: Free texts, in which "none" is a word like others.
_TEXTS = {"name", "description"}
_STEP = re.compile(r"([^.\[\]=\s]+)((?:\[\d+\])*)")


def apply_overrides(scene: Scene, overrides: Iterable[str]) -> Scene:
    """A scene with some values changed.

    Each override is ``path=value``. ``rope.segments=80`` changes every rope,
    ``rope[1].segments=80`` or ``rope.left.segments=80`` (by its name) one of them; the same goes
    for anchors, winches, loads and kicks. The keys of ``[run]`` need no prefix:
    ``time_step=0.001``. A value is read as TOML and, where it is none, taken as text, so that
    ``method=rk4`` needs no quotes. ``none`` takes an optional value or table away, so that
    it has its default again.

    Changing ``segments`` of a rope of springs keeps their ``segment_length``: the rope becomes
    longer. A rope of a material keeps its length.

    Raises:
        SceneError: with every override that names nothing, and every fault of the new scene.
    """
    return _changed(scene, scene_table(scene), [partial(_split, text) for text in overrides])


def replaced(model: M, changes: Mapping[str, Any]) -> M:
    """A model with some values changed, each named by its path below the model, values as in Python.

    Raises:
        SceneError: with every path that names nothing, and every fault of the new model.
    """
    table = scene_table(model) if isinstance(model, Scene) else as_table(model)
    pairs = [partial(_named, path, value) for path, value in changes.items()]
    return _changed(model, table, pairs)


_Change = Callable[[], tuple[list[str | int], Any]]


def _changed(model: M, table: dict[str, Any], changes: Iterable[_Change]) -> M:
    """The model that a table makes once some values are set."""
    faults: list[Fault] = []
    for change in changes:
        try:
            path, value = change()
            for owner, key, part in _targets(type(model), table, path):
                _set(owner, key, part, value)
        except SceneError as error:
            faults += error.faults
    if faults:
        raise SceneError(faults)
    return type(model).model_validate(table)


def _named(path: str, value: Any) -> tuple[list[str | int], Any]:
    """The steps of a path and its value, models as tables."""
    return _steps(path), plain(value)


def _fault(path: str, rule: str) -> SceneError:
    return SceneError([Fault(path, NO_VALUE, rule)])


def _split(override: str) -> tuple[list[str | int], Any]:
    """The steps of the path and the value."""
    path, equals, text = override.partition("=")
    path, text = path.strip(), text.strip()
    if not equals or not path:
        raise _fault(f'"{override}"', "must be written as path=value, such as rope.segments=80")
    steps = _steps(path)
    if steps[0] in RunSettings.model_fields:
        steps.insert(0, "run")
    return steps, _value(text)


def _steps(path: str) -> list[str | int]:
    """The steps of a path: keys, names and numbers."""
    steps: list[str | int] = []
    for part in path.split("."):
        found = _STEP.fullmatch(part)
        if found is None:
            raise _fault(path, "is no path; write it as rope.segments or rope[0].load[1].mass")
        steps.append(found[1])
        steps += [int(index) for index in re.findall(r"\d+", found[2])]
    return steps


def _value(text: str) -> Any:
    """The value that a text stands for: TOML where it is, else the text itself."""
    try:
        table = tomllib.loads(f"value = {text}")
    except (ValueError, RecursionError):  # ValueError: also of numbers with too many digits
        return text
    return table["value"] if len(table) == 1 else text


# What an earlier path of the same call has put there.
_WHOLE = "was set to a value without keys before; leave that out, or set it whole"

_Target = tuple[dict[str, Any], str, ModelType]


def _targets(root: ModelType, table: dict[str, Any], steps: list[str | int]) -> Iterator[_Target]:
    """Every table, key and model that a path below a root leads to."""
    places: list[tuple[dict[str, Any], ModelType, str]] = [(table, root, "")]
    rest = list(steps)
    while True:
        key = _as_in_toml(places, rest.pop(0))
        places = [_known(place, key) for place in places]
        if not rest:
            for owner, model, _ in places:
                yield owner, str(key), model
            return
        places, rest = _descend(places, str(key), rest)


def _as_in_toml(places: list[tuple[dict[str, Any], ModelType, str]], key: str | int) -> str | int:
    """The key in TOML of one that may be a field's name in Python: ``ropes`` is ``rope``."""
    for _, model, _ in places:
        if isinstance(key, str) and key in model.model_fields:
            return toml_name(key, model.model_fields[key])
    return key


def _known(
    place: tuple[dict[str, Any], ModelType, str], key: str | int
) -> tuple[dict[str, Any], ModelType, str]:
    """The same place, after a check that its model has the key."""
    _, model, path = place
    known = keys(model)
    if isinstance(key, int) or key not in known:
        rule = f"unknown key; {nearest(str(key), list(known))}"
        others = [tag(one) for one in siblings(model) if key in keys(one)]
        if others:
            rule = f"{tag(model)!r} has no such key, {others[0]!r} has: set {path}.kind too"
        raise _fault(join(path, str(key)), rule)
    return place


def _descend(
    places: list[tuple[dict[str, Any], ModelType, str]], key: str, rest: list[str | int]
) -> tuple[list[tuple[dict[str, Any], ModelType, str]], list[str | int]]:
    """Go from tables into what stands there under a key; returns what is left of the path."""
    below: list[tuple[dict[str, Any], ModelType, str]] = []
    left = rest
    for owner, model, path in places:
        kind = kind_of(keys(model)[key])
        here = join(path, key)
        if not kind.models:
            raise _fault(here, "holds a value of its own; set it whole")
        if not kind.listed:
            if isinstance(rest[0], int):
                raise _fault(f"{here}[{rest[0]}]", f"there is only one; write {here}")
            inner = owner.setdefault(key, {})
            if not isinstance(inner, dict):
                raise _fault(here, _WHOLE)
            below.append((inner, _model(kind.models, inner, here), here))
            continue
        chosen, left = _choose(owner.get(key, []), kind.models[0], here, rest)
        below += [(item, kind.models[0], spot) for item, spot in chosen]
    return below, left


def _model(models: tuple[ModelType, ...], inner: dict[str, Any], path: str) -> ModelType:
    """The model that a table is of; a table not there yet starts as the first kind."""
    model = by_tag(models, inner.setdefault("kind", tag(models[0])) if len(models) > 1 else None)
    if model is None:
        kinds = ", ".join(str(tag(one)) for one in models)
        raise _fault(join(path, "kind"), f"must be one of {kinds}")
    return model


def _choose(
    items: list[dict[str, Any]], model: ModelType, path: str, rest: list[str | int]
) -> tuple[list[tuple[dict[str, Any], str]], list[str | int]]:
    """The items of a list that the next step of a path means: one by index or name, else all."""
    if not isinstance(items, list) or not all(isinstance(item, dict) for item in items):
        raise _fault(path, _WHOLE)
    spots = [(item, f"{path}[{i}]") for i, item in enumerate(items)]
    if not items:
        raise _fault(path, "the scene has none")
    step = rest[0]
    if isinstance(step, int):
        if step >= len(items):
            raise _fault(f"{path}[{step}]", f"must be from 0 to {len(items) - 1}")
        if len(rest) == 1:
            raise _fault(f"{path}[{step}]", "give a key of it too")
        return [spots[step]], rest[1:]
    named = [spot for spot in spots if spot[0].get("name") == step]
    if named and len(rest) > 1 and step not in keys(model):
        return named, rest[1:]
    if step not in keys(model) and len(rest) > 1:
        names = [str(item["name"]) for item in items if "name" in item]
        raise _fault(f"{path}.{step}", f"no such name or key; {nearest(step, names)}")
    return spots, rest


def _set(owner: dict[str, Any], key: str, model: ModelType, value: Any) -> None:
    """Put a value into a table; a new kind drops the keys that it does not know."""
    field = keys(model)[key]
    if isinstance(value, str) and value == "none" and not field.is_required() and key not in _TEXTS:
        owner.pop(key, None)
        return
    if key == "kind" and value != owner.get("kind"):
        _change_kind(owner, model, value)
    owner[key] = value


def _change_kind(owner: dict[str, Any], model: ModelType, value: Any) -> None:
    chosen = by_tag(siblings(model), value)
    if chosen is not None:
        for key in set(owner) - set(keys(chosen)):
            del owner[key]
