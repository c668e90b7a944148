"""Steps that make up energy: found before they count.

Springs pressed to a point, which fly apart within a step, are not monotone: no Runge-Kutta or multistep
method bounds their energy, and L-stable ones were seen to multiply it by eight. What a step makes up is
known exactly,
    sum U(x1) - U(x0) - h f . (u0 + u1) / 2
over the segments, U the energy of stretch and bending, f the mean force that the step used and u the ends'
relative velocity; see `laws.ledger`. Clamps that turn stand where the step ends in both U, so that their
work does not count as made up. What a bound of the stretch gives does: it stops, and gives nothing; so does
what friction gives, as it may where a held node stops at once, friction is stiff and the step long. A step
that makes up a good part of all energy there is has no worth, where what all is carried along with does
not count. What rounding makes up of next to nothing does not either: a rope that coasts has no other energy.
With bending, where those may make up more, all laws together may make up little, see `all_energy`. Not
asked where clamps turn: what these put in by way of a step's own forces is off by more in long steps.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, part
from ropewalk.laws.clamps import bent_energy, clamps_turn
from ropewalk.laws.couplings import coupled_energy, coupled_work, couples
from ropewalk.laws.elastic import CHANGE, stored_energy
from ropewalk.laws.inner import gained_at_drums, heat
from ropewalk.laws.ledger import energy_past_anchors
from ropewalk.laws.rare import has_bending, has_inner, limits, parts, winds
from ropewalk.methods.all_energy import made_beside_segments, taken
from ropewalk.methods.rounding import EPSILON

# Of kinetic and stored energy, and of weight times length [1]: a whole step; twice as much each time that it
# is halved, as what is hard to solve must end somewhere; any part.
MOST, MOST_OF_ANY = 0.002, 0.05
MOST_IN_ALL = 0.001  # [1] the same of what all laws together make up, with bending; of any part


@part
def most_of(system, level, soft):
    """Return what a part of a step that was halved so often may make up [1]; with bending what any may.

    By implicit Euler, which is `soft`. By the method itself all parts together may no more than the whole.
    """
    if not soft:
        return (MOST_OF_ANY if has_bending(system) else MOST) / 2.0**level
    return MOST_OF_ANY if has_bending(system) else min(MOST * 2.0**level, MOST_OF_ANY)


@part
def makes_up_energy(system, state, stage, ends, mean, dt, most):
    """Tell whether a step from `state` to `stage` under the `mean` forces makes up more than `most` [1].

    `ends` are what segments remember at its end.
    """
    before = stored_energy(system, state, state.x, state.inner)
    after = stored_energy(system, state, stage.x, ends)
    work = taken(mean.elastic, state.v, stage.v, dt)
    rubbed = taken(mean.friction, state.v, stage.v, dt)
    if has_bending(system):
        before += bent_energy(system, state, state.x)
        after += bent_energy(system, state, stage.x)
        work += taken(mean.bending, state.v, stage.v, dt)
        if not (winds(system, state) or parts(system) or clamps_turn(system, state)):
            in_all = after - before - work - rubbed
            in_all += made_beside_segments(system, state, stage, mean, dt)
            if is_too_much(system, state, stage, before, after, in_all, MOST_IN_ALL, dt):
                return True
    if has_inner(system, state):
        work -= heat(system.elastic, state.stiffness, state.rest_length, ends[CHANGE], dt)
        if winds(system, state):
            work += gained_at_drums(system, state, stage.x, ends, dt)
    if limits(system):  # a bound may only take energy
        work += min(taken(mean.limiter, state.v, stage.v, dt), 0.0)
    if couples(system, state):  # what it stores; friction and impacts may only take
        held, holds = coupled_energy(system, state, state.x), coupled_energy(system, state, stage.x)
        given = holds - held + coupled_work(system, mean.node, state.v, stage.v, dt)
        work -= max(given, 0.0)
        before, after = before + held, after + held
    gain = after - before - work - min(rubbed, 0.0)
    return is_too_much(system, state, stage, before, after, gain, most, dt)


@part
def is_too_much(system, state, stage, before, after, gain, most, dt):
    """Tell whether a gain [J] is more than `most` [1] of the least there is of `before` and `after` [J]."""
    if gain <= most * before:
        return False
    mass, inverse_mass = state.mass, state.inverse_mass
    least = min(
        before + energy_past_anchors(state.v, mass, inverse_mass),
        after + energy_past_anchors(stage.v, mass, inverse_mass),
    )
    bound = most * (least + turned_over(system, state))
    return gain > bound and gain > bound + rounded(system, state, stage, dt) / most


@part
def rounded(system, state, stage, dt):
    """Return what rounding of places and ways, to d, stores in segments and bends [J]: sum k d^2.

    Of a segment stretched by s it makes up k s d, which is more than `most` of its energy, k s^2 / 2, by
    no more than k d^2 / (2 most), whatever s.
    """
    size, sums = 0.0, 0.0
    for i in range(stage.x.shape[1]):
        for k in range(3):
            size = max(size, abs(stage.x[k, i]) + dt * abs(stage.v[k, i]))
    for j in range(state.stiffness.shape[0]):
        sums += state.stiffness[j] if state.stiffness[j] < math.inf else 0.0
    if has_bending(system):
        for i in range(1, state.bending_stiffness.shape[0] - 1):
            length = min(state.rest_length[i - 1], state.rest_length[i])
            if state.bending_stiffness[i] > 0.0 and length > 0.0:
                sums += state.bending_stiffness[i] / (length * length)
    return sums * (16.0 * EPSILON * size) ** 2


@part
def turned_over(system, state):
    """Return what gravity can turn over [J]: weight times length of ropes that are bound together, summed."""
    mass, lengths, gravity = state.mass, state.rest_length, system.gravity
    table = system.node.contact
    if system.rare is None or table.rope.shape[0] == 0:  # all of these ropes are bound together
        return weight_times_length(mass, lengths, gravity)
    total = 0.0
    for r in range(table.lead.shape[0]):
        if table.lead[r] == r:
            total += weight_times_length_of(table.lead, table.rope, r, mass, lengths, gravity)
    return total


@kernel
def weight_times_length(mass, rest_length, gravity):
    """Return weight times length of all ropes [J]."""
    weight, length = 0.0, 0.0
    for i in range(mass.shape[0]):
        weight += mass[i]
    for j in range(rest_length.shape[0]):
        length += rest_length[j]
    x, y, z = gravity[0], gravity[1], gravity[2]
    return math.sqrt(x * x + y * y + z * z) * weight * length


@kernel
def weight_times_length_of(lead, rope, one, mass, rest_length, gravity):
    """Return the same of those ropes alone that `one` leads; `lead` and `rope` as `Pairs` has them."""
    weight, length = 0.0, 0.0
    for i in range(mass.shape[0]):
        own = i < rope.shape[0] and rope[i] >= 0  # else it is the last node of a rope
        if lead[rope[i] if own else rope[i - 1]] == one:
            weight += mass[i]
    for j in range(rest_length.shape[0]):
        if rope[j] >= 0 and lead[rope[j]] == one:
            length += rest_length[j]
    x, y, z = gravity[0], gravity[1], gravity[2]
    return math.sqrt(x * x + y * y + z * z) * weight * length
