"""`ropewalk run --uncertain`: bands of what is not known exactly."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ropewalk.cli.bands_table import FIGURE, tell_bands
from ropewalk.cli.commands.sweep import SWEEPS, ended, telling
from ropewalk.cli.output_files import claimed, warn_of_left
from ropewalk.cli.progress import tell_compiling

if TYPE_CHECKING:
    from ropewalk.scene import Scene


def run_uncertain(
    scene: Scene,
    spreads: Sequence[str],
    drawn: tuple[int, int | None],
    where: tuple[Path | None, str, bool],
    *,
    as_json: bool,
    quiet: bool = False,
) -> int:
    """Make the runs into a sweep's folder, print the bands and draw the figure there.

    `drawn` are the number of samples and their seed.
    """
    from ropewalk.sweeps.spread_text import parse_all, parse_uncertain
    from ropewalk.sweeps.uncertainty import uncertain

    output, name, overwrite = where
    vary = parse_all("--uncertain", parse_uncertain, spreads)
    if not quiet:
        tell_compiling(scene.run.method, scene)
    with claimed(output, SWEEPS, f"{name}-uncertain") as folder, telling(quiet=quiet):
        samples, seed = drawn
        ask: dict[str, Any] = {
            "samples": samples,
            "seed": seed,
            "store": folder,
            "overwrite": overwrite,
            "progress": not quiet,
        }
        status = ended(
            folder, lambda: uncertain(scene, vary, **ask), as_json, tell_bands, quiet=quiet
        )
        if overwrite and not quiet:
            warn_of_left(folder, "sweep", but=FIGURE)
        return status
