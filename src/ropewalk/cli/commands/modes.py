"""`ropewalk modes`: how a scene rings."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ropewalk.cli.console import print_json, print_table, say
from ropewalk.cli.failures import Refusal
from ropewalk.cli.output_files import refuse_existing
from ropewalk.cli.progress import telling_of_compiling
from ropewalk.cli.scene_argument import json_option, load_scene, set_option

if TYPE_CHECKING:
    from ropewalk.vibration import Modes


@click.command()
@click.argument("scene")
@click.option(
    "--count",
    type=click.IntRange(1, 1000),
    default=10,
    show_default=True,
    metavar="N",
    help="How many modes: those of the lowest natural (undamped) frequencies, in their order.",
)
@click.option(
    "--about",
    type=click.Choice(["equilibrium", "start"]),
    default="equilibrium",
    show_default=True,
    help="The shape they are about: at rest, or as the scene starts.",
)
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Draw the modes' shapes into a file that ends in .png, .svg or .pdf.",
)
@set_option
@click.option("--overwrite", is_flag=True, help="Replace a figure that is there.")
@json_option
def modes(
    scene: str,
    count: int,
    about: str,
    output: Path | None,
    overrides: tuple[str, ...],
    overwrite: bool,
    as_json: bool,
) -> None:
    """Find the natural frequencies of a scene, with shapes and damping, without running it.

    Small motions about the shape in which the scene is at rest. The damping ratio comes from the scene's
    friction and drag; a mode that creeps does not ring at all. A run begins in a mode with:
    run.start = "at-rest" and run.ring = {mode = 3, speed = 0.1}.
    """
    loaded = load_scene(scene, overrides)
    if output is not None:
        from ropewalk.plots.figure_files import FORMATS

        if output.suffix.lower().removeprefix(".") not in FORMATS:
            raise Refusal(f"{output}: must end in .{', .'.join(FORMATS)}")
        refuse_existing(output, overwrite=overwrite)
    from ropewalk.api import modes as find_modes

    with telling_of_compiling():
        found = find_modes(loaded, about, count)  # type: ignore[arg-type]
    if output is not None:
        from ropewalk import plots

        output.parent.mkdir(parents=True, exist_ok=True)
        plots.save(found.plot.mode_shapes(), output)
    if as_json:
        print_json(
            {"name": loaded.name, "about": about, "modes": found.table, "notes": found.notes}
        )
        return
    _print(found)
    for note in found.notes:
        say(f"note: {note}")
    if output is not None:
        say(str(output))


def _print(found: Modes) -> None:
    several = len(found.layout.ropes) > 1
    rows = []
    for row in found.table:
        cells = (
            str(row["mode"]),
            f"{row['frequency [Hz]']:.6g} Hz",
            f"{row['damping ratio [1]']:.4g}",
            _decay(row["decay rate [1/s]"]),
            _motion(row),
        )
        rows.append((*cells, row["rope"]) if several else cells)
    columns = ("mode", "frequency", "damping ratio", "falls to 1/e in", "motion, half waves")
    title = f"{found.scene.name}: modes about its {found.about}"
    print_table((*columns, "rope") if several else columns, rows, title=title, right=range(4))


def _motion(row: dict[str, Any]) -> str:
    if row["motion"] == "turns":
        return f"{row['rope']} turns"
    return f"{row['motion']}, {row['half waves']}"


def _decay(rate: float) -> str:
    if rate == 0.0:
        return "never"
    return f"{1.0 / rate:.4g} s" if rate > 0.0 else f"grows, x e in {-1.0 / rate:.4g} s"
