"""What laws of nodes remember, and the rows that their forces have, where a state stands."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import State, System
from ropewalk.laws.registry import NODE_LAWS, NodeArrays


def with_memory(system: System, state: State) -> State:
    """Return the state with what laws of nodes remember where it stands: nothing has moved yet."""
    held = (state.inverse_mass == 0.0).astype(np.int64)
    laws, n = list(zip(NODE_LAWS, system.node, strict=True)), state.x.shape[1]
    rows = [3 if law.channels is None else law.channels(table) for law, table in laws]
    if rows == [len(force) for force in state.forces.node]:
        forces = state.forces
    else:
        forces = state.forces._replace(node=NodeArrays(*(np.zeros((k, n)) for k in rows)))
    return state._replace(
        memory=NodeArrays(
            *(
                np.zeros(0)
                if law.memory is None
                else law.memory(table, state.x, state.stiffness, held)
                for law, table in laws
            )
        ),
        forces=forces,
    )
