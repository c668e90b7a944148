"""Which nodes touch which obstacles, and with what force: from places, velocities and the forces of all."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.closing import closing
from ropewalk.laws.contact import push_on
from ropewalk.laws.contact_frame import find_gaps, surface_at
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import surface_near
from ropewalk.laws.obstacle_pose import rates_of
from ropewalk.laws.polygon import pulls_ahead, tilted, turned_by
from ropewalk.lowering.rooms import FACING
from ropewalk.lowering.splitting import split, that_slide
from ropewalk.lowering.wedging import held_along

SLIPS = 0.99  # of what friction can carry: a contact that moves and carries more slips [1]
STILL = 1e-6  # [m/s] a contact that moves less does not
PRESSED = 0.01  # of what a rope presses on an obstacle, beyond which what lies on it counts as holding it [1]

_Row = tuple[
    int, int, Floats, float, float, Floats, float, float, float, Floats, float
]  # in the order that `_shared` reads


class Contacts(NamedTuple):
    """Contacts at one time, one row each; c of them, by node."""

    obstacle: Ints  # (c,)
    node: Ints  # (c,) index of the arrays
    normal: Floats  # (c, 3) out of the obstacle [1]
    push: Floats  # (c,) R_n [N]
    turn: Floats  # (c,) angle by which the rope turns there towards the obstacle [rad]
    aside: Floats  # (c,) ... and within its surface [rad]
    rub: Floats  # (c, 3) R_t [N]
    friction: Floats  # (c,) coefficient with which the node acts as its arc, the way it rubs [1]
    slip: Floats  # (c, 3) velocity of the node over the surface [m/s]
    # tan p and e [rad] of `laws.polygon`, (c,): friction is tan(p + c e), c as the rope pulls
    cone: Floats
    off: Floats
    given: Floats  # (c,) coefficient of friction of the rope on the obstacle, of an arc [1]

    @property
    def use(self) -> Floats:
        """|R_t| / (mu R_n) of every contact [1], (c,): 1 where friction carries all it can; 0 without any.

        NaN where the friction is: where it cannot be told from what ropes do.
        """
        most = self.friction * self.push
        size = np.linalg.norm(self.rub, axis=1)
        found: Floats = np.divide(
            size, most, out=np.zeros_like(size), where=(most > 0.0) | np.isnan(size)
        )
        return found

    def at_slip(self, friction: float, rows: Ints) -> float:
        """Return the ratio of tensions at which a stretch of a rope without weight slips [1].

        exp of the sum of sqrt((mu a)^2 - b^2), `friction` mu, a the turn towards the surface and b that
        within it: the rope presses with T a and needs T b across, which friction lacks along it. On a drum
        that is exp(mu theta). A node that friction does not hold across adds nothing, one on several
        surfaces what they do together, see `held_along`. With a share of that, see `using`, it is the same
        power of it: ln(ratio) / ln(ratio at slip) is taken. See `statics.wraps`.
        """
        return float(np.exp(self.held_by(friction, rows).sum()))

    def held_by(self, friction: float, rows: Ints) -> Floats:
        """Return by how much ln T may rise over each contact of a stretch, (r,) [1], see `at_slip`."""
        spare = (friction * self.turn[rows]) ** 2 - self.aside[rows] ** 2
        spare = np.sqrt(np.maximum(spare, 0.0))
        beside = np.bincount(self.node)[self.node[rows]] > 1 if rows.size else np.zeros(0, bool)
        for row in np.flatnonzero(beside):
            all_of = np.flatnonzero(self.node == self.node[rows[row]])
            parts = (part[all_of] for part in (self.normal, self.given, self.turn, self.aside))
            spare[row] = held_along(*parts)
        found: Floats = spare
        return found

    def pressed_by(self, rows: Ints) -> list[int]:
        """Return which other obstacles press a stretch against its own noticeably, by number.

        From another side, as a keeper over a drum does: how hard is not told by the tension, as it is of the
        sides of a groove, on all of which it presses by itself, see `held_along`.
        """
        nodes, own = self.node[rows], self.obstacle[rows[0]]
        between = (self.node >= nodes.min()) & (self.node <= nodes.max()) & (self.obstacle != own)
        found: dict[int, float] = {}
        for other in np.flatnonzero(between).tolist():
            here = int(rows[np.argmin(np.abs(nodes - self.node[other]))])
            against = -float(self.normal[other] @ self.normal[here]) * float(self.push[other])
            if self.node[here] == self.node[other]:
                against = (
                    0.0 if self._grooved(here, other) else min(against, float(self.push[here]))
                )
            if against > 0.0:
                o = int(self.obstacle[other])
                found[o] = found.get(o, 0.0) + against
        most = PRESSED * float(self.push[rows].sum())
        return [o for o, force in sorted(found.items()) if force > most]

    def _grooved(self, row: int, other: int) -> bool:
        """Tell whether two surfaces that a node touches are as the sides of a groove in which the rope lies.

        It turns towards both, or towards none and is not between them as in a press, but by its weight.
        """
        turns = int(self.turn[row] > 0.0) + int(self.turn[other] > 0.0)
        return turns == 2 or (turns == 0 and float(self.normal[row] @ self.normal[other]) > FACING)

    def using(self, share: float) -> Contacts:
        """Return the same contacts with a share [1] of what friction has along the rope, as of `at_slip`.

        That which is needed across stays: sqrt((s mu_a)^2 + (1 - s^2) b^2) of every contact, s the share.
        """
        across = np.divide(
            self.aside, self.turn, out=np.zeros_like(self.aside), where=self.turn > 0.0
        )
        across = np.minimum(across, self.cone)
        cone = np.sqrt((share * self.cone) ** 2 + (1.0 - share**2) * across**2)
        return self._replace(cone=cone, off=share * self.off)

    @property
    def slips(self) -> NDArray[np.bool_]:
        """Whether each contact slips, (c,): it moves, and friction carries what it can."""
        moves = np.linalg.norm(self.slip, axis=1) > STILL
        return np.asarray(moves & ((self.use >= SLIPS) | (self.friction == 0.0)))


def stretches(contacts: Contacts, rows: Ints) -> list[Ints]:
    """Return rows of contacts of one rope with one obstacle in stretches of nodes side by side.

    One node between two of them may be off.
    """
    if not rows.size:
        return []
    return list(np.split(rows, np.flatnonzero(np.diff(contacts.node[rows]) > 2) + 1))


def contacts_at(
    table: Obstacles,
    x: Floats,
    v: Floats,
    force: Floats,
    stiffness: Floats,
    t: float = 0.0,
    only: Sequence[int] | None = None,
    span: float = 0.0,
) -> Contacts:
    """Return the contacts of nodes at places `x` with velocities `v`, (3, n) [m, m/s], at time `t` [s].

    `force` (3, n) [N] is that of all obstacles on every node, `stiffness` (s,) that of the segments [N/m].
    Where a node touches several, each has friction along its own surface, see `splitting`. With `only` some
    obstacles, those of nodes that may touch one of them.
    For `span` see `within_reach`.
    """
    rows: list[_Row] = []
    nodes = np.flatnonzero(np.any(force != 0.0, axis=0))
    speed, over, near = within_reach(table, nodes, x, v, t, span)
    wanted = near if only is None else near & near[list(only)].any(axis=0)
    for j, o in np.argwhere(wanted.T).tolist():
        i = int(nodes[j])
        gap, *direction, ax, ay, az, ca, cb = surface_near(table, o, x[:, i], t)
        normal = np.array(direction)
        room, rise = gap - table.thickness[i], float(normal @ speed[o, j])
        moves = tuple(speed[o, j])
        rise = closing(rise, room, tuple(direction), (ax, ay, az), ca, cb, moves)[0]
        push = push_on(table, o, i, gap, rise)
        if not push > 0.0:
            continue
        probed = (*direction, ax, ay, az, ca, cb)
        turn, cone, off, _ = turned_by(x, x, table, o, i, probed, 0.0, stiffness)
        along, mu = over[o, j] - normal * (normal @ over[o, j]), float(table.friction[o, i])
        aside = turn_within(x, i, normal) if turn > 0.0 else 0.0
        rows.append((o, i, normal, push, cone, along, turn, aside, off, over[o, j], mu))
    found = _shared(rows, force)
    _tilt(found, x)
    several = _several(found)
    if (
        several.size and found.off.any()
    ):  # of what polygons have once it is known which way each rubs
        _split_at(found, several, np.array([row[9] for row in rows]), force)
        _tilt(found, x)
    return found


def _tilt(found: Contacts, x: Floats) -> None:
    """Put the coefficients of friction of nodes that act as arcs, the way they rub."""
    for row in np.flatnonzero(found.off).tolist():
        i, normal, rub = int(found.node[row]), found.normal[row], found.rub[row]
        ahead = pulls_ahead(x, i, *normal.tolist(), *rub.tolist())
        found.friction[row] = tilted(float(found.cone[row]), float(found.off[row]), ahead)


def turn_within(x: Floats, i: int, normal: Floats) -> float:
    """Return the angle by which a rope turns within a surface at a node [rad], of this normal (3,).

    Between what segments before and after it, of places `x` (3, n) [m], are along the surface.
    """
    before, after = x[:, i] - x[:, i - 1], x[:, i + 1] - x[:, i]
    into, out = (way - normal * (normal @ way) for way in (before, after))
    return abs(math.atan2(float(normal @ np.cross(into, out)), float(into @ out)))


def within_reach(
    table: Obstacles, nodes: Ints, x: Floats, v: Floats, t: float, span: float = 0.0
) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """Return velocities of m nodes beside obstacles, (k, m, 3) twice [m/s], and which may touch, (k, m).

    The first is that which closes a gap, the second that over the surface. A damper takes hold before the
    surface does, see `closing`: no farther out than the velocity over its stiffness lets it. Where `v` are
    means over the last `span` [s], as those of implicit Euler, both are, too; see `obstacle_lead`.
    """
    count, places, velocities = len(table.kind), x[:, nodes].T, v[:, nodes].T
    speed, over = np.empty((2, count, len(nodes), 3))
    for o in range(count):
        now = np.array(surface_at(table, o, t))
        turning = np.array(rates_of(table, o, now[7]))
        arm = places - now[:3] - table.hub[o]
        speed[o] = velocities - now[3:6] - np.cross(turning[1], arm)
        over[o] = speed[o] - np.cross(turning[0], arm)
        if 0.0 < span <= t:
            ahead, turning_on = beyond_mean(table, o, t, span, arm)
            speed[o] += ahead
            over[o] += ahead + turning_on
    gaps = np.empty((count, len(nodes)))
    find_gaps(np.ascontiguousarray(places.T), table, t, gaps)
    damping = table.ratio[:, None] * table.damping[:, nodes]
    lead = damping / table.stiffness[:, nodes] * np.linalg.norm(speed, axis=2)
    room = gaps - table.thickness[nodes]
    return speed, over, room <= (1.0 + 1e-9) * lead


def beyond_mean(
    table: Obstacles, o: int, t: float, span: float, arms: Floats
) -> tuple[Floats, Floats]:
    """Return how far a body's velocities are from their means over `span` [s] before `t`, (3,), (m, 3) [m/s].

    That of its hub, and what its turning adds at places (m, 3) from that [m] at `t`, which go along with it.
    """
    now, before = (np.array(surface_at(table, o, time)) for time in (t, t - span))
    axle, turn = table.axle[o], now[6] - before[6]
    aside = np.cross(axle, arms)
    chord = math.sin(turn) * aside - (1.0 - math.cos(turn)) * np.cross(axle, aside)
    return now[3:6] - (now[:3] - before[:3]) / span, now[7] * aside - chord / span


def at_rates(table: Obstacles, wheels: Floats, t: float, span: float = 0.0) -> Obstacles:
    """Return the same obstacles, those that turn freely as recorded at time `t` [s], rows of `RECORDED`.

    They have turned at their rate for `span` [s]: of a run by implicit Euler that is so for its step.
    """
    spin, params = table.spin.copy(), table.turns.params.copy()
    free = table.wheel >= 0
    which = table.wheel[free]
    spin[free] = 0.0, t - span, np.inf
    spin[free, 0] = wheels[which, 1]
    params[free, 0] = wheels[which, 0] - wheels[which, 1] * (t - spin[free, 1])
    turns = table.turns._replace(params=params)
    return table._replace(spin=spin, turns=turns, wheel=np.full_like(table.wheel, -1))


def _shared(rows: list[_Row], force: Floats) -> Contacts:
    """Return the contacts with their friction, the rest of the force once all pushes are taken off."""
    count = len(rows)
    node = np.array([row[1] for row in rows], np.int64)
    normal = np.array([row[2] for row in rows]).reshape(count, 3)
    push = np.array([row[3] for row in rows], np.float64)
    friction = np.array([row[4] for row in rows], np.float64)
    most = friction * push
    rest, able = force.T.copy(), np.zeros(force.shape[1])
    np.add.at(rest, node, -push[:, None] * normal)
    np.add.at(able, node, most)
    share = np.divide(most, able[node], out=np.zeros(count), where=able[node] > 0.0)
    rub = share[:, None] * rest[node]
    rub -= (rub * normal).sum(axis=1)[:, None] * normal
    found = Contacts(
        obstacle=np.array([row[0] for row in rows], np.int64),
        node=node,
        normal=normal,
        push=push,
        turn=np.array([row[6] for row in rows], np.float64),
        aside=np.array([row[7] for row in rows], np.float64),
        rub=rub,
        friction=friction,
        slip=np.array([row[5] for row in rows]).reshape(count, 3),
        cone=friction.copy(),
        off=np.array([row[8] for row in rows], np.float64),
        given=np.array([row[10] for row in rows], np.float64),
    )
    _split_at(found, _several(found), np.array([row[9] for row in rows]), force)
    return found


def _several(found: Contacts) -> Ints:
    """Return the nodes that more than one surface rubs."""
    return np.flatnonzero(np.bincount(found.node[found.friction * found.push > 0.0]) > 1)


def _split_at(found: Contacts, nodes: Ints, over: Floats, force: Floats) -> None:
    """Put what rubs at nodes on several surfaces; `over` (c, 3) are velocities over them, none taken off."""
    for i in nodes.tolist():
        here = np.flatnonzero(found.node == i)
        normal, push, slip = found.normal[here], found.push[here], found.slip[here]
        slides = that_slide(slip, over[here], STILL)
        rest, most = force[:, i] - push @ normal, found.friction[here] * push
        found.rub[here] = split(normal, most, rest, slip, slides)
