"""`ropewalk schema`: the format of scenes, for editors."""

from __future__ import annotations

import json
from pathlib import Path

import click

from ropewalk.cli.console import say
from ropewalk.cli.output_files import write_new


@click.command()
@click.option("-o", "--output", type=click.Path(path_type=Path), help="Write it to this file.")
@click.option("--overwrite", is_flag=True, help="Replace a file that is there.")
def schema(output: Path | None, overwrite: bool) -> None:
    """Print the JSON Schema of the scene format.

    Editors that know it complete keys and mark faults while you type.
    """
    from ropewalk.scene import schema as make_schema

    text = json.dumps(make_schema(), indent=2)
    if output is None:
        say(text)
        return
    write_new(output, text + "\n", overwrite=overwrite)
    say(str(output))
