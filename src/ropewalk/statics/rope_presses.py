"""What ropes press on the nodes of others, and on their own, at rest."""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.pairs.table import CONTACTS, OTHER, OWN, PUSH
from ropewalk.lowering import Model


def presses_of_ropes(model: Model, memory: Any) -> Floats:
    """Return the sum of the normal forces of ropes on every node, (n,) [N]; `memory` is `State.memory`.

    That of a contact goes to both nodes of each of its segments, as it lies between them.
    """
    found = np.zeros(model.layout.nodes)
    if model.scene.contact is None:
        return found
    contact = memory.contact
    count = int(contact.tally[CONTACTS])
    pair, grip = contact.pair[:count], contact.grip[:count]
    push = np.maximum(grip[:, PUSH], 0.0)
    for segments, at in zip(pair[:, :2].T, (grip[:, OWN], grip[:, OTHER]), strict=True):
        np.add.at(found, segments, (1.0 - at) * push)
        np.add.at(found, segments + 1, at * push)
    return found
