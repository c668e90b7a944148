"""`ropewalk plot`: figures of a run."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from inspect import signature
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ropewalk.cli.console import say
from ropewalk.cli.failures import Refusal
from ropewalk.cli.output_files import refuse_existing
from ropewalk.cli.run_argument import is_sweep, open_run, parse_node, run_argument
from ropewalk.words.nearest import nearest

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_TAKES = {
    **dict.fromkeys(("times", "time", "frames"), "--time"),
    **dict.fromkeys(("nodes", "node"), "--node"),
}


@click.command()
@run_argument
@click.argument("kinds", nargs=-1, metavar="[KIND]...")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path), help="Folder, or the file of one figure; "
    "default DIR/figures.",
)  # fmt: skip
@click.option(
    "--format",
    "formats",
    default="png",
    show_default=True,
    help="png, svg, pdf, or several: png,svg.",
)
@click.option(
    "--time",
    "times",
    multiple=True,
    type=float,
    metavar="S",
    help="Show this time, in seconds; can be given again.",
)
@click.option(
    "--node",
    "nodes",
    multiple=True,
    metavar="[ROPE:]NODE",
    help="Show this node, such as 5, -1 or left:5; can be given again.",
)
@click.option("--overwrite", is_flag=True, help="Replace figures that are there.")
def plot(
    folder: Path,
    kinds: tuple[str, ...],
    output: Path | None,
    formats: str,
    times: tuple[float, ...],
    nodes: tuple[str, ...],
    overwrite: bool,
) -> None:
    """Draw figures of the run in DIR.

    \b
    KIND is one or more of (default: all of them; of an equilibrium: forces):
      shape      the ropes at some times (--time)
      film       the rope over time as a strip of pictures (--time)
      height     height of nodes against time (--node)
      tension    tension along the rope and in time (--time for profiles)
      energy     energies, works and the energy error
      phase      velocity against position of a node (--node)
      reactions  force of each anchor on its rope
      forces     the last frame coloured by tension, with the anchors' forces
      contact    forces of contacts and tension along the ropes (--time)
      sticking   which nodes stick and which slip, against time
    Of a sweep, KIND is a name of what it kept, such as tension_max.
    """
    if is_sweep(folder):
        _refuse_of_sweeps(times, nodes)
        plot_sweep(folder, kinds, output, formats, overwrite)
        return
    result = open_run(folder)
    from ropewalk import plots

    at_rest = result.status == "at rest"
    chosen = _chosen(kinds or (("forces",) if at_rest else ()), list(plots.PLOTS))
    endings = _endings(formats, plots.FORMATS)
    targets = _targets(folder, output, chosen, endings, plots.FORMATS)
    _refuse_unused(chosen, plots.PLOTS, times=times, nodes=nodes)
    for path in (path for kind in chosen for path in targets[kind]):
        refuse_existing(path, overwrite=overwrite or output is None)
    for kind in chosen:
        if not kinds and not plots.PLOTS[kind].there(result):
            continue  # nothing to draw, and nobody asked for it
        figure = draw(plots.PLOTS[kind].draw, result, times, nodes)
        for path in targets[kind]:
            path.parent.mkdir(parents=True, exist_ok=True)
            say(str(plots.save(figure, path)))


def plot_sweep(
    folder: Path, kinds: Sequence[str], output: Path | None, formats: str, overwrite: bool
) -> None:
    """Draw what a sweep kept, one figure each."""
    from ropewalk import plots
    from ropewalk.plots.sweeps import drawable
    from ropewalk.sweeps.answer import open_sweep

    data = open_sweep(folder)
    known = drawable(data)
    if not known:
        raise Refusal(f"{folder}: keeps nothing that can be drawn; keep maxima, or [time] of them")
    chosen, endings = _chosen(kinds, known), _endings(formats, plots.FORMATS)
    targets = _targets(folder, output, chosen, endings, plots.FORMATS)
    for kind in chosen:
        try:
            figure = plots.sweep(data, kind)
        except ValueError as error:
            raise Refusal(f"{folder}: {error}") from error
        for path in targets[kind]:
            refuse_existing(path, overwrite=overwrite or output is None)
            path.parent.mkdir(parents=True, exist_ok=True)
            say(str(plots.save(figure, path)))


def _refuse_of_sweeps(times: Sequence[float], nodes: Sequence[str]) -> None:
    for flag, given in (("--time", times), ("--node", nodes)):
        if given:
            raise Refusal(f"{flag}: figures of a sweep take none; leave it out")


def draw(
    function: Callable[..., Any], result: Result, times: Sequence[float], nodes: Sequence[str]
) -> Any:
    """Draw one figure with those of the options that it takes.

    Raises Refusal for a time or a node that is not there.
    """
    takes = signature(function).parameters
    options: dict[str, Any] = {}
    parsed = [parse_node(node, result) for node in nodes]
    if times and "times" in takes:
        options["times"] = list(times)
    elif times and "time" in takes:
        options["time"] = _one(times)
    elif times and "frames" in takes:
        _refuse_times(times, result)
        options["frames"] = [result.frame_at(time) for time in times]
    if parsed and "nodes" in takes:
        options["nodes"] = parsed
    elif parsed and "node" in takes:
        options["node"] = parsed[0]
    try:
        return function(result, **options)
    except ValueError as error:
        raise Refusal(f"{result.folder}: {error}") from error


def _one(times: Sequence[float]) -> float:
    if len(times) > 1:
        raise Refusal("--time: contact shows one; give it once")
    return times[0]


def _refuse_times(times: Sequence[float], result: Result) -> None:
    end = float(result.time[-1])
    for time in times:
        if not 0.0 <= time <= end:
            raise Refusal(
                f"--time {time:g}: must be from 0 to {end:g} s, the time of the last frame"
            )


def _chosen(kinds: Sequence[str], known: list[str]) -> list[str]:
    for kind in kinds:
        if kind not in known:
            raise Refusal(f'KIND: "{kind}" - there is no such figure; {nearest(kind, known)}')
    return list(dict.fromkeys(kinds)) or known


def _endings(formats: str, known: Sequence[str]) -> list[str]:
    endings = [part.strip().lower().removeprefix(".") for part in formats.split(",")]
    for ending in endings:
        if ending not in known:
            raise Refusal(f'--format: "{ending}" - must be one or more of {", ".join(known)}')
    return list(dict.fromkeys(endings))


def _targets(
    folder: Path, output: Path | None, kinds: list[str], endings: list[str], known: Sequence[str]
) -> dict[str, list[Path]]:
    """Return the files of every figure."""
    if output is not None and output.suffix.lower().removeprefix(".") in known:
        if len(kinds) > 1:
            raise Refusal(
                f"{output}: is one file, and these are {len(kinds)} figures; name a folder"
            )
        return {kinds[0]: [output]}
    where = output or folder / "figures"
    return {kind: [where / f"{kind}.{ending}" for ending in endings] for kind in kinds}


def _refuse_unused(kinds: list[str], known: dict[str, Any], **given: Sequence[object]) -> None:
    """Refuse --time or --node when no figure takes it."""
    used = {
        _TAKES[name]
        for kind in kinds
        for name in signature(known[kind].draw).parameters
        if name in _TAKES
    }
    for name, values in given.items():
        flag = _TAKES[name]
        if values and flag not in used:
            raise Refusal(f"{flag}: {', '.join(kinds)} takes none; leave it out")
