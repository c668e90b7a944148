"""`ropewalk run`: run a scene into a folder."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from ropewalk.cli.console import say, tell, warn
from ropewalk.cli.failures import BROKE, INTERRUPTED, Refusal
from ropewalk.cli.output_files import claimed, refuse_parent, warn_of_left
from ropewalk.cli.progress import RunProgress, tell_compiling
from ropewalk.cli.results_table import print_result_json, print_results
from ropewalk.cli.scene_argument import json_option, load_scene, run_options, short_name
from ropewalk.cli.startup import without_scipy
from ropewalk.words.shell import typed

if TYPE_CHECKING:
    from ropewalk.lowering import Model
    from ropewalk.record.parted import Parting
    from ropewalk.record.result import Result
    from ropewalk.scene import Scene

RUNS = Path("runs")
_NAMED = 3  # partings that are told one by one

quiet_option = click.option(
    "-q", "--quiet", is_flag=True, help="No progress, no table: print the run's folder only."
)


@click.command()
@click.argument("scene")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="The run's folder; default: runs/NAME-1, -2 and so on.",
)
@run_options
@click.option("--keep-going", is_flag=True, help="Record on into a break, to the planned end.")
@click.option(
    "--uncertain",
    "spreads",
    multiple=True,
    metavar="PATH=SPREAD",
    help="A value that is not known exactly: a range 9.5..10.5, norm(1e5, 5e3), or 10% below and above the "
    "scene's. Then many runs are made, and bands for tension, sag and anchor forces printed and drawn; "
    "can be given again.",
)
@click.option("--samples", type=click.IntRange(2), metavar="N", help="Of --uncertain; default 256.")
@click.option(
    "--seed",
    type=click.IntRange(0),
    help="Of --uncertain's samples; default: a new one, which is told.",
)
@click.option("--overwrite", is_flag=True, help="Replace a run that is in DIR.")
@json_option
@quiet_option
def run(
    scene: str,
    output: Path | None,
    spreads: tuple[str, ...],
    samples: int | None,
    seed: int | None,
    overrides: tuple[str, ...],
    duration: str | None,
    time_step: str | None,
    method: str | None,
    keep_going: bool,
    overwrite: bool,
    as_json: bool,
    quiet: bool,
) -> int:
    """Run a scene into a folder.

    The folder holds the scene as it was run, where it came from, and all numbers in a form that
    xarray opens; it is written as the run goes on. A run that breaks keeps everything up to its last
    good frame, says why it broke and ends with exit status 3. Ctrl-C ends a run so that it can be
    resumed.
    """
    loaded = load_scene(scene, overrides, duration=duration, time_step=time_step, method=method)
    if spreads:
        from ropewalk.cli.commands.uncertain import run_uncertain

        if keep_going:
            raise Refusal(
                "--keep-going: goes on with one run; those of --uncertain that break have no numbers"
            )
        where = (output, short_name(scene), overwrite)
        drawn = (samples or 256, seed)
        return run_uncertain(loaded, spreads, drawn, where, as_json=as_json, quiet=quiet)
    if samples is not None:
        raise Refusal("--samples: goes with --uncertain; for a sweep see: ropewalk sweep --help")
    if seed is not None:
        raise Refusal("--seed: goes with --uncertain; a run without it draws nothing")
    if output is not None:
        with without_scipy():
            refuse_run(output, overwrite)
    result, warnings = run_scene(
        loaded,
        output,
        short_name(scene),
        keep_going=keep_going,
        overwrite=overwrite,
        quiet=quiet,
    )
    if overwrite and output is not None and not quiet:
        warn_of_left(output, "run")
    return conclude(result, warnings, as_json=as_json, quiet=quiet)


def refuse_run(folder: Path, overwrite: bool) -> None:
    """Refuse, before anything is computed, a folder that a run must not be written to.

    Raises Refusal for a run that is there, RunError for anything else that is in the way.
    """
    from ropewalk.record.place import check_free, is_run

    refuse_parent(folder)
    if not overwrite and is_run(folder):
        raise Refusal(f"{folder}: holds a run already; take another folder, or give --overwrite")
    check_free(folder, overwrite)


def run_scene(
    scene: Scene,
    output: Path | None,
    name: str,
    *,
    parent: Path = RUNS,
    keep_going: bool = False,
    overwrite: bool = False,
    quiet: bool = False,
) -> tuple[Result, tuple[str, ...]]:
    """Run a scene into `output`, or else into the first free folder `parent`/`name`-1, -2 ...

    Returns the result and what was warned of. Raises SceneError, RunError, OSError.
    """
    with without_scipy():
        from ropewalk.api import explain
        from ropewalk.lowering import build
        from ropewalk.record.run import record_run

        model = build(scene)
        if not quiet:
            if model.plan.why:
                tell(model.plan.why)
            tell_compiling(model.plan.method, scene)
        warnings = predicted(model)
        if not quiet:
            for text in warnings:
                warn(text)
        with claimed(output, parent, name) as folder, RunProgress(scene, quiet=quiet) as progress:
            result = record_run(
                model,
                folder,
                keep_going=keep_going,
                overwrite=overwrite,
                progress=progress,
                explain=explain,
            )
    return result, warnings


def predicted(model: Model) -> tuple[str, ...]:
    """Return what is to be warned of before a run: that it will break, or likely slips of units."""
    from ropewalk.analysis.check import check

    return check(model, measure=False).warnings


def conclude(result: Result, warnings: tuple[str, ...] = (), *, as_json: bool, quiet: bool) -> int:
    """Print how a run ended and return the exit status."""
    if as_json:
        print_result_json(result, warnings)
    elif quiet:
        say(str(result.folder))
    else:
        print_results(result, f"{result.scene.name}: {result.status}")
        say(f"run folder: {result.folder}")
    if not quiet:
        _tell_of_events(result)
        _tell_of_partings(result.partings)
    if result.status == "interrupted":
        tell(f"interrupted at t = {result.time[-1]:.6g} s; what there is was kept")
        tell(f"go on with: ropewalk resume {typed(result.folder)}")
        return INTERRUPTED
    if result.diagnosis:
        tell(result.diagnosis)
        if not result.facts.keep_going:
            tell(f"everything up to t = {result.time[-1]:.6g} s is kept in {result.folder}")
            if result.beyond is not None:
                tell(f"see how it broke: ropewalk plot {typed(result.folder)} shape film")
                tell("record on into the break: run it with --keep-going")
        return BROKE
    return 0


def _tell_of_partings(partings: tuple[Parting, ...]) -> None:
    """Say what parted: the first few, and how many more."""
    for parting in partings[:_NAMED]:
        warn(f"a rope parted: {parting}")
    if len(partings) > _NAMED:
        warn(f"and {len(partings) - _NAMED} more segments parted")


def _tell_of_events(result: Result) -> None:
    """Say which winches stood still for want of rope, and what has run off a rope that parted."""
    from ropewalk.record.event_log import RAN_OFF

    for event in result.events:
        if event["event"] == RAN_OFF:
            at = f"{event['time']:.6g} s"
            warn(
                f"slide {event['slide']!r} ran off rope {event['rope']!r} at t = {at}: it had parted"
            )
        if event["event"] == "winch stopped" and event["by"] == "empty drum":
            at = f"{event['time']:.6g} s"
            warn(f"winch {event['winch']!r} stopped at t = {at}: its drum was empty")
