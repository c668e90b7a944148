"""What a scene can be made into: a result in memory, a run folder, and its continuation."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from ropewalk.record.result import Result
from ropewalk.record.simulate import Progress, no_explanation, simulate_in_memory
from ropewalk.scene import Scene, load
from ropewalk.scene.presets import names, preset
from ropewalk.simulation import Broken, Simulation

SceneLike = Scene | str | Path


class BrokenRun(Broken):
    """A run that broke. It has a `result` up to the break (or into it) and a `diagnosis`."""

    def __init__(self, result: Result) -> None:
        super().__init__(result.diagnosis)
        self.result, self.diagnosis = result, result.diagnosis


def as_scene(source: SceneLike) -> Scene:
    """Return a scene as it is, by its preset's name, or read from a TOML file.

    Raises SceneError when it cannot be read or has faults.
    """
    if isinstance(source, Scene):
        return source
    if isinstance(source, str) and source in names():
        return preset(source)
    return load(source)


def simulate(
    scene: SceneLike,
    *,
    on_failure: Literal["raise", "return"] = "raise",
    keep_going: bool = False,
    progress: Progress | None = None,
    ledger: bool = True,
) -> Result:
    """Run a scene, a preset's name or a scene file, and return the result in memory.

    Args:
        scene: what to run.
        on_failure: "raise" BrokenRun when the run breaks, or "return" what there is up to there.
        keep_going: record on into the break, to the planned end.
        progress: called after every block of frames with frames done, frames planned and the block.
        ledger: add up the work of every law; without it a run is a little faster.

    Raises SceneError for a faulty scene, BrokenRun (a `Broken`) when the run breaks.
    """
    if on_failure not in ("raise", "return"):
        raise ValueError(f'on_failure: {on_failure!r} - must be "raise" or "return"')
    result = simulate_in_memory(
        as_scene(scene), keep_going=keep_going, progress=progress, ledger=ledger, explain=explain
    )
    if result.diagnosis and on_failure == "raise":
        raise BrokenRun(result)
    return result


def explain(simulation: Simulation) -> str:
    """Say why a run broke; the simulation stands at its last good frame."""
    return no_explanation(simulation)
