"""Which ropes of a scene make up an island."""

from __future__ import annotations

import numpy as np

from ropewalk.engine.meeting_boxes import boxes_at, joined, meeting
from ropewalk.engine.wheel_reach import boxes_of_wheels, homes_of, reached, reaches_at
from ropewalk.laws.pairs.swept import FROM
from ropewalk.lowering import Model
from ropewalk.methods.registry import METHODS
from ropewalk.motions.rows import own_jumps
from ropewalk.scene.joint import tied_ropes

#: Of more ropes than these the calls of their kernels would show in the time of a run.
MOST_APART = 64


def partition(model: Model, apart: bool = False) -> list[list[int]]:
    """Return the ropes of every island, by their numbers.

    Where ropes can touch each other those are one that are within reach where the model stands, and so are
    those within reach of a wheel; very many of an explicit method are all one, at no cost but that they
    break together.
    With `apart` ropes of an explicit method have islands of their own, too, unless they are very many.
    """
    method, count = METHODS[model.plan.method], len(model.scene.ropes)
    tied = tied_ropes(model.scene.ropes, model.scene.joints, model.scene.slides)
    explicit, touching = method.fixed and not method.implicit, model.scene.contact is not None
    wheels = model.system.node.obstacle.inertia.size > 0  # ropes on one turn it together
    if touching or wheels:
        if explicit and (count > MOST_APART or not touching):
            return [list(range(count))]
        return within_reach(model, tied)
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


def within_reach(model: Model, tied: list[list[int]]) -> list[list[int]]:
    """Return groups of ropes of which none is within reach of another's contacts, or of a wheel of its own.

    Of those that are tied.
    """
    boxes, owners = reaches_at(model)
    wheels = boxes_of_wheels(model.system.node.obstacle)
    of = [boxes[np.isin(owners, ropes)] for ropes in tied]
    met = reached(wheels, homes_of(model), tied, of)
    if model.scene.contact is not None:
        table, swept = model.system.node.contact, model.state.memory.contact.swept
        rope = table.rope[swept[:, FROM].astype(np.int64)]
        group = np.zeros(len(model.scene.ropes), np.int64)
        for k, ropes in enumerate(tied):
            group[ropes] = k
        met |= meeting(boxes_at(model.system, model.state), group[rope])
    return [list(ropes) for ropes in joined([tuple(ropes) for ropes in tied], met)]
