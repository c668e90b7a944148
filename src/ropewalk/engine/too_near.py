"""What contacts say of a run that cannot go on."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Ints, State
from ropewalk.laws.pairs.table import CONTACTS, CROWDED, FAULT, FIRST, PASSED, REFUSED, SECOND
from ropewalk.lowering import Layout, Plan
from ropewalk.lowering.obstacle_checks import longest_kept_out
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Obstacle, Scene
from ropewalk.scene.obstacles import name_of
from ropewalk.words.safe_side import rounded_down

_FINER = 0.1  # [1] of the longest step that `adaptive` took


def finer(plan: Plan, longest: float = 0.0) -> tuple[str, ...]:
    """Name what lets a method look closer, as things to try: its step, or its tolerance.

    `longest` [s] is the longest step that `adaptive` took; for it a time_step is the longest it may take.
    """
    if plan.tolerance is None:
        return (f"a time_step below {1e3 * plan.dt:.3g} ms",)
    most = f" of {1e3 * _FINER * longest:.1g} ms or less" if longest > 0.0 else ""
    return (
        f"a tolerance below {1e3 * plan.tolerance:.3g} mm",
        f"a shorter longest step (a time_step{most})",
    )


def _watched(plan: Plan) -> tuple[str, ...]:
    """Name a method that sees to it that nothing passes, where this one does not."""
    return () if METHODS[plan.method].implicit else ("implicit-euler",)


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


def one_of(*helps: str) -> str:
    """Return things to try in a row."""
    first = ", ".join(helps[:-1])
    return f"{first}, or {helps[-1]}" if first else helps[-1]


def passing(
    which: Ints, state: State, layout: Layout, scene: Scene, closer: tuple[str, ...]
) -> tuple[str, str]:
    """Say what goes through which obstacle, and what helps in this scene; "" twice where nothing does.

    `which` is `Memory.through` of the obstacles, or its `fault`; `closer` is what lets the method look
    closer, see `finer`.
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
        return what, one_of(*closer, *slower, "a stiffer contact (its compliance)")
    made = next(one for one in scene.ropes if one.name == rope)
    short = longest_kept_out(body, made)
    what = (
        f"segment {node} of rope {rope!r} would go through obstacle {name!r} between its two nodes, where "
        "nothing holds it"
    )
    long = float(np.linalg.norm(state.x[:, index + 1] - state.x[:, index]))
    if long <= short:  # that is not it: something comes too fast
        return what, one_of(*closer, *slower)
    more = (
        f"more segments (at most {rounded_down(1e3 * short)} mm long, this one is {1e3 * long:.3g})"
    )
    if made.segment_length <= short:  # it is this long because it is stretched
        return what, one_of(more, *slower)
    led = any(one.motion.kind != "fixed" for one in (body, *scene.anchors))
    return what, one_of(more, *(["another way for what is led"] if led else []))


def fault_of(state: State, layout: Layout, scene: Scene, plan: Plan) -> str:
    """Say what is wrong with the contacts; "" for nothing."""
    closer = *_watched(plan), *finer(plan)
    through, helps = passing(state.memory.obstacle.fault, state, layout, scene, closer)
    if through:
        return f"{through.replace('would go', 'has gone')}: take {helps}"
    count = state.memory.contact.tally
    if not count.size or count[FAULT] == 0:
        return ""
    if count[FAULT] == PASSED:
        return (
            f"{pair_of(state, layout)} came nearer to each other in a step than half the sum of "
            "their radii, or half as near as they were, and may have passed through each other: take "
            f"{one_of(*closer, *_slower(scene))}"
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


def refused_pair(
    state: State, layout: Layout, scene: Scene, plan: Plan, longest: float = 0.0
) -> str:
    """Say between whom the last step was not let pass; "" where that was not why it ended.

    `longest` [s] as in `finer`.
    """
    count, closer = state.memory.contact.tally, finer(plan, longest)
    if fault := fault_of(state, layout, scene, plan):
        return fault
    through, helps = passing(state.memory.obstacle.through, state, layout, scene, closer)
    if through:
        return f"{through}. Try {helps}"
    if not count.size or count[REFUSED] == 0:
        return ""
    helps = one_of(*closer, *_slower(scene), "a stiffer contact (contact.compliance)")
    return (
        f"{pair_of(state, layout)} would come too near to each other, or pass through each other. "
        f"Try {helps}"
    )
