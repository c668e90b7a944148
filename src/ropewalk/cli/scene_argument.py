"""SCENE as the commands take it: a TOML file or the name of a preset, with values changed."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ropewalk.cli.failures import Refusal, Settings
from ropewalk.words.nearest import nearest

if TYPE_CHECKING:
    from ropewalk.scene import Scene

_F = TypeVar("_F", bound=Callable[..., Any])

set_option = click.option(
    "--set",
    "overrides",
    multiple=True,
    metavar="PATH=VALUE",
    help="Change a value of the scene, such as rope.segments=80; can be given again.",
)
json_option = click.option(
    "--json", "as_json", is_flag=True, help="Print one JSON object on stdout, nothing else."
)


def run_options(function: _F) -> _F:
    """Add the options that stand for values of [run]."""
    for option in (
        click.option(
            "--method", metavar="NAME", help="Method of integration, in place of the scene's."
        ),
        click.option("--time-step", metavar="S", help='Largest time step, in seconds, or "auto".'),
        click.option("--duration", metavar="S", help="Simulated time, in seconds."),
        set_option,
    ):
        function = option(function)
    return function


def as_flags(overrides: Sequence[str], **run: str | None) -> list[str]:
    """Return what changes a scene, the values of [run] from options of their own among it."""
    return [*overrides, *(f"run.{key}={value}" for key, value in run.items() if value is not None)]


def load_scene(source: str, overrides: Sequence[str] = (), **run: str | None) -> Scene:
    """Load a scene file or a preset and change values of it.

    `run` are values of [run] from options of their own. Raises SceneError with every fault, Refusal
    when there is neither a file nor a preset of that name.
    """
    from ropewalk.scene import SceneError, apply_overrides, load, presets

    _loaded().append(source)
    named = source in presets.names() and not Path(source).is_file()
    if named:
        scene = presets.preset(source)
    elif _is_path(source):
        scene = load(source)
    else:
        raise Refusal(_unknown(source, presets.names()))
    changes = as_flags(overrides, **run)
    if not changes:
        return scene
    try:
        return apply_overrides(scene, changes)
    except SceneError as error:
        raise SceneError(error.faults, f"{source}, changed by flags") from None


@contextmanager
def named(source: str) -> Iterator[None]:
    """Let what goes wrong tell of which of a command's several scenes it is; that of the only one does."""
    try:
        yield
    except Exception:
        _loaded()[:] = [source]
        raise


def _loaded() -> list[str]:
    """Return the scenes that messages may be of (`failures.explain`), to be changed."""
    context = click.get_current_context(silent=True)
    return [] if context is None else context.ensure_object(Settings).scenes


def _is_path(source: str) -> bool:
    """Whether the source means a file rather than a preset."""
    if "\0" in source:
        raise Refusal("SCENE: holds a NUL character; must be a file or the name of a preset")
    separated = "/" in source or "\\" in source or source.endswith(".toml")
    try:
        return bool(source) and (separated or Path(source).exists())
    except OSError:  # a name that is too long for the file system
        return False


def _unknown(source: str, names: Sequence[str]) -> str:
    if not source:
        return 'SCENE: "" - must be a scene file or the name of a preset'
    shown = source if len(source) <= 60 else f"{source[:57]}..."
    return (
        f"{shown}: no such file, and no preset of that name; {nearest(source, names)} "
        "(see: ropewalk presets)"
    )


def short_name(source: str) -> str:
    """Return a name for files and folders made from a scene: the preset's or the file's own."""
    stem = Path(source).name
    stem = stem.removesuffix(".toml") or "scene"
    return re.sub(r"[^\w.-]+", "-", stem).strip("-.") or "scene"
