"""Winches: the unstretched length of a rope changes at one end.

The segment next to the drum (the working segment) gets longer or shorter every step; its spring constant
is EA over its present length, and half of the new length's mass goes to either of its nodes. Beyond
1.6 nominal lengths it is split where both parts have its strain, below 0.4 it is merged with its neighbour;
the merged rest length is chosen so that its tension is the working segment's, and the small difference in
unstretched length is given back while the winch turns on. So tension has no jump and no length is lost.
What the winch does to the energies is booked as its work.

A segment's length is that of every stage's own time (`wind_to`); masses, and nodes that go on or off a drum,
follow at the end of the step. Methods that use the forces of its beginning alone wind at its end.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import State, System
from ropewalk.core.jit import deferred, kernel, part
from ropewalk.laws.clamps import bent_energy
from ropewalk.laws.couplings import wind_couplings
from ropewalk.laws.elastic import stored_energy
from ropewalk.laws.fresh import (
    mix_in,
    mix_segments,
    remembers,
    split_memory,
    working_segment,
)
from ropewalk.laws.joints import is_tied
from ropewalk.laws.ledger import gravity_energy, kinetic_energy
from ropewalk.laws.parting import has_parted
from ropewalk.laws.rare import has_bending, has_inner, parts
from ropewalk.laws.wound_bends import put_on_beam, set_bends

SPLIT = 1.6  # [1] times the nominal segment length
MERGE = 0.4
CHANGED = 0.05  # [1] of a winch's rate: a smaller change is what it gives back of merged segments
WINCH_SHARE = 0.2  # a winch winds at most this part of a segment in a step [1]

# Columns of `turning`: the step's begin and length [s], the working segment's rest length then, what the
# winch winds and what it gives back of what merged segments have lost [m], 1 where it can turn at all, the
# working segment's length then [m].
BEGIN, STEP, LENGTH, WOUND, BACK, TURNS, REACH = range(7)


def joined(system: System, state: State) -> NDArray[np.bool_]:
    """Return which segments join two nodes of a rope, or will when they leave a drum, (s,)."""
    found = state.stiffness > 0.0
    for one, other in zip(system.winches.first, system.winches.last, strict=True):
        found[min(one, other) : max(one, other)] = True
    return found


@deferred()
def run_winches(system, state, t, dt, turning):
    """Turn all winches by one step that starts at `t` [s], after it, and book their work.

    `turning` is working space, as of `plan_turns`.
    """
    kinetic, potential = kinetic_energy(state.v, state.mass), _potential(system, state)
    for row in range(state.winch_exit.shape[0]):
        plan_turn(system, state, row, t, dt, turning)
        if has_inner(system, state):
            j = working_segment(system.winches, state.winch_exit, row)
            mix_in(system, state, j, turning[row, WOUND] + turning[row, BACK])
        _end_turn(system, state, row, turning)
        turning[row, WOUND] = 0.0
    wind_couplings(system, state)
    _book(system, state, kinetic, potential)


@deferred("boolean")
def plan_turns(system, state, t, dt, turning):
    """Write what every winch is to wind in the step of `dt` from `t` [s], (w, 7), see BEGIN.

    Returns whether one starts, stops or changes its speed, so that forces at `t` are others than before.
    """
    for row in range(turning.shape[0]):
        turning[row, WOUND] = 0.0
    changed = False
    for row in range(turning.shape[0]):
        before = state.winch_rate[row]
        plan_turn(system, state, row, t, dt, turning)
        rate = state.winch_rate[row]
        changed = changed or abs(rate - before) > CHANGED * max(abs(rate), abs(before))
    return changed


@deferred()
def wind_to(system, state, time, turning):
    """Give the working segments the rest lengths that they have at `time` [s] of the planned step."""
    winches = system.winches
    for row in range(turning.shape[0]):
        working, change = working_segment(winches, state.winch_exit, row), 0.0
        for other in range(turning.shape[0]):  # both ends of a rope may work on one segment
            if working_segment(winches, state.winch_exit, other) == working:
                change += turning[other, WOUND] + turning[other, BACK]
        if change != 0.0:
            share = (time - turning[row, BEGIN]) / turning[row, STEP]
            set_segment(winches, state, row, working, turning[row, LENGTH] + share * change)
            if has_bending(system):
                set_bends(system, state, row)


@kernel
def winding(turning):
    """Tell whether any winch winds in the planned step."""
    busy = False
    for row in range(turning.shape[0]):
        busy = busy or turning[row, WOUND] + turning[row, BACK] != 0.0
    return busy


@deferred()
def end_turns(system, state, turning):
    """End a step in which `wind_to` has wound: masses, and the nodes at the drums; book their work."""
    kinetic, potential = kinetic_energy(state.v, state.mass), _potential(system, state)
    wind_to(system, state, turning[0, BEGIN], turning)  # then one winch after the other
    for row in range(state.winch_exit.shape[0]):
        _end_turn(system, state, row, turning)
    wind_couplings(system, state)
    _book(system, state, kinetic, potential)


@deferred()
def cut_short(system, state, t, turning):
    """End the turns of a step that came no farther than to `t` [s]."""
    wind_to(system, state, t, turning)
    if t <= turning[0, BEGIN]:
        return
    for row in range(turning.shape[0]):
        share = (t - turning[row, BEGIN]) / turning[row, STEP]
        turning[row, WOUND] *= share
        turning[row, BACK] *= share
        turning[row, STEP] *= share
    end_turns(system, state, turning)


@kernel
def _book(system, state, kinetic, potential):
    """Book what has changed since the energies were these [J], and the largest work so far."""
    state.work.winch[0] += kinetic_energy(state.v, state.mass) - kinetic
    state.work.winch[1] += _potential(system, state) - potential
    last = state.most.shape[0] - 1
    state.most[last] = max(state.most[last], abs(state.work.winch[0] + state.work.winch[1]))


@kernel
def _potential(system, state):
    stored = stored_energy(system, state, state.x, state.inner)
    if has_bending(system):
        stored += bent_energy(system, state, state.x)
    return gravity_energy(state.x, state.mass, system.gravity) + stored


@part
def stays_off(system, state, row, node):
    """Tell whether a node cannot come on to the drum of a winch: one that is held, tied, or has a load."""
    return (
        state.inverse_mass[node] == 0.0
        or is_tied(system, state, node)
        or node == system.winches.load[row]
    )


@kernel
def plan_turn(system, state, row, t, dt, turning):
    """Write what winch `row` is to wind in the step of `dt` from `t` [s], and the rate of that."""
    winches = system.winches
    drum, working = state.winch_exit[row], working_segment(winches, state.winch_exit, row)
    nominal, length = winches.segment[row], state.rest_length[working]
    low = min(winches.first[row], winches.last[row])
    high = max(winches.first[row], winches.last[row])
    whole = not (parts(system) and has_parted(state.memory.parting.time, low, high))
    outer = drum + winches.step[row]
    wound = 0.0
    turned = min(t + dt, winches.stop[row]) - max(t, winches.start[row])
    # A drum that was let go does not turn, nor one whose rope has parted.
    turns = state.held[winches.anchor[row]] == 1 and whole
    if turned > 0.0 and turns:
        total = unstretched(winches, state, row)
        for other in range(
            turning.shape[0]
        ):  # what another drum of the rope winds in the same step
            if low <= state.winch_exit[other] <= high and other != row:
                total += turning[other, WOUND]
        wound = winches.speed[row] * turned
        if wound < 0.0:
            wound = max(wound, min(0.0, winches.shortest[row] - total))
        else:
            left = winches.drum[row] - state.winch_paid[row]
            wound = min(wound, max(0.0, min(winches.longest[row] - total, left)))
        if stays_off(system, state, row, outer):
            wound = max(wound, min(0.0, 0.5 * nominal - length))
        if drum == winches.first[row]:  # no node is left to pay out
            wound = min(wound, max(0.0, SPLIT * nominal - length))
    back = 0.0
    if turns:
        back = state.winch_debt[row] * min(
            1.0, abs(wound) / nominal
        )  # its mass never left the rope
    turning[row, BEGIN], turning[row, STEP], turning[row, LENGTH] = t, dt, length
    turning[row, WOUND], turning[row, BACK] = wound, back
    turning[row, TURNS] = 1.0 if turns else 0.0
    state.winch_rate[row] = (wound + back) / dt


@kernel
def _end_turn(system, state, row, turning):
    """Give the working segment its length and masses; split or merge it where it is due."""
    winches = system.winches
    drum, working = state.winch_exit[row], working_segment(winches, state.winch_exit, row)
    nominal = winches.segment[row]
    outer = drum + winches.step[row]
    wound, back, length = turning[row, WOUND], turning[row, BACK], state.rest_length[working]
    state.winch_debt[row] -= back
    state.winch_paid[row] += wound
    if wound + back != 0.0:
        length += wound + back
        state.mass[drum] += 0.5 * winches.line[row] * wound
        add_mass(state, outer, 0.5 * winches.line[row] * wound)
        set_segment(winches, state, row, working, length)
    if turning[row, TURNS] == 1.0:
        if length > SPLIT * nominal and drum != winches.first[row]:
            split(system, state, row, drum, working, length)
        elif (
            length < MERGE * nominal
            and outer != winches.last[row]
            and not stays_off(system, state, row, outer)
        ):
            merge(system, state, row, drum, working, length)
    follow_drum(winches, state, row)
    if has_bending(system):
        set_bends(system, state, row)


@kernel
def unstretched(winches, state, row):
    """Return the unstretched length of the rope off all its drums [m], debts included."""
    low = min(winches.first[row], winches.last[row])
    high = max(winches.first[row], winches.last[row])
    total = 0.0
    for j in range(low, high):
        total += state.rest_length[j]  # what is on a drum is dead, of length 0
    for other in range(state.winch_exit.shape[0]):
        if low <= state.winch_exit[other] <= high:
            total += state.winch_debt[other]
    return total


@kernel
def add_mass(state, node, mass):
    """Add mass to a node [kg]; a held node stays held."""
    state.mass[node] += mass
    if state.inverse_mass[node] > 0.0:
        state.inverse_mass[node] = 1.0 / state.mass[node]


@kernel
def set_segment(winches, state, row, segment, length):
    """Give a segment a rest length [m] and the material that goes with it."""
    state.rest_length[segment] = length
    state.stiffness[segment] = winches.EA[row] / length
    state.damping_vector[segment] = winches.vector[row] / length
    state.damping_axial[segment] = winches.axial[row] / length


@kernel
def split(system, state, row, drum, working, length):
    """Let the node on the drum go, where both halves keep strain and rate of strain.

    The next one becomes the exit. What grows is the half at the drum alone, so that the node goes nearly as
    fast as the one ahead.
    """
    winches = system.winches
    state.past[0] = 0.0  # a multistep method knows nothing of the node's past
    side = winches.step[row]
    nominal, line = winches.segment[row], winches.line[row]
    outer, inner = drum + side, drum - side
    rest = length - nominal
    grown = nominal / length * state.winch_rate[row] / length  # of the way to the node ahead [1/s]
    for k in range(3):
        way = state.x[k, outer] - state.x[k, drum]
        state.x[k, inner] = state.x[k, drum]
        state.v[k, inner] = state.v[k, drum]
        state.x[k, drum] += rest / length * way
        state.v[k, drum] += rest / length * (state.v[k, outer] - state.v[k, drum]) + grown * way
        state.acceleration[k, drum] = rest / length * state.acceleration[k, outer]
    near = rest
    if has_bending(system):
        near = put_on_beam(system, state, row, length)
        state.winch_debt[row] += rest - near
    state.mass[inner] = state.mass[drum] - 0.5 * line * nominal
    state.mass[drum] = 0.5 * line * length
    state.inverse_mass[drum] = 1.0 / state.mass[drum]
    add_mass(state, outer, -0.5 * line * rest)
    set_segment(winches, state, row, working, nominal)
    set_segment(winches, state, row, working - side, near)
    if has_inner(system, state):
        split_memory(state, working, working - side)
    state.winch_exit[row] = inner
    state.anchor_node[winches.anchor[row]] = inner


@kernel
def merge(system, state, row, drum, working, length):
    """Take the next node on to the drum; keep the working segment's tension."""
    winches = system.winches
    state.past[0] = 0.0
    side = winches.step[row]
    outer = drum + side
    far = outer + side
    following = working + side
    stretched, merged = 0.0, 0.0
    for k in range(3):
        stretched += (state.x[k, outer] - state.x[k, drum]) ** 2
        merged += (state.x[k, far] - state.x[k, drum]) ** 2
    stretched, merged = math.sqrt(stretched), math.sqrt(merged)
    both = length + state.rest_length[following]
    kept = merged * length / stretched if stretched > length else both
    if has_inner(system, state) and remembers(system.elastic, state.stiffness, working):
        kept = mix_segments(system, state, working, following, merged)
    kept = max(kept, MERGE * winches.segment[row])  # a fold must not make it short and stiff
    state.winch_debt[row] += both - kept
    state.mass[outer] += state.mass[drum] - 0.5 * winches.line[row] * length
    add_mass(state, far, 0.5 * winches.line[row] * length)
    state.mass[drum] = 0.0
    state.inverse_mass[outer] = 0.0
    for k in range(3):
        state.x[k, outer] = state.x[k, drum]
        state.v[k, outer] = state.v[k, drum]
        state.acceleration[k, outer] = 0.0
    state.stiffness[working] = 0.0
    state.damping_vector[working] = 0.0
    state.damping_axial[working] = 0.0
    state.rest_length[working] = 0.0
    set_segment(winches, state, row, following, kept)
    state.winch_exit[row] = outer
    state.anchor_node[winches.anchor[row]] = outer


@kernel
def follow_drum(winches, state, row):
    """Keep the rope that is on the drum where the drum is, out of reach of every law's work."""
    drum, side = state.winch_exit[row], winches.step[row]
    i = winches.first[row]
    while i != drum:
        for k in range(3):
            state.x[k, i] = state.x[k, drum]
            state.v[k, i] = 0.0
        i += side
