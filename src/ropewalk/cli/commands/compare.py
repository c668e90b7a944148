"""`ropewalk compare`: runs side by side."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ropewalk.cli.commands.run import refuse_run
from ropewalk.cli.console import print_json, print_table, say, tell, warn
from ropewalk.cli.failures import Refusal
from ropewalk.cli.output_files import free_name, refuse_existing
from ropewalk.cli.progress import RunProgress, tell_compiling
from ropewalk.cli.run_argument import open_run
from ropewalk.cli.scene_argument import json_option, load_scene, named, run_options, short_name

if TYPE_CHECKING:
    from ropewalk.analysis.compare import Comparison
    from ropewalk.record.result import Result
    from ropewalk.scene import Scene


@click.command()
@click.argument("runs", nargs=-1, required=True, metavar="A B [C]...")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="The figure, which ends in .png, .svg or .pdf (default: compare-A-B.png); or a folder, "
    "which gets the figure and keeps the run of every scene that is run.",
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
@click.option("--overwrite", is_flag=True, help="Replace a figure, and runs, that are there.")
@json_option
def compare(
    runs: tuple[str, ...],
    output: Path | None,
    times: tuple[float, ...],
    overrides: tuple[str, ...],
    overwrite: bool,
    as_json: bool,
    **changes: str | None,
) -> None:
    """Compare two or more runs with the first of them: numbers, distance in time, one figure.

    Each is a run folder, or a scene file or preset, which is then run: in memory, or with -o FOLDER
    into a folder in it. --set and the other flags of a run change the scenes that are run.
    """
    if len(runs) < 2:
        raise Refusal(f"{runs[0]}: is one run; name two or more to compare")
    if (overrides or any(changes.values())) and all(Path(run).is_dir() for run in runs):
        raise Refusal("--set and its like change scenes that are run; these are all runs already")
    labels = _labels(runs)
    path, kept = _places(runs, labels, output, overwrite=overwrite)
    scenes = [None if Path(run).is_dir() else load_scene(run, overrides, **changes) for run in runs]
    results = [
        open_run(Path(run)) if scene is None else _run(scene, run, folder, overwrite=overwrite)
        for run, scene, folder in zip(runs, scenes, kept, strict=True)
    ]
    from ropewalk import plots
    from ropewalk.analysis.compare import compare_runs

    found = compare_runs(results, labels)
    try:
        figure = plots.compare(found, times=list(times) or None)
    except ValueError as error:
        raise Refusal(f"--time: {error}" if times else str(error)) from error
    path.parent.mkdir(parents=True, exist_ok=True)
    plots.save(figure, path)
    folders = [result.folder for result in results]
    if as_json:
        settings = {key: list(values) for key, values in found.settings}
        print_json(
            {"runs": found.rows, "settings": settings, "folders": folders, "figure": str(path)}
        )
    else:
        _print(found)
        say(f"figure: {path}")


def _places(
    runs: Sequence[str], labels: Sequence[str], output: Path | None, *, overwrite: bool
) -> tuple[Path, list[Path | None]]:
    """Return where the figure goes, and the folder that keeps each run, if any.

    Raises Refusal, before anything is run, for what must not be written to.
    """
    nowhere: list[Path | None] = [None for _ in runs]
    if output is None:
        return free_name(Path(f"compare-{'-'.join(map(short_name, runs[:4]))}.png")), nowhere
    if output.suffix and not output.is_dir():
        if output.suffix.lower() not in (".png", ".svg", ".pdf"):
            raise Refusal(f"{output}: must end in .png, .svg or .pdf, or be a folder")
        refuse_existing(output, overwrite=overwrite)
        return output, nowhere
    figure = output / "compare.png"
    refuse_existing(figure, overwrite=overwrite)
    kept, taken = list[Path | None](), set[str]()
    for run, label in zip(runs, labels, strict=True):
        kept.append(None)
        if not Path(run).is_dir():
            name = _free(short_name(label.replace("/", "-")), taken)
            kept[-1] = output / name
            refuse_run(output / name, overwrite)
    return figure, kept


def _free(name: str, taken: set[str]) -> str:
    """Return a name that none has taken yet, numbered if need be, and take it; case makes no difference."""
    numbered = (name if number == 1 else f"{name}-{number}" for number in count(1))
    free = next(one for one in numbered if one.casefold() not in taken)
    taken.add(free.casefold())
    return free


def _run(scene: Scene, source: str, folder: Path | None, *, overwrite: bool) -> Result:
    """Run a scene, in memory or into a folder."""
    from ropewalk import api

    tell_compiling(scene.run.method, scene)
    with named(source), RunProgress(scene) as progress:
        result = (
            api.simulate(scene, on_failure="return", progress=progress)
            if folder is None
            else api.run(scene, folder, on_failure="return", overwrite=overwrite, progress=progress)
        )
    if result.diagnosis:
        warn(f"{source}: {result.diagnosis}")
    elif result.status != "finished":
        tell(f"{source}: {result.status}")
    if folder is not None:
        tell(f"{source}: kept in {folder}")
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
