"""What a step makes up beside stretch and bends, whatever law has it.

By law chords that are taken for arcs count, which others take: what slides over a bar is pushed off by it and
has its segments shortened, by the same amount. So does what is stopped: works at mean speeds give to one law
what another one takes. The sum over all is what energy has risen by, less what anchors put in. Of a law that
may honestly give (a wind, a body that moves) only what it takes is known.
"""

from __future__ import annotations

from typing import Any

from ropewalk.core.arrays import APPLIED
from ropewalk.core.jit import deferred, kernel, part
from ropewalk.laws.couplings import work_on_nodes
from ropewalk.laws.node_law import NodeLaw
from ropewalk.laws.nodes import fold
from ropewalk.laws.rare import acts, limits


@part
def _nothing_made(system, state, forces, x1, v1, dt):
    return 0.0


def _making(law: NodeLaw, k: int, rest: Any) -> Any:
    energy, still = law.energy, law.still
    gives = law.power is not None or law.given is not None

    @part
    def _made(system, state, forces, x1, v1, dt):
        total = rest(system, state, forces, x1, v1, dt)
        if acts(system, k):
            table = system.node[k]
            own = work_on_nodes(forces[k], state.v, v1, dt)
            if energy is not None:
                own += energy(table, state, x1) - energy(table, state, state.x)
            if gives and (still is None or not still(table)):
                own = min(own, 0.0)
            total += own
        return total

    return _made


_made_by_nodes = fold(_making, _nothing_made)


@deferred("float64")
def made_beside_segments(system, state, stage, mean, dt):
    """Return what a step from `state` to `stage` under the `mean` forces makes up beside segments [J].

    Negative where impacts, friction on bodies and the method itself take more.
    """
    x0, v0, x1, v1, free = state.x, state.v, stage.x, stage.v, state.inverse_mass
    gain = made_by_weight(state.mass, free, system.gravity, x0, v0, x1, v1, dt)
    if limits(system):
        gain -= taken(mean.limiter, v0, v1, dt)
    if system.flags[APPLIED] == 1:
        gain += made_by_loads(state.forces.applied, free, x0, v0, x1, v1, dt)
    gain += _made_by_nodes(system, state, mean.node, x1, v1, dt)
    for force in (mean.elastic, mean.friction, mean.bending):
        gain += made_at_anchors(force, free, x0, v0, x1, v1, dt)
    return gain


@kernel
def made_at_anchors(force, inverse_mass, x0, v0, x1, v1, dt):
    """Return what segment forces do on held nodes over their way beyond that at mean speeds [J]."""
    total = 0.0
    for k in range(3):
        f, a, u, b, w = force[k], x0[k], v0[k], x1[k], v1[k]
        for i in range(inverse_mass.shape[0]):
            if inverse_mass[i] == 0.0:
                total += (f[i + 1] - f[i]) * (b[i] - a[i] - 0.5 * dt * (u[i] + w[i]))
    return total


@kernel
def taken(force, v0, v1, dt):
    """Return the work that segment forces (3, n + 1) take up in a step [J], minus that on the nodes."""
    total = 0.0
    for k in range(3):
        f, a, b = force[k], v0[k], v1[k]
        for j in range(f.shape[0] - 2):
            total += f[j + 1] * (a[j + 1] - a[j] + b[j + 1] - b[j])
    return 0.5 * dt * total


@kernel
def made_by_weight(mass, inverse_mass, gravity, x0, v0, x1, v1, dt):
    """Return what weight does to free nodes at mean speeds beyond what it does over their way [J]."""
    total = 0.0
    for k in range(3):
        a, u, b, w = x0[k], v0[k], x1[k], v1[k]
        for i in range(mass.shape[0]):
            more = mass[i] * gravity[k] * (0.5 * dt * (u[i] + w[i]) - (b[i] - a[i]))
            total += more if inverse_mass[i] > 0.0 else 0.0
    return total


@kernel
def made_by_loads(force, inverse_mass, x0, v0, x1, v1, dt):
    """Return the same of constant forces on nodes, (3, n) [J]."""
    total = 0.0
    for k in range(3):
        a, u, b, w = x0[k], v0[k], x1[k], v1[k]
        for i in range(inverse_mass.shape[0]):
            more = force[k, i] * (0.5 * dt * (u[i] + w[i]) - (b[i] - a[i]))
            total += more if inverse_mass[i] > 0.0 else 0.0
    return total
