"""`ropewalk export`: a run's numbers for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from ropewalk.cli.console import say
from ropewalk.cli.failures import Refusal
from ropewalk.cli.run_argument import open_run, run_argument

FORMATS = ("csv", "parquet", "npz", "vtk")
_FLAGS = {
    "quantities": "--quantity",
    "nodes": "--node",
    "rope": "--node",
    "times": "--time",
    "every": "--every",
    "out": "-o",
    "to": "--to",
}


@click.command()
@run_argument
@click.option("--to", required=True, type=click.Choice(FORMATS), help="Format.")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="Folder, or file of one table; default: DIR/csv and so on.",
)
@click.option(
    "--quantity",
    "quantities",
    multiple=True,
    metavar="NAME",
    help="positions, velocities, tension, elastic_tension, rest_length, energy, work, reactions, moments, "
    "joint_forces, pulleys, contact_force, contact_work, momentum, angular_momentum or another of those "
    "recorded; can be given again. Default: all but momenta, rest_length, and places and times of extremes.",
)
@click.option(
    "--node",
    "nodes",
    multiple=True,
    metavar="[ROPE:]NODE",
    help="Only this node and the segments beside it; of ROPE also its anchors and joints alone. Pulleys and "
    "the table of the run are of all ropes. Can be given again.",
)
@click.option(
    "--time",
    "times",
    multiple=True,
    type=float,
    metavar="S",
    help="Only the frame nearest to this time, in seconds; can be given again.",
)
@click.option(
    "--every",
    type=int,
    metavar="N",
    help="Only every N-th frame; greatest and least are since the row before.",
)
@click.option(
    "--long/--wide",
    "long",
    default=True,
    show_default=True,
    help="Tables: a row per frame and node, or a row per frame.",
)
@click.option("--overwrite", is_flag=True, help="Replace files that are there.")
def export(
    folder: Path,
    to: str,
    output: Path | None,
    nodes: tuple[str, ...],
    long: bool,
    overwrite: bool,
    **chosen: Any,
) -> None:
    """Write the numbers of the run in DIR for other programs.

    csv and parquet make tables (nodes, segments, anchors, joints, pulleys, contacts, rope_contacts,
    wraps, slides, run; those that the run has), npz a NumPy file, vtk a series that ParaView opens.
    Columns carry units.
    """
    from ropewalk.record.errors import InputError
    from ropewalk.record.export import export as write

    rope, numbers = _places(nodes)
    options: dict[str, Any] = {
        key: value for key, value in chosen.items() if value not in (None, ())
    }
    options |= {
        "nodes": numbers,
        "rope": rope,
        "layout": "long" if long else "wide",
        "overwrite": overwrite or output is None,
    }
    out = output or folder / ("run.npz" if to == "npz" else to)
    try:
        paths = write(open_run(folder), to, out, **options)
    except InputError as error:
        flag = _FLAGS.get(error.path, error.path)
        raise Refusal(f"{flag} {_plain(error.value)}: {error.rule}") from error
    for path in paths:
        say(str(path))


def _places(nodes: tuple[str, ...]) -> tuple[str | None, list[int] | None]:
    """Return the one rope that is named, if any, and the nodes' numbers."""
    ropes, numbers = set(), []
    for text in nodes:
        name, _, number = text.rpartition(":")
        ropes.add(name)
        try:
            numbers.append(int(number))
        except ValueError:
            raise Refusal(f"--node {text}: must be a node's number, or ROPE:NODE") from None
    if len(ropes) > 1:
        raise Refusal(f"--node {', '.join(nodes)}: must all be of one rope, or all without a rope")
    return next(iter(ropes), None) or None, numbers or None


def _plain(value: object) -> str:
    if isinstance(value, (list, tuple)):
        return ", ".join(map(str, value))
    return str(value)
