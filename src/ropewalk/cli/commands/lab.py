"""`ropewalk lab`: a page in which ropes run in the browser itself."""

from __future__ import annotations

from pathlib import Path

import click

from ropewalk.cli.console import say
from ropewalk.cli.failures import Refusal
from ropewalk.cli.output_files import free_name, refuse_existing
from ropewalk.cli.scene_argument import load_scene, named, set_option


@click.command()
@click.argument("scenes", nargs=-1, metavar="[SCENE]...")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="File that ends in .html; default: lab.html.",
)
@click.option("--lessons", is_flag=True, help="Add the scenes of the five lessons for a class.")
@set_option
@click.option("--overwrite", is_flag=True, help="Replace a file that is there.")
def lab(
    scenes: tuple[str, ...],
    output: Path | None,
    lessons: bool,
    overrides: tuple[str, ...],
    overwrite: bool,
) -> None:
    """Write a page in which ropes run in the browser itself: no server, no network, no Python.

    A visitor changes spring constant, friction, mass, step, method and gravity, pulls the rope, measures any
    node, and breaks it; a meter says what step holds. By default with the student report's ropes. SCENE may
    have springs or materials, friction, loads, kicks, anchors that stand, move straight or let go, and posts:
    cylinders, capsules, spheres and planes that stand still.
    """
    path = output or free_name(Path("lab.html"))
    if path.suffix.lower() not in (".html", ".htm"):
        raise Refusal(f"{path}: must end in .html")
    if overrides and not scenes:
        raise Refusal("--set changes the scenes that are named: name one, such as r4")
    refuse_existing(path, overwrite=overwrite)
    from ropewalk.live.lab import lab_scene, write_lab

    loaded = [load_scene(source, overrides) for source in scenes]
    for source, scene in zip(scenes, loaded, strict=True):
        with named(source):
            lab_scene(scene)
    if lessons:
        from ropewalk.lessons import lesson_scenes

        loaded = [*lesson_scenes(), *loaded]
    write_lab(path, loaded)
    say(str(path))
