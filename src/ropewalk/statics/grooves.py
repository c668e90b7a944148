"""Nodes at rest on several surfaces, as in a groove, seen as on one that carries what they carry together.

How a rope came to lie in a groove decides what friction does across it: it may wedge the rope, and each side
then carries all it can though the rope is far from sliding along. What slides along has none of it across.
"""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.lowering.touching import Contacts
from ropewalk.lowering.wedging import pressing


def as_of_one(contacts: Contacts, force: Floats) -> Contacts:
    """Return the contacts with the same surface in place of those that a node touches, where it does several.

    `force` (3, n) [N] is that of all obstacles on every node. As much of it as they can is carried by the
    surfaces' normal forces R_i; the rest is what friction has to carry, at most sum(mu_i R_i). So that a
    groove whose sides are at an angle beta to its bottom holds as one surface of mu / cos(beta) does.
    """
    normal, push, rub = contacts.normal.copy(), contacts.push.copy(), contacts.rub.copy()
    cone, off, aside = contacts.cone.copy(), contacts.off.copy(), contacts.aside.copy()
    friction = contacts.friction.copy()
    for node in np.flatnonzero(np.bincount(contacts.node) > 1):
        rows = np.flatnonzero(contacts.node == node)
        pushes = pressing(contacts.normal[rows], force[:, node])
        whole = pushes @ contacts.normal[rows]
        size = float(np.linalg.norm(whole))
        if not size > 0.0:
            continue
        normal[rows], push[rows], rub[rows] = whole / size, size, force[:, node] - whole
        friction[rows] = cone[rows] = pushes @ contacts.friction[rows] / size
        off[rows] = aside[rows] = 0.0
    return contacts._replace(
        normal=normal, push=push, rub=rub, cone=cone, off=off, aside=aside, friction=friction
    )


def beside(contacts: Contacts, rows: Ints) -> list[int]:
    """Return which other obstacles the nodes of some rows touch, by number."""
    also = np.isin(contacts.node, contacts.node[rows])
    return sorted(set(contacts.obstacle[also].tolist()) - set(contacts.obstacle[rows].tolist()))
