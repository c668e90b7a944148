"""Ropes that part: what carries more than its breaking load at the end of a step is let go.

Of every rope the most loaded segment parts, relative to its breaking load. The others have not heard of it:
until a wave from there can have come, node by node along the rope, no other segment of the rope
parts. Else all that carried too much at that moment would, one a step, and the rope would be dust: a rope
parts where it is weakest, and its strength is never the same all along. A front of a chain of masses and
springs is about 2 d^(1/3) segments wide after d of them, which is waited for as well.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, part
from ropewalk.laws.clamps import bent_energy
from ropewalk.laws.couplings import part_couplings
from ropewalk.laws.elastic import stored_energy
from ropewalk.laws.fresh import working_segment
from ropewalk.laws.rare import has_bending, winds
from ropewalk.methods.carried import carried_tension, record_elastic
from ropewalk.methods.scratch import SEEN

WIDE = 2.0  # [1]


@part
def part_ropes(system, state, look, t):
    """Part what carries too much at the end of a step at time `t` [s]; return how many segments.

    The forces at hand are then no longer those of the state.
    """
    table, parted = system.node.parting, state.memory.parting
    over, carried, look.known[SEEN] = look.segments[0], look.segments[1], 0.0
    record_elastic(system, state, look.sums, over)
    carried_tension(system, state, over, carried)
    if winds(system, state):
        spare_drums(system.winches, state.winch_exit, parted.time, carried)
    count, j, begin = 0, 0, 0
    passing = table.passing
    if find_overloaded(table.strength, table.rope, passing, parted.time, carried, t, over) > 0:
        while begin < over.shape[0]:
            j, begin = most_loaded(table.rope, over, begin)
            if j >= 0:
                part_segment(system, state, j, carried[j], t)
                count += 1
    return count


@kernel
def spare_drums(winches, exits, time, carried):
    """Leave out the segments next to drums, whose lengths are the winches': the next ones part, if any.

    Those count that are there, up to where the rope has parted at some `time` [s].
    """
    for row in range(exits.shape[0]):
        first, last = winches.first[row], winches.last[row]
        low, high, drums, end = min(first, last), max(first, last), 0, last
        for other in range(exits.shape[0]):
            if low <= exits[other] <= high:
                drums += 1
                if other != row:
                    end = exits[other]
        reach, whole = 0, abs(end - exits[row])
        while reach < whole:
            j = exits[row] + reach if winches.step[row] > 0 else exits[row] - 1 - reach
            if time[j] < math.inf:
                drums = 1  # another drum lies beyond
                break
            reach += 1
        if reach > drums:
            carried[working_segment(winches, exits, row)] = 0.0


@kernel
def time_of_news(segments, passing):
    """Return how long a parting is unknown so many segments away [s]; a wave takes `passing` [s]."""
    if segments == 0:
        return 0.0
    return passing * (1.0 + (WIDE + WIDE * segments ** (1.0 / 3.0)) / segments)


@kernel
def find_overloaded(strength, rope, passing, time, carried, t, over):
    """Write tension over breaking load of every segment that may part, else 0, (s,); return how many."""
    count, last, here = 0, -1, -1
    for j in range(over.shape[0]):
        over[j] = 0.0
        if rope[j] != here:
            here, last = rope[j], -1
        if here < 0:
            continue
        if time[j] < math.inf:
            last = j
        elif carried[j] > strength[j] and carried[j] < math.inf:
            if last < 0 or t - time[last] >= time_of_news(j - last, passing[j] - passing[last]):
                over[j] = carried[j] / strength[j]
                count += 1
    if count == 0:
        return 0
    last, here = -1, -1
    for back in range(over.shape[0]):
        j = over.shape[0] - 1 - back
        if rope[j] != here:
            here, last = rope[j], -1
        if here >= 0 and time[j] < math.inf:
            last = j
        elif over[j] > 0.0 and last >= 0:
            if t - time[last] < time_of_news(last - j, passing[last] - passing[j]):
                over[j] = 0.0
                count -= 1
    return count


@kernel
def most_loaded(rope, over, begin):
    """Return the most loaded segment of the rope that begins with segment `begin`, -1: none, and the next."""
    j, best, found = begin, 0.0, -1
    while j < over.shape[0] and rope[j] == rope[begin]:
        if over[j] > best:
            best, found = over[j], j
        j += 1
    return found, j


@part
def part_segment(system, state, j, tension, t):
    """Let segment `j` go, which carries `tension` [N], at time `t` [s]; what it stored is lost."""
    x = state.x
    lost = stored_energy(system, state, x, state.inner)
    if has_bending(system):
        lost += bent_energy(system, state, x)
    state.stiffness[j] = 0.0
    state.damping_vector[j] = 0.0
    state.damping_axial[j] = 0.0
    state.rest_length[j] = 0.0
    state.tension[j] = 0.0
    if state.limited.shape[0] > 0:
        state.limited[j] = 0.0
    if has_bending(system):
        for i in (j, j + 1):
            state.bending_stiffness[i] = 0.0
            state.bending_damping[i] = 0.0
        lost -= bent_energy(system, state, x)
    lost -= stored_energy(system, state, x, state.inner)
    state.memory.parting.time[j] = t
    state.memory.parting.tension[j] = tension
    state.work.node.parting[j] -= lost
    part_couplings(system, state, j, t)
    state.past[0] = 0.0  # a multistep method begins anew
