"""`ropewalk report`: the student report's claims, checked."""

from __future__ import annotations

from pathlib import Path

import click

from ropewalk.cli.console import say
from ropewalk.cli.files import claimed
from ropewalk.cli.progress import counting

RUNS = Path("runs")


@click.command()
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="Folder of the report; default: runs/report-1, -2 and so on.",
)
def report(output: Path | None) -> None:
    """Check the claims of the student report and write one page with figures.

    Every claim with what was measured, what theory says, the verdict and a figure, as HTML and
    Markdown.
    """
    from ropewalk.report import write_report

    with claimed(output, RUNS, "report") as folder, counting("claims") as progress:
        paths = write_report(folder, progress)
    for path in paths:
        say(str(path))
