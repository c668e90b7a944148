"""What a rope's end that lands on an obstacle gives at least, where steps are too long to show it.

A straight column that comes down on its end at v is stopped by a wave that runs up it: it presses with
v sqrt(EA mu) at once, and with twice that at an end that is held. Long implicit steps stop it within one, and
show next to nothing of it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.body_loads import is_apart, of_nodes
from ropewalk.record.facts import FINISHED
from ropewalk.scene import Rope

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_PIECE = 256  # frames that are read at once
_STRAIGHT = 0.95  # cosine of 18 degrees: of the column's segments to the push, friction with it


class _End(NamedTuple):
    """An end of a rope that nothing holds or loads."""

    rope: Rope
    rows: slice  # of its rope's nodes
    way: int  # 1 for its first node, -1 for its last
    node: int
    held_until: float  # [s] its other end; see `_held_until`


class Landing(NamedTuple):
    """An end of a rope that has landed on an obstacle between two frames, and presses with this at least."""

    rope: str
    speed: float  # of the column towards the obstacle [m/s]
    force: float  # on the obstacle [N]
    held: float  # on an anchor at its other end, the rope's weight taken off [N]; 0: none is told
    hard: float  # on an obstacle that does not give [N]
    time: float  # [s] of the frame before

    def words(self, least: float, by: str) -> str:
        """Return that there was at least this force [N], and what does not show it, `by`."""
        return (
            f"too low: it was {least:.3g} N at least. After t = {self.time:.6g} s an end of rope "
            f"{self.rope!r} lands at {self.speed:.3g} m/s; a column that is stopped on its end gives "
            f"v sqrt(EA mu), {self.hard:.3g} N where nothing gives, at once, and twice that at a held end, "
            f"which {by} do not show"
        )


def landings_of(result: Result) -> tuple[Landing, ...]:
    """Return the landings of ropes' ends.

    Of ropes that push, on obstacles that stand still, by ends that bear no load and are not held. A contact
    of stiffness k takes its time: in that until the wave is back, 2 L / c, it comes to
    1 - exp(-2 k L / (c Z)) of v Z, Z = sqrt(EA mu), and to more with its damper.
    """
    scene = result.scene
    if result.status != FINISHED or "contact_force" not in result.source.names:
        return ()
    still = all(body.motion.kind == "fixed" and body.spin is None for body in scene.obstacles)
    if not scene.obstacles or not still or not is_apart(result):
        return ()
    ends = [end for rope in scene.ropes if _pushes(rope) for end in _free_ends(result, rope)]
    return tuple(_of_ends(result, ends)) if ends else ()


def _pushes(rope: Rope) -> bool:
    return rope.made_of.kind == "material" and not rope.rigid and not rope.made_of.tension_only


def _free_ends(result: Result, rope: Rope) -> Iterator[_End]:
    """Yield the ends of a rope that nothing holds or loads."""
    span, layout = result.layout.span(rope.name), result.layout
    given = [one.node for one in rope.loads] + [one.node for one in rope.forces]
    loaded = {span.first + rope.node_index(node) for node in given}
    if span.spare_start or span.spare_end:  # what a winch winds has no length of its own
        return
    for end, other, way in ((span.first, span.last, 1), (span.last, span.first, -1)):
        if end in loaded or end in layout.anchor_nodes or end in layout.tied_nodes:
            continue
        yield _End(rope, slice(span.first, span.last + 1), way, end, _held_until(result, other))


def _held_until(result: Result, node: int) -> float:
    """Return when the last anchor of a node lets go [s]: infinite for never, negative for none."""
    anchors = zip(result.scene.anchors, result.layout.anchor_nodes, strict=True)
    times = [one.release_time for one, there in anchors if there == node]
    return max((math.inf if time is None else time for time in times), default=-math.inf)


def _of_ends(result: Result, ends: list[_End]) -> Iterator[Landing]:
    """Yield the landings of these ends; everything is read once for all of them."""
    from ropewalk.record.contacts import model_of

    nodes, stiffness = [end.node for end in ends], None
    for first in range(0, result.good_frames - 1, _PIECE):
        last = min(first + _PIECE + 1, result.good_frames)
        force = np.nan_to_num(result.read(of_nodes(result), first, last)[:, nodes])
        there = np.linalg.norm(force, axis=2) > 0.0
        lands = np.argwhere(there[1:] & ~there[:-1]).tolist()
        if not lands:
            continue
        if stiffness is None:
            stiffness = model_of(result).system.node.obstacle.stiffness.min(axis=0)
        x, v = (result.read(name, first, last) for name in ("positions", "velocities"))
        for k, which in lands:
            end, push = ends[which], force[k + 1, which]
            rows = tuple(one[k, end.rows][:: end.way] for one in (x, v))
            times = result.time[first + k : first + k + 2]
            soft = float(stiffness[end.node])
            if one := _landing(result, end, rows, push / np.linalg.norm(push), (soft, times)):
                yield one


def _landing(
    result: Result, end: _End, rows: tuple[Floats, ...], normal: Floats, at: tuple[float, Floats]
) -> Landing | None:
    """Return what an end gives that an obstacle of some stiffness [N/m] pushes along `normal` [1].

    `rows`: places [m] and velocities [m/s] of its rope from it on, in the frame before; `at`: that stiffness,
    and the times of that frame and the next [s].
    """
    rope, (x, v), (contact, (before, after)) = end.rope, rows, at
    steps = np.diff(x, axis=0)
    along = (steps @ normal) / np.linalg.norm(steps, axis=1)
    straight = int(np.argmin(np.append(along >= _STRAIGHT, False)))
    speed = float((-v[: straight + 1] @ normal).min())
    if straight < 1 or not speed > 0.0:
        return None
    mu = rope.own_mass / rope.length_unstretched
    stiff = rope.segment_stiffness * rope.segment_length
    impedance = math.sqrt(stiff * mu)
    back = 2.0 * straight * rope.segment_length * math.sqrt(mu / stiff)
    force = -speed * impedance * math.expm1(-contact * back / impedance) * float(along[0]) ** 2
    weight = rope.total_mass * math.hypot(*result.scene.gravity)
    holds = (
        straight == rope.segments and end.held_until >= after + 0.5 * back
    )  # when the wave is there
    held = max(2.0 * force - weight, 0.0) if holds else 0.0
    return Landing(rope.name, speed, force, held, speed * impedance, float(before))
