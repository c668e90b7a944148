"""Scenes that have no rest shape, or one that nothing determines: what is missing."""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.laws.acting import at_rest
from ropewalk.laws.node_law import Rest
from ropewalk.lowering import Model, Span
from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.statics.hung import held_nodes
from ropewalk.statics.tied import partners, points, tied_nodes
from ropewalk.words.pushes import FAR

_ROUNDING = 1e-9  # of a weight, or a length: what buoyancy, or rest, leaves of it by rounding [1]
_NOTHING = 1e-12  # of the largest tension: what carries nothing [1]


def unheld_ropes(model: Model) -> tuple[str, ...]:
    """Return the names of the ropes that no anchor holds at time zero, nor another rope that one holds."""
    return tuple(rope.name for rope in model.layout.ropes if not _is_held(model, rope))


def undetermined_ropes(model: Model) -> tuple[str, ...]:
    """Return the names of the ropes that have no rest shape, or any."""
    return tuple(rope.name for rope in model.layout.ropes if _fault_of(model, rope))


def unseen_words(model: Model) -> str:
    """Return why a run or check says nothing of rest, and whether `ropewalk settle` may find it."""
    text = (
        "the rest of ropes that touch each other or slide along each other is not looked for here; "
    )
    if not (without := undetermined_ropes(model)):
        return f"{text}`ropewalk settle` looks for it"
    return (
        f"{text}and rope {without[0]!r} has none: {_fault_of(model, model.layout.span(without[0]))}"
    )


def refuse_impossible(model: Model) -> None:
    """Raise SceneError for ropes that have no rest shape, or that nothing gives one."""
    _refuse([_fault_of(model, rope) for rope in model.layout.ropes], model)


def refuse_loose(model: Model, positions: Floats, tension: Floats, left: Floats) -> None:
    """Raise SceneError for ropes with parts that nothing stretches at rest, `is_loose`.

    Args:
        model: what is at rest.
        positions: places of the nodes there (n, 3) [m].
        tension: of the segments there (s,) [N].
        left: the largest force that is left on a node of each segment's rope (s,) [N], see `left_over`.
    """
    nothing, rules = unloaded(tension, left), []
    for rope in model.layout.ropes:
        held = _held_anyhow(model, rope)
        parts = itertools.pairwise(held)
        tails = [(held[0], rope.start), (held[-1], rope.end)] if held else []
        between, beyond = (
            any(is_loose(model, rope, part, positions, nothing) for part in some)
            for some in (parts, tails)
        )
        rules.append(_no_shape(model, outer=beyond) if between or beyond else "")
    _refuse(rules, model)


def has_one_shape(model: Model, positions: Floats, tension: Floats, left: Floats) -> bool:
    """Tell whether neither `refuse_impossible` nor, of what was found, `refuse_loose` refuses a scene.

    Arguments as of that.
    """
    try:
        refuse_impossible(model)
        refuse_loose(model, positions, tension, left)
    except SceneError:
        return False
    return True


def _refuse(rules: list[str], model: Model) -> None:
    """Raise SceneError with what is wrong with the ropes, "" for nothing."""
    faults = [
        Fault(f"rope[{number}]", rope.name, rule)
        for number, (rope, rule) in enumerate(zip(model.layout.ropes, rules, strict=True))
        if rule
    ]
    if faults:
        raise SceneError(faults)


def unloaded(tension: Floats, left: Floats) -> NDArray[np.bool_]:
    """Return which segments carry nothing but rounding, (s,), of their tensions [N]; NaN are left out.

    `left` is the largest force that is left on a node of the rope (s,) [N]: where no rope is stretched, all
    tensions are such.
    """
    largest = float(np.fmax.reduce(np.abs(tension), initial=0.0))
    return np.asarray(np.abs(tension) <= np.maximum(_NOTHING * largest, FAR * left))


def is_loose(
    model: Model,
    rope: Span,
    part: tuple[int, int],
    positions: Floats,
    nothing: NDArray[np.bool_],
) -> bool:
    """Tell whether nothing gives a part of a rope its shape: neither forces on it nor what pulls its ends.

    Args:
        model: what is at rest.
        rope: of which it is a part.
        part: the nodes at its ends: two that are held, or one and the rope's end.
        positions: places of the nodes at rest (n, 3) [m].
        nothing: which segments carry nothing (s,).
    """
    first, last = sorted(part)
    if first == last or not nothing[first:last].all():
        return False
    if {Rest.HOLDS, Rest.CARRIES} & at_rest(model.system) or _bends(model, rope):
        return False
    held = set(_held_anyhow(model, rope))
    if _is_drawn(model, rope, first + (first in held), last - (last in held)):
        return False
    if not {first, last} <= held:
        return True
    distance = float(np.linalg.norm(positions[last] - positions[first]))
    length = float(model.state.rest_length[first:last].sum())
    return last - first > 1 and distance < length * (1.0 - _ROUNDING)


def _fault_of(model: Model, rope: Span) -> str:
    """Return what is missing for one rope to be at rest; "" where nothing is."""
    heavy, rests = bool(np.any(model.system.gravity)), at_rest(model.system)
    if Rest.HOLDS in rests:
        return ""
    if not _is_held(model, rope):
        return _unheld(model, rope, heavy, rests)
    held = _held_anyhow(model, rope)
    if Rest.CARRIES in rests or _bends(model, rope) or _is_drawn(model, rope):
        return ""
    outer = rope.start != held[0] or rope.end != held[-1]
    slack = any(
        _is_slack(model, a, b) and not _may_be_drawn_taut(model, rope, a, b)
        for a, b in itertools.pairwise(held)
    )
    return _no_shape(model, outer=outer) if outer or slack else ""


def _no_shape(model: Model, *, outer: bool) -> str:
    """Return the words for what is slack between nodes that are held, or lies beyond the outermost one."""
    part = "the part beyond its last anchor" if outer else "it is slack between its anchors, and"
    verb = "has" if outer else "has there"
    heavy = bool(np.any(model.system.gravity))
    lacks = ("weight (buoyancy carries it all)", "weight") if heavy else ("gravity", "gravity")
    return (
        f"{part} {verb} no shape of its own: there is neither {lacks[0]} nor wind, so every shape is "
        f"at rest; give {lacks[1]}, wind, or anchors that stretch it"
    )


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


def _is_drawn(model: Model, rope: Span, first: int = 0, last: int | None = None) -> bool:
    """Whether weight or a constant force acts on a node of the rope that the other does not take up.

    Of the nodes from `first` to `last` alone, if these are given.
    """
    weight, push = _forces_on(model, rope)
    least = _ROUNDING * np.abs(weight).max()
    if last is not None:
        weight, push = (
            part[:, first - rope.start : last - rope.start + 1] for part in (weight, push)
        )
    return bool(np.abs(weight + push).max(initial=0.0) > least)


def _bends(model: Model, rope: Span) -> bool:
    """Whether a rope is stiff in bending."""
    return model.scene.rope_named(rope.name).bending_stiffness > 0.0


def _may_be_drawn_taut(model: Model, rope: Span, first: int, last: int) -> bool:
    """Whether a part of a rope between two held nodes may be taut though these are nearer than it is long.

    An obstacle that it goes round stretches it, or what slides along it, or it is tied at an end, whose place
    is not known yet; or another rope, where it is drawn stretched. What is at rest tells: `refuse_loose`.
    """
    scene, rest = model.scene, float(model.state.rest_length[first:last].sum())
    if scene.obstacles or any(slide.on == rope.name for slide in scene.slides):
        return True
    drawn = np.linalg.norm(np.diff(model.state.x[:, first : last + 1], axis=1), axis=0).sum()
    if scene.contact is not None and drawn > rest * (1.0 + _ROUNDING):
        return True
    return not (_is_fixed(model, first) and _is_fixed(model, last))


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


def _held_anyhow(model: Model, rope: Span) -> list[int]:
    """Return the nodes of a rope that anchors hold, joints tie or slides lead, in order, in the arrays."""
    tied, slid = tied_nodes(model, rope), _sliding_nodes(model, rope)
    return sorted({*held_nodes(model, rope), *tied, *slid})


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
