"""`ropewalk movie`: a run in motion."""

from __future__ import annotations

from pathlib import Path

import click

from ropewalk.cli.console import say
from ropewalk.cli.failures import Refusal
from ropewalk.cli.output_files import refuse_existing
from ropewalk.cli.progress import counting
from ropewalk.cli.run_argument import open_run, run_argument


@click.command()
@run_argument
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="File that ends in .gif, or in .mp4 (needs ffmpeg); default: DIR/movie.gif.",
)
@click.option(
    "--speed",
    type=float,
    default=1.0,
    show_default=True,
    help="Simulated seconds per second; 0.1 is slow motion.",
)
@click.option("--fps", type=float, default=25.0, show_default=True, help="Pictures per second.")
@click.option("--overwrite", is_flag=True, help="Replace a file that is there.")
def movie(folder: Path, output: Path | None, speed: float, fps: float, overwrite: bool) -> None:
    """Make a movie of the run in DIR, coloured by tension."""
    result = open_run(folder)
    path = output or folder / "movie.gif"
    if path.suffix.lower() not in (".gif", ".mp4"):
        raise Refusal(f"{path}: must end in .gif or .mp4")
    refuse_existing(path, overwrite=overwrite or output is None)
    from ropewalk import plots

    try:
        with counting("movie", "pictures") as progress:
            path.parent.mkdir(parents=True, exist_ok=True)
            plots.movie(result, path, speed=speed, fps=fps, progress=progress)
    except plots.MovieError as error:
        raise Refusal(f"{path}: {error}") from error
    except ValueError as error:
        raise Refusal(f"--{error}") from error
    say(str(path))
