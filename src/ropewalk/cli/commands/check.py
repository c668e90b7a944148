"""`ropewalk check`: what can be said of a scene before it runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from ropewalk.cli.console import print_json, print_table, say, warn
from ropewalk.cli.errors import BROKE
from ropewalk.cli.progress import telling_of_compiling
from ropewalk.cli.sources import json_option, load_scene, named, run_options

if TYPE_CHECKING:
    from ropewalk.analysis.check import Check


@click.command()
@click.argument("scene")
@run_options
@json_option
def check(
    scene: str,
    overrides: tuple[str, ...],
    duration: str | None,
    time_step: str | None,
    method: str | None,
    as_json: bool,
) -> int:
    """Say whether a scene will run, and what to expect of it.

    Prints the largest stable step of every method, the margin of this run, wave speeds, sag and
    tension at rest, the cost, and warnings of likely slips of units. Nothing is run or written.

    Exit status 3 when the run is expected to break, else 0.
    """
    from ropewalk.analysis.check import check as check_scene

    loaded = load_scene(scene, overrides, duration=duration, time_step=time_step, method=method)
    with named(scene), telling_of_compiling():
        found = check_scene(loaded)
    if as_json:
        print_json({"scene": scene} | found.as_dict())
    else:
        _print(found)
    return 0 if found.ok else BROKE


def _print(found: Check) -> None:
    from ropewalk.analysis.check import milliseconds

    stability = found.stability
    say(f"{found.name}")
    say(f"  {stability.verdict}")
    if found.why:
        say(f"  {found.why}")
    rows = []
    for name, step in stability.largest_step.items():
        chosen = "this run" if name == stability.method else ""
        fits = "yes" if stability.step <= step else "no"
        rows.append((name, milliseconds(step), fits, chosen))
    here = milliseconds(stability.step)
    print_table(("method", "largest stable step", f"stable at {here}", ""), rows, right=[1])
    for line in _facts(found):
        say(line)
    for note in stability.notes:
        say(f"note: {note}")
    for text in found.warnings:
        warn(text)


def _facts(found: Check) -> list[str]:
    """The rest of the check's own lines, without those that the table shows."""
    lines = found.lines()
    first = next(i for i, line in enumerate(lines) if line.startswith("largest stable steps"))
    after = first + 1 + len(found.stability.largest_step)
    kept = [line for line in (*lines[1:first], *lines[after:]) if line != found.why]
    return [line for line in kept if not line.startswith(("warning: ", "note: "))]
