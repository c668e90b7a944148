"""Changing single values of a scene from text: ``rope.segments=80``."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from typing import Any

from pydantic.fields import FieldInfo

from ropewalk.scene.base import Model
from ropewalk.scene.changing import (
    RENEWING,
    Target,
    changed,
    no_path,
    put,
    steps_of,
    targets_of,
    value_at,
)
from ropewalk.scene.faults import Fault, SceneError
from ropewalk.scene.paths import keys, toml_name
from ropewalk.scene.run_settings import RunSettings
from ropewalk.scene.scene import Scene
from ropewalk.scene.toml_text import as_value


def apply_overrides(scene: Scene, overrides: Iterable[str]) -> Scene:
    """A scene with some values changed.

    Each override is ``path=value``. ``rope.segments=80`` changes every rope,
    ``rope[1].segments=80`` or ``rope.left.segments=80`` (by its name) one of them; the same goes
    for anchors, winches, loads and kicks. ``gravity[2]=-1.62`` changes one component of a
    vector. The keys of ``[run]`` need no prefix:
    ``time_step=0.001``. A value is read as TOML and, where it is none, taken as text, so that
    ``method=rk4`` needs no quotes. ``none`` takes an optional value or table away, so that
    it has its default again.

    What takes others away, such as a `kind` or another rope of the library, is set before them, wherever it
    stands.

    Changing ``segments`` of a rope of springs keeps their ``segment_length``: the rope becomes
    longer. A rope of a material keeps its length.

    Raises:
        SceneError: with every override that names nothing, and every fault of the new scene.
    """
    return changed(scene, [partial(_split, text) for text in overrides])


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
        self._table = scene.as_said()
        faults: list[Fault] = []
        places: list[list[Target]] = []
        for path in self.paths:
            try:
                places.append(list(targets_of(Scene, self._table, _steps_of_scene(path.strip()))))
            except SceneError as error:
                faults += error.faults
        if faults:
            raise SceneError(faults)
        self._places = places
        targets = [target for found in places for target in found]
        # These take keys away, which must be there again for the next value.
        self._renewed = any(target.key in RENEWING for target in targets)
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
        found = [(value_at(target), target.part) for target in self._places[number]]
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
        pairs = zip(self._places, values, strict=True)
        for targets, value in sorted(pairs, key=lambda pair: pair[0][0].key not in RENEWING):
            for target in targets:
                put(target, value)
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


def _split(override: str) -> tuple[list[str | int], Any]:
    """The steps of the path and the value."""
    path, equals, text = override.partition("=")
    path, text = path.strip(), text.strip()
    if not equals or not path:
        raise no_path(f'"{override}"', "must be written as path=value, such as rope.segments=80")
    return _steps_of_scene(path), as_value(text)


def _steps_of_scene(path: str) -> list[str | int]:
    """The steps of a path below a scene, where the keys of [run] need no prefix."""
    steps = steps_of(path)
    if steps[0] in RunSettings.model_fields:
        steps.insert(0, "run")
    return steps
