"""Contacts of a rope whose nodes come off a winch's drum, or go on to it: the same places of other segments.

A node that comes off lies on the segment that was next to the drum, so that every point of it stays where it
was. One that goes on leaves a straight line between drum and node beyond: contacts there keep what they hold,
and the way to that line is looked at as that of a step is.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.laws.pairs.force import depth_at
from ropewalk.laws.pairs.pair_memory import drop_gone, look_for_passes
from ropewalk.laws.pairs.search import are_neighbours, find_near, note_ropes
from ropewalk.laws.pairs.swept import sweep
from ropewalk.laws.pairs.table import (
    CONTACTS,
    FAULT,
    FULL,
    GONE,
    LEVER,
    OTHER,
    OWN,
    PUSH,
    SPRING,
    STIFF,
    WIDTH,
)
from ropewalk.laws.pairs.way import begin_contact

LEAST = 1e-6  # [1] least part of two segments that one of them is


@small
def length_of(x, segment):
    """Return how long a segment is [m]."""
    square = 0.0
    for k in range(3):
        square += (x[k, segment + 1] - x[k, segment]) ** 2
    return math.sqrt(square)


@kernel
def move_to(memory, row, a, segment, place, scale):
    """Put side `a` of a contact to a place of another segment, so many times as long as its own was."""
    pair, grip = memory.pair, memory.grip
    pair[row, a] = segment
    grip[row, OWN + a * (OTHER - OWN)] = min(max(place, 0.0), 1.0)
    for k in range(3):
        grip[row, LEVER + 3 * a + k] /= scale


@kernel
def come_off(memory, new, old, side, share):
    """Share the contacts of segment `old` with `new`, which begins at the drum and has so much of it."""
    for row in range(memory.tally[CONTACTS]):
        for a in range(2):
            if memory.pair[row, a] != old:
                continue
            place = memory.grip[row, OWN + a * (OTHER - OWN)]
            place = place if side > 0 else 1.0 - place  # from the drum on
            if place < share:
                segment, place, scale = new, place / share, share
            else:
                segment, place, scale = old, (place - share) / (1.0 - share), 1.0 - share
            move_to(memory, row, a, segment, place if side > 0 else 1.0 - place, scale)


@kernel
def go_on(x, table, memory, tied, gone, kept, side):
    """Give the contacts of segment `gone`, next to the drum, to `kept`, which spans both at x (3, n).

    The places before are those of `memory`.
    """
    near, far = length_of(memory.place, gone), length_of(memory.place, kept)
    share = min(max(near / (near + far), LEAST), 1.0 - LEAST) if near + far > 0.0 else 0.5
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        if i != gone and j != gone and i != kept and j != kept:
            continue
        before = depth_at(memory.place, memory, row, i, j, table.radius[i] + table.radius[j])
        for a in range(2):
            segment, place = memory.pair[row, a], memory.grip[row, OWN + a * (OTHER - OWN)]
            place = place if side > 0 else 1.0 - place
            if segment == gone:
                place, part = share * place, share
            elif segment == kept:
                place, part = share + (1.0 - share) * place, 1.0 - share
            else:
                continue
            move_to(memory, row, a, kept, place if side > 0 else 1.0 - place, 1.0 / part)
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        if are_neighbours(table, memory, tied, min(i, j), max(i, j)):
            memory.grip[row, GONE] = 1.0
        else:
            begin_contact(x, table, memory, row, before)


@small
def is_after(pair, a, b):
    """Tell whether row a belongs after row b."""
    return pair[a, 0] > pair[b, 0] or (pair[a, 0] == pair[b, 0] and pair[a, 1] > pair[b, 1])


@kernel
def sort_rows(memory):
    """Sort the contacts by their segments; of two between the same ones the first takes over."""
    pair, grip = memory.pair, memory.grip
    for last in range(1, memory.tally[CONTACTS]):
        row = last
        while row > 0 and is_after(pair, row - 1, row):
            for a in range(2):
                pair[row - 1, a], pair[row, a] = pair[row, a], pair[row - 1, a]
            for k in range(WIDTH):
                grip[row - 1, k], grip[row, k] = grip[row, k], grip[row - 1, k]
            row -= 1
    first = 0
    for row in range(1, memory.tally[CONTACTS]):
        other = pair[row, 0] != pair[first, 0] or pair[row, 1] != pair[first, 1]
        if other or grip[first, GONE] == 1.0:
            first = row
            continue
        grip[row, GONE] = 1.0
        grip[first, PUSH] += grip[row, PUSH]
        grip[first, STIFF] = max(grip[first, STIFF], grip[row, STIFF])
        for k in range(3):
            grip[first, SPRING + k] += grip[row, SPRING + k]
    drop_gone(memory)


@kernel
def wind_pairs(table, state, winches):
    """Let contacts follow the nodes that have gone on to drums, or come off, since the last step."""
    memory, x, changed = state.memory.contact, state.x, False
    for row in range(state.winch_exit.shape[0]):
        drum, side = state.winch_exit[row], winches.step[row]
        working = drum if side > 0 else drum - 1
        on_drum = working - side
        if memory.rope[working] < 0 and state.stiffness[working] > 0.0:
            length = state.rest_length[working]
            share = length / (length + state.rest_length[working + side])
            come_off(memory, working, working + side, side, share)
            changed = True
        elif 0 <= on_drum < memory.rope.shape[0] and memory.rope[working] >= 0:
            if memory.rope[on_drum] == memory.rope[working] and state.stiffness[on_drum] == 0.0:
                go_on(x, table, memory, state.tied, on_drum, working, side)
                changed = True
    if not changed:
        return
    note_ropes(table, memory, state.stiffness)
    sweep(memory.place, x, memory)
    sort_rows(memory)
    if not find_near(memory.place, x, table, memory, state.tied):
        memory.tally[FAULT] = FULL
    look_for_passes(memory.place, x, memory, table)
    for k in range(3):
        for i in range(x.shape[1]):
            memory.place[k, i] = x[k, i]
