"""How long a run will take on this machine."""

from __future__ import annotations

from ropewalk.core.deferred import clock
from ropewalk.engine.crews import are_compiled
from ropewalk.lowering import Model
from ropewalk.methods.registry import METHODS
from ropewalk.simulation import Broken, Simulation

# Cost of one force evaluation and update, with books and extremes, of presets on a current processor core.
# Nineteen presets that were measured took 0.44 to 1.5 times as much, ropes in contact up to sixty times.
_PER_NODE = 1e-8  # [s]
_PER_STEP = 1.5e-6  # [s]
_WITHIN = 3.0  # the factor either way within which a machine is taken to be [1]
_SAMPLE = 0.02  # [s] of computing that a measurement takes
_AFFORDABLE = (
    20_000  # nodes up to which two steps are run: of more an implicit one can take many seconds
)


def touches(model: Model) -> bool:
    """Whether ropes may touch obstacles or each other: a step then costs by where they are."""
    return model.scene.contact is not None or bool(model.scene.obstacles)


def run_time(model: Model, seconds: float, measured: bool) -> str:
    """Return in words how long a run takes, from the estimate `seconds` [s], without recording."""
    if measured:
        pace = ", at the pace of its first steps" if touches(model) else ""
        return f"in about {_duration(seconds)}{pace}"
    if touches(model):
        return "in a time that is not known: contact makes steps dearer, up to sixty times"
    low, high = _duration(seconds / _WITHIN), _duration(seconds * _WITHIN)
    return f"in {'about' if low == high else f'some {low} to'} {high} (not measured)"


def _duration(seconds: float) -> str:
    if seconds < 1.0:
        return f"{max(1e3 * seconds, 1.0):.0f} ms"
    if seconds < 120.0:
        return f"{seconds:.2g} s" if seconds < 99.5 else f"{seconds:.0f} s"
    return f"{seconds / 60:.3g} min" if seconds < 7200.0 else f"{seconds / 3600:.3g} h"


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
        or not are_compiled(method, model.system.rare, model.scene)
    ):
        return typical, False
    simulation = Simulation(model)
    dt = model.plan.dt
    count = max(1, min(int(_SAMPLE / typical), 2000, model.plan.steps))
    try:
        simulation.step(dt)
        start = clock()
        simulation.step(count * dt)
        spent = clock() - start
    except Broken:
        return typical, False
    return spent / count, True
