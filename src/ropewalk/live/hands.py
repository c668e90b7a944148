"""Hands on the ropes: soft springs that pull nodes, and anchors that follow a pointer.

Both are brought up to date every `CONTROL` seconds of the user's time, at whole steps, and act evenly in
between. A hand is as wide as `WIDTH` of the rope: it pulls all nodes there alike, so that a rope in a
thousand pieces is no harder to lift than one in forty. Its soft spring F = K (target - x) - C v, x and v the
means of the nodes it holds, is bounded in three ways, so that it pulls hard
enough and cannot break anything: K lifts all the rope with a stretch of 1 % of its length and
K H^2 <= m / 4, C damps a tenth of the rope critically and C H <= m / 4, and |F| is at most 20 times
the rope's weight (H the time between two updates, m the mass that the hand holds), or what the user allows
if that is less. With C >= K H / 2 a sampled spring gives no energy out (Colgate & Schenkel 1997, passivity
of a virtual wall).

Hands act in the user's time. Where the computer manages only a part p of the speed that is asked for, K is
1 / p^2 and C 1 / p times as large, as far as the bounds above allow, and H is p times as long: the pointer
is reached in the same time on the clock. Anchors follow 1 / p times as fast, also where a low speed is asked
for.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.live.ties import Pull, brought, is_over
from ropewalk.simulation import Simulation

CONTROL = 1.0 / 960.0  # [s] of the user's time between two updates, or one step
WIDTH = 0.01  # of a rope that a hand holds to either side of the node that it took
FOLLOW = 0.02  # [s] in which an anchor makes up 63 % of the way to its target
FASTEST = 30.0  # [m/s] of an anchor on its way to its target
MOST_GRABS = 8
SLOWEST = 1e-4  # pace that hands still make up for
_LIFT, _SHARE, _FORCE = 100.0, 0.1, 20.0


@dataclass(frozen=True)
class Grab:
    """A soft spring on a node."""

    node: int
    target: Floats  # (3,) [m]
    owner: int = 0
    force: Floats = field(default_factory=lambda: np.zeros(3))  # on the node [N]
    allowed: float | None = None  # by the user, largest force [N]
    pace: float = 1.0  # simulated seconds in one of the user's
    most: float = 0.0  # largest force [N] since the last update


class Target(NamedTuple):
    """Where an anchor is to go."""

    place: Floats  # (3,) [m]
    owner: int
    pace: float = 1.0  # simulated seconds in one of the user's


class Hands:
    """All that hands do to one simulation."""

    def __init__(self) -> None:
        self.grabs: list[Grab] = []
        self.targets: dict[str, Target] = {}  # of anchors that follow a pointer
        self.movers: dict[str, int] = {}  # who moves an anchor by a held key
        self.pulls: list[Pull] = []  # points on their way to each other, to be tied
        self.fresh = False  # something has changed since the last update

    @property
    def active(self) -> bool:
        """Whether there is anything to bring up to date."""
        return bool(self.grabs or self.targets or self.pulls)

    def pace(self, speed: float) -> float:
        """Return how many simulated seconds make one of the user's, for the quickest of the hands."""
        paces = [one.pace / speed for one in self.grabs]
        paces += [min(one.pace, speed) for one in self.targets.values()]
        return bounded(min(paces, default=1.0))

    def copy(self) -> Hands:
        """Return a copy."""
        made = Hands()
        made.grabs, made.targets, made.fresh = list(self.grabs), dict(self.targets), self.fresh
        made.movers, made.pulls = dict(self.movers), list(self.pulls)
        return made

    def grab(self, made: Grab) -> None:
        """Take hold of a node, or move the target of a grab."""
        kept = [one for one in self.grabs if (one.node, one.owner) != (made.node, made.owner)]
        self.grabs = [*kept, made]
        self.fresh = True

    def let_go(self, simulation: Simulation, owner: int | None, node: int | None = None) -> None:
        """End grabs: of an owner (None: of all), of one node or of all."""
        gone = [
            one
            for one in self.grabs
            if (owner is None or one.owner == owner) and (node is None or one.node == node)
        ]
        if gone:
            self.grabs = [one for one in self.grabs if one not in gone]
            within = [_within_reach(simulation, one.node) for one in gone]
            simulation.push({int(node): np.zeros(3) for node in np.concatenate(within)})
            self.fresh = True

    def stop(self, simulation: Simulation, owner: int | None) -> None:
        """End what an owner (None: anybody) moves: drags and held keys; the anchors stand still."""
        names = [name for name, one in self.targets.items() if owner in (None, one.owner)]
        names += [name for name, one in self.movers.items() if owner in (None, one)]
        for name in names:
            self.still(simulation, name)
        for pull in self.pulls:
            if owner in (None, pull.owner):
                self.pulls = [replace(one, left=0.0) if one == pull else one for one in self.pulls]

    def over(self, simulation: Simulation) -> list[Pull]:
        """Return the pulls whose points have met, and those that are given up."""
        return [one for one in self.pulls if is_over(simulation, one)]

    def still(self, simulation: Simulation, name: str) -> None:
        """Have an anchor stand still."""
        self.targets.pop(name, None)
        self.movers.pop(name, None)
        handle = simulation.anchors.get(name)
        if handle is not None and handle.holds:
            handle.velocity = (0.0, 0.0, 0.0)

    def holds(self, owner: int) -> bool:
        """Tell whether an owner holds or moves anything."""
        held = [one.owner for one in self.grabs] + [one.owner for one in self.targets.values()]
        held += [one.owner for one in self.pulls]
        return owner in (*held, *self.movers.values())

    def renumber(self, source: Floats) -> None:
        """Follow the nodes into new arrays; grabs of nodes that are gone end."""
        kept = []
        for one in self.grabs:
            near = int(np.argmin(np.abs(source - one.node)))
            if abs(source[near] - one.node) <= 0.5:
                kept.append(replace(one, node=near))
        self.grabs, self.fresh = kept, True

    def update(self, simulation: Simulation, interval: float, speed: float) -> None:
        """Set the forces and the anchors' velocities for the next `interval` [s]."""
        self.fresh = False
        for name, target in list(self.targets.items()):
            handle = simulation.anchors.get(name)
            if handle is None or not handle.holds:
                del self.targets[name]
                continue
            time = max(FOLLOW * bounded(min(target.pace, speed)), interval)
            velocity = (target.place - handle.position) / time
            size = float(np.linalg.norm(velocity))
            handle.velocity = velocity * min(1.0, FASTEST / size) if size > 0.0 else velocity
        self.pulls = [brought(simulation, one, interval) for one in self.pulls]
        if not self.grabs:
            return
        self.grabs = [self._pulled(simulation, one, interval, speed) for one in self.grabs]
        forces: dict[int, Floats] = {}
        for one in self.grabs:
            held = held_around(simulation, one.node)
            for node in held.tolist():
                forces[node] = forces.get(node, np.zeros(3)) + one.force / held.size
        simulation.push(forces)

    def _pulled(self, simulation: Simulation, grab: Grab, interval: float, speed: float) -> Grab:
        state, i = simulation.arrays, grab.node
        held = held_around(simulation, i)
        stiffness, damping, most = soft_spring(simulation, i, interval, bounded(grab.pace / speed))
        if grab.allowed is not None:
            most = min(most, grab.allowed)
        place, velocity = state.x[:, held].mean(axis=1), state.v[:, held].mean(axis=1)
        force = stiffness * (grab.target - place) - damping * velocity
        size = float(np.linalg.norm(force))
        if not size <= most:
            force = force * (most / size) if np.isfinite(size) else np.zeros(3)
        return replace(grab, force=force, most=most)


def bounded(pace: float) -> float:
    """Return a pace within what hands make up for."""
    return min(max(pace, SLOWEST), 1.0)


def _within_reach(simulation: Simulation, node: int) -> Ints:
    """Return the nodes of a rope that are no farther from one than a hand is wide."""
    name, _ = simulation.layout.rope_of(node)
    span = simulation.layout.span(name)
    around = int(WIDTH * (span.end - span.start))
    return np.arange(max(node - around, span.first), min(node + around, span.last) + 1)


def held_around(simulation: Simulation, node: int) -> Ints:
    """Return the free nodes that a hand holds which takes hold of one; at least that one."""
    nodes = _within_reach(simulation, node)
    free = nodes[simulation.arrays.inverse_mass[nodes] > 0.0]
    return free if node in free else np.array([node])


def soft_spring(
    simulation: Simulation, node: int, interval: float, pace: float = 1.0
) -> tuple[float, float, float]:
    """Return stiffness [N/m], damping [N s/m] and largest force [N] of a grab of a node."""
    state, layout = simulation.arrays, simulation.layout
    name, _ = layout.rope_of(node)
    span = layout.span(name)
    length = simulation.scene.rope_named(name).length_unstretched or 1.0
    mass = float(state.mass[span.start : span.end + 1].sum())
    weight = mass * max(float(np.linalg.norm(simulation.system.gravity)), 1.0)
    held = held_around(simulation, node)
    own = held.size * float(state.mass[held].min())
    stiffness = min(_LIFT * weight / length / pace**2, 0.25 * own / interval**2)
    damping = 2.0 * float(np.sqrt(stiffness * _SHARE * mass))
    damping = max(min(damping, 0.25 * own / interval), 0.5 * stiffness * interval)
    return stiffness, damping, _FORCE * weight
