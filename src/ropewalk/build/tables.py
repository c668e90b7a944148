"""Scene -> System (constant) and State (what evolves)."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.build.bending import add_bending, no_bending
from ropewalk.build.curve import initial_points
from ropewalk.build.layout import Layout, Span
from ropewalk.build.limiter_order import limiter_order
from ropewalk.build.motion_rows import anchor_tables
from ropewalk.core.arrays import (
    Air,
    Floats,
    Forces,
    Ground,
    Limiter,
    State,
    System,
    Winches,
    Work,
)
from ropewalk.core.status import BREAK_STRETCH
from ropewalk.laws.anchors import start_of_anchor
from ropewalk.methods.kinks import kink_times
from ropewalk.scene import Material, Rope, Scene, Springs


def make_tables(scene: Scene, layout: Layout) -> tuple[System, State]:
    """Return the constant tables and the state at time zero."""
    state = _ropes(scene, layout)
    system = _system(scene, layout, state)
    system, state = add_bending(scene, layout, system, state)
    system = system._replace(kinks=kink_times(system.anchors, system.bending))
    _hold(system, state)
    return system, state


def line_density(rope: Rope) -> float:
    """Return mass per unstretched length [kg/m]; a spring rope's node mass over segment length."""
    if isinstance(rope.made_of, Material):
        return rope.made_of.mass_per_length
    length = rope.segment_length
    return rope.made_of.node_mass / length if length > 0.0 else 0.0


def _node_masses(rope: Rope) -> Floats:
    """Return the mass of every node of the rope as described, loads included [kg], (nodes,)."""
    if isinstance(rope.made_of, Springs):
        mass = np.full(rope.nodes, rope.made_of.node_mass)
    else:
        mass = np.full(rope.nodes, rope.made_of.mass_per_length * rope.segment_length)
        mass[0] *= 0.5
        mass[-1] *= 0.5
    for load in rope.loads:
        mass[rope.node_index(load.node)] += load.mass
    return mass


def _add_forces(scene: Scene, rope: Rope, applied: Floats) -> None:
    """Add the constant forces on a rope's nodes [N], (3, nodes): those given, and the water's lift."""
    for force in rope.forces:
        applied[:, rope.node_index(force.node)] += force.force
    if rope.submerged_weight is None:
        return
    size = math.hypot(*scene.gravity)
    share = np.full(rope.nodes, rope.segment_length)
    share[[0, -1]] *= 0.5
    weight = line_density(rope) * share
    if isinstance(rope.made_of, Springs):
        weight = np.full(rope.nodes, rope.made_of.node_mass)
        share[:] = rope.length_unstretched / rope.nodes
    applied += np.outer(scene.up, weight * size - rope.submerged_weight * share)


def _ropes(scene: Scene, layout: Layout) -> State:
    n, s = layout.nodes, layout.segments
    a, w = len(scene.anchors), len(scene.winches)
    x, v, mass = np.zeros((3, n)), np.zeros((3, n)), np.zeros(n)
    lengths, stiffness = np.zeros(s), np.zeros(s)
    vector, axial = np.zeros(s), np.zeros(s)
    applied = np.zeros((3, n))
    for rope, span in zip(scene.ropes, layout.ropes, strict=True):
        nodes, segments = slice(span.start, span.end + 1), slice(span.start, span.end)
        x[:, nodes] = initial_points(scene, rope).T
        x[:, span.first : span.start] = x[:, span.start, None]
        x[:, span.end + 1 : span.last + 1] = x[:, span.end, None]
        v[:, nodes] = np.array(rope.shape.velocity)[:, None]
        for kick in rope.kicks:
            v[:, span.start + rope.node_index(kick.node)] = kick.velocity
        mass[nodes] = _node_masses(rope)
        _add_forces(scene, rope, applied[:, nodes])
        lengths[segments] = rope.segment_length
        stiffness[segments] = rope.segment_stiffness
        form = vector if rope.made_of.friction == "vector" else axial
        if rope.made_of.friction == "vector" or not rope.rigid:  # no length changes, nothing rubs
            form[segments] = rope.segment_friction
    inverse = np.divide(1.0, mass, out=np.zeros(n), where=mass > 0.0)
    segment, node, none = (3, n + 1), (3, n), (3, 0)
    channels = segment, segment, node, node, node, none, segment if scene.limiter else none
    exits = [_exit(layout.span(winch.rope), winch.end) for winch in scene.winches]
    return State(
        x=x,
        v=v,
        acceleration=np.zeros(node),
        mass=mass,
        inverse_mass=inverse,
        tension=np.zeros(s),
        limited=np.zeros(s if scene.limiter else 0),
        drift=np.zeros(node),
        past=np.zeros(3),
        rest_length=lengths,
        stiffness=stiffness,
        damping_vector=vector,
        damping_axial=axial,
        held=np.ones(a, np.int64),
        anchor_node=np.array(layout.anchor_nodes, dtype=np.int64),
        anchor_x=np.zeros((a, 3)),
        anchor_v=np.zeros((a, 3)),
        reaction=np.zeros((a, 3)),
        winch_exit=np.array(exits, dtype=np.int64),
        winch_rate=np.zeros(w),
        winch_debt=np.zeros(w),
        winch_paid=np.zeros(w),
        bending_stiffness=np.zeros(0),
        bending_damping=np.zeros(0),
        clamp_direction=np.zeros((0, 3)),
        clamp_spin=np.zeros((0, 3)),
        moment=np.zeros((0, 6)),
        forces=Forces(*(np.zeros(shape) for shape in channels))._replace(applied=applied),
        work=Work(*(np.zeros(size) for size in (s, s, n, n, n, n, a, 2, 2, 0, 0))),
    )


def _exit(span: Span, end: str) -> int:
    return span.start if end == "start" else span.end


def _system(scene: Scene, layout: Layout, state: State) -> System:
    floor = np.full(layout.segments, -math.inf)
    for rope, span in zip(scene.ropes, layout.ropes, strict=True):
        if rope.made_of.tension_only:
            floor[span.first : span.last] = 0.0
    origins = state.x[:, state.anchor_node].T.copy()
    pushed = state.forces.applied.any()
    return System(
        gravity=np.array(scene.gravity, dtype=np.float64),
        flags=np.array(
            [pushed, state.damping_axial.any(), (floor == 0.0).any(), 0], dtype=np.int64
        ),
        break_stretch=_break_stretch(scene, state),
        slack_floor=floor,
        air=_air(scene, layout),
        ground=_ground(scene),
        limiter=_limiter(scene, layout),
        anchors=anchor_tables(scene, origins, state.anchor_node),
        winches=_winches(scene, layout),
        bending=no_bending(),
        kinks=np.zeros(0),
    )


def _break_stretch(scene: Scene, state: State) -> float:
    """The stretch that tells a broken simulation from a soft rope under all its weight [1]."""
    weight = math.hypot(*scene.gravity) * float(state.mass.sum())
    weight += float(np.linalg.norm(state.forces.applied, axis=0).sum())
    softest = state.stiffness * state.rest_length
    softest = softest[(softest > 0.0) & np.isfinite(softest)]
    return BREAK_STRETCH + (3.0 * weight / float(softest.min()) if len(softest) else 0.0)


def _air(scene: Scene, layout: Layout) -> Air:
    air, n = scene.air, layout.nodes
    normal, tangential = np.zeros(layout.segments), np.zeros(layout.segments)
    drag, quadratic = np.zeros(n), np.zeros(n)
    if air is None:
        return Air(0, 0, drag, quadratic, normal, tangential, np.zeros(3))
    for rope, span in zip(scene.ropes, layout.ropes, strict=True):
        segments = slice(span.first, span.last)
        normal[segments] = 0.5 * air.density * air.normal_coefficient * rope.diameter
        tangential[segments] = (
            0.5 * math.pi * air.density * air.tangential_coefficient * rope.diameter
        )
        nodes = slice(span.first, span.last + 1)  # those still on a drum, too
        drag[nodes], quadratic[nodes] = air.node_drag, air.node_drag_quadratic
    curved = bool(quadratic.any() or normal.any() or tangential.any())
    linear = int(air.node_drag > 0.0)
    wind = np.array(air.wind, dtype=np.float64)
    return Air(linear, int(curved), drag, quadratic, normal, tangential, wind)


def _ground(scene: Scene) -> Ground:
    up = np.array(scene.up)
    ground = scene.ground
    if ground is None:
        return Ground(0, up, 0.0, 0.0, 0.0, 0.0, 0.0)
    numbers = ground.height, ground.repulsion, ground.friction, ground.absorption
    return Ground(1, up, *numbers, ground.damping_ratio)


def _limiter(scene: Scene, layout: Layout) -> Limiter:
    limiter = scene.limiter
    if limiter is None:
        return Limiter(0, 0.0, math.inf, 0, np.zeros(0, np.int64), np.zeros(0))
    order, share = limiter_order(layout)
    return Limiter(1, limiter.min_stretch, limiter.max_stretch, limiter.passes, order, share)


def _winches(scene: Scene, layout: Layout) -> Winches:
    rows = []
    for winch in scene.winches:
        rope, span = scene.rope_named(winch.rope), layout.span(winch.rope)
        at_start = winch.end == "start"
        drum = span.start if at_start else span.end
        length = rope.segment_length
        friction = rope.segment_friction * length
        form = (friction, 0.0) if rope.made_of.friction == "vector" else (0.0, friction)
        rows.append(
            (
                layout.anchor_nodes.index(drum),
                span.first if at_start else span.last,
                span.last if at_start else span.first,
                1 if at_start else -1,
                winch.speed,
                winch.start,
                winch.stop,
                length,
                winch.min_length or 0.5 * length,
                winch.max_length or math.inf,
                span.length_on_drum(winch.end, length) if winch.on_drum is None else winch.on_drum,
                rope.segment_stiffness * length,
                *form,
                line_density(rope),
            )
        )
    columns = np.array(rows, dtype=np.float64).reshape(-1, 15).T
    anchor, first, last, step = (column.astype(np.int64) for column in columns[:4])
    rest = (np.ascontiguousarray(column) for column in columns[4:])
    return Winches(anchor, first, last, step, *rest)


def _hold(system: System, state: State) -> None:
    """Put the held nodes where their anchors are at time zero, with the anchors' velocities."""
    for row, node in enumerate(state.anchor_node):
        state.anchor_x[row] = state.x[:, node]
        point, speed = np.zeros(3), np.zeros(3)
        start_of_anchor(system, state, row, point, speed)
        if system.anchors.release[row] <= 0.0:
            state.held[row] = 0
            continue
        state.anchor_x[row], state.anchor_v[row] = point, speed
        state.x[:, node], state.v[:, node] = point, speed
        state.inverse_mass[node] = 0.0
