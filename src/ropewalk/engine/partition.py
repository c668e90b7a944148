"""Which ropes of a scene make up an island."""

from __future__ import annotations

import numpy as np

from ropewalk.lowering import Model
from ropewalk.methods.registry import METHODS
from ropewalk.motions.rows import own_jumps
from ropewalk.scene.joint import tied_ropes

#: Of more ropes than these the calls of their kernels would show in the time of a run.
MOST_APART = 64


def partition(model: Model, apart: bool = False) -> list[list[int]]:
    """Return the ropes of every island, by their numbers.

    With `apart` ropes of an explicit method have islands of their own, too, unless they are very many.
    """
    method, count = METHODS[model.plan.method], len(model.scene.ropes)
    wheels = model.system.node.obstacle.inertia.size > 0  # ropes on one turn it together
    if model.scene.contact is not None or model.scene.slides or wheels:
        return [list(range(count))]
    tied = tied_ropes(model.scene.ropes, model.scene.joints)
    if method.implicit or not method.fixed or (apart and count <= MOST_APART):
        return tied
    single = {winch.rope for winch in model.scene.winches}
    single |= {rope.name for rope in model.scene.ropes if rope.made_of.parts}
    anchors, bending = model.system.anchors, model.system.bending
    for row, anchor in enumerate(model.scene.anchors):
        times = [anchors.release[row], *own_jumps(anchors, row)]
        if len(bending.turn):
            times += list(bending.turn[row, 1:])
        if any(0.0 < time < np.inf for time in times):
            single.add(anchor.rope)
    names = [rope.name for rope in model.scene.ropes]
    alone = [group for group in tied if any(names[i] in single for i in group)]
    others = {i for group in alone for i in group}
    together = [i for i in range(count) if i not in others]
    return ([together] if together else []) + alone
