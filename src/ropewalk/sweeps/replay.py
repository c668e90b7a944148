"""One run of a sweep, made again."""

from __future__ import annotations

from pathlib import Path

from ropewalk.record.result import Result
from ropewalk.scene import Scene
from ropewalk.sweeps.batch import Batcher
from ropewalk.sweeps.store import SweepFolder


def scene_of(folder: Path, run: int) -> Scene:
    """Return the scene of one run of a sweep. Raises RunError, SceneError."""
    sweep = SweepFolder.open(folder)
    row = sweep.row(run)
    scene = Batcher(sweep.plan.recipe).scene(row)
    return scene.replace(name=f"{scene.name}, run {run}"[:200])


def replay(folder: Path, run: int) -> Result:
    """Return one run of a sweep (or its equilibrium), made again to the same bits."""
    sweep = SweepFolder.open(folder)
    return Batcher(sweep.plan.recipe).run(sweep.row(run))
