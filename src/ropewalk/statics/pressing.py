"""How deep the tension of ropes presses them into obstacles, and which lie through them at rest."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.contact import push_on
from ropewalk.laws.obstacle_places import surface_near
from ropewalk.laws.obstacle_way import find_sweep
from ropewalk.lowering import Model
from ropewalk.lowering.obstacle_checks import longest_kept_out, through
from ropewalk.scene.obstacles import name_of, thinnest
from ropewalk.statics.balance import Balance
from ropewalk.statics.standing import standing_obstacles
from ropewalk.words.safe_side import rounded_down

_TINY = 1e-300
_SHALLOW = 0.5  # of a rope's radius: contacts at rest that are pressed in deeper are wrong [1]
_BARE = 0.1  # ... of a body's least radius, where the rope has no diameter [1]
_THROUGH = (
    0.25  # ... of both radii, on the way: from there a rope may come out on the other side [1]
)
_ALLOWED = (
    0.02  # of a rope's radius, or of the body's: the depth that a compliance is named for [1]
)
_SHORT = 0.9  # of a rope's length: one whose shape is shorter falls before it hangs [1]


class Pressed(NamedTuple):
    """The node that was pressed deepest."""

    node: int
    obstacle: int
    depth: float  # [m]
    compliance: float  # that would do [m/N]
    through: bool  # whether on the way to where it is now

    def words(self, model: Model) -> str:
        """What happened, and what to change."""
        rope, number = model.layout.rope_of(self.node)
        name = model.scene.obstacles[self.obstacle].name
        through = " and through it" if self.through else ""
        helps = _drawn_short(model, rope) if self.through else ""
        helps = helps or (
            "by tension or weight; give the obstacle a compliance of at most "
            f"{rounded(self.compliance)} m/N"
        )
        return (
            f"no shape of rest was found: node {number} of rope {rope!r} is pressed "
            f"{1e3 * self.depth:.3g} mm into {name!r}{through} {helps}"
        )


def _drawn_short(model: Model, rope: str) -> str:
    """Say that a rope is drawn much shorter than it is, and falls before it hangs; "" of another one.

    It comes through a body as it falls, which no compliance keeps: a stiffer one lets it slide and fall.
    """
    span, state = model.layout.span(rope), model.state
    places = state.x[:, span.start : span.end + 1]
    drawn = float(np.linalg.norm(np.diff(places, axis=1), axis=0).sum())
    own = float(state.rest_length[span.start : span.end].sum())
    if drawn >= _SHORT * own:
        return ""
    return f"as it falls: its shape is {drawn:.4g} m long, and it is {own:.4g} m; draw it as long as it is"


class Across(NamedTuple):
    """A segment that would go through an obstacle between its two nodes."""

    segment: int
    obstacle: int
    length: float  # [m]

    def words(self, model: Model) -> str:
        """What happened, and what to change."""
        rope, number = model.layout.rope_of(self.segment)
        body = model.scene.obstacles[self.obstacle]
        short = longest_kept_out(body, model.scene.rope_named(rope))
        helps = "a shape nearer to rest"
        if self.length > short:
            helps = (
                f"more segments (at most {rounded_down(1e3 * short)} mm long, this one is "
                f"{1e3 * self.length:.3g})"
            )
        return (
            f"no shape of rest was found: segment {number} of rope {rope!r} would go through obstacle "
            f"{name_of(body, self.obstacle)!r} between its two nodes, where nothing holds it. Try {helps}"
        )


class Watch:
    """Looks how deep nodes are pressed in while ropes creep."""

    def __init__(self, model: Model, balance: Balance) -> None:
        self.balance, self.table = balance, model.system.node.obstacle
        self.body = np.array([thinnest(body) for body in model.scene.obstacles])
        self.drawn = model.state.x.copy()
        self.push = pressing(model)
        self.deep: dict[tuple[int, int], float] = {}  # depth of nodes in obstacles on the way [m]
        self.across: Across | None = None  # what would have gone through last

    def passes(self, x: Floats, y: Floats) -> bool:
        """Tell whether a segment goes through an obstacle between its nodes, from x to y, (3, n) [m] each."""
        state, table = self.balance.state, self.balance.system.node.obstacle
        if not self.body.size:
            return False
        found = np.zeros_like(state.memory.obstacle.through)
        wheels, now = state.memory.obstacle.wheel, np.zeros(2)
        if not find_sweep(x, y, state.inverse_mass, state.stiffness, table, wheels, found, now):
            return False
        segment = int(np.flatnonzero(found)[0])
        long = float(np.linalg.norm(y[:, segment + 1] - y[:, segment]))
        self.across = Across(segment, -int(found[segment]) - 1, long)
        return True

    def see(self, x: Floats) -> None:
        """Look at places (3, n) [m] on the way."""
        self.across = None  # the ropes went on without
        for i, o, depth in self._deeper(x, on_way=True):
            self.deep[i, o] = max(depth, self.deep.get((i, o), 0.0))

    def at_last(self, x: Floats) -> Pressed | None:
        """Return what is pressed in too deep at the last places (3, n) [m], or came through on the way."""
        self.balance.others(x)
        found = [self._pressed(*row, through=False) for row in self._deeper(x, on_way=False)]
        for (i, o), depth in self.deep.items():
            before, now = self._probe(i, o, self.drawn)[1:4], self._probe(i, o, x)[1:4]
            if np.dot(before, now) < 0.0:
                found.append(self._pressed(i, o, depth, through=True))
        return max(found, key=lambda one: (one.through, one.depth), default=None)

    def _deeper(self, x: Floats, *, on_way: bool) -> list[tuple[int, int, float]]:
        """Return node, obstacle and depth [m] of contacts that are deeper than they may be."""
        table, found = self.table, []
        thick, size = table.thickness, np.linalg.norm(self.balance.contact_force(), axis=0)
        for o in range(len(table.kind)):
            least = np.where(thick > 0.0, _SHALLOW * thick, _BARE * self.body[o])
            if on_way:
                least = np.maximum(least, _THROUGH * (self.body[o] + thick))
            for i in map(int, np.flatnonzero(size > table.stiffness[o] * least)):
                depth = float(thick[i] - self._probe(i, o, x)[0])
                if depth > least[i]:
                    found.append((i, o, depth))
        return found

    def _probe(self, i: int, o: int, x: Floats) -> tuple[float, ...]:
        found: tuple[float, ...] = surface_near(self.table, o, x[:, i])
        return found

    def _pressed(self, i: int, o: int, depth: float, *, through: bool) -> Pressed:
        gap = float(self.table.thickness[i]) - depth
        push = max(push_on(self.table, o, i, gap, 0.0), self.push)
        enough = allowed_depth(float(self.body[o]), float(self.table.thickness[i])) / push
        return Pressed(i, o, depth, enough, through)


def speared_words(model: Model, balance: Balance, x: Floats) -> str:
    """Say which segment lies through an obstacle in places (3, n) [m]: nothing holds it there. Or ""."""
    table = model.system.node.obstacle
    if not len(table.kind):
        return ""
    table = standing_obstacles(table, balance.state.memory.obstacle)
    number, segment, row = next(
        through(table, x, model.state.inverse_mass, model.layout), (-1, -1, -1)
    )
    if number < 0:
        return ""
    rope, body = model.layout.ropes[number].name, model.scene.obstacles[row].name
    return (
        f"no shape of rest was found: segment {segment} of rope {rope!r} comes to lie through {body!r} "
        "between its two nodes, where nothing holds it; take more segments"
    )


def allowed_depth(body: float, thick: float) -> float:
    """Return the depth that hardly matters [m], of a body and half a rope's diameter [m]."""
    return _ALLOWED * min(radius for radius in (body, thick) if radius > 0.0)  # edges may be sharp


def pressing(model: Model) -> float:
    """Return the largest force with which tension in the drawn shape, or what is applied, presses a node [N].

    Rigid links are taken to have none.
    """
    state = model.state
    d = np.diff(state.x, axis=1)
    size = np.sqrt((d * d).sum(axis=0))
    stiff = np.where(np.isfinite(state.stiffness), state.stiffness, 0.0)
    pull = stiff * np.maximum(size - state.rest_length, 0.0)
    along = pull * d / np.maximum(size, _TINY)
    force = state.forces.applied.copy()
    force[:, :-1] += along
    force[:, 1:] -= along
    free = (state.inverse_mass > 0.0) & (state.mass > 0.0)
    return float(np.linalg.norm(force, axis=0)[free].max(initial=0.0))


def rounded(compliance: float) -> str:
    """Return a compliance [m/N] of one digit, no larger."""
    power = 10.0 ** math.floor(math.log10(compliance))
    return f"{math.floor(compliance / power * (1.0 + 1e-9)) * power:.1g}"
