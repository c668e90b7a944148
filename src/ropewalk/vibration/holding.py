"""What friction does in small motions: it holds, also where it carries all it can, but on what moves on.

A contact at its limit slips in the first half swing alone. Then it carries less by what it slipped times its
spring, and the same swing again leaves it within its limit (shakedown): from then on it holds both ways.
Measured: a load on a drum that creeping left all at its limit, and a rope on a floor, ring at what is found
with all contacts held, to 0.1 %, those on a drum up and down to 0.3 %.

Where a surface moves along under the rope from the start, as that of a drum that turns, contacts slip all
the time, and nothing holds along it: there friction is left out, what of it follows the motion (by N, and by
which way the rope slips) included. Loads of one size on drums that turn ring up to 20 % off what is found so,
across up to 30 %; where friction bears a difference of loads, nothing in these modes does. The rest that they
are about is that over bodies that stand where they start: what moves only later stands in it, and holds.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.arrays import Floats
from ropewalk.laws.contact_frame import GRIP, GROWS, surface_at
from ropewalk.laws.contact_frame import PUSH as PRESSED
from ropewalk.laws.obstacle_places import depths, moves, surface_near, turning_rate
from ropewalk.laws.pairs.table import CONTACTS, PUSH, SPRING
from ropewalk.laws.slides.table import SPRING as HELD
from ropewalk.lowering import Model
from ropewalk.lowering.touching import SLIPS
from ropewalk.statics.coupled import bound_there

_FIRMLY = 2.0  # times the friction that it has: far from the limit [1]
_LOOKS = 8  # how often in the first frame surfaces are looked at
_ALONG = 1e-9  # [1] of a surface's speed: so little along it is rounding


def held(model: Model) -> Model:
    """Return the model with friction enough for what all contacts, and all that slides, carry."""
    node, state = model.system.node, arrays.copy(model.state)
    state.memory.obstacle.grip[:, GRIP] *= _FIRMLY
    state.memory.obstacle.grip[:, GROWS] = 0.0
    contact = node.contact._replace(friction=_FIRMLY * node.contact.friction)
    slide = node.slide._replace(
        friction=_FIRMLY * node.slide.friction, brake=_FIRMLY * node.slide.brake
    )
    system = model.system._replace(node=node._replace(contact=contact, slide=slide))
    return replace(model, system=system, state=state)


def slipping(model: Model, built: Model, x: Floats) -> tuple[Model, tuple[str, ...]]:
    """Return the model without friction where surfaces move along under places (3, n) [m], and their names.

    They do where they move in the first frame of a run: what moves only later stands at rest. `built` has
    the bodies as they move; those that move as an anchor does take the rope along.
    """
    scene, table = model.scene, built.system.node.obstacle
    state, led = arrays.copy(model.state), [anchor.motion for anchor in scene.anchors]
    names = []
    for row, body in enumerate(scene.obstacles):
        if not moves(table, row) and turning_rate(table, row) == 0.0:
            continue
        rates = _rates(table, row, 1.0 / scene.run.frame_rate)
        if body.motion in led:
            rates[:, :3] = 0.0
        nodes = np.flatnonzero((depths(table, x)[row] > 0.0) & (state.memory.obstacle.held == 0))
        under = [int(i) for i in nodes if _moves_under(table, row, x[:, i], rates)]
        if under:
            names.append(body.name)
            state.memory.obstacle.grip[row, GRIP, under] = 0.0
            state.memory.obstacle.grip[row, GROWS, under] = 0.0
    return replace(model, state=state), tuple(names)


def _rates(table: Any, row: int, until: float) -> Floats:
    """Return velocities [m/s] of a body and its rates about its axle [rad/s] before a time [s], (t, 4)."""
    found = [
        surface_at(table, row, float(t)) for t in np.linspace(0.0, until, _LOOKS, endpoint=False)
    ]
    return np.array([(*at[3:6], at[7]) for at in found])


def _moves_under(table: Any, row: int, place: Floats, rates: Floats) -> bool:
    """Tell whether the surface of a body of such rates moves along at a place (3,) [m]."""
    normal = np.array(surface_near(table, row, place)[1:4])
    arm = place - surface_at(table, row, 0.0)[:3] - table.hub[row]
    speed = rates[:, :3] + rates[:, 3:] * np.cross(table.axle[row], arm)
    along = speed - (speed @ normal)[:, None] * normal
    return bool((np.abs(along).max(axis=1) > _ALONG * np.abs(speed).max(axis=1)).any())


def full(model: Model) -> tuple[int, int]:
    """Return how many contacts and slides with friction carry nearly all they can, and of how many."""
    grip, contact = model.state.memory.obstacle.grip, model.state.memory.contact
    carried = [np.linalg.norm(grip[:, :GRIP], axis=1).ravel()]
    most = [(grip[:, GRIP] * grip[:, PRESSED]).ravel()]
    table = model.system.node.contact
    if table.radius.size:
        pairs = contact.grip[: contact.tally[CONTACTS]]
        first, second = table.rope[contact.pair[: len(pairs)].T]
        carried.append(np.linalg.norm(pairs[:, SPRING : SPRING + 3], axis=1))
        most.append(table.friction[first, second] * pairs[:, PUSH])
    carried.append(np.abs(model.state.memory.slide.grip[:, HELD]))
    most.append(_most_of_slides(model))
    rubs, bound = np.concatenate(carried), np.concatenate(most)
    return int(((bound > 0.0) & (rubs >= SLIPS * bound)).sum()), int((bound > 0.0).sum())


def _most_of_slides(model: Model) -> Floats:
    slide, sight = model.system.node.slide, model.state.memory.slide.sight
    return np.array([float(bound_there(slide, sight, row)) for row in range(len(slide.node))])


def full_note(full: int, count: int) -> str:
    """Return what is to be said where some contacts carry nearly all that friction can."""
    if count == 1:
        which = "the one contact carries nearly all that friction can, and holds"
    else:
        which = f"{full} of {count} contacts carry nearly all that friction can, and hold"
    return (
        f"{which} in small motions, once the first half swing has let them slip a little: larger motions "
        "slip on, ring lower and die down sooner"
    )


def slip_note(names: tuple[str, ...]) -> str:
    """Return what is to be said of bodies that move along under the rope."""
    does = "move" if len(names) > 1 else "moves"
    which = "obstacles " if len(names) > 1 else "obstacle "
    return (
        f"{which}{', '.join(map(repr, names))} {does} along under what touches it from the start: that slips "
        "all the time, and friction is left out there, also what of it follows the motion. The rest that "
        "modes are about is that over bodies that stand: where loads on both sides balance without friction "
        "frequencies are to be trusted to some 20 to 30 %, where friction bears a difference not at all, and "
        "damping nowhere"
    )
