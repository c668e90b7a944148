"""What the host asks of the laws of nodes: which act, what they do at rest, what flows about the ropes."""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats, System
from ropewalk.laws.node_law import NodeLaw, Rest
from ropewalk.laws.registry import NODE_LAWS, NodeTables


def acting(system: System) -> list[tuple[NodeLaw, Any]]:
    """Return the laws that act, with their tables."""
    return [
        (law, table) for law, table in zip(NODE_LAWS, system.node, strict=True) if law.acts(table)
    ]


def section_of(law: NodeLaw, scene: Any) -> Any:
    """Return what a scene says of a law; of one of ropes what each says, None where none does."""
    if not law.of_ropes:
        return getattr(scene, law.section, None)
    told = tuple(getattr(rope, law.section, None) for rope in scene.ropes)
    return told if any(one is not None for one in told) else None


def relaxed(system: System) -> System:
    """Return the system with laws that remember as they are when nothing has moved for long."""
    tables = [
        table if law.relaxed is None else law.relaxed(table)
        for law, table in zip(NODE_LAWS, system.node, strict=True)
    ]
    if all(one is other for one, other in zip(tables, system.node, strict=True)):
        return system
    acts = [law.acts(table) for law, table in zip(NODE_LAWS, tables, strict=True)]
    return system._replace(node=NodeTables(*tables), acts=np.array(acts, np.int64))


def at_rest(system: System) -> set[Rest]:
    """Return what the laws that act do to nodes at rest; NOTHING is left out.

    Of one that does not say the worst is thought: that it holds every node somewhere.
    """
    found = {
        Rest.HOLDS if law.at_rest is None else law.at_rest(table) for law, table in acting(system)
    }
    return found - {Rest.NOTHING}


def borne(system: System, x: Floats) -> Any:
    """Return which nodes at places (3, n) [m] lie on something that bears them, (n,)."""
    found = np.zeros(x.shape[1], dtype=bool)
    for law, table in acting(system):
        if law.bears is not None:
            found |= law.bears(table, x)
    return found


def flow(system: System) -> Floats:
    """Return the velocity of what flows about the ropes [m/s], (3,)."""
    found = np.zeros(3)
    for law, table in zip(NODE_LAWS, system.node, strict=True):
        if law.flow is not None:
            found = found + law.flow(table)
    return found
