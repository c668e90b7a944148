"""`ropewalk resume`: go on with a run that was killed or interrupted."""

from __future__ import annotations

import warnings
from pathlib import Path

import click

from ropewalk.cli.commands.run import conclude, quiet_option
from ropewalk.cli.commands.sweep import on_options
from ropewalk.cli.console import warn
from ropewalk.cli.failures import Refusal
from ropewalk.cli.progress import RunProgress, tell_compiling
from ropewalk.cli.run_argument import is_sweep, open_run, run_argument
from ropewalk.cli.scene_argument import json_option
from ropewalk.cli.startup import without_scipy


@click.command()
@run_argument
@click.option(
    "--force",
    is_flag=True,
    help="Even if another version of Ropewalk began the run; it may then not go on to the same bits.",
)
@on_options
@json_option
@quiet_option
def resume(
    folder: Path, force: bool, on: str | None, workers: int | None, as_json: bool, quiet: bool
) -> int:
    """Go on with the run or sweep in DIR where it was killed or interrupted.

    It goes on to the same bits as one that was never interrupted.
    """
    if is_sweep(folder):
        from ropewalk.cli.commands.sweep import resume_folder

        return resume_folder(folder, on, workers, force=force, as_json=as_json, quiet=quiet)
    with without_scipy(), warnings.catch_warnings(record=True) as caught:
        from ropewalk.api import explain
        from ropewalk.record.resume import resume_run

        begun = open_run(folder)  # first: of what is no run, or not yet a sweep, that is told
        if on is not None or workers is not None:
            raise Refusal("--on, --workers: are of sweeps; a run goes on in this process")
        if not quiet:
            tell_compiling(begun.plan.method, begun.scene)
        warnings.simplefilter("always", UserWarning)
        with RunProgress(begun.scene, quiet=quiet) as progress:
            result = resume_run(folder, force=force, progress=progress, explain=explain)
    texts = tuple(str(one.message) for one in caught if one.category is UserWarning)
    if not quiet:
        for text in texts:
            warn(text)
    return conclude(result, texts, as_json=as_json, quiet=quiet)
