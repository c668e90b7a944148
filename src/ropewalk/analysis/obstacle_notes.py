"""What `check` says of obstacles: what the rope's nodes may miss, and how much contacts yield."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.laws.hardening import depth_under
from ropewalk.lowering import Model
from ropewalk.lowering.chains import driven_speed, fastest
from ropewalk.lowering.obstacle_checks import turned_rate
from ropewalk.methods.registry import METHODS
from ropewalk.scene.obstacles import Cylinder, thinnest, what_is_thin
from ropewalk.statics import Statics
from ropewalk.statics.pressing import pressing, rounded

_YIELDS = 0.1  # of a rope's radius, or an obstacle's: contacts that yield more are told of [1]
_ALONG = math.sqrt(0.5)  # cosine of 45 degrees
_TURNS = 0.1  # [rad] in a step; with more of it friction points noticeably aside


def _goes_along(model: Model, body: Cylinder) -> bool:
    """Tell whether some segment is drawn rather along a cylinder's axis than across it."""
    segments = np.diff(model.state.x, axis=1)[:, model.state.stiffness > 0.0]
    axis = np.subtract(body.end, body.start)
    sizes = np.linalg.norm(segments, axis=0) * np.linalg.norm(axis)
    return bool((np.abs(axis @ segments) > _ALONG * sizes).any())


def obstacle_warnings(model: Model, statics: Statics) -> list[str]:
    """Return a sentence for everything that a scene with obstacles does otherwise than its user may think."""
    scene, system = model.scene, model.system
    if not scene.obstacles:
        return []
    found = []
    table = system.node.obstacle
    longest = max(rope.segment_length for rope in scene.ropes)
    thick = float(table.thickness.max())
    step = model.plan.dt if model.plan.longest is None else model.plan.longest
    way = _speed(model, statics) * step
    # Implicit methods solve a step that would go through again in halves: they need no word.
    whole = not METHODS[model.plan.method].implicit
    for row, body in enumerate(scene.obstacles):
        name, radius, measure = (
            f"obstacle {body.name!r}",
            thinnest(body) + thick,
            what_is_thin(body),
        )
        reached = measure == "radius" or not isinstance(body, Cylinder) or _goes_along(model, body)
        if longest > 2.0 * radius and reached:
            found.append(
                f"{name}: segments of {1e3 * longest:.4g} mm are longer than twice its {measure} "
                f"({1e3 * radius:.4g} mm, the rope's half diameter counted in): only nodes touch, and a run "
                "in which it would slip through between two of them ends there; take more segments"
            )
        if whole and way > radius:
            found.append(
                f"{name}: a node may move {1e3 * way:.4g} mm in a step, more than its {measure} "
                f"({1e3 * radius:.4g} mm): a run in which one goes through ends there; take steps of at "
                f"most {1e3 * step * radius / way:.3g} ms"
            )
        turn = turned_rate(system, row, body) * step
        if turn > _TURNS:
            found.append(
                f"{name}: it turns by {math.degrees(turn):.3g} degrees in a step, and friction there points "
                f"up to half of that aside; take steps of at most {1e3 * step * _TURNS / turn:.3g} ms"
            )
        what, force = _presses(model, statics, row)
        yields = float(depth_under(table, force)[row].max())
        least = min(radius, thick) if thick > 0.0 else radius
        if yields > _YIELDS * least:
            enough = rounded(_YIELDS * least / force)
            found.append(
                f"{name}: {what} presses it in by {1e3 * yields:.3g} mm; give it a compliance of at most "
                f"{enough} m/N where that matters"
            )
    return found


def _speed(model: Model, statics: Statics) -> float:
    """Return the largest speed to reckon with against obstacles [m/s].

    What starts at rest and is let alone moves as fast as what moves it; a run tells where it was faster.
    """
    system, state = model.system, model.state
    at_rest = model.scene.run.start == "at-rest" and model.scene.run.ring is None and statics.solved
    moves = state.v[:, state.inverse_mass > 0.0].any() or len(model.scene.winches) > 0
    let_go = moves or np.isfinite(system.anchors.release).any()
    alone = at_rest and not let_go
    return driven_speed(system) if alone else fastest(system, state)


def _presses(model: Model, statics: Statics, row: int) -> tuple[str, float]:
    """Return what may press a node most into an obstacle, in words, and its force [N]."""
    weight = float(np.linalg.norm(model.system.gravity) * model.state.mass.sum())
    found = [("all weight on one node", weight)]
    if statics.solved and statics.contacts is not None:
        push = statics.contacts.push[statics.contacts.obstacle == row]
        found.append(("what a node carries at rest", float(push.max(initial=0.0))))
    else:
        found.append(("the largest force on a node of the drawn shape", pressing(model)))
    return max(found, key=lambda one: one[1])
