"""DIR as the commands take it: a run folder; and nodes as they are named on the command line."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from ropewalk.cli.console import warn
from ropewalk.cli.failures import Refusal

if TYPE_CHECKING:
    from ropewalk.record.result import Result

run_argument = click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))


def open_run(folder: Path, *, whole: bool = False) -> Result:
    """Open a run folder. Raises RunError when it is none, or damaged, Refusal of a sweep.

    Of a live session it is the first part, of which is warned unless the `whole` is taken.
    """
    from ropewalk.record.result import Result

    if is_sweep(folder):
        rule = f"is a sweep, which keeps no run whole; `ropewalk view {folder} --run 0` makes one again"
        raise Refusal(f"{folder}: {rule}")
    result = Result.open(folder)
    if result.facts.provenance.get("live") and not whole:
        from ropewalk.live.keeper import parts

        if (count := len(parts(folder))) > 1:
            warn(
                f"{folder}: this is the first of {count} parts of a live session; the others are runs of "
                f"their own, {folder}/part-2 and on"
            )
    return result


def is_sweep(folder: Path) -> bool:
    """Tell whether a folder holds a sweep rather than a run."""
    return any((folder / name).is_file() for name in ("sweep.json", "values/sweep.json"))


def parse_node(text: str, result: Result) -> tuple[str, int]:
    """Return rope and node (as given, negative ones count from the end) of NODE or ROPE:NODE.

    Raises Refusal when there is no such rope or node.
    """
    name, colon, number = text.rpartition(":")
    ropes = [span.name for span in result.layout.ropes]
    if not colon and len(ropes) > 1:
        names = ", ".join(f"{rope}:{text}" for rope in ropes[:8])
        raise Refusal(f"--node {text}: there are several ropes; say which: {names}")
    rope = name if colon else ropes[0]
    if rope not in ropes:
        raise Refusal(f"--node {text}: there is no rope {rope!r}; there is {', '.join(ropes)}")
    try:
        node = int(number)
    except ValueError:
        raise Refusal(f"--node {text}: must be a node's number, or ROPE:NODE") from None
    try:
        result.layout.node(node, rope)
    except IndexError as error:
        raise Refusal(f"--node {text}: {error}") from None
    return rope, node
