"""All laws but the springs', whose tension is an unknown of its own in the equations of rest."""

from __future__ import annotations

from ropewalk.core.jit import kernel
from ropewalk.laws.table import evaluate, force_on_node
from ropewalk.laws.tangent import add_tangents, begin_tangent, mark


@kernel
def other_forces(system, state, x, v, forces, total):
    """Write the force of all laws but the springs' on every node [N], weight included, (3, n)."""
    evaluate(system, state, x, v, forces)
    elastic = forces.elastic
    for k in range(3):
        for j in range(elastic.shape[1]):
            elastic[k, j] = 0.0
    for i in range(x.shape[1]):
        for k in range(3):
            total[k, i] = force_on_node(system, state, forces, i, k)


@kernel
def other_stiffness(system, state, x, v, band):
    """Write -dF/dx of all laws but the springs' [N/m]."""
    mark(system, state, x, band)
    begin_tangent(system, state, x, v, 1.0, 0.0, False, band)
    add_tangents(system, state, x, v, 1.0, 0.0, band)
