"""The ledger: the work of every law, exact in discrete time.

Over one step a node's velocity goes from v0 to v1 = v0 + h F / m, F the method's (mean) force. Then
    m (v1^2 - v0^2) / 2 = h F . (v0 + v1) / 2
without any error, for every method, so the work of a law is h F_law . (v0 + v1) / 2, and the kinetic
energy balance closes to round-off. What the potentials gain or lose beyond that is the method's own error.
The sums run per segment and per node, so that the loops vectorise and the sums stay accurate.
"""

from __future__ import annotations

from ropewalk.core.arrays import APPLIED
from ropewalk.core.jit import apart, deferred, kernel, part, seldom
from ropewalk.core.ranges import ALL, rows
from ropewalk.laws.booking import book_nodes
from ropewalk.laws.fresh import working_segment
from ropewalk.laws.nodes import on_channels
from ropewalk.laws.rare import has_bending, limits


@kernel
def add_power(force, middle, dt, work, lo, hi):
    """Add force . velocity * dt of every node [J] to `work` (n,)."""
    f0, f1, f2 = rows(force, lo, hi)
    u0, u1, u2 = rows(middle, lo, hi)
    work = work[lo:hi]
    for i in range(work.shape[0]):
        work[i] += dt * (f0[i] * u0[i] + f1[i] * u1[i] + f2[i] * u2[i])


@part
def _account(force, work, middle, dt, lo, hi):
    add_power(force, middle, dt, work, lo, hi)


_account_nodes = on_channels(_account)


@part
def account(system, state, forces, middle, dt, lo=0, hi=ALL):
    """Add one step's work of every law; `middle` is (v0 + v1) / 2 of each node [m/s], (3, n).

    For nodes `lo` to `hi - 1` and the segments that end there.
    """
    work = state.work
    begin, end = max(lo - 1, 0), min(hi, state.mass.shape[0]) - 1
    done = work.elastic, work.friction
    add_spring_power(forces.elastic, forces.friction, middle, dt, *done, begin, end)
    add_weight_power(state.mass, system.gravity, middle, dt, work.weight, lo, hi)
    if has_bending(system):
        add_segment_power(forces.bending, middle, dt, work.bending, begin, end)
    if limits(system):
        work.limiter[0] -= segment_power(forces.limiter, middle, dt)
    if system.flags[APPLIED] == 1:
        add_power(forces.applied, middle, dt, work.applied, lo, hi)
    _account_nodes(system, forces.node, work.node, middle, dt, lo, hi)
    book_nodes(system, state, forces, middle, dt)


@apart
def add_spring_power(elastic, friction, middle, dt, elastic_work, friction_work, lo, hi):
    """As `add_segment_power`, for both forces of a spring in one sweep."""
    e0, e1, e2 = rows(elastic, lo, hi + 1)
    c0, c1, c2 = rows(friction, lo, hi + 1)
    u0, u1, u2 = rows(middle, lo, hi + 1)
    elastic_work, friction_work = elastic_work[lo:hi], friction_work[lo:hi]
    for j in range(elastic_work.shape[0]):
        dx, dy, dz = u0[j + 1] - u0[j], u1[j + 1] - u1[j], u2[j + 1] - u2[j]
        elastic_work[j] -= dt * (e0[j + 1] * dx + e1[j + 1] * dy + e2[j + 1] * dz)
        friction_work[j] -= dt * (c0[j + 1] * dx + c1[j + 1] * dy + c2[j + 1] * dz)


@kernel
def add_segment_power(force, middle, dt, work, lo=0, hi=ALL):
    """Add the work of forces between neighbours [J] to `work` (s,); `force` is (3, n + 1)."""
    f0, f1, f2 = rows(force, lo, hi + 1)
    u0, u1, u2 = rows(middle, lo, hi + 1)
    work = work[lo:hi]
    for j in range(work.shape[0]):
        work[j] -= dt * (
            f0[j + 1] * (u0[j + 1] - u0[j])
            + f1[j + 1] * (u1[j + 1] - u1[j])
            + f2[j + 1] * (u2[j + 1] - u2[j])
        )


@deferred()
def book_growth(system, state, friction, dt, lo=0, hi=ALL):
    """Give the winches what the friction of their working segments, (3, n + 1), does as rope is wound.

    Friction follows r' - r L'/L, see `growth_friction`: by that it takes, and only takes; of the power
    along r' the rest, f r L'/L, is the drum's. For segments that end at nodes `lo` to `hi - 1`. Without a
    ledger, too: the verdict knows by it what winches have given.
    """
    x, L = state.x, state.rest_length
    for row in range(state.winch_exit.shape[0]):
        j = working_segment(system.winches, state.winch_exit, row)
        if lo <= j + 1 < hi and L[j] > 0.0:  # not parted
            pull = 0.0
            for k in range(3):
                pull += friction[k, j + 1] * (x[k, j + 1] - x[k, j])
            wound = dt * state.winch_rate[row] / L[j] * pull
            state.work.friction[j] += wound
            state.work.winch[0] -= wound


@kernel
def segment_power(force, middle, dt):
    """Return the work that forces between neighbours take up, (3, n + 1) [J]."""
    total = 0.0
    for k in range(3):
        f, u = force[k], middle[k]
        for j in range(u.shape[0] - 1):
            total += f[j + 1] * (u[j + 1] - u[j])
    return dt * total


@kernel
def add_weight_power(mass, gravity, middle, dt, work, lo, hi):
    """Add the work of weight [J] to `work` (n,)."""
    gx, gy, gz = dt * gravity[0], dt * gravity[1], dt * gravity[2]
    u0, u1, u2 = rows(middle, lo, hi)
    mass, work = mass[lo:hi], work[lo:hi]
    for i in range(work.shape[0]):
        work[i] += mass[i] * (gx * u0[i] + gy * u1[i] + gz * u2[i])


@kernel
def kinetic_energy(v, mass):
    """Return the kinetic energy of all nodes [J], held ones included."""
    total = 0.0
    for i in range(mass.shape[0]):
        total += 0.5 * mass[i] * (v[0, i] * v[0, i] + v[1, i] * v[1, i] + v[2, i] * v[2, i])
    return total


@kernel
def energy_past_anchors(v, mass, inverse_mass):
    """Return the kinetic energy of the free nodes past the held ones, or past their mean where none is [J].

    What is carried along as a whole hides nothing that happens within it.
    """
    held = 0
    for i in range(mass.shape[0]):
        held += 1 if inverse_mass[i] == 0.0 else 0
    energy = 0.0
    for k in range(3):
        weight, momentum, square = 0.0, 0.0, 0.0
        for i in range(mass.shape[0]):
            share = mass[i] if held == 0 else 1.0 if inverse_mass[i] == 0.0 else 0.0
            weight += share
            momentum += share * v[k, i]
        for i in range(mass.shape[0]):
            if inverse_mass[i] > 0.0:
                square += mass[i] * (v[k, i] - momentum / weight) ** 2
        energy += 0.5 * square
    return energy


@seldom
def gravity_energy(x, mass, gravity):
    """Return the potential energy of weight [J], zero at the origin."""
    total = 0.0
    for i in range(mass.shape[0]):
        total -= mass[i] * (gravity[0] * x[0, i] + gravity[1] * x[1, i] + gravity[2] * x[2, i])
    return total


@kernel
def wound_energy(system, state):
    """Return the potential energy of the weight of rope that has gone on to drums since the start [J].

    It counts where its drum is, zero at the origin; negative of rope that drums have paid out. With it rope
    keeps its energy as it passes a drum, which `gravity_energy` of what is out does not.
    """
    total = 0.0
    for row in range(state.winch_exit.shape[0]):
        drum = state.winch_exit[row]
        high = 0.0
        for k in range(3):
            high -= system.gravity[k] * state.x[k, drum]
        total -= system.winches.line[row] * state.winch_paid[row] * high
    return total
