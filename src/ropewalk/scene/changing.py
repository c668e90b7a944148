"""Changing values of a model by the paths to them: ``rope.segments``, ``anchor[1].motion.speed``."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from ropewalk import library
from ropewalk.scene.faults import NO_VALUE, Fault, SceneError, join
from ropewalk.scene.model_table import plain
from ropewalk.scene.paths import (
    ModelType,
    by_tag,
    keys,
    kind_of,
    section_with,
    siblings,
    tag,
    toml_name,
)
from ropewalk.words.nearest import nearest

if TYPE_CHECKING:
    from ropewalk.scene.base import Model

M = TypeVar("M", bound="Model")
#: Free texts, in which "none" is a word like others.
_TEXTS = {"name", "description"}
#: What a file holds, which is in the table once it is read; another file takes its place.
_FROM_FILES = {
    *("vertices", "faces", "values", "spacing", "origin"),
    *("strain", "tension", "times", "positions", "points"),
}
#: Keys that take others away when they are set.
RENEWING = ("kind", "library", "file", "made_of")
#: What a material always has; where one of them is missing, the library gives it.
NEEDED = ("EA", "mass_per_length")
_STEP = re.compile(r"([^.\[\]=\s]+)((?:\[\d+\])*)")


def replaced(model: M, changes: Mapping[str, Any]) -> M:
    """A model with some values changed, each named by its path below the model, values as in Python.

    Raises:
        SceneError: with every path that names nothing, and every fault of the new model.
    """
    pairs = [partial(_named, path, value) for path, value in changes.items()]
    return changed(model, pairs)


_Change = Callable[[], tuple[list[str | int], Any]]


def changed(model: M, changes: Iterable[_Change]) -> M:
    """The model with some values set: each change gives the steps of a path, and a value."""
    table = model.as_said()
    found: list[tuple[list[str | int], Any]] = []
    faults: list[Fault] = []
    for change in changes:
        try:
            steps, value = change()
            first = _as_in_toml([(table, type(model), "")], steps[0])
            found.append(([first, *steps[1:]], value))
        except SceneError as error:
            faults += error.faults
    for steps, value in _renewing_first(found):
        try:
            for target in targets_of(type(model), table, steps):
                put(target, value)
        except SceneError as error:
            faults += error.faults
    if faults:
        raise SceneError(faults)
    return type(model).model_validate(table)


def _renewing_first(
    changes: Iterable[tuple[list[str | int], Any]],
) -> list[tuple[list[str | int], Any]]:
    """The changes, those first that take away what stands beside them, so that no other is lost.

    What makes the table that they are in, or names it, stays before them.
    """
    ordered: list[tuple[list[str | int], Any]] = []
    for steps, value in changes:
        at = len(ordered)
        if steps[-1] in RENEWING:
            while at and not _must_stay_before(ordered[at - 1][0], steps):
                at -= 1
        ordered.insert(at, (steps, value))
    return ordered


def _must_stay_before(one: list[str | int], renewing: list[str | int]) -> bool:
    if one[-1] in (*RENEWING, "name"):
        return True
    rest = iter([step for step in renewing[:-1] if isinstance(step, str)])
    return all(step in rest for step in one if isinstance(step, str))  # a table above it


def _named(path: str, value: Any) -> tuple[list[str | int], Any]:
    """The steps of a path and its value, models as tables."""
    return steps_of(path), plain(value)


def no_path(path: str, rule: str) -> SceneError:
    return SceneError([Fault(path, NO_VALUE, rule)])


def steps_of(path: str) -> list[str | int]:
    """The steps of a path: keys, names and numbers."""
    steps: list[str | int] = []
    for part in path.split("."):
        found = _STEP.fullmatch(part)
        if found is None:
            raise no_path(path, "is no path; write it as rope.segments or rope[0].load[1].mass")
        steps.append(found[1])
        steps += [int(index) for index in re.findall(r"\d+", found[2])]
    return steps


# What an earlier path of the same call has put there.
_WHOLE = "was set to a value without keys before; leave that out, or set it whole"


class Target(NamedTuple):
    """Where a path leads: a key of a table, or one component of the list that stands there."""

    owner: dict[str, Any]
    key: str
    model: ModelType
    path: str
    part: int | None = None
    above: dict[str, Any] | None = (
        None  # the table that `owner` stands in, where it is one of its keys
    )


def targets_of(root: ModelType, table: dict[str, Any], steps: list[str | int]) -> Iterator[Target]:
    """Every table, key and model that a path below a root leads to."""
    places: list[tuple[dict[str, Any], ModelType, str]] = [(table, root, "")]
    rest, above = list(steps), list[dict[str, Any]]()
    while True:
        key = _as_in_toml(places, rest.pop(0))
        places = [_known(place, key) for place in places]
        if not rest or (len(rest) == 1 and _is_vector(places, str(key), rest[0])):
            for i, (owner, model, path) in enumerate(places):
                part = int(rest[0]) if rest else None
                where = join(path, str(key)) + ("" if part is None else f"[{part}]")
                outer = (
                    above[i] if len(above) == len(places) else None
                )  # else there is a list between
                yield _checked(Target(owner, str(key), model, where, part, outer))
            return
        above = [owner for owner, _, _ in places]
        places, rest = _descend(places, str(key), rest)


def _as_in_toml(places: list[tuple[dict[str, Any], ModelType, str]], key: str | int) -> str | int:
    """The key in TOML of one that may be a field's name in Python: ``ropes`` is ``rope``."""
    for _, model, _ in places:
        if isinstance(key, str) and key in model.model_fields:
            return toml_name(key, model.model_fields[key])
    return key


def _is_vector(
    places: list[tuple[dict[str, Any], ModelType, str]], key: str, step: str | int
) -> bool:
    """Whether the last step is a component of a value such as [x, y, z]."""
    return isinstance(step, int) and all(not kind_of(keys(m)[key]).models for _, m, _ in places)


def value_at(target: Target) -> Any:
    field = keys(target.model)[target.key]
    default = None if field.is_required() else field.get_default()
    return target.owner.get(target.key, default)


def _checked(target: Target) -> Target:
    """The same target, after a check that there is such a component."""
    if target.part is None:
        return target
    whole = value_at(target)
    if not isinstance(whole, (list, tuple)):
        raise no_path(target.path, "has no components; set it whole")
    if target.part >= len(whole):
        raise no_path(target.path, f"must be from 0 to {len(whole) - 1}")
    return target


def _known(
    place: tuple[dict[str, Any], ModelType, str], key: str | int
) -> tuple[dict[str, Any], ModelType, str]:
    """The same place, after a check that its model has the key."""
    _, model, path = place
    known = keys(model)
    if isinstance(key, int) or key not in known:
        rule = f"unknown key; {nearest(str(key), list(known))}"
        others = [tag(one) for one in siblings(model) if key in keys(one)]
        if inner := section_with(model, str(key)):
            rule = f"unknown key here; write {join(join(path, inner), str(key))}"
        if others:
            rule = f"{tag(model)!r} has no such key, {others[0]!r} has: set {path}.kind too"
        raise no_path(join(path, str(key)), rule)
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
            raise no_path(here, "holds a value of its own; set it whole")
        if not kind.listed:
            if isinstance(rest[0], int):
                raise no_path(f"{here}[{rest[0]}]", f"there is only one; write {here}")
            inner = owner.setdefault(key, {})
            if key == "made_of" and isinstance(inner, str):
                inner = owner[key] = {"kind": "material", "library": inner}
            if not isinstance(inner, dict):
                raise no_path(here, _WHOLE)
            below.append((inner, _model(kind.models, inner, here), here))
            continue
        chosen, left = _choose(owner.get(key, []), kind.models[0], here, rest)
        below += [(item, _model(kind.models, item, spot), spot) for item, spot in chosen]
    return below, left


def _model(models: tuple[ModelType, ...], inner: dict[str, Any], path: str) -> ModelType:
    """The model that a table is of; a table not there yet starts as the first kind."""
    model = by_tag(models, inner.setdefault("kind", tag(models[0])) if len(models) > 1 else None)
    if model is None:
        kinds = ", ".join(str(tag(one)) for one in models)
        raise no_path(join(path, "kind"), f"must be one of {kinds}")
    return model


def _choose(
    items: list[dict[str, Any]], model: ModelType, path: str, rest: list[str | int]
) -> tuple[list[tuple[dict[str, Any], str]], list[str | int]]:
    """The items of a list that the next step of a path means: one by index or name, else all."""
    if not isinstance(items, list) or not all(isinstance(item, dict) for item in items):
        raise no_path(path, _WHOLE)
    spots = [(item, f"{path}[{i}]") for i, item in enumerate(items)]
    if not items:
        raise no_path(path, "the scene has none")
    step = rest[0]
    if isinstance(step, int):
        if step >= len(items):
            rule = "there is only [0]" if len(items) == 1 else f"must be from 0 to {len(items) - 1}"
            raise no_path(f"{path}[{step}]", rule)
        if len(rest) == 1:
            raise no_path(f"{path}[{step}]", "give a key of it too")
        return [spots[step]], rest[1:]
    named = [spot for spot in spots if spot[0].get("name") == step]
    known = {*keys(model), *model.model_fields}  # in TOML, and in Python
    if named and len(rest) > 1 and step not in known:
        return named, rest[1:]
    if step not in known and len(rest) > 1:
        names = [str(item["name"]) for item in items if "name" in item]
        raise no_path(f"{path}.{step}", f"no such name or key; {nearest(step, names)}")
    return spots, rest


def put(target: Target, value: Any) -> None:
    """Put a value into a table; a new kind drops the keys that it does not know."""
    owner, key, model, _, part, above = target
    field = keys(model)[key]
    if part is not None:
        whole = list(value_at(target))
        whole[part] = value
        owner[key] = whole
        return
    if isinstance(value, str) and value == "none" and not field.is_required() and key not in _TEXTS:
        owner.pop(key, None)
        return
    if key == "kind" and value != owner.get("kind"):
        _change_kind(owner, model, value)
    for other in displaced(owner, key, value):
        del owner[other]
    if (
        key == "library" and value and above is not None
    ):  # of the rope, whose diameter the library gives, too
        above.pop("diameter", None)
    owner[key] = value


def _change_kind(owner: dict[str, Any], model: ModelType, value: Any) -> None:
    chosen = by_tag(siblings(model), value)
    if chosen is not None:
        for key in set(owner) - set(keys(chosen)):
            del owner[key]


def displaced(names: Iterable[str], key: str, value: Any) -> set[str]:
    """Return which of a table's `names` a new value for `key` takes away: what went with the old one."""
    if key == "library" and value:
        return set(names) - {"kind"}
    if key == "file" and value:
        return _FROM_FILES & set(names)
    return {"diameter"} & set(names) if key == "made_of" and brings_diameter(value) else set()


def brings_diameter(made_of: Any) -> bool:
    """Tell whether a value for `made_of` names a rope of the library, whose diameter comes with it."""
    if isinstance(made_of, Mapping):
        return bool(made_of.get("library")) and not all(key in made_of for key in NEEDED)
    return isinstance(made_of, str | library.LibraryRope)
