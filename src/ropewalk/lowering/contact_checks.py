"""Scenes whose ropes touch each other and cannot be run: methods that cannot, ropes inside each other."""

from __future__ import annotations

from ropewalk.core.arrays import State, System
from ropewalk.laws.pairs.distance import nearest
from ropewalk.laws.pairs.table import FAULT, FULL, NEAR
from ropewalk.lowering.layout import Layout
from ropewalk.lowering.obstacle_checks import RINGING
from ropewalk.lowering.rebound_checks import contact_rebound_faults
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import NO_VALUE, Fault

_DEEPEST = 0.9  # [1] least distance at the start over the sum of the radii


def can_touch(method: str) -> bool:
    """Tell whether a method can work with ropes that touch each other."""
    return method not in RINGING


def refuse_contact(
    scene: Scene, system: System, state: State, layout: Layout, *, drawn: bool = True
) -> None:
    """Raise SceneError for a scene that cannot be run for its contact.

    With `drawn` off ropes get other places than those of the state.
    """
    if scene.contact is None:
        return
    faults, method = [], scene.run.method
    if not can_touch(method):
        able = ", ".join(name for name in METHODS if can_touch(name))
        rule = (
            "cannot work with ropes that touch each other: it keeps stiff modes ringing, so that nothing "
            f"comes to rest; methods that can: {able}"
        )
        faults.append(Fault("run.method", method, rule))
    faults += contact_rebound_faults(scene, system, state)
    faults += _inside(system, state, layout) if drawn else []
    if faults:
        raise SceneError(faults)


def _inside(system: System, state: State, layout: Layout) -> list[Fault]:
    """Return a fault for the two segments that start deepest inside each other, or for too many contacts."""
    table = system.node.contact
    if state.memory.contact.tally[FAULT] == FULL:
        rule = (
            "finds more pairs of segments near each other at the start than there is room for: draw the "
            "ropes apart, or give them fewer segments"
        )
        return [Fault("contact", NO_VALUE, rule)]
    worst, pair = deepest(system, state)
    if worst >= _DEEPEST:
        return []
    (one, a), (other, b) = (layout.rope_of(k) for k in pair)
    size = float(table.radius[pair[0]] + table.radius[pair[1]])
    own = [span.name for span in layout.ropes].index(other)
    rule = (
        f"starts {1e3 * (1.0 - worst) * size:.4g} mm inside segment {a} of rope {one!r}, half of both "
        "diameters counted in: draw the ropes apart"
    )
    return [Fault(f"rope[{own}].shape", f"segment {b}", rule)]


def refuse_tying(scene: Scene) -> None:
    """Raise SceneError where nodes are to be tied while ropes touch: they would be pressed together."""
    if scene.contact is not None:
        rule = "cannot be tied by hand where ropes touch each other: its nodes would be pressed together"
        raise SceneError(
            [Fault("joint", NO_VALUE, f"{rule}; draw it in the scene, or leave out contact")]
        )


def deepest(system: System, state: State) -> tuple[float, tuple[int, int]]:
    """Return the least distance of two segments over the sum of their radii, at most 1, and which."""
    table, memory = system.node.contact, state.memory.contact
    worst, pair = 1.0, (0, 0)
    for i, j in memory.near[: memory.tally[NEAR]]:
        size = float(table.radius[i] + table.radius[j])
        over = nearest(state.x, state.x, 0.0, i, j)[2] / size
        if over < worst:
            worst, pair = over, (int(i), int(j))
    return worst, pair


def refuse_pressing(system: System, state: State, layout: Layout, before: float) -> None:
    """Raise SceneError where a scene with the places of a running one has ropes inside each other.

    `before` is what `deepest` found of the running one.
    """
    if state.memory.contact.tally[FAULT] == FULL:
        raise SceneError(_inside(system, state, layout))
    worst, pair = deepest(system, state)
    if worst >= min(_DEEPEST, before * (1.0 - 1e-9)):
        return
    (one, a), (other, b) = (layout.rope_of(k) for k in pair)
    size = float(system.node.contact.radius[list(pair)].sum())
    rule = (
        f"would have segment {b} {1e3 * (1.0 - worst) * size:.4g} mm inside segment {a} of rope {one!r} "
        "where they lie now, half of both diameters counted in: take a smaller diameter, or pull the ropes "
        "apart first"
    )
    own = [span.name for span in layout.ropes].index(other)
    raise SceneError([Fault(f"rope[{own}].diameter", NO_VALUE, rule)])


def refuse_untying(scene: Scene) -> None:
    """Raise SceneError where a joint is to be cut while ropes touch: its nodes lie inside each other."""
    if scene.contact is not None:
        rule = "stands where ropes touch each other: what it ties lies at one place, and would burst apart"
        raise SceneError(
            [Fault("joint", NO_VALUE, f"{rule}; cut a segment beside it, or leave out contact")]
        )
