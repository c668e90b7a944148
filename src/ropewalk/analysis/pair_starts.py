"""What `check` says of ropes that are drawn pressed into each other: contacts throw them apart.

Drawn more than a tenth inside each other they are refused, see `lowering.contact_checks`. What is no deeper
than the skin of a contact is braked there (5 mm/s of ropes of 10 mm), and what is less than a tenth may be a
contact that carries: then it presses with no more than the ropes in its heap weigh, or pull each other by.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
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
    carried, rope = _carried(model), table.rope
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
        if push > carried[rope[i]] and (worst is None or here > worst):
            worst = here
    return worst


def _carried(model: Model) -> Floats:
    """Return what may press the ropes of each one's heap together, (ropes,) [N].

    Their weight, and twice their largest pull. In a heap are ropes that touch as the run starts, and those
    bound to them: what hangs elsewhere presses nothing there.
    """
    state, layout = model.state, model.layout
    heap = _heaps(model)
    weight = state.mass * np.linalg.norm(model.system.gravity)
    size = np.linalg.norm(np.diff(state.x, axis=1), axis=0)
    stiff = np.where(np.isfinite(state.stiffness), state.stiffness, 0.0)
    pull = stiff * np.maximum(size - state.rest_length, 0.0)
    own, most = np.zeros(heap.size), np.zeros(heap.size)
    for lead, span in zip(heap, layout.ropes, strict=True):
        own[lead] += weight[span.first : span.last + 1].sum()
        most[lead] = max(most[lead], pull[span.first : span.last].max(initial=0.0))
    return (own + 2.0 * most)[heap]


def _heaps(model: Model) -> Ints:
    """Return for every rope one that stands for all that touch or are bound to each other, (ropes,)."""
    table, memory, x = model.system.node.contact, model.state.memory.contact, model.state.x
    heap: Ints = table.lead.copy()
    for i, j in memory.near[: memory.tally[NEAR]].tolist():
        one, other = heap[table.rope[[i, j]]]
        if one != other and nearest(x, x, 0.0, i, j)[2] < table.radius[i] + table.radius[j]:
            heap[heap == max(one, other)] = min(one, other)
    return heap
