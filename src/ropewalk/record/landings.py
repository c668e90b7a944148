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
from ropewalk.lowering import Span
from ropewalk.record.body_loads import is_apart, of_nodes
from ropewalk.record.facts import FINISHED
from ropewalk.scene import Rope

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_PIECE = 256  # frames that are read at once
_STRAIGHT = 0.95  # cosine of 18 degrees: of the column's segments to the push, friction with it


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


def hardest_landing(result: Result) -> Landing | None:
    """Return the landing of a rope's end that gives most; None where none is seen.

    Of ropes that push, on obstacles that stand still, by ends that bear no load and are not held. A contact
    of stiffness k takes its time: in that until the wave is back, 2 L / c, it comes to
    1 - exp(-2 k L / (c Z)) of v Z, Z = sqrt(EA mu), and to more with its damper.
    """
    scene = result.scene
    if result.status != FINISHED or "contact_force" not in result.source.names:
        return None
    still = all(body.motion.kind == "fixed" and body.spin is None for body in scene.obstacles)
    if not scene.obstacles or not still or not is_apart(result):
        return None
    found = [one for rope in scene.ropes if _pushes(rope) for one in _of_rope(result, rope)]
    return max(found, key=lambda one: one.force, default=None)


def _pushes(rope: Rope) -> bool:
    return rope.made_of.kind == "material" and not rope.rigid and not rope.made_of.tension_only


def _of_rope(result: Result, rope: Rope) -> Iterator[Landing]:
    """Yield the landings of a rope's two ends."""
    span, layout = result.layout.span(rope.name), result.layout
    given = [one.node for one in rope.loads] + [one.node for one in rope.forces]
    loaded = {span.first + rope.node_index(node) for node in given}
    if span.spare_start or span.spare_end:  # what a winch winds has no length of its own
        return
    for end, other, way in ((span.first, span.last, 1), (span.last, span.first, -1)):
        if end in loaded or end in layout.anchor_nodes or end in layout.tied_nodes:
            continue
        for first in range(0, result.good_frames - 1, _PIECE):
            last = min(first + _PIECE + 1, result.good_frames)
            force = np.nan_to_num(result.read(of_nodes(result), first, last)[:, end])
            there = np.linalg.norm(force, axis=1) > 0.0
            for k in np.flatnonzero(there[1:] & ~there[:-1]).tolist():
                normal = force[k + 1] / np.linalg.norm(force[k + 1])
                if one := _landing(result, (rope, span), (end, way), normal, first + k):
                    held = other in layout.anchor_nodes
                    yield one if held else one._replace(held=0.0)


def _landing(
    result: Result, of: tuple[Rope, Span], end: tuple[int, int], normal: Floats, frame: int
) -> Landing | None:
    """Return what an end gives that an obstacle pushes along `normal` [1] in the frame after this one."""
    (rope, span), (node, way) = of, end
    from ropewalk.record.contacts import model_of

    rows = slice(span.first, span.last + 1)
    x = result.read("positions", frame, frame + 1)[0, rows][::way]
    v = result.read("velocities", frame, frame + 1)[0, rows][::way]
    steps = np.diff(x, axis=0)
    along = (steps @ normal) / np.linalg.norm(steps, axis=1)
    straight = int(np.argmin(np.append(along >= _STRAIGHT, False)))
    speed = float((-v[: straight + 1] @ normal).min())
    if straight < 1 or not speed > 0.0:
        return None
    mu, stiff = (
        rope.own_mass / rope.length_unstretched,
        rope.segment_stiffness * rope.segment_length,
    )
    impedance, back = (
        math.sqrt(stiff * mu),
        2.0 * straight * rope.segment_length * math.sqrt(mu / stiff),
    )
    contact = float(model_of(result).system.node.obstacle.stiffness[:, node].min())
    force = -speed * impedance * math.expm1(-contact * back / impedance) * float(along[0]) ** 2
    weight = rope.total_mass * math.hypot(*result.scene.gravity)
    held = 2.0 * force - weight if straight == rope.segments else 0.0
    return Landing(
        rope.name, speed, force, max(held, 0.0), speed * impedance, float(result.time[frame])
    )
