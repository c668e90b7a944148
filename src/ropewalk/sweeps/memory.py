"""A sweep in memory: the same as its folder, without one."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from ropewalk.sweeps.batch import Batch
from ropewalk.sweeps.sweep_plan import SweepPlan


class SweepMemory:
    """The values of all runs of a sweep, and what they led to."""

    def __init__(self, plan: SweepPlan, values: Iterable[list[Any]]) -> None:
        self.plan = plan
        columns = [np.concatenate(parts) for parts in zip(*values, strict=True)]
        self.values = dict(zip(plan.columns, columns, strict=True))
        self.columns: dict[str, Any] = {
            "status": np.full(plan.runs, "", dtype=object),
            "reason": np.full(plan.runs, "", dtype=object),
            "notes": np.full(plan.runs, "", dtype=object),
            "broke_at": np.full(plan.runs, math.nan),
        }
        for variable in plan.variables:
            self.columns[variable.name] = np.full((plan.runs, *variable.sizes), math.nan)
        self._done: set[int] = set()

    def write(self, number: int, batch: Batch) -> None:
        """Take a batch."""
        rows = self.plan.rows(number)
        for name, values in batch.arrays().items():
            self.columns[name][rows.start : rows.stop] = values
        self._done.add(number)

    def is_done(self, number: int) -> bool:
        """Tell whether a batch is there."""
        return number in self._done

    def rows(self, number: int) -> list[list[Any]]:
        """Return the values of a batch's runs."""
        rows = self.plan.rows(number)
        names = [parameter["name"] for parameter in self.plan.parameters]
        parts = [self.values[name][rows.start : rows.stop].tolist() for name in names]
        return [list(row) for row in zip(*parts, strict=True)]
