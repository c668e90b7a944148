"""Where the stages of a step are to begin, for a rope whose next step was looked at already."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.core.jit import part
from ropewalk.methods.scratch import put, put_row

READY, BEGIN, END, STEP, USED = range(5)


class Starts(NamedTuple):
    """The starts of all stages, and what they are for."""

    x: Floats  # (stages, 3, n) [m]
    v: Floats  # (stages, 3, n) [m/s]
    tension: Floats  # (stages, s) [N]
    known: Floats  # (5,) 1 where there are any, of which step: begin, end, length [s]; how many were of use


def make_starts(state: State, stages: int) -> Starts:
    """Return room for them."""
    x, tension = np.zeros((stages, *state.x.shape)), np.zeros((stages, *state.tension.shape))
    return Starts(x, x.copy(), tension, np.zeros(5))


@part
def forget_starts(starts):
    """Forget them, as the state has changed."""
    starts.known[READY] = 0.0


@part
def take_start(starts, s, t, after, dt, stage):
    """Begin stage `s` of a step where its start is, if there is one."""
    known = starts.known
    if known[READY] == 1.0 and known[BEGIN] == t and known[END] == after and known[STEP] == dt:
        put(starts.x[s], stage.x)
        put(starts.v[s], stage.v)
        put_row(starts.tension[s], stage.tension)
        known[USED] += 1.0
