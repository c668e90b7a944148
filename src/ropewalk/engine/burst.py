"""Ropes that have burst within a call: where their boxes say that they have been, they have not."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ropewalk.core.status import BROKEN
from ropewalk.engine.engine import Engine
from ropewalk.methods.verdict import judge

Pairs = set[tuple[int, int]]


def unburst(engines: Sequence[Engine], pairs: Pairs, finite: bool, time: float | None) -> Pairs:
    """Return those pairs of islands of which none has burst.

    With `finite` that is what is nowhere, or by `time` [s], where it is given, has energy made up; what is
    stretched far may come back. Else it is what is stretched beyond the verdict's bound.
    """
    numbers = {k for pair in pairs for k in pair}
    whole = {k for k in numbers if _is_whole(engines[k], finite, time)}
    return {pair for pair in pairs if whole.issuperset(pair)}


def _is_whole(engine: Engine, finite: bool, time: float | None) -> bool:
    state, most = engine.state, engine.system.break_stretch
    if finite:
        return bool(np.isfinite(state.x).all()) and (time is None or not _made_up(engine, time))
    square = (np.diff(state.x, axis=1) ** 2).sum(axis=0)
    live = (state.stiffness > 0.0) & (state.rest_length > 0.0)
    return bool((square[live] <= (most * state.rest_length[live]) ** 2).all())


def _made_up(engine: Engine, time: float) -> bool:
    """Tell whether the verdict of a frame would find a fault that is no stretch; nothing changes by that."""
    state, kept = engine.state, engine.state.balance.copy()
    status = judge(engine.system._replace(break_stretch=np.inf), state, time)
    state.balance[:] = kept
    return bool(status == BROKEN)
