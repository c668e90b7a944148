"""`ropewalk sweep`: many runs of one scene; what resume, info and plot do with its folder."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from ropewalk.cli.console import print_json, print_table, say, tell, warn
from ropewalk.cli.failures import INTERRUPTED, Refusal
from ropewalk.cli.output_files import claimed, refuse_parent, warn_of_left
from ropewalk.cli.progress import tell_compiling
from ropewalk.cli.scene_argument import json_option, load_scene, run_options, short_name
from ropewalk.words.counts import counted
from ropewalk.words.shell import typed

SWEEPS = Path("sweeps")
_TOLD = 20  # damaged files


def on_options(command: Any) -> Any:
    """Give a command the options that say who makes the runs."""
    workers = click.option(
        "--workers", type=click.IntRange(1), metavar="N", help="Processes of local."
    )
    on = click.option(
        "--on",
        metavar="WHERE",
        help='Address of a Dask scheduler, "local" (all cores here) or "here" (one process).',
    )
    return on(workers(command))


@click.command()
@click.argument("scene")
@click.option(
    "--vary",
    "varied",
    multiple=True,
    required=True,
    metavar="PATH=WHAT",
    help="What to vary, as in --set: a list 1e4,1e5,1e6, a range 9.5..10.5 m, linspace(1, 2, 5), or a "
    "distribution of scipy.stats such as norm(1e5, 5e3), or uniform(3, 0.5), low and width: from 3 to 3.5; "
    "can be given again.",
)
@click.option("--samples", type=int, metavar="N", help="Draw N runs; without it lists make a grid.")
@click.option("--design", default="sobol", show_default=True, help="sobol, lhs, halton or random.")
@click.option("--seed", type=int, help="Of the samples; default: a new one, which info tells.")
@click.option(
    "--keep",
    multiple=True,
    metavar="WHAT",
    help="What to keep of every run, such as tension.max, positions[-1] or sag.max[time]; can be given "
    "again. Default: largest tension and reactions, last positions.",
)
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="The sweep's folder; default: sweeps/NAME-1, -2 and so on.",
)
@on_options
@click.option("--rest", is_flag=True, help="Find each scene's equilibrium instead of running it.")
@run_options
@click.option("--overwrite", is_flag=True, help="Replace a sweep that is in DIR.")
@json_option
def sweep(
    scene: str,
    varied: tuple[str, ...],
    samples: int | None,
    design: str,
    seed: int | None,
    keep: tuple[str, ...],
    output: Path | None,
    on: str | None,
    workers: int | None,
    rest: bool,
    overrides: tuple[str, ...],
    duration: str | None,
    time_step: str | None,
    method: str | None,
    overwrite: bool,
    as_json: bool,
) -> int:
    """Run a scene many times with other values, into a folder.

    Lists make a grid; with --samples, ranges, distributions and lists are drawn from. Everything wrong
    at the corners is told before anything runs. A run that breaks is a result like others. Killed at any
    moment, the sweep goes on with `ropewalk resume DIR`, to the same bits.
    """
    from ropewalk.sweeps.many import sweep as make
    from ropewalk.sweeps.spread_text import parse_all, parse_vary

    loaded = load_scene(scene, overrides, duration=duration, time_step=time_step, method=method)
    vary = parse_all("--vary", parse_vary, varied)
    if output is not None:
        refuse_parent(output)
    tell_compiling(loaded.run.method, loaded)
    asked: dict[str, Any] = {
        "keep": keep or None,
        "samples": samples,
        "design": design,
        "seed": seed,
    }
    asked |= {"on": on, "workers": workers, "what": "rest" if rest else "run"}
    with claimed(output, SWEEPS, short_name(scene)) as folder, telling():
        status = ended(
            folder, lambda: make(loaded, vary, store=folder, overwrite=overwrite, **asked), as_json
        )
        if overwrite:
            warn_of_left(folder, "sweep")
        return status


def resume_folder(
    folder: Path,
    on: str | None,
    workers: int | None,
    *,
    force: bool,
    as_json: bool,
    quiet: bool = False,
) -> int:
    """Go on with the sweep in a folder."""
    from ropewalk.cli.bands_table import tell_bands
    from ropewalk.sweeps.many import resume_sweep
    from ropewalk.sweeps.sweep_folder import SweepFolder
    from ropewalk.sweeps.uncertainty import is_uncertain

    uncertain = is_uncertain(SweepFolder.open(folder).plan)
    how: dict[str, Any] = {"on": on, "workers": workers, "force": force}
    how |= {"progress": False} if quiet else {}
    with telling(quiet=quiet):
        return ended(
            folder,
            lambda: resume_sweep(folder, **how),
            as_json,
            tell_bands if uncertain else None,
            fresh=False,
            quiet=quiet,
        )


@contextmanager
def telling(*, quiet: bool = False) -> Iterator[None]:
    """Print warnings as the command line does."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore" if quiet else "always", UserWarning)
        warnings.showwarning = lambda message, *_, **__: warn(str(message))
        yield


def ended(
    folder: Path,
    make: Callable[[], Any],
    as_json: bool,
    finish: Callable[..., None] | None = None,
    *,
    fresh: bool = True,
    quiet: bool = False,
) -> int:
    """Make a sweep and print how it ended, by `finish` or as `info` does; return the exit status.

    `fresh` unless it goes on with the one that is in the folder. `quiet` prints the folder alone.
    """
    from ropewalk.sweeps.sweep_folder import SweepFolder, is_sweep

    before = _id(folder) if fresh else ""
    try:
        make()
    except KeyboardInterrupt:
        if not is_sweep(folder) or _id(folder) == before:  # that would be overwritten
            raise
        found = SweepFolder.open(folder)
        done = sum(len(found.plan.rows(number)) for number in found.standing()[0])
        tell(f"interrupted: {done} of {counted(found.plan.runs, 'run')} are stored")
        tell(f"go on with: ropewalk resume {typed(folder)}")
        return INTERRUPTED
    if finish is not None:
        finish(folder, as_json=as_json, quiet=quiet)
    elif quiet and not as_json:
        say(str(folder))
    else:
        info_folder(folder, as_json=as_json)
    return 0


def _id(folder: Path) -> str:
    """Return which sweep a folder holds; "" for none that can be read."""
    from ropewalk.record.errors import RunError
    from ropewalk.sweeps.sweep_folder import SweepFolder

    try:
        return SweepFolder.open(folder).plan.id
    except RunError:
        return ""


def info_folder(folder: Path, *, as_json: bool, checked: bool = False) -> None:
    """Say what is in a sweep's folder. With `checked` raises Refusal where batches are damaged."""
    from ropewalk.record.note_kinds import noted
    from ropewalk.sweeps.repair import faults
    from ropewalk.sweeps.summary import IN_ROWS, summary
    from ropewalk.sweeps.sweep_folder import SweepFolder
    from ropewalk.sweeps.uncertainty import FEW

    sweep = SweepFolder.open(folder)
    if checked and (wrong := faults(sweep)):
        more = [f"and {len(wrong) - _TOLD} more"] if len(wrong) > _TOLD else []
        raise Refusal("\n".join([*wrong[:_TOLD], *more]))
    found = summary(sweep)
    if as_json:
        print_json({"folder": str(folder), **found})
        return
    say(f"{folder}: {found['title']}")
    ended = ", ".join(f"{count} {how}" for how, count in found["ended"].items())
    seed = "" if found["seed"] is None else f", seed {found['seed']}"
    rows = [
        ("runs", f"{found['done']} of {found['runs']} made: {ended or 'none yet'}"),
        ("design", f"{found['design']}{seed}"),
        ("batches", f"{found['batches done']} of {found['batches']} stored"),
        ("ropewalk", str(found["provenance"].get("ropewalk", ""))),
        ("started", str(found["provenance"].get("started", ""))),
    ]
    print_table(("", ""), rows)
    print_table(("varied", "unit", "spread"), [_varied(p) for p in found["parameters"]])
    columns = ("kept", "unit", "over", "shape", "least", "5 %", "median", "95 %", "largest")
    print_table(columns, [_kept(v) for v in found["kept"]], right=range(4, 9))
    if found["plain"] < found["runs"]:
        say(
            f"5 %, median and 95 % are of {counted(found['sample'], 'run')}, those of a plain sample of "
            f"{found['plain']} that ended well; all others, for Sobol indices, repeat its values"
        )
    if found["design"] in IN_ROWS and 0 < found["done"] < found["runs"]:
        say(
            "5 %, median and 95 % are those of all runs alone: the first ones are no sample of them"
        )
    elif 0 < found["sample"] < FEW and any("quantiles" in one for one in found["kept"]):
        say(
            f"of {counted(found['sample'], 'run')}, 5 % and 95 % are hardly more than the least and the "
            "largest met"
        )
    if notes := noted(found["notes"], found["ended well"]):
        print_table(("noted", "of the runs that ended well"), notes)
    if found["notes"] is None:
        say("what the table of each run warns of was not kept yet when this sweep was made")
    causes = [(str(count), why) for why, count in found["causes"].items()]
    if causes:
        say("the numbers of what was kept are those of the runs that ended well alone")
        print_table(("broken runs", "cause (# is a number that differs)"), causes)
    if found["damaged"]:
        warn(f"{len(found['damaged'])} stored batches are damaged; resume makes them again")
    if found["done"] < found["runs"]:
        say(f"go on with: ropewalk resume {typed(folder)}")
    say(f"sweep folder: {folder}")


def _varied(parameter: dict[str, Any]) -> tuple[str, str, str]:
    return parameter["path"], parameter["unit"], parameter["spread"] or "given values"


def _kept(variable: dict[str, Any]) -> Sequence[str]:
    from ropewalk.sweeps.keep import over

    shape = " x ".join(
        f"{size} {d}" for d, size in zip(variable["dims"], variable["sizes"], strict=True)
    )
    numbers = ["" if value != value else f"{value:.5g}" for value in variable.get("quantiles", ())]
    about = [variable["name"], variable["unit"], over(variable["long_name"]), shape]
    return [*about, *numbers, *[""] * (5 - len(numbers))]
