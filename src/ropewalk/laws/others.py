"""All laws but the springs', whose tension is an unknown of its own in the equations of rest."""

from __future__ import annotations

from ropewalk.core.blocks import ZERO9, store9
from ropewalk.core.jit import kernel
from ropewalk.laws.couplings import (
    add_couplings,
    meet_couplings,
    order_couplings,
    remember_couplings,
)
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


@kernel
def coupled_tangent(system, state, x, v, weight_x, weight_v, network):
    """Write -(weight_x dF/dx + weight_v dF/dv) of laws between nodes that are no neighbours.

    Return whether there was room for what they couple.
    """
    if not order_couplings(system, state, x, network):
        return False
    for p in range(network.diagonal.shape[0]):
        store9(network.diagonal, p, ZERO9)
    for b in range(network.start[network.diagonal.shape[0]]):
        store9(network.upper, b, ZERO9)
        store9(network.lower, b, ZERO9)
    add_couplings(system, state, x, v, weight_x, weight_v, network)
    return True


@kernel
def keep_couplings(system, state):
    """Let these laws keep what they carry at the state, as at the end of a step."""
    remember_couplings(system, state)


@kernel
def meet_others(system, state, x):
    """Tell whether a way from the state to places (3, n) may stand, see `couplings`."""
    return meet_couplings(system, state, x)
