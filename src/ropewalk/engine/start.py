"""How a run starts: from the shape that the scene draws, or at rest, ringing in a mode or not."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.arrays import Floats, State, System
from ropewalk.laws.clamps import start_clamps
from ropewalk.laws.free_torques import rope_torques
from ropewalk.laws.wheel_rows import ANGLE, PULL, RATE, TORQUE, WEIGHED
from ropewalk.lowering import Model
from ropewalk.lowering.elastic_tables import let_relax
from ropewalk.lowering.limiter_bounds import with_bounds
from ropewalk.lowering.link_lengths import with_links
from ropewalk.lowering.remembered import with_memory
from ropewalk.methods.recording import bends
from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.scene.obstacles import is_free
from ropewalk.scene.ring import Ring
from ropewalk.statics import Statics, checked_shape


def started(model: Model) -> Model:
    """Return the model as its run starts; itself when that is as the scene draws it.

    Rigid links start at their lengths (`lowering.link_lengths`), whatever chords the shape has, and segments
    within the bounds of a limiter that is solved for (`lowering.limiter_bounds`).

    With `start = "at-rest"` its places are those of the equilibrium, and its velocities zero but for kicks,
    anchors that move at once, and the mode that `ring` names.

    Raises SceneError for a scene without a rest shape, for rigid links that a method cannot hold, that do
    not reach or do not have the shape's length, and for a mode that is not there or does not
    ring; `statics.NoRest` when none is found.
    """
    return started_with_rest(model)[0]


def started_with_rest(model: Model) -> tuple[Model, Statics | None]:
    """Return what `started` does, and the shape of rest where it was looked for."""
    if model.started:
        return model, None
    run = model.scene.run
    if run.start != "at-rest":
        found = _remembering(with_bounds(with_links(model)))
        load_wheels(found.system, found.state)
        return found, None
    state = arrays.copy(model.state)
    rest = checked_shape(model)
    state.x[...] = rest.positions.T
    if run.ring is not None:
        state.v[...] += run.ring.speed * _velocity(model, run.ring)
    found = _remembering(with_bounds(with_links(replace(model, state=state))))
    if rest.memory is not None:
        memory = found.state.memory.obstacle
        rates = memory.wheel.copy()
        arrays.assign(found.state.memory, rest.memory)
        rates[:, ANGLE] = rest.memory.obstacle.wheel[:, ANGLE]
        memory.wheel[...] = rates
        load_wheels(found.system, found.state)
    return found, rest


def all_started(parts: Iterable[Model], ropes: Iterable[list[int]]) -> list[Model]:
    """Return parts of a scene as their runs start; `ropes` are the numbers of theirs in the whole scene.

    Raises SceneError for all parts together, NoRest for the first one.
    """
    found, faults = list[Model](), list[Fault]()
    for part, numbers in zip(parts, ropes, strict=True):
        try:
            found.append(started(part))
        except SceneError as error:
            told = [_in_whole(fault, numbers) for fault in error.faults]
            faults += [fault for fault in told if fault not in faults]
    if faults:
        raise SceneError(faults)
    return found


def _in_whole(fault: Fault, numbers: list[int]) -> Fault:
    """Return a fault of a part, its rope named as in the whole scene."""
    path = re.sub(r"^rope\[(\d+)\]", lambda m: f"rope[{numbers[int(m[1])]}]", fault.path)
    return replace(fault, path=path)


def load_wheels(system: System, state: State) -> None:
    """Write the torques with which wheels start, as methods take them that begin with an explicit stage.

    Those of the ropes and of the bodies' own weights [N m], by what contacts remember, into what is
    remembered of the wheels (`laws.wheel_rows`).
    """
    table, memory = system.node.obstacle, state.memory.obstacle
    if not len(table.inertia):
        return
    torques = rope_torques(table, memory, state.x, state.v)
    for row, w in enumerate(table.wheel):
        if w < 0:
            continue
        drive, rate, angle = float(torques[row]), memory.wheel[w, RATE], memory.wheel[w, ANGLE]
        weigh = table.weight[w, 0] * np.cos(angle) + table.weight[w, 1] * np.sin(angle)
        most = table.bearing[w]
        drag = -most * np.sign(rate) if rate else -float(np.clip(drive + weigh, -most, most))
        memory.wheel[w, TORQUE], memory.wheel[w, WEIGHED] = drive, weigh
        memory.wheel[w, PULL] = drive + drag + weigh - table.viscous[w] * rate


def _remembering(model: Model) -> Model:
    """Return the model, started: laws of nodes remember the places in which it does.

    At rest contacts carry what holds the ropes there, elsewhere nothing yet. What relaxes has done so.
    """
    state = with_memory(model.system, model.state)
    let_relax(model.system, state)
    return replace(model, state=state, started=True)


def _velocity(model: Model, ring: Ring) -> Floats:
    """Return the shape of a mode (3, n), its largest displacement 1."""
    from ropewalk.vibration import modes

    if any(map(is_free, model.scene.obstacles)):
        rule = "a pulley would have to turn as the mode does, and starts at its own rate: leave out ring"
        raise SceneError([Fault("run.ring.mode", ring.mode, rule)])
    found = modes(model, count=ring.mode)
    if found.count < ring.mode:
        rule = f"must be at most {found.count}: this scene has no more modes"
        raise SceneError([Fault("run.ring.mode", ring.mode, rule)])
    if not found.frequencies[-1] > 0.0:
        rule = "does not ring: this mode only creeps; see `ropewalk modes` for those that do"
        raise SceneError([Fault("run.ring.mode", ring.mode, rule)])
    shape = found.shapes[ring.mode - 1].real
    largest = float(np.sqrt((shape**2).sum(axis=1)).max())
    return np.ascontiguousarray(shape.T / largest)


def set_first_reactions(system: System, state: State) -> None:
    """At time zero an anchor's reaction balances the forces on its node, which are evaluated already.

    And on what is tied to that node.
    """
    joints = system.joints
    for row, i in enumerate(state.anchor_node):
        j = joints.of_anchor[row]
        nodes = [i] if j < 0 else joints.member[joints.first[j] : joints.first[j + 1]]
        state.reaction[row] = 0.0
        for node in nodes if state.held[row] else ():
            state.reaction[row] -= _total_force(system, state, node)
    set_joint_forces(system, state)
    if len(state.moment):  # else it would be compiled for nothing
        start_clamps(system, state)


def set_joint_forces(system: System, state: State) -> None:
    """Write the force of every joint on its nodes [N], (p, 3): what each needs for its acceleration.

    From forces and accelerations that are evaluated already. Over a joint they add up to nothing, or to the
    force of the anchor that holds it (`laws.joint_forces`); to nothing each where it is not tied.
    """
    joints = system.joints
    for j, tied in enumerate(state.tied):
        for p in range(joints.first[j], joints.first[j + 1]):
            i = joints.member[p]
            push = state.mass[i] * state.acceleration[:, i] - _total_force(system, state, i)
            state.joint_force[p] = tied * push


def _total_force(system: System, state: State, i: int) -> Floats:
    """Return the force of all laws on a node, weight included [N], (3,)."""
    forces = state.forces
    total: Floats = forces.elastic[:, i + 1] - forces.elastic[:, i]
    total = total + forces.friction[:, i + 1] - forces.friction[:, i]
    if bends(state):
        total = total + forces.bending[:, i + 1] - forces.bending[:, i]
    if system.limiter.active:
        total = total + forces.limiter[:, i + 1] - forces.limiter[:, i]
    for channel in (*forces.node, forces.applied):
        total = total + channel[:3, i]
    weight: Floats = state.mass[i] * system.gravity
    return total + weight
