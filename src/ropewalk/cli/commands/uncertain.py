"""`ropewalk run --uncertain`: bands of what is not known exactly."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ropewalk.cli.bands_table import tell_bands
from ropewalk.cli.commands.sweep import SWEEPS, ended, telling
from ropewalk.cli.output_files import claimed
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
) -> int:
    """Make the runs into a sweep's folder, print the bands and draw the figure there.

    `drawn` are the number of samples and their seed.
    """
    from ropewalk.sweeps.spread_text import parse_uncertain
    from ropewalk.sweeps.uncertainty import uncertain

    output, name, overwrite = where
    vary = dict(parse_uncertain(text) for text in spreads)
    tell_compiling(scene.run.method, scene)
    with claimed(output, SWEEPS, f"{name}-uncertain") as folder, telling():
        samples, seed = drawn
        ask: dict[str, Any] = {
            "samples": samples,
            "seed": seed,
            "store": folder,
            "overwrite": overwrite,
        }
        return ended(folder, lambda: uncertain(scene, vary, **ask), as_json, tell_bands)
