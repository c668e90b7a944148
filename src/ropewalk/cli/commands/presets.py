"""`ropewalk presets`: the ready scenes."""

from __future__ import annotations

import click

from ropewalk.cli.console import print_json, print_table, say
from ropewalk.cli.scene_argument import json_option


@click.command()
@click.argument("name", required=False)
@json_option
def presets(name: str | None, as_json: bool) -> None:
    """List the ready scenes, or show the one called NAME.

    The name of a preset can stand wherever a scene is wanted: ropewalk run r4
    """
    from ropewalk.scene import presets as ready

    if name is not None:
        text = ready.preset_text(name)
        if as_json:
            scene = ready.preset(name)
            print_json({"name": name, "title": scene.name, "description": scene.description})
        else:
            say(text.rstrip("\n"))
        return
    scenes = {known: ready.preset(known) for known in ready.names()}
    if as_json:
        described = [
            {"name": known, "title": scene.name, "description": scene.description}
            for known, scene in scenes.items()
        ]
        print_json({"presets": described})
        return
    rows = [(known, scene.description) for known, scene in scenes.items()]
    print_table(("preset", "what it shows"), rows)
    say("ropewalk run r4          runs one")
    say("ropewalk presets r4      shows it")
    say("ropewalk new r4          writes it to r4.toml, to edit")
