"""Elastic laws as tables for the kernels, and what they give at rest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from ropewalk.core.arrays import Elastic, Floats, State, System
from ropewalk.laws.elastic import NOW, rest_pulls, rest_strains, slopes
from ropewalk.laws.registry import ELASTIC_LAWS, ElasticTables
from ropewalk.lowering.layout import Layout
from ropewalk.scene import Rope

Said = tuple[tuple[Any, ...], ...]  # what each rope says of each law, None: nothing


def said_by(ropes: Sequence[Rope]) -> Said:
    """Return what each rope says of each law."""
    return tuple(tuple(law.says(rope) for rope in ropes) for law in ELASTIC_LAWS)


def elastic_tables(layout: Layout, said: Said) -> Elastic:
    """Return the tables of the laws of all ropes; on a drum, too."""
    of = np.full(layout.segments, -1, np.int64)
    tables = [law.lower(one, layout) for law, one in zip(ELASTIC_LAWS, said, strict=True)]
    for k, one in enumerate(said):
        for word, span in zip(one, layout.ropes, strict=True):
            if word is not None:
                of[span.first : span.last] = k
    any_law = bool((of >= 0).any())
    time = np.full(len(of) * any_law, math.inf)
    for k, (law, table) in enumerate(zip(ELASTIC_LAWS, tables, strict=True)):
        mine = np.flatnonzero(of == k)
        if mine.size and law.time is not None:
            time[mine] = law.time(table)[mine]
    return Elastic(of, time, ElasticTables(*tables))


def remembers(elastic: Elastic) -> bool:
    """Tell whether the law of any segment has a memory."""
    return bool(np.isfinite(elastic.time).any())


def let_relax(system: System, state: State) -> None:
    """Bring what segments remember to rest in the state's places: where the rope has long been."""
    if not state.inner.shape[1]:
        return
    state.inner[...] = 0.0
    mine = np.isfinite(system.elastic.time) & (state.stiffness > 0.0)
    stretch = np.sqrt((np.diff(state.x, axis=1) ** 2).sum(axis=0)) - state.rest_length
    strain = stretch[mine] / state.rest_length[mine]
    slack = system.slack_floor[mine] == 0.0
    state.inner[NOW, mine] = np.where(slack, np.maximum(strain, 0.0), strain)


def stored_at_rest(system: System, state: State, tension: Floats) -> float:
    """Return the elastic energy of all segments under tensions at rest [J], (s,) [N]."""
    k = state.stiffness
    stored = np.divide(tension**2, 2.0 * k, out=np.zeros_like(k), where=k > 0.0)
    if system.elastic.time.size:
        stretch, soft, pull = (np.zeros_like(tension) for _ in range(3))
        put_under_tension(system, state, tension, stretch, soft)
        rest_pulls(system.elastic, state.rest_length, k, stretch, pull, stored)
    return float(stored.sum())


def put_under_tension(
    system: System, state: State, tension: Floats, stretch: Floats, soft: Floats
) -> None:
    """Write stretch [m] and compliance [m/N] of segments with a law under tensions [N], (s,) each."""
    if system.elastic.time.size:
        lengths, k = state.rest_length, state.stiffness
        rest_strains(system.elastic, lengths, k, np.asarray(tension, float), stretch, soft)


def put_tension(system: System, state: State, stretch: Floats, tension: Floats) -> None:
    """Write the tension [N] of segments with a law at stretches [m], (s,) each, pressed ones too."""
    if system.elastic.time.size:
        lengths, k, stored = state.rest_length, state.stiffness, np.zeros_like(tension)
        rest_pulls(system.elastic, lengths, k, stretch, tension, stored)


def slopes_at_rest(system: System, state: State, strain: Floats) -> tuple[Floats, Floats]:
    """Return how the tension rises with the length [N/m], (s,): slowly, and at once; at strains [1], (s,)."""
    slow, fast = state.stiffness.copy(), state.stiffness.copy()
    if system.elastic.time.size:
        slopes(system.elastic, state.stiffness, strain, slow, fast)
    return slow, fast


def softest(elastic: Elastic, stiffness: Floats) -> Floats:
    """Return the least slope of every segment's tension by its length [N/m], (s,), from the largest."""
    found = stiffness
    for k, (law, table) in enumerate(zip(ELASTIC_LAWS, elastic.table, strict=True)):
        if (elastic.of == k).any():
            found = np.where(elastic.of == k, law.least(table) * stiffness, found)
    return found
