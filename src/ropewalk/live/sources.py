"""Scenes that a page asks for: presets, the program's own, TOML text, and addresses.

An address is what stands behind # in a link: `scene=r4&mass=2&left.length=3`, or `toml=...` with the scene
itself, deflated, in base64url. Nothing is read from disk but presets: TOML from a page may name no files.
"""

from __future__ import annotations

import base64
import json
import tomllib
import zlib
from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import cache
from typing import Any
from urllib.parse import parse_qsl, urlencode

from ropewalk.live.commands import LONGEST_TEXT, SceneCommand
from ropewalk.live.json_input import read_json
from ropewalk.live.parameters import initial, refusal
from ropewalk.scene import Scene, SceneError, dumps, loads
from ropewalk.scene.presets import names, preset

START = "start"
LONGEST_ADDRESS = 8000
Settings = list[tuple[str, str | None, Any]]
Start = tuple[Scene, str | None]
Read = Callable[[str], Scene]  # of TOML


def from_toml(text: str) -> Scene:
    """Read a scene from TOML that names no files. Raises SceneError."""
    if len(text) > LONGEST_TEXT:
        raise refusal("toml", f"{len(text)} characters", f"must be at most {LONGEST_TEXT}")
    with suppress(tomllib.TOMLDecodeError, RecursionError):  # `loads` says it better
        _refuse_files(tomllib.loads(text))
    return loads(text, "the scene")


def scene_of(
    command: SceneCommand, start: Start, read: Read = from_toml
) -> tuple[Scene, str | None, Settings]:
    """Return scene, preset's name and constants to change. Raises SceneError."""
    given = [one for one in (command.preset, command.toml, command.address) if one is not None]
    if len(given) != 1:
        raise refusal("scene", None, "give one of preset, toml, address")
    if command.preset is not None:
        return (*_named(command.preset, start), [])
    if command.toml is not None:
        return read(command.toml), None, []
    return from_address(str(command.address), start, read)


def _named(name: str, start: Start) -> Start:
    if name == START:
        return start
    return preset(name), name


def _refuse_files(table: Any, path: str = "") -> None:
    if isinstance(table, list):
        for i, item in enumerate(table):
            _refuse_files(item, f"{path}[{i}]")
    elif isinstance(table, dict):
        for key, item in table.items():
            here = f"{path}.{key}" if path else str(key)
            if key == "file":
                raise refusal(here, item, "a scene from a page may name no files")
            _refuse_files(item, here)


def from_address(
    text: str, start: Start, read: Read = from_toml
) -> tuple[Scene, str | None, Settings]:
    """Take an address apart. Raises SceneError."""
    try:
        pairs = parse_qsl(
            text.lstrip("#?"), keep_blank_values=True, strict_parsing=True, max_num_fields=200
        )
    except ValueError:
        raise refusal("address", text, "must be written as scene=r4&mass=2") from None
    scene: Scene | None = None
    name: str | None = None
    settings: Settings = []
    for key, value in pairs:
        if key == "scene":
            scene, name = _named(value, start)
        elif key == "toml":
            scene, name = read(_inflated(value)), None
        else:
            rope, _, parameter = key.rpartition(".")
            settings.append((parameter, rope or None, _value(value)))
    if scene is None:
        scene, name = start
    return scene, name, settings


def scene_at(text: str, start: Start) -> Scene:
    """Return the scene that an address describes, its constants changed. Raises SceneError."""
    behind = text.partition("#")[2] if "#" in text else text  # a whole link will do
    if dict(parse_qsl(behind, keep_blank_values=True)).get("scene") in ("", START):
        rule = "names the scene of the program that it was copied from; keep that scene as TOML"
        raise refusal("address", text, rule)
    scene, _, settings = from_address(behind, start)
    return initial(scene, {(parameter, rope): value for parameter, rope, value in settings})


def _value(text: str) -> Any:
    try:
        return read_json(text)
    except SceneError:
        return text


def _inflated(text: str) -> str:
    try:
        data = base64.urlsafe_b64decode(text + "=" * (-len(text) % 4))
        made = zlib.decompressobj()
        plain = made.decompress(data, LONGEST_TEXT)
        if made.unconsumed_tail:
            raise ValueError("too long")
        return plain.decode()
    except (ValueError, zlib.error):
        raise refusal("toml", text, "is no scene that this program has written") from None


def address(start: Start, loaded: Start, changes: Mapping[tuple[str, str | None], Any]) -> str:
    """Return the address of a scene with changed constants."""
    scene, name = loaded
    if name is not None and name in names():
        first = ("scene", name)
    elif scene == start[0]:
        first = _packed(scene) or ("scene", START)
    else:
        first = _packed(scene) or ("scene", "")
    pairs = [first]
    changes = {**_settled(first, scene, changes), **changes}
    for (parameter, rope), value in changes.items():
        text = value if isinstance(value, str) else json.dumps(value)
        pairs.append((f"{rope}.{parameter}" if rope else parameter, text))
    return urlencode(pairs, safe="[],.")


def _settled(
    first: tuple[str, str], loaded: Scene, changes: Mapping[tuple[str, str | None], Any]
) -> dict[tuple[str, str | None], Any]:
    """Return what a preset leaves to the program, which would choose anew for the changed constants."""
    if first[0] != "scene" or not changes:
        return {}
    left = chosen(first[1])
    if ("steps_per_frame", None) in changes:
        left = left - {"time_step"}
    return {(name, None): getattr(loaded.run, name) for name in sorted(left)}


@cache
def chosen(name: str) -> frozenset[str]:
    """Return what of method and time step a preset leaves to the program."""
    if name not in names():
        return frozenset()
    run = preset(name).run
    return frozenset(one for one in ("method", "time_step") if getattr(run, one) == "auto")


def _packed(scene: Scene) -> tuple[str, str] | None:
    data = zlib.compress(dumps(scene).encode(), 9)
    text = base64.urlsafe_b64encode(data).decode().rstrip("=")
    return ("toml", text) if len(text) <= LONGEST_ADDRESS else None
