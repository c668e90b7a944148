"""`ropewalk check`: what can be said of a scene before it runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from ropewalk.cli.console import print_json, say, warn
from ropewalk.cli.failures import BROKE
from ropewalk.cli.progress import telling_of_compiling
from ropewalk.cli.scene_argument import as_flags, json_option, load_scene, run_options

if TYPE_CHECKING:
    from ropewalk.analysis.check import Check


@click.command()
@click.argument("scene")
@run_options
@click.option("--all", "all_methods", is_flag=True, help="Tell of every method and of waves, too.")
@json_option
def check(
    scene: str,
    overrides: tuple[str, ...],
    duration: str | None,
    time_step: str | None,
    method: str | None,
    all_methods: bool,
    as_json: bool,
) -> int:
    """Say whether a scene will run, and what to expect of it.

    Prints sag, tension and strain at rest, how long the run takes, whether its step is stable and by what
    margin, and warnings of likely slips of units; with --all the largest stable step of every method, what
    decides it, and wave speeds. Nothing is run or written.

    Exit status 3 when the run is expected to break, else 0.
    """
    from ropewalk.analysis.check import check as check_scene
    from ropewalk.scene.as_given import as_given

    loaded = load_scene(scene, overrides, duration=duration, time_step=time_step, method=method)
    with telling_of_compiling():
        found = check_scene(loaded)
    flags = as_flags(overrides, duration=duration, time_step=time_step)
    given = as_given(scene, loaded, flags)
    if as_json:
        quantities = {"as_given": [one._asdict() for one in given]}
        print_json({"scene": scene} | found.as_dict() | quantities)
    else:
        _print(found, all_methods)
        for one in given:
            say(f"as given: {one}")
    return 0 if found.ok else BROKE


def _print(found: Check, all_methods: bool) -> None:
    lines = found.lines(all_methods=all_methods)
    for line in lines:
        if not line.startswith("warning: "):
            say(line)
    for text in found.warnings:
        warn(text)
