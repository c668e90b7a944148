"""Mean forces over the stages of a step, from which anchors have their reactions and laws their work."""

from __future__ import annotations

from ropewalk.core.arrays import APPLIED
from ropewalk.core.jit import kernel, part
from ropewalk.methods.scratch import add_forces, begin_forces


@part
def begin_mean(system, state, weight, mean, ledger):
    """Write `weight` times the forces of a step's first stage to `mean`."""
    if ledger or system.rare is not None:
        begin_forces(system, state.forces, weight, mean)
    else:
        _share_at_anchors(system, state, weight, mean, True)


@part
def add_to_mean(system, state, weight, mean, ledger):
    """Add `weight` times the forces of another stage to `mean`."""
    if ledger or system.rare is not None:
        add_forces(system, state.forces, weight, mean)
    else:
        _share_at_anchors(system, state, weight, mean, False)


@part
def _share_at_anchors(system, state, weight, mean, first):
    """Write or add a share at the nodes of anchors alone: without a ledger no others are asked for."""
    order, nodes, forces = system.anchors.order, state.anchor_node, state.forces
    share_beside(order, nodes, forces.elastic, weight, first, mean.elastic)
    share_beside(order, nodes, forces.friction, weight, first, mean.friction)
    if system.flags[APPLIED] == 1:
        share_at(order, nodes, forces.applied, weight, first, mean.applied)
    elif first:
        share_at(order, nodes, forces.applied, 0.0, True, mean.applied)


@kernel
def share_beside(order, nodes, force, weight, first, mean):
    """Write (`first`) or add weight * force of the segments at `nodes`, which `order` sorts, (3, n + 1)."""
    done = -1
    for index in range(order.shape[0]):
        i = nodes[order[index]]
        for j in range(max(i, done + 1), i + 2):
            for k in range(3):
                before = 0.0 if first else mean[k, j]
                mean[k, j] = before + weight * force[k, j]
        done = i + 1


@kernel
def share_at(order, nodes, force, weight, first, mean):
    """As `share_beside`, of forces on nodes, (3, n)."""
    done = -1
    for index in range(order.shape[0]):
        i = nodes[order[index]]
        for k in range(3 if i > done else 0):
            before = 0.0 if first else mean[k, i]
            mean[k, i] = before + weight * force[k, i]
        done = i
