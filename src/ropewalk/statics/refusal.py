"""Scenes that have no rest shape, or one that nothing determines: what is missing."""

from __future__ import annotations

import itertools

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.acting import at_rest
from ropewalk.laws.node_law import Rest
from ropewalk.lowering import Model, Span
from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.statics.hung import held_nodes
from ropewalk.statics.tied import partners, points, tied_nodes

_ROUNDING = 1e-9  # of a weight: what buoyancy leaves of it by rounding [1]


def unheld_ropes(model: Model) -> tuple[str, ...]:
    """Return the names of the ropes that no anchor holds at time zero, nor another rope that one holds."""
    return tuple(rope.name for rope in model.layout.ropes if not _is_held(model, rope))


def undetermined_ropes(model: Model) -> tuple[str, ...]:
    """Return the names of the ropes that have no rest shape, or any."""
    return tuple(rope.name for rope in model.layout.ropes if _fault_of(model, rope))


def refuse_impossible(model: Model) -> None:
    """Raise SceneError for ropes that have no rest shape, or that nothing gives one."""
    faults = []
    for number, rope in enumerate(model.layout.ropes):
        rule = _fault_of(model, rope)
        if rule:
            faults.append(Fault(f"rope[{number}]", rope.name, rule))
    if faults:
        raise SceneError(faults)


def _fault_of(model: Model, rope: Span) -> str:
    """Return what is missing for one rope to be at rest; "" where nothing is."""
    held = held_nodes(model, rope)
    heavy, rests = bool(np.any(model.system.gravity)), at_rest(model.system)
    if Rest.HOLDS in rests:
        return ""
    if not _is_held(model, rope):
        return _unheld(model, rope, heavy, rests)
    held = sorted({*held, *tied_nodes(model, rope), *_sliding_nodes(model, rope)})
    bends = model.scene.ropes[model.scene.rope_index(rope.name)].bending_stiffness > 0.0
    if Rest.CARRIES in rests or bends or _is_drawn(model, rope):
        return ""
    outer = rope.start != held[0] or rope.end != held[-1]
    slack = any(
        _is_slack(model, a, b) and not _is_laden(model, rope, a, b)
        for a, b in itertools.pairwise(held)
    )
    if outer or slack:
        part = (
            "the part beyond its last anchor" if outer else "it is slack between its anchors, and"
        )
        verb = "has" if outer else "has there"
        lacks = ("weight (buoyancy carries it all)", "weight") if heavy else ("gravity", "gravity")
        return (
            f"{part} {verb} no shape of its own: there is neither {lacks[0]} nor wind, so every shape is "
            f"at rest; give {lacks[1]}, wind, or anchors that stretch it"
        )
    return ""


def _unheld(model: Model, rope: Span, heavy: bool, rests: set[Rest]) -> str:
    named = [anchor for anchor in model.scene.anchors if anchor.rope == rope.name]
    missing = "no anchor holds it"
    if named:
        missing = "all its anchors have let go at time 0 (release_time = 0)"
    windy, remedy = Rest.CARRIES in rests, "hold a node of it with an anchor"
    if windy:
        return f"{missing}: the wind carries it away; {remedy}"
    if not _is_drawn(model, rope):
        acts = "its weight and buoyancy cancel" if heavy else "nothing acts on it"
        return f"{missing}, and {acts}: it is at rest wherever it is; hold a node of it"
    down = weight_left(model, rope) if heavy else 0.0
    if down <= 0.0:
        if model.scene.obstacles:  # forces may draw it onto them
            return ""
        does = "it rises" if down < 0.0 else "a constant force carries it away"
        return f"{missing}: {does}; {remedy}"
    if Rest.BEARS not in rests:
        return f"{missing}, and there is no ground: it falls; {remedy}"
    return ""


def weight_left(model: Model, rope: Span) -> float:
    """Return what draws a rope and all that joints tie to it down, less what lifts them [N]; 0: rounding."""
    ropes = partners(model, rope) if tied_nodes(model, rope) else [rope]
    parts = [_forces_on(model, one) for one in ropes]
    gravity = np.asarray(model.system.gravity)
    size = float(np.linalg.norm(gravity)) or 1.0
    down = sum(float((gravity / size @ (weight + push)).sum()) for weight, push in parts)
    most = sum(float(np.abs(weight).sum()) for weight, _ in parts)
    return down if abs(down) > _ROUNDING * most else 0.0


def _forces_on(model: Model, rope: Span) -> tuple[Floats, Floats]:
    """Return weights and constant forces on a rope's nodes, buoyancy among these, (3, n) [N]."""
    state, own = model.state, slice(rope.start, rope.end + 1)
    return np.outer(model.system.gravity, state.mass[own]), state.forces.applied[:, own]


def _is_drawn(model: Model, rope: Span) -> bool:
    """Whether weight or a constant force acts on a node of the rope that the other does not take up."""
    weight, push = _forces_on(model, rope)
    return bool(np.abs(weight + push).max() > _ROUNDING * np.abs(weight).max())


def _is_laden(model: Model, rope: Span, first: int, last: int) -> bool:
    """Whether weight or a constant force stretches the part of a rope between two nodes, from elsewhere.

    By what slides along the rope or, where an end of the part is not fixed, by what joints tie to it.
    """
    loose = not (_is_fixed(model, first) and _is_fixed(model, last))
    beside = partners(model, rope) if loose else [rope]
    seen = {rope.name}
    while beside:
        one = beside.pop()
        riders = {slide.rope for slide in model.scene.slides if slide.on == one.name} - seen
        beside += [other for name in riders for other in partners(model, model.layout.span(name))]
        seen |= riders
        if one.name != rope.name and _is_drawn(model, one):
            return True
    return False


def _is_fixed(model: Model, node: int) -> bool:
    """Whether an anchor holds a node, or one that a joint ties to it."""
    anchored, number = model.state.anchor_node[model.state.held == 1], points(model)
    if number is None:
        return bool((anchored == node).any())
    return bool((number[anchored] == number[node]).any())


def _is_held(model: Model, rope: Span) -> bool:
    """Whether an anchor holds the rope, or one that it is tied to; or it slides along another."""
    if any(slide.rope == rope.name for slide in model.scene.slides):
        return True
    if not tied_nodes(model, rope):
        return bool(held_nodes(model, rope))
    return any(held_nodes(model, one) for one in partners(model, rope))


def _sliding_nodes(model: Model, rope: Span) -> set[int]:
    """Return the nodes of a rope that slide along others, as indices of the arrays."""
    slides = [slide for slide in model.scene.slides if slide.rope == rope.name]
    return {model.layout.node(slide.node, slide.rope) for slide in slides}


def _is_slack(model: Model, first: int, last: int) -> bool:
    if last - first == 1:
        return False
    state = model.state
    distance = float(np.linalg.norm(state.x[:, last] - state.x[:, first]))
    return distance < float(state.rest_length[first:last].sum())
