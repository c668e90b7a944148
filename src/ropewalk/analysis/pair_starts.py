"""What `check` says of ropes that are drawn pressed into each other: contacts throw them apart.

Drawn more than a tenth inside each other they are refused, see `lowering.contact_checks`. What is no deeper
than the skin of a contact is braked there (5 mm/s of ropes of 10 mm), and what is less than a tenth may be a
contact that carries: then it presses with no more than the ropes weigh, or pull each other by.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk.laws.pairs.distance import nearest
from ropewalk.laws.pairs.force import squeeze
from ropewalk.laws.pairs.table import LAYER, NEAR
from ropewalk.lowering import Model

_squeeze = getattr(squeeze, "py_func", squeeze)


class _Deep(NamedTuple):
    """Two segments that start pressed into each other; the most is thrown apart fastest."""

    speed: float  # with which that is at most: dampers take some nine tenths of it [m/s]
    depth: float  # [m]
    pair: tuple[int, int]


def pair_start_warnings(model: Model) -> list[str]:
    """Return a sentence for the two segments that a contact throws apart fastest as the run starts."""
    scene, layout = model.scene, model.layout
    if scene.contact is None or scene.run.start == "at-rest":
        return []
    found = _deepest(model)
    if found is None:
        return []
    (one, a), (other, b) = (layout.rope_of(k) for k in found.pair)
    size = float(model.system.node.contact.radius[list(found.pair)].sum())
    return [
        f"rope[{scene.rope_index(other)}].shape: segment {b} - it starts {1e3 * found.depth:.3g} mm inside "
        f"segment {a} of rope {one!r}, half of both diameters counted in, which nothing presses so far: the "
        f"contact throws them apart, with up to {found.speed:.2g} m/s were it not damped; draw their middles "
        f"{1e3 * size:.4g} mm apart"
    ]


def _deepest(model: Model) -> _Deep | None:
    """Return the pair that is thrown apart fastest; None where all press with what may be carried."""
    state, table = model.state, model.system.node.contact
    memory, worst = state.memory.contact, None
    carried = _carried(model)
    for i, j in memory.near[: memory.tally[NEAR]].tolist():
        size = float(table.radius[i] + table.radius[j])
        s, t, distance = nearest(state.x, state.x, 0.0, i, j)
        depth = size - distance
        if not depth > LAYER * size:
            continue
        springs = (1.0 / float(one[i] + one[j]) for one in (table.soft, table.hard, table.stop))
        push, _, stored = _squeeze(depth, *springs, LAYER * size)
        shares = np.array([1.0 - s, s, 1.0 - t, t])
        moves = float((shares**2 * state.inverse_mass[[i, i + 1, j, j + 1]]).sum())
        here = _Deep(math.sqrt(2.0 * stored * moves), depth, (i, j))
        if push > carried and (worst is None or here > worst):
            worst = here
    return worst


def _carried(model: Model) -> float:
    """Return what may press ropes together: all their weight, and twice the largest pull at the start [N]."""
    state = model.state
    weight = float(state.mass.sum() * np.linalg.norm(model.system.gravity))
    size = np.linalg.norm(np.diff(state.x, axis=1), axis=0)
    stiff = np.where(np.isfinite(state.stiffness), state.stiffness, 0.0)
    pull = stiff * np.maximum(size - state.rest_length, 0.0)
    return weight + 2.0 * float(pull.max(initial=0.0))
