"""Bounds of the stretch where drums wind: the length of a segment at its bound changes with its rest length.

A segment of rest length L at the bound s has the length s L, which a drum that winds L' changes by s L' in a
second. Impulses bring the rate of length to that, and not to zero; what they do through it is the drum's.
"""

from __future__ import annotations

from ropewalk.core.jit import kernel, small
from ropewalk.laws.fresh import working_segment
from ropewalk.laws.rare import winds


@small
def bound_rate(limiter, bound, rate):
    """Return how fast a bound moves [m/s] where rope is wound at `rate`: 0 at none, shortest if negative."""
    if bound == 0.0:
        return 0.0
    return (limiter.longest if bound > 0.0 else limiter.shortest) * rate


@kernel
def begin_rates(system, state, bound, rates):
    """Write minus the rates of length that segments are to have at a `bound`, 0 elsewhere, (s,) [m/s]."""
    for j in range(state.rest_length.shape[0]):
        rates[j] = 0.0
    if winds(system, state):
        for row in range(state.winch_exit.shape[0]):
            j = working_segment(system.winches, state.winch_exit, row)
            rates[j] -= bound_rate(system.limiter, bound[j], state.winch_rate[row])


@kernel
def give_to_drums(system, state, bound, impulse):
    """Book and return what drums do through impulses [N s] of the segments at them [J]."""
    total = 0.0
    for row in range(state.winch_exit.shape[0]):
        j = working_segment(system.winches, state.winch_exit, row)
        total -= impulse[j] * bound_rate(system.limiter, bound[j], state.winch_rate[row])
    state.work.winch[0] += total
    last = state.most.shape[0] - 1
    state.most[last] = max(state.most[last], abs(state.work.winch[0] + state.work.winch[1]))
    return total
