"""Tables and lists of the reference pages, made from the package itself at build time.

`scene-format`   every table of a scene file, from the models
`methods-table`  the methods of time integration, from the registry
`presets-table`  the presets
`ropes-table`    the rope library
`rope-sources`   its sources
`commands`       the command line, from its commands and options
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import groupby
from typing import Any, Literal, get_args, get_origin

import click
from docutils import nodes
from docutils.statemachine import StringList
from pydantic.fields import FieldInfo
from sphinx.util.docutils import SphinxDirective
from sphinx.util.nodes import nested_parse_with_titles

from ropewalk.cli import main
from ropewalk.library import names, rope, sources
from ropewalk.live.themes import menu
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Scene, presets
from ropewalk.scene.paths import keys, kind_of, sections, tag


def scene_format() -> Iterator[str]:
    """Yield a section of Markdown for every table of a scene file."""
    listed = {"": False}
    for path, model in sections(Scene):
        for key, field in keys(model).items():
            listed[f"{path}.{key}".lstrip(".")] = kind_of(field).listed
        if path and all(kind_of(field).models for field in model.model_fields.values()):
            continue
        yield from _section(path, model, listed.get(path, False))


def _section(path: str, model: Any, listed: bool) -> Iterator[str]:
    kind = tag(model)
    brackets = f"[[{path}]]" if listed else f"[{path}]"
    yield (
        f"## `{brackets}`" + (f' with `kind = "{kind}"`' if kind else "")
        if path
        else "## Top level"
    )
    yield ""
    yield (model.__doc__ or "").strip().split("\n\n")[0].replace("\n    ", " ").replace("``", "`")
    yield ""
    rows = [(key, field) for key, field in keys(model).items() if key != "kind"]
    if not rows:
        return
    yield "| key | unit | default | meaning |"
    yield "|---|---|---|---|"
    for key, field in rows:
        yield f"| `{key}` | {_unit(field)} | {_default(field)} | {_meaning(field)} |"
    yield ""


def _unit(field: FieldInfo) -> str:
    extra = field.json_schema_extra
    return str(extra.get("unit", "")) if isinstance(extra, dict) else ""


def _default(field: FieldInfo) -> str:
    kind = kind_of(field)
    if field.is_required():
        return "needed"
    if kind.models or field.default in (None, (), ""):
        return ""
    value = field.default
    if isinstance(value, bool):
        return f"`{str(value).lower()}`"
    if isinstance(value, tuple):
        return "`[" + ", ".join(f"{part:g}" for part in value) + "]`"
    return f'`"{value}"`' if isinstance(value, str) else f"`{value:g}`"


def _meaning(field: FieldInfo) -> str:
    text = str(field.description or "")
    kind = kind_of(field)
    tags = [f'`"{name}"`' for name in map(tag, kind.models) if name]
    if len(tags) > 1:
        text += ": a table of kind " + ", ".join(tags)
    elif kind.models:
        text += " (tables of their own)" if kind.listed else " (a table of its own)"
    elif choices := [
        f'`"{name}"`' for name in _choices(field.annotation) if f'"{name}"' not in text
    ]:
        text += f" ({', '.join(choices)})"
    return text.replace("|", "\\|")


def _choices(annotation: Any) -> list[str]:
    """Return the texts that a field may be."""
    if get_origin(annotation) is Literal:
        return [one for one in get_args(annotation) if isinstance(one, str)]
    return [text for part in get_args(annotation) for text in _choices(part)]


def methods_table() -> Iterator[str]:
    """Yield the table of methods."""
    yield "| method | order | force evaluations per step | |"
    yield "|---|---|---|---|"
    for method in METHODS.values():
        cost = str(method.evaluations)
        if method.implicit:
            cost = f"{cost} stage{'s' * (method.evaluations > 1)} to solve"
        yield f"| `{method.name}` | {method.order} | {cost} | {method.summary} |"


def presets_table() -> Iterator[str]:
    """Yield a section of Markdown with a table for every theme of the live view's menu."""
    for theme, listed in groupby(menu(), lambda entry: entry.theme):
        yield f"## {theme}"
        yield ""
        yield "| preset | what it shows |"
        yield "|---|---|"
        for entry in listed:
            yield f"| `{entry.name}` | {presets.preset(entry.name).description} |"
        yield ""


def ropes_table() -> Iterator[str]:
    """Yield a section of Markdown with a table for every family of the rope library."""
    columns = {"diameter": 1e3, "mass_per_length": 1e3, "EA": 1e-3, "breaking_load": 1e-3}
    every = [rope(name) for name in names()]
    for family in dict.fromkeys(one.family for one in every):
        yield f"## {family[0].upper()}{family[1:]}"
        yield ""
        yield "| rope | | diameter [mm] | mass [g/m] | EA [kN] | breaking load [kN] |"
        yield "|---|---|---|---|---|---|"
        for one in every:
            if one.family != family:
                continue
            numbers = [(one.numbers[key], factor) for key, factor in columns.items()]
            cells = [
                f"{'~' * n.guessed}{float(f'{factor * n.value:.4g}'):g}" for n, factor in numbers
            ]
            yield f"| `{one.name}` | {one.title} | {' | '.join(cells)} |"
        yield ""


def rope_sources() -> Iterator[str]:
    """Yield the list of the library's sources."""
    for name, text in sources().items():
        yield f"* **{name}**: {text}"


def commands() -> Iterator[str]:
    """Yield a section for every command."""
    context = click.Context(main, info_name="ropewalk")
    assert isinstance(main, click.Group)
    for name in main.list_commands(context):
        command = main.get_command(context, name)
        if command is not None and not command.hidden:
            yield from _command(command, click.Context(command, info_name=name, parent=context))


def _command(command: click.Command, context: click.Context) -> Iterator[str]:
    yield f"## `ropewalk {context.info_name}`"
    yield ""
    yield "```text"
    yield from command.get_help(context).splitlines()
    yield "```"
    yield ""


def directive(lines: Callable[[], Iterator[str]]) -> type[SphinxDirective]:
    """Return a directive that puts the Markdown of `lines` in its place."""

    class Generated(SphinxDirective):
        def run(self) -> list[nodes.Node]:
            text = StringList(list(lines()), source=lines.__name__)
            parent = nodes.section()
            parent.document = self.state.document
            nested_parse_with_titles(self.state, text, parent)
            return parent.children

    return Generated


def setup(app: Any) -> dict[str, Any]:
    """Register the directives."""
    for make in (scene_format, methods_table, presets_table, ropes_table, rope_sources, commands):
        app.add_directive(make.__name__.replace("_", "-"), directive(make))
    return {"parallel_read_safe": True}
