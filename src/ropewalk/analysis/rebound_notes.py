"""What `check` says of what throws back: whether contacts go deep enough, and not too deep."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.analysis.obstacle_notes import reckoned_speed
from ropewalk.laws.obstacle_rows import half_thickness
from ropewalk.laws.striking import pushes
from ropewalk.lowering import Model
from ropewalk.lowering.rebound_checks import (
    RESOLVED,
    deepest_meeting,
    least_meeting,
    linear_to,
    swings,
)
from ropewalk.statics import Statics
from ropewalk.words.safe_side import rounded_down, rounded_up

_MOST = 0.75  # [1] of half a body's thickness: what comes deeper would go through


def rebound_warnings(model: Model, statics: Statics) -> list[str]:
    """Return a sentence for everything by which a restitution is not what it says."""
    return _of_obstacles(model, statics) + _of_ropes(model, statics)


def _of_obstacles(model: Model, statics: Statics) -> list[str]:
    """Return a sentence for everything by which an obstacle's restitution is not what it says."""
    bodies = model.scene.obstacles
    rows = [row for row, body in enumerate(bodies) if body.restitution > 0.0]
    if not rows:
        return []
    speed = reckoned_speed(model, statics)
    found = [note for row in rows for note in _depths(model, row, speed)]
    rods = [rope.name for rope in model.scene.ropes if pushes(rope)]
    if rods:
        found.append(
            f"obstacle {bodies[rows[0]].name!r}: its restitution is that of a node on its own, and the links "
            f"of rope {rods[0]!r} push: what hits is heavier, and leaves with more"
        )
    return found


def _depths(model: Model, row: int, speed: float) -> list[str]:
    """Return a sentence where the fastest node goes in less than steps resolve, or farther than is right."""
    body, table = model.scene.obstacles[row], model.system.node.obstacle
    limit = model.scene.run.tolerance
    free = model.state.inverse_mass > 0.0
    if not speed > 0.0 or not free.any():
        return []
    deep = speed / swings(model.system, row)[free]
    thick = table.thickness[free]
    allowed = np.minimum(np.where(thick > 0.0, thick, math.inf), _MOST * half_thickness(body))
    soft = 1.0 / float(table.stiffness[row].min())  # it has no other
    least, share = float(deep.min()), float((deep / allowed).max())
    comes = (
        f"obstacle {body.name!r}: a node that comes with {speed:.3g} m/s, the fastest to reckon with, goes "
        "in by"
    )
    if least < RESOLVED * limit:
        finer, softer = least / RESOLVED, soft * (RESOLVED * limit / least) ** 2
        return [
            f"{comes} {1e3 * least:.3g} mm, {least / limit:.2g} tolerances, and its restitution is right "
            f"from {RESOLVED:g} on; take a run.tolerance of at most {rounded_down(finer, 2)} m, or a "
            f"compliance of at least {rounded_up(softer, 2)} m/N"
        ]
    if share > 1.0:
        worst = int(np.argmax(deep / allowed))
        return [
            f"{comes} {1e3 * deep[worst]:.3g} mm, where {1e3 * allowed[worst]:.3g} mm are half of the rope, "
            f"or most of the body; take a compliance of at most "
            f"{rounded_down(soft / share**2, 2)} m/N"
        ]
    return []


def _of_ropes(model: Model, statics: Statics) -> list[str]:
    """Return a sentence for everything by which that of ropes on ropes is not what it says."""
    contact = model.scene.contact
    if contact is None or contact.restitution == 0.0 or contact.compliance is None:
        return []
    soft, limit, allowed = contact.compliance, model.scene.run.tolerance, linear_to(model.system)
    speed, least = reckoned_speed(model, statics), least_meeting(model.system, model.state)
    both, most = deepest_meeting(model.system, model.state, speed)
    shallow, deep = speed * math.sqrt(soft * least), both * math.sqrt(soft * most)
    found = []
    if 0.0 < shallow < RESOLVED * limit:
        finer, softer = shallow / RESOLVED, soft * (RESOLVED * limit / shallow) ** 2
        found.append(
            f"{_meet(speed)} {1e3 * shallow:.3g} mm, {shallow / limit:.2g} tolerances, and its restitution "
            f"is right from {RESOLVED:g} on; take a run.tolerance of at most {rounded_down(finer, 2)} m, or "
            f"a compliance of at least {rounded_up(softer, 2)} m/N"
        )
    elif deep > allowed:
        found.append(
            f"{_meet(both)} {1e3 * deep:.3g} mm, and contacts of ropes are linear to {1e3 * allowed:.3g} mm: "
            f"beyond they throw back more; take a compliance of at most "
            f"{rounded_down(soft * (allowed / deep) ** 2, 2)} m/N"
        )
    long = [rope for rope in model.scene.ropes if rope.segments > 1]
    if long:
        found.append(
            f"contact: its restitution is that of two segments on their own; those beside them in rope "
            f"{long[0].name!r} pull meanwhile, and what is left to its segments is not that"
        )
    return found


def _meet(speed: float) -> str:
    return f"contact: segments that meet at {speed:.3g} m/s, to be reckoned with, are pressed by"
