"""`ropewalk report`: the student report's claims, checked."""

from __future__ import annotations

from pathlib import Path

import click

from ropewalk.cli.commands.run import RUNS
from ropewalk.cli.console import print_table, tell
from ropewalk.cli.failures import Refusal
from ropewalk.cli.output_files import claimed, refuse_parent
from ropewalk.display.bar import Bar, terminal


@click.command()
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="Folder of the report; default: runs/report-1, -2 and so on.",
)
@click.option("--overwrite", is_flag=True, help="Write over a report that is in DIR.")
@click.option("-q", "--quiet", is_flag=True, help="Do not name the claims as they are run.")
def report(output: Path | None, overwrite: bool, quiet: bool) -> None:
    """Check the claims of the student report and write one page with figures.

    Every claim with what was measured, what theory says, the verdict and a figure, as HTML and
    Markdown.
    """
    if output is not None:
        refuse_parent(output / "figures")
        if output.is_dir() and any(output.iterdir()) and not overwrite:
            raise Refusal(f"{output}: is not empty; take another folder, or give --overwrite")
    from ropewalk.report import write_report

    with claimed(output, RUNS, "report") as folder, Bar("report", shown=not quiet) as bar:

        def told(done: int, planned: int, what: str) -> None:
            bar.show(done, planned, [f"{done} of {planned}", what])
            if what and not (quiet or terminal()):
                tell(what)

        paths = write_report(folder, told)
    print_table(("", ""), [(what, str(path)) for what, path in paths.items()])
