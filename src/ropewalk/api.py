"""What a scene can be made into: a result in memory, a run folder, and its continuation."""

from __future__ import annotations

from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from ropewalk.lowering import Model, build
from ropewalk.record.facts import INTERRUPTED
from ropewalk.record.result import Result
from ropewalk.record.simulate import Progress, simulate_in_memory
from ropewalk.scene import Fault, Scene, SceneFileError, load
from ropewalk.scene.faults import NO_VALUE, found_in
from ropewalk.scene.presets import names, preset
from ropewalk.scene.toml_text import NO_FILE
from ropewalk.simulation import Broken, Simulation
from ropewalk.words.nearest import nearest

if TYPE_CHECKING:
    from ropewalk.analysis.check import Check
    from ropewalk.vibration import Modes

SceneLike = Scene | str | Path


class BrokenRun(Broken):
    """A run that broke. It has a `result` up to the break (or into it) and a `diagnosis`."""

    def __init__(self, result: Result) -> None:
        more = "The error's `result` holds what there is"
        more += "; its plot.shape() shows the break." if result.beyond is not None else "."
        super().__init__(f"{result.diagnosis.removesuffix('.')}. {more}")
        self.result, self.diagnosis = result, result.diagnosis


def as_scene(source: SceneLike) -> Scene:
    """Return a scene as it is, by its preset's name, or read from a TOML file.

    Raises SceneError when it cannot be read or has faults.
    """
    if isinstance(source, Scene):
        return source
    if isinstance(source, str) and source in names():
        return preset(source)
    try:
        return load(source)
    except SceneFileError as error:
        if isinstance(source, str) and error.faults[0].rule == NO_FILE and _may_be_a_name(source):
            rule = f"{NO_FILE}, and no preset of that name; {nearest(source, names())}"
            raise SceneFileError([Fault("", NO_VALUE, rule)], source) from None
        raise


def _may_be_a_name(source: str) -> bool:
    return not (Path(source).suffix == ".toml" or "/" in source or "\\" in source)


def told_of(source: SceneLike | Model) -> AbstractContextManager[None]:
    """Let what is found wrong with a scene when it is built tell the file, or the preset, that it is of."""
    return found_in(str(source) if isinstance(source, str | Path) else None)


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
    _check_choice(on_failure)
    with told_of(scene):
        result = simulate_in_memory(
            as_scene(scene),
            keep_going=keep_going,
            progress=progress,
            ledger=ledger,
            explain=explain,
        )
    return _ended(result, on_failure)


def equilibrium(scene: SceneLike) -> Result:
    """Return the shape in which a scene is at rest, without running it.

    Weight, stretch, bending, wind, ground, obstacles, other ropes and slides take part, the last three with
    their friction; damping does not, nor friction that is viscous (along segments, on the ground), nor the
    stretch limiter. Anchors stand where they are at time zero.

    Args:
        scene: scene, preset's name, or scene file.

    Returns:
        A result of one frame with the status "at rest": `positions` [m], `tension` [N], `reactions` [N],
        and `residual`, the largest force that is left on a free node [N]. Where several shapes are at
        rest (a rope that lies on the ground), it is the one that the scene's own shape leads to.

    Raises SceneError for a scene without a rest shape, with what is missing; `statics.NoRest` when
    Newton's method finds none.
    """
    from ropewalk.record.rest import rest_result

    with told_of(scene):
        return rest_result(as_scene(scene))


def modes(
    scene: SceneLike, about: Literal["equilibrium", "start"] = "equilibrium", count: int = 10
) -> Modes:
    """Return the slowest natural modes of a scene, from the exact tangents of all laws.

    Args:
        scene: scene, preset's name, or scene file.
        about: the shape they are about: "equilibrium", or "start", the scene as it starts, whether forces
            balance there or not.
        count: how many, by natural frequency, the lowest first.

    Returns:
        Frequencies [Hz], shapes, damping ratios [1] and what moves in each mode.

    Raises SceneError for a scene without a rest shape, ValueError for another `about` or a count below 1.
    """
    from ropewalk import vibration

    with told_of(scene):
        return vibration.modes(build(as_scene(scene), stepped=False), about, count)


def check(source: SceneLike | Model, *, measure: bool = True) -> Check:
    """Say whether a scene will run, and what to expect of it; nothing is run.

    Args:
        source: scene, preset's name, scene file, or built model.
        measure: time a few steps for the estimate of the run time; else take it from a table.

    Returns:
        The largest stable steps [s], waves [m/s], sag [m] and tension [N] at rest, cost and warnings;
        printed, one fact a line.

    Raises SceneError when the scene cannot be planned.
    """
    from ropewalk.analysis.check import check as check_model

    with told_of(source):
        return check_model(
            source if isinstance(source, Model) else as_scene(source), measure=measure
        )


def run(
    scene: SceneLike,
    folder: str | Path,
    *,
    on_failure: Literal["raise", "return"] = "raise",
    keep_going: bool = False,
    overwrite: bool = False,
    progress: Progress | None = None,
    ledger: bool = True,
) -> Result:
    """Run a scene into a run folder, in memory that does not grow with its duration.

    Killed at any moment, it leaves a folder that opens, and `resume` goes on. Ctrl-C drops
    what has begun of the present frame and saves the rest (a second one does not wait).

    Args:
        scene: scene, preset's name, or scene file.
        folder: of the run; must not exist, or be empty.
        on_failure: "raise" BrokenRun or KeyboardInterrupt when the run breaks or is interrupted, or
            "return" the result up to there with its `status`.
        keep_going: record on into a break, to the planned end.
        overwrite: put the run in place of another one in `folder`.
        progress: called after every block of frames with frames done, frames planned and the block.
        ledger: add up the work of every law.

    Raises SceneError, RunError (the folder cannot be written), BrokenRun, KeyboardInterrupt.
    """
    from ropewalk.record.run import record_run

    _check_choice(on_failure)
    with told_of(scene):
        result = record_run(
            as_scene(scene),
            Path(folder),
            keep_going=keep_going,
            overwrite=overwrite,
            progress=progress,
            ledger=ledger,
            explain=explain,
        )
    return _ended(result, on_failure)


def resume(
    folder: str | Path,
    *,
    force: bool = False,
    on_failure: Literal["raise", "return"] = "raise",
    progress: Progress | None = None,
) -> Result:
    """Go on with a killed or interrupted run, to the same bits as one never interrupted.

    Args:
        folder: of the run.
        force: go on also when other sources of ropewalk began it (then with a warning, and perhaps not
            to the same bits).
        on_failure: "raise" or "return" what there is, as in `run`.
        progress: called after every block of frames with frames done, frames planned and the block.

    Raises RunError when there is nothing to go on with, else as `run`.
    """
    from ropewalk.record.resume import resume_run

    _check_choice(on_failure)
    result = resume_run(Path(folder), force=force, progress=progress, explain=explain)
    return _ended(result, on_failure)


def open(folder: str | Path) -> Result:  # noqa: A001 - as `rw.open`, it is what it says
    """Open a run `folder`, finished or not, and return its result.

    Quantities are read when they are first used: times [s], positions [m], tensions [N] ...

    Raises RunError when it is no run folder, or damaged.
    """
    return Result.open(folder)


def _check_choice(on_failure: str) -> None:
    if on_failure not in ("raise", "return"):
        raise ValueError(f'on_failure: {on_failure!r} - must be "raise" or "return"')


def _ended(result: Result, on_failure: str) -> Result:
    if on_failure == "raise" and result.diagnosis:
        raise BrokenRun(result)
    if on_failure == "raise" and result.status == INTERRUPTED:
        raise KeyboardInterrupt(
            f"{result.folder}: interrupted at t = {result.time[-1]:.6g} s; saved"
        )
    return result


def explain(simulation: Simulation) -> str:
    """Say why a run broke; the simulation stands at its last good frame, and stays there."""
    from ropewalk.analysis import diagnosis

    return str(diagnosis.explain(simulation))
