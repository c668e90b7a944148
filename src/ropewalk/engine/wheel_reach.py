"""Obstacles that turn freely, wheels, among islands: whose they are, and who comes within reach of them.

A wheel belongs to its home, the rope that is nearest where the model is drawn, and to the island of that.
Nobody else has it among his obstacles. Where ropes of another island come within its box that one becomes
one with the wheel's, as those of `engine.meetings` that meet. A wheel that moves, or is not round, is within
reach of all.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State, copy
from ropewalk.laws.contact import remember_contacts
from ropewalk.laws.contact_books import GAP
from ropewalk.laws.obstacle_places import moves, reach_of
from ropewalk.laws.obstacle_shapes import CAPSULE, CYLINDER, SPHERE, TORUS
from ropewalk.laws.pairs.swept import (
    AHEAD,
    FROM,
    HELD_HIGH,
    HELD_LOW,
    HIGH,
    LOW,
    place_held,
    runs_of,
    with_held,
)
from ropewalk.laws.pairs.table import REACH
from ropewalk.lowering import Model

ROUND = (SPHERE, CYLINDER, CAPSULE, TORUS)


def boxes_of_wheels(table: Any) -> Floats:
    """Return boxes (w, 6) [m] of wheels; without ends for those whose surface moves: it may come fast."""
    found = np.zeros((len(table.inertia), 6))
    for row in np.flatnonzero(table.wheel >= 0):
        wide = _extent(table, int(row))
        box = np.concatenate([table.hub[row] - wide, table.hub[row] + wide])
        found[table.wheel[row]] = box
    return found


def _extent(table: Any, row: int) -> Floats:
    """Return how far a wheel is from its hub along x, y and z at most (3,) [m]."""
    axle = np.abs(table.axle[row])
    if table.kind[row] not in ROUND or table.sweeps[row] or moves(table, row):
        return np.full(3, np.inf)
    across = np.sqrt(np.maximum(1.0 - axle**2, 0.0))
    long = _along(table, row)
    lengthwise = np.where(axle > 0.0, long * np.maximum(axle, 1e-300), 0.0)
    found: Floats = lengthwise + reach_of(table, row) * across
    return found


def _along(table: Any, row: int) -> float:
    """Return how far a round solid reaches from its hub along its axle at most [m]."""
    size, kind = table.size[row], table.kind[row]
    middle = table.center[row] - table.hub[row]
    own = {SPHERE: 0, CYLINDER: 1, TORUS: 1}
    long = size[1] + size[0] if kind == CAPSULE else size[own[kind]]
    return float(abs(middle @ table.axle[row]) + long)


def homes_of(model: Model) -> Ints:
    """Return for every wheel the rope nearest to it where a model stands, by its number (w,)."""
    boxes, x = boxes_of_wheels(model.system.node.obstacle), model.state.x
    found = np.zeros(len(boxes), np.int64)
    for w, box in enumerate(boxes):
        low, high = box[LOW:HIGH, None], box[HIGH:FROM, None]
        off = np.maximum(np.maximum(low - x, x - high), 0.0)
        far = np.sqrt((off**2).sum(axis=0))
        spans = model.layout.ropes
        found[w] = np.argmin([far[span.first : span.last + 1].min() for span in spans])
    return found


def numbered(model: Model) -> Ints:
    """Return of which rope every segment is, (s,): -1 of none."""
    found = np.full(model.layout.segments, -1, np.int64)
    for number, span in enumerate(model.layout.ropes):
        found[span.first : span.last] = number
    return found


def ahead_of(model: Model) -> Floats:
    """Return for how long on a wheel takes hold of a node that comes at it, at most, (n,) [s].

    Its damper presses from a gap of so long on its way, see `laws.closing`.
    """
    table = model.system.node.obstacle
    free = table.wheel >= 0
    slack = table.ratio[free, None] * table.damping[free]
    found: Floats = (slack / table.stiffness[free]).max(axis=0, initial=0.0)
    return found


def reaches_at(model: Model) -> tuple[Floats, Ints]:
    """Return the boxes of all runs where a model stands, (k, 6) [m], and of which ropes they are.

    Speeds are the first step's: they may be of what bursts in it.
    """
    rope, x = numbered(model), model.state.x
    swept, still = with_held(runs_of(rope), np.zeros(x.shape[1])), np.zeros_like(x)
    place_held(x, still, x, still, swept)
    owners = rope[swept[:, FROM].astype(np.int64)]
    return _widened(swept, _pads(model)[owners]), owners


def _widened(swept: Floats, wide: Floats) -> Floats:
    """Return the boxes of what obstacles reach, wider by so much each (k,) [m]."""
    low, high = swept[:, HELD_LOW:HELD_HIGH], swept[:, HELD_HIGH:AHEAD]
    return np.hstack([low - wide[:, None], high + wide[:, None]])


def reached(
    wheels: Floats, homes: Ints, groups: Sequence[Sequence[int]], boxes: Sequence[Floats]
) -> set[tuple[int, int]]:
    """Return which groups of ropes have come within reach of whose wheels, as pairs of their places.

    `boxes` (k, 6) are those of each group.
    """
    found = set[tuple[int, int]]()
    owner = {rope: k for k, ropes in enumerate(groups) for rope in ropes}
    for wheel, home in zip(wheels, homes.tolist(), strict=True):
        for k, own in enumerate(boxes):
            touch = (own[:, LOW:HIGH] <= wheel[HIGH:FROM]) & (wheel[LOW:HIGH] <= own[:, HIGH:FROM])
            if home in owner and owner[home] != k and touch.all(axis=1).any():
                found.add((min(k, owner[home]), max(k, owner[home])))
    return found


class Wheels:
    """The wheels of a scene, and who comes within reach of them."""

    def __init__(self, model: Model, table: Any) -> None:
        """Take up a model's wheels; `table` has how hands move them."""
        self.homes, self._ahead = homes_of(model), ahead_of(model)
        self._table, self._moved, self._boxes = table, np.zeros(0, np.int64), np.zeros((0, 6))
        self._pads, self._wide = _pads(model), dict[tuple[int, ...], Floats]()
        owners = numbered(model)[runs_of(numbered(model))[:, FROM].astype(np.int64)]
        self._runs = np.bincount(owners, minlength=len(self._pads))

    def met(
        self, groups: Sequence[tuple[int, ...]], states: Sequence[State], ended: Floats
    ) -> set[tuple[int, int]]:
        """Return which groups of ropes have met one with a wheel, as pairs of their places.

        By where their states say that they have been since boxes began.
        """
        if not self.homes.size or len(groups) < 2:
            return set()
        if not np.array_equal(self._moved, self._table.motion.kind):
            self._moved, self._boxes = self._table.motion.kind.copy(), boxes_of_wheels(self._table)
        boxes = []
        for ropes, state, over in zip(groups, states, ended, strict=True):
            wide = self._wide.get(ropes)
            if wide is None:  # of each run: they lie as their ropes do
                runs = [self._runs[i] for i in ropes]
                wide = self._wide[ropes] = np.repeat(self._pads[list(ropes)], runs)
            own = state.memory.contact.swept
            boxes.append(_widened(_lying(state) if over else own, wide))
        return reached(self._boxes, self.homes, groups, boxes)

    def watched(self, model: Model, nodes: Ints) -> Model:
        """Return an island's model that keeps where wheels reach it, `nodes` its ones in the whole."""
        if not self.homes.size:
            return model
        state = model.state
        swept = state.memory.contact.swept
        runs = swept if swept.size else runs_of(numbered(model))
        contact = state.memory.contact._replace(swept=with_held(runs, self._ahead[nodes]))
        return replace(model, state=state._replace(memory=state.memory._replace(contact=contact)))

    def meet(self, whole: State, bodies: Ints, parts: Sequence[tuple[Ints, Ints]]) -> None:
        """Let wheels have nothing at nodes that come from parts without them, from where these are now.

        `bodies` are the obstacles of the island that these become, `parts` those and the nodes of each.
        """
        memory, time = whole.memory.obstacle, float(whole.now[1])
        for known, nodes in parts:
            rows = bodies[~np.isin(bodies, known)]
            if rows.size:
                found, still = copy(memory), np.zeros_like(whole.x)
                found.place[...] = whole.x
                now = np.array([time, time])
                remember_contacts(whole.x, still, self._table, found, now, whole.stiffness)
                for row in rows:
                    memory.grip[row][:, nodes] = found.grip[row][:, nodes]
                    memory.books[row, GAP, nodes] = found.books[row, GAP, nodes]


def _pads(model: Model) -> Floats:
    """Return how far from its middle a rope may touch a wheel, (r,) [m]."""
    thick = model.system.node.obstacle.thickness
    return np.array([REACH * thick[one.first : one.last + 1].max() for one in model.layout.ropes])


def _lying(state: State) -> Floats:
    """Return where wheels reach ropes that have ended, at whatever speed: they stay there."""
    found: Floats = state.memory.contact.swept.copy()
    still = np.zeros_like(state.x)
    place_held(state.x, still, state.x, still, found)
    return found


def follow_others(own: State, whole: State, nodes: Ints) -> None:
    """Let obstacles remember where nodes are whose island has none of them: they touch nothing."""
    memory = whole.memory.obstacle
    if own.memory.obstacle.place.size or not memory.place.size:
        return
    memory.place[:, nodes] = whole.x[:, nodes]
    memory.way[:, nodes] = 0.0
    memory.held[nodes] = whole.inverse_mass[nodes] == 0.0
