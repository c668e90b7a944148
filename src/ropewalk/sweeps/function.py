"""A sweep as a function of a matrix, as tools for sensitivity, sampling and optimisation call it."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from contextlib import ExitStack
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ropewalk.api import SceneLike, as_scene, told_of
from ropewalk.core.arrays import Floats
from ropewalk.record.errors import InputError
from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.sweeps import engines
from ropewalk.sweeps.batch import RUN, Batch, make_recipe
from ropewalk.sweeps.keep import make_keep
from ropewalk.sweeps.parameters import INT, Parameter, make_parameters
from ropewalk.sweeps.refusals import check_on, check_options
from ropewalk.sweeps.trial import try_out
from ropewalk.sweeps.worker import batcher_of


class SweepFunction:
    """Maps values (N, D) to what is kept of their runs (N, K): `columns` names the K.

    A run that breaks gives a row of NaN; `last` has status and reason of every run of the last call. One
    row (D,) gives one row (K,). What is a whole number in the scene is rounded to the nearest one (halves to
    the even one), since samplers draw fractions; `sweep` refuses those. Use it as a context manager, or
    `close` it, when it has a cluster.
    """

    def __init__(
        self,
        scene: SceneLike,
        names: Sequence[str],
        keep: Sequence[str] | str | None = None,
        *,
        what: str = RUN,
        on: Any = "here",
        workers: int | None = None,
    ) -> None:
        check_options(what, None, workers)
        check_on("local" if on is None else on)
        loaded = as_scene(scene)
        paths = [names] if isinstance(names, str) else list(names)
        with told_of(scene):
            self.parameters = _at_their_values(loaded, paths)
            kept = make_keep(keep, bool(loaded.anchors))
            trial = try_out(loaded, self.parameters, kept, what)
        self.variables = trial.variables
        self.coordinates = trial.coordinates
        self.recipe = make_recipe(loaded, self.parameters, trial.variables, what)
        self.columns = tuple(name for v in trial.variables for name in _column_names(v))
        self.last: Batch = Batch()
        self._stack = ExitStack()
        self._client: Any = None
        if on != "here":
            entered = self._stack.enter_context
            self._client = entered(engines.client_of(on, workers, lambda text: None))

    def __call__(self, values: ArrayLike) -> Floats:
        """Make the runs. Raises InputError for a matrix of another width."""
        matrix = np.asarray(values, dtype=np.float64)
        table = np.atleast_2d(matrix)
        if table.ndim != 2 or table.shape[1] != len(self.parameters):
            paths = ", ".join(self.recipe.paths)
            shape = " x ".join(map(str, matrix.shape))
            raise InputError("values", shape, f"must be N x {len(self.parameters)}: {paths}")
        found = self.runs(table)
        parts = [found[v.name].reshape(len(table), -1) for v in self.variables]
        made: Floats = np.concatenate(parts, axis=1)
        return made[0] if matrix.ndim == 1 else made

    def runs(self, table: Floats) -> dict[str, Floats]:
        """Make the runs of (N, D) values and return what is kept by name, each (N, ...)."""
        whole = [parameter.kind == INT for parameter in self.parameters]
        rows = [
            [round(v) if i and math.isfinite(v) else v for v, i in zip(row, whole, strict=True)]
            for row in table.tolist()
        ]
        recipe = json.dumps(self.recipe.plain())
        if self._client is None:
            self.last = batcher_of(recipe).make(rows)
        else:
            self.last = engines.map_rows(self._client, recipe, self.recipe.source, rows)
        return self.last.kept

    def close(self) -> None:
        """Shut down the cluster that was started for it, if any."""
        self._stack.close()
        self._client = None

    def __enter__(self) -> SweepFunction:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


def _at_their_values(scene: Any, paths: list[str]) -> tuple[Parameter, ...]:
    """The parameters at the values that the scene gives them. Raises SceneError."""
    from ropewalk.scene.overrides import Places

    places = Places(scene, paths)
    faults, given = [], {}
    for number, path in enumerate(paths):
        value = places.value(number)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            faults.append(Fault(path, value, "must be a number in the scene"))
        given[path] = [value]
    if faults:
        raise SceneError(faults)
    return make_parameters(scene, given)


def _column_names(variable: Any) -> list[str]:
    if not variable.sizes:
        return [variable.name]
    places = np.ndindex(*variable.sizes)
    return [f"{variable.name}[{','.join(map(str, place))}]" for place in places]
