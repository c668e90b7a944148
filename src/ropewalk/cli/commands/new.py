"""`ropewalk new`: a commented scene to edit."""

from __future__ import annotations

import re
from importlib.resources import files
from pathlib import Path

import click

from ropewalk.cli.console import say, tell
from ropewalk.cli.output_files import write_new
from ropewalk.cli.scene_argument import short_name
from ropewalk.words.nearest import close_name
from ropewalk.words.shell import typed

_LIKE = 0.7  # how like a preset's name a name is that may be meant for it; 1: the same


@click.command()
@click.argument("name")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path), help="The file; default NAME.toml."
)
@click.option("--from", "origin", metavar="PRESET", help="Begin with this preset.")
@click.option("--overwrite", is_flag=True, help="Replace a file that is there.")
def new(name: str, output: Path | None, origin: str | None, overwrite: bool) -> None:
    """Write a commented scene to edit.

    NAME is a preset to begin with, or a name of your own for the scene; such a scene begins with a
    starter that explains every part, or with the preset of --from.
    """
    text, begun_with = _text(name, origin)
    path = output or Path(f"{short_name(name)}.toml")
    write_new(path, text, overwrite=overwrite)
    if origin is None:
        _tell_of_preset(name)
    say(f"{path}: a scene begun with {begun_with}")
    say(f"next:  ropewalk check {typed(path)}")
    say(f"then:  ropewalk run {typed(path)}")


def _text(name: str, origin: str | None) -> tuple[str, str]:
    """Return the TOML and what it began with."""
    from ropewalk.scene import Fault, SceneError, loads, presets

    if not name.strip() or len(name) > 200 or not name.isprintable():
        rule = "must be a name of 1 to 200 printable characters, or a preset"
        raise SceneError([Fault("NAME", name, rule)])
    if origin is None and name in presets.names():
        return presets.preset_text(name), f"the preset {name}"
    if origin is None:
        text, begun_with = starter(), "the starter (a preset's name would take that preset)"
    else:
        text, begun_with = presets.preset_text(origin), f"the preset {origin}"
    quoted = name.replace("\\", "\\\\").replace('"', '\\"')
    text = re.sub(r'^name = ".*"', lambda _: f'name = "{quoted}"', text, count=1, flags=re.M)
    loads(text, "the new scene")
    return text, begun_with


def _tell_of_preset(name: str) -> None:
    """Say which preset may be meant by a name that is nearly one's."""
    from ropewalk.scene import presets

    meant = close_name(name, presets.names(), _LIKE)
    if meant and meant != name:
        tell(f'note: "{name}" is no preset; did you mean the preset "{meant}"?')


def starter() -> str:
    """Return the starter scene: every part explained, the optional ones commented out."""
    return (files("ropewalk.cli") / "starter.toml").read_text(encoding="utf-8")
