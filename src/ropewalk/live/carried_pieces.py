"""What pieces of rope have as wholes in a session, frame by frame: who goes along with them sees the rest.

As in the table of a run, see `record.turnover`, as far as that is known while it goes on.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.acting import section_of
from ropewalk.laws.parting import NAME as PARTING
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.lowering import Layout
from ropewalk.lowering.masses import line, masses
from ropewalk.methods.recording import work_names
from ropewalk.record.quantities import has_rope, rest_length_at_start
from ropewalk.record.turnover import loose, pieces, stands
from ropewalk.scene import Scene

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_VALUES = 1_000_000  # numbers of one quantity looked at together
_TOUCHING = tuple(law.name for law in NODE_LAWS if law.touch is not None)


class Standing(NamedTuple):
    """What is known of ropes at one time."""

    scene: Scene
    layout: Layout
    rest: Floats  # (s,) rest lengths [m]
    held: Floats  # (n,) above 0 where an anchor holds
    mass: Floats  # (n,) [kg]
    given: float  # what changes have put in until then [J]
    touched: bool  # whether surfaces or hands have done anything


class Goers(NamedTuple):
    """Who goes along with pieces, between two changes of these."""

    labels: Ints  # (n,) of the pieces
    part: Floats  # (n,) share of a node in what goes along with its piece [1]
    mass: Floats  # (n,) [kg]
    falls: Floats  # (pieces,) 1 for one that nothing but its weight moves

    def summed(self, values: Floats) -> Floats:
        """Return the sums over pieces, (pieces, 3), of (n, 3)."""
        return np.stack([np.bincount(self.labels, weights=row) for row in values.T], axis=1)


class Carried(NamedTuple):
    """The energy of pieces as wholes [J]: that of a mass that goes with what carries each."""

    kinetic: float = 0.0
    gravity: float = 0.0
    fallen: float = 0.0  # both, of pieces in free fall: it does not change but by an error
    key: tuple[object, ...] = ()  # what tells one set of pieces from another
    goers: Goers | None = None
    low: float = 0.0  # gravity, and what falls has, when these pieces began
    begin: float = 0.0
    base: tuple[float, float] = (0.0, 0.0)  # ... and what was counted until then

    def later(self, now: Standing, x: Floats, v: Floats) -> Carried:
        """Return it at a later time, of places and velocities (n, 3) [m, m/s]."""
        key = (now.scene, now.given, now.touched, now.held.tobytes(), now.rest.tobytes())
        old = self
        if key != self.key:
            old = self._replace(key=key, goers=_goers(now), base=(self.gravity, self.fallen))
        if old.goers is None:
            return old._replace(kinetic=0.0)
        high, quick = _as_wholes(old.goers, x, v, np.asarray(now.scene.gravity))
        whole, falling = float(high.sum()), float(((high + quick) * old.goers.falls).sum())
        if key != self.key:
            old = old._replace(low=whole, begin=falling)
        return old._replace(
            kinetic=float(quick.sum()),
            gravity=old.base[0] + whole - old.low,
            fallen=old.base[1] + falling - old.begin,
        )


def touched_anything(work: Floats, bending: bool, more: tuple[str, ...]) -> bool:
    """Tell whether surfaces or hands have done any work, of (laws + anchors,) [J] as recorded."""
    names = work_names(bending, more)
    return any(work[i] != 0.0 for i, name in enumerate(names) if name in (*_TOUCHING, "applied"))


def carried_of(result: Result, begin: Carried, given: Floats) -> Iterator[Carried]:
    """Go through the frames of a run, which goes on from `begin`; `given` (frames,): see `Standing`."""
    scene, layout, read = result.scene, result.layout, result.read
    mass = masses(layout, tuple(line(rope) for rope in scene.ropes))[0]
    rest = rest_length_at_start(layout, [rope.segment_length for rope in scene.ropes])
    ends = [one.release_time for one in scene.anchors]
    nodes = np.array(layout.anchor_nodes, dtype=np.int64)
    until = np.array([math.inf if time is None else time for time in ends])
    step = max(1, _VALUES // (3 * layout.nodes))
    for first in range(0, result.frames, step):
        rows = first, min(first + step, result.frames)
        time, work, x, v = (
            read(name, *rows) for name in ("time", "work", "positions", "velocities")
        )
        rests = read("rest_length", *rows) if "rest_length" in result.source.names else None
        for row in range(len(time)):
            held = np.zeros(layout.nodes)
            held[nodes[time[row] <= until]] = 1.0
            touched = touched_anything(np.nan_to_num(work[row]), layout.bends, layout.more)
            there = rest if rests is None else rests[row]
            put_in = float(given[first + row])
            now = Standing(scene, layout, there, held, mass, put_in, touched)
            begin = begin.later(now, x[row], np.nan_to_num(v[row]))
            yield begin


def _as_wholes(goers: Goers, x: Floats, v: Floats, gravity: Floats) -> tuple[Floats, Floats]:
    """Return the energy of weight, and of motion, of what goes along with each piece [J], (pieces,)."""
    part, mass = goers.part[:, None], goers.mass[:, None]
    masses = np.bincount(goers.labels, weights=goers.mass)
    along, momentum = goers.summed(v * part), goers.summed(v * mass)
    quick = (along * momentum).sum(axis=1) - 0.5 * masses * (along**2).sum(axis=1)
    return masses * (goers.summed(x * part) @ -gravity), quick


def _goers(now: Standing) -> Goers | None:
    """Return who goes along with pieces; None where anchors that stand still hold all."""
    scene, layout = now.scene, now.layout
    lengths = [rope.segment_length for rope in scene.ropes]
    labels = pieces(scene, layout, has_rope(layout, now.rest, lengths))
    held = np.asarray(now.held > 0.0)
    fed = np.zeros(layout.nodes, dtype=bool)
    for winch in scene.winches:
        span = layout.span(winch.rope)
        fed[span.first : span.last + 1] = True
    free = loose(labels, held)
    if stands(scene) and not (free & ~fed).any():
        return None
    others = (law for law in NODE_LAWS if law.name != PARTING and law.name not in _TOUCHING)
    calm = scene.limiter is None and not any(section_of(law, scene) for law in others)
    weight = np.where(free, now.mass * calm, held) * ~fed
    total = np.bincount(labels, weights=weight)
    falls = np.zeros(len(total))
    falls[labels] = free & ~fed & (calm and not now.touched)
    return Goers(labels, weight / np.where(total > 0.0, total, 1.0)[labels], now.mass, falls)
