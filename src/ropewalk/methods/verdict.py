"""Whether a simulation is broken: not finite, stretched beyond reason, or with energy that nothing gave it.

The energy of the ropes (kinetic, weight, stretch, bending, of laws of nodes and forces applied), less that at
the start, can honestly be what anchors, clamps and winches have put in, what a wind can, and what weight or
the energy at the start turns over. Friction and air at rest take energy and give none, so that the
verdict needs no ledger. A limiter that acts after explicit steps takes much of what it makes them make up:
what it has taken counts as there still, and what it has put in is made up. What anchors give is counted at
its most so far, step by step (`State.most`, kept where the work is booked): at a period's end it is zero
again. What changes between two calls (a kick, a force) counts as given.
"""

from __future__ import annotations

from ropewalk.core.arrays import APPLIED
from ropewalk.core.jit import kernel, part, seldom
from ropewalk.core.status import BROKEN, HONEST, LAST, MADE_UP, OK, SEEN, TAKEN, ZERO
from ropewalk.laws.clamps import bent_energy
from ropewalk.laws.couplings import any_fault
from ropewalk.laws.elastic import stored_energy
from ropewalk.laws.ledger import gravity_energy, kinetic_energy
from ropewalk.laws.nodes import node_energy, node_given, node_power
from ropewalk.laws.rare import has_bending

LARGEST = 1e154  # [m] the square of a longer one is infinite


@seldom
def energy_now(system, state):
    """Return the energy of all ropes [J], that of laws of nodes and of applied forces included."""
    total = kinetic_energy(state.v, state.mass)
    total += gravity_energy(state.x, state.mass, system.gravity)
    total += stored_energy(system, state, state.x, state.inner)
    if has_bending(system):
        total += bent_energy(system, state, state.x)
    x = state.x
    total += node_energy(system, state, x)
    if system.flags[APPLIED] == 1:
        force = state.forces.applied
        for i in range(x.shape[1]):
            total -= force[0, i] * x[0, i] + force[1, i] * x[1, i] + force[2, i] * x[2, i]
    return total


@kernel
def note_changes(system, state):
    """Count as given what the host has changed since the last call."""
    energy = energy_now(system, state)
    if energy != state.balance[LAST]:
        change = energy - state.balance[LAST]
        if change - change == 0.0:  # finite
            state.balance[ZERO] += change
            state.balance[HONEST] += abs(change)
        state.balance[LAST] = energy


@part
def gained(balance, energy):
    """Return what the ropes have more than at the start [J], with what a limiter has taken of it.

    What the limiter has put in, which it may not, is as much made up, even where friction has taken it since.
    """
    return max(energy - balance[ZERO] + max(balance[TAKEN], 0.0), -balance[TAKEN])


@part
def note_energy(system, state):
    """Keep the energy, so that what the host changes before the next call is known."""
    state.balance[LAST] = energy_now(system, state)


@kernel
def judge(system, state, time):
    """Return BROKEN or OK for the state at `time` [s]."""
    status = check_state(state, system.break_stretch)
    balance = state.balance
    balance[HONEST] += (time - balance[SEEN]) * node_power(system, state, state.x)
    balance[SEEN] = time
    energy, given = energy_now(system, state), node_given(system, state, state.x)
    for row in range(state.most.shape[0]):
        given += state.most[row]
    balance[LAST] = energy
    if not gained(balance, energy) <= MADE_UP * (balance[HONEST] + given):  # NaN is broken, too
        status = BROKEN
    if any_fault(system, state):
        status = BROKEN
    return status


@kernel
def check_state(state, break_stretch):
    """Return BROKEN when anything is not finite or a live segment is stretched beyond reason."""
    x0, x1, x2 = state.x[0], state.x[1], state.x[2]
    v0, v1, v2 = state.v[0], state.v[1], state.v[2]
    lengths, stiffness = state.rest_length, state.stiffness
    bad = 0
    for i in range(v0.shape[0]):
        speed = v0[i] + v1[i] + v2[i]
        bad += 0 if speed - speed == 0.0 else 1  # neither infinite nor NaN
    for j in range(lengths.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        length = lengths[j]
        live = length > 0.0 and stiffness[j] > 0.0
        longest = break_stretch * length if live else LARGEST
        square = dx * dx + dy * dy + dz * dz
        bad += 0 if square <= longest * longest and length - length == 0.0 else 1
    return OK if bad == 0 else BROKEN
