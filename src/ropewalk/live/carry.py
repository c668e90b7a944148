"""Carrying a running simulation over into another scene: places, velocities, anchors, work, time."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats, Ints, State, System, assign, flatten
from ropewalk.laws.contact_frame import DAMP, STIFF
from ropewalk.laws.pairs.law import memory as found_contacts
from ropewalk.laws.slides.sliding import memory as place_slides
from ropewalk.laws.wound_bends import set_all_bends
from ropewalk.live.carry_books import carry_books
from ropewalk.live.carry_contacts import carry_contacts
from ropewalk.live.parameters import refusal
from ropewalk.live.wound_ropes import carry_winches
from ropewalk.lowering import Model, build, with_all_laws
from ropewalk.lowering.contact_checks import deepest, refuse_pressing
from ropewalk.lowering.joint_tables import tied_with
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation


def carry_over(
    old: Simulation, scene: Scene, source: Floats, parts: Sequence[int] = ()
) -> Simulation:
    """Return a simulation of `scene` that goes on where `old` stands.

    `source` says for every node of the new scene where it was, (nodes,), fractional between two
    nodes: place and velocity are then interpolated. `parts` are segments of `old` that part now, in a scene
    in which any can. Raises SceneError when the scene cannot be planned, or there is nothing to part.
    """
    model = with_all_laws(build(scene, drawn=False, endless=True))
    state = model.state
    state.x[...] = _interpolated(old.arrays.x, source)
    state.v[...] = _interpolated(old.arrays.v, source)
    if scene.winches:
        carry_winches(old, model)
    _meet(model)
    for j in parts:
        if not can_part(old, j):
            raise refusal("segment", j, "is on a winch's drum, or has parted: nothing is to be cut")
    gone = _carry_partings(old, state, source, parts)
    kinds = _carry_anchors(old, model)
    if scene.winches and state.bending_stiffness.size:
        set_all_bends(model.system, state)
    if scene.contact is not None:
        found = found_contacts(model.system.node.contact, state.x, state.stiffness)
        assign(state.memory.contact, found)
        before = 1.0
        if old.scene.contact is not None:
            before = deepest(old.system, old.arrays)[0]
        refuse_pressing(model.system, state, model.layout, before)
    if scene.slides:
        memory = place_slides(model.system.node.slide, state.x, state.stiffness)
        _leave_off(old, scene, memory.off)
        assign(state.memory.slide, memory)
    made = Simulation(model, ledger=old.ledger)
    snapshot = made.state
    _carry_work(old, made, snapshot.state)
    _carry_memory(old, made, snapshot.state, source)
    _remember_partings(old, snapshot.state, gone, parts)
    start, dt, step = old.clock
    if made.plan.dt != dt:
        start, dt, step = old.time, made.plan.dt, 0
    drive = old.state.winch_drive if scene.winches else snapshot.winch_drive
    same = len(scene.obstacles) == len(old.scene.obstacles)
    made.restore(
        snapshot._replace(
            start=start,
            dt=dt,
            step=step,
            motion_kinds=kinds,
            winch_drive=drive.copy(),
            bodies=old.state.bodies if same else snapshot.bodies,
        )
    )
    if scene.obstacles or scene.contact is not None:
        made.push({})  # forces and accelerations with what contacts hold
    made.count_errors()  # not from where the scene would begin, nor from before all work
    return made


def can_part(simulation: Simulation, segment: int) -> bool:
    """Tell whether a segment of a wound rope is off its drum, and has not parted."""
    return bool(simulation.arrays.stiffness[segment] > 0.0)


def _interpolated(values: Floats, source: Floats) -> Floats:
    """Return columns of an array (3, n) at fractional indices."""
    low = np.floor(source).astype(np.int64)
    share = source - low
    if not share.any():
        return values[:, low]
    high = np.minimum(low + 1, values.shape[1] - 1)
    mixed: Floats = values[:, low] * (1.0 - share) + values[:, high] * share
    return mixed


def _meet(model: Model) -> None:
    """Give the nodes of a new joint one place and velocity, with the momentum that they have."""
    state, joints = model.state, model.system.joints
    for first, last in zip(joints.first[:-1], joints.first[1:], strict=True):
        nodes = joints.member[first:last]
        share = state.mass[nodes] / state.mass[nodes].sum()
        for values in (state.x, state.v):
            if (values[:, nodes] != values[:, nodes[:1]]).any():
                values[:, nodes] = (values[:, nodes] @ share)[:, None]


def _carry_partings(
    old: Simulation, new: State, source: Floats, parts: Sequence[int]
) -> list[tuple[int, int]]:
    """Let what has parted, or does now, and is still there be so; return its segments, new and old."""
    parted, may = old.arrays.memory.parting.time, new.memory.parting.time.size > 0
    gone = [*np.flatnonzero(np.isfinite(parted)), *parts] if may else ()
    found = [
        (int(i), int(j))
        for j in gone
        for i in np.flatnonzero((source[:-1] == j) & (source[1:] == j + 1))
    ]
    for place, _ in found:
        for array in (new.stiffness, new.damping_vector, new.damping_axial, new.rest_length):
            array[place] = 0.0
        if new.bending_stiffness.size:
            new.bending_stiffness[place : place + 2] = 0.0
            new.bending_damping[place : place + 2] = 0.0
    return found


def _remember_partings(
    old: Simulation, state: State, gone: Sequence[tuple[int, int]], parts: Sequence[int]
) -> None:
    """Keep when and at what tension segments have parted, given as new and old ones."""
    was, kept = old.arrays.memory.parting, state.memory.parting
    for here, there in gone:
        now = there in parts
        kept.time[here] = old.time if now else was.time[there]
        kept.tension[here] = old.tension[there] if now else was.tension[there]
        if state.limited.size:
            state.limited[here] = 0.0


def _leave_off(old: Simulation, scene: Scene, off: Floats) -> None:
    """Keep off its rope what has run off it: `off` (slides,) says when [s]."""
    known = [(slide.name, slide.on) for slide in old.scene.slides]
    for row, slide in enumerate(scene.slides):
        if (slide.name, slide.on) in known:
            off[row] = old.arrays.memory.slide.off[known.index((slide.name, slide.on))]


def _carry_anchors(old: Simulation, model: Model) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    """Put the anchors where they were, by name; return their kinds of motion."""
    before, state, system = old.arrays, model.state, model.system
    rows = {name: row for row, name in enumerate(old.layout.anchor_names)}
    kinds = system.anchors.kind.copy()
    alive = state.mass > 0.0
    state.inverse_mass[...] = np.divide(1.0, state.mass, out=np.zeros_like(state.mass), where=alive)
    for row, name in enumerate(model.layout.anchor_names):
        node = int(state.anchor_node[row])
        if name in rows:
            was = rows[name]
            state.anchor_x[row] = before.anchor_x[was]
            state.anchor_v[row] = before.anchor_v[was]
            state.held[row] = before.held[was]
            system.anchors.params[row] = old.system.anchors.params[was]
            kinds[row] = old.system.anchors.kind[was]
        else:
            state.anchor_x[row] = system.anchors.params[row, :3] = state.x[:, node]
            state.anchor_v[row] = 0.0
            state.v[:, node] = 0.0
            state.held[row] = 1
        _carry_clamp(old, model, row, rows.get(name))
        if state.held[row]:
            nodes = tied_with(system.joints, state.tied, node)
            state.inverse_mass[nodes] = 0.0
            state.x[:, nodes] = state.anchor_x[row][:, None]
            state.v[:, nodes] = state.anchor_v[row][:, None]
    return kinds


def _carry_clamp(old: Simulation, model: Model, row: int, was: int | None) -> None:
    """Keep a clamp's direction as far as it has turned; one that has let go bends freely again."""
    state, bending = model.state, model.system.bending
    if not len(state.moment) or not bending.clamped[row]:
        return
    if was is not None and len(old.arrays.moment) and old.system.bending.clamped[was]:
        state.clamp_direction[row] = old.arrays.clamp_direction[was]
        state.clamp_spin[row] = old.arrays.clamp_spin[was]
    if not state.held[row]:
        node = int(state.anchor_node[row])
        state.bending_stiffness[node] = bending.stiffness[node]
        state.bending_damping[node] = bending.damping[node]


def _carry_memory(old: Simulation, made: Simulation, state: State, source: Floats) -> None:
    """Keep what contacts hold at nodes that are there still, and how bodies turn: nothing slips or stops."""
    state.now[...] = old.arrays.now
    whole = source == np.floor(source)
    nodes = source[whole].astype(np.int64)
    if len(made.scene.obstacles) == len(old.scene.obstacles) > 0:
        grip = old.arrays.memory.obstacle.grip
        state.memory.obstacle.grip[:, :, whole] = grip[:, :, nodes]
        state.memory.obstacle.held[...] = state.inverse_mass == 0.0
        if np.array_equal(old.system.node.obstacle.wheel, made.system.node.obstacle.wheel):
            state.memory.obstacle.wheel[...] = old.arrays.memory.obstacle.wheel
        _fit_contacts(old, made, state, whole, nodes)
        carry_books(old, made, state)
    if old.arrays.inner.shape == state.inner.shape:
        state.inner[...] = old.arrays.inner
    # What a bound held in the last step is shown until the next one, which its own kind of method clears.
    alike = METHODS[old.plan.method].implicit == METHODS[made.plan.method].implicit
    if alike and old.arrays.limited.size and state.limited.size:
        here = np.flatnonzero(whole[:-1] & whole[1:] & (np.diff(source) == 1.0))
        state.limited[here] = old.arrays.limited[source[here].astype(np.int64)]
    same = nodes.size == old.arrays.x.shape[1] and (nodes == np.arange(nodes.size)).all()
    if same and whole.all() and _slide_alike(old.system, made.system):
        assign(state.memory.slide, old.arrays.memory.slide)
    carry_contacts(old, made, state, source)


def _slide_alike(old: System, new: System) -> bool:
    """Tell whether the same nodes slide along the same lines, with the same drums."""
    parts = ("node", "first", "last", "winch")
    was, now = old.node.slide, new.node.slide
    return all(np.array_equal(getattr(was, part), getattr(now, part)) for part in parts)


def _fit_contacts(
    old: Simulation, made: Simulation, state: State, whole: NDArray[np.bool_], nodes: Ints
) -> None:
    """Let springs and dampers of contacts that an edit has changed be those of the new ones.

    Those of the last step would hold up or throw a node for the next one, were it far from the surface.
    """
    was, now = old.system.node.obstacle, made.system.node.obstacle
    grip, same = state.memory.obstacle.grip, np.zeros(now.stiffness.shape, bool)
    same[:, whole] = True
    for part in ("stiffness", "hard", "damping"):
        same[:, whole] &= getattr(was, part)[:, nodes] == getattr(now, part)[:, whole]
    grip[:, STIFF] = np.where(same, grip[:, STIFF], now.stiffness)
    grip[:, DAMP] = np.where(same, grip[:, DAMP], now.damping)


def _carry_work(old: Simulation, made: Simulation, state: State) -> None:
    """Keep the work done so far: part by part where the parts are the same, else in one place."""
    before = old.arrays.work
    works = flatten(before)
    rows = {name: row for row, name in enumerate(old.layout.anchor_names)}
    for name, target in flatten(state.work).items():
        values = works[name]
        if name == "anchors":
            continue
        if values.shape == target.shape:
            target[...] = values
        elif len(target):
            target[0] = values.sum()
    for row, name in enumerate(made.layout.anchor_names):
        if name in rows:
            was = rows.pop(name)
            state.work.anchors[row] = before.anchors[was]
            state.reaction[row] = old.arrays.reaction[was]
    state.work.applied[0] += before.anchors[list(rows.values())].sum()  # of anchors that are gone
