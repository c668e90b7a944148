"""`ropewalk line`: set up a line by what one knows of it, and roll a load along it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ropewalk.cli.console import print_json, print_table, say
from ropewalk.cli.failures import Refusal
from ropewalk.cli.output_files import refuse_existing
from ropewalk.cli.scene_argument import json_option

if TYPE_CHECKING:
    from ropewalk.rigging import Line, Rolling

_SHOWN = 9  # places of the load in the table
_SEGMENTS = 60  # of the scene that is written


@click.command()
@click.argument("rope")
@click.option("--span", required=True, metavar="M", help="Horizontal distance of the ends.")
@click.option(
    "--rise", default="0", show_default=True, metavar="M", help="How much higher the second end is."
)
@click.option("--sag", metavar="M", help='Largest drop below the straight line: "3 m", "2 %".')
@click.option("--pretension", metavar="N", help='Tension at the first end: "15 kN".')
@click.option("--length", metavar="M", help="Length without tension.")
@click.option("--load", metavar="KG", help="Mass that rolls along it.")
@click.option("--held", is_flag=True, help="The trolley grips the rope; else it rolls free.")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write a scene, the load in its middle (.toml), or draw how it rolls (.png, .svg, .pdf).",
)
@click.option("--overwrite", is_flag=True, help="Replace a file that is there.")
@json_option
def line(
    rope: str,
    span: str,
    rise: str,
    sag: str | None,
    pretension: str | None,
    length: str | None,
    load: str | None,
    held: bool,
    output: Path | None,
    overwrite: bool,
    as_json: bool,
) -> None:
    """Set up a line of the library's ROPE by sag, pretension or length; roll a load along it.

    At rest, under its own weight. Numbers may have units: --span "300 m" --sag "2 %" --load "80 kg".
    Gives the length to cut, tensions, forces on the anchors, and how near to breaking.
    """
    from ropewalk.rigging import line as set_up
    from ropewalk.rigging.lines import quantity
    from ropewalk.scene.toml_text import as_value

    if output is not None:
        _check_output(output, load)
        refuse_existing(output, overwrite=overwrite)
    given = {"sag": sag, "pretension": pretension, "length": length}
    numbers = {name: as_value(text) for name, text in given.items() if text is not None}
    higher = quantity("rise", as_value(rise), "m", any_sign=True)
    mass = quantity("load", as_value(load), "kg") if load is not None else None
    found = set_up(as_value(span), higher, rope, **numbers)
    rolled = found.rolling(mass, held=held) if mass is not None else None
    if output is not None:
        _write(found, mass, rolled, output)
    if as_json:
        print_json(_facts(found, rolled))
        return
    for text in found.lines():
        say(text)
    if rolled is not None:
        _print(rolled)
    if output is not None:
        say(str(output))
        if rolled is not None and output.suffix.lower() == ".toml":
            say(f"in this scene the load hangs still at the middle, node {_SEGMENTS // 2}")


def _check_output(output: Path, load: str | None) -> None:
    from ropewalk.plots.figure_files import FORMATS

    kind = output.suffix.lower().removeprefix(".")
    if kind not in ("toml", *FORMATS):
        raise Refusal(f"{output}: must end in .toml, .{', .'.join(FORMATS)}")
    if kind != "toml" and load is None:
        raise Refusal(f"{output}: a figure needs a load that rolls (--load)")


def _write(found: Line, mass: float | None, rolled: Rolling | None, output: Path) -> None:
    output.parent.mkdir(parents=True, exist_ok=True)
    if output.suffix.lower() == ".toml":
        from ropewalk.scene import Load, save

        loads = [] if mass is None else [Load(node=_SEGMENTS // 2, mass=mass)]
        save(found.scene(_SEGMENTS, name=output.stem, loads=loads), output)
    elif rolled is not None:
        from ropewalk import plots

        plots.save(rolled.figure(), output)


def _print(rolled: Rolling) -> None:
    import numpy as np

    from ropewalk.scene.guess import guesses_of

    for text in rolled.lines():
        say(text)
    first, last = (np.hypot(*forces.T) for forces in (rolled.anchor_start, rolled.anchor_end))
    columns = {
        "place m": rolled.place,
        "height m": rolled.height,
        "sag m": rolled.sag,
        "largest tension N": rolled.largest_tension,
        "first anchor N": first,
        "second anchor N": last,
    }
    if rolled.utilisation is not None:
        guessed = "breaking_load" in guesses_of(rolled.line.material)
        columns[f"{'~' * guessed}utilisation %"] = 100.0 * rolled.utilisation
    step = max(1, rolled.place.size // _SHOWN)
    rows = [
        [f"{column[i]:.5g}" for column in columns.values()]
        for i in range(step // 2, rolled.place.size, step)
    ]
    print_table(list(columns), rows, right=range(len(columns)))


def _facts(found: Line, rolled: Rolling | None) -> dict[str, Any]:
    from ropewalk.scene.guess import guesses_of

    about: dict[str, Any] = {
        "span": found.span,
        "height_difference": found.height_difference,
        "rope": found.material.library,
        "EA": found.material.EA,
        "length": found.length,
        "sag": found.sag,
        "tensions": found.tensions,
        "anchor_forces": found.anchor_forces,
        "breaking_load": found.material.breaking_load,
        "utilisation": found.utilisation,
        "safety_factor": found.safety_factor,
        "guessed": {name: [one.low, one.high] for name, one in guesses_of(found.material).items()},
        "notes": found.notes() + (rolled.notes() if rolled is not None else []),
    }
    return about | ({"rolling": rolled.table} if rolled is not None else {})
