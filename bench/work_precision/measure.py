"""Error and shortest time of every contestant of a case."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np

from bench.work_precision.contestants import Entry, Series, all_series
from bench.work_precision.equations import Floats, equations
from bench.work_precision.reference import Reference, distance, reference
from bench.work_precision.scenes import Case
from ropewalk.lowering import build

ROUNDS = 7  # at most, per entry
SHARE = 0.25  # [s] of repeats per entry, after the first
LONGEST = 2.5  # [s] a contestant that took longer is not given a smaller step
BROKEN_LONGEST = 0.2  # [s] the same, for one that broke
FLOOR = 10.0  # times the reference's own error: nothing below it is believed
FINE = 1e-8  # [m] nobody needs less


class Point(NamedTuple):
    """One contestant at one setting: what it cost and how far off it was."""

    case: str
    family: str
    name: str
    setting: float  # step [s], or tolerance
    seconds: float  # shortest of the repeats
    error: float  # [m], rms over nodes at the end; inf where the run broke
    reference_error: float  # [m]


def measure(
    case: Case, series: Callable[..., Iterable[Series]] = all_series, share: float = SHARE
) -> tuple[list[Point], Reference]:
    """Return the points of all contestants of a case, and the reference they are measured against.

    Every entry runs once for its error; then the entries take turns, and each keeps its shortest time.
    """
    model = build(case.scene)
    system = equations(model)
    exact = reference(system, case.duration)
    first: list[tuple[Entry, float, float]] = []
    for one in series(case, model, system):
        first += _first_runs(one, exact)
    best = {id(entry): seconds for entry, _, seconds in first}
    for turn in range(ROUNDS):
        for entry, error, seconds in first:
            if math.isfinite(error) and turn < share / seconds:
                best[id(entry)] = min(best[id(entry)], _timed(entry)[1])
    points = [
        Point(case.name, e.family, e.name, e.setting, best[id(e)], error, exact.error)
        for e, error, _ in first
    ]
    return points, exact


def _first_runs(series: Series, exact: Reference) -> list[tuple[Entry, float, float]]:
    """Run the entries until they become too slow, or as exact as the reference."""
    found = []
    for number, entry in enumerate(series.entries):
        if number == 0 and series.family != "scipy":  # the first call compiles
            _timed(entry)
        places, seconds = _timed(entry)
        error = distance(places, exact.positions) if places is not None else math.inf
        error = error if math.isfinite(error) else math.inf
        found.append((entry, error, seconds))
        longest = LONGEST if math.isfinite(error) else BROKEN_LONGEST
        if seconds > longest or error < max(FLOOR * exact.error, FINE):
            break
    return found


def _timed(entry: Entry) -> tuple[Floats | None, float]:
    """Run an entry; return its positions (None when it broke) and its time [s]."""
    entry.ready()
    begun = time.perf_counter()
    try:
        with np.errstate(all="ignore"):
            places = entry.run()
    except RuntimeError:
        return None, time.perf_counter() - begun
    return places, time.perf_counter() - begun
