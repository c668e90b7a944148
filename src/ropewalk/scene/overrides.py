"""Changing single values of a scene from text: ``rope.segments=80``."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple, TypeVar

from pydantic.fields import FieldInfo

from ropewalk.scene.base import Model
from ropewalk.scene.faults import NO_VALUE, Fault, SceneError, join
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
from ropewalk.scene.run_settings import RunSettings
from ropewalk.scene.scene import Scene
from ropewalk.scene.toml_text import as_table, as_value, plain, scene_table
from ropewalk.words.nearest import nearest

M = TypeVar("M", bound=Model)
#: Free texts, in which "none" is a word like others.
_TEXTS = {"name", "description"}
#: What a file holds, which is in the table once it is read; another file takes its place.
_FROM_FILES = {
    *("vertices", "faces", "values", "spacing", "origin"),
    *("strain", "tension", "times", "positions", "points"),
}
_STEP = re.compile(r"([^.\[\]=\s]+)((?:\[\d+\])*)")


def apply_overrides(scene: Scene, overrides: Iterable[str]) -> Scene:
    """A scene with some values changed.

    Each override is ``path=value``. ``rope.segments=80`` changes every rope,
    ``rope[1].segments=80`` or ``rope.left.segments=80`` (by its name) one of them; the same goes
    for anchors, winches, loads and kicks. ``gravity[2]=-1.62`` changes one component of a
    vector. The keys of ``[run]`` need no prefix:
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
            for target in _targets(type(model), table, path):
                _set(target, value)
        except SceneError as error:
            faults += error.faults
    if faults:
        raise SceneError(faults)
    return type(model).model_validate(table)


def _named(path: str, value: Any) -> tuple[list[str | int], Any]:
    """The steps of a path and its value, models as tables."""
    return _steps(path), plain(value)


class Places:
    """Places in a scene to which values are written, again and again.

    `scene(values)` is `apply_overrides` with the same paths, and values as they are instead of text.
    """

    def __init__(self, scene: Scene, paths: Iterable[str], whole: bool = False) -> None:
        """Find the places. Raises SceneError with every path that leads nowhere.

        The parts of the scene that no path leads into are taken over as they are, checked already, unless
        the `whole` scene is to be made each time.
        """
        self.paths = tuple(paths)
        self._table = scene_table(scene)
        faults: list[Fault] = []
        places: list[list[_Target]] = []
        for path in self.paths:
            try:
                places.append(list(_targets(Scene, self._table, _steps_of_scene(path.strip()))))
            except SceneError as error:
                faults += error.faults
        if faults:
            raise SceneError(faults)
        self._places = places
        targets = [target for found in places for target in found]
        # These take keys away, which must be there again for the next value.
        self._renewed = any(target.key in ("kind", "library", "made_of") for target in targets)
        self._scene, self._whole = scene, whole
        if not whole and not any(target.key == "name" for target in targets):  # others tell names
            owners = {id(target.owner) for target in targets}
            _take_over(self._table, scene, owners, {(id(t.owner), t.key) for t in targets})

    def field(self, number: int) -> tuple[FieldInfo, str]:
        """Return the field that path `number` leads to (to the first of many) and its whole path."""
        target = self._places[number][0]
        return keys(target.model)[target.key], target.path

    def value(self, number: int) -> Any:
        """Return what stands at path `number` now (at the first of many places); None for nothing."""
        return self.values(number)[0]

    def values(self, number: int) -> list[Any]:
        """Return what stands at path `number` now, place by place; None for nothing."""
        found = [(_whole(target), target.part) for target in self._places[number]]
        return [one if part is None or one is None else one[part] for one, part in found]

    def overlap(self, number: int, other: int) -> bool:
        """Tell whether two of the paths write to one place."""
        for one in self._places[number]:
            for two in self._places[other]:
                same = one.owner is two.owner and one.key == two.key
                if same and (one.part is None or two.part is None or one.part == two.part):
                    return True
        return False

    def scene(self, values: Sequence[Any]) -> Scene:
        """Return the scene with these values, one per path. Raises SceneError with every fault."""
        if self._renewed or any(
            isinstance(v, str) and v == "none" for v in values
        ):  # which takes the key away
            return Places(self._scene, self.paths, whole=True)._written(values)
        try:
            return self._written(values)
        except SceneError:
            if self._whole:
                raise
            return Places(self._scene, self.paths, whole=True)._written(values)  # all faults

    def _written(self, values: Sequence[Any]) -> Scene:
        for targets, value in zip(self._places, values, strict=True):
            for target in targets:
                _set(target, value)
        return Scene.model_validate(self._table)


def _take_over(
    table: dict[str, Any], model: Model, owners: set[int], targets: set[tuple[int, str]]
) -> bool:
    """Put the model's own parts in place of the tables below which nothing is to be changed.

    `owners` are the ids of tables in which something is; returns whether this is one, or any below it.
    """
    names = {toml_name(name, field): name for name, field in type(model).model_fields.items()}
    changed = id(table) in owners
    for key, value in table.items():
        if (id(table), key) in targets:
            continue
        part = getattr(model, names[key])
        if isinstance(value, dict) and isinstance(part, Model):
            below = _take_over(value, part, owners, targets)
            table[key] = value if below else part
            changed |= below
        elif isinstance(value, dict):  # a table that a path has begun
            changed = True
        elif isinstance(value, list) and part and isinstance(part[0], Model):
            pairs = list(zip(value, part, strict=True))
            below_each = [_take_over(item, one, owners, targets) for item, one in pairs]
            table[key] = [
                item if below else one for (item, one), below in zip(pairs, below_each, strict=True)
            ]
            changed |= any(below_each)
    return changed


def _fault(path: str, rule: str) -> SceneError:
    return SceneError([Fault(path, NO_VALUE, rule)])


def _split(override: str) -> tuple[list[str | int], Any]:
    """The steps of the path and the value."""
    path, equals, text = override.partition("=")
    path, text = path.strip(), text.strip()
    if not equals or not path:
        raise _fault(f'"{override}"', "must be written as path=value, such as rope.segments=80")
    return _steps_of_scene(path), as_value(text)


def _steps_of_scene(path: str) -> list[str | int]:
    """The steps of a path below a scene, where the keys of [run] need no prefix."""
    steps = _steps(path)
    if steps[0] in RunSettings.model_fields:
        steps.insert(0, "run")
    return steps


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


# What an earlier path of the same call has put there.
_WHOLE = "was set to a value without keys before; leave that out, or set it whole"


class _Target(NamedTuple):
    """Where a path leads: a key of a table, or one component of the list that stands there."""

    owner: dict[str, Any]
    key: str
    model: ModelType
    path: str
    part: int | None = None


def _targets(root: ModelType, table: dict[str, Any], steps: list[str | int]) -> Iterator[_Target]:
    """Every table, key and model that a path below a root leads to."""
    places: list[tuple[dict[str, Any], ModelType, str]] = [(table, root, "")]
    rest = list(steps)
    while True:
        key = _as_in_toml(places, rest.pop(0))
        places = [_known(place, key) for place in places]
        if not rest or (len(rest) == 1 and _is_vector(places, str(key), rest[0])):
            for owner, model, path in places:
                part = int(rest[0]) if rest else None
                where = join(path, str(key)) + ("" if part is None else f"[{part}]")
                yield _checked(_Target(owner, str(key), model, where, part))
            return
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


def _whole(target: _Target) -> Any:
    field = keys(target.model)[target.key]
    default = None if field.is_required() else field.get_default()
    return target.owner.get(target.key, default)


def _checked(target: _Target) -> _Target:
    """The same target, after a check that there is such a component."""
    if target.part is None:
        return target
    whole = _whole(target)
    if not isinstance(whole, (list, tuple)):
        raise _fault(target.path, "has no components; set it whole")
    if target.part >= len(whole):
        raise _fault(target.path, f"must be from 0 to {len(whole) - 1}")
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
            rule = f"unknown key here; write {join(path, inner)}.{key}"
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
        below += [(item, _model(kind.models, item, spot), spot) for item, spot in chosen]
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
            rule = "there is only [0]" if len(items) == 1 else f"must be from 0 to {len(items) - 1}"
            raise _fault(f"{path}[{step}]", rule)
        if len(rest) == 1:
            raise _fault(f"{path}[{step}]", "give a key of it too")
        return [spots[step]], rest[1:]
    named = [spot for spot in spots if spot[0].get("name") == step]
    known = {*keys(model), *model.model_fields}  # in TOML, and in Python
    if named and len(rest) > 1 and step not in known:
        return named, rest[1:]
    if step not in known and len(rest) > 1:
        names = [str(item["name"]) for item in items if "name" in item]
        raise _fault(f"{path}.{step}", f"no such name or key; {nearest(step, names)}")
    return spots, rest


def _set(target: _Target, value: Any) -> None:
    """Put a value into a table; a new kind drops the keys that it does not know."""
    owner, key, model, _, part = target
    field = keys(model)[key]
    if part is not None:
        whole = list(_whole(target))
        whole[part] = value
        owner[key] = whole
        return
    if isinstance(value, str) and value == "none" and not field.is_required() and key not in _TEXTS:
        owner.pop(key, None)
        return
    if key == "kind" and value != owner.get("kind"):
        _change_kind(owner, model, value)
    if key == "library":  # its numbers take the place of those that are there
        for other in set(owner) - {"kind"}:
            del owner[other]
    if key == "file":
        for other in _FROM_FILES & set(owner):
            del owner[other]
    if key == "made_of" and isinstance(value, str):
        owner.pop("diameter", None)
    owner[key] = value


def _change_kind(owner: dict[str, Any], model: ModelType, value: Any) -> None:
    chosen = by_tag(siblings(model), value)
    if chosen is not None:
        for key in set(owner) - set(keys(chosen)):
            del owner[key]
