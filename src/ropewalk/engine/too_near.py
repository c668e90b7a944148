"""What contacts say of a run that cannot go on."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Ints, State
from ropewalk.laws.obstacle import radius_of
from ropewalk.laws.obstacle_rows import half_thickness
from ropewalk.laws.obstacle_way import LONG
from ropewalk.laws.pairs.table import CONTACTS, CROWDED, FAULT, FIRST, PASSED, REFUSED, SECOND
from ropewalk.lowering import Layout
from ropewalk.scene import Obstacle, Scene
from ropewalk.scene.obstacles import name_of

SHORTER = "a shorter time_step"


def pair_of(state: State, layout: Layout) -> str:
    """Name the two segments that a contact's count points to."""
    count = state.memory.contact.tally
    (one, a), (other, b) = (layout.rope_of(int(count[k])) for k in (FIRST, SECOND))
    return f"segment {a} of rope {one!r} and segment {b} of rope {other!r}"


def _slower(scene: Scene, obstacle: Obstacle | None = None) -> list[str]:
    """Return what moves in a scene, and at one obstacle of it (at all, without one), as a thing to try."""
    led = scene.obstacles if obstacle is None else (obstacle,)
    moving = [
        (
            "slower obstacles" if obstacle is None else "a slower obstacle",
            any(body.motion.kind != "fixed" or _turned(body) for body in led),
        ),
        ("slower anchors", any(one.motion.kind != "fixed" for one in scene.anchors)),
        ("slower winches", any(one.speed != 0.0 for one in scene.winches)),
        ("a slower start", any(rope.kicks or any(rope.shape.velocity) for rope in scene.ropes)),
    ]
    return [words for words, moves in moving if moves]


def _turned(body: Obstacle) -> bool:
    """Tell whether a motor turns an obstacle."""
    return body.spin is not None and not body.spin.free


def _one_of(*helps: str) -> str:
    """Return things to try in a row."""
    first = ", ".join(helps[:-1])
    return f"{first}, or {helps[-1]}" if first else helps[-1]


def passing(which: Ints, state: State, layout: Layout, scene: Scene) -> tuple[str, str]:
    """Say what goes through which obstacle, and what helps in this scene; "" twice where nothing does.

    `which` is `Memory.through` of the obstacles, or its `fault`.
    """
    found = np.flatnonzero(which)
    if not found.size:
        return "", ""
    index = int(found[0])
    rope, node = layout.rope_of(index)
    row = abs(int(which[index])) - 1
    body = scene.obstacles[row]
    name, slower = name_of(body, row), _slower(scene, body)
    if which[index] > 0:
        what = (
            f"node {node} of rope {rope!r} would go through obstacle {name!r}, or too deep into it"
        )
        return what, _one_of(SHORTER, *slower, "a stiffer contact (its compliance)")
    made = next(one for one in scene.ropes if one.name == rope)
    short = LONG * (half_thickness(body) + radius_of(made))
    what = (
        f"segment {node} of rope {rope!r} would go through obstacle {name!r} between its two nodes, where "
        "nothing holds it"
    )
    long = float(np.linalg.norm(state.x[:, index + 1] - state.x[:, index]))
    if long <= short:  # that is not it: something comes too fast
        return what, _one_of(SHORTER, *slower)
    more = f"more segments (at most {1e3 * short:.3g} mm long, this one is {1e3 * long:.3g})"
    if made.segment_length <= short:  # it is this long because it is stretched
        return what, _one_of(more, *slower)
    led = any(one.motion.kind != "fixed" for one in (body, *scene.anchors))
    return what, _one_of(more, *(["another way for what is led"] if led else []))


def fault_of(state: State, layout: Layout, scene: Scene) -> str:
    """Say what is wrong with the contacts; "" for nothing."""
    through, helps = passing(state.memory.obstacle.fault, state, layout, scene)
    if through:
        gone = through.replace("would go", "has gone")
        return f"{gone}: take implicit-euler, {helps}"
    count = state.memory.contact.tally
    if not count.size or count[FAULT] == 0:
        return ""
    if count[FAULT] == PASSED:
        return (
            f"{pair_of(state, layout)} came nearer to each other in a step than half the sum of "
            "their radii, or half as near as they were, and may have passed through each other: take a "
            "shorter time_step, or implicit-euler, which sees to it that nothing passes"
        )
    if count[FAULT] == CROWDED:
        return (
            f"contacts couple more nodes with each other than there is room for to solve their equations, "
            f"{count[CONTACTS]} pairs of segments touch: give the ropes fewer "
            "segments, or let fewer lie in a heap"
        )
    return (
        f"more segments are near each other than there is room for, {count[CONTACTS]} pairs now: no contact "
        "is left out silently; give the ropes fewer segments"
    )


def refused_pair(state: State, layout: Layout, scene: Scene) -> str:
    """Say between whom the last step was not let pass; "" where that was not why it ended."""
    count = state.memory.contact.tally
    if fault := fault_of(state, layout, scene):
        return fault
    through, helps = passing(state.memory.obstacle.through, state, layout, scene)
    if through:
        return f"{through}. Try {helps}"
    if not count.size or count[REFUSED] == 0:
        return ""
    helps = _one_of(SHORTER, *_slower(scene), "a stiffer contact (contact.compliance)")
    return (
        f"{pair_of(state, layout)} would come too near to each other, or pass through each other. "
        f"Try {helps}"
    )
