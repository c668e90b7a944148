"""Whether ropes turned with friction on so few nodes that their tensions err, see `coarse_turns`."""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle import Obstacles
from ropewalk.lowering.coarse_turns import CoarseTurn, coarse_turn
from ropewalk.lowering.touching import at_rates
from ropewalk.record.contacts import Lying, lying, model_of, touching
from ropewalk.record.quantities import OBSTACLE_FORCE, PULLEYS, has_rope

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_PIECE = 64  # frames that are read at once
_LOOKED_AT = 16  # frames, those in which most may be wrong by the line alone
_TURNS = math.radians(8.0)  # at a node: one that turns by less is not looked at
_TOWARDS = 0.5  # [1] cosine, of the way in which the line turns and what presses
_TOLD = math.log(1.05)  # of the ratio: what goes unsaid, as few frames meet the worst
_PULLS = 0.5  # [1] of a rope's largest tension: with less it tells nothing of that


class Coarse(NamedTuple):
    """Where tensions may err most."""

    frame: int
    wrap: Lying
    turn: CoarseTurn
    pull: float  # the larger tension there [N]


def coarse_note(result: Result) -> str:
    """Say where a rope under much of its tension turned on too few nodes; "" where none did.

    Of the recorded frames in which it turned most.
    """
    found = coarsest(result)
    if found is None:
        return ""
    wrap, body = found.wrap, result.scene.obstacles[found.wrap.obstacle]
    name, count = result.layout.ropes[wrap.rope].name, wrap.last - wrap.first + 1
    lay = "one node lay" if count == 1 else f"{count} nodes lay"
    ratio = f"{wrap.ratio:.4g}, by its friction alone {wrap.at_slip:.4g} at most"
    return (
        f"at t = {result.time[found.frame]:.6g} s rope {name!r} turned by {math.degrees(wrap.angle):.3g} "
        f"degrees on {body.name!r}, where {lay}: with so few on a turn the ratio of its tensions ({ratio}) "
        f"may err {found.turn.most}, and jumps as nodes come and go; {found.turn.remedy}"
    )


def coarsest(result: Result) -> Coarse | None:
    """Return where most of a tension may be wrong; None where its ratio is known to 5 %, or nothing slips."""
    rubs = any(
        body.friction_with(rope) > 0.0
        for body in result.scene.obstacles
        for rope in result.scene.ropes
    )
    if not rubs or "contact_force" not in result.source.names:
        return None
    frames, largest = _frames(result)
    if not frames:
        return None
    table, worst, most = model_of(result).system.node.obstacle, None, 0.0
    for frame in frames:
        for one in _of_frame(result, table, frame):
            span = result.layout.ropes[one.wrap.rope]
            if one.pull < _PULLS * largest[span.first : span.last].max():
                continue
            if one.turn.error * one.pull > most:
                worst, most = one, one.turn.error * one.pull
    return worst


def _of_frame(result: Result, table: Obstacles, frame: int) -> Iterator[Coarse]:
    """Yield the stretches of ropes on obstacles at a frame that slip, or may, with too few nodes."""

    def read(name: str) -> Floats:
        return result.read(name, frame, frame + 1)

    scene, t = result.scene, float(result.time[frame])
    x, v, force = (
        np.ascontiguousarray(read(name)[0].T)
        for name in ("positions", "velocities", _force(result))
    )
    changes = "rest_length" in result.source.names
    rest = read("rest_length") if changes else result.rest_length[frame : frame + 1]
    there = has_rope(result.layout, rest, [rope.segment_length for rope in scene.ropes])[0]
    wheels = read(PULLEYS)[0] if result.layout.pulleys else None
    now = table if wheels is None else at_rates(table, wheels, t)
    contacts = touching(now, x, v, force, there, None, t)
    for wrap in lying(scene, result.layout, contacts, read("tension")[0]):
        rope = scene.rope_named(result.layout.ropes[wrap.rope].name)
        friction = scene.obstacles[wrap.obstacle].friction_with(rope)
        turn = coarse_turn(now, contacts, wrap.rows, x, friction, rope.segment_length, t)
        # What is farther from slipping than it may err is held, whatever friction allows; NaN: pulls nothing.
        slips = math.log(wrap.ratio) + turn.error >= math.log(wrap.at_slip)
        if turn.error > _TOLD and slips:
            yield Coarse(frame, wrap, turn, max(wrap.before, wrap.after))


def _force(result: Result) -> str:
    """Return the name of the force of obstacles; in old runs that of ropes on ropes is in it."""
    return OBSTACLE_FORCE if OBSTACLE_FORCE in result.source.names else "contact_force"


def _frames(result: Result) -> tuple[list[int], Floats]:
    """Return the frames to look at, and the largest tension of every segment, (s,) [N].

    Those with the largest sum, over nodes that something presses on the inside of a turn, of tension times
    the turn squared.
    """
    name = _force(result)
    ends = [node for rope in result.layout.ropes for node in (rope.first, rope.last)]
    scores: list[tuple[float, int]] = []
    largest = np.zeros(result.layout.nodes - 1)
    for first in range(0, result.good_frames, _PIECE):
        last = min(first + _PIECE, result.good_frames)
        tension = np.nan_to_num(result.read("tension", first, last))
        largest = np.maximum(largest, tension.max(axis=0))
        force = result.read(name, first, last)
        touches = np.asarray(force.any(axis=2))
        touches[:, ends] = False
        row, node = np.nonzero(touches)
        if not row.size:
            continue
        x = result.read("positions", first, last)
        into, out = (_unit(x[row, node + n] - x[row, node + n - 1]) for n in (0, 1))
        bent, press = out - into, force[row, node]
        size = np.linalg.norm(bent, axis=1)
        turn = 2.0 * np.arcsin(np.minimum(0.5 * size, 1.0))
        towards = -(bent * press).sum(axis=1) > _TOWARDS * size * np.linalg.norm(press, axis=1)
        pull = np.maximum(tension[row, node - 1], tension[row, node])
        score = np.where(towards & (turn > _TURNS), pull * turn**2, 0.0)
        of_frame = np.bincount(row, weights=score, minlength=last - first)
        scores += [(float(of_frame[n]), first + n) for n in np.flatnonzero(of_frame).tolist()]
    return sorted(frame for _, frame in heapq.nlargest(_LOOKED_AT, scores)), largest


def _unit(ways: Floats) -> Floats:
    sizes = np.linalg.norm(ways, axis=1, keepdims=True)
    found: Floats = np.divide(ways, sizes, out=np.zeros_like(ways), where=sizes > 0.0)
    return found
