"""Terminal output: facts on stdout, talk on stderr."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from rich.console import Console

_PIPE_WIDTH = 160  # columns of a table that nobody's terminal cuts


def console(*, stderr: bool = False) -> Console:
    """Return a console of the terminal's width, or of a wide page where there is no terminal."""
    from rich.console import Console

    made = Console(stderr=stderr, highlight=False, soft_wrap=False)
    if not made.is_terminal:
        made = Console(stderr=stderr, highlight=False, width=_PIPE_WIDTH, no_color=True)
    return made


def load_tables() -> None:
    """Load now what a table at the end needs, so that Ctrl-C in between is answered sooner."""
    _drawn(("all",), [("that",)], "is: drawn", ())


def say(text: str = "") -> None:
    """Print a line of results on stdout."""
    click.echo(text)


def tell(text: str) -> None:
    """Print a line about the work on stderr."""
    click.echo(text, err=True)


def warn(text: str) -> None:
    """Print a warning on stderr."""
    click.echo(click.style("warning: ", fg="yellow", bold=True) + text, err=True)


def print_json(value: dict[str, Any]) -> None:
    """Print one JSON object on stdout; NaN and infinity become null."""
    click.echo(json.dumps(finite(value), indent=2))


def finite(value: Any) -> Any:
    """Return `value` as plain JSON values."""
    if isinstance(value, dict):
        return {str(key): finite(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [finite(item) for item in value]
    if isinstance(value, Path):
        return str(value)
    if value is None or isinstance(value, (bool, int, str)):
        return value
    number = float(value)
    return number if number - number == 0.0 else None


def print_table(
    columns: Sequence[str],
    rows: Iterable[Sequence[str]],
    *,
    title: str = "",
    right: Iterable[int] = (),
) -> None:
    """Print a table on stdout; `right` names the columns of numbers."""
    click.echo(_drawn(columns, rows, title, right))


def _drawn(
    columns: Sequence[str], rows: Iterable[Sequence[str]], title: str, right: Iterable[int]
) -> str:
    from rich import box
    from rich.table import Table
    from rich.text import Text

    aligned = set(right)
    table = Table(
        title=Text(title, style="bold") if title else None,
        title_justify="left",
        box=box.SIMPLE_HEAD,
        pad_edge=False,
        show_header=any(columns),
    )
    for i, name in enumerate(columns):
        number = i in aligned
        table.add_column(Text(name), justify="right" if number else "left", no_wrap=number)
    for row in rows:
        table.add_row(*(Text(cell) for cell in row))
    page = console()
    with page.capture() as drawn:
        page.print(table)
    lines = [line.rstrip() for line in drawn.get().splitlines()]
    return "\n".join(line for line in lines if click.unstyle(line))
