"""A sweep from its first word to its answer: faults, batches, store, workers."""

from __future__ import annotations

import json
import math
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ropewalk.api import SceneLike, as_scene, told_of
from ropewalk.core.deferred import clock
from ropewalk.record.errors import RunError
from ropewalk.record.facts import provenance
from ropewalk.record.files import writing
from ropewalk.record.lock import locked
from ropewalk.scene import Scene
from ropewalk.sweeps import answer, engines
from ropewalk.sweeps.batch import RUN, Batch, Recipe, make_recipe
from ropewalk.sweeps.designs import Design, make_design
from ropewalk.sweeps.identity import sweep_hash
from ropewalk.sweeps.keep import Kept, make_keep
from ropewalk.sweeps.labels import make_labels
from ropewalk.sweeps.memory import SweepMemory
from ropewalk.sweeps.parameters import gives_runs, make_parameters
from ropewalk.sweeps.refusals import (
    check_free,
    check_on,
    check_options,
    refuse_one_name_twice,
    refuse_too_much,
)
from ropewalk.sweeps.repair import mend
from ropewalk.sweeps.runs_bar import RunsBar
from ropewalk.sweeps.sweep_folder import SweepFolder, is_sweep
from ropewalk.sweeps.sweep_plan import SweepPlan, rows_of
from ropewalk.sweeps.trial import Trial, try_out
from ropewalk.sweeps.worker import batcher_of, count_broken, job_of

if TYPE_CHECKING:
    import xarray as xr

#: A sweep that keeps more than this needs a folder [bytes].
#: Work of one batch [s]: long beside what handing it out costs, short beside the sweep.
BATCH_SECONDS = 1.0
_MOST_BATCH_BYTES = 64_000_000
_MEASURED = 0.2  # [s] of first runs that are timed
_MOST_MEASURED = 256  # runs
_TOLD = 20  # names of what is damaged


@dataclass(frozen=True)
class Standing:
    """How far a sweep is."""

    done: int  # runs
    runs: int
    broken: int
    per_second: float  # runs made in a second of this part of the sweep
    note: str = ""  # where it runs


Progress = Callable[[Standing], None]


def sweep(
    scene: SceneLike,
    vary: Any,
    *,
    keep: Sequence[str] | str | None = None,
    samples: int | None = None,
    design: str = "sobol",
    seed: int | None = None,
    store: str | Path | None = None,
    on: Any = None,
    workers: int | None = None,
    what: str = RUN,
    batch: int | None = None,
    overwrite: bool = False,
    progress: Progress | bool = True,
) -> xr.Dataset:
    """Run a scene many times with other values, and return what was kept of every run.

    Args:
        scene: scene, preset's name, or scene file.
        vary: mapping from paths (those of `--set`, such as "rope.made_of.EA") to a list of values, a
            frozen distribution of scipy.stats, or a range (low, high); or a pandas DataFrame or xarray
            Dataset with a column per path: the runs themselves.
        keep: what to keep of every run: "tension.max", "positions[-1]", "sag.max[time]", ...; by
            default the largest tension and reactions over all steps, and the last positions.
        samples: number of runs drawn from the ranges and distributions; without it lists make a grid.
        design: how they are drawn: "sobol", "lhs", "halton" or "random".
        seed: of the samples; by default a new one, which the answer tells.
        store: folder to write to as the sweep goes on; without it the answer is in memory.
        on: a Dask client, the address of a scheduler, "local" (a cluster of this machine's cores), or
            "here" (this process). By default "local" where it is worth it and Dask is installed.
        workers: processes of a cluster of its own; by default one per core.
        what: "run", or "rest": the equilibrium of each scene, without a run.
        batch: runs made and stored together; by default measured: up to a second's work.
        overwrite: put the sweep in place of another one in `store`.
        progress: a function called with a `Standing` now and then; True: a bar on a terminal.

    Returns:
        A Dataset. Of a grid every parameter is a dimension, else they lie along `run`; with units. Every
        run has a `status`; one that broke has also a `reason` and `broke_at` [s], and NaN in what was kept.

    Raises SceneError with the faults of all corners before anything runs; InputError, RunError;
    KeyboardInterrupt, after which `resume` goes on with what is stored.
    """
    loaded = as_scene(scene)
    with told_of(scene):
        parameters = make_parameters(loaded, vary)
        given = gives_runs(vary)
        labels = make_labels(vary, parameters) if given else ()
        chosen = make_design(parameters, samples, design, seed, given, labels)
        return make_runs(
            loaded, chosen, keep, store=store, on=on, workers=workers, what=what, batch=batch,
            overwrite=overwrite, progress=progress,
        )  # fmt: skip


def make_runs(
    scene: Scene,
    design: Design,
    keep: Sequence[str] | str | None,
    *,
    store: str | Path | None = None,
    on: Any = None,
    workers: int | None = None,
    what: str = RUN,
    batch: int | None = None,
    overwrite: bool = False,
    progress: Progress | bool = True,
) -> xr.Dataset:
    """Make the runs of a design; all else as of `sweep`."""
    check_options(what, batch, workers)
    check_on(on)
    folder = Path(store) if store is not None else None
    kept = make_keep(keep, bool(scene.anchors))
    if folder is not None:
        check_free(folder, overwrite)
    asked = (what, batch, overwrite)
    return _made(scene, design, kept, asked, folder, (on, workers, progress))


def _made(
    scene: Scene,
    design: Design,
    kept: Sequence[Kept],
    asked: tuple[str, int | None, bool],
    folder: Path | None,
    how: tuple[Any, ...],
) -> xr.Dataset:
    """Try out a sweep's corners, make it, and return its answer."""
    what, batch, overwrite = asked
    trial = try_out(scene, design.parameters, kept, what, design)
    refuse_one_name_twice(trial, design)
    refuse_too_much(trial, design, folder)
    recipe = make_recipe(scene, design.parameters, trial.variables, what)
    first = _first_runs(recipe, design, batch)
    plan = _plan(scene, design, trial, recipe, first, batch)
    begun = _Begun(first, set(), 0)
    if folder is None:
        memory = SweepMemory(plan, design.pieces())
        _make(memory, begun, *how)
        return answer.in_memory(memory)
    return _stored((folder, overwrite), plan, scene, design, begun, how)


def _stored(
    where: tuple[Path, bool],
    plan: SweepPlan,
    scene: Scene,
    design: Design,
    begun: _Begun,
    how: tuple[Any, ...],
) -> xr.Dataset:
    """Make a sweep into a folder, perhaps over another one."""
    folder, overwrite = where
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
    with locked(folder):
        if is_sweep(folder) and not overwrite:  # it was not there when the folder was checked
            raise RunError(folder, "was made by another process meanwhile; take another folder")
        sink = SweepFolder.create(folder, plan, scene, design.pieces())
        _make(sink, begun, *how)
    return answer.stored(sink)


def resume_sweep(
    folder: str | Path,
    *,
    on: Any = None,
    workers: int | None = None,
    force: bool = False,
    progress: Progress | bool = True,
) -> xr.Dataset:
    """Go on with a sweep that was stopped or killed, to the same bits as one that never was.

    Batches that are marked as done are checked; damaged ones are made again, with a warning. With `force`
    also when other sources of ropewalk began it. Raises RunError when it cannot be; else as `sweep`.
    """
    check_options(RUN, None, workers)
    check_on(on)
    found = SweepFolder.open(Path(folder))
    if found.plan.recipe.source != sweep_hash() and not force:
        rule = (
            "was begun by other sources of ropewalk (or another numpy or numba), so it would not go on "
            "to the same bits; resume it with the version it was begun with, or force it"
        )
        raise RunError(folder, rule)
    with locked(found.folder):
        if SweepFolder.open(found.folder).plan.id != found.plan.id:
            raise RunError(folder, "was replaced by another sweep meanwhile")
        found.tidy()
        if mended := mend(found):
            names = ", ".join(mended[:_TOLD])
            warnings.warn(f"{folder}: damaged files were put right: {names}", stacklevel=2)
        done, damaged = found.standing()
        if damaged:
            numbers = ", ".join(map(str, damaged[:_TOLD]))
            many = "batch is damaged and is" if len(damaged) == 1 else "batches are damaged and are"
            told = f"{len(damaged)} stored {many} made again: {numbers}"
            warnings.warn(f"{folder}: {told}", stacklevel=2)
            found.unmark(damaged)
        if len(done) < found.plan.batches:
            broken = sum(count_broken(status) for status, _ in found.statuses(done))
            _make(found, _Begun(None, set(done), broken), on, workers, progress)
    return answer.stored(found)


# -- the first runs ------------------------------------------------------------------------


@dataclass
class _First:
    """The first runs, made here and timed: what a batch should be, and the beginning of the first."""

    batch: Batch
    seconds: float  # of one run


def _first_runs(recipe: Recipe, design: Design, batch: int | None) -> _First:
    """Make the first runs until they have taken a while.

    The first one may compile: its time counts only where it is the only one.
    """
    batcher = batcher_of(json.dumps(recipe.plain()))
    columns = next(design.pieces())[: len(design.parameters)]
    rows = rows_of([column[:_MOST_MEASURED] for column in columns])[: batch or None]
    begun = clock()
    made, spent = batcher.make(rows[:1]), []
    alone = clock() - begun
    begun = clock()
    for row in rows[1:]:
        before = clock()
        made.append(batcher.make([row]))
        spent.append(clock() - before)
        if clock() - begun > _MEASURED:
            break
    return _First(made, sum(spent) / len(spent) if spent else alone)


def _plan(
    scene: Scene, design: Design, trial: Trial, recipe: Recipe, first: _First, batch: int | None
) -> SweepPlan:
    about = provenance(trial.model.plan, True, False)
    plan = SweepPlan(
        title=scene.name,
        recipe=recipe,
        parameters=tuple(parameter.described() for parameter in design.parameters),
        labels=tuple(label.described() for label in design.labels),
        design=design.kind,
        shape=design.shape,
        runs=design.runs,
        batch=1,
        variables=trial.variables,
        coordinates=trial.coordinates,
        provenance=about,
        seed=design.seed,
    )
    return replace(plan, batch=batch or _batch_size(plan, first))


def _batch_size(plan: SweepPlan, first: _First) -> int:
    """Return how many runs make a batch: a power of two, at least those that are made already."""
    by_time = BATCH_SECONDS / max(first.seconds, 1e-6)
    by_bytes = _MOST_BATCH_BYTES / plan.run_bytes
    many = max(1.0, min(by_time, by_bytes, plan.runs / 16))
    size = 1 << int(math.log2(many))
    return max(size, len(first.batch.status))


# -- making it -----------------------------------------------------------------------------


@dataclass
class _Begun:
    """What there is already: first runs made here, batches that are stored."""

    first: _First | None
    done: set[int]
    broken: int


def _make(
    sink: SweepFolder | SweepMemory, begun: _Begun, on: Any, workers: int | None, progress: Any
) -> None:
    """Make all batches that are not done."""
    plan = sink.plan
    with RunsBar(plan.title, plan.runs, progress, Standing) as bar:
        bar.start(sum(len(plan.rows(n)) for n in begun.done), begun.broken)

        def told(number: int, broken: int) -> None:
            bar.add(len(plan.rows(number)), broken)

        seconds = 0.0
        if begun.first is not None:
            _finish_first(sink, begun.first)
            begun.done.add(0)
            told(0, begun.first.batch.broken)
            seconds = begun.first.seconds
        left = [n for n in range(plan.batches) if n not in begun.done]
        if begun.first is None and on is None:  # what is gone on with: how long will it take?
            before = clock()
            engines.make_here(sink, iter(left[:1]), told)
            seconds = (clock() - before) / plan.batch
            left = left[1:]
        work = seconds * plan.batch * len(left)
        folder = sink.folder if isinstance(sink, SweepFolder) else None
        if _runs_here(on, work):
            engines.make_here(sink, iter(left), told)
            return
        size = min(workers, max(1, len(left))) if workers else None
        with engines.client_of(on, size, bar.note) as client:
            engines.make_with(client, sink, folder, iter(left), told)


def _finish_first(sink: SweepFolder | SweepMemory, first: _First) -> None:
    """Make the rest of the first batch, and store it."""
    rows = sink.rows(0)
    batcher = batcher_of(job_of(sink.plan, None)["recipe"])
    if len(rows) > len(first.batch.status):
        first.batch.append(batcher.make(rows[len(first.batch.status) :]))
    sink.write(0, first.batch)


_told_of_extra = False


def _runs_here(on: Any, work: float) -> bool:
    """Decide who makes the batches; `work` [s] is what is left for one core."""
    global _told_of_extra
    if on == "here":
        return True
    if engines.has_dask():
        return on is None and work < engines.WORTH_A_CLUSTER
    if work > engines.WORTH_A_CLUSTER and not _told_of_extra:
        _told_of_extra = True
        warnings.warn(
            "this sweep runs in one process; with pip install 'ropewalk[sweep]' the same call takes all "
            "cores, or a cluster",
            stacklevel=4,
        )
    return True
