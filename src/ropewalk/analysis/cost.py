"""How long a run will take on this machine."""

from __future__ import annotations

import time

from ropewalk.core.cache import is_compiled
from ropewalk.lowering import Model
from ropewalk.methods.registry import METHODS
from ropewalk.simulation import Broken, Simulation

# Cost of one force evaluation and update, with books and extremes, of presets on a current processor core;
# only for estimates. Contact takes up to sixty times as much.
_PER_NODE = 1e-8  # [s]
_PER_STEP = 1.5e-6  # [s]
_SAMPLE = 0.02  # [s] of computing that a measurement takes
_AFFORDABLE = (
    20_000  # nodes up to which two steps are run: of more an implicit one can take many seconds
)


def seconds_per_step(model: Model, measure: bool = True) -> tuple[float, bool]:
    """Return the estimated time of one step [s], without recording, and whether it was measured.

    It is measured by running some steps of a copy, unless there are very many nodes, the run breaks within
    them or the machine code still has to be made (that takes longer than the answer is worth).
    """
    method = METHODS[model.plan.method]
    typical = method.cost * _PER_NODE * model.layout.nodes + _PER_STEP
    if (
        model.layout.nodes > _AFFORDABLE
        or not measure
        or not is_compiled(method.advance, model.system.rare)
    ):
        return typical, False
    simulation = Simulation(model)
    dt = model.plan.dt
    count = max(1, min(int(_SAMPLE / typical), 2000, model.plan.steps))
    try:
        simulation.step(dt)
        start = time.perf_counter()
        simulation.step(count * dt)
        spent = time.perf_counter() - start
    except Broken:
        return typical, False
    return spent / count, True
