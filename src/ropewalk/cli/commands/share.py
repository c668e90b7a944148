"""`ropewalk share`: a run as one page that replays it anywhere."""

from __future__ import annotations

from pathlib import Path

import click

from ropewalk.cli.console import say, tell
from ropewalk.cli.failures import Refusal
from ropewalk.cli.output_files import refuse_existing
from ropewalk.cli.run_argument import open_run, run_argument


@click.command()
@run_argument
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="File that ends in .html; default: DIR/page.html.",
)
@click.option(
    "--fps", type=float, default=60.0, show_default=True, help="Frames per second to keep at most."
)
@click.option("--overwrite", is_flag=True, help="Replace a file that is there.")
def share(folder: Path, output: Path | None, fps: float, overwrite: bool) -> None:
    """Write the run in DIR as one HTML file that replays it, without server or network."""
    open_run(folder, whole=True)
    path = output or folder / "page.html"
    if path.suffix.lower() not in (".html", ".htm"):
        raise Refusal(f"{path}: must end in .html")
    if not 0.0 < fps <= 10_000.0:
        raise Refusal(f"--fps: {fps:g} - must be more than 0 and at most 10000")
    refuse_existing(path, overwrite=overwrite or output is None)
    from ropewalk.live.share import share_run

    recording = share_run(folder, path, frame_rate=fps, overwrite=True)
    tell(f"{recording.header['about']} {path.stat().st_size / 1e6:.2f} MB.")
    say(str(path))
