"""Ready scenes: the systems that the project starts from, and some classics."""

from __future__ import annotations

import re
from importlib.resources import files
from pathlib import Path

from ropewalk.scene.faults import Fault, SceneError
from ropewalk.scene.scene import Scene
from ropewalk.scene.toml_text import loads
from ropewalk.words.nearest import nearest

#: The report's scenes first, then NeHe's and Habrador's, then all others.
_GROUPS = (r"r\d", r"n\d", r"h\d", r"")


def _folder() -> Path:
    return Path(str(files("ropewalk.scene"))) / "presets"


def names() -> list[str]:
    """The names of all presets, in the order in which they are worth reading."""
    found = (item.name for item in _folder().iterdir() if item.name.endswith(".toml"))
    return sorted((name.removesuffix(".toml") for name in found), key=_order)


def _order(name: str) -> tuple[int, str]:
    return next(i for i, group in enumerate(_GROUPS) if re.match(group, name)), name


def preset_text(name: str) -> str:
    """The preset as commented TOML.

    Raises:
        SceneError: when there is no such preset.
    """
    known = names()
    if name not in known:
        rule = f"no such preset; {nearest(name, known)}"
        raise SceneError([Fault("preset", name, rule)])
    return (_folder() / f"{name}.toml").read_text(encoding="utf-8")


def preset(name: str) -> Scene:
    """The scene of the preset called `name`; the command `ropewalk presets` lists all.

    Raises:
        SceneError: when there is no such preset.
    """
    return loads(preset_text(name), f"preset {name}")
