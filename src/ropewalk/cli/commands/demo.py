"""`ropewalk demo`: the report's scene, run, drawn and written out."""

from __future__ import annotations

from pathlib import Path

import click

from ropewalk.cli.commands.run import RUNS, refuse_run, run_scene
from ropewalk.cli.console import print_table, say, tell
from ropewalk.cli.results_table import print_results
from ropewalk.cli.scene_argument import load_scene
from ropewalk.cli.startup import without_scipy

PRESET = "r4"
PAGE = "page.html"
FIGURES = ("shape", "film", "height", "tension", "energy")


@click.command()
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="The run's folder; default: runs/demo-1, -2 and so on.",
)
@click.option("--overwrite", is_flag=True, help="Replace a run that is in DIR.")
def demo(output: Path | None, overwrite: bool) -> None:
    """Run the student report's rope on three anchors: tables, figures, numbers.

    A rope of 40 m hangs on three anchors; the left one moves 6 m, and waves run along the rope.
    """
    with without_scipy():
        scene = load_scene(PRESET)
        if output is not None:
            refuse_run(output, overwrite)
        tell(f"{scene.name}: {scene.description}")
        result, _ = run_scene(scene, output, "demo", parent=RUNS, overwrite=overwrite)
    folder = result.folder
    assert folder is not None
    tell("drawing figures and writing tables")
    from ropewalk import plots
    from ropewalk.live.share import share_run
    from ropewalk.record.export import export

    figures = folder / "figures"
    figures.mkdir(exist_ok=True)
    for kind in FIGURES:
        plots.save(plots.PLOTS[kind].draw(result), figures / f"{kind}.png")
    tables = export(result, "csv", folder / "csv", overwrite=True)
    page = folder / PAGE
    share_run(folder, page, overwrite=True)
    print_results(result, f"{scene.name}: {result.status}")
    rows = [
        ("run folder", str(folder)),
        ("figures", ", ".join(f"{kind}.png" for kind in FIGURES) + f" in {figures}"),
        ("tables", ", ".join(path.name for path in tables) + f" in {folder / 'csv'}"),
        ("page to open", str(page)),
    ]
    print_table(("", ""), rows)
    say("look further:   ropewalk movie " + str(folder))
    say(f"change it:      ropewalk run {PRESET} --set rope.made_of.spring_friction=0.5")
    say(f"break it:       ropewalk run {PRESET} --time-step 0.0167")
