"""`ropewalk sheet`: the report of a job, as HTML or PDF."""

from __future__ import annotations

from pathlib import Path

import click

from ropewalk.cli.console import print_json, say, tell
from ropewalk.cli.failures import BROKE, Refusal
from ropewalk.cli.output_files import free_name, refuse_existing
from ropewalk.cli.progress import tell_compiling
from ropewalk.cli.scene_argument import (
    as_flags,
    json_option,
    load_scene,
    run_options,
    short_name,
)


@click.command()
@click.argument("scene")
@click.option(
    "-o",
    "--output",
    "outputs",
    multiple=True,
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="File to write, .html or .pdf; can be given again. Default: NAME-sheet.html.",
)
@click.option("--at-rest", is_flag=True, help="Do not run it: the scene at rest alone.")
@click.option(
    "--no-convergence",
    is_flag=True,
    help="Do not compute it again with half the segments, half the step and a guessed stiffness's ends.",
)
@click.option(
    "--uncertain",
    "spreads",
    multiple=True,
    metavar="PATH=SPREAD",
    help="A value that is not known, as of `run --uncertain`; can be given again.",
)
@click.option(
    "--samples",
    type=click.IntRange(2),
    default=64,
    show_default=True,
    help="Base samples of what is not known.",
)
@run_options
@click.option("--overwrite", is_flag=True, help="Replace files that are there.")
@click.option("-q", "--quiet", is_flag=True, help="Do not say what is done.")
@json_option
def sheet(
    scene: str,
    outputs: tuple[Path, ...],
    at_rest: bool,
    no_convergence: bool,
    spreads: tuple[str, ...],
    samples: int,
    overrides: tuple[str, ...],
    duration: str | None,
    time_step: str | None,
    method: str | None,
    overwrite: bool,
    quiet: bool,
    as_json: bool,
) -> int:
    """Write the sheet of a job: one scene, for who must sign for it.

    A drawing with dimensions, the ropes and where their numbers come from, what is taken for granted, sag,
    tensions and anchor forces at rest and in the run, utilisation, method and energy error, how the numbers
    change with half the segments, half the step and both ends of a guessed stiffness, versions, and the
    scene itself. Ends with the status of `run` when the run breaks.
    """
    loaded = load_scene(scene, overrides, duration=duration, time_step=time_step, method=method)
    paths = outputs or (free_name(Path(f"{short_name(scene)}-sheet.html")),)
    _check(paths, overwrite)
    from ropewalk.sheets import sheet as make
    from ropewalk.sweeps.spread_text import parse_all, parse_uncertain

    vary = parse_all("--uncertain", parse_uncertain, spreads)
    if not at_rest:
        tell_compiling(loaded.run.method, loaded)
    made = make(
        loaded,
        run=not at_rest,
        convergence=not no_convergence,
        uncertain=vary or None,
        samples=samples,
        file=scene,
        flags=as_flags(overrides, duration=duration, time_step=time_step),
        progress=None if quiet or as_json else tell,
    )
    for path in paths:
        made.save(path)
    if as_json:
        print_json(made.as_dict() | {"files": [str(path) for path in paths]})
    else:
        for path in paths:
            say(str(path))
    broke = made.result is not None and bool(made.result.diagnosis)
    return BROKE if broke else 0


def _check(paths: tuple[Path, ...], overwrite: bool) -> None:
    """Refuse, before anything is computed, what could not be written."""
    from importlib.util import find_spec

    from ropewalk.sheets.document import format_of

    for path in paths:
        try:
            kind = format_of(path)
        except ValueError as error:
            raise Refusal(str(error)) from None
        if kind == "pdf" and find_spec("reportlab") is None:
            raise Refusal(
                f"{path}: a PDF needs reportlab: pip install 'ropewalk[sheet]', or write .html and print it"
            )
        refuse_existing(path, overwrite=overwrite)
