"""What `check` says of obstacles: what the rope's nodes may miss, and how much contacts yield."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.hardening import depth_under
from ropewalk.laws.obstacle import radius_of
from ropewalk.laws.obstacle_rows import half_thickness, place_of
from ropewalk.lowering import Model
from ropewalk.lowering.chains import driven_speed, fastest
from ropewalk.lowering.long_segments import TWICE, long_about, longest_about
from ropewalk.lowering.obstacle_checks import (
    STAYS_OUT,
    loading_each_other,
    radius_with_rope,
    turned_rate,
)
from ropewalk.methods.registry import METHODS
from ropewalk.scene.motions import Table
from ropewalk.scene.obstacles import HalfPipe, Obstacle, Plane, thinnest, what_is_thin
from ropewalk.statics import Statics
from ropewalk.statics.pressing import pressing, rounded
from ropewalk.words.safe_side import rounded_down

_YIELDS = 0.1  # of a rope's radius, or an obstacle's: contacts that yield more are told of [1]
_ROUNDING = 1e-9  # of a place [1]
_PLACES = {"point", "center", "position", "start"}  # fields that say where an obstacle is
_TURNS = 0.1  # [rad] in a step; with more of it friction points noticeably aside


def obstacle_warnings(model: Model, statics: Statics) -> list[str]:
    """Return a sentence for everything that a scene with obstacles does otherwise than its user may think."""
    if not model.scene.obstacles:
        return []
    step = model.plan.dt if model.plan.longest is None else model.plan.longest
    way = reckoned_speed(model, statics) * step
    # Implicit methods solve a step that would go through again in halves: they need no word.
    whole = not METHODS[model.plan.method].implicit
    found = []
    for row, body in enumerate(model.scene.obstacles):
        name, measure = f"obstacle {body.name!r}", what_is_thin(body)
        found += _begins_elsewhere(model, row) + _long_segments(model, body)
        radius = radius_with_rope(model.system, body)
        if whole and way > radius:
            found.append(
                f"{name}: a node may move {1e3 * way:.4g} mm in a step, more than its {measure} "
                f"({1e3 * radius:.4g} mm): a run in which one goes through ends there; take steps of at "
                f"most {rounded_down(1e3 * step * radius / way)} ms"
            )
        turn = turned_rate(model.system, row, body, model.scene.run.duration) * step
        if turn > _TURNS:
            found.append(
                f"{name}: it turns by {math.degrees(turn):.3g} degrees in a step, and friction there points "
                f"up to half of that aside; take steps of at most {rounded_down(1e3 * step * _TURNS / turn)} "
                "ms"
            )
        found += _yielding(model, statics, row)
    return found


def _begins_elsewhere(model: Model, row: int) -> list[str]:
    """Return a sentence where the table of a motion begins beside where its obstacle is drawn.

    Nothing of a place that nobody gave, nor of a plane or a half-pipe that is moved along itself.
    """
    body, table = model.scene.obstacles[row], model.system.node.obstacle
    if not isinstance(body.motion, Table) or not body.model_fields_set & _PLACES:
        return []
    drawn, begins = np.array(place_of(body)[0], dtype=np.float64), table.center[row]
    off = begins - drawn
    if isinstance(body, Plane):
        off = table.axis[row] * float(table.axis[row] @ off)
    elif isinstance(body, HalfPipe):
        along = np.subtract(body.end, body.start)
        off = off - along * float(along @ off / (along @ along))
    way = float(np.linalg.norm(off))
    if way <= _ROUNDING * float(np.abs([drawn, begins]).max()):
        return []
    places = (", ".join(f"{one:.4g}" for one in place) for place in (drawn, begins))
    return [
        f"obstacle {body.name!r}: it is drawn at ({next(places)}) m and its table of motion begins at "
        f"({next(places)}) m, {1e3 * way:.4g} mm off: it is there from the start, for `positions` are the "
        "places, no ways"
    ]


def _long_segments(model: Model, body: Obstacle) -> list[str]:
    """Return a sentence where segments may pass an obstacle between two nodes, of the rope that most may."""
    ropes = model.scene.ropes
    drawn = np.diff(model.state.x, axis=1)[:, model.state.stiffness > 0.0]
    rope = long_about(model.scene, body, drawn)
    if rope is None:
        return []
    longest = longest_about(body, rope)
    whose = f" of rope {rope.name!r}" if len(ropes) > 1 else ""
    thin, times, measure = thinnest(body), "twice", what_is_thin(body)
    if longest < TWICE * (thin + radius_of(rope)):
        measure = measure if half_thickness(body) == thin else "half thickness"
        thin, times = half_thickness(body), f"{STAYS_OUT:g} times"
    return [
        f"obstacle {body.name!r}: segments{whose} of {1e3 * rope.segment_length:.4g} mm are longer than "
        f"{times} its {measure} ({1e3 * (thin + radius_of(rope)):.4g} mm, the rope's half diameter counted "
        "in): only nodes touch, and a run in which it would slip through between two of them ends there; "
        f"take more segments, of at most {rounded_down(1e3 * longest)} mm"
    ]


def _yielding(model: Model, statics: Statics, row: int) -> list[str]:
    """Return a sentence where an obstacle may yield by much of its own radius, or of a rope's."""
    body, table = model.scene.obstacles[row], model.system.node.obstacle
    allowed = _YIELDS * np.where(table.thickness > 0.0, table.thickness, thinnest(body))
    found, most = [], math.inf
    for what, forces in _presses(model, statics, row).items():
        depth = depth_under(table, forces)[row]
        worst = int(np.argmax(depth / allowed))
        found.append((float(depth[worst] / allowed[worst]), what, float(depth[worst])))
        pressed = forces > 0.0
        most = min(most, float((allowed[pressed] / forces[pressed]).min(initial=math.inf)))
    share, what, yields = max(found, key=lambda one: one[0])
    if not share > 1.0:
        return []
    return [
        f"obstacle {body.name!r}: {what} presses it in by {1e3 * yields:.3g} mm; give it a compliance of "
        f"at most {rounded(most)} m/N where that matters"
    ]


def reckoned_speed(model: Model, statics: Statics) -> float:
    """Return the largest speed to reckon with against obstacles [m/s].

    What starts at rest and is let alone moves as fast as what moves it; a run tells where it was faster.
    """
    system, state, until = model.system, model.state, model.scene.run.duration
    at_rest = model.scene.run.start == "at-rest" and model.scene.run.ring is None and statics.solved
    moves = state.v[:, state.inverse_mass > 0.0].any() or len(model.scene.winches) > 0
    let_go = moves or np.isfinite(system.anchors.release).any()
    alone = at_rest and not let_go
    return driven_speed(system, until) if alone else fastest(system, state, until)


def _presses(model: Model, statics: Statics, row: int) -> dict[str, Any]:
    """Return what may press a node most into an obstacle, in words, and its force by nodes [N], (n,).

    All weight on one node is not reckoned with where it is known what nodes carry at rest.
    """
    push = np.zeros(model.state.mass.size)
    if statics.solved and statics.contacts is not None:
        contacts, on_it = statics.contacts, statics.contacts.obstacle == row
        np.maximum.at(push, contacts.node[on_it], contacts.push[on_it])
        at_rest = {"what a node carries at rest": push}
        return at_rest if on_it.any() else {"all weight on one node": _weight(model), **at_rest}
    push[:] = pressing(model)
    drawn = {"the largest force on a node of the drawn shape": push}
    return {"all weight on one node": _weight(model), **drawn}


def _weight(model: Model) -> Floats:
    """Return for every node the weight of all ropes that may load each other with its own [N], (n,)."""
    gravity, mass = float(np.linalg.norm(model.system.gravity)), model.state.mass
    weight = np.zeros(mass.size)
    for group in loading_each_other(model.scene):
        nodes = [
            np.arange(one.first, one.last + 1) for one in map(model.layout.ropes.__getitem__, group)
        ]
        own = np.concatenate(nodes)
        weight[own] = gravity * mass[own].sum()
    return weight
