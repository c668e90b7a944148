"""Contacts of a run: who touches what, with what force, and whether it sticks; from what was recorded."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import as_at_rest
from ropewalk.laws.pairs.law import memory as pair_memory
from ropewalk.laws.pairs.table import CONTACTS
from ropewalk.lowering import Layout, Model, Span, build
from ropewalk.lowering.touching import Contacts, at_rates, contacts_at, stretches
from ropewalk.methods.kinks import AT, JUST_BELOW, ROUNDING
from ropewalk.record.contact_modes import SLIPS, STICKS, UNKNOWN, WORDS
from ropewalk.record.facts import AT_REST
from ropewalk.record.quantities import OBSTACLE_FORCE, PULLEYS, has_rope
from ropewalk.record.rope_contact_table import modes_on_ropes

if TYPE_CHECKING:
    from ropewalk.record.result import Result
    from ropewalk.scene import Scene

RANK = np.array(
    [0, 1, 3, 2], np.int8
)  # of the modes: what slips for sure shows before what is not known


TURNS = 0.01  # of what a rope turns in one stretch on an obstacle; one with less only grazes it [1]


class WrapHistory(NamedTuple):
    """What a rope does on an obstacle in the course of a run, one row a frame.

    A rope may leave it and come back: the angle is that of all stretches on it, what the rope turns by
    between them left out, and the tensions are those before the first and after the last of them. What acts
    on the rope between two stretches, as the other block of a tackle, is in those tensions and not in the
    angle, so that of several stretches there is no ratio: the table ``wraps`` has each on its own. After the
    rope broke angle and tensions are NaN. What a winch pays out has numbers below 0, or beyond the last.
    """

    time: Floats  # (frames,) [s]
    nodes: Ints  # (frames, 2) first and last node of those stretches; 0 and -1, the last first: none touches
    angle: Floats  # (frames,) by which the rope turns there towards the obstacle [rad]
    before: Floats  # (frames,) tension of the segment before the first of them [N]
    after: Floats  # (frames,) ... after the last one [N]
    parts: Ints  # (frames,) how many stretches there are

    @property
    def touches(self) -> NDArray[np.bool_]:
        """Whether the rope touches the obstacle, (frames,)."""
        return self.nodes[:, 0] <= self.nodes[:, 1]

    @property
    def ratio(self) -> Floats:
        """The tension after over that before [1]; NaN where there is none, and of several stretches."""
        found: Floats = np.full(self.time.shape, np.nan)
        one = (self.before > 0.0) & (self.parts == 1)
        np.divide(self.after, self.before, out=found, where=one)
        return found


def contact_modes(result: Result, frames: Sequence[int] | None = None) -> NDArray[np.int8]:
    """Return what nodes do, (frames, nodes), by place in MODES: 0 where one touches no obstacle.

    1 sticks, 2 slips, 3 unknown (see `Result.contact_modes`), -1 after its rope broke. Of some `frames`
    only. Of several obstacles at one node: slips before unknown before sticks.
    """
    wanted = range(result.frames) if frames is None else frames
    rows = {int(frame): row for row, frame in enumerate(wanted)}
    found = np.zeros((len(rows), result.layout.nodes), np.int8)
    for frame, contacts in each_frame(result, wanted):
        np.maximum.at(found[rows[frame]], contacts.node, RANK[_modes(contacts)])
    ranked: NDArray[np.int8] = RANK[found]  # which is its own inverse
    _leave_broken(result, wanted, ranked)
    return ranked


def _leave_broken(result: Result, frames: Iterable[int], modes: NDArray[np.int8]) -> None:
    """Put -1, not known, for nodes of ropes that had broken at these frames, (frames, nodes)."""
    for span in result.layout.ropes:
        modes[np.array(frames) >= _broken_from(result, span), span.first : span.last + 1] = -1


def _broken_from(result: Result, span: Span) -> int:
    """Return the first frame in which a rope has no numbers since it broke; beyond the last: it has."""
    if result.facts.keep_going:
        return result.frames
    return next((end.frames for end in result.ends if span.name in end.ropes), result.frames)


def node_modes(result: Result, frames: Sequence[int] | None = None) -> NDArray[np.int8]:
    """Return what every node does on obstacles or ropes, (frames, nodes), by place in MODES.

    Of several contacts of one node: slips before unknown before sticks; -1 after its rope broke.
    """
    wanted = range(result.frames) if frames is None else frames
    both = np.stack([contact_modes(result, wanted), modes_on_ropes(result, wanted)])
    both = np.maximum(both, 0)
    found: NDArray[np.int8] = np.take_along_axis(both, RANK[both].argmax(axis=0)[None], axis=0)[0]
    _leave_broken(result, wanted, found)
    return found


def _modes(contacts: Contacts) -> NDArray[np.int8]:
    """Return the place in MODES of every contact, (c,)."""
    modes = np.where(contacts.slips, SLIPS, STICKS).astype(np.int8)
    modes[np.isnan(contacts.use)] = UNKNOWN
    return modes


def wrap_history(result: Result, rope: str | None, obstacle: str) -> WrapHistory:
    """Return how a rope lies on an obstacle at each frame. Raises KeyError for an unknown name."""
    names = [body.name for body in result.scene.obstacles]
    if obstacle not in names:
        raise KeyError(
            f"name one of the obstacles {', '.join(names) or '(none)'}, not {obstacle!r}"
        )
    o, span = names.index(obstacle), result.layout.span(rope)
    count = result.frames
    nodes = np.tile(np.array([0, -1], np.int64), (count, 1))
    angle, before, after = np.zeros((3, count))
    several = np.zeros(count, np.int64)
    tension = result.tension
    for frame, contacts in each_frame(result, range(count), [o]):
        own = (contacts.node >= span.first) & (contacts.node <= span.last)
        touching = _that_turn(contacts, np.flatnonzero(own & (contacts.obstacle == o)))
        if not touching.size:
            continue
        lies = _lies(span, contacts, touching, tension[frame])
        nodes[frame], (angle[frame], before[frame], after[frame]) = lies[:2], lies[2:]
        several[frame] = len(stretches(contacts, touching))
    broken = _broken_from(result, span)
    nodes[broken:], several[broken:] = (0, -1), 0
    angle[broken:] = before[broken:] = after[broken:] = np.nan
    return WrapHistory(np.asarray(result.time), nodes, angle, before, after, several)


def _that_turn(contacts: Contacts, rows: Ints) -> Ints:
    """Return the rows of the stretches in which a rope turns towards the obstacle; all if it does in none."""
    parts = stretches(contacts, rows)
    turns = np.array([contacts.turn[part].sum() for part in parts])
    most = turns.max(initial=0.0)
    return np.concatenate(
        [rows[:0], *(p for p, a in zip(parts, turns, strict=True) if a >= TURNS * most)]
    )


class Lying(NamedTuple):
    """One stretch of a rope on one obstacle at one time."""

    rope: int  # its number
    obstacle: int
    rows: Ints  # of its contacts
    first: int  # node of the rope
    last: int
    angle: float  # by which the rope turns there towards the obstacle [rad]
    before: float  # tension of the segment before the first node [N]; 0 at the rope's end
    after: float  # ... after the last node
    at_slip: float  # ratio of tensions at which it slips, see `Contacts.at_slip` [1]

    @property
    def ratio(self) -> float:
        """The larger tension over the smaller [1]; NaN where that pulls nothing."""
        low, high = sorted((self.before, self.after))
        return high / low if low > 0.0 else np.nan


def lying(
    scene: Scene,
    layout: Layout,
    contacts: Contacts,
    tension: Floats,
    only: Sequence[int] | None = None,
) -> Iterator[Lying]:
    """Yield the stretches of ropes on obstacles, rope by rope, from contacts and tensions (s,) [N].

    With `only` those on some obstacles.
    """
    for number, span in enumerate(layout.ropes):
        own = (contacts.node >= span.first) & (contacts.node <= span.last)
        for o in np.unique(contacts.obstacle[own]).tolist():
            if only is not None and o not in only:
                continue
            mu = scene.obstacles[o].friction_with(scene.rope_named(span.name))
            for here in stretches(contacts, np.flatnonzero(own & (contacts.obstacle == o))):
                lies = _lies(span, contacts, here, tension)
                yield Lying(number, o, here, *lies, contacts.at_slip(mu, here))


def _lies(
    span: Span, contacts: Contacts, rows: Ints, tension: Floats
) -> tuple[int, int, float, float, float]:
    """Return first and last node of rows of contacts, the angle there, the tensions before and after."""
    first, last = int(contacts.node[rows].min()), int(contacts.node[rows].max())
    angle = float(contacts.turn[rows].sum())
    before = float(tension[first - 1]) if first > span.first else 0.0
    after = float(tension[last]) if last < span.last else 0.0
    return first - span.start, last - span.start, angle, before, after


def each_frame(
    result: Result, frames: Iterable[int], only: Sequence[int] | None = None
) -> Iterator[tuple[int, Contacts]]:
    """Return the frames of those given in which something touches, with their contacts.

    With `only` some obstacles, the contacts of nodes that may touch one of them.
    """
    if "contact_force" not in result.source.names:
        return
    model = model_of(result)
    table, rest = model.system.node.obstacle, result.rest_length
    lengths = [rope.segment_length for rope in result.scene.ropes]
    apart = OBSTACLE_FORCE in result.source.names
    force = result.obstacle_force if apart else result.contact_force
    x, v = result.positions, result.velocities
    turning = result.read(PULLEYS) if result.layout.pulleys else None
    for frame in map(int, frames):
        if force[frame].any():
            now = [np.ascontiguousarray(part[frame].T) for part in (x, v, force)]
            t, span = seen_at(model, float(result.time[frame]))
            wheels = None if turning is None else turning[frame]
            there = has_rope(result.layout, rest[frame : frame + 1], lengths)[0]
            contacts = touching(table, now[0], now[1], now[2], there, wheels, t, only, span)
            yield frame, contacts if apart else without_ropes(model, now[0], contacts)


def seen_at(model: Model, t: float) -> tuple[float, float]:
    """Return the time just before which forces at a frame at `t` [s] were taken, for `surface_at`.

    And over which time velocities are means there [s], see `touching`. Steps end just before a kink, such as
    where a drum begins to turn (`methods.kinks`): what rubs then rubs on the drum that stands.
    """
    method, dt, kinks = model.plan.method, model.plan.dt, model.system.kinks
    if method == "semi-implicit-euler":  # its steps are not cut
        return t, 0.0
    here = int(np.searchsorted(kinks, t - (little := max(AT * dt, ROUNDING * t))))
    before = float(kinks[here - 1]) if here > 0 else 0.0
    span = min(dt, t - before) if method == "implicit-euler" else 0.0
    if here < len(kinks) and kinks[here] <= t + little:
        t = min(t, float(kinks[here]) * JUST_BELOW)
    return t, span


def touching(
    table: Obstacles,
    x: Floats,
    v: Floats,
    force: Floats,
    there: NDArray[np.bool_],
    wheels: Floats | None,
    t: float,
    only: Sequence[int] | None = None,
    span: float = 0.0,
) -> Contacts:
    """Return the contacts at one time [s], from places, velocities and obstacles' forces (3, n) [m, m/s, N].

    `there` (s,) tells which segments are rope, neither on a drum nor parted; `wheels` are rows of
    `wheel_rows.RECORDED`, None where nothing turns freely; for `only` and `span` see `contacts_at`.
    """
    then = table if wheels is None else at_rates(table, wheels, t, span)
    return contacts_at(then, x, v, force, there.astype(float), t, only, span)


def without_ropes(model: Model, x: Floats, contacts: Contacts) -> Contacts:
    """Return the contacts of nodes at places (3, n) [m] with NaN for friction where a rope is touched, too.

    For runs that were recorded before the force of obstacles was kept apart from that of ropes.
    """
    if model.scene.contact is None:
        return contacts
    found = pair_memory(model.system.node.contact, x, model.state.stiffness)
    pairs = found.pair[: found.tally[CONTACTS]].ravel()
    touches = np.zeros(x.shape[1], bool)
    touches[pairs] = touches[pairs + 1] = True
    return contacts._replace(rub=np.where(touches[contacts.node, None], np.nan, contacts.rub))


def model_of(result: Result) -> Model:
    """Return the model of a result's scene in its drawn shape; of an equilibrium obstacles stand in it.

    Its steps are not judged: they have been taken, or none were.
    """
    run = result.scene.run.model_copy(update={"start": "shape", "ring": None})
    scene = result.scene.model_copy(update={"run": run})
    model = build(scene, drawn=False, stepped=False)
    return replace(model, system=as_at_rest(model.system)) if result.status == AT_REST else model


COLUMNS = (
    *("time [s]", "rope", "node", "obstacle", "normal force [N]", "friction force [N]"),
    *("friction used [1]", "slip speed [m/s]", "friction power [W]", "mode"),
    *("x [m]", "y [m]", "z [m]", "fx [N]", "fy [N]", "fz [N]"),  # of the node; on it
)


def rows(result: Result, frames: Iterable[int], nodes: Ints) -> list[NDArray[np.generic]]:
    """Return the columns of the table of contacts, of some frames and nodes."""
    names = np.array([body.name for body in result.scene.obstacles], dtype=object)
    labels = [result.layout.rope_of(i) for i in range(result.layout.nodes)]
    ropes = np.array([rope for rope, _ in labels], dtype=object)
    numbers = np.array([number for _, number in labels])
    found: list[list[NDArray[np.generic]]] = [[] for _ in COLUMNS]
    wanted = np.zeros(result.layout.nodes, bool)
    wanted[nodes] = True
    places = result.positions
    for frame, contacts in each_frame(result, frames):
        keep = wanted[contacts.node]
        force = contacts.push[:, None] * contacts.normal + contacts.rub
        parts = (
            *(np.full(keep.size, result.time[frame]), ropes[contacts.node], numbers[contacts.node]),
            *(names[contacts.obstacle], contacts.push, np.linalg.norm(contacts.rub, axis=1)),
            *(contacts.use, np.linalg.norm(contacts.slip, axis=1)),
            *((contacts.rub * contacts.slip).sum(axis=1), WORDS[_modes(contacts)]),
            *(*places[frame, contacts.node].T, *force.T),
        )
        for column, part in zip(found, parts, strict=True):
            column.append(part[keep])
    empty = np.zeros(0)
    return [np.concatenate(column) if column else empty for column in found]
