"""The energy error of ropes whose anchors are all accelerated alike, as who goes along with them sees it.

Seen at rest it holds what carrying the ropes is booked by: an anchor has its own velocity, a node that only
goes along that of the method. Of links that hang still below a shaken hand implicit Euler loses M a^2 h / 2 a
second, many times the energy of all that moves there. Who goes along sees no work of anchors, but that of
weight and inertia, (g - a) . d(M r), with r of the centre of mass from the anchor.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.acting import section_of
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.lowering.masses import line, masses
from ropewalk.methods.recording import CONSERVATIVE
from ropewalk.methods.registry import METHODS
from ropewalk.record.balances import hardly_any

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_VALUES = 1_000_000  # numbers of one quantity looked at together
_LITTLE = 0.5  # [1] of the error as seen at rest
_LOOKS = 20  # steps and frames to a swing, at least: fewer may see each swing at the same places, or blur it
_ROUNDING = 1e-6  # [1] of a frame's length
_STILL = 1e-6  # [1] of the length: what solving leaves of links that go nowhere
_RESOLVED = (
    0.01  # [1] of the energy turned over: what half the frames may make of the work of inertia
)


class Along(NamedTuple):
    """What is seen from the anchors."""

    error: Floats  # (frames,) [J]
    turned: float  # energy turned over [J]; 0: nothing that links and steps could tell from the anchors' way


def accelerated_alike(result: Result) -> bool:
    """Tell whether anchors are all that moves ropes, and swing alike, in steps and frames that follow them.

    A table's way may jump within a step or a frame, with nothing of it to be seen in either.
    """
    scene, method, plan = result.scene, METHODS.get(result.plan.method), result.plan
    if method is None or not method.implicit or not scene.anchors or scene.winches or scene.limiter:
        return False
    first = scene.anchors[0].motion
    if not (first.kind == "shake" or (first.kind == "orbit" and len(scene.anchors) == 1)):
        return False
    longest = float(np.diff(result.time).max(initial=plan.dt if plan.tolerance is None else 0.0))
    resolved = longest * abs(first.frequency) * _LOOKS <= 1.0 + _ROUNDING
    acts = any(section_of(law, scene) for law in NODE_LAWS)
    alike = all(one.motion == first and one.release_time is None for one in scene.anchors)
    return resolved and alike and not (acts or scene.parts or result.ends or result.layout.pulleys)


def seen_along(result: Result) -> Along | None:
    """Return what is seen from the anchors; None of all other runs, and where frames do not resolve it.

    Of ropes that are held all the time. Links that move by no more than what anchors gain in a step, and get
    nowhere, count as still: so much the velocities of their nodes lag behind.
    """
    good = result.good_frames
    if good < 3 or not accelerated_alike(result) or np.any(result.work["applied"][:good]):
        return None
    if len({result.layout.rope_of(node)[0] for node in result.layout.anchor_nodes}) < len(
        result.layout.ropes
    ):
        return None
    time, gravity = result.time[:good], np.asarray(result.scene.gravity)
    kinetic, speed, arm, mass = _as_a_whole(result, good)
    done = _done(time, speed, arm, gravity)
    forms = [
        part[:good]
        for name, part in result.energy.items()
        if name not in ("kinetic", "gravity", "total")
    ]
    others = [
        work[:good]
        for name, work in result.work.items()
        if name not in CONSERVATIVE and not name.startswith("anchor:")
    ]
    error = kinetic + np.sum(forms, axis=0) - done - np.sum(others, axis=0)
    turned = max(float(np.ptp(part)) for part in (kinetic, done, *forms))
    coarse = _done(time[::2], speed[::2], arm[::2], gravity)
    least = _of_a_step(result, time, speed, arm, mass)
    apart = float(np.abs(coarse - done[::2]).max())
    if not math.isfinite(turned) or apart > _RESOLVED * max(turned, least):
        return None
    return Along(error - error[0], turned if turned > least else 0.0)


def along_note(result: Result, worst: float) -> str:
    """Say how little of the largest error [J] is of what ropes do beside going along; else ""."""
    along = seen_along(result)
    if along is None or not result.facts.ledger:
        return ""
    own = float(np.abs(along.error).max())
    if not own < _LITTLE * worst or worst <= hardly_any(result.scene):
        return ""
    return (
        f"seen by who goes along with the anchors, which carry all rope alike, it is {own:.3g} J: the rest "
        "is of how it is booked that they carry it, and says nothing of forces"
    )


def _of_a_step(result: Result, time: Floats, speed: Floats, arm: Floats, mass: float) -> float:
    """Return the energy of what anchors gain in a step, where links go nowhere beside them [J]; else 0."""
    ropes, plan = result.scene.ropes, result.plan
    reach = mass * max(rope.length_unstretched for rope in ropes)
    if not all(rope.rigid for rope in ropes) or (np.ptp(arm, axis=0) > _STILL * reach).any():
        return 0.0
    gain = np.linalg.norm(np.gradient(speed, time, axis=0), axis=1).max() * plan.dt
    return 0.5 * mass * float(gain) ** 2


def _as_a_whole(result: Result, good: int) -> tuple[Floats, Floats, Floats, float]:
    """Return the kinetic energy seen from the anchors [J], (frames,), their velocity [m/s], (frames, 3), mass
    times the way from the first one to the centre of mass [kg m], (frames, 3), and the mass of all [kg].
    """
    scene, layout = result.scene, result.layout
    mass, node = (
        masses(layout, tuple(line(rope) for rope in scene.ropes))[0],
        layout.anchor_nodes[0],
    )
    kinetic, speed, arm = np.zeros(good), np.zeros((good, 3)), np.zeros((good, 3))
    step = max(1, _VALUES // (3 * layout.nodes))
    for first in range(0, good, step):
        rows = slice(first, min(first + step, good))
        x, v = (result.read(name, rows.start, rows.stop) for name in ("positions", "velocities"))
        speed[rows] = v[:, node]
        kinetic[rows] = 0.5 * ((v - v[:, node : node + 1]) ** 2).sum(axis=2) @ mass
        arm[rows] = mass @ (x - x[:, node : node + 1])
    return kinetic, speed, arm, float(mass.sum())


def _done(time: Floats, speed: Floats, arm: Floats, gravity: Floats) -> Floats:
    """Return the work of weight and inertia since the first frame [J], (frames,).

    By the trapezoidal rule with its first correction, as a and dr / dt are no straight lines between frames.
    """
    if len(time) < 2:
        return np.zeros(len(time))
    span, ways = np.diff(time), (np.gradient(one, time, axis=0) for one in (speed, arm))
    bends = np.prod([np.diff(way, axis=0) for way in ways], axis=0).sum(axis=1)
    pull = gravity - np.diff(speed, axis=0) / span[:, None]
    done = (pull * np.diff(arm, axis=0)).sum(axis=1) - span * bends / 12.0
    return np.concatenate(([0.0], np.cumsum(done)))
