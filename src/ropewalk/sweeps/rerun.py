"""One run of a sweep, made again."""

from __future__ import annotations

import warnings
from pathlib import Path

from ropewalk.record.result import Result
from ropewalk.scene import Scene
from ropewalk.sweeps.batch import Batcher
from ropewalk.sweeps.identity import sweep_hash
from ropewalk.sweeps.sweep_folder import SweepFolder


def scene_of(folder: Path, run: int) -> Scene:
    """Return the scene of one run of a sweep. Raises RunError, SceneError."""
    sweep = SweepFolder.open(folder)
    row = sweep.row(run)
    scene = Batcher(sweep.plan.recipe).scene(row)
    return scene.replace(name=f"{scene.name}, run {run}"[:200])


def replay(folder: Path, run: int) -> Result:
    """Return one run of a sweep (or its equilibrium), made again to the same bits.

    Warns when other sources of ropewalk, numpy or numba made the sweep.
    """
    sweep = SweepFolder.open(folder)
    if sweep.plan.recipe.source != sweep_hash():
        warnings.warn(
            f"{folder}: was made by other sources of ropewalk (or another numpy or numba), so this run "
            "may not have the bits of the sweep",
            stacklevel=2,
        )
    return Batcher(sweep.plan.recipe).run(sweep.row(run))
