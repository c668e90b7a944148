"""Scenes that have no rest shape, or one that nothing determines: what is missing."""

from __future__ import annotations

import itertools

import numpy as np

from ropewalk.laws.acting import at_rest
from ropewalk.laws.node_law import Rest
from ropewalk.lowering import Model, Span
from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.statics.hung import held_nodes
from ropewalk.statics.tied import partners, tied_nodes


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
    windy = Rest.CARRIES in rests
    if not _is_held(model, rope):
        return _unheld(model, rope, heavy, rests)
    held = sorted({*held, *tied_nodes(model, rope), *_sliding_nodes(model, rope)})
    bends = model.scene.ropes[model.scene.rope_index(rope.name)].bending_stiffness > 0.0
    if heavy or windy or bends or _is_pushed(model, rope):
        return ""
    outer = rope.start != held[0] or rope.end != held[-1]
    slack = any(_is_slack(model, a, b) for a, b in itertools.pairwise(held))
    if outer or slack:
        part = (
            "the part beyond its last anchor" if outer else "it is slack between its anchors, and"
        )
        verb = "has" if outer else "has there"
        return (
            f"{part} {verb} no shape of its own: there is neither gravity nor wind, so every shape is "
            "at rest; give gravity, wind, or anchors that stretch it"
        )
    return ""


def _unheld(model: Model, rope: Span, heavy: bool, rests: set[Rest]) -> str:
    windy = Rest.CARRIES in rests
    named = [anchor for anchor in model.scene.anchors if anchor.rope == rope.name]
    missing = "no anchor holds it"
    if named:
        missing = "all its anchors have let go at time 0 (release_time = 0)"
    if not (heavy or windy) and _is_pushed(model, rope):
        if model.scene.obstacles:  # forces may draw it onto them
            return ""
        return f"{missing}: a constant force carries it away; hold a node of it with an anchor"
    if not (heavy or windy):
        return f"{missing}, and nothing acts on it: it is at rest wherever it is; hold a node of it"
    if windy:
        return f"{missing}: the wind carries it away; hold a node of it with an anchor"
    if Rest.BEARS not in rests:
        return f"{missing}, and there is no ground: it falls; hold a node of it with an anchor"
    return ""


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


def _is_pushed(model: Model, rope: Span) -> bool:
    """Whether a constant force acts on a node of the rope."""
    return bool(model.state.forces.applied[:, rope.start : rope.end + 1].any())


def _is_slack(model: Model, first: int, last: int) -> bool:
    if last - first == 1:
        return False
    state = model.state
    distance = float(np.linalg.norm(state.x[:, last] - state.x[:, first]))
    return distance < float(state.rest_length[first:last].sum())
