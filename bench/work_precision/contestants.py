"""Who competes: every method of Ropewalk, numpy and scipy, each over a range of steps or tolerances."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.sparse import csr_array, diags_array, kron

from bench.work_precision.equations import LOWER_BAND, UPPER_BAND, Equations, Floats, rates
from bench.work_precision.numpy_euler import numpy_euler
from bench.work_precision.scenes import Case
from ropewalk import Simulation
from ropewalk.analysis.stability import stability
from ropewalk.lowering import Model
from ropewalk.methods.registry import METHODS

HALVINGS = 11
MOST_STEPS = 3e6
LARGEST_STEP = 1.0 / 15.0  # [s]
CLOSE_TO_BOUND = 0.95
TOLERANCES = tuple(10.0**-k for k in range(2, 10))
OURS = TOLERANCES[
    :6
]  # of the adaptive method, for a step; a run's error is some hundred times as large
SCIPY = ("LSODA", "Radau", "BDF")


class Entry(NamedTuple):
    """One contestant at one setting."""

    family: str
    name: str
    setting: float  # step [s], or tolerance
    ready: Callable[[], object]  # outside the clock
    run: Callable[[], Floats]  # returns positions [m], (n, 3), at the end


class Series(NamedTuple):
    """One contestant's entries, from the cheapest to the dearest."""

    family: str
    name: str
    entries: tuple[Entry, ...]


def all_series(case: Case, model: Model, equations: Equations) -> Iterator[Series]:
    """Yield every contestant of a case."""
    bounds = stability(model).largest_step
    for name in (name for name, method in METHODS.items() if method.fixed):
        bound = bounds.get(name, math.inf)
        bound = bound if bound > case.duration / MOST_STEPS else 0.0  # too small to be of use
        steps = step_sizes(bound, bounds["semi-implicit-euler"])
        yield Series("ropewalk", name, tuple(_ropewalk(case, name, step) for step in steps))
    yield Series("ropewalk", "adaptive", tuple(_adaptive(case, tol) for tol in OURS))
    steps = step_sizes(bounds["semi-implicit-euler"], math.inf)
    yield Series("numpy", "semi-implicit-euler", tuple(_numpy(case, equations, s) for s in steps))
    for name in SCIPY:
        entries = tuple(_scipy(case, equations, name, tol) for tol in TOLERANCES)
        yield Series("scipy", name, entries)


def step_sizes(bound: float, other: float) -> list[float]:
    """Return steps from close to the stability bound [s] on, each half of the one before it.

    A method without a stable step begins where the `other` bound is.
    """
    largest = CLOSE_TO_BOUND * (bound if bound > 0.0 else other)
    largest = min(largest, LARGEST_STEP)
    return [largest / 2**k for k in range(HALVINGS)]


def _ropewalk(case: Case, method: str, step: float) -> Entry:
    return _stepped(case, method, step, time_step=step, steps="divide")


def _adaptive(case: Case, tolerance: float) -> Entry:
    return _stepped(case, "adaptive", tolerance, time_step="auto", tolerance=tolerance)


def _stepped(case: Case, method: str, setting: float, **more: object) -> Entry:
    """Return an entry that runs in one frame, with no ledger."""
    once = {"duration": case.duration, "frame_rate": 1.0 / case.duration}
    run = case.scene.run.replace(method=method, **once, **more)
    simulation = Simulation(case.scene.replace(run=run), ledger=False)
    start = simulation.state

    def positions() -> Floats:
        simulation.step()
        return simulation.positions

    return Entry("ropewalk", method, setting, lambda: simulation.restore(start), positions)


def _numpy(case: Case, equations: Equations, step: float) -> Entry:
    count = math.ceil(case.duration / step)

    def positions() -> Floats:
        return numpy_euler(equations, case.duration, count)

    return Entry("numpy", "semi-implicit-euler", step, lambda: None, positions)


def _scipy(case: Case, equations: Equations, method: str, tolerance: float) -> Entry:
    if method == "LSODA":
        options: dict[str, object] = {"lband": LOWER_BAND, "uband": UPPER_BAND}
    else:
        options = {"jac_sparsity": sparsity(equations.nodes.shape[1])}

    def positions() -> Floats:
        y = equations.start
        for begin, end in equations.pieces(case.duration):
            y = equations.enter(y, begin)
            found = solve_ivp(
                rates,
                (begin, end),
                y,
                method,
                t_eval=[end],
                args=equations.arguments,
                rtol=tolerance,
                atol=tolerance,
                **options,
            )
            if not found.success:
                raise RuntimeError(found.message)
            y = found.y[:, -1]
        return equations.places(y)

    return Entry("scipy", method, tolerance, lambda: None, positions)


def sparsity(nodes: int) -> csr_array:
    """Return which entries of the Jacobian can differ from zero, (6 n, 6 n)."""
    offsets = [-1, 0, 1]
    neighbours = diags_array([np.ones(nodes - abs(k)) for k in offsets], offsets=offsets)
    forces = np.zeros((6, 6))
    forces[3:, :] = 1.0
    motion = np.zeros((6, 6))
    motion[:3, 3:] = np.eye(3)
    return csr_array(kron(neighbours, forces) + kron(np.eye(nodes), motion))
