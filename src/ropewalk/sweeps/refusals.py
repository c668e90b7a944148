"""What no sweep can be: seen before any run is made."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ropewalk.record.errors import InputError, RunError
from ropewalk.record.lock import is_locked
from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.sweeps import engines
from ropewalk.sweeps.batch import REST, RUN
from ropewalk.sweeps.designs import Design
from ropewalk.sweeps.sweep_folder import COPIES, DATA, PARTIAL, SCENE, is_sweep
from ropewalk.sweeps.trial import Trial
from ropewalk.sweeps.whole import is_whole

MOST_IN_MEMORY = 1_000_000_000  # bytes
#: What a sweep that was killed before it was there leaves, and with that what may be of one it overwrites.
_BEGUN = {PARTIAL, DATA, COPIES}
_LEFT = {*_BEGUN, SCENE, "figures", ".lock"}


def check_options(what: str, batch: int | None, workers: int | None) -> None:
    """Refuse what no sweep can be. Raises InputError."""
    if what not in (RUN, REST):
        raise InputError("what", what, 'must be "run" or "rest"')
    for name, value, of in (("batch", batch, "runs"), ("workers", workers, "processes")):
        if value is not None and not is_whole(value, 1):
            raise InputError(name, value, f"must be a whole number of {of} from 1 on")


def check_on(on: Any) -> None:
    """Look at who is to make the runs, before any is made. Raises InputError, RunError."""
    if on in (None, "here"):
        return
    if not engines.has_dask():
        rule = "needs Dask, which is not installed: pip install 'ropewalk[sweep]'"
        raise InputError("on", str(on), rule)
    engines.check_answers(on)


def check_free(folder: Path, overwrite: bool) -> None:
    """Refuse a folder that a sweep must not be written to. Raises RunError."""
    if not folder.exists() or (folder.is_dir() and not any(folder.iterdir())):
        return
    if not folder.is_dir():
        raise RunError(folder, "is a file, not a folder")
    if is_locked(folder):
        raise RunError(folder, "is being written by another process")
    if not is_sweep(folder):
        names = {path.name for path in folder.iterdir()}
        if (names & _BEGUN and names <= _LEFT) or names <= {".lock"}:
            return  # of a sweep that never began
        raise RunError(folder, "holds something else than a sweep; take another folder")
    if not overwrite:
        rule = (
            "holds a sweep already: resume it, take another folder, or overwrite (overwrite=True)"
        )
        raise RunError(folder, rule)


def refuse_one_name_twice(trial: Trial, design: Design) -> None:
    """Refuse labels and parameters named like what is kept: the answer has one place for both."""
    kept = {variable.name: variable.text for variable in trial.variables}
    kept |= {dim: f"the dimension {dim}" for v in trial.variables for dim in v.dims}
    rule = "has the name of {}, which is kept; rename it, or keep something else"
    given = [(label.name, label.name) for label in design.labels]
    given += [(parameter.path, parameter.name) for parameter in design.parameters]
    faults = [Fault("vary", what, rule.format(kept[name])) for what, name in given if name in kept]
    if faults:
        raise SceneError(faults)


def refuse_too_much(trial: Trial, design: Design, folder: Path | None) -> None:
    """Refuse a sweep that would fill the memory. Raises InputError."""
    size = 8 * (1 + len(design.parameters) + sum(v.numbers for v in trial.variables))
    if folder is None and size * design.runs > MOST_IN_MEMORY:
        rule = (
            f"{design.runs} runs keep {size * design.runs / 1e9:.3g} GB, more than 1 GB: "
            "give a folder (store=...), or keep less"
        )
        raise InputError("store", None, rule)
