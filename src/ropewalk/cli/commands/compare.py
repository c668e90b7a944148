"""`ropewalk compare`: runs side by side."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ropewalk.cli.console import print_json, print_table, say, tell, warn
from ropewalk.cli.errors import Refusal
from ropewalk.cli.files import free_name, refuse_existing
from ropewalk.cli.progress import RunProgress, tell_compiling
from ropewalk.cli.runs import open_run
from ropewalk.cli.sources import json_option, load_scene, run_options, short_name

if TYPE_CHECKING:
    from ropewalk.analysis.compare import Comparison
    from ropewalk.record.result import Result


@click.command()
@click.argument("runs", nargs=-1, required=True, metavar="A B [C]...")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="The figure, which ends in .png, .svg or .pdf; default: compare-A-B.png.",
)
@click.option(
    "--time",
    "times",
    multiple=True,
    type=float,
    metavar="S",
    help="Show the shapes at this time, in seconds; can be given again.",
)
@run_options
@click.option("--overwrite", is_flag=True, help="Replace a figure that is there.")
@json_option
def compare(
    runs: tuple[str, ...],
    output: Path | None,
    times: tuple[float, ...],
    overrides: tuple[str, ...],
    duration: str | None,
    time_step: str | None,
    method: str | None,
    overwrite: bool,
    as_json: bool,
) -> None:
    """Compare two or more runs with the first of them: numbers, distance in time, one figure.

    Each is a run folder, or a scene file or preset, which is then run in memory; --set and the other
    flags of a run change the scenes that are run.
    """
    if len(runs) < 2:
        raise Refusal(f"{runs[0]}: is one run; name two or more to compare")
    labels = _labels(runs)
    path = output or free_name(Path(f"compare-{'-'.join(map(short_name, runs[:4]))}.png"))
    if path.suffix.lower() not in (".png", ".svg", ".pdf"):
        raise Refusal(f"{path}: must end in .png, .svg or .pdf")
    refuse_existing(path, overwrite=overwrite)
    changes = {"duration": duration, "time_step": time_step, "method": method}
    results = [_result(run, overrides, changes) for run in runs]
    from ropewalk import plots
    from ropewalk.analysis.compare import compare_runs

    found = compare_runs(results, labels)
    try:
        figure = plots.compare(found, times=list(times) or None)
    except ValueError as error:
        raise Refusal(f"--time: {error}" if times else str(error)) from error
    path.parent.mkdir(parents=True, exist_ok=True)
    plots.save(figure, path)
    if as_json:
        settings = {key: list(values) for key, values in found.settings}
        print_json({"runs": found.rows, "settings": settings, "figure": str(path)})
    else:
        _print(found)
        say(f"figure: {path}")


def _result(source: str, overrides: tuple[str, ...], changes: dict[str, str | None]) -> Result:
    """Open a run folder, or run a scene in memory."""
    path = Path(source)
    if path.is_dir():
        return open_run(path)
    scene = load_scene(source, overrides, **changes)
    from ropewalk.api import simulate

    tell_compiling(scene.run.method)
    with RunProgress(scene) as progress:
        result = simulate(scene, on_failure="return", progress=progress)
    if result.diagnosis:
        warn(f"{source}: {result.diagnosis}")
    elif result.status != "finished":
        tell(f"{source}: {result.status}")
    return result


def _labels(runs: Sequence[str]) -> list[str]:
    """Return a different name for each run: its folder's, file's or preset's, numbered if need be."""
    names = [short_name(run) for run in runs]
    if len(set(names)) < len(names):
        names = [run.rstrip("/") for run in runs]
    seen: dict[str, int] = {}
    labels = []
    for name in names:
        seen[name] = seen.get(name, 0) + 1
        labels.append(name if seen[name] == 1 else f"{name} ({seen[name]})")
    return labels


def _print(found: Comparison) -> None:
    rows = found.rows
    facts = [key for key in rows[0] if key != "run"]
    numbers = range(1, len(rows) + 1)
    table = [(fact, *(_text(row[fact]) for row in rows)) for fact in facts]
    print_table(("", *found.labels), table, right=numbers)
    if found.settings:
        settings = [(path, *values) for path, values in found.settings]
        print_table(("what differs", *found.labels), settings, right=numbers)


def _text(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.5g}" if value == value else "-"
    return str(value)
